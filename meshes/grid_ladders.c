// meshes/grid_ladders.c
#include "meshes/grid_ladders.h"

#include "base/memory.h"
#include "meshes/sizing.h"

#include <math.h>
#include <stdlib.h>

// the thinnest interval of the grid, angles as arcs of the outer radius [m]
static double thinnest_part(const grid *g)
{
    double thinnest = INFINITY;
    for (int d = 0; d < 2; d++) {
        const double unit = g->polar && d == 1 ? g->at[0][g->n[0]] : 1;
        for (int i = 0; i < g->n[d]; i++) {
            // the hole of a ring is no part of it
            const bool hole = g->polar && d == 0 && g->at[0][i] == 0;
            thinnest = hole ? thinnest : fmin(thinnest, unit * (g->at[d][i + 1] - g->at[d][i]));
        }
    }
    return thinnest;
}

// The outermost layer at a corner over the thinnest part of the grid.
static const double LAST_LAYER = 0.25;

// finest: [n + 1] for either direction, lowered at the breaks that meet in corners [m]
static void find_corners(const section_outline *o, const grid *g, const mesh_options *options,
                         double *finest[2])
{
    const double part = thinnest_part(g), near = part / 100;
    for (int j = 0; j <= g->n[1]; j++) {
        for (int i = 0; i <= g->n[0]; i++) {
            double x[2];
            grid_point(g, g->at[0][i], g->at[1][j], x);
            const corner c = corner_at(o, x[0], x[1], near);
            const double length =
                c == CORNER_NONE ? 0 : LAST_LAYER * part * sizing_shrink(options, c);
            double *at[2] = {&finest[0][i], &finest[1][j]};
            for (int d = 0; d < 2 && c != CORNER_NONE; d++) {
                *at[d] = *at[d] > 0 ? fmin(*at[d], length) : length;
            }
        }
    }
}

// Fields change over a wall's thickness; long thin walls get no more elements than this for it.
static const double MOST_FOR_THICKNESS = 40;

static void limit_by_thickness(const grid *g, const mesh_options *options, double target[2])
{
    const double part = thinnest_part(g) / sizing_finer(options);
    for (int d = 0; d < 2; d++) {
        const double extent = g->at[d][g->n[d]] - g->at[d][0];
        target[d] = fmin(target[d], fmax(part, extent / MOST_FOR_THICKNESS));
    }
}

// whether any cell of that row of cells (d 0: one interval of the first coordinate) has a material
static bool row_is_used(const grid *g, int d, int i)
{
    for (int j = 0; j < g->n[1 - d]; j++) {
        if (g->owner[d == 0 ? j * g->n[0] + i : i * g->n[0] + j] >= 0) {
            return true;
        }
    }
    return false;
}

static int material_of(const section_outline *o, const grid *g, int d, int i, int j)
{
    if (i < 0 || i >= g->n[d]) {
        return -1;
    }
    const int owner = g->owner[d == 0 ? j * g->n[0] + i : i * g->n[0] + j];
    return owner < 0 ? -1 : o->items[owner].material;
}

typedef enum edge_kind { EDGE_NONE, EDGE_INTERFACE, EDGE_FREE } edge_kind;

// what materials do across a break: the strongest of it; angles close
static edge_kind break_kind(const section_outline *o, const grid *g, int d, int i)
{
    edge_kind kind = EDGE_NONE;
    const bool closes = g->polar && d == 1 && (i == 0 || i == g->n[1]);
    const int below = closes ? g->n[1] - 1 : i - 1, above = closes ? 0 : i;
    for (int j = 0; j < g->n[1 - d]; j++) {
        const int m = material_of(o, g, d, below, j), n = material_of(o, g, d, above, j);
        if (m != n) {
            kind = m < 0 || n < 0 ? EDGE_FREE : kind == EDGE_NONE ? EDGE_INTERFACE : kind;
        }
    }
    return kind;
}

// Shortest interval with material and a free edge at either side, angles as arcs of the outer
// radius [m].
static double thinnest_free(const section_outline *o, const grid *g, const double unit[2])
{
    double thinnest = INFINITY;
    for (int d = 0; d < 2; d++) {
        for (int i = 0; i < g->n[d]; i++) {
            const bool free_beside =
                break_kind(o, g, d, i) == EDGE_FREE || break_kind(o, g, d, i + 1) == EDGE_FREE;
            const double length = unit[d] * (g->at[d][i + 1] - g->at[d][i]);
            thinnest = free_beside && row_is_used(g, d, i) ? fmin(thinnest, length) : thinnest;
        }
    }
    return thinnest;
}

// length of the shorter of the intervals with material on either side of a break
static double room_beside(const grid *g, int d, int i)
{
    const int n = g->n[d];
    const bool closes = g->polar && d == 1;
    const int beside[2] = {closes ? (i + n - 1) % n : i - 1, closes ? i % n : i};
    double room = INFINITY;
    for (int k = 0; k < 2; k++) {
        const int c = beside[k];
        if (c >= 0 && c < n && row_is_used(g, d, c)) {
            room = fmin(room, g->at[d][c + 1] - g->at[d][c]);
        }
    }
    return room;
}

// Interfaces get one layer at least: it costs little, since there are few, and shear and torsion
// jump there all along the body. Its part of the narrower side, below the third that layers take.
static const double INTERFACE_PART = 0.3;

// finest: [n + 1] for either direction, in units of the grid's coordinates; 0 at breaks that no
// edge lies on
static void find_edges(const section_outline *o, const grid *g, const mesh_options *options,
                       const double unit[2], double *finest[2])
{
    const double first = sizing_edge_first(options, o->size, thinnest_free(o, g, unit));
    for (int d = 0; d < 2; d++) {
        for (int i = 0; i <= g->n[d]; i++) {
            const edge_kind kind = break_kind(o, g, d, i);
            const double most = INTERFACE_PART * room_beside(g, d, i);
            finest[d][i] = kind == EDGE_FREE        ? first / unit[d]
                           : kind == EDGE_INTERFACE ? fmin(SIZING_INTERFACE * first / unit[d], most)
                                                    : 0;
        }
    }
}

static status edge_ladders(const section_outline *o, const grid *g, const mesh_options *options,
                           double *finest[2], ladder l[2])
{
    status st = OK;
    const double outer = g->at[0][g->n[0]];
    const double unit[2] = {1, g->polar ? outer : 1};
    const double size = sizing_edge_length(options, o->size);
    const double arc = sizing_edge_angle(options);
    const double around = options->size > 0 ? fmin(size / outer, arc) : arc;
    const double target[2] = {size, g->polar ? around : size};
    find_edges(o, g, options, unit, finest);
    for (int d = 0; d < 2; d++) {
        const ladder_steps steps = {target[d], SIZING_GROWTH, SIZING_STRETCH};
        TRY(ladder_make(g->n[d], g->at[d], finest[d], &steps, &l[d]));
    }

done:
    return st;
}

static status corner_ladders(const section_outline *o, const grid *g, const mesh_options *options,
                             double *finest[2], ladder l[2])
{
    status st = OK;
    const double size = sizing_length(options, o->size), outer = g->at[0][g->n[0]];
    double target[2] = {size, size};
    if (!(options->size > 0)) {
        find_corners(o, g, options, finest);
        limit_by_thickness(g, options, target);
    }
    if (g->polar) {
        // along a ring the field is smooth away from corners: the arc alone decides
        target[1] =
            options->size > 0 ? fmin(size / outer, sizing_angle(options)) : sizing_angle(options);
        for (int j = 0; j <= g->n[1]; j++) {
            finest[1][j] /= outer;
        }
    }
    for (int d = 0; d < 2; d++) {
        const ladder_steps steps = {target[d], sizing_growth(options), 1};
        TRY(ladder_make(g->n[d], g->at[d], finest[d], &steps, &l[d]));
    }

done:
    return st;
}

status grid_ladders_make(const section_outline *o, const grid *g, const mesh_options *options,
                         ladder l[2])
{
    status st = OK;
    double *finest[2] = {NULL, NULL};
    for (int d = 0; d < 2; d++) {
        TRY(TAKE(finest[d], (size_t)g->n[d] + 1));
    }
    TRY((options->edge_layers > 0 ? edge_ladders : corner_ladders)(o, g, options, finest, l));
    if ((double)l[0].n * l[1].n > SECTION_MOST_ELEMENTS) {
        TRY(status_fail(ERR_INPUT, "mesh: its size asks for more than %d elements",
                        SECTION_MOST_ELEMENTS));
    }

done:
    free(finest[0]);
    free(finest[1]);
    return st;
}
