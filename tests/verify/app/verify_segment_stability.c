// tests/verify/app/verify_segment_stability.c
// The lines of docs/segment_stability.md that are quick: each within its estimate, or refused.
#include "tests/verify/app/segment_stress_cases.h"

int main(void)
{
    against(BY_SECOND_WAY,
            "each line of docs/segment_stability.md against a finer segment of its own");
    const stress_count n = stress_all(true, NULL);
    printf("%d lines: %d refused, %d outside their estimate\n", n.rows, n.refused, n.outside);
    CHECK_AT_LEAST(n.rows, 7);
    CHECK(n.outside == 0);
    CHECK_BELOW(2 * n.refused, n.rows);
    return test_failures != 0;
}
