// reach/reach_map.c
#include "reach/reach_map_inside.h"

#include "base/memory.h"

#include <string.h>

// boxes that wait, 70 bytes each
enum { MOST_BOXES = 1 << 21, LOOKS_PER_QUESTION = 1024 };

// Of a box's motion, so finely its room is looked at.
static const double look_share = 0.5;
reach_map_options reach_map_options_default(void)
{
    return (reach_map_options){
        .near = 1e-3,
        .resolution = 2.5e-4,  // of what is reached at all, few points hang on less
        .most_looks = 3000000, // less than a minute
    };
}

// --- marks

static bool mark_reached(void *context, int point)
{
    const mapping *m = context;
    m->out->state[point] = 1;
    if (m->out->q) {
        memcpy(m->out->q[point], m->q, sizeof *m->out->q);
    }
    return true;
}

static bool mark_maybe(void *context, int point)
{
    const mapping *m = context;
    m->maybe[point] = true;
    return false;
}

// --- boxes

static void pose_of(const mapping *m, const joint_box *b, double q[SCOPE_JOINTS])
{
    memset(q, 0, SCOPE_JOINTS * sizeof *q);
    for (int j = 0; j < BOX_JOINTS; j++) {
        q[j] = (b->low[j] + b->high[j]) / 2;
    }
    if (m->bend) {
        memcpy(q + SCOPE_BEND, m->bend, (size_t)(m->inv->scope->njoint - SCOPE_BEND) * sizeof *q);
    }
}

// the room at the box's middle: whether that pose has room, and whether any or all of the box has
static status look(mapping *m, joint_box *b, const double *q, bool *room_at_middle)
{
    status st = OK;
    *room_at_middle = b->free;
    if (!b->free) {
        // what is more than free is not asked for
        const double tolerance = look_share * b->motion;
        const clearance_wish wish = {tolerance, -b->motion, b->s, b->motion + tolerance};
        TRY(scope_bend(m->state, q));
        const double room = room_roughly(m->room, m->state, q, &wish, &b->s);
        m->out->looks++;
        b->bound = fmin(b->bound, room + b->motion);
        b->free = room - wish.tolerance >= b->motion;
        *room_at_middle = room >= wish.tolerance;
        if (room >= 0 && room < wish.tolerance) {
            double s;
            *room_at_middle = m->room->at(m->room->context, m->state, q, &s) >= 0;
        }
    }

done:
    return st;
}

static vec3 middle_tip(const mapping *m, const joint_box *b, const double *q)
{
    const vec3 bent = bend_sweep_at(m->sweep, (b->low[SCOPE_BEND] + b->high[SCOPE_BEND]) / 2).tip;
    const pose base = scope_base(m->state, q);
    return vec3_add(base.p, mat3_mul_vec(base.R, bent));
}

// what a box that is not divided may reach
static void cover(mapping *m, const joint_box *b)
{
    double part[BOX_JOINTS], motion, q[SCOPE_JOINTS];
    box_motions(m->sweep, b, part, &motion);
    pose_of(m, b, q);
    sample_grid_near(&m->samples, middle_tip(m, b, q), m->options->near + motion + m->sweep->error,
                     mark_maybe, m);
    m->out->spacing = fmax(m->out->spacing, 2 * motion);
}

// leaves a box out, marks what its middle reaches, or keeps it
static status consider(mapping *m, joint_box *b)
{
    status st = OK;
    double part[BOX_JOINTS], motion, q[SCOPE_JOINTS];
    bool room;
    box_motions(m->sweep, b, part, &motion);
    b->motion = box_motion(part);
    pose_of(m, b, q);
    const vec3 tip = middle_tip(m, b, q);
    if (!sample_grid_any(&m->samples, tip, m->options->near + motion + m->sweep->error)) {
        return OK;
    }
    TRY(look(m, b, q, &room));
    if (b->bound < 0) {
        return OK;
    }
    if (room) {
        m->q = q;
        sample_grid_near(&m->samples, tip, m->options->near - m->sweep->error, mark_reached, m);
    }
    if (b->motion <= m->resolution || m->heap.n == m->heap.most) {
        cover(m, b);
    } else {
        box_push(&m->heap, b);
    }

done:
    return st;
}

static status ask_to_stop(const mapping *m)
{
    const reach_map_options *o = m->options;
    if (o->stop && o->stop(o->context, fmin(1, (double)m->out->looks / o->most_looks))) {
        return status_fail(ERR_RESOURCE, "scope %s: the map was stopped", m->inv->scope->name);
    }
    return OK;
}

// the turn's limits are those of one turn, the bend's those of the sweep
static joint_box whole_box(const mapping *m)
{
    const scope *s = m->inv->scope;
    double turn[2];
    box_one_turn(s, turn);
    return (joint_box){
        .low = {s->low[SCOPE_INSERTION], turn[0], m->sweep->node[0].u},
        .high = {s->high[SCOPE_INSERTION], turn[1], m->sweep->node[m->sweep->nnode - 1].u},
        .bound = INFINITY,
        .s = -INFINITY};
}

status map_boxes(mapping *m)
{
    status st = OK;
    joint_box all = whole_box(m);
    m->heap.n = 0;
    TRY(consider(m, &all));
    for (int i = 0; m->heap.n > 0 && m->out->looks < m->options->most_looks; i++) {
        joint_box half[2];
        const joint_box b = box_pop(&m->heap);
        box_halve(m->sweep, &b, half);
        TRY(consider(m, &half[0]));
        TRY(consider(m, &half[1]));
        if (i % LOOKS_PER_QUESTION == 0) {
            TRY(ask_to_stop(m));
        }
    }
    // the looks ran out
    for (int i = 0; i < m->heap.n; i++) {
        cover(m, &m->heap.box[i]);
    }

done:
    return st;
}

// --- the map

static status check(const inverse *inv, const scope_state *state, const reach_map_options *o,
                    int npoint, const double (*point)[3])
{
    if (scope_of(state) != inv->scope) {
        return status_fail(ERR_BUG, "map: a state of another scope");
    }
    if (!(o->near > 0) || !(o->resolution > 0) || o->most_looks < 1 || npoint < 1) {
        return status_fail(ERR_INPUT, "map: %d points, within %g m, a resolution of %g m", npoint,
                           o->near, o->resolution);
    }
    for (int i = 0; i < 3 * npoint; i++) {
        if (!isfinite(point[i / 3][i % 3])) {
            return status_fail(ERR_INPUT, "map: point %d is none", i / 3 + 1);
        }
    }
    return OK;
}

status reach_map(const inverse *inv, scope_state *state, const room_probe *room, int npoint,
                 const double (*point)[3], const reach_map_options *options, reach_map_answer *out)
{
    status st = OK;
    mapping m = {.inv = inv,
                 .state = state,
                 .room = room,
                 .options = options,
                 .out = out,
                 .sweep = &inv->sweep,
                 .resolution = options->resolution,
                 .heap = {.most = MOST_BOXES}};
    TRY(check(inv, state, options, npoint, point));
    TRY(sample_grid_make(npoint, point, options->near, &m.samples));
    TRY(TAKE(m.maybe, (size_t)npoint));
    TRY(TAKE(m.heap.box, MOST_BOXES));
    memset(out->state, 0, (size_t)npoint * sizeof *out->state);
    out->spacing = out->looks = 0;
    TRY(inv->scope->njoint == BOX_JOINTS ? map_boxes(&m) : map_many(&m));
    for (int i = 0; i < npoint; i++) {
        out->state[i] = out->state[i] == 0 && m.maybe[i] ? 2 : out->state[i];
    }

done:
    free(m.heap.box);
    free(m.maybe);
    sample_grid_free(&m.samples);
    return st;
}
