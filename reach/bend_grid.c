// reach/bend_grid.c
#include "reach/bend_grid.h"

#include "base/memory.h"

#include <string.h>

// nodes along each of n joints: about 1,000 to 6,000 in all
static const int nodes_along[SCOPE_TENDONS + 1] = {0, 0, 33, 13, 7, 5, 4, 3, 3};

// Between nodes the tip leaves the plane through them by h^2/8 of the second derivatives, which are
// differenced from the slopes at the nodes: their largest is taken this many times.
static const double curvature_margin = 2;

typedef struct grid_node {
    vec3 tip, slope[SCOPE_TENDONS];
} grid_node;

typedef struct grid_making {
    scope_state *state;
    int n, m;                  // joints, nodes along each
    int stride[SCOPE_TENDONS]; // from node to node along each joint
    grid_node *node;
} grid_making;

static double joint_at(const scope *s, int joint, double share)
{
    const int j = SCOPE_BEND + joint;
    return s->low[j] + share * (s->high[j] - s->low[j]);
}

static status solve_nodes(grid_making *g, int nnode)
{
    status st = OK;
    const scope *s = scope_of(g->state);
    double q[SCOPE_JOINTS] = {0};
    for (int k = 0; k < nnode; k++) {
        for (int j = 0; j < g->n; j++) {
            q[SCOPE_BEND + j] = joint_at(s, j, (k / g->stride[j] % g->m) / (g->m - 1.0));
        }
        TRY(scope_bend(g->state, q));
        TRY(scope_bent_tip(g->state, &g->node[k].tip, g->node[k].slope));
    }

done:
    return st;
}

// how much the tip may be off the plane through the cell's corners, in each direction [m]
static vec3 bulge(const grid_making *g, int first)
{
    const scope *s = scope_of(g->state);
    vec3 sum = {{0, 0, 0}};
    for (int j = 0; j < g->n; j++) {
        const double h = joint_at(s, j, 1.0 / (g->m - 1)) - joint_at(s, j, 0);
        vec3 most = {{0, 0, 0}};
        for (int corner = 0; corner < 1 << g->n; corner++) {
            int k = first;
            for (int i = 0; i < g->n; i++) {
                k += corner >> i & 1 ? g->stride[i] : 0;
            }
            if (!(corner >> j & 1)) {
                const vec3 change =
                    vec3_sub(g->node[k + g->stride[j]].slope[j], g->node[k].slope[j]);
                for (int a = 0; a < 3; a++) {
                    most.a[a] = fmax(most.a[a], fabs(change.a[a]));
                }
            }
        }
        // h^2/8 of (change / h)
        sum = vec3_add_scaled(sum, curvature_margin * h / 8, most);
    }
    return sum;
}

// where the cell's tips are: by a circle about the corners for the distance from the line, so that
// the line itself is no exception
static void fill_cell(const grid_making *g, int first, grid_cell *cell)
{
    const int ncorner = 1 << g->n;
    const vec3 off = bulge(g, first);
    vec3 middle = {{0, 0, 0}};
    double radius = 0, least = INFINITY, most = 0;
    int k[1 << SCOPE_TENDONS];
    cell->z[0] = INFINITY;
    cell->z[1] = -INFINITY;
    for (int c = 0; c < ncorner; c++) {
        k[c] = first;
        for (int i = 0; i < g->n; i++) {
            k[c] += c >> i & 1 ? g->stride[i] : 0;
        }
        const vec3 p = g->node[k[c]].tip;
        middle = vec3_add_scaled(middle, 1.0 / ncorner, p);
        cell->z[0] = fmin(cell->z[0], p.a[2] - off.a[2]);
        cell->z[1] = fmax(cell->z[1], p.a[2] + off.a[2]);
        least = fmin(least, hypot(p.a[0], p.a[1]));
        most = fmax(most, hypot(p.a[0], p.a[1]));
    }
    for (int c = 0; c < ncorner; c++) {
        const vec3 p = g->node[k[c]].tip;
        radius = fmax(radius, hypot(p.a[0] - middle.a[0], p.a[1] - middle.a[1]));
    }
    const double bulging = hypot(off.a[0], off.a[1]), away = hypot(middle.a[0], middle.a[1]);
    // the distance is convex: largest at a corner of the plane
    cell->rho[0] = fmax(0, fmax(away - radius, least - 2 * radius) - bulging);
    cell->rho[1] = most + bulging;
}

static double spacing_of(const grid_making *g, int nnode)
{
    double most = 0;
    for (int k = 0; k < nnode; k++) {
        for (int j = 0; j < g->n; j++) {
            if (k / g->stride[j] % g->m + 1 < g->m) {
                const vec3 step = vec3_sub(g->node[k + g->stride[j]].tip, g->node[k].tip);
                most = fmax(most, vec3_norm(step));
            }
        }
    }
    return most;
}

static void fill_cells(const grid_making *g, int nnode, bend_grid *out)
{
    const scope *s = scope_of(g->state);
    for (int k = 0; k < nnode; k++) {
        bool inside = true;
        for (int j = 0; j < g->n; j++) {
            inside = inside && k / g->stride[j] % g->m + 1 < g->m;
        }
        if (inside) {
            grid_cell *cell = &out->cell[out->ncell++];
            fill_cell(g, k, cell);
            for (int j = 0; j < g->n; j++) {
                cell->middle[j] = joint_at(s, j, (k / g->stride[j] % g->m + 0.5) / (g->m - 1.0));
            }
        }
    }
}

status bend_grid_make(scope_state *state, bend_grid *out)
{
    status st = OK;
    const int n = scope_of(state)->njoint - SCOPE_BEND, m = nodes_along[n];
    grid_making g = {.state = state, .n = n, .m = m};
    int nnode = 1, ncell = 1;
    for (int j = 0; j < n; j++) {
        g.stride[j] = nnode;
        nnode *= m;
        ncell *= m - 1;
    }
    TRY(TAKE(g.node, (size_t)nnode));
    TRY(TAKE(out->cell, (size_t)ncell));
    TRY(solve_nodes(&g, nnode));
    out->nbend = n;
    out->per_joint = m;
    fill_cells(&g, nnode, out);
    out->spacing = spacing_of(&g, nnode);

done:
    free(g.node);
    return st;
}

void bend_grid_free(bend_grid *g)
{
    free(g->cell);
    *g = (bend_grid){0};
}
