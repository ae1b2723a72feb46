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
// Curvatures that differ by less than this part of their sum are those of one curve, as elements of
// a low order have it; the same for jumps that turn an edge of an element's length by less [rad].
static const double same_curve = 0.3, same_turn = 0.02;
// of a side, between the points that tell its curvature
static const double short_way = 1e-4;

// What the elements around a node fill: angles, and the integral of the unit vectors over them,
// which tells half a turn in one piece from the same in two.
typedef struct wedge {
    double angle, x, y;
} wedge;

// The curvatures of its two sides are summed with opposite signs: what is left of a material around
// a node belongs to the edges that bound it, as their vectors' difference and their sum.
typedef struct bend {
    double difference[2], sum; // [1/m]
    double length;             // of the longest side [m]
} bend;

typedef struct around {
    wedge all, first; // first: of the first material met
    bend edge;        // of it
    int material, second;
    int count; // of materials, up to 3
} around;

// one element's corner
typedef struct corner_sides {
    double unit[2][2]; // directions of the two sides that leave it, counter-clockwise
    double curvature[2], length[2];
} corner_sides;

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

static void bend_add(bend *b, const corner_sides *c)
{
    for (int i = 0; i < 2; i++) {
        const double sign = i == 0 ? 1 : -1, k = c->curvature[i];
        b->difference[0] -= sign * k * c->unit[i][1];
        b->difference[1] += sign * k * c->unit[i][0];
        b->sum += sign * k;
        b->length = fmax(b->length, c->length[i]);
    }
}

static bool is_bend(const bend *b)
{
    const double jump = hypot(b->difference[0], b->difference[1]);
    return jump > same_curve * fabs(b->sum) && jump * b->length > same_turn;
}

static void add(around *a, int material, const corner_sides *c)
{
    const double *u = c->unit[0], *v = c->unit[1];
    const double angle = fabs(atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]));
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
        bend_add(&a->edge, c);
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

// dx/dt of a side's parameter t at a point of the element
static void tangent(const mesh *m, const int *conn, int nnode, const double *dN, const double *side,
                    double t[2])
{
    t[0] = t[1] = 0;
    for (int i = 0; i < nnode; i++) {
        const double *x = m->xyz + 3 * (size_t)conn[i];
        const double d = dN[2 * i] * side[0] + dN[2 * i + 1] * side[1];
        t[0] += x[0] * d;
        t[1] += x[1] * d;
    }
}

// what an element's basis is at its corners, the same for all elements
typedef struct corner_basis {
    corner_place place;
    double at[2 * ELEMENT_MAX_PLANE_NODES], beyond[2][2 * ELEMENT_MAX_PLANE_NODES];
} corner_basis;

static int corner_bases(const element *e, corner_basis basis[4])
{
    corner_place place[4];
    double N[ELEMENT_MAX_PLANE_NODES];
    const int n = corner_places(e, place);
    for (int c = 0; c < n; c++) {
        basis[c].place = place[c];
        element_basis(e, place[c].at, N, basis[c].at);
        for (int s = 0; s < 2; s++) {
            const double x[2] = {place[c].at[0] + short_way * place[c].side[s][0],
                                 place[c].at[1] + short_way * place[c].side[s][1]};
            element_basis(e, x, N, basis[c].beyond[s]);
        }
    }
    return n;
}

static corner_sides sides_at(const mesh *m, const int *conn, const element *e,
                             const corner_basis *b)
{
    corner_sides c;
    // a quadrangle's sides are 2 long in its own coordinates
    const double whole = e->shape == SHAPE_QUAD ? 2 : 1;
    for (int s = 0; s < 2; s++) {
        double t[2], next[2];
        tangent(m, conn, e->nnode, b->at, b->place.side[s], t);
        tangent(m, conn, e->nnode, b->beyond[s], b->place.side[s], next);
        const double speed = hypot(t[0], t[1]);
        c.unit[s][0] = t[0] / speed;
        c.unit[s][1] = t[1] / speed;
        c.length[s] = whole * speed;
        c.curvature[s] = (t[0] * next[1] - t[1] * next[0]) / (short_way * speed * speed * speed);
    }
    return c;
}

// Elements of one material whose axes differ are two materials.
static int kind_at(const mesh *m, const mesh_block *b, const material *materials, int k)
{
    const int frame =
        b->frame && materials[b->material[k]].kind != MATERIAL_ISOTROPIC ? b->frame[k] : -1;
    return b->material[k] * (m->nframe + 1) + frame + 1;
}

static status add_block(const mesh *m, const mesh_block *b, const material *materials, around *node)
{
    status st = OK;
    element e = {0};
    corner_basis basis[4];
    TRY(element_make(b->shape, m->order, &e));
    const int ncorner = corner_bases(&e, basis);
    for (int k = 0; k < b->nelem; k++) {
        const int *conn = b->conn + (size_t)k * (size_t)b->per_elem;
        for (int c = 0; c < ncorner; c++) {
            const corner_sides sides = sides_at(m, conn, &e, &basis[c]);
            add(&node[conn[basis[c].place.node]], kind_at(m, b, materials, k), &sides);
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

// Where the first material fills half a turn and something ends, its edge goes on smoothly.
static bool bends_at(const around *a)
{
    return is_half(&a->first) && is_bend(&a->edge);
}

status corners_find(const mesh *m, const material *materials, bool turning, corners *out)
{
    status st = OK;
    around *node = NULL;
    // a pattern that turns couples what leaves no stress alone
    const bool alike = !turning && is_alike(m, materials);
    *out = (corners){.strongest = CORNER_NONE};
    TRY(TAKE(node, (size_t)m->nnode));
    for (int b = 0; b < m->nblock; b++) {
        TRY(add_block(m, &m->block[b], materials, node));
    }
    for (int i = 0; i < m->nnode; i++) {
        const corner c = kind_of(&node[i], alike);
        out->strongest = c > out->strongest ? c : out->strongest;
        out->bends = out->bends || bends_at(&node[i]);
    }

done:
    free(node);
    return st;
}
