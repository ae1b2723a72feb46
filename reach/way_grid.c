// reach/way_grid.c
// The widest way over a grid of insertion, turn and the share of the bend: Dijkstra's, with the
// least room on the way instead of its length. Poses are looked at when they are come to, legs when
// a way leads over them.
#include "reach/way_inside.h"

#include "base/memory.h"
#include "reach/joint_boxes.h"

#include <string.h>

enum { INSERTIONS = 40, INSERTIONS_TURNING = 20, BENDS = 16, MOST_TRIES = 40 };

typedef struct way_node {
    way_pose pose;
    double width; // the least room on the widest way to it
    int from;     // the node before; -1: none
    bool looked, done;
    bool shut[3]; // the legs to the next along each dimension touch
} way_node;

typedef struct way_grid {
    int n[3], stride[3], nnode; // insertion, turn, share
    double *value[3];
    way_node *node;
    int goal;
} way_grid;

static void free_grid(way_grid *g)
{
    for (int d = 0; d < 3; d++) {
        free(g->value[d]);
    }
    free(g->node);
}

// low, then those of goal + k step in the limits, ascending; *at: the goal's
static int fill_values(double low, double high, double goal, double step, double *value, int *at)
{
    int n = 0;
    const int before = step > 0 ? (int)fmin(floor((goal - low) / step), 1000) : 0;
    if (goal - before * step > low) {
        value[n++] = low;
    }
    *at = n + before;
    for (int k = -before; k == 0 || (step > 0 && goal + k * step <= high); k++) {
        value[n++] = goal + k * step;
    }
    return n;
}

static status make_grid(const way_search *w, int turns, way_grid *g)
{
    status st = OK;
    const scope *s = scope_of(w->state);
    int at[3] = {0};
    double turn[2];
    box_one_turn(s, turn);
    turn[0] = fmin(turn[0], w->goal[SCOPE_TURN]);
    turn[1] = fmax(turn[1], w->goal[SCOPE_TURN]);
    TRY(TAKE(g->value[0], INSERTIONS + 3));
    TRY(TAKE(g->value[1], (size_t)turns + 1003));
    TRY(TAKE(g->value[2], BENDS + 1));
    const double step = (s->high[0] - s->low[0]) / (turns > 1 ? INSERTIONS_TURNING : INSERTIONS);
    g->n[0] = fill_values(s->low[0], s->high[0], w->goal[0], step, g->value[0], &at[0]);
    g->n[1] = 1;
    g->value[1][0] = w->goal[SCOPE_TURN];
    if (turns > 1) {
        g->n[1] = fill_values(turn[0], turn[1], w->goal[1], (turn[1] - turn[0]) / turns,
                              g->value[1], &at[1]);
    }
    g->n[2] = BENDS + 1;
    at[2] = BENDS;
    g->nnode = 1;
    for (int d = 0; d < 3; d++) {
        g->stride[d] = g->nnode;
        g->nnode *= g->n[d];
        g->goal += at[d] * g->stride[d];
    }
    TRY(TAKE(g->node, (size_t)g->nnode));
    for (int i = 0; i < g->nnode; i++) {
        const int turn_at = i / g->stride[1] % g->n[1];
        g->node[i].pose = (way_pose){.insertion = g->value[0][i % g->n[0]],
                                     .turn = g->value[1][turn_at],
                                     .share = (double)(i / g->stride[2]) / BENDS};
    }

done:
    return st;
}

static status look_at(way_search *w, way_node *n)
{
    status st = OK;
    if (!n->looked) {
        TRY(way_look(w, &n->pose));
        n->looked = true;
    }

done:
    return st;
}

// the widest of those that are not done; -1: none
static int widest(const way_grid *g)
{
    int best = -1;
    for (int i = 0; i < g->nnode; i++) {
        const way_node *n = &g->node[i];
        if (!n->done && n->width > -INFINITY && (best < 0 || n->width > g->node[best].width)) {
            best = i;
        }
    }
    return best;
}

static status go_on(way_search *w, way_grid *g, int i)
{
    status st = OK;
    for (int k = 0; k < 6; k++) {
        const int d = k / 2, at = i / g->stride[d] % g->n[d];
        const int j = k % 2 ? i + g->stride[d] : i - g->stride[d];
        if (k % 2 ? at + 1 == g->n[d] : at == 0) {
            continue;
        }
        way_node *next = &g->node[j];
        if (next->done || g->node[k % 2 ? i : j].shut[d]) {
            continue;
        }
        TRY(look_at(w, next));
        const double width = fmin(g->node[i].width, next->pose.room);
        if (width > next->width) {
            next->width = width;
            next->from = i;
        }
    }

done:
    return st;
}

// the widest way to the goal
static status find_widest(way_search *w, way_grid *g)
{
    status st = OK;
    for (int i = 0; i < g->nnode; i++) {
        g->node[i].width = -INFINITY;
        g->node[i].from = -1;
        g->node[i].done = false;
    }
    // outside any turn is as good
    for (int t = 0; t < g->n[1]; t++) {
        way_node *start = &g->node[t * g->stride[1]];
        TRY(look_at(w, start));
        start->width = start->pose.room;
    }
    for (int i = widest(g); i >= 0 && w->out->looks < w->most_looks; i = widest(g)) {
        g->node[i].done = true;
        if (i == g->goal) {
            break;
        }
        TRY(go_on(w, g, i));
    }

done:
    return st;
}

// the dimension in which two neighbours differ
static int across(const way_grid *g, int i, int j)
{
    int d = 0;
    while (i / g->stride[d] % g->n[d] == j / g->stride[d] % g->n[d]) {
        d++;
    }
    return d;
}

// looks at the legs of the way to the goal; shuts those that touch
static status walk_back(way_search *w, way_grid *g, bool *free, double *room)
{
    status st = OK;
    *free = true;
    *room = g->node[g->goal].pose.room;
    for (int i = g->goal; g->node[i].from >= 0; i = g->node[i].from) {
        double bound;
        bool leg_free;
        const int from = g->node[i].from, first = from < i ? from : i;
        TRY(way_between(w, &g->node[from].pose, &g->node[i].pose, &leg_free, &bound));
        g->node[first].shut[across(g, from, i)] = !leg_free;
        *room = fmin(*room, bound);
        *free = *free && leg_free;
    }

done:
    return st;
}

static void tell_way(way_search *w, const way_grid *g, double room)
{
    int n = 0;
    for (int i = g->goal; i >= 0; i = g->node[i].from) {
        n++;
    }
    w->out->found = n <= WAY_POSES;
    w->out->npose = w->out->found ? n : 0;
    w->out->room = room;
    for (int i = g->goal; i >= 0 && w->out->found; i = g->node[i].from) {
        way_joints(w, &g->node[i].pose, w->out->q[--n]);
    }
}

status way_over_grid(way_search *w, int turns)
{
    status st = OK;
    way_grid g = {.goal = 0};
    TRY(make_grid(w, turns, &g));
    for (int k = 0; k < MOST_TRIES && !w->out->found && w->out->looks < w->most_looks; k++) {
        bool free;
        double room;
        TRY(find_widest(w, &g));
        const double width = g.node[g.goal].done ? g.node[g.goal].width : -INFINITY;
        w->out->room = k == 0 ? fmax(w->out->room, width) : w->out->room;
        if (!(width >= w->least)) {
            break;
        }
        TRY(walk_back(w, &g, &free, &room));
        if (free) {
            tell_way(w, &g, room);
        }
    }

done:
    free_grid(&g);
    return st;
}
