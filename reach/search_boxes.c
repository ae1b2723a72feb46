// reach/search_boxes.c
// Branch and bound over insertion, turn and the one bending joint, the box of most promise first.
#include "reach/search_inside.h"

#include "base/memory.h"
#include "reach/joint_boxes.h"

enum { MOST_PIECES = 4000 };

static const double pi = 3.14159265358979323846;

// Once the target is reached, so many looks more are spent on a pose with more room.
static const int looks_after = 30;
// Bounds alone rarely find a pose that just has room: after so many looks without one, poses are
// led to more room, which takes up to a few hundred looks each; again at this many times as many.
static const int looks_before_leading = 1500, looks_growth = 4;
// Boxes of most promise that poses are led from.
enum { LED = 6 };
// Of a box's motion, so finely its room is looked at.
static const double look_share = 0.125;

// how far the tip is from the target, without a solve
static double miss_of(cylinder_point c, vec3 bent, const double *q)
{
    const double rho = hypot(bent.a[0], bent.a[1]);
    const double gap = q[SCOPE_TURN] + atan2(bent.a[1], bent.a[0]) - c.angle;
    const double across = 2 * sqrt(rho * c.rho) * sin(gap / 2);
    return hypot(hypot(rho - c.rho, across), bent.a[2] + q[SCOPE_INSERTION] - c.z);
}

enum { HALVINGS = 12 };

// from the middle towards the pose of the same bend that is nearest to the target, until near
// enough if there is such a pose
static void towards(const search *s, cylinder_point c, vec3 bent, double *q)
{
    double end[SCOPE_JOINTS], from = 0, to = 1;
    const double least = inverse_on_line(s->inv->scope, c, bent, end);
    if (least > s->options->tolerance || miss_of(c, bent, q) <= s->options->tolerance) {
        return;
    }
    const double start[2] = {q[SCOPE_INSERTION], q[SCOPE_TURN]};
    for (int i = 0; i < HALVINGS; i++) {
        const double t = (from + to) / 2;
        for (int j = 0; j < 2; j++) {
            q[j] = start[j] + t * (end[j] - start[j]);
        }
        if (miss_of(c, bent, q) <= s->options->tolerance) {
            to = t;
        } else {
            from = t;
        }
    }
    for (int j = 0; j < 2; j++) {
        q[j] = start[j] + to * (end[j] - start[j]);
    }
}

// bounds the room in a box and keeps it where the tip may be near
static status consider(search *s, cylinder_point c, box_heap *h, joint_box *b)
{
    status st = OK;
    const bend_sweep *w = &s->inv->sweep;
    double part[BOX_JOINTS], tip_motion, room;
    inverse_pose pose = {{0}, 0};
    box_motions(w, b, part, &tip_motion);
    for (int j = 0; j < BOX_JOINTS; j++) {
        pose.q[j] = (b->low[j] + b->high[j]) / 2;
    }
    const bend_node m = bend_sweep_at(w, pose.q[SCOPE_BEND]);
    if (miss_of(c, m.tip, pose.q) > s->options->tolerance + tip_motion + w->error) {
        return OK;
    }
    const double middle[2] = {pose.q[0], pose.q[1]};
    towards(s, c, m.tip, pose.q);
    b->motion = box_motion(part);
    const double shift =
        hypot(pose.q[SCOPE_INSERTION] - middle[0], (pose.q[SCOPE_TURN] - middle[1]) * m.farthest);
    // less than this is as good as none
    const double useful = s->out->room >= 0 ? s->out->room : 0;
    clearance_wish wish = {look_share * b->motion, useful - b->motion - shift, b->s, 0};
    TRY(inverse_miss(s->state, s->target, &pose));
    TRY(search_look(s, &pose, &wish, &room));
    b->bound = fmin(b->bound, room + b->motion + shift);
    if (shift > b->motion) {
        // far from the box: its middle says more
        pose.q[SCOPE_INSERTION] = middle[0];
        pose.q[SCOPE_TURN] = middle[1];
        TRY(inverse_miss(s->state, s->target, &pose));
        wish.below = useful - b->motion;
        TRY(search_look(s, &pose, &wish, &room));
        b->bound = fmin(b->bound, room + b->motion);
    }
    b->s = wish.first;
    box_push(h, b);

done:
    return st;
}

// --- where the tip may be near

// the boxes of a piece of the bend: insertion and turn by the tip's ball around the target
static status piece(search *s, cylinder_point c, box_heap *h, double from, double to)
{
    status st = OK;
    const scope *sc = s->inv->scope;
    double limit[2];
    const bend_node m = bend_sweep_at(&s->inv->sweep, (from + to) / 2);
    const double way =
        bend_sweep_at(&s->inv->sweep, to).tip_moved - bend_sweep_at(&s->inv->sweep, from).tip_moved;
    const double ball = s->options->tolerance + way + s->inv->sweep.error;
    const double rho = hypot(m.tip.a[0], m.tip.a[1]), z = c.z - m.tip.a[2];
    joint_box b = {.bound = INFINITY};
    b.low[SCOPE_BEND] = from;
    b.high[SCOPE_BEND] = to;
    b.low[SCOPE_INSERTION] = fmax(z - ball, sc->low[SCOPE_INSERTION]);
    b.high[SCOPE_INSERTION] = fmin(z + ball, sc->high[SCOPE_INSERTION]);
    if (fabs(rho - c.rho) > ball || b.low[SCOPE_INSERTION] > b.high[SCOPE_INSERTION]) {
        return OK;
    }
    box_one_turn(sc, limit);
    const double half = c.rho > ball && rho > 0 ? asin(ball / c.rho) : pi;
    const double middle = c.angle - atan2(m.tip.a[1], m.tip.a[0]);
    const double first = middle + 2 * pi * floor((limit[0] - middle) / (2 * pi));
    for (double a = first; a - half <= limit[1]; a += 2 * pi) {
        joint_box part = b;
        part.low[SCOPE_TURN] = fmax(a - half, limit[0]);
        part.high[SCOPE_TURN] = fmin(a + half, limit[1]);
        if (part.low[SCOPE_TURN] <= part.high[SCOPE_TURN] && h->n < h->most) {
            TRY(consider(s, c, h, &part));
        }
    }

done:
    return st;
}

// the whole sweep, in pieces in which the tip moves by the tolerance at most
static status pieces(search *s, cylinder_point c, box_heap *h)
{
    status st = OK;
    const bend_sweep *w = &s->inv->sweep;
    for (int k = 0; k + 1 < w->nnode; k++) {
        const double from = w->node[k].u, width = w->node[k + 1].u - from;
        const double way = w->node[k + 1].tip_moved - w->node[k].tip_moved;
        const int n = (int)fmin(ceil(way / s->options->tolerance), MOST_PIECES) + 1;
        for (int i = 0; i < n; i++) {
            TRY(piece(s, c, h, from + width * i / n, from + width * (i + 1) / n));
        }
    }

done:
    return st;
}

// --- poses led to more room

// from the pose of a box that is nearest to the target
static status lead_box(search *s, const joint_box *b)
{
    status st = OK;
    inverse_pose pose = {{0}, 0};
    for (int j = 0; j < BOX_JOINTS; j++) {
        pose.q[j] = (b->low[j] + b->high[j]) / 2;
    }
    TRY(inverse_miss(s->state, s->target, &pose));
    if (pose.miss > s->options->tolerance) {
        TRY(inverse_fit(s->state, s->target, &pose));
    }
    TRY(pose.miss <= s->options->tolerance ? search_lead(s, pose) : OK);

done:
    return st;
}

// from the best pose so far and from the first boxes, until the target is reached
static status lead_some(search *s, const box_heap *h)
{
    status st = OK;
    TRY(isfinite(s->out->room) ? search_lead(s, s->out->pose) : OK);
    for (int i = 0; i < h->n && i < LED && s->out->room < 0; i++) {
        TRY(lead_box(s, &h->box[i]));
    }

done:
    return st;
}

// --- the search

static status divide(search *s, cylinder_point c, box_heap *h, const joint_box *b)
{
    status st = OK;
    joint_box half[2];
    box_halve(&s->inv->sweep, b, half);
    TRY(consider(s, c, h, &half[0]));
    TRY(consider(s, c, h, &half[1]));

done:
    return st;
}

// whether the box of most promise decides the answer
static bool decided(const search *s, const joint_box *top, int since_reached)
{
    const double best = s->out->room;
    if (s->out->looks >= s->options->most_looks || top->motion <= s->options->resolution) {
        return true;
    }
    return best >= 0 ? top->bound <= best + s->options->resolution || since_reached > looks_after
                     : top->bound < 0;
}

status search_boxes(search *s)
{
    status st = OK;
    const cylinder_point c = cylinder_of(s->state, s->target);
    // every look pushes one box at most
    box_heap h = {.most = 2 * s->options->most_looks + MOST_PIECES};
    int reached_at = s->out->room >= 0 ? s->out->looks : -1, lead_at = looks_before_leading;
    TRY(TAKE(h.box, (size_t)h.most + 2));
    TRY(pieces(s, c, &h));
    while (h.n > 0 && h.n < h.most &&
           !decided(s, &h.box[0], reached_at < 0 ? 0 : s->out->looks - reached_at)) {
        const joint_box b = box_pop(&h);
        TRY(divide(s, c, &h, &b));
        if (s->out->room < 0 && s->out->looks >= lead_at) {
            lead_at = looks_growth * s->out->looks;
            TRY(lead_some(s, &h));
        }
        reached_at = reached_at < 0 && s->out->room >= 0 ? s->out->looks : reached_at;
    }
    if (s->out->room < 0 && h.n > 0 && h.box[0].bound >= 0) {
        TRY(lead_some(s, &h)); // boxes as small as the resolution
    }
    s->out->bound = fmax(s->out->room, h.n > 0 ? h.box[0].bound : -INFINITY);

done:
    free(h.box);
    return st;
}
