// reach/scope_room.c
#include "reach/scope_room.h"

typedef struct scope_body {
    scope_state *state;
    pose base, entry;
    double free_entry, leave;
} scope_body;

static vec3 body_point(const void *context, double s)
{
    const scope_body *b = context;
    vec3 h = {{0, 0, s}};
    if (s > 0 && scope_bent_point(b->state, s, &h, NULL) != OK) {
        h.a[0] = NAN; // a point that is none has no room
    }
    return vec3_add(b->base.p, mat3_mul_vec(b->base.R, h));
}

// in the channel, from how far a point is from the line there
static double channel_room(const void *context, vec3 p)
{
    const scope_body *b = context;
    const vec3 x = mat3_tmul_vec(b->entry.R, vec3_sub(p, b->entry.p));
    const double beyond = fmax(x.a[2] - b->free_entry, 0);
    return b->leave + SCOPE_CHANNEL_PLAY - hypot(hypot(x.a[0], x.a[1]), beyond);
}

static void roughly(const scope_room *room, scope_state *state, const double *q,
                    const clearance_wish *wish, clearance *out)
{
    const scope_body body = {state, scope_base(state, q), scope_entry(state), room->free_entry,
                             room->leave};
    const double length = scope_of(state)->length;
    // the shaft is on the line, where the channel has room for it
    const double looked_at = fmax(room->free_entry, room->shaft_free);
    const body_curve curve = {.at = body_point,
                              .context = &body,
                              .begin = fmin(looked_at - q[SCOPE_INSERTION], 0),
                              .end = length,
                              .stretch = scope_stretch(state),
                              .anyway = channel_room};
    clearance_until(room->tree, &curve, scope_of(state)->radius, wish, out);
}

void scope_clearance(const scope_room *room, scope_state *state, const double *q, clearance *out)
{
    const clearance_wish all = {room->tolerance, -INFINITY, -INFINITY, 0};
    roughly(room, state, q, &all, out);
}

static double room_at(void *context, scope_state *state, const double *q, double *s)
{
    const scope_room *room = context;
    clearance c = {0};
    scope_clearance(room, state, q, &c);
    *s = c.s;
    return c.least - room->leave;
}

static double rough_room(void *context, scope_state *state, const double *q,
                         const clearance_wish *wish, double *s)
{
    const scope_room *room = context;
    clearance_wish w = *wish;
    clearance c = {0};
    w.below += room->leave;
    w.above += w.above > 0 ? room->leave : 0;
    roughly(room, state, q, &w, &c);
    *s = c.s;
    return c.least - room->leave;
}

room_probe scope_room_probe(scope_room *room)
{
    return (room_probe){.at = room_at, .context = room, .roughly = rough_room};
}
