// reports/store_rod.c
#include "reports/store_parts.h"

#include <limits.h>
#include <stdio.h>

typedef struct rod_run rod_run;

#define RUN(member) offsetof(rod_run, member)

// what every solution has one of, or one for every tendon or load
static status pass_runs(const passage *p, rod_result *rod)
{
    static const column columns[] = {
        {"tip_p_m", COLUMN_REAL, "m", RUN(tip.p), 1, {3}, 0},
        {"tip_R", COLUMN_REAL, "-", RUN(tip.R), 2, {3, 3}, 0},
        {"total_bend_rad", COLUMN_REAL, "rad", RUN(total_bend_rad), 0, {0}, 0},
        {"iterations", COLUMN_INT, "-", RUN(iterations), 0, {0}, INT_MAX},
        {"relative_error", COLUMN_ANY, "-", RUN(relative_error), 0, {0}, 0},
        {"fraction", COLUMN_REAL, "-", RUN(fraction), 0, {0}, 0},
        {"eigenvalue", COLUMN_ANY, "-", RUN(eigenvalue), 0, {0}, 0},
        {"energy_J", COLUMN_ANY, "J", RUN(energy), 0, {0}, 0},
        {"work_J", COLUMN_ANY, "J", RUN(work), 0, {0}, 0},
        {"residual", COLUMN_ANY, "-", RUN(residual), 0, {0}, 0},
        {"largest_strain", COLUMN_REAL, "-", RUN(largest_strain), 0, {0}, 0},
    };
    const size_t nt = (size_t)rod->ntendon, nl = (size_t)rod->nload;
    const column lists[] = {
        {"tension_N", COLUMN_REAL, "N", RUN(tension), 1, {nt}, 0},
        {"pull_m", COLUMN_ANY, "m", RUN(pull), 1, {nt}, 0},
        {"tendon_length_m", COLUMN_REAL, "m", RUN(tendon_length), 1, {nt}, 0},
        {"load_factor", COLUMN_REAL, "-", RUN(load), 1, {nl}, 0},
    };
    status st = OK;
    TRY(passage_columns(p, "rod", COUNT_OF(columns), columns,
                        rows_of(rod->run, rod->nsolution, sizeof *rod->run)));
    TRY(passage_columns(p, "rod", COUNT_OF(lists), lists,
                        rows_behind(rod->run, rod->nsolution, sizeof *rod->run)));

done:
    return st;
}

// -1 (not known) to 1; stored from 0
static status pass_stable(const passage *p, int i, rod_run *run)
{
    char name[64];
    int stored = run->stable + 1;
    (void)snprintf(name, sizeof name, "rod/critical/%d/stable_plus_1", i);
    const status st = passage_count(p, name, 0, 2, &stored);
    run->stable = stored - 1;
    return st;
}

static status pass_critical(const passage *p, int i, rod_run *run)
{
    static const column columns[] = {
        {"kind", COLUMN_INT, "-", offsetof(rod_critical, kind), 0, {0}, CRITICAL_BIFURCATION},
        {"fraction", COLUMN_REAL, "-", offsetof(rod_critical, fraction), 0, {0}, 0},
    };
    status st = OK;
    char group[48];
    passage_name count;
    (void)snprintf(group, sizeof group, "rod/critical/%d", i);
    count = passage_join(group, "count");
    TRY(passage_count(p, count.text, 0, ROD_MAX_CRITICAL, &run->ncritical));
    TRY(passage_columns(p, group, COUNT_OF(columns), columns,
                        rows_of(run->critical, run->ncritical, sizeof *run->critical)));
    for (int k = 0; k < run->ncritical; k++) {
        char tail[40];
        int stored = run->critical[k].negative + 1; // -1: no potential
        (void)snprintf(tail, sizeof tail, "%d/negative_plus_1", k);
        const passage_name name = passage_join(group, tail);
        TRY(passage_count(p, name.text, 0, INT_MAX, &stored));
        run->critical[k].negative = stored - 1;
    }

done:
    return st;
}

static status pass_shape(const passage *p, int i, const rod_result *rod, rod_run *run)
{
    static const column s = {"s_m", COLUMN_REAL, "m", 0, 0, {0}, 0};
    static const column poses[] = {
        {"p_m", COLUMN_REAL, "m", offsetof(pose, p), 1, {3}, 0},
        {"R", COLUMN_REAL, "-", offsetof(pose, R), 2, {3, 3}, 0},
    };
    static const column curvature = {"curvature_per_m", COLUMN_REAL, "1/m", 0, 1, {3}, 0};
    static const column stretch = {"strain", COLUMN_REAL, "-", 0, 1, {3}, 0};
    static const column wrench = {"wrench", COLUMN_REAL, "N, N m", 0, 1, {6}, 0};
    const size_t nt = (size_t)rod->ntendon;
    const column along = {"tension_N", COLUMN_REAL, "N", 0, 1, {nt}, 0};
    status st = OK;
    char group[64];
    const int n = rod->npoint;
    (void)snprintf(group, sizeof group, "rod/shape/%d", i);
    TRY(p->reading ? rod_run_room(rod, run) : OK);
    TRY(passage_columns(p, group, 1, &s, rows_of(run->s, n, sizeof *run->s)));
    TRY(passage_columns(p, group, COUNT_OF(poses), poses,
                        rows_of(run->shape, n, sizeof *run->shape)));
    TRY(passage_columns(p, group, 1, &curvature,
                        rows_of(run->curvature, n, sizeof *run->curvature)));
    TRY(passage_columns(p, group, 1, &stretch, rows_of(run->stretch, n, sizeof *run->stretch)));
    TRY(passage_columns(p, group, 1, &wrench, rows_of(run->wrench, n, sizeof *run->wrench)));
    TRY(passage_columns(p, group, 1, &along, rows_of(run->along, n, nt * sizeof *run->along)));

done:
    return st;
}

static status pass_rates(const passage *p, rod_result *rod)
{
    static const column columns[] = {
        {"tip_compliance_space", COLUMN_REAL, "m/N, ...", RUN(rates.space), 2, {6, 6}, 0},
        {"tip_compliance_body", COLUMN_REAL, "m/N, ...", RUN(rates.body), 2, {6, 6}, 0},
    };
    const size_t nt = (size_t)rod->ntendon, nl = (size_t)rod->nload;
    const column lists[] = {
        {"tip_by_tension", COLUMN_REAL, "m/N, rad/N", RUN(rates.tension), 2, {nt, 6}, 0},
        {"tip_by_pull", COLUMN_REAL, "1, rad/m", RUN(rates.pull), 2, {nt, 6}, 0},
        {"tip_by_load_factor", COLUMN_REAL, "m, rad", RUN(rates.load), 2, {nl, 6}, 0},
    };
    status st = OK;
    TRY(passage_columns(p, "rod", COUNT_OF(columns), columns,
                        rows_of(rod->run, rod->nsolution, sizeof *rod->run)));
    TRY(passage_columns(p, "rod", COUNT_OF(lists), lists,
                        rows_behind(rod->run, rod->nsolution, sizeof *rod->run)));

done:
    return st;
}

// a load's own members are arrays of LOAD_PLACES
static status pass_sketches(const passage *p, rod_result *rod)
{
#define SKETCH(member) offsetof(rod_load_sketch, member)
    static const column columns[] = {
        {"kind", COLUMN_INT, "-", SKETCH(kind), 0, {0}, LOAD_GRAVITY},
        {"frame", COLUMN_INT, "-", SKETCH(frame), 0, {0}, LOAD_BODY},
        {"from_m", COLUMN_REAL, "m", SKETCH(from), 0, {0}, 0},
        {"to_m", COLUMN_REAL, "m", SKETCH(to), 0, {0}, 0},
        {"force", COLUMN_REAL, "N, N/m", SKETCH(force), 2, {LOAD_PLACES, 3}, 0},
        {"moment", COLUMN_REAL, "N m, N", SKETCH(moment), 2, {LOAD_PLACES, 3}, 0},
        {"place_m", COLUMN_REAL, "m", SKETCH(place), 2, {LOAD_PLACES, 2}, 0},
        {"acceleration_m_per_s2", COLUMN_REAL, "m/s^2", SKETCH(acceleration), 1, {3}, 0},
    };
#undef SKETCH
    return passage_columns(p, "rod/load", COUNT_OF(columns), columns,
                           rows_of(rod->load_sketch, rod->nload, sizeof *rod->load_sketch));
}

// what pictures need beside the solutions
static status pass_surroundings(const passage *p, rod_result *rod)
{
    static const column end = {"end_m", COLUMN_REAL, "m", 0, 0, {0}, 0};
    static const column poses[] = {
        {"p_m", COLUMN_REAL, "m", offsetof(pose, p), 1, {3}, 0},
        {"R", COLUMN_REAL, "-", offsetof(pose, R), 2, {3, 3}, 0},
    };
    const size_t n = (size_t)rod->npoint;
    const column path = {"path_m", COLUMN_REAL, "m", 0, 2, {n, 2}, 0};
    status st = OK;
    TRY(passage_columns(p, "rod/tendon", 1, &end,
                        rows_of(rod->tendon_end, rod->ntendon, sizeof *rod->tendon_end)));
    TRY(passage_columns(p, "rod/tendon", 1, &path,
                        rows_of(rod->tendon_path, rod->ntendon, n * sizeof *rod->tendon_path)));
    TRY(passage_columns(p, "rod/rest", COUNT_OF(poses), poses,
                        rows_of(rod->rest, rod->npoint, sizeof *rod->rest)));
    TRY(pass_sketches(p, rod));

done:
    return st;
}

static status pass_names(const passage *p, rod_result *rod)
{
    static const column name = {"name", COLUMN_TEXT, "-", 0, 0, {RESULT_NAME}, 0};
    static const column base = {"base_m", COLUMN_REAL, "m", 0, 1, {2}, 0};
    status st = OK;
    TRY(passage_columns(p, "rod/tendon", 1, &name,
                        rows_of(rod->tendon_name, rod->ntendon, RESULT_NAME)));
    TRY(passage_columns(p, "rod/tendon", 1, &base,
                        rows_of(rod->tendon_base, rod->ntendon, sizeof *rod->tendon_base)));
    TRY(passage_columns(p, "rod/load", 1, &name, rows_of(rod->load_name, rod->nload, RESULT_NAME)));

done:
    return st;
}

// the counts; reading: room for what they say
static status pass_sizes(const passage *p, rod_result *rod)
{
    status st = OK;
    rod_result sizes = *rod;
    int has_rates = sizes.has_rates;
    TRY(passage_count(p, "rod/tendon_count", 0, RESULT_MAX_TENDONS, &sizes.ntendon));
    TRY(passage_count(p, "rod/load_count", 0, RESULT_MAX_LOADS, &sizes.nload));
    TRY(passage_count(p, "rod/point_count", 2, MOST_POINTS, &sizes.npoint));
    TRY(passage_count(p, "rod/solution_count", 0, MOST_SOLUTIONS, &sizes.nsolution));
    TRY(passage_count(p, "rod/has_rates", 0, 1, &has_rates));
    sizes.has_rates = has_rates == 1;
    TRY(p->reading ? rod_result_make(&sizes, rod) : OK);

done:
    return st;
}

status store_pass_rod(const passage *p, run_result *r)
{
    static const column length = {
        "length_m", COLUMN_POSITIVE, "m", offsetof(run_result, rod_length), 0, {0}, 0};
    status st = OK;
    rod_result *rod = &r->rod;
    TRY(passage_columns(p, "rod", 1, &length, single(r)));
    TRY(pass_sizes(p, rod));
    TRY(pass_names(p, rod));
    TRY(pass_surroundings(p, rod));
    TRY(pass_runs(p, rod));
    TRY(rod->has_rates ? pass_rates(p, rod) : OK);
    for (int i = 0; i < rod->nsolution; i++) {
        rod_run *run = &rod->run[i];
        TRY(pass_stable(p, i, run));
        TRY(pass_critical(p, i, run));
        TRY(pass_shape(p, i, rod, run));
    }
    TRY(store_pass_strains(p, r));

done:
    return st;
}
