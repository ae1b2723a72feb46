// fem/apply.c
#include "fem/apply_parts.h"

#include "base/memory.h"

#include <string.h>

#include "fem/blas.h"

static status make_room(apply *a, int ncol)
{
    status st = OK;
    if (ncol <= a->room) {
        return OK;
    }
    double **const all[] = {&a->nodal, &a->flat, &a->flat_to, &a->solid};
    for (int i = 0; i < 4; i++) {
        free(*all[i]);
        *all[i] = NULL;
    }
    a->room = 0;
    const size_t width = 3 * (size_t)ncol, rows = 3 * (size_t)a->most_points;
    const size_t levels = (size_t)a->body->order + 1;
    TRY(TAKE(a->nodal, (size_t)a->most_nodes * width));
    TRY(TAKE(a->flat, levels * rows * width));
    TRY(TAKE(a->flat_to, levels * rows * width));
    TRY(TAKE(a->solid, (size_t)a->nl * rows * width));
    a->room = ncol;

done:
    return st;
}

// --- one level: nodes <-> slopes in the plane

static void gather(const apply *a, const apply_element *e, int ncol, const double *u, double *to)
{
    const size_t n = (size_t)ncol, direction = (size_t)a->body->plane->nnode * n;
    for (int k = 0; k < e->n2; k++) {
        const double *from = u + (size_t)e->conn[k] * n;
        for (int d = 0; d < 3; d++, from += direction, to += n) {
            for (size_t c = 0; c < n; c++) {
                to[c] = from[c];
            }
        }
    }
}

static void scatter(const apply *a, const apply_element *e, int ncol, const double *from, double *f)
{
    const size_t n = (size_t)ncol, direction = (size_t)a->body->plane->nnode * n;
    for (int k = 0; k < e->n2; k++) {
        double *to = f + (size_t)e->conn[k] * n;
        for (int d = 0; d < 3; d++, to += direction, from += n) {
            for (size_t c = 0; c < n; c++) {
                to[c] += from[c];
            }
        }
    }
}

// flat [3 np][3 ncol] = slopes [3 np][n2] nodal [n2][3 ncol]
static void slopes_of(const apply *a, const apply_element *e, int ncol, const double *u,
                      double *flat)
{
    const int width = 3 * ncol, rows = 3 * e->np;
    const double one = 1, none = 0;
    gather(a, e, ncol, u, a->nodal);
    dgemm_("N", "N", &width, &rows, &e->n2, &one, a->nodal, &width, e->slopes, &e->n2, &none, flat,
           &width);
}

static void forces_of(const apply *a, const apply_element *e, int ncol, const double *flat,
                      double *f)
{
    const int width = 3 * ncol, rows = 3 * e->np;
    const double one = 1, none = 0;
    dgemm_("N", "T", &width, &e->n2, &rows, &one, flat, &width, e->slopes, &e->n2, &none, a->nodal,
           &width);
    scatter(a, e, ncol, a->nodal, f);
}

// --- along one layer: levels <-> points

// The two slopes in the plane are interpolated, the third has the slope along s: solid [nl][3 part]
// from flat [levels][3 part], or with `back` flat_to from solid.
static void along(const apply *a, double half, size_t part, bool back)
{
    const int levels = a->body->order + 1, two = 2 * (int)part, one = (int)part,
              stride = 3 * (int)part, room = ELEMENT_MAX_ORDER + 1;
    const double unit = 1, none = 0, scale = 1 / half;
    const double *L = &a->L[0][0], *dL = &a->dL[0][0]; // by rows: points
    if (back) {
        dgemm_("N", "T", &two, &levels, &a->nl, &unit, a->solid, &stride, L, &room, &unit,
               a->flat_to, &stride);
        dgemm_("N", "T", &one, &levels, &a->nl, &scale, a->solid + two, &stride, dL, &room, &unit,
               a->flat_to + two, &stride);
    } else {
        dgemm_("N", "N", &two, &a->nl, &levels, &unit, a->flat, &stride, L, &room, &none, a->solid,
               &stride);
        dgemm_("N", "N", &one, &a->nl, &levels, &scale, a->flat + two, &stride, dL, &room, &none,
               a->solid + two, &stride);
    }
}

// --- one column of elements

// the upper level of one layer is the next one's lower level
static void stand(apply *a, const apply_element *e, int first, int last, int ncol, const double *u,
                  double *f)
{
    const body *b = a->body;
    const int p = b->order;
    const size_t block = 3 * (size_t)b->plane->nnode * (size_t)ncol;
    const size_t part = 3 * (size_t)e->np * (size_t)ncol, all = 3 * part;
    double *top = a->flat + (size_t)p * all, *top_to = a->flat_to + (size_t)p * all;
    slopes_of(a, e, ncol, u, top);
    memset(top_to, 0, all * sizeof *top_to);
    for (int layer = first; layer < last; layer++) {
        const double half = (b->level[(layer + 1) * p] - b->level[layer * p]) / 2;
        const size_t at = (size_t)(layer - first) * (size_t)p * block;
        memcpy(a->flat, top, all * sizeof *top);
        memcpy(a->flat_to, top_to, all * sizeof *top);
        memset(a->flat_to + all, 0, (size_t)p * all * sizeof *top);
        for (int k = 1; k <= p; k++) {
            slopes_of(a, e, ncol, u + at + (size_t)k * block, a->flat + (size_t)k * all);
        }
        along(a, half, part, false);
        apply_stresses(a, e, layer, ncol, a->solid);
        along(a, half, part, true);
        for (int k = 0; k < p; k++) {
            forces_of(a, e, ncol, a->flat_to + (size_t)k * all, f + at + (size_t)k * block);
        }
    }
    forces_of(a, e, ncol, top_to, f + (size_t)(last - first) * (size_t)p * block);
}

status apply_layers(apply *a, int first_layer, int last_layer, int ncol, const double *u, double *f)
{
    status st = OK;
    TRY(make_room(a, ncol));
    for (int e = 0; first_layer < last_layer && e < a->nelem; e++) {
        stand(a, &a->element[e], first_layer, last_layer, ncol, u, f);
    }

done:
    return st;
}

double apply_flops(const apply *a)
{
    double flops = 0;
    const double p = a->body->order, layers = a->last_layer - a->first_layer;
    for (int i = 0; i < a->nelem; i++) {
        const double n2 = a->element[i].n2, np = a->element[i].np, nl = a->nl;
        const double plane = 2 * 3 * np * n2 * 3 * p, line = 2 * 9 * np * (p + 1) * nl;
        const double law = a->element[i].Q ? 54 : 27;
        flops += layers * (2 * plane + 2 * line + nl * np * (law + (a->body->prism ? 0 : 54)));
    }
    return flops;
}
