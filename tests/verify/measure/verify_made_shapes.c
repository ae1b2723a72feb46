// The synthetic shapes of cases/measured/ are what tests/made_shapes.h makes:
//   verify_made_shapes DIR    writes them into DIR
#include "measure/line_file.h"
#include "tests/made_shapes.h"
#include "tests/test.h"

#include <stdlib.h>

// of a place, in the unit that the files have: the last digit of numbers that round the other way
#define LAST_DIGIT 1.01e-4

static void the_march_has_converged(void)
{
    double coarse[MADE_POINTS][4], fine[MADE_POINTS][4];
    for (int i = 0; i < MADE_SHAPES; i += 5) {
        made_line(&made_shapes[i], MADE_STEPS / 4, coarse);
        made_line(&made_shapes[i], MADE_STEPS / 2, fine);
        for (int d = 0; d < 4; d++) {
            CHECK_WITHIN(coarse[MADE_POINTS - 1][d], fine[MADE_POINTS - 1][d], 1e-9);
        }
    }
}

static void the_files_are_those(const char *folder)
{
    for (int i = 0; i < MADE_SHAPES; i++) {
        centreline c = {0};
        double row[MADE_POINTS][4];
        made_rows(i, row);
        bool said = false;
        CHECK_OK(line_file_read(folder, &(key_text){made_shapes[i].file, {1, 1}}, made_length, &c,
                                &said));
        CHECK(said);
        CHECK(c.count == MADE_POINTS);
        for (int k = 0; k < c.count && c.count == MADE_POINTS; k++) {
            CHECK_WITHIN(1e3 * c.s[k], 1e3 * row[k][0], LAST_DIGIT);
            for (int d = 0; d < 3; d++) {
                CHECK_WITHIN(1e3 * c.p[k].a[d], 1e3 * row[k][1 + d], LAST_DIGIT);
            }
            CHECK_NEAR(c.sigma[k], made_sigma, 1e-12);
        }
        centreline_free(&c);
    }
}

static int write_all(const char *folder)
{
    char path[4096];
    for (int i = 0; i < MADE_SHAPES; i++) {
        (void)snprintf(path, sizeof path, "%s/%s", folder, made_shapes[i].file);
        FILE *f = fopen(path, "w");
        if (!f) {
            perror(path);
            return 1;
        }
        made_write(i, f);
        (void)fclose(f);
    }
    return 0;
}

int main(int argc, char **argv)
{
    against(BY_MADE_DATA, "the synthetic shapes of cases/measured, marched anew");
    char folder[4096];
    const char *source = getenv("STIFFAXIS_SOURCE");
    if (argc > 1) {
        return write_all(argv[1]);
    }
    (void)snprintf(folder, sizeof folder, "%s/cases/measured", source ? source : ".");
    the_march_has_converged();
    the_files_are_those(folder);
    return test_failures != 0;
}
