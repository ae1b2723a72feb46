// fuzz_step SECONDS [SEED]: mutated STEP files; gmsh reads them in a child process, so they are
// few.
#include "tests/seeds.h"

int main(int argc, char **argv)
{
    seed_files s = {0};
    seed_add_file(&s, "bar.step");
    const mutant_plan plan = {
        .nseed = s.count, .seeds = s.seed, .suffix = ".step", .read = step_mutant};
    const int wrong = s.count == 1 ? mutants_main(argc, argv, plan) : 1;
    seeds_free(&s);
    return wrong;
}
