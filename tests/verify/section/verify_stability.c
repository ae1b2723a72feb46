// tests/verify/section/verify_stability.c
// Every third line of docs/stability.md: bench/bench_stability.c makes the whole table.
#include "tests/verify/section/stress.h"

#include "tests/test.h"

int main(void)
{
    against(BY_SECOND_WAY, "each line of docs/stability.md against a finer section of its own");
    const stress_count n = stress_all(3);
    CHECK_ABOVE(n.rows, 20);
    CHECK(n.outside == 0);
    // refusals are the exception
    CHECK_AT_MOST(n.refused, n.rows / 4);
    return test_failures != 0;
}
