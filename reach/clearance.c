// reach/clearance.c
// The signed distance changes no faster than the point moves. So between s = a and b, where it is
// d_a and d_b, it is nowhere less than (d_a + d_b - stretch (b - a)) / 2: pieces that this bound
// does not settle are halved.
#include "reach/clearance.h"

#include <math.h>

// a piece and one of its halves at each of the levels: 2^-64 of the curve is below rounding
enum { LEVELS = 64 };

typedef struct piece {
    double a, b;   // s
    double da, db; // distances of the wall there, less the radius
} piece;

typedef struct walk {
    const distance_tree *t;
    const body_curve *body;
    double radius;
    clearance *out;
} walk;

// the clearance at s, where |distance| is known to be at most `within`
static double clearance_at(walk *w, double s, double within)
{
    const vec3 p = w->body->at(w->body->context, s);
    const nearest_point wall = distance_within(w->t, p, within);
    const double c = wall.distance - w->radius;
    w->out->queries++;
    // a NaN is no room
    if (!(c >= w->out->least)) {
        w->out->least = c;
        w->out->s = s;
        w->out->point = p;
        w->out->wall = wall;
    }
    return c;
}

static double piece_half(const walk *w, const piece *c)
{
    return 0.5 * w->body->stretch * (c->b - c->a);
}

static double piece_bound(const walk *w, const piece *c)
{
    return 0.5 * (c->da + c->db) - piece_half(w, c);
}

static void split(walk *w, const piece *c, piece half[2])
{
    const double middle = 0.5 * (c->a + c->b);
    const double nearer = fmin(fabs(c->da + w->radius), fabs(c->db + w->radius));
    // wider by what rounding may add
    const double within = (nearer + piece_half(w, c)) * (1 + 1e-9) + 1e-12;
    const double d = clearance_at(w, middle, within);
    half[0] = (piece){c->a, middle, c->da, d};
    half[1] = (piece){middle, c->b, d, c->db};
}

static piece whole_body(walk *w)
{
    *w->out = (clearance){.least = INFINITY, .bound = INFINITY};
    piece c = {.a = w->body->begin, .b = w->body->end};
    c.da = clearance_at(w, c.a, INFINITY);
    c.db = clearance_at(w, c.b, INFINITY);
    return c;
}

void clearance_along(const distance_tree *t, const body_curve *body, double radius,
                     double tolerance, clearance *out)
{
    walk w = {.t = t, .body = body, .radius = radius, .out = out};
    piece todo[LEVELS + 1] = {whole_body(&w)};
    for (int n = 1; n > 0;) {
        const piece c = todo[--n];
        const double bound = piece_bound(&w, &c);
        if (bound >= out->least - tolerance || piece_half(&w, &c) <= tolerance || n + 2 > LEVELS) {
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
    out->bound = fmin(out->bound, out->least);
}

bool clearance_is_free(const distance_tree *t, const body_curve *body, double radius, double least,
                       double tolerance, clearance *at)
{
    clearance own;
    walk w = {.t = t, .body = body, .radius = radius, .out = at ? at : &own};
    piece todo[LEVELS + 1] = {whole_body(&w)};
    for (int n = 1; n > 0 && w.out->least >= least;) {
        const piece c = todo[--n];
        const double bound = piece_bound(&w, &c);
        if (bound >= least) {
            w.out->bound = fmin(w.out->bound, bound);
            continue;
        }
        if (piece_half(&w, &c) <= tolerance || n + 2 > LEVELS) {
            return false;
        }
        piece half[2];
        split(&w, &c, half);
        todo[n++] = half[1]; // from the begin on: the first place that is too near is found
        todo[n++] = half[0];
    }
    return w.out->least >= least;
}
