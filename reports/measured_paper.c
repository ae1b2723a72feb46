// reports/measured_paper.c
// The paper's Tables II and III: its model against its own measured shapes, which are not
// published.
#include "reports/measured_show.h"

#include <math.h>

#define PI 3.14159265358979323846

static const paper_error table_2[] = {
    {"constant NC", 0, 0.49, 1.25, 1.0, 1.6},  {"constant NC", 0, 0.67, 2.03, 1.7, 2.3},
    {"constant NC", 0, 0.98, 3.09, 2.6, 2.8},  {"constant NC", PI, 0.49, 1.37, 1.1, 2.1},
    {"constant NC", PI, 0.67, 1.99, 1.7, 2.3}, {"constant NC", PI, 0.98, 3.97, 3.3, 2.8},
};

static const paper_error table_3[] = {
    {"helical NC", PI / 2, 0.49, 1.47, 1.2, 2.2}, {"helical NC", PI / 2, 0.69, 2.85, 2.4, 4.0},
    {"helical NC", PI / 2, 0.98, 3.15, 2.6, 4.6}, {"helical NC", PI / 2, 1.47, 3.47, 2.9, 6.1},
    {"helical NC", PI / 2, 1.96, 1.69, 1.4, 6.6},
};

// tensions are given to two decimals, angles by whole quarters
#define SAME_TENSION 1e-6
#define SAME_ANGLE 1e-3

// the one tendon that is pulled, -1 where there is none or more than one
static int only_tendon(const rod_result *rod, const struct rod_run *run)
{
    int only = -1;
    for (int i = 0; i < rod->ntendon; i++) {
        if (run->tension[i] > 0) {
            if (only >= 0) {
                return -1;
            }
            only = i;
        }
    }
    return only;
}

const paper_error *paper_error_of(const run_result *r, int solution)
{
    const bool second = r->measured.paper == PAPER_TABLE_2;
    const paper_error *table = second ? table_2 : table_3;
    const int n =
        second ? (int)(sizeof table_2 / sizeof *table_2) : (int)(sizeof table_3 / sizeof *table_3);
    const struct rod_run *run = &r->rod.run[solution];
    const int tendon = only_tendon(&r->rod, run);
    if (r->measured.paper == PAPER_NONE || tendon < 0) {
        return NULL;
    }
    const double angle = atan2(r->rod.tendon_base[tendon][1], r->rod.tendon_base[tendon][0]);
    for (int i = 0; i < n; i++) {
        const double turn = remainder(angle - table[i].angle, 2 * PI);
        if (fabs(turn) <= SAME_ANGLE &&
            fabs(run->tension[tendon] - table[i].tension) <= SAME_TENSION) {
            return &table[i];
        }
    }
    return NULL;
}
