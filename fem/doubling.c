// fem/doubling.c
// The first of the three ways: a prism's slabs are all the same, so one is condensed to its two
// ends and joined with itself until it is the body. docs/theory.md (5.12)
#include "fem/way.h"

#include "base/memory.h"
#include "fem/blas.h"
#include "fem/doubling_answer.h"
#include "fem/doubling_plan.h"
#include "fem/doubling_symmetry.h"

#include <math.h>
#include <string.h>
#include <time.h>

static double cpu_seconds(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

// --- what loads it

static vec6 turned(double angle, vec6 w)
{
    const mat3 R = mat3_rot_z(angle);
    const vec3 n = mat3_mul_vec(R, vec6_linear(w)), m = mat3_mul_vec(R, vec6_angular(w));
    return (vec6){{n.a[0], n.a[1], n.a[2], m.a[0], m.a[1], m.a[2]}};
}

// resultant of a column on the tip, in the base's axes about the section's origin
static vec6 column_wrench(const doubling *d, const level_fit *area, int j)
{
    vec6 w = {0};
    if (j < 6) {
        w.a[j] = 1;
        return w;
    }
    const load_column *l = d->problem->extra + (j - 6);
    const double tip = d->turn_rate * (d->begin + d->problem->body->length);
    const vec3 force = {{l->tip_force[0], l->tip_force[1], l->tip_force[2]}};
    const vec3 at =
        mat3_mul_vec(mat3_rot_z(tip), (vec3){{area->centroid[0], area->centroid[1], 0}});
    const vec3 moment = vec3_cross(at, force);
    for (int i = 0; i < 3 && l->uniform_tip; i++) {
        w.a[i] = force.a[i];
        w.a[3 + i] = moment.a[i];
    }
    return w;
}

// nodal forces along a, b, z with a resultant in the section's axes
static void spread(const doubling *d, const level_fit *fit, vec6 w, double *f)
{
    const size_t dofs = 3 * (size_t)fit->nplane;
    const double c = cos(d->cut.angle), s = sin(d->cut.angle);
    for (int i = 0; i < 6; i++) {
        for (size_t k = 0; w.a[i] != 0 && k < dofs; k++) {
            f[k] += w.a[i] * fit->force[(size_t)i * dofs + k];
        }
    }
    for (size_t k = 0; k < dofs; k += 3) {
        const double x = f[k], y = f[k + 1];
        f[k] = c * x + s * y;
        f[k + 1] = c * y - s * x;
    }
}

static status make_loads(const segment_problem *p, const body *thin, doubling *d)
{
    status st = OK;
    const size_t dofs = 3 * (size_t)p->body->plane->nnode;
    level_fit by_E = {0}, by_area = {0};
    TRY(level_fit_make(thin, 0, LEVEL_BY_E, &by_E));
    TRY(level_fit_make(thin, 0, LEVEL_BY_AREA, &by_area));
    TRY(TAKE(d->tip_force, (size_t)d->ncolumn * dofs));
    TRY(TAKE(d->base_force, (size_t)d->ncolumn * dofs));
    TRY(TAKE(d->fit, 6 * dofs));
    for (int j = 0; j < d->ncolumn; j++) {
        const vec6 w = column_wrench(d, &by_area, j);
        const vec6 answer = {{-w.a[NX], -w.a[NY], 0, 0, 0, -w.a[MZ]}};
        const double tip = d->turn_rate * (d->begin + p->body->length);
        spread(d, j < 6 ? &by_E : &by_area, turned(-tip, w), d->tip_force + (size_t)j * dofs);
        if (p->base == BASE_FREE_TO_CONTRACT) {
            spread(d, &by_E, turned(-d->turn_rate * d->begin, answer),
                   d->base_force + (size_t)j * dofs);
        }
    }
    for (int i = 0; i < 6; i++) {
        vec6 unit = {0};
        unit.a[i] = 1;
        spread(d, &by_E, unit, d->fit + (size_t)i * dofs);
    }

done:
    level_fit_free(&by_E);
    level_fit_free(&by_area);
    return st;
}

// --- the whole way

static void doubling_free(doubling *d)
{
    cut_free(&d->cut);
    slab_free(&d->slab);
    free(d->tip_force);
    free(d->base_force);
    free(d->fit);
    *d = (doubling){0};
}

static status make(const segment_problem *p, doubling *d)
{
    status st = OK;
    body thin = {0};
    TRY(doubling_thin_body(p->body, d->doublings, &thin));
    TRY(doubling_slab_make(&thin, &d->slab, &d->cut));
    TRY(make_loads(p, &thin, d));

done:
    body_free(&thin);
    return st;
}

static status solve_part(const doubling *d, int part, double *cell_energy, way_run *run)
{
    status st = OK;
    slab_stiffness thin = {0};
    doubling_tree t = {0};
    const double begin = cpu_seconds();
    TRY(slab_condense(&d->slab, &d->cut, part, &thin));
    const double condensed = cpu_seconds();
    TRY(doubling_tree_make(&d->cut, part, &d->slab, &thin, d->doublings, d->grid, d->wants->fields,
                           d->wants->cancelled, &t));
    const double joined = cpu_seconds();
    TRY(doubling_answer_add(d, &t, cell_energy, run));
    run->assemble_seconds += condensed - begin;
    run->factor_seconds += joined - condensed;
    run->solve_seconds += cpu_seconds() - joined;

done:
    free(thin.P);
    free(thin.N);
    doubling_tree_free(&t);
    return st;
}

static status take_fields(const segment_problem *p, const doubling *d, way_run *run)
{
    status st = OK;
    run->first = p->body->first;
    run->last = p->body->last;
    if (d->wants->fields) {
        TRY(TAKE(run->u, (size_t)d->ncolumn * (size_t)(run->last - run->first) * 3 *
                             (size_t)p->body->plane->nnode));
    }

done:
    return st;
}

status way_doubling(const segment_problem *p, const way_wants *wants, way_run *out)
{
    status st = OK;
    doubling d = {.problem = p,
                  .wants = wants,
                  .ncolumn = problem_columns(p),
                  .doublings = doubling_count(p->body),
                  .begin = p->body->level[0],
                  .turn_rate = p->body->spec.turn_rate};
    way_run run = {0};
    double *cell_energy = NULL;
    const double begin = cpu_seconds();
    TRY(doubling_check(p));
    TRY(blas_take());
    d.grid = d.doublings < REPORTED_HALVINGS ? d.doublings : REPORTED_HALVINGS;
    TRY(TAKE(cell_energy, 36 * ((size_t)1 << d.grid)));
    TRY(doubling_answer_take(&d, &run));
    TRY(take_fields(p, &d, &run));
    TRY(make(p, &d));
    run.assemble_seconds = cpu_seconds() - begin;
    for (int part = 0; part < d.cut.npart; part++) {
        TRY(solve_part(&d, part, cell_energy, &run));
    }
    TRY(doubling_answer_finish(&d, cell_energy, &run));
    run.dofs = 3LL * p->body->plane->nnode * p->body->order * (1LL << d.doublings);
    *out = run;
    run = (way_run){0};

done:
    free(cell_energy);
    doubling_free(&d);
    way_run_free(&run);
    return st;
}
