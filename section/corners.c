// section/corners.c
#include "section/corners.h"

#include "base/memory.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#define PI 3.14159265358979323846

// Angles at nodes of curved elements are those of their outlines to a part of this; edges that turn
// by less are smooth [rad].
static const double same_angle = 0.03;

// What the elements around a node fill: angles, and the integral of the unit vectors over them,
// which tells half a turn in one piece from the same in two.
typedef struct wedge {
    double angle, x, y;
} wedge;

typedef struct around {
    wedge all, first; // first: of the first material met
    int material, second;
    int count; // of materials, up to 3
} around;

static void wedge_add(wedge *w, double angle, const double *u, const double *v)
{
    w->angle += angle;
    // over the wedge from u to v: a turn of (v - u) by -pi / 2
    w->x += v[1] - u[1];
    w->y -= v[0] - u[0];
}

static bool is_half(const wedge *w)
{
    return fabs(w->angle - PI) < same_angle && hypot(w->x, w->y) > 2 * cos(2 * same_angle);
}

static void add(around *a, int material, double angle, const double *u, const double *v)
{
    if (a->count == 0) {
        a->count = 1;
        a->material = material;
    } else if (a->count == 1 && material != a->material) {
        a->count = 2;
        a->second = material;
    } else if (a->count == 2 && material != a->material && material != a->second) {
        a->count = 3;
    }
    wedge_add(&a->all, angle, u, v);
    if (material == a->material) {
        wedge_add(&a->first, angle, u, v);
    }
}

static corner kind_of(const around *a, bool alike)
{
    const bool inside = fabs(a->all.angle - 2 * PI) < same_angle;
    if (a->count == 0 || (inside && a->count == 1)) {
        return CORNER_NONE;
    }
    if (inside) {
        return a->count == 2 && is_half(&a->first) ? CORNER_NONE : CORNER_STRONG;
    }
    if (is_half(&a->all)) {
        const bool upright = fabs(a->first.angle - PI / 2) < same_angle;
        return a->count == 1                       ? CORNER_NONE
               : a->count == 2 && alike && upright ? CORNER_WEAK
                                                   : CORNER_STRONG;
    }
    return a->count == 1 && a->all.angle < PI ? CORNER_WEAK : CORNER_STRONG;
}

// --- an element's corners

// reference coordinates of a corner, and the directions of the sides that leave it,
// counter-clockwise
typedef struct corner_place {
    int node;
    double at[2], side[2][2];
} corner_place;

static int corner_places(const element *e, corner_place c[4])
{
    const int p = e->order, n = e->nnode;
    if (e->shape == SHAPE_TRIANGLE) {
        c[0] = (corner_place){0, {0, 0}, {{1, 0}, {0, 1}}};
        c[1] = (corner_place){p, {1, 0}, {{-1, 1}, {-1, 0}}};
        c[2] = (corner_place){n - 1, {0, 1}, {{0, -1}, {1, -1}}};
        return 3;
    }
    c[0] = (corner_place){0, {-1, -1}, {{1, 0}, {0, 1}}};
    c[1] = (corner_place){p, {1, -1}, {{0, 1}, {-1, 0}}};
    c[2] = (corner_place){n - 1, {1, 1}, {{-1, 0}, {0, -1}}};
    c[3] = (corner_place){n - 1 - p, {-1, 1}, {{0, -1}, {1, 0}}};
    return 4;
}

// unit tangents of the two sides at a corner
static void tangents(const mesh *m, const int *conn, int nnode, const double *dN,
                     const corner_place *c, double t[2][2])
{
    double J[2][2] = {{0}};
    for (int i = 0; i < nnode; i++) {
        const double *x = m->xyz + 3 * (size_t)conn[i];
        for (int d = 0; d < 2; d++) {
            J[d][0] += x[d] * dN[2 * i];
            J[d][1] += x[d] * dN[2 * i + 1];
        }
    }
    for (int s = 0; s < 2; s++) {
        const double x = J[0][0] * c->side[s][0] + J[0][1] * c->side[s][1];
        const double y = J[1][0] * c->side[s][0] + J[1][1] * c->side[s][1];
        const double length = hypot(x, y);
        t[s][0] = x / length;
        t[s][1] = y / length;
    }
}

// Elements of one material whose axes differ are two materials.
static int kind_at(const mesh_block *b, const material *materials, int k)
{
    const int frame =
        b->frame && materials[b->material[k]].kind != MATERIAL_ISOTROPIC ? b->frame[k] : -1;
    return frame < 0 ? b->material[k] : -1 - frame;
}

static status add_block(const mesh *m, const mesh_block *b, const material *materials, around *node)
{
    status st = OK;
    element e = {0};
    corner_place place[4];
    double N[ELEMENT_MAX_PLANE_NODES], dN[4][2 * ELEMENT_MAX_PLANE_NODES];
    TRY(element_make(b->shape, m->order, &e));
    const int ncorner = corner_places(&e, place);
    for (int c = 0; c < ncorner; c++) {
        element_basis(&e, place[c].at, N, dN[c]);
    }
    for (int k = 0; k < b->nelem; k++) {
        const int *conn = b->conn + (size_t)k * (size_t)b->per_elem;
        for (int c = 0; c < ncorner; c++) {
            double t[2][2];
            tangents(m, conn, e.nnode, dN[c], &place[c], t);
            const double angle = fabs(atan2(t[0][0] * t[1][1] - t[0][1] * t[1][0],
                                            t[0][0] * t[1][0] + t[0][1] * t[1][1]));
            add(&node[conn[place[c].node]], kind_at(b, materials, k), angle, t[0], t[1]);
        }
    }

done:
    return st;
}

// One Poisson's ratio and no directions: stretching and bending then leave the materials' common
// edge without stress of its own.
static bool is_alike(const mesh *m, const material *materials)
{
    const material *first = NULL;
    for (int b = 0; b < m->nblock; b++) {
        for (int k = 0; k < m->block[b].nelem; k++) {
            const material *one = &materials[m->block[b].material[k]];
            first = first ? first : one;
            if (one->kind != MATERIAL_ISOTROPIC || one->nu != first->nu) {
                return false;
            }
        }
    }
    return true;
}

status corners_strongest(const mesh *m, const material *materials, corner *out)
{
    status st = OK;
    around *node = NULL;
    const bool alike = is_alike(m, materials);
    *out = CORNER_NONE;
    TRY(TAKE(node, (size_t)m->nnode));
    for (int b = 0; b < m->nblock; b++) {
        TRY(add_block(m, &m->block[b], materials, node));
    }
    for (int i = 0; i < m->nnode && *out != CORNER_STRONG; i++) {
        const corner c = kind_of(&node[i], alike);
        *out = c > *out ? c : *out;
    }

done:
    free(node);
    return st;
}
