// reach/bend_sweep.c
#include "reach/bend_sweep.h"

#include "base/memory.h"

enum { FIRST_CELLS = 8, DEEPEST = 9, MOST_NODES = (FIRST_CELLS << DEEPEST) + 1 };

// The cubic's error at a middle that is small enough, of the tip's length: far under what a target
// asks for; roots are found on the cubic and finished on the rod.
static const double cubic_error = 1e-6;
// Chords between nodes and between samples are shorter than the paths.
static const double path_margin = 1.03;

typedef struct sweep_node {
    bend_node node;
    vec3 body[SWEEP_SAMPLES];
} sweep_node;

typedef struct sweep_making {
    scope_state *state;
    int nnode;
    double error;
    sweep_node *node; // [MOST_NODES]
} sweep_making;

static status solve_node(scope_state *state, double u, sweep_node *out)
{
    status st = OK;
    const double length = scope_of(state)->length;
    const double q[SCOPE_BEND + 1] = {0, 0, u};
    out->node.u = u;
    TRY(scope_bend(state, q));
    TRY(scope_bent_tip(state, &out->node.tip, &out->node.slope));
    // between two samples
    out->node.farthest = 0;
    for (int i = 0; i < SWEEP_SAMPLES; i++) {
        TRY(scope_bent_point(state, length * (i + 1) / SWEEP_SAMPLES, &out->body[i], NULL));
        out->node.farthest = fmax(out->node.farthest, hypot(out->body[i].a[0], out->body[i].a[1]));
    }
    out->node.farthest += scope_stretch(state) * length / (2 * SWEEP_SAMPLES);

done:
    return st;
}

static vec3 cubic(const bend_node *a, const bend_node *b, double u)
{
    const double h = b->u - a->u, t = (u - a->u) / h, r = 1 - t;
    vec3 p = vec3_scale(r * r * (1 + 2 * t), a->tip);
    p = vec3_add_scaled(p, t * t * (1 + 2 * r), b->tip);
    p = vec3_add_scaled(p, h * t * r * r, a->slope);
    return vec3_add_scaled(p, -h * t * t * r, b->slope);
}

static vec3 cubic_slope(const bend_node *a, const bend_node *b, double u)
{
    const double h = b->u - a->u, t = (u - a->u) / h, r = 1 - t;
    vec3 p = vec3_scale(6 * t * r / h, vec3_sub(b->tip, a->tip));
    p = vec3_add_scaled(p, r * (1 - 3 * t), a->slope);
    return vec3_add_scaled(p, t * (1 - 3 * r), b->slope);
}

// the nodes between a and b, without them
static status refine(sweep_making *m, const sweep_node *a, const sweep_node *b, int depth)
{
    status st = OK;
    sweep_node middle;
    const double length = scope_of(m->state)->length;
    TRY(solve_node(m->state, (a->node.u + b->node.u) / 2, &middle));
    const vec3 guess = cubic(&a->node, &b->node, middle.node.u);
    const double error = vec3_norm(vec3_sub(guess, middle.node.tip));
    if (error <= cubic_error * length) {
        m->node[m->nnode++] = middle;
        m->error = fmax(m->error, error);
        return OK;
    }
    if (depth == DEEPEST - 1) {
        return status_fail(ERR_NUMERIC,
                           "scope %s: its tip jumps by %g mm near %g of its bending joint",
                           scope_of(m->state)->name, 1e3 * error, middle.node.u);
    }
    TRY(refine(m, a, &middle, depth + 1));
    m->node[m->nnode++] = middle;
    TRY(refine(m, &middle, b, depth + 1));

done:
    return st;
}

// how far points have moved from node to node
static void add_up(sweep_making *m)
{
    for (int k = 1; k < m->nnode; k++) {
        const sweep_node *a = &m->node[k - 1];
        sweep_node *b = &m->node[k];
        double most = 0, tip = 0;
        for (int i = 0; i < SWEEP_SAMPLES; i++) {
            tip = path_margin * vec3_norm(vec3_sub(b->body[i], a->body[i]));
            most = fmax(most, tip);
        }
        b->node.moved = a->node.moved + most;
        b->node.tip_moved = a->node.tip_moved + tip;
    }
}

status bend_sweep_make(scope_state *state, bend_sweep *out)
{
    status st = OK;
    sweep_making m = {.state = state};
    sweep_node last = {0}, next = {0};
    const double low = scope_of(state)->low[SCOPE_BEND], high = scope_of(state)->high[SCOPE_BEND];
    TRY(TAKE(m.node, MOST_NODES));
    TRY(solve_node(state, low, &last));
    m.node[m.nnode++] = last;
    for (int i = 1; i <= FIRST_CELLS; i++) {
        // a range of one value is two nodes there
        TRY(solve_node(state, i < FIRST_CELLS ? low + (high - low) * i / FIRST_CELLS : high,
                       &next));
        if (high > low) {
            TRY(refine(&m, &last, &next, 0));
        }
        m.node[m.nnode++] = next;
        last = next;
    }
    add_up(&m);
    TRY(TAKE(out->node, (size_t)m.nnode));
    for (int k = 0; k < m.nnode; k++) {
        out->node[k] = m.node[k].node;
    }
    out->nnode = m.nnode;
    out->error = m.error;

done:
    free(m.node);
    return st;
}

void bend_sweep_free(bend_sweep *w)
{
    free(w->node);
    *w = (bend_sweep){0};
}

int bend_sweep_cell(const bend_sweep *w, double u)
{
    int low = 0, high = w->nnode - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (w->node[middle].u <= u) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

bend_node bend_sweep_at(const bend_sweep *w, double u)
{
    const bend_node *a = &w->node[bend_sweep_cell(w, u)], *b = a + 1;
    const double h = b->u - a->u, t = h > 0 ? (u - a->u) / h : 0;
    if (!(h > 0)) {
        return *a;
    }
    bend_node n = {.u = u, .tip = cubic(a, b, u), .slope = cubic_slope(a, b, u)};
    n.farthest = fmax(a->farthest, b->farthest);
    n.moved = a->moved + t * (b->moved - a->moved);
    n.tip_moved = a->tip_moved + t * (b->tip_moved - a->tip_moved);
    return n;
}
