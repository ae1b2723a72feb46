// tests/fuzz/fuzz_dxf.c
// fuzz_dxf SECONDS [SEED]: mutated drawings. Always outlines, or an error of one line.
#include "tests/dxf.h"
#include "tests/fuzz/mutate.h"

static status read_drawing(const char *directory, const char *name, void *context)
{
    status st = OK;
    drawing *d = NULL;
    section_outline o = {0};
    bool found = false;
    (void)context;
    st = dxf_open_file(directory, name, NULL, 0, &d);
    if (st == OK) {
        st = drawing_outline(d, &o, &found);
    }
    section_outline_free(&o);
    drawing_free(d);
    return st;
}

int main(int argc, char **argv)
{
    static dxf_paper papers[3];
    dxf_tube(&papers[0], 15);
    dxf_tube(&papers[1], 6);
    dxf_all_kinds(&papers[2]);
    mutant_seed seeds[3];
    for (int i = 0; i < 3; i++) {
        seeds[i] = (mutant_seed){(const unsigned char *)papers[i].text, papers[i].count};
    }
    return mutants_main(
        argc, argv,
        (mutant_plan){.nseed = 3, .seeds = seeds, .suffix = ".dxf", .read = read_drawing});
}
