// reach/clearance.c
// The room changes no faster than the point moves. So between s = a and b, where it is at least r_a
// and r_b, it is nowhere less than (r_a + r_b - stretch (b - a)) / 2: pieces that this bound does
// not settle are halved.                                                docs/theory.md (10.22)
#include "reach/clearance.h"

#include <math.h>

// a piece and one of its halves at each of the levels: 2^-64 of the curve is below rounding
enum { LEVELS = 64 };

// a place of the curve
typedef struct place {
    double s;
    double room;  // at least
    double reach; // the wall is within this
} place;

typedef struct piece {
    place a, b;
} piece;

typedef struct walk {
    const distance_tree *t;
    const body_curve *body;
    double radius, below;
    clearance *out;
} walk;

static void keep_least(walk *w, double room, double s, vec3 p, const nearest_point *wall)
{
    // a NaN is no room
    if (!(room >= w->out->least)) {
        w->out->least = room;
        w->out->s = s;
        w->out->point = p;
        w->out->wall = *wall;
    }
}

// whether what is known of the distance is enough
static bool settle(walk *w, place *at, vec3 p, double anyway, double settles, distance_range known)
{
    const double high = fmax(known.high - w->radius, anyway), least = w->out->least;
    at->room = fmax(known.low - w->radius, anyway);
    at->reach = fmin(at->reach, known.reach);
    if (high < w->below) {
        keep_least(w, high, at->s, p, &(nearest_point){known.high, p, -1});
        return true;
    }
    return at->room >= least && (at->room >= least + settles || high < least + settles);
}

// The room at s, where the wall is known to be within `reach`. Where what is known without a search
// is enough, there is none: it is not the least, and either settles pieces that reach as far as
// `settles` from it or does not even if the wall is as far away as it may be.
static place look(walk *w, double s, double reach, double settles)
{
    const vec3 p = w->body->at(w->body->context, s);
    const double anyway = w->body->anyway ? w->body->anyway(w->body->context, p) : -INFINITY;
    place out = {s, anyway, reach};
    bool enough = settle(w, &out, p, anyway, settles, distance_between(w->t, p));
    enough = enough || settle(w, &out, p, anyway, settles, distance_between_closely(w->t, p));
    if (!enough) {
        const nearest_point wall = distance_within(w->t, p, out.reach);
        out.room = fmax(wall.distance - w->radius, anyway);
        out.room = isnan(wall.distance) ? NAN : out.room;
        out.reach = fabs(wall.distance);
        w->out->queries++;
        keep_least(w, out.room, s, p, &wall);
    }
    return out;
}

static double piece_half(const walk *w, const piece *c)
{
    return 0.5 * w->body->stretch * (c->b.s - c->a.s);
}

static double piece_bound(const walk *w, const piece *c)
{
    return 0.5 * (c->a.room + c->b.room) - piece_half(w, c);
}

static void split(walk *w, const piece *c, piece half[2])
{
    const double middle = 0.5 * (c->a.s + c->b.s), way = piece_half(w, c);
    // wider by what rounding may add
    const double reach = (fmin(c->a.reach, c->b.reach) + way) * (1 + 1e-9) + 1e-12;
    const place m = look(w, middle, reach, way);
    half[0] = (piece){c->a, m};
    half[1] = (piece){m, c->b};
}

// two pieces about the place that is looked at first
static int whole_body(walk *w, double first, double above, piece out[2])
{
    const double begin = w->body->begin, end = w->body->end;
    *w->out = (clearance){.least = above, .bound = above, .s = first};
    first = first > begin && first < end ? first : begin;
    const place middle = look(w, first, INFINITY, 0), last = look(w, end, INFINITY, 0);
    out[0] = (piece){middle, last};
    if (first > begin) {
        out[1] = (piece){look(w, begin, INFINITY, 0), middle};
    }
    return first > begin ? 2 : 1;
}

void clearance_until(const distance_tree *t, const body_curve *body, double radius,
                     const clearance_wish *wish, clearance *out)
{
    walk w = {.t = t, .body = body, .radius = radius, .below = wish->below, .out = out};
    piece todo[LEVELS + 2];
    int n = whole_body(&w, wish->first, wish->above > 0 ? wish->above : INFINITY, todo);
    while (n > 0 && out->least >= wish->below) {
        const piece c = todo[--n];
        const double bound = piece_bound(&w, &c);
        if (bound >= out->least - wish->tolerance || piece_half(&w, &c) <= wish->tolerance ||
            n + 2 > LEVELS) {
            out->bound = fmin(out->bound, bound);
            continue;
        }
        piece half[2];
        split(&w, &c, half);
        // the less promising half last: it may need no look by then
        const int first = piece_bound(&w, &half[0]) <= piece_bound(&w, &half[1]) ? 0 : 1;
        todo[n++] = half[1 - first];
        todo[n++] = half[first];
    }
    out->bound = n > 0 ? -INFINITY : fmin(out->bound, out->least);
}
