// fem/coarse.c
#include "fem/coarse_parts.h"

#include "base/memory.h"
#include "fem/blas.h"
#include "fem/mesh_axes.h"

#include <string.h>

void coarse_free(coarse *c)
{
    if (c) {
        free(c->matrix);
        free(c->right);
        free(c->rigid);
        free(c->turned);
        free(c->added);
        free(c->active);
        free(c);
    }
}

bool coarse_is_active(const coarse *c, int level, int mode)
{
    const coarse_spec *s = &c->spec;
    if (level == 0 && s->clamped) {
        return false;
    }
    if (level == 0 && s->guided) {
        return mode < COARSE_RIGID ? mode == 0 || mode == 1 || mode == 5
                                   : !s->modes->along[mode - COARSE_RIGID];
    }
    return mode < COARSE_RIGID || !(s->cap && level == s->body->nlevel - 1);
}

// direction by direction, u [3][nplane][ncol] into other axes: v_i = sum_j R_ij u_j
static void turn_axes(mat3 R, size_t run, const double *u, double *v)
{
    for (size_t i = 0; i < 3; i++) {
        for (size_t k = 0; k < run; k++) {
            v[i * run + k] = R.a[i][0] * u[k] + R.a[i][1] * u[run + k] + R.a[i][2] * u[2 * run + k];
        }
    }
}

static void take_out_inactive(const coarse *c, int level, int ncol, double *y)
{
    for (int k = 0; k < c->count; k++) {
        for (int j = 0; !coarse_is_active(c, level, k) && j < ncol; j++) {
            y[k * ncol + j] = 0;
        }
    }
}

void coarse_restrict(coarse *c, int level, int ncol, const double *r, double *y)
{
    const body *b = c->spec.body;
    const section_modes *m = c->spec.modes;
    const int n3 = 3 * b->plane->nnode;
    const double *turned = r;
    if (!b->prism) {
        turn_axes(mat3_transpose(mesh_axes(b, level)), (size_t)b->plane->nnode * (size_t)ncol, r,
                  c->turned);
        turned = c->turned;
    }
    section_rigid(b, level, c->rigid);
    blas_product(COARSE_RIGID, ncol, n3, c->rigid, r, 0, y);
    blas_product(m->count, ncol, n3, m->value, turned, 0, y + COARSE_RIGID * ncol);
    take_out_inactive(c, level, ncol, y);
}

void coarse_prolong(coarse *c, int level, int ncol, const double *y, double *z)
{
    const body *b = c->spec.body;
    const section_modes *m = c->spec.modes;
    const int n3 = 3 * b->plane->nnode, rigid = COARSE_RIGID;
    const size_t run = (size_t)b->plane->nnode * (size_t)ncol;
    const double one = 1, before = b->prism ? 1 : 0;
    double *to = b->prism ? z : c->turned;
    memcpy(c->active, y, (size_t)c->count * (size_t)ncol * sizeof *y);
    take_out_inactive(c, level, ncol, c->active);
    section_rigid(b, level, c->rigid);
    // by rows: z [3n][ncol] += modes [3n][count] y [count][ncol]
    dgemm_("N", "N", &ncol, &n3, &rigid, &one, c->active, &ncol, c->rigid, &rigid, &one, z, &ncol);
    dgemm_("N", "N", &ncol, &n3, &m->count, &one, c->active + COARSE_RIGID * ncol, &ncol, m->value,
           &m->count, &before, to, &ncol);
    if (!b->prism) {
        turn_axes(mesh_axes(b, level), run, c->turned, c->added);
        for (size_t i = 0; i < 3 * run; i++) {
            z[i] += c->added[i];
        }
    }
}

static status take_room(coarse *c)
{
    status st = OK;
    const size_t n3 = 3 * (size_t)c->spec.body->plane->nnode, count = (size_t)c->count;
    TRY(TAKE(c->rigid, n3 * COARSE_RIGID));
    TRY(TAKE(c->turned, n3 * count));
    TRY(TAKE(c->added, n3 * count));
    TRY(TAKE(c->active, count * count));

done:
    return st;
}

status coarse_make(const coarse_spec *spec, coarse **out)
{
    status st = OK;
    coarse *c = NULL;
    const body *b = spec->body;
    int info = 0;
    TRY(TAKE(c, 1));
    *c = (coarse){.spec = *spec, .count = COARSE_RIGID + spec->modes->count};
    c->size = c->count * b->nlevel;
    c->band = c->count * (b->order + 1) - 1;
    TRY(TAKE(c->matrix, (size_t)c->size * (size_t)(c->band + 1)));
    TRY(take_room(c));
    TRY(TAKE(c->right, (size_t)c->size));
    TRY(coarse_fill(c));
    const int room = c->band + 1;
    dpbtrf_("U", &c->size, &c->band, c->matrix, &room, &info);
    if (info != 0) {
        TRY(status_fail(ERR_NUMERIC,
                        "segment: the supports leave a motion of the body free, or its stiffness "
                        "is not positive"));
    }
    *out = c;
    c = NULL;

done:
    coarse_free(c);
    return st;
}

size_t coarse_values(const coarse *c)
{
    return (size_t)c->size;
}

double coarse_bytes(const coarse *c)
{
    return (double)c->size * (c->band + 1) * sizeof(double);
}

void coarse_solve(coarse *c, int ncol, const double *r, double *y)
{
    const size_t block = 3 * (size_t)c->spec.body->plane->nnode * (size_t)ncol;
    const size_t part = (size_t)c->count * (size_t)ncol;
    const int one = 1, room = c->band + 1;
    int info = 0;
    memset(y, 0, (size_t)c->size * (size_t)ncol * sizeof *y);
    for (int level = c->spec.first; level < c->spec.last; level++) {
        coarse_restrict(c, level, ncol, r + (size_t)(level - c->spec.first) * block,
                        y + (size_t)level * part);
    }
    c->spec.door->sum((int)((size_t)c->size * (size_t)ncol), y);
    // every rank has the factors: columns are shared out
    for (int j = 0; j < ncol; j++) {
        const bool mine = j % c->spec.size == c->spec.rank;
        for (int i = 0; i < c->size; i++) {
            c->right[i] = mine ? y[(size_t)i * (size_t)ncol + (size_t)j] : 0;
        }
        if (mine) {
            dpbtrs_("U", &c->size, &c->band, &one, c->matrix, &room, c->right, &c->size, &info);
        }
        for (int i = 0; i < c->size; i++) {
            y[(size_t)i * (size_t)ncol + (size_t)j] = c->right[i];
        }
    }
    if (c->spec.size > 1) {
        c->spec.door->sum(c->size * ncol, y);
    }
}

void coarse_add(coarse *c, int ncol, const double *y, double *z)
{
    const size_t block = 3 * (size_t)c->spec.body->plane->nnode * (size_t)ncol;
    for (int level = c->spec.first; level < c->spec.last; level++) {
        coarse_prolong(c, level, ncol, y + (size_t)level * (size_t)c->count * (size_t)ncol,
                       z + (size_t)(level - c->spec.first) * block);
    }
}
