// fem/unknowns_hold.c
// Which directions of which nodes are held: by a base free to contract, and by the case's holds.
#include "fem/unknowns.h"

#include "base/memory.h"

#include <math.h>

static int farthest_node(const unknowns *u, int from)
{
    int far = from;
    double most = -1, x[3], y[3];
    body_node(u->body, from, 0, x);
    for (int i = 0; i < u->nplane; i++) {
        body_node(u->body, i, 0, y);
        const double d = hypot(y[0] - x[0], y[1] - x[1]);
        if (unknowns_block(u, i, 0) >= 0 && d > most) {
            most = d;
            far = i;
        }
    }
    return far;
}

// u_z on the whole base, and three pins against the rigid motions in the plane; they carry nothing,
// since the base's own traction balances the load. (5.8)
static void hold_base(unknowns *u)
{
    int first = 0;
    double x[3], y[3];
    for (int i = u->nplane - 1; i >= 0; i--) {
        if (unknowns_block(u, i, 0) >= 0) {
            u->held[unknowns_index(u, i, 0)] = 1 << 2;
            first = i;
        }
    }
    const int a = farthest_node(u, first), b = farthest_node(u, a);
    body_node(u->body, a, 0, x);
    body_node(u->body, b, 0, y);
    u->held[unknowns_index(u, a, 0)] |= 1 | 1 << 1;
    u->held[unknowns_index(u, b, 0)] |= fabs(y[0] - x[0]) > fabs(y[1] - x[1]) ? 1 << 1 : 1;
}

static status take_held(unknowns *u)
{
    const size_t levels = (size_t)(u->share.to - u->share.from);
    return u->held ? OK : TAKE(u->held, levels * (size_t)u->nplane);
}

status unknowns_hold(const segment_problem *p, unknowns *u)
{
    status st = OK;
    if (p->base == BASE_FREE_TO_CONTRACT && u->share.from == 0) {
        TRY(take_held(u));
        hold_base(u);
    }

done:
    return st;
}
