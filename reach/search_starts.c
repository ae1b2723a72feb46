// reach/search_starts.c
// More than one bending joint: the family of poses at the target, each led to more room along what
// leaves the tip where it is.
#include "reach/search_inside.h"

#include <string.h>

enum { FAMILY = 16, ROUNDS = 40 };

// Of the joints' ranges: the first step along a direction, and the last.
static const double first_step = 0.1, last_step = 1e-3;

// a step along a direction and back to the target, or near it; whether it has more room
static status try_step(search *s, inverse_pose *pose, double *room, const double *direction,
                       double step, bool *better)
{
    status st = OK;
    const scope *sc = s->inv->scope;
    inverse_pose next = *pose;
    double there;
    for (int j = 0; j < sc->njoint; j++) {
        next.q[j] += step * direction[j];
    }
    scope_clip(sc, next.q);
    *better = false;
    TRY(inverse_miss(s->state, s->target, &next));
    if (next.miss > s->options->tolerance) {
        TRY(inverse_fit(s->state, s->target, &next));
    }
    if (next.miss > s->options->tolerance) {
        return OK;
    }
    clearance_wish more = {.below = *room, .tolerance = s->options->resolution};
    TRY(search_look(s, &next, &more, &there));
    if (there > *room) {
        *better = true;
        *room = there;
        *pose = next;
    }

done:
    return st;
}

// directions along the family, then every joint alone: the tip may be off by the tolerance
static status directions_at(search *s, const inverse_pose *pose, double (*direction)[SCOPE_JOINTS],
                            int *n)
{
    status st = OK;
    const scope *sc = s->inv->scope;
    double J[3 * SCOPE_JOINTS];
    vec3 tip;
    TRY(scope_bend(s->state, pose->q));
    TRY(scope_tip(s->state, pose->q, &tip, J));
    *n = inverse_null_space(sc, J, direction);
    for (int j = 0; j < sc->njoint; j++) {
        memset(direction[*n], 0, sizeof direction[*n]);
        direction[(*n)++][j] = sc->high[j] - sc->low[j];
    }

done:
    return st;
}

status search_lead(search *s, inverse_pose pose)
{
    status st = OK;
    double direction[2 * SCOPE_JOINTS][SCOPE_JOINTS], room, step = first_step;
    clearance_wish any = {.below = -INFINITY, .tolerance = s->options->resolution};
    TRY(search_look(s, &pose, &any, &room));
    for (int i = 0; i < ROUNDS && step > last_step && s->out->looks < s->options->most_looks; i++) {
        bool moved = false;
        int n;
        TRY(directions_at(s, &pose, direction, &n));
        for (int k = 0; k < 2 * n && !moved; k++) {
            TRY(try_step(s, &pose, &room, direction[k / 2], k % 2 ? -step : step, &moved));
        }
        step *= moved ? 1 : 0.5;
    }

done:
    return st;
}

status search_starts(search *s)
{
    status st = OK;
    inverse_answer family;
    TRY(inverse_family(s->inv, s->state, s->target, FAMILY, &family));
    s->out->starts += family.starts;
    if (family.npose == 0) {
        family.pose[family.npose++] = family.nearest;
    }
    // a pose that has room already is enough of an answer
    for (int i = 0; i < family.npose; i++) {
        double room;
        clearance_wish any = {.below = -INFINITY, .tolerance = s->options->resolution};
        TRY(search_look(s, &family.pose[i], &any, &room));
    }
    for (int i = 0; i < family.npose && s->out->room < 0; i++) {
        TRY(search_lead(s, family.pose[i]));
    }

done:
    return st;
}
