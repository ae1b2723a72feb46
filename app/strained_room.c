// app/strained_room.c
#include "app/strained_room.h"

#include <string.h>

// A material strained to twice its limit counts as much as a body in the tissue by the scope's
// length times this: about as far as the tip moves meanwhile.
static const double of_length = 0.5;

// a pose that is none
static const double no_pose = 1e3;

static double room_of(const strained_room *r, const scope_state *state, double room)
{
    return r->over > 0 ? fmin(room, 0) - of_length * scope_of(state)->length * r->over : room;
}

// the strains once for all poses of the same tensions; where there are none the pose is none
static void know_strains(strained_room *r, const scope_state *state, const double *q)
{
    const size_t bytes = (size_t)(scope_of(state)->njoint - SCOPE_BEND) * sizeof *q;
    if (r->known && memcmp(r->tension, q + SCOPE_BEND, bytes) == 0) {
        return;
    }
    double share;
    r->over = no_pose;
    if (reach_strain_share(r->strains, q, &share) == OK) {
        r->over = share - 1;
    } else {
        status_clear();
    }
    memcpy(r->tension, q + SCOPE_BEND, bytes);
    r->known = true;
}

static double room_at(void *context, scope_state *state, const double *q, double *s)
{
    strained_room *r = context;
    const room_probe plain = scope_room_probe(r->room);
    const double room = plain.at(plain.context, state, q, s);
    know_strains(r, state, q);
    return room_of(r, state, room);
}

static double rough_room(void *context, scope_state *state, const double *q,
                         const clearance_wish *wish, double *s)
{
    strained_room *r = context;
    const room_probe plain = scope_room_probe(r->room);
    const double room = room_roughly(&plain, state, q, wish, s);
    if (room <= wish->below) {
        return room; // the strains make it no more
    }
    know_strains(r, state, q);
    return room_of(r, state, room);
}

room_probe strained_room_probe(const reach_strain_probe *strains, scope_room *room,
                               strained_room *out)
{
    *out = (strained_room){.room = room, .strains = strains};
    return (room_probe){.at = room_at, .context = out, .roughly = rough_room};
}
