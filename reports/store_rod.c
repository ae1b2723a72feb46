// reports/store_rod.c
#include "reports/store_parts.h"

#include <limits.h>
#include <stdio.h>

typedef struct rod_run rod_run;

static status pass_runs(const passage *p, rod_result *rod)
{
    const size_t nt = (size_t)rod->ntendon;
#define RUN(member) offsetof(rod_run, member)
    const column columns[] = {
        {"tension_N", COLUMN_REAL, "N", RUN(tension), 1, {nt}, 0},
        {"tendon_length_m", COLUMN_REAL, "m", RUN(tendon_length), 1, {nt}, 0},
        {"tip_p_m", COLUMN_REAL, "m", RUN(tip.p), 1, {3}, 0},
        {"tip_R", COLUMN_REAL, "-", RUN(tip.R), 2, {3, 3}, 0},
        {"total_bend_rad", COLUMN_REAL, "rad", RUN(total_bend_rad), 0, {0}, 0},
        {"iterations", COLUMN_INT, "-", RUN(iterations), 0, {0}, INT_MAX},
        {"relative_error", COLUMN_ANY, "-", RUN(relative_error), 0, {0}, 0},
        {"largest_strain", COLUMN_REAL, "-", RUN(largest_strain), 0, {0}, 0},
    };
#undef RUN
    return passage_columns(p, "rod", COUNT_OF(columns), columns,
                           rows_of(rod->run, rod->nsolution, sizeof *rod->run));
}

static status pass_shape(const passage *p, int i, int npoint, rod_run *run)
{
    static const column s = {"s_m", COLUMN_REAL, "m", 0, 0, {0}, 0};
    static const column poses[] = {
        {"p_m", COLUMN_REAL, "m", offsetof(pose, p), 1, {3}, 0},
        {"R", COLUMN_REAL, "-", offsetof(pose, R), 2, {3, 3}, 0},
    };
    static const column curvature = {"curvature_per_m", COLUMN_REAL, "1/m", 0, 1, {3}, 0};
    status st = OK;
    char group[64];
    const size_t n = (size_t)npoint;
    (void)snprintf(group, sizeof group, "rod/shape/%d", i);
    TRY(passage_room(p, (void **)&run->s, n, sizeof *run->s));
    TRY(passage_room(p, (void **)&run->shape, n, sizeof *run->shape));
    TRY(passage_room(p, (void **)&run->curvature, n, sizeof *run->curvature));
    TRY(passage_columns(p, group, 1, &s, rows_of(run->s, npoint, sizeof *run->s)));
    TRY(passage_columns(p, group, COUNT_OF(poses), poses,
                        rows_of(run->shape, npoint, sizeof *run->shape)));
    TRY(passage_columns(p, group, 1, &curvature,
                        rows_of(run->curvature, npoint, sizeof *run->curvature)));

done:
    return st;
}

status store_pass_rod(const passage *p, run_result *r)
{
    static const column length = {
        "length_m", COLUMN_POSITIVE, "m", offsetof(run_result, rod_length), 0, {0}, 0};
    static const column name = {"name", COLUMN_TEXT, "-", 0, 0, {sizeof r->rod.tendon_name[0]}, 0};
    static const column base = {"base_m", COLUMN_REAL, "m", 0, 1, {2}, 0};
    status st = OK;
    rod_result *rod = &r->rod;
    int n = rod->nsolution;
    TRY(passage_columns(p, "rod", 1, &length, single(r)));
    TRY(passage_count(p, "rod/tendon_count", 0, RESULT_MAX_TENDONS, &rod->ntendon));
    TRY(passage_columns(p, "rod/tendon", 1, &name,
                        rows_of(rod->tendon_name, rod->ntendon, sizeof rod->tendon_name[0])));
    TRY(passage_columns(p, "rod/tendon", 1, &base,
                        rows_of(rod->tendon_base, rod->ntendon, sizeof rod->tendon_base[0])));
    TRY(passage_count(p, "rod/point_count", 2, MOST_POINTS, &rod->npoint));
    TRY(passage_count(p, "rod/solution_count", 0, MOST_SOLUTIONS, &n));
    TRY(passage_room(p, (void **)&rod->run, (size_t)n, sizeof *rod->run));
    rod->nsolution = n;
    TRY(pass_runs(p, rod));
    for (int i = 0; i < n; i++) {
        TRY(pass_shape(p, i, rod->npoint, &rod->run[i]));
    }
    TRY(store_pass_strains(p, r));

done:
    return st;
}
