// app/print_models.c
// What assumptions about the section cost, entry by entry.
#include "app/print.h"

#include <math.h>
#include <stdio.h>

static const char *const axis[6] = {"nx", "ny", "nz", "mx", "my", "mz"};

// entries that are smaller in 3D and in every model are left out: they are zero
static const double SMALL = 1e-5;

enum { WIDTH = 24 };

static double scale_of(const model_checks *m, int i, int j)
{
    return sqrt(m->compliance.a[i][i] * m->compliance.a[j][j]);
}

// of 3D
static double off(const model_checks *m, int k, int i, int j)
{
    const model_check *one = &m->model[k];
    return one->why[0] ? NAN
                       : (one->compliance.a[i][j] - m->compliance.a[i][j]) / scale_of(m, i, j);
}

static void print_entry(const model_checks *m, int i, int j)
{
    const double own = m->compliance.a[i][j] / scale_of(m, i, j);
    bool counts = fabs(own) > SMALL;
    for (int k = 0; k < MODEL_CHECKS; k++) {
        counts = counts || fabs(off(m, k, i, j)) > SMALL;
    }
    if (!counts) {
        return;
    }
    // mm, N, rad
    printf("%s %-22s %13.7g", axis[i], axis[j],
           m->compliance.a[i][j] * (i < 3 ? 1e3 : 1) * (j < 3 ? 1 : 1e-3));
    for (int k = 0; k < MODEL_CHECKS; k++) {
        printf(" %*.1e", WIDTH, off(m, k, i, j));
    }
    (void)putchar('\n');
}

static void print_largest(const model_checks *m, bool law)
{
    printf("%-39s", law ? "its law alone (stretch, bending, twist)" : "the largest, ends and all");
    for (int k = 0; k < MODEL_CHECKS; k++) {
        const model_check *one = &m->model[k];
        const double error = law ? one->law_error : one->error;
        char words[40] = "";
        if (!one->why[0] && !isnan(error)) {
            (void)snprintf(words, sizeof words, "%.2g at %s %s", error,
                           axis[law ? one->law_row : one->row],
                           axis[law ? one->law_column : one->column]);
        }
        printf(" %*s", k ? WIDTH : WIDTH - 1, words);
    }
    (void)putchar('\n');
}

void print_models(const run_result *r)
{
    const model_checks *m = &r->models;
    if (!m->there) {
        return;
    }
    printf("what the section's models cost: tip compliance less that of 3D, over its sqrt(C_ii "
           "C_jj); %.4g mm\n",
           1e3 * m->lengths[0]);
    printf("%-25s %13s", "entry", "3D mm, N, rad");
    for (int k = 0; k < MODEL_CHECKS; k++) {
        printf(" %*s", WIDTH, m->model[k].name);
    }
    (void)putchar('\n');
    for (int k = 0; k < 36; k++) {
        if (k % 6 >= k / 6) {
            print_entry(m, k / 6, k % 6);
        }
    }
    print_largest(m, false);
    if (m->lengths[1] > 0) {
        print_largest(m, true);
        printf("the law alone: by the difference of two segments, %.4g and %.4g mm, of which the "
               "ends take the same\n",
               1e3 * m->lengths[0], 1e3 * m->lengths[1]);
    } else {
        printf("ends and law are not told apart: %s\n", m->why_no_second);
    }
}
