// rodsolver/rod_case.c
#include "rodsolver/rod_case.h"

#include "base/memory.h"

#include <math.h>

bool rod_case_has_gravity(const rod_case *c)
{
    return c->gravity[0] != 0 || c->gravity[1] != 0 || c->gravity[2] != 0;
}

int rod_case_loads(const rod_case *c)
{
    return c->loads.count + c->line_loads.count + rod_case_has_gravity(c);
}

pose rod_case_base(const rod_case *c)
{
    const base_case *b = &c->base;
    const double *r = b->rotation, *p = b->position;
    const pose clamp = {so3_exp((vec3){{r[0], r[1], r[2]}}), {{p[0], p[1], p[2]}}};
    const pose pushed = {so3_exp((vec3){{0, 0, b->turn}}), {{0, 0, b->insertion}}};
    return pose_mul(clamp, pushed);
}

rod_spec rod_case_spec(const rod_case *c, const law_along *law)
{
    return (rod_spec){
        .law = law,
        .rest = c->rest,
        .ntendon = c->tendons.count,
        .npoint_load = c->loads.count,
        .nline_load = c->line_loads.count,
        .nbreak = c->breaks.nrow * c->breaks.ncol,
        .tendons = c->spec,
        .point_loads = c->loads.items,
        .line_loads = c->line_loads.items,
        .breaks = c->breaks.a,
        .gravity = {c->gravity[0], c->gravity[1], c->gravity[2]},
    };
}

void rod_case_release(rod_case *c)
{
    tendon_case *t = c->tendons.items;
    for (int i = 0; t && i < c->tendons.count; i++) {
        free(t[i].read);
        t[i].read = NULL;
    }
    free(c->spec);
    c->spec = NULL;
}

// --- solutions

static int most(int a, int b)
{
    return a > b ? a : b;
}

// rows, of which tensions, pulls and factors have as many or one; 0: nothing is asked for
static int row_count(const rod_case *c)
{
    const int given = most(c->tensions.nrow, most(c->pulls.nrow, c->factors.nrow));
    const bool bent = rod_case_loads(c) > 0 || mark_given(c->rest.at);
    return given > 0 ? given : c->sweep.count > 0 || (bent && c->tendons.count == 0);
}

// solutions for every row; where they are too many some number beyond ROD_CASE_SOLUTIONS
static int grid_count(const rod_case *c)
{
    const sweep_case *sweep = c->sweep.items;
    int n = 1;
    for (int i = 0; i < c->sweep.count && n <= ROD_CASE_SOLUTIONS; i++) {
        n = n <= ROD_CASE_SOLUTIONS / (sweep[i].steps + 1) ? n * (sweep[i].steps + 1)
                                                           : ROD_CASE_SOLUTIONS + 1;
    }
    return n;
}

int rod_case_solutions(const rod_case *c)
{
    const long n = (long)row_count(c) * grid_count(c);
    return n <= ROD_CASE_SOLUTIONS ? (int)n : ROD_CASE_SOLUTIONS + 1;
}

mark rod_case_rows(const rod_case *c)
{
    const mark all[] = {c->tensions.at, c->pulls.at, c->factors.at,
                        c->sweep.at,    c->loads.at, c->line_loads.at};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        if (mark_given(all[i])) {
            return all[i];
        }
    }
    return c->at;
}

// entry j of a row; of the only one where there is one
static double entry(const key_rows *rows, int row, int j, double missing)
{
    const int i = rows->nrow == 1 ? 0 : row;
    return rows->nrow > 0 ? rows->a[(size_t)i * (size_t)rows->ncol + (size_t)j] : missing;
}

// the swept number of this solution, the last sweep running fastest
static void apply_sweeps(const rod_case *c, int place, double *tension, double *pull, double *load)
{
    const sweep_case *sweep = c->sweep.items;
    for (int i = c->sweep.count - 1; i >= 0; i--) {
        const sweep_case *w = &sweep[i];
        const int step = place % (w->steps + 1);
        const double t = (double)step / w->steps;
        const double value =
            step == w->steps ? w->to[w->kind] : w->from[w->kind] * (1 - t) + w->to[w->kind] * t;
        double *of[SWEEP_KINDS] = {tension, pull, load};
        of[w->kind][w->index] = value;
        if (w->kind == SWEEP_TENSION) {
            pull[w->index] = NAN;
        }
        place /= w->steps + 1;
    }
}

void rod_case_solution(const rod_case *c, int i, double *tension, double *pull, double *load)
{
    const int grid = grid_count(c), row = i / grid;
    for (int j = 0; j < c->tendons.count; j++) {
        tension[j] = entry(&c->tensions, row, j, NAN);
        pull[j] = entry(&c->pulls, row, j, NAN);
    }
    for (int j = 0; j < rod_case_loads(c); j++) {
        load[j] = entry(&c->factors, row, j, 1);
    }
    apply_sweeps(c, i % grid, tension, pull, load);
    for (int j = 0; j < c->tendons.count; j++) {
        tension[j] = isnan(pull[j]) ? tension[j] : 0;
    }
}
