// fem/way_run.c
#include "fem/level_forces.h"

#include "base/beam_law.h"
#include "base/memory.h"
#include "fem/level_fit.h"

#include <string.h>

void way_run_free(way_run *run)
{
    free(run->z);
    free(run->motion);
    free(run->resultant);
    free(run->applied);
    free(run->work);
    free(run->u);
    *run = (way_run){0};
}

void way_field_exchange(const way_field *f)
{
    const level_share *s = &f->share;
    const int p = f->p->body->order, n = 3 * f->p->body->plane->nnode;
    const bool busy = s->first < s->last, top = s->last == f->p->body->nlevel;
    for (int j = 0; j < problem_columns(f->p); j++) {
        const bool down = busy && s->rank > 0, above = busy && !top;
        f->door->pass_down(down ? n : 0, down ? way_field_level(f, j, s->first) : NULL,
                           above ? n : 0, above ? way_field_level(f, j, s->last) : NULL);
        for (int k = 1; k <= p; k++) { // the last layer's levels are the next rank's layer below
            f->door->pass_up(above ? n : 0, above ? way_field_level(f, j, s->last - k) : NULL,
                             down ? n : 0, down ? way_field_level(f, j, s->first - k) : NULL);
        }
    }
}

// the base's origin, and motions of the base as columns have them; zeroes on ranks without it
static status base_motions(const way_field *f, int ncolumn, double *origin, vec6 *q)
{
    status st = OK;
    level_fit fit = {0};
    if (f->share.first == 0 && f->share.last > 0) {
        body_origin(f->p->body, 0, origin);
        TRY(level_fit_make(f->p->body, 0, LEVEL_BY_E, &fit));
        for (int j = 0; j < ncolumn; j++) {
            q[j] = level_fit_motion(&fit, way_field_level(f, j, 0));
        }
    }

done:
    level_fit_free(&fit);
    return st;
}

static void take_out(const body *b, int level, const double *origin, vec6 q, double *u)
{
    for (int i = 0; i < b->plane->nnode; i++, u += 3) {
        double x[3];
        body_node(b, i, level, x);
        u[0] -= q.a[NX] - q.a[MZ] * (x[1] - origin[1]);
        u[1] -= q.a[NY] + q.a[MZ] * (x[0] - origin[0]);
    }
}

status way_field_centre(const way_field *f)
{
    status st = OK;
    const body *b = f->p->body;
    const int ncolumn = problem_columns(f->p);
    double origin[3] = {0};
    vec6 *q = NULL;
    TRY(f->door->agree(TAKE(q, (size_t)ncolumn)));
    TRY(f->door->agree(base_motions(f, ncolumn, origin, q)));
    f->door->sum(3, origin);
    f->door->sum(6 * ncolumn, q->a);
    for (int j = 0; j < ncolumn; j++) {
        for (int level = f->share.from; level < f->share.to; level++) {
            take_out(b, level, origin, q[j], way_field_level(f, j, level));
        }
    }

done:
    free(q);
    return st;
}

// one fit does for all levels of a prism that is the same everywhere
static bool levels_are_alike(const body *b)
{
    bool alike = b->prism && !b->spec.matter;
    for (int k = 0; k < b->plane->nblock; k++) {
        const mesh_block *block = &b->plane->block[k];
        for (int e = 0; alike && e < block->nelem; e++) {
            alike = !material_varies(&b->spec.materials[block->material[e]]);
        }
    }
    return alike;
}

static status fit_motions(const way_field *f, vec6 *motion)
{
    status st = OK;
    level_fit fit = {0};
    const body *b = f->p->body;
    const int ncolumn = problem_columns(f->p);
    const bool alike = levels_are_alike(b);
    for (int level = f->share.first; level < f->share.last; level++) {
        if (!alike || level == f->share.first) {
            level_fit_free(&fit);
            TRY(level_fit_make(b, level, LEVEL_BY_E, &fit));
        }
        for (int j = 0; j < ncolumn; j++) {
            motion[j * b->nlevel + level] = level_fit_motion(&fit, way_field_level(f, j, level));
        }
    }

done:
    level_fit_free(&fit);
    return st;
}

static status take_room(const way_field *f, way_run *run)
{
    status st = OK;
    const size_t all = (size_t)run->ncolumn * (size_t)run->nlevel;
    TRY(TAKE(run->z, (size_t)run->nlevel));
    TRY(TAKE(run->motion, all));
    TRY(TAKE(run->resultant, all));
    memcpy(run->z, f->p->body->level, (size_t)run->nlevel * sizeof *run->z);

done:
    return st;
}

static status keep_field(const way_field *f, way_run *run)
{
    status st = OK;
    const level_share *s = &f->share;
    const size_t all = way_field_offset(f, run->ncolumn, s->from);
    run->first = s->from;
    run->last = s->to;
    run->shared = s->size > 1;
    run->own_first = s->first;
    run->own_last = s->last;
    run->shared = s->size > 1;
    TRY(TAKE(run->u, all));
    memcpy(run->u, f->u, all * sizeof *run->u);

done:
    return st;
}

static status fill_own(const way_field *f, const level_forces *inner, const way_wants *wants,
                       way_run *run)
{
    status st = OK;
    TRY(take_room(f, run));
    TRY(fit_motions(f, run->motion));
    way_resultants(f, inner, run->resultant);
    if (wants->fields) {
        TRY(keep_field(f, run));
    }

done:
    return st;
}

// whether anything but wrenches on the tip puts forces on the body
static bool has_more_loads(const segment_problem *p)
{
    bool more = p->nspring > 0 || p->nhold > 0;
    for (int j = 0; j < p->nextra; j++) {
        const load_column *c = &p->extra[j];
        more = more || c->npressure > 0 || c->holds_move;
        for (int d = 0; d < 3; d++) {
            more = more || c->body_force[d] != 0 || c->acceleration[d] != 0;
        }
    }
    return more;
}

status way_fill(const way_field *f, const level_forces *inner, const way_wants *wants, way_run *out)
{
    status st = OK;
    out->ncolumn = problem_columns(f->p);
    out->nlevel = f->p->body->nlevel;
    const int many = 6 * out->ncolumn * out->nlevel;
    TRY(f->door->agree(fill_own(f, inner, wants, out)));
    f->door->sum(many, out->motion->a);
    f->door->sum(many, out->resultant->a);
    if (has_more_loads(f->p)) {
        TRY(f->door->agree(TAKE(out->applied, (size_t)(many / 6))));
        TRY(way_applied(f, inner, out->applied));
    }
    TRY(way_window_energy(f, wants, out->motion, &out->energy));

done:
    return st;
}
