// reach/way.c
#include "reach/way_inside.h"

#include <string.h>

enum { STRAIGHT_STEPS = 16, TURNS = 16 };

// Chords are shorter than the paths.
static const double path_margin = 1.03;

// --- poses

void way_joints(const way_search *w, const way_pose *p, double q[SCOPE_JOINTS])
{
    memset(q, 0, SCOPE_JOINTS * sizeof *q);
    q[SCOPE_INSERTION] = p->insertion;
    q[SCOPE_TURN] = p->turn;
    for (int j = SCOPE_BEND; j < scope_of(w->state)->njoint; j++) {
        // the ends to the last bit
        q[j] = p->share < 1 ? w->rest[j] + p->share * (w->goal[j] - w->rest[j]) : w->goal[j];
    }
}

status way_look(way_search *w, way_pose *p)
{
    status st = OK;
    double q[SCOPE_JOINTS], s;
    way_joints(w, p, q);
    TRY(scope_bend(w->state, q));
    p->room = w->room->at(w->room->context, w->state, q, &s);
    w->out->looks++;

done:
    return st;
}

// --- motions

static double at_share(const double *table, double share)
{
    const double x = share * WAY_SHARES;
    const int k = x < WAY_SHARES ? (int)x : WAY_SHARES - 1;
    return table[k] + (x - k) * (table[k + 1] - table[k]);
}

double way_motion(const way_search *w, const way_pose *a, const way_pose *b)
{
    const double bent = fabs(at_share(w->moved, b->share) - at_share(w->moved, a->share));
    const double far = fmax(at_share(w->farthest, a->share), at_share(w->farthest, b->share));
    return hypot(b->insertion - a->insertion, (far + bent) * (b->turn - a->turn)) + bent;
}

// the tip's way from no bend to all of it
static status fill_motions(way_search *w)
{
    status st = OK;
    const scope *s = scope_of(w->state);
    vec3 before[WAY_SAMPLES + 1], p;
    for (int k = 0; k <= WAY_SHARES; k++) {
        double q[SCOPE_JOINTS], most = 0;
        way_joints(w, &(way_pose){.share = (double)k / WAY_SHARES}, q);
        TRY(scope_bend(w->state, q));
        for (int i = 0; i <= WAY_SAMPLES; i++) {
            TRY(scope_bent_point(w->state, s->length * i / WAY_SAMPLES, &p, NULL));
            most = k > 0 ? fmax(most, vec3_norm(vec3_sub(p, before[i]))) : 0;
            w->farthest[k] = fmax(w->farthest[k], hypot(p.a[0], p.a[1]));
            before[i] = p;
        }
        w->farthest[k] += scope_stretch(w->state) * s->length / (2 * WAY_SAMPLES);
        w->moved[k] = k > 0 ? w->moved[k - 1] + path_margin * most : 0;
    }

done:
    return st;
}

// --- from pose to pose

enum { DEEPEST = 40 };

typedef struct leg {
    way_pose a, b;
} leg;

static way_pose between(const way_pose *a, const way_pose *b)
{
    return (way_pose){.insertion = (a->insertion + b->insertion) / 2,
                      .turn = (a->turn + b->turn) / 2,
                      .share = (a->share + b->share) / 2};
}

status way_between(way_search *w, const way_pose *a, const way_pose *b, bool *free, double *bound)
{
    status st = OK;
    leg todo[DEEPEST + 2] = {{*a, *b}};
    *free = a->room >= w->least && b->room >= w->least;
    *bound = INFINITY;
    for (int n = 1; n > 0 && *free;) {
        const leg l = todo[--n];
        const double motion = way_motion(w, &l.a, &l.b);
        const double here = (l.a.room + l.b.room - motion) / 2;
        if (here >= w->least || motion <= w->resolution) {
            *bound = fmin(*bound, here);
            continue;
        }
        way_pose middle = between(&l.a, &l.b);
        if (n + 2 > DEEPEST || w->out->looks >= w->most_looks) {
            *free = false;
            break;
        }
        TRY(way_look(w, &middle));
        *free = middle.room >= w->least;
        todo[n++] = (leg){middle, l.b};
        todo[n++] = (leg){l.a, middle};
    }

done:
    return st;
}

// --- straight in, then bent

static void tell_pose(way_search *w, const way_pose *p)
{
    way_joints(w, p, w->out->q[w->out->npose++]);
}

static status straight_in(way_search *w)
{
    status st = OK;
    const double low = scope_of(w->state)->low[SCOPE_INSERTION];
    way_pose last = {low, w->goal[SCOPE_TURN], 0, 0};
    bool free = true;
    TRY(way_look(w, &last));
    tell_pose(w, &last);
    w->out->room = last.room;
    for (int k = 1; k <= 2 * STRAIGHT_STEPS && free; k++) {
        const double in = fmin((double)k / STRAIGHT_STEPS, 1);
        const double share = fmax((double)k / STRAIGHT_STEPS - 1, 0);
        double bound;
        way_pose next = {low + in * (w->goal[SCOPE_INSERTION] - low), w->goal[SCOPE_TURN], share,
                         0};
        next.insertion = in < 1 ? next.insertion : w->goal[SCOPE_INSERTION];
        TRY(way_look(w, &next));
        TRY(way_between(w, &last, &next, &free, &bound));
        w->out->room = fmin(w->out->room, free ? bound : next.room);
        tell_pose(w, &next);
        last = next;
    }
    w->out->found = w->out->straight = free;
    w->out->npose = free ? w->out->npose : 0;

done:
    return st;
}

status way_find(scope_state *state, const room_probe *room, const double *q, double least,
                double resolution, int most_looks, way_answer *out)
{
    status st = OK;
    const scope *s = scope_of(state);
    way_search w = {.state = state,
                    .room = room,
                    .goal = q,
                    .least = least,
                    .resolution = resolution,
                    .most_looks = most_looks,
                    .out = out};
    out->found = out->straight = false;
    out->npose = out->looks = 0;
    if (!(resolution > 0) || !scope_within(s, q)) {
        return status_fail(ERR_INPUT,
                           "scope %s: a way to a pose beyond its limits, or of no "
                           "resolution (%g m)",
                           s->name, resolution);
    }
    for (int j = SCOPE_BEND; j < s->njoint; j++) {
        w.rest[j] = fmin(fmax(0, s->low[j]), s->high[j]);
    }
    TRY(fill_motions(&w));
    TRY(straight_in(&w));
    if (!out->found) {
        TRY(way_over_grid(&w, 1));
    }
    if (!out->found && s->high[SCOPE_TURN] > s->low[SCOPE_TURN]) {
        TRY(way_over_grid(&w, TURNS));
    }

done:
    return st;
}
