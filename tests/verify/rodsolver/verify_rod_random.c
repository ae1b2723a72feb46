// tests/verify/rodsolver/verify_rod_random.c
// Random rods under a tip force, from rest: each ends in the right equilibrium, or at a critical
// point of its loading path that both methods find. The whole campaign: ./run bench random
#include "tests/test.h"
#include "tests/verify/rodsolver/random_rods.h"

static void none_is_wrong_and_none_silent(random_rods *rods, const char *what,
                                          random_problem (*make)(int), int problems)
{
    const random_count n = random_run(rods, make, 0, problems, NULL);
    random_print(what, &n);
    CHECK(random_failures(&n) == 0);
    CHECK(n.problems == problems);
}

int main(void)
{
    against(BY_SECOND_WAY, "the second method, shooting (tests/rod_shooting.h)");
    static random_rods rods;
    CHECK_OK(random_rods_make(&rods));
    if (rods.state) {
        none_is_wrong_and_none_silent(&rods, "any direction", random_at, 100);
        none_is_wrong_and_none_silent(&rods, "in a plane", random_plane_at, 40);
    }
    random_rods_free(&rods);
    return test_failures != 0;
}
