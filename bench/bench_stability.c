// bench/bench_stability.c
// The table of docs/stability.md. Exit code 1 where an error leaves its estimate.
#include "tests/verify/section/stress.h"

int main(void)
{
    const stress_count n = stress_all(1);
    printf("\n%d sections: %d refused, %d outside their estimate\n", n.rows, n.refused, n.outside);
    return n.outside > 0;
}
