// fuzz_table SECONDS [SEED]: mutated tables of tests. Always curves, or an error of one line.
#include "measure/material_test.h"
#include "tests/fuzz/mutate.h"

#include <math.h>

static status read_test(const char *directory, const char *name, void *context)
{
    status st = OK;
    char path[512];
    material_result r = {0};
    const material_settings s = {.gauge_length = 0.02, .area = 8e-6, .departure = 0.05, .nu = NAN};
    (void)context;
    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    const char *const paths[] = {path};
    st = material_measure(1, paths, &s, &r);
    material_result_free(&r);
    return st;
}

int main(int argc, char **argv)
{
    static char pairs[4000], machine[4000];
    int n =
        snprintf(pairs, sizeof pairs, "strain_1 [%%],stress_1 (MPa),strain_2 [%%],stress_2_kPa\n");
    int m =
        snprintf(machine, sizeof machine,
                 "Test;12.5\nGauge length [mm];20\n\"Area\";8;mm^2\n\nSpecimen;Extension;Force\n"
                 ";(mm);(N)\n");
    for (int i = 0; i < 40; i++) {
        n += snprintf(pairs + n, sizeof pairs - (size_t)n, "%g,%g,%g,%g\n", 0.1 * i,
                      0.02 * i + 0.001 * sin(i), 0.2 * i, 30. * i);
        m += snprintf(machine + m, sizeof machine - (size_t)m, "%s;%d,%02d;%d,5\n",
                      i < 20 ? "A" : "B", i % 20 / 10, i * 5 % 100, i % 20);
    }
    const mutant_seed seeds[2] = {{(const unsigned char *)pairs, (size_t)n},
                                  {(const unsigned char *)machine, (size_t)m}};
    return mutants_main(
        argc, argv, (mutant_plan){.nseed = 2, .seeds = seeds, .suffix = ".csv", .read = read_test});
}
