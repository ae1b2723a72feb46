// tests/unit/meshes/test_mutants.c
// Spoiled files: some hundred of each kind are answered in time by one line or a mesh, and nothing
// else happens.
#include "tests/seeds.h"
#include "tests/test.h"

static void msh_files(void)
{
    seed_files s = msh_seeds();
    mutant_plan plan = {
        .nseed = s.count, .seeds = s.seed, .suffix = ".msh", .read = msh_mutant, .state = 1};
    CHECK(s.count == 5);
    CHECK(mutants_run(&plan, test_is_long() ? 300 : 100, 0) == 0);
    seeds_free(&s);
}

static void step_files(void)
{
    seed_files s = {0};
    seed_add_file(&s, "bar.step");
    mutant_plan plan = {
        .nseed = s.count, .seeds = s.seed, .suffix = ".step", .read = step_mutant, .state = 1};
    CHECK(s.count == 1);
    CHECK(mutants_run(&plan, test_is_long() ? 300 : 100, 0) == 0);
    seeds_free(&s);
}

int main(void)
{
    msh_files();
    step_files();
    return test_failures != 0;
}
