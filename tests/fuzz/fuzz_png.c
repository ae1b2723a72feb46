// fuzz_png SECONDS [SEED]: spoiled PNG images are opened and meshed, or refused with one line.
#include "tests/fuzz/png_mutants.h"

int main(int argc, char **argv)
{
    png_mutants m = {0};
    const int wrong = mutants_main(argc, argv, png_mutant_plan(&m));
    png_mutants_free(&m);
    return wrong;
}
