// rodsolver/equilibrium_demand.c
// What a request asks for, and what kind of problem that makes.
#include "rodsolver/equilibrium.h"

#include <math.h>

void demand_of(const rod_state *state, const rod_request *q, demand *d)
{
    const rod *r = state->rod;
    for (int i = 0; i < r->ntendon; i++) {
        d->pull[i] = q->pull ? q->pull[i] : NAN;
        d->tension[i] = state->tension[i];
    }
    for (int i = 0; i < rod_load_count(r); i++) {
        d->load[i] = q->load ? q->load[i] : 1;
    }
    d->tip_space = q->tip_space;
    d->tip_body = q->tip_body;
    d->to_base = mat3_transpose(mat3_mul(state->base.R, r->base.R));
}

static bool is_zero(const double *a, int n)
{
    for (int i = 0; i < n; i++) {
        if (a[i] != 0) {
            return false;
        }
    }
    return true;
}

static void classify_load(int frame, const double *force, const double *moment, bool line,
                          equilibrium *e)
{
    const bool turns = frame == LOAD_BODY;
    e->lines = e->lines || line;
    e->followers = e->followers || (turns && !is_zero(force, 3));
    // a moment that keeps its direction has no potential either
    e->conservative = e->conservative && !turns && is_zero(moment, 3);
}

static bool field_is_zero(const field *f)
{
    return !field_varies(f) && f->value == 0;
}

static void classify_demand(equilibrium *e, const demand *d)
{
    const rod *r = e->rod;
    static const double some[3] = {1, 1, 1}, none[3] = {0};
    for (int i = 0; i < r->npoint_load; i++) {
        const point_load *l = &r->point_loads[i];
        if (d->load[i] != 0) {
            classify_load(l->frame, l->force, l->moment, false, e);
        }
    }
    for (int i = 0; i < r->nline_load + r->has_gravity; i++) {
        const line_load *l = i < r->nline_load ? &r->line_loads[i] : NULL;
        const bool moment = l && !(field_is_zero(&l->moment[0]) && field_is_zero(&l->moment[1]) &&
                                   field_is_zero(&l->moment[2]));
        if (d->load[r->npoint_load + i] != 0) {
            classify_load(l ? l->frame : LOAD_SPACE, some, moment ? some : none, true, e);
        }
    }
    classify_load(LOAD_SPACE, d->tip_space.a, d->tip_space.a + 3, false, e);
    if (!is_zero(d->tip_body.a, 6)) {
        classify_load(LOAD_BODY, d->tip_body.a, d->tip_body.a + 3, false, e);
    }
}

void demand_classify(equilibrium *e)
{
    e->conservative = true;
    e->lines = e->followers = e->friction = false;
    classify_demand(e, &e->from);
    classify_demand(e, &e->to);
    for (int i = 0; i < e->rod->ntendon; i++) {
        const bool pulls = e->from.tension[i] > 0 || e->to.tension[i] > 0 || !isnan(e->to.pull[i]);
        e->friction = e->friction || (pulls && e->rod->spec[i].friction > 0);
    }
    e->conservative = e->conservative && !e->friction;
}
