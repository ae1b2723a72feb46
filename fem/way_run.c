// fem/way_run.c
#include "fem/way_fill.h"

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

void way_field_get_above(const petsc_door *door, const body *b, const level_share *s, int ncolumn,
                         double *u)
{
    const size_t n = 3 * (size_t)b->plane->nnode, held = (size_t)way_field_levels(s, b->order);
    const bool sends = s->first < s->last && s->rank > 0;
    const bool gets = s->first < s->last && s->last < b->nlevel;
    for (size_t j = 0; j < (size_t)ncolumn; j++) {
        double *mine = u + j * held * n;
        door->pass_down(sends ? (int)n : 0, mine, gets ? (int)n : 0,
                        gets ? mine + (held - 1) * n : NULL);
    }
}

void way_field_gather(const way_field *f, int column, const int *conn, int per_elem, int layer,
                      double *u)
{
    const int p = f->p->body->order;
    for (int k = 0; k <= p; k++) {
        const double *from = way_field_level(f, column, layer * p + k);
        for (int a = 0; a < per_elem; a++, u += 3) {
            memcpy(u, from + 3 * (size_t)conn[a], 3 * sizeof *u);
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

status way_field_centre(const way_field *f, double *u)
{
    status st = OK;
    const body *b = f->p->body;
    const int ncolumn = problem_columns(f->p);
    const size_t n = 3 * (size_t)b->plane->nnode;
    double origin[3] = {0};
    vec6 *q = NULL;
    TRY(f->door->agree(TAKE(q, (size_t)ncolumn)));
    TRY(f->door->agree(base_motions(f, ncolumn, origin, q)));
    f->door->sum(3, origin);
    f->door->sum(6 * ncolumn, q->a);
    for (int j = 0; j < ncolumn; j++) {
        for (int level = f->share.first; level < f->share.last; level++) {
            const size_t at = (size_t)j * (size_t)f->nheld + (size_t)(level - f->share.first);
            take_out(b, level, origin, q[j], u + at * n);
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
    const size_t n = 3 * (size_t)f->p->body->plane->nnode;
    run->first = f->share.first;
    run->last = f->share.last;
    const size_t own = (size_t)(run->last - run->first) * n;
    TRY(TAKE(run->u, (size_t)run->ncolumn * own));
    for (size_t j = 0; j < (size_t)run->ncolumn && own > 0; j++) {
        memcpy(run->u + j * own, way_field_level(f, (int)j, run->first), own * sizeof *run->u);
    }

done:
    return st;
}

static status fill_own(const way_field *f, const way_wants *wants, way_run *run)
{
    status st = OK;
    TRY(take_room(f, run));
    TRY(fit_motions(f, run->motion));
    TRY(way_resultants(f, run->resultant));
    if (wants->fields) {
        TRY(keep_field(f, run));
    }

done:
    return st;
}

status way_fill(const way_field *f, const way_wants *wants, way_run *out)
{
    status st = OK;
    out->ncolumn = problem_columns(f->p);
    out->nlevel = f->p->body->nlevel;
    const int many = 6 * out->ncolumn * out->nlevel;
    TRY(f->door->agree(fill_own(f, wants, out)));
    f->door->sum(many, out->motion->a);
    f->door->sum(many, out->resultant->a);
    TRY(way_window_energy(f, wants, out->motion, &out->energy));

done:
    return st;
}
