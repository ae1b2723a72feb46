// reach/distance_grid.c
#include "reach/distance_grid.h"

#include "base/memory.h"

#include <math.h>
#include <stdatomic.h>

// Of a ventricle of 60 x 40 x 80 mm a node every millimetre; empty ones cost no memory that is
// touched.
enum { MOST_NODES = 200 * 1000 };

// Sums of a few numbers in double, of their size.
static const double rounding = 1e-14;

enum { EMPTY, BUSY, FILLED };

typedef struct grid_node {
    atomic_int state;
    double distance;
    vec3 wall; // the surface's point that is nearest to the node
} grid_node;

struct distance_grid {
    exact_distance *exact;
    const void *context;
    vec3 low;
    double step;
    int n[3]; // nodes
    grid_node *node;
};

// the largest number of nodes that is not too many
static void choose_step(const surface *s, distance_grid *g)
{
    double most = 0, nodes;
    for (int d = 0; d < 3; d++) {
        g->low.a[d] = s->low[d];
        most = fmax(most, s->high[d] - s->low[d]);
    }
    g->step = most / MOST_NODES;
    do {
        nodes = 1;
        g->step *= 1.05;
        for (int d = 0; d < 3; d++) {
            nodes *= ceil((s->high[d] - s->low[d]) / g->step) + 1;
        }
    } while (nodes > MOST_NODES);
    for (int d = 0; d < 3; d++) {
        g->n[d] = (int)ceil((s->high[d] - s->low[d]) / g->step) + 1;
    }
}

status distance_grid_make(const surface *s, exact_distance *exact, const void *context,
                          distance_grid **out)
{
    status st = OK;
    distance_grid *g = NULL;
    TRY(TAKE(g, 1));
    g->exact = exact;
    g->context = context;
    choose_step(s, g);
    TRY(TAKE(g->node, (size_t)g->n[0] * (size_t)g->n[1] * (size_t)g->n[2]));
    *out = g;
    g = NULL;

done:
    distance_grid_free(g);
    return st;
}

void distance_grid_free(distance_grid *g)
{
    if (g) {
        free(g->node);
        free(g);
    }
}

// what the node holds, from here on
static void node_at(const distance_grid *g, grid_node *node, vec3 place, double *distance,
                    vec3 *wall)
{
    int empty = EMPTY;
    if (atomic_load_explicit(&node->state, memory_order_acquire) != FILLED) {
        const nearest_point found = g->exact(g->context, place);
        *distance = found.distance;
        *wall = found.p;
        if (atomic_compare_exchange_strong(&node->state, &empty, BUSY)) {
            node->distance = found.distance;
            node->wall = found.p;
            atomic_store_explicit(&node->state, FILLED, memory_order_release);
        }
        return;
    }
    *distance = node->distance;
    *wall = node->wall;
}

static const distance_range unknown = {-INFINITY, INFINITY, INFINITY};

// narrows the range by what a node says
static void ask_node(const distance_grid *g, const int i[3], vec3 p, distance_range *range)
{
    const int index = (i[2] * g->n[1] + i[1]) * g->n[0] + i[0];
    vec3 place, wall;
    double distance;
    for (int d = 0; d < 3; d++) {
        place.a[d] = g->low.a[d] + i[d] * g->step;
    }
    node_at(g, &g->node[index], place, &distance, &wall);
    const double way = vec3_norm(vec3_sub(p, place));
    const double slip = rounding * (fabs(distance) + way + vec3_norm(p));
    range->reach = fmin(range->reach, vec3_norm(vec3_sub(p, wall)) + slip);
    range->low = fmax(range->low, fmax(distance - way - slip, -range->reach));
    range->high = fmin(range->high, fmin(distance + way + slip, range->reach));
}

distance_range distance_grid_nearest(distance_grid *g, vec3 p)
{
    distance_range range = unknown;
    int i[3];
    for (int d = 0; d < 3; d++) {
        const double x = floor((p.a[d] - g->low.a[d]) / g->step + 0.5);
        if (!(x >= 0 && x < g->n[d])) {
            return unknown;
        }
        i[d] = (int)x;
    }
    ask_node(g, i, p, &range);
    return range;
}

distance_range distance_grid_eight(distance_grid *g, vec3 p)
{
    distance_range range = unknown;
    int low[3];
    for (int d = 0; d < 3; d++) {
        const double x = floor((p.a[d] - g->low.a[d]) / g->step);
        if (!(x >= 0 && x + 1 < g->n[d])) {
            return unknown;
        }
        low[d] = (int)x;
    }
    for (int k = 0; k < 8; k++) {
        const int i[3] = {low[0] + (k & 1), low[1] + (k >> 1 & 1), low[2] + (k >> 2)};
        ask_node(g, i, p, &range);
    }
    return range;
}
