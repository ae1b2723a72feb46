// rodsolver/equilibrium_make.c
#include "base/memory.h"
#include "rodsolver/equilibrium.h"

static status take_demand(const rod *r, demand *d)
{
    status st = OK;
    TRY(TAKE(d->tension, (size_t)r->ntendon));
    TRY(TAKE(d->pull, (size_t)r->ntendon));
    TRY(TAKE(d->load, (size_t)rod_load_count(r)));
    d->to_base = mat3_identity();

done:
    return st;
}

static void give_back_demand(demand *d)
{
    free(d->tension);
    free(d->pull);
    free(d->load);
}

static status take_stations(equilibrium *e, size_t n)
{
    status st = OK;
    TRY(TAKE(e->xi, n));
    TRY(TAKE(e->line, n));
    TRY(TAKE(e->line_from, n));
    TRY(TAKE(e->line_to, n));
    TRY(TAKE(e->line_difference, n));
    TRY(TAKE(e->state, n));
    TRY(TAKE(e->tangent, n));
    TRY(TAKE(e->omega, n));
    TRY(TAKE(e->nu, n));
    TRY(TAKE(e->rv, n));
    TRY(TAKE(e->rw, n));
    TRY(TAKE(e->kept_v, n));
    TRY(TAKE(e->kept_w, n));
    TRY(TAKE(e->arc_v, n));
    TRY(TAKE(e->load_rate, n));
    TRY(TAKE(e->arc_w, n));
    TRY(TAKE(e->step, n));
    TRY(TAKE(e->slope, n));
    TRY(TAKE(e->old, n));
    TRY(TAKE(e->scratch, n));
    TRY(TAKE(e->direction, n));
    TRY(TAKE(e->arc_step, n));
    TRY(TAKE(e->decay, n * (size_t)e->rod->ntendon));

done:
    return st;
}

static status take_nodes(equilibrium *e, size_t n)
{
    status st = OK;
    TRY(TAKE(e->node, n));
    TRY(TAKE(e->node_from, n));
    TRY(TAKE(e->node_to, n));
    TRY(TAKE(e->node_difference, n));
    TRY(TAKE(e->node_R, n));
    TRY(TAKE(e->node_N, n));
    TRY(TAKE(e->node_M, n));
    TRY(TAKE(e->answer_N, n));
    TRY(TAKE(e->answer_M, n));
    TRY(TAKE(e->node_p, n));
    TRY(TAKE(e->panel, n));
    TRY(TAKE(e->phi, n));
    TRY(TAKE(e->beyond, n));

done:
    return st;
}

static status take_tendons(equilibrium *e, size_t n)
{
    status st = OK;
    TRY(TAKE(e->pulled, n));
    TRY(TAKE(e->slack, n));
    TRY(TAKE(e->tension, n));
    TRY(TAKE(e->rest_length, n));
    TRY(TAKE(e->length, n));
    TRY(TAKE(e->length_by_tension, n * n));
    TRY(TAKE(e->tension_step, n));
    TRY(TAKE(e->tension_slope, n));
    TRY(TAKE(e->tension_old, n));
    TRY(TAKE(e->tension_direction, n));
    TRY(TAKE(e->arc_tension, n));

done:
    return st;
}

static status take_follow(follow_room *f, size_t nstation, size_t ntendon)
{
    status st = OK;
    TRY(TAKE(f->v, nstation));
    TRY(TAKE(f->w, nstation));
    TRY(TAKE(f->given, ntendon));
    TRY(TAKE(f->change, ntendon));
    TRY(TAKE(f->x, nstation));
    TRY(TAKE(f->basis, nstation * (FRICTION_VECTORS + 1)));

done:
    return st;
}

static bool any_friction(const rod *r)
{
    for (int i = 0; i < r->ntendon; i++) {
        if (r->spec[i].friction > 0) {
            return true;
        }
    }
    return false;
}

status equilibrium_make(const rod *r, equilibrium **out)
{
    status st = OK;
    equilibrium *e = NULL;
    TRY(TAKE(e, 1));
    e->rod = r;
    for (int k = 0; k < r->nplan; k++) {
        e->room = r->plans[k].nstation > e->room ? r->plans[k].nstation : e->room;
    }
    e->room = r->half.nstation > e->room ? r->half.nstation : e->room;
    TRY(take_demand(r, &e->from));
    TRY(take_demand(r, &e->to));
    TRY(take_stations(e, (size_t)e->room));
    TRY(take_nodes(e, (size_t)e->room / GAUSS_STATIONS + 1));
    TRY(take_tendons(e, (size_t)r->ntendon));
    if (any_friction(r)) {
        TRY(take_follow(&e->follow, (size_t)e->room, (size_t)r->ntendon));
    }
    *out = e; // ownership passes only when all is well
    e = NULL;

done:
    equilibrium_free(e);
    return st;
}

static void free_all(size_t n, void **owned)
{
    for (size_t i = 0; i < n; i++) {
        free(owned[i]);
    }
}

static void give_back_stations(equilibrium *e)
{
    void *owned[] = {
        e->xi,           e->line,          e->line_from, e->line_to,     e->line_difference,
        e->state,        e->tangent,       e->omega,     e->nu,          e->rv,
        e->rw,           e->kept_v,        e->kept_w,    e->arc_v,       e->load_rate,
        e->arc_w,        e->step,          e->slope,     e->old,         e->scratch,
        e->direction,    e->arc_step,      e->decay,     e->follow.v,    e->follow.w,
        e->follow.given, e->follow.change, e->follow.x,  e->follow.basis};
    free_all(sizeof owned / sizeof *owned, owned);
}

static void give_back_rest(equilibrium *e)
{
    void *owned[] = {e->node_N,
                     e->node_M,
                     e->answer_N,
                     e->answer_M,
                     e->node,
                     e->node_from,
                     e->node_to,
                     e->node_difference,
                     e->node_R,
                     e->node_p,
                     e->panel,
                     e->phi,
                     e->beyond,
                     e->pulled,
                     e->slack,
                     e->tension,
                     e->rest_length,
                     e->length,
                     e->length_by_tension,
                     e->tension_step,
                     e->tension_slope,
                     e->tension_old,
                     e->tension_direction,
                     e->arc_tension};
    free_all(sizeof owned / sizeof *owned, owned);
}

void equilibrium_free(equilibrium *e)
{
    if (!e) {
        return;
    }
    give_back_demand(&e->from);
    give_back_demand(&e->to);
    give_back_stations(e);
    give_back_rest(e);
    free(e);
}
