// fem/brick.c
#include "fem/brick.h"

#include "base/memory.h"
#include "base/triangle_rule.h"
#include "fem/brick_parts.h"

#include <string.h>

void brick_free(brick *w)
{
    if (!w) {
        return;
    }
    double *const owned[] = {
        w->weight,           w->slope,        w->xyz,  w->grad, w->dV, w->work, w->more, w->sum,

        w->projection.value, w->projection.P, w->grade};
    for (size_t i = 0; i < sizeof owned / sizeof *owned; i++) {
        free(owned[i]);
    }
    free(w->stiffness);
    for (int i = 0; i < BRICK_PLANES; i++) {
        free(w->flat[i].E);
    }
    free(w->place);
    free(w);
}

static size_t larger(size_t a, size_t b)
{
    return a > b ? a : b;
}

// room for the largest element of the body
static status take_room(brick *w)
{
    status st = OK;
    const body *b = w->body;
    size_t n2 = 0, np = 0;
    for (int k = 0; k < b->plane->nblock; k++) {
        n2 = larger(n2, (size_t)b->plane->block[k].per_elem);
        np = larger(np, (size_t)b->plane_table[k].npoint);
    }
    const size_t n = n2 * (size_t)(b->order + 1), nq = np * (size_t)b->line_table.npoint;
    TRY(TAKE(w->weight, nq));
    TRY(TAKE(w->slope, 3 * nq * n));
    TRY(TAKE(w->xyz, 3 * n));
    TRY(TAKE(w->grad, 3 * nq * n));
    TRY(TAKE(w->dV, nq));
    TRY(TAKE(w->place, nq));
    TRY(TAKE(w->grade, nq));
    TRY(TAKE(w->stiffness, nq));
    for (int i = 0; i < BRICK_PLANES; i++) {
        brick_plane *p = &w->flat[i];
        TRY(TAKE(p->E, 4 * 9 * n2 * n2));
        p->C = p->E + 9 * n2 * n2;
        p->Ct = p->C + 9 * n2 * n2;
        p->M = p->Ct + 9 * n2 * n2;
    }
    // work: slopes with their weights; more: slopes times a law, of the points of one height; sum:
    // pairs of directions and nodes
    TRY(TAKE(w->work, 3 * nq * n));
    TRY(TAKE(w->more, larger(3 * nq * n, BRICK_PAIRS * 3 * np * n)));
    TRY(TAKE(w->sum, 2 * 9 * n * n));
    if (b->spec.mixed) {
        TRY(TAKE(w->projection.value, nq * BRICK_MAX_PRESSURES));
        TRY(TAKE(w->projection.P, 3 * n * BRICK_MAX_PRESSURES));
    }

done:
    return st;
}

status brick_make(const body *b, brick **out)
{
    status st = OK;
    brick *w = NULL;
    TRY(TAKE(w, 1));
    w->body = b;
    w->block = -1;
    TRY(take_room(w));
    *out = w;
    w = NULL;

done:
    brick_free(w);
    return st;
}

status brick_stand_on(brick *w, int block, int e)
{
    status st = OK;
    const mesh_block *k = &w->body->plane->block[block];
    const bool same = block == w->block;
    w->block = block;
    w->e = e;
    w->conn = k->conn + (size_t)e * (size_t)k->per_elem;
    w->layer = -1;
    for (int i = 0; i < BRICK_PLANES; i++) {
        w->flat[i].material = -1;
    }
    if (!same) {
        TRY(brick_tables(w));
    }

done:
    return st;
}

status brick_stiffness(brick *w, int layer, double *K)
{
    const int material = body_material(w->body, w->block, w->e, layer);
    if (material < 0) {
        memset(K, 0, 9 * (size_t)w->n * (size_t)w->n * sizeof *K);
        return OK;
    }
    const bool same_along_s = !material_varies(&w->body->spec.materials[material]);
    return w->body->prism && !w->body->spec.mixed && same_along_s
               ? brick_prism_stiffness(w, layer, material, K)
               : brick_full_stiffness(w, layer, material, K);
}

// A triangle's points are those of a rule for the squares of its strains
static int best_plane_points(const brick *w, double (*point)[3])
{
    double weight[ELEMENT_MAX_PLANE_NODES], x[ELEMENT_MAX_ORDER];
    const int p = w->body->plane->order;
    if (w->plane.shape == SHAPE_TRIANGLE) {
        return triangle_rule(2 * p - 2, point, weight);
    }
    gauss_legendre(p, x, weight);
    for (int i = 0; i < p * p; i++) {
        point[i][0] = x[i % p];
        point[i][1] = x[i / p];
    }
    return p * p;
}

int brick_best_points(const brick *w, double (*point)[3])
{
    double x[ELEMENT_MAX_ORDER], weight[ELEMENT_MAX_ORDER];
    const int count = best_plane_points(w, point), along = w->body->order;
    gauss_legendre(along, x, weight);
    for (int k = along - 1; k >= 0; k--) {
        for (int i = 0; i < count; i++) {
            memcpy(point[k * count + i], point[i], 2 * sizeof **point);
            point[k * count + i][2] = x[k];
        }
    }
    return count * along;
}
