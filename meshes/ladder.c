// meshes/ladder.c
#include "meshes/ladder.h"

#include "base/memory.h"
#include "meshes/sizing.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

// layers from one break: no direction needs more, since growth from the finest length to all of a
// section takes fewer
enum { MOST_LAYERS = 24 };

void ladder_free(ladder *l)
{
    free(l->edge);
    free(l->cell);
    *l = (ladder){0};
}

// distances from a break at which layers end, none beyond `room`; *next is the length to go on with
static int layers(double finest, double target, double growth, double room, double *at,
                  double *next)
{
    int n = 0;
    double x = 0, step = finest > 0 ? finest : target;
    while (step < target && x + step < room && n < MOST_LAYERS) {
        x += step;
        at[n++] = x;
        step *= growth;
    }
    *next = step;
    return n;
}

typedef struct interval {
    double from, to;
    double low[MOST_LAYERS], high[MOST_LAYERS]; // distances from either end
    int nlow, nhigh;
    double nmiddle; // equal elements between the layers
} interval;

static interval plan(double from, double to, const double *finest, const ladder_steps *steps)
{
    const double target = steps->target, growth = steps->growth;
    interval v = {.from = from, .to = to};
    // layers leave a third to the middle
    const bool both = finest[0] > 0 && finest[1] > 0;
    const double room = (to - from) * (both ? 1.0 / 3 : 2.0 / 3);
    double next[2];
    v.nlow = layers(finest[0], target, growth, room, v.low, &next[0]);
    v.nhigh = layers(finest[1], target, growth, room, v.high, &next[1]);
    const double below = v.nlow ? v.low[v.nlow - 1] : 0, above = v.nhigh ? v.high[v.nhigh - 1] : 0;
    v.nmiddle = sizing_parts(to - from - below - above,
                             fmin(target, steps->stretch * fmin(next[0], next[1])));
    return v;
}

static void put(ladder *l, int cell, double edge)
{
    l->edge[l->n] = edge;
    l->cell[l->n++] = cell;
}

// the lower edges of an interval's elements
static void fill(const interval *v, int cell, ladder *l)
{
    const double low = v->from + (v->nlow ? v->low[v->nlow - 1] : 0);
    const double high = v->to - (v->nhigh ? v->high[v->nhigh - 1] : 0);
    for (int i = 0; i < v->nlow; i++) {
        put(l, cell, i == 0 ? v->from : v->from + v->low[i - 1]);
    }
    for (int i = 0; i < (int)v->nmiddle; i++) {
        put(l, cell, low + (high - low) * i / v->nmiddle);
    }
    for (int i = v->nhigh - 1; i >= 0; i--) {
        put(l, cell, v->to - v->high[i]);
    }
}

status ladder_make(int ncell, const double *at, const double *finest, const ladder_steps *steps,
                   ladder *out)
{
    status st = OK;
    ladder l = {0};
    double total = 0;

    for (int c = 0; c < ncell; c++) {
        const interval v = plan(at[c], at[c + 1], finest + c, steps);
        total += v.nlow + v.nmiddle + v.nhigh;
    }
    if (!(total <= SECTION_MOST_ELEMENTS)) {
        TRY(status_fail(ERR_INPUT, "mesh: its size asks for more than %d elements",
                        SECTION_MOST_ELEMENTS));
    }
    TRY(TAKE(l.edge, (size_t)total + 1));
    TRY(TAKE(l.cell, (size_t)total));
    for (int c = 0; c < ncell; c++) {
        const interval v = plan(at[c], at[c + 1], finest + c, steps);
        fill(&v, c, &l);
    }
    l.edge[l.n] = at[ncell];
    *out = l;
    l = (ladder){0};

done:
    ladder_free(&l);
    return st;
}
