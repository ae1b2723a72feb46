// fem/unknowns_hold.c
// Which directions of which nodes are held: by a base free to contract, and by the case's holds.
#include "fem/unknowns.h"

#include "base/memory.h"
#include "fem/face.h"

#include <math.h>
#include <string.h>

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

// --- the case's holds

static status check_hold(const segment_problem *p, const face_hold *h)
{
    if (h->on.face == FACE_TIP && p->tip == TIP_RIGID) {
        return status_fail(ERR_INPUT, "segment: a hold on the tip, which is a rigid cap");
    }
    if (h->on.face == FACE_BASE && p->base != BASE_FREE) {
        return status_fail(ERR_INPUT, "segment: a hold on the base, which is held");
    }
    return OK;
}

// where two holds meet the later one says how the node moves
static void mark_held(unknowns *u, const face_hold *h, const bool *mark)
{
    for (int level = u->share.from; level < u->share.to; level++) {
        for (int i = 0; i < u->nplane; i++) {
            const size_t at = unknowns_index(u, i, level);
            if (!mark[at] || unknowns_block(u, i, level) < 0) {
                continue; // clamped, or the cap's
            }
            u->held[at] |= (unsigned char)(h->mask & 7);
            for (size_t d = 0; u->motion && d < 3; d++) {
                u->motion[3 * at + d] = h->mask >> d & 1 ? h->motion[d] : u->motion[3 * at + d];
            }
        }
    }
}

static bool any_moves(const segment_problem *p)
{
    bool any = false;
    for (int i = 0; i < p->nhold; i++) {
        const double *m = p->hold[i].motion;
        any = any || m[0] != 0 || m[1] != 0 || m[2] != 0;
    }
    return any;
}

static status hold_faces(const segment_problem *p, unknowns *u)
{
    status st = OK;
    bool *mark = NULL;
    const size_t all = (size_t)(u->share.to - u->share.from) * (size_t)u->nplane;
    TRY(take_held(u));
    TRY(TAKE(mark, all));
    if (any_moves(p)) {
        TRY(TAKE(u->motion, 3 * all));
    }
    for (int i = 0; i < p->nhold; i++) {
        TRY(check_hold(p, &p->hold[i]));
        memset(mark, 0, all * sizeof *mark);
        TRY(face_nodes(u->body, &p->hold[i].on, u->share.from, u->share.to, mark));
        mark_held(u, &p->hold[i], mark);
    }

done:
    free(mark);
    return st;
}

status unknowns_hold(const segment_problem *p, unknowns *u)
{
    status st = OK;
    if (p->base == BASE_FREE_TO_CONTRACT && p->nspring + p->nhold > 0) {
        // its own traction answers the loads: nothing else may
        TRY(status_fail(ERR_INPUT, "segment: springs and holds beside a base that is free to "
                                   "contract: the base is clamped or free for that"));
    }
    if (p->base == BASE_FREE_TO_CONTRACT && u->share.from == 0) {
        TRY(take_held(u));
        hold_base(u);
    }
    if (p->nhold > 0) {
        TRY(hold_faces(p, u));
    }

done:
    return st;
}
