// reach/scope_room.c
#include "reach/scope_room.h"

typedef struct scope_body {
    const scope_state *state;
    const double *q;
} scope_body;

static vec3 body_point(const void *context, double s)
{
    const scope_body *b = context;
    return scope_point(b->state, b->q, s);
}

void scope_clearance(const scope_room *room, scope_state *state, const double *q, clearance *out)
{
    const scope_body body = {state, q};
    const double length = scope_of(state)->length;
    const body_curve curve = {.at = body_point,
                              .context = &body,
                              .begin = fmin(room->free_entry - q[SCOPE_INSERTION], length),
                              .end = length,
                              .stretch = scope_stretch(state)};
    clearance_along(room->tree, &curve, scope_of(state)->radius, room->tolerance, out);
}

static double room_at(void *context, scope_state *state, const double *q, double *s)
{
    clearance c = {0};
    scope_clearance(context, state, q, &c);
    *s = c.s;
    return c.least;
}

room_probe scope_room_probe(scope_room *room)
{
    return (room_probe){.at = room_at, .context = room};
}
