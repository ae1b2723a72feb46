#include "meshes/morph_kinds.h"

#include "base/memory.h"
#include "meshes/extension.h"
#include "meshes/morph_knots.h"

#include <math.h>
#include <string.h>

struct curve_morph {
    int nnode;
    double *xyz; // [nnode][3] at the base
    double size;
    shape_curves base;
    int nmark;
    node_mark *mark; // nodes on borders and interfaces
    extension inside;
};

void curve_morph_free(curve_morph *m)
{
    if (m) {
        free(m->xyz);
        free(m->mark);
        shape_curves_free(&m->base);
        extension_free(&m->inside);
        free(m);
    }
}

// --- triangles between neighbouring nodes of the elements' lattices

static void add_triangle(int (*out)[3], int *n, const int *conn, int a, int b, int c)
{
    const int t[3] = {conn[a], conn[b], conn[c]};
    memcpy(out[(*n)++], t, sizeof t);
}

static void split_triangle(const int *conn, int p, int (*out)[3], int *n)
{
    for (int j = 0, row = 0; j < p; row += p + 1 - j, j++) {
        for (int i = 0; i < p - j; i++) {
            const int at = row + i, up = at + p + 1 - j;
            add_triangle(out, n, conn, at, at + 1, up);
            if (i + 1 < p - j) {
                add_triangle(out, n, conn, at + 1, up + 1, up);
            }
        }
    }
}

static void split_quad(const int *conn, int p, int (*out)[3], int *n)
{
    for (int j = 0; j < p; j++) {
        for (int i = 0; i < p; i++) {
            const int at = j * (p + 1) + i, up = at + p + 1;
            add_triangle(out, n, conn, at, at + 1, up + 1);
            add_triangle(out, n, conn, at, up + 1, up);
        }
    }
}

static status split(const mesh *m, int (**out)[3], int *n)
{
    status st = OK;
    const mesh_block *b = &m->block[0];
    int(*t)[3] = NULL;
    TRY(TAKE(t,
             (b->shape == SHAPE_QUAD ? 2 : 1) * (size_t)b->nelem * (size_t)(m->order * m->order)));
    *n = 0;
    for (int e = 0; e < b->nelem; e++) {
        const int *conn = b->conn + (size_t)e * (size_t)b->per_elem;
        if (b->shape == SHAPE_QUAD) {
            split_quad(conn, m->order, t, n);
        } else {
            split_triangle(conn, m->order, t, n);
        }
    }
    *out = t;

done:
    return st;
}

status curve_morph_make(const section_outline *base, const mesh *plane, curve_morph **out)
{
    status st = OK;
    curve_morph *m = NULL;
    bool *given = NULL;
    int(*triangle)[3] = NULL, ntriangle = 0;
    if (plane->nblock != 1) {
        TRY(status_fail(ERR_BUG, "a mesh of outlines has one kind of elements"));
    }
    TRY(TAKE(m, 1));
    m->nnode = plane->nnode;
    m->size = base->size;
    TRY(TAKE(m->xyz, 3 * (size_t)plane->nnode));
    memcpy(m->xyz, plane->xyz, 3 * (size_t)plane->nnode * sizeof *m->xyz);
    TRY(shape_curves_make(base, 0, &m->base));
    TRY(node_marks_make(plane, &m->base, base->size, &m->mark, &m->nmark));
    TRY(TAKE(given, (size_t)plane->nnode));
    for (int i = 0; i < m->nmark; i++) {
        given[m->mark[i].node] = true;
    }
    TRY(split(plane, &triangle, &ntriangle));
    TRY(extension_make(plane->nnode, plane->xyz, ntriangle, triangle, given, &m->inside));
    *out = m;
    m = NULL;

done:
    free(given);
    curve_morph_free(m);
    return st;
}

// --- at s

static bool same_curves(const shape_curves *a, const shape_curves *b)
{
    bool same = a->ncurve == b->ncurve;
    for (int k = 0; k < a->ncurve && same; k++) {
        same = a->curve[k].n == b->curve[k].n && a->curve[k].shape == b->curve[k].shape;
    }
    return same;
}

// x -> A x + b
typedef struct affine {
    double A[2][2], b[2];
} affine;

static void affine_at(const affine *f, const double *x, double y[2])
{
    for (int c = 0; c < 2; c++) {
        y[c] = f->A[c][0] * x[0] + f->A[c][1] * x[1] + f->b[c];
    }
}

// the affine map that carries the marked nodes best to where they are now, in the mean square
static affine nearest_affine(const curve_morph *m, const double (*now)[2])
{
    double x[2] = {0}, y[2] = {0}, S[2][2] = {{0}}, T[2][2] = {{0}};
    affine f = {{{0}}, {0}};
    for (int i = 0; i < m->nmark; i++) {
        for (int c = 0; c < 2; c++) {
            x[c] += m->xyz[3 * (size_t)m->mark[i].node + (size_t)c] / m->nmark;
            y[c] += now[i][c] / m->nmark;
        }
    }
    for (int i = 0; i < m->nmark; i++) {
        const double *at = m->xyz + 3 * (size_t)m->mark[i].node;
        for (int c = 0; c < 4; c++) {
            S[c / 2][c % 2] += (at[c / 2] - x[c / 2]) * (at[c % 2] - x[c % 2]);
            T[c / 2][c % 2] += (now[i][c / 2] - y[c / 2]) * (at[c % 2] - x[c % 2]);
        }
    }
    const double det = S[0][0] * S[1][1] - S[0][1] * S[1][0];
    for (int c = 0; c < 2; c++) {
        f.A[c][0] = (T[c][0] * S[1][1] - T[c][1] * S[1][0]) / det;
        f.A[c][1] = (T[c][1] * S[0][0] - T[c][0] * S[0][1]) / det;
        f.b[c] = y[c] - f.A[c][0] * x[0] - f.A[c][1] * x[1];
    }
    return f;
}

// where the marked nodes are now
static void place_marks(const curve_morph *m, const shape_curves *now, const curve_knots *knots,
                        double (*x)[2])
{
    for (int i = 0; i < m->nmark; i++) {
        const int curve = m->mark[i].curve[0], n = now->curve[curve].n;
        shape_curve_point(now, curve, curve_knots_place(knots, curve, n, m->mark[i].place[0]),
                          x[i]);
    }
}

static double area_of(const int *n, const double *xyz)
{
    const double *a = xyz + 3 * (size_t)n[0], *b = xyz + 3 * (size_t)n[1],
                 *c = xyz + 3 * (size_t)n[2];
    return ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
}

// largest |ln| of a triangle's change of area over that of all of them
static double strain_of(const curve_morph *m, const double *xyz)
{
    double all[2] = {0, 0}, strain = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (int t = 0; t < m->inside.ntriangle; t++) {
            const double was = area_of(m->inside.triangle[t], m->xyz);
            const double is = area_of(m->inside.triangle[t], xyz);
            if (!(is > 0)) {
                return INFINITY;
            }
            if (pass == 0) {
                all[0] += was;
                all[1] += is;
            } else {
                strain = fmax(strain, fabs(log(is / was * (all[0] / all[1]))));
            }
        }
    }
    return strain;
}

// the affine part of the marks' motion for all nodes, what is left of it spread over the inside
static status fill_inside(const curve_morph *m, const double (*now)[2], double *xyz)
{
    status st = OK;
    double(*d)[2] = NULL, *room = NULL;
    const affine f = nearest_affine(m, now);
    TRY(TAKE(d, (size_t)m->nnode));
    TRY(TAKE(room, (size_t)m->inside.nfree));
    for (int i = 0; i < m->nmark; i++) {
        double y[2];
        affine_at(&f, m->xyz + 3 * (size_t)m->mark[i].node, y);
        for (int c = 0; c < 2; c++) {
            d[m->mark[i].node][c] = now[i][c] - y[c];
        }
    }
    extension_fill(&m->inside, d, room);
    for (int i = 0; i < m->nnode; i++) {
        double *x = xyz + 3 * (size_t)i;
        affine_at(&f, m->xyz + 3 * (size_t)i, x);
        x[0] += d[i][0];
        x[1] += d[i][1];
        x[2] = 0;
    }

done:
    free(d);
    free(room);
    return st;
}

status curve_morph_nodes(const curve_morph *m, const section_outline *o, double turn, double *xyz,
                         bool *same, double *strain)
{
    status st = OK;
    shape_curves now = {0};
    curve_knots knots = {0};
    double(*x)[2] = NULL;
    TRY(shape_curves_make(o, turn, &now));
    *same = same_curves(&m->base, &now);
    if (*same) {
        TRY(curve_knots_make(&m->base, &now, m->mark, m->nmark, m->size, &knots, same));
    }
    if (*same) {
        TRY(TAKE(x, (size_t)m->nmark));
        place_marks(m, &now, &knots, x);
        TRY(fill_inside(m, (const double(*)[2])x, xyz));
        *strain = strain_of(m, xyz);
    }

done:
    free(x);
    shape_curves_free(&now);
    curve_knots_free(&knots);
    return st;
}
