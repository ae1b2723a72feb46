// tests/verify/fem/ring_mesh.h
// A ring with a stiff sector on a polar grid whose breaks come from ladders of ever smaller
// elements towards walls and interfaces; and the straight prism on it.
#pragma once

#include "base/memory.h"
#include "fem/way.h"
#include "tests/test.h"

#include <string.h>

static const double PI = 3.14159265358979323846;

enum { RING_MOST_BREAKS = 400 };

typedef struct ring {
    double outer, inner;  // [m]
    double middle, width; // of the sector of material 1 [rad]
    int soft, stiff;      // elements along the two arcs without ladders
    int radial;           // across the wall without ladders
    int order;
    int steps;     // of each ladder at the walls
    int arc_steps; // of ladders as long in metres at interfaces
    double shrink; // from one step to the next, below 1
    double first;  // of the element that a ladder divides, over the wall; at interfaces too
} ring;

// the prototype's section
static inline ring fig4_ring(int order)
{
    return (ring){.outer = 4e-3,
                  .inner = 3.2e-3,
                  .middle = PI,
                  .width = PI / 8,
                  .soft = 10,
                  .stiff = 2,
                  .radial = 1,
                  .order = order};
}

// from a to b in n equal pieces, the first and last of which are `edge` long and shrink towards the
// ends in `steps` steps
static inline int ladder_breaks(double a, double b, int n, int steps, double shrink, double edge,
                                double *at)
{
    int count = 0;
    for (int k = 0; k < steps; k++) {
        at[count++] = k == 0 ? a : a + edge * pow(shrink, steps - k);
    }
    if (steps == 0) {
        edge = 0;
    }
    for (int k = 0; k <= n; k++) {
        at[count++] = a + edge + (b - a - 2 * edge) * k / n;
    }
    for (int k = steps - 1; k >= 0; k--) {
        at[count++] = k == 0 ? b : b - edge * pow(shrink, steps - k);
    }
    if (steps == 0) {
        at[0] = a;
    }
    return count - 1;
}

static inline status ring_mesh(const ring *s, mesh *out)
{
    status st = OK;
    const int p = s->order;
    const double from = s->middle - s->width / 2, wall = s->outer - s->inner;
    const double edge = s->first * wall, arc = edge / s->inner;
    double radius[RING_MOST_BREAKS], angle[RING_MOST_BREAKS], node[ELEMENT_MAX_ORDER + 1];
    const int nr = ladder_breaks(s->inner, s->outer, s->radial, s->steps, s->shrink, edge, radius);
    const int stiff =
        ladder_breaks(from, from + s->width, s->stiff, s->arc_steps, s->shrink, arc, angle);
    const int na = stiff + ladder_breaks(from + s->width, from + 2 * PI, s->soft, s->arc_steps,
                                         s->shrink, arc, angle + stiff);
    const int around = na * p, across = nr * p + 1, nelem = na * nr;
    const shape quad = SHAPE_QUAD;
    gauss_lobatto_nodes(p + 1, node);
    TRY(mesh_make(p, around * across, 1, &quad, &nelem, out));
    for (int i = 0; i < around; i++) {
        const double a = angle[i / p], b = angle[i / p + 1];
        const double t = a + (b - a) * (node[i % p] + 1) / 2;
        for (int j = 0; j < across; j++) {
            const int k = j == across - 1 ? nr - 1 : j / p;
            const double r = radius[k] + (radius[k + 1] - radius[k]) * (node[j - k * p] + 1) / 2;
            out->xyz[3 * (i * across + j)] = r * cos(t);
            out->xyz[3 * (i * across + j) + 1] = r * sin(t);
        }
    }
    for (int e = 0; e < nelem; e++) {
        out->block[0].material[e] = e / nr < stiff;
        for (int m = 0; m < (p + 1) * (p + 1); m++) {
            // the first reference coordinate runs outwards, the second around: counter-clockwise
            out->block[0].conn[e * (p + 1) * (p + 1) + m] =
                (e / nr * p + m / (p + 1)) % around * across + e % nr * p + m % (p + 1);
        }
    }

done:
    return st;
}

// a straight prism in equal layers, or one that turns
static inline status prism_body(const mesh *plane, const material *materials, int order, int layers,
                                double length, double turn_rate, body *out)
{
    status st = OK;
    double *layer = NULL;
    TRY(TAKE(layer, (size_t)layers + 1));
    for (int i = 0; i <= layers; i++) {
        layer[i] = length * i / layers;
    }
    const body_spec spec = {.plane = plane,
                            .materials = materials,
                            .order = order,
                            .nlayer = layers,
                            .layer = layer,
                            .turn_rate = turn_rate};
    TRY(body_make(&spec, out));

done:
    free(layer);
    return st;
}

static inline mat6 tip_compliance(const way_run *run)
{
    mat6 C = {0};
    for (int j = 0; j < 6; j++) {
        for (int i = 0; i < 6; i++) {
            C.a[i][j] = run->motion[(j + 1) * run->nlevel - 1].a[i];
        }
    }
    return C;
}
