// bench/bench_segment_stability.c
// The table of docs/segment_stability.md, or those of its lines that contain a word. Exit code 1
// where an error leaves its estimate.
#include "tests/verify/app/segment_stress_cases.h"

int main(int argc, char **argv)
{
    const stress_count n = stress_all(false, argc > 1 ? argv[1] : NULL);
    printf("\n%d lines: %d refused, %d outside their estimate\n", n.rows, n.refused, n.outside);
    return n.outside > 0 || test_failures > 0;
}
