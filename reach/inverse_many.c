// reach/inverse_many.c
// More than one bending joint: least squares from starts that the grid chooses.
#include "reach/inverse_inside.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_STARTS = 48 };

typedef struct start {
    double miss;   // of the cell's box from the target [m]
    double centre; // of its middle, for the order among those that may hold the target
    int cell;
} start;

static double outside(double x, const double range[2])
{
    return fmax(fmax(range[0] - x, x - range[1]), 0);
}

// how far the target is from where the cell's tips get
static start start_at(const inverse *inv, cylinder_point c, int cell)
{
    const scope *s = inv->scope;
    const grid_cell *g = &inv->grid.cell[cell];
    const double z[2] = {g->z[0] + s->low[SCOPE_INSERTION], g->z[1] + s->high[SCOPE_INSERTION]};
    const double across = c.rho - (g->rho[0] + g->rho[1]) / 2, along = (z[0] + z[1]) / 2 - c.z;
    const double room = (s->high[SCOPE_INSERTION] - s->low[SCOPE_INSERTION]) / 2;
    return (start){hypot(outside(c.rho, g->rho), outside(c.z, z)),
                   hypot(across, fmax(fabs(along) - room, 0)), cell};
}

// the nearest boxes first, and of equals the nearest middles
static bool before(const start *a, const start *b)
{
    return a->miss < b->miss || (a->miss == b->miss && a->centre < b->centre);
}

// the best of them, in order
static int choose(const inverse *inv, cylinder_point c, start best[MOST_STARTS])
{
    int n = 0;
    for (int k = 0; k < inv->grid.ncell; k++) {
        const start s = start_at(inv, c, k);
        if (n == MOST_STARTS && !before(&s, &best[n - 1])) {
            continue;
        }
        int at = n < MOST_STARTS ? n++ : n - 1;
        for (; at > 0 && before(&s, &best[at - 1]); at--) {
            best[at] = best[at - 1];
        }
        best[at] = s;
    }
    return n;
}

static status from_cell(const inverse *inv, scope_state *state, vec3 target, cylinder_point c,
                        int cell, inverse_answer *out)
{
    status st = OK;
    inverse_pose pose = {{0}, 0};
    vec3 bent;
    for (int j = 0; j < inv->grid.nbend; j++) {
        pose.q[SCOPE_BEND + j] = inv->grid.cell[cell].middle[j];
    }
    TRY(scope_bend(state, pose.q));
    TRY(scope_bent_tip(state, &bent, NULL));
    (void)inverse_on_line(inv->scope, c, bent, pose.q);
    TRY(inverse_fit(state, target, &pose));
    inverse_keep(inv->scope, &pose, out);
    out->starts++;

done:
    return st;
}

// Where no cell can hold the target, this many starts find a pose that is near.
enum { STARTS_OUTSIDE = 1 };

// cells that may hold the target, evenly over all that do, so that the poses are of the whole
// family
static status spread(const inverse *inv, scope_state *state, vec3 target, int want,
                     inverse_answer *out)
{
    status st = OK;
    const cylinder_point c = cylinder_of(state, target);
    int holding = 0, next = 0;
    for (int k = 0; k < inv->grid.ncell; k++) {
        holding += start_at(inv, c, k).miss == 0;
    }
    for (int k = 0, i = 0; k < inv->grid.ncell; k++) {
        if (start_at(inv, c, k).miss == 0 && i++ * want / holding >= next) {
            next++;
            TRY(from_cell(inv, state, target, c, k, out));
        }
    }

done:
    return st;
}

status inverse_many(const inverse *inv, scope_state *state, vec3 target, int want,
                    inverse_answer *out)
{
    status st = OK;
    const cylinder_point c = cylinder_of(state, target);
    start best[MOST_STARTS];
    TRY(spread(inv, state, target, want, out));
    const int n = choose(inv, c, best);
    for (int i = 0; i < n && out->npose == 0; i++) {
        if (best[i].miss > 0 && i >= STARTS_OUTSIDE) {
            break;
        }
        TRY(from_cell(inv, state, target, c, best[i].cell, out));
    }

done:
    return st;
}
