// fuzz_msh SECONDS [SEED]: mutated MSH files of both versions, as text and as bytes.
#include "tests/seeds.h"

int main(int argc, char **argv)
{
    seed_files s = msh_seeds();
    const mutant_plan plan = {
        .nseed = s.count, .seeds = s.seed, .suffix = ".msh", .read = msh_mutant};
    const int wrong = s.count == 5 ? mutants_main(argc, argv, plan) : 1;
    seeds_free(&s);
    return wrong;
}
