// bench/bench_rod_stability.c
// The table of docs/rod_stability.md. Exit code 1 where a rod is wrong or a number is not finite.
#include "tests/verify/rodsolver/rod_stress_loads.h"

int main(void)
{
    const stress_count n = stress_all(1);
    printf("\n%d lines: %d refused, %d wrong, %d silent\n", n.rows, n.refused, n.outside, n.silent);
    return n.outside > 0 || n.silent > 0 || test_failures > 0;
}
