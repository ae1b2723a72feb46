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

// to [part] = sum_k w_k from_k, parts of the two slopes in the plane and of the one along s
static void combine(size_t n, double w, const double *from, double *to)
{
    for (size_t i = 0; i < n; i++) {
        to[i] += w * from[i];
    }
}

static void to_points(const apply *a, double half, size_t part, double *const *flat)
{
    const int levels = a->body->order + 1;
    for (int t = 0; t < a->nl; t++) {
        double *to = a->solid + (size_t)t * 3 * part;
        memset(to, 0, 3 * part * sizeof *to);
        for (int k = 0; k < levels; k++) {
            combine(2 * part, a->L[t][k], flat[k], to);
            combine(part, a->dL[t][k] / half, flat[k] + 2 * part, to + 2 * part);
        }
    }
}

static void to_levels(const apply *a, double half, size_t part, double *const *flat)
{
    const int levels = a->body->order + 1;
    for (int t = 0; t < a->nl; t++) {
        const double *from = a->solid + (size_t)t * 3 * part;
        for (int k = 0; k < levels; k++) {
            combine(2 * part, a->L[t][k], from, flat[k]);
            combine(part, a->dL[t][k] / half, from + 2 * part, flat[k] + 2 * part);
        }
    }
}

// --- one column of elements

static void swap(double **p, double **q)
{
    double *const kept = *p;
    *p = *q;
    *q = kept;
}

// the upper level of one layer is the next one's lower level
static void stand(apply *a, const apply_element *e, int first, int last, int ncol, const double *u,
                  double *f)
{
    const body *b = a->body;
    const int p = b->order;
    const size_t block = 3 * (size_t)b->plane->nnode * (size_t)ncol;
    const size_t part = 3 * (size_t)e->np * (size_t)ncol;
    double *in[ELEMENT_MAX_ORDER + 1], *out[ELEMENT_MAX_ORDER + 1];
    for (int k = 0; k <= p; k++) {
        in[k] = a->flat + (size_t)k * 3 * part;
        out[k] = a->flat_to + (size_t)k * 3 * part;
    }
    slopes_of(a, e, ncol, u, in[0]);
    memset(out[0], 0, 3 * part * sizeof **out);
    for (int layer = first; layer < last; layer++) {
        const double half = (b->level[(layer + 1) * p] - b->level[layer * p]) / 2;
        const size_t at = (size_t)(layer - first) * (size_t)p * block;
        for (int k = 1; k <= p; k++) {
            slopes_of(a, e, ncol, u + at + (size_t)k * block, in[k]);
            memset(out[k], 0, 3 * part * sizeof **out);
        }
        to_points(a, half, part, in);
        apply_stresses(a, e, layer, ncol, a->solid);
        to_levels(a, half, part, out);
        for (int k = 0; k < p; k++) {
            forces_of(a, e, ncol, out[k], f + at + (size_t)k * block);
        }
        swap(&in[0], &in[p]);
        swap(&out[0], &out[p]);
    }
    forces_of(a, e, ncol, out[0], f + (size_t)(last - first) * (size_t)p * block);
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
