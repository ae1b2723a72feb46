// bench/bench_segment_stability.c
// The table of docs/segment_stability.md. Exit code 1 where an error leaves its estimate.
#include "tests/verify/app/segment_stress_cases.h"

int main(void)
{
    const stress_count n = stress_all(false);
    printf("\n%d lines: %d refused, %d outside their estimate\n", n.rows, n.refused, n.outside);
    return n.outside > 0 || test_failures > 0;
}
