// fem/level_balance.c
// What balances the loads where the base is free to contract, and the right-hand sides.
#include "fem/level_loads.h"

#include "base/beam_law.h"
#include "base/memory.h"
#include "fem/level_fit.h"

#include <string.h>

vec6 wrench_moved(vec6 w, const double from[3], const double to[3])
{
    const vec3 arm = {{from[0] - to[0], from[1] - to[1], from[2] - to[2]}};
    const vec3 turn = vec3_cross(arm, vec6_linear(w));
    for (int i = 0; i < 3; i++) {
        w.a[3 + i] += turn.a[i];
    }
    return w;
}

vec6 wrench_of_force(const double *f, const double *x)
{
    const vec3 m = vec3_cross((vec3){{x[0], x[1], x[2]}}, (vec3){{f[0], f[1], f[2]}});
    return (vec6){{f[0], f[1], f[2], m.a[0], m.a[1], m.a[2]}};
}

void level_fit_add_wrench(const level_fit *fit, vec6 w, double *force)
{
    const size_t n = 3 * (size_t)fit->nplane;
    for (size_t j = 0; j < 6; j++) {
        for (size_t i = 0; w.a[j] != 0 && i < n; i++) {
            force[i] += w.a[j] * fit->force[j * n + i];
        }
    }
}

typedef struct balance {
    const segment_problem *p;
    const level_share *s;
    level_loads *loads;
} balance;

// resultants of this rank's own levels about the base's origin; a rigid cap's unit wrenches act at
// the tip's
static void sum_forces(const balance *l, double *total)
{
    const body *b = l->p->body;
    for (int j = 0; j < l->loads->ncolumn; j++) {
        vec6 w = {0};
        for (int level = l->s->first; level < l->s->last; level++) {
            const double *f = (l->loads->force + level_loads_offset(b, l->s, j, level));
            for (int i = 0; i < b->plane->nnode; i++) {
                double x[3];
                body_node(b, i, level, x);
                w = vec6_add(w, wrench_of_force(f + 3 * (size_t)i, x));
            }
        }
        if (j < 6 && l->p->tip == TIP_RIGID && l->s->last == b->nlevel &&
            l->s->first < l->s->last) {
            const double zero[3] = {0};
            double tip[3];
            vec6 unit = {0};
            unit.a[j] = 1;
            body_origin(b, b->nlevel - 1, tip);
            w = vec6_add(w, wrench_moved(unit, tip, zero));
        }
        memcpy(total + 6 * (size_t)j, w.a, sizeof w.a);
    }
}

// Sideways forces and torque are answered by an E-proportional traction on the base, the multiplier
// of "no mean motion". (5.8)
static status balance_base(const balance *l, const double *total)
{
    status st = OK;
    level_fit by_E = {0};
    const double zero[3] = {0};
    double base[3];
    if (l->s->from > 0) {
        return OK;
    }
    TRY(level_fit_make(l->p->body, 0, LEVEL_BY_E, &by_E));
    body_origin(l->p->body, 0, base);
    for (int j = 0; j < l->loads->ncolumn; j++) {
        vec6 w;
        memcpy(w.a, total + 6 * (size_t)j, sizeof w.a);
        w = wrench_moved(w, zero, base);
        const vec6 answer = {{-w.a[NX], -w.a[NY], 0, 0, 0, -w.a[MZ]}};
        level_fit_add_wrench(&by_E, answer,
                             l->loads->force + level_loads_offset(l->p->body, l->s, j, 0));
    }

done:
    level_fit_free(&by_E);
    return st;
}

status level_loads_balance(const petsc_door *door, const segment_problem *p, const level_share *s,
                           level_loads *loads)
{
    status st = OK;
    const balance l = {p, s, loads};
    const int many = 6 * loads->ncolumn;
    double *total = NULL;
    TRY(door->agree(TAKE(total, (size_t)many)));
    sum_forces(&l, total);
    door->sum(many, total);
    TRY(door->agree(balance_base(&l, total)));

done:
    free(total);
    return st;
}

void level_loads_gather(const level_loads *l, const segment_problem *p, const unknowns *u,
                        double *b)
{
    const level_share *s = &u->share;
    const size_t held = 3 * (size_t)(s->to - s->from) * (size_t)u->nplane;
    const size_t rows = 3 * (size_t)(u->last - u->first);
    for (int j = 0; j < l->ncolumn; j++) {
        double *to = b + (size_t)j * rows;
        unknowns_gather(u, l->force + (size_t)j * held, to);
        if (j < 6 && p->tip == TIP_RIGID && unknowns_has_tip(u)) {
            to[3 * (u->cap_block - u->first) + j] += j < 3 ? 1 : 1 / u->radius;
        }
    }
}
