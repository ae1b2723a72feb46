// tests/verify/rodsolver/verify_rod_stability.c
// Every third line of docs/rod_stability.md: bench/bench_rod_stability.c makes the whole table.
#include "tests/verify/rodsolver/rod_stress_loads.h"

int main(void)
{
    against(BY_SECOND_WAY, "each line of docs/rod_stability.md against the second method");
    const stress_count n = stress_all(3);
    CHECK_ABOVE(n.rows, 25);
    CHECK(n.outside == 0 && n.silent == 0);
    // refusals are the exception
    CHECK_AT_MOST(n.refused, n.rows / 8);
    return test_failures != 0;
}
