// meshes/carrier.c
#include "meshes/carrier.h"

#include "base/element.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

carrier carrier_line(const double a[2], const double b[2])
{
    return (carrier){.kind = CARRIER_LINE, .p = {{a[0], a[1]}, {b[0], b[1]}}, .to = 1};
}

carrier carrier_arc(const double centre[2], double first, double second, double angle, double from,
                    double to)
{
    const double c = cos(angle), s = sin(angle);
    return (carrier){
        .kind = CARRIER_ELLIPSE,
        .p = {{centre[0], centre[1]}, {first * c, first * s}, {-second * s, second * c}},
        .from = from,
        .to = to};
}

// an ellipse longer than this is long
static const double LONG_ELLIPSE = 2;
// no piece is shorter than this angle [rad]
static const double SHORTEST_PIECE = 1e-6;

int carrier_divided(const double centre[2], double first, double second, double angle, double from,
                    double to, carrier out[CARRIER_MOST_PIECES])
{
    const bool is_long = fmax(first, second) > LONG_ELLIPSE * fmin(first, second);
    const double slant = atan2(second, first); // where the tangent runs at half a right angle
    const double at[] = {0, slant, PI / 2, PI - slant};
    int n = 0;
    double begin = from;
    for (int half = (int)floor(from / PI); half * PI < to; half++) {
        for (int i = 0; i < 4; i += is_long ? 1 : 2) {
            const double end = half * PI + at[i];
            if (end > begin + SHORTEST_PIECE && end < to - SHORTEST_PIECE &&
                n < CARRIER_MOST_PIECES - 1) {
                out[n++] = carrier_arc(centre, first, second, angle, begin, end);
                begin = end;
            }
        }
    }
    out[n++] = carrier_arc(centre, first, second, angle, begin, to);
    return n;
}

carrier carrier_cubic(const double *control)
{
    carrier c = {.kind = CARRIER_CUBIC, .to = 1};
    memcpy(c.p, control, sizeof c.p);
    return c;
}

// value, slope and second derivative of the curve at t
static void derivatives(const carrier *c, double t, double x[2], double d1[2], double d2[2])
{
    for (int k = 0; k < 2; k++) {
        const double a = c->p[0][k], b = c->p[1][k], e = c->p[2][k], f = c->p[3][k];
        if (c->kind == CARRIER_LINE) {
            x[k] = t < 0.5 ? a + (b - a) * t : b - (b - a) * (1 - t);
            d1[k] = b - a;
            d2[k] = 0;
        } else if (c->kind == CARRIER_ELLIPSE) {
            x[k] = a + b * cos(t) + e * sin(t);
            d1[k] = e * cos(t) - b * sin(t);
            d2[k] = -b * cos(t) - e * sin(t);
        } else {
            const double u = 1 - t;
            x[k] = u * u * u * a + 3 * u * u * t * b + 3 * u * t * t * e + t * t * t * f;
            d1[k] = 3 * (u * u * (b - a) + 2 * u * t * (e - b) + t * t * (f - e));
            d2[k] = 6 * (u * (e - 2 * b + a) + t * (f - 2 * e + b));
        }
    }
}

void carrier_point(const carrier *c, double t, double x[2])
{
    double d1[2], d2[2];
    derivatives(c, t, x, d1, d2);
}

void carrier_slope(const carrier *c, double t, double dx[2])
{
    double x[2], d2[2];
    derivatives(c, t, x, dx, d2);
}

void carrier_start(const carrier *c, double x[2])
{
    carrier_point(c, c->from, x);
}

void carrier_end(const carrier *c, double x[2])
{
    carrier_point(c, c->to, x);
}

static int point_count(const carrier *c)
{
    return c->kind == CARRIER_LINE ? 2 : c->kind == CARRIER_ELLIPSE ? 3 : 4;
}

carrier carrier_moved(const carrier *c, double angle, const double shift[2], int mirror)
{
    carrier out = *c;
    const double cs = cos(angle), sn = sin(angle);
    for (int i = 0; i < point_count(c); i++) {
        const bool direction = c->kind == CARRIER_ELLIPSE && i > 0;
        const double x = c->p[i][0], y = mirror * c->p[i][1];
        out.p[i][0] = cs * x - sn * y + (direction ? 0 : shift[0]);
        out.p[i][1] = sn * x + cs * y + (direction ? 0 : shift[1]);
    }
    return out;
}

carrier carrier_scaled(const carrier *c, double factor)
{
    carrier out = *c;
    for (int i = 0; i < point_count(c); i++) {
        out.p[i][0] *= factor;
        out.p[i][1] *= factor;
    }
    return out;
}

carrier carrier_reversed(const carrier *c)
{
    carrier out = *c;
    if (c->kind == CARRIER_ELLIPSE) {
        out.from = c->to;
        out.to = c->from;
        return out;
    }
    for (int i = 0, n = point_count(c); i < n; i++) {
        memcpy(out.p[i], c->p[n - 1 - i], sizeof out.p[i]);
    }
    return out;
}

carrier carrier_bent(const carrier *c, const double by_start[2], const double by_end[2])
{
    carrier out = *c;
    const int last = point_count(c) - 1;
    for (int k = 0; k < 2; k++) {
        if (c->kind == CARRIER_ELLIPSE) {
            // p1 cos t + p2 sin t takes up both
            const double det = sin(c->to - c->from), a = by_start[k], b = by_end[k];
            out.p[1][k] += (a * sin(c->to) - b * sin(c->from)) / det;
            out.p[2][k] += (b * cos(c->from) - a * cos(c->to)) / det;
            continue;
        }
        out.p[0][k] += by_start[k];
        out.p[last][k] += by_end[k];
        if (c->kind == CARRIER_CUBIC) {
            out.p[1][k] += by_start[k];
            out.p[2][k] += by_end[k];
        }
    }
    return out;
}

// control points of the part of a cubic between two parameters
static void cubic_part(const carrier *c, double from, double to, double out[4][2])
{
    double slope[2];
    for (int end = 0; end < 2; end++) {
        const double t = end ? to : from, third = (to - from) / 3;
        carrier_point(c, t, out[end ? 3 : 0]);
        carrier_slope(c, t, slope);
        for (int k = 0; k < 2; k++) {
            out[end ? 2 : 1][k] = out[end ? 3 : 0][k] + (end ? -third : third) * slope[k];
        }
    }
}

int carrier_hull(const carrier *c, double from, double to, double hull[CARRIER_HULL][2])
{
    if (c->kind == CARRIER_CUBIC) {
        cubic_part(c, from, to, hull);
        return 4;
    }
    carrier_point(c, from, hull[0]);
    if (c->kind == CARRIER_LINE) {
        carrier_point(c, to, hull[1]);
        return 2;
    }
    // where the tangents at its ends meet
    const double middle = (from + to) / 2, stretch = 1 / cos((to - from) / 2);
    for (int k = 0; k < 2; k++) {
        hull[1][k] = c->p[0][k] + stretch * (c->p[1][k] * cos(middle) + c->p[2][k] * sin(middle));
    }
    carrier_point(c, to, hull[2]);
    return 3;
}

double carrier_turn(const carrier *c)
{
    double h[CARRIER_HULL][2], turn = 0, before[2] = {0, 0};
    const int n = carrier_hull(c, c->from, c->to, h);
    for (int i = 0; i + 1 < n; i++) {
        const double step[2] = {h[i + 1][0] - h[i][0], h[i + 1][1] - h[i][1]};
        turn += fabs(atan2(before[0] * step[1] - before[1] * step[0],
                           before[0] * step[0] + before[1] * step[1]));
        memcpy(before, step, sizeof before);
    }
    return turn;
}

double carrier_sweep(const carrier *c, const double about[2])
{
    enum { POINTS = 12 }; // exact for cubics, to rounding for arcs below a half turn
    double x[POINTS], w[POINTS], sum = 0;
    gauss_legendre(POINTS, x, w);
    for (int q = 0; q < POINTS; q++) {
        const double half = (c->to - c->from) / 2, t = (c->from + c->to) / 2 + half * x[q];
        double at[2], slope[2];
        carrier_point(c, t, at);
        carrier_slope(c, t, slope);
        sum += w[q] * half * ((at[0] - about[0]) * slope[1] - (at[1] - about[1]) * slope[0]);
    }
    return sum;
}

// halvings after which a part is as good as its chord
enum { DEEPEST = 50 };

static bool part_crosses(const carrier *c, double from, double to, double x, double y, int depth)
{
    double h[CARRIER_HULL][2];
    const int n = carrier_hull(c, from, to, h);
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < 2; k++) {
            low[k] = fmin(low[k], h[i][k]);
            high[k] = fmax(high[k], h[i][k]);
        }
    }
    if (y < low[1] || y > high[1] || x > high[0]) {
        return false;
    }
    const double *a = h[0], *b = h[n - 1];
    const bool straddles = (a[1] > y) != (b[1] > y);
    if (x < low[0]) {
        return straddles;
    }
    if (c->kind == CARRIER_LINE || depth == DEEPEST) {
        return straddles && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
    }
    const double middle = (from + to) / 2;
    return part_crosses(c, from, middle, x, y, depth + 1) !=
           part_crosses(c, middle, to, x, y, depth + 1);
}

bool carrier_crosses(const carrier *c, double x, double y)
{
    return part_crosses(c, c->from, c->to, x, y, 0);
}

static double distance_at(const carrier *c, const double x[2], double t)
{
    double at[2];
    carrier_point(c, t, at);
    return hypot(at[0] - x[0], at[1] - x[1]);
}

// Newton's steps for (x(t) - x) . x'(t) = 0 that do not lead further away
static double polish(const carrier *c, const double x[2], double t, double low, double high)
{
    enum { STEPS = 20 };
    double best = distance_at(c, x, t);
    for (int i = 0; i < STEPS; i++) {
        double at[2], d1[2], d2[2];
        derivatives(c, t, at, d1, d2);
        const double off[2] = {at[0] - x[0], at[1] - x[1]};
        const double slope = off[0] * d1[0] + off[1] * d1[1], speed = d1[0] * d1[0] + d1[1] * d1[1];
        const double full = speed + off[0] * d2[0] + off[1] * d2[1];
        const double step = slope / (full > speed / 2 ? full : speed);
        const double next = fmin(fmax(t - step, low), high), there = distance_at(c, x, next);
        if (!(there < best)) {
            break;
        }
        t = next;
        best = there;
    }
    return t;
}

// the angle of a point on an ellipse, in its own axes
static double ellipse_guess(const carrier *c, const double x[2])
{
    const double *u = c->p[1], *v = c->p[2], dx = x[0] - c->p[0][0], dy = x[1] - c->p[0][1];
    const double det = u[0] * v[1] - u[1] * v[0];
    return atan2((u[0] * dy - u[1] * dx) / det, (dx * v[1] - dy * v[0]) / det);
}

static double cubic_guess(const carrier *c, const double x[2])
{
    enum { SAMPLES = 24 };
    double best = INFINITY, guess = 0;
    for (int i = 0; i <= SAMPLES; i++) {
        const double t = polish(c, x, (double)i / SAMPLES, 0, 1), d = distance_at(c, x, t);
        if (d < best) {
            best = d;
            guess = t;
        }
    }
    return guess;
}

double carrier_distance(const carrier *c, const double x[2], double *t)
{
    if (c->kind == CARRIER_ELLIPSE) {
        *t = polish(c, x, ellipse_guess(c, x), -INFINITY, INFINITY);
    } else if (c->kind == CARRIER_CUBIC) {
        *t = cubic_guess(c, x);
    } else {
        const double dx = c->p[1][0] - c->p[0][0], dy = c->p[1][1] - c->p[0][1];
        *t = ((x[0] - c->p[0][0]) * dx + (x[1] - c->p[0][1]) * dy) / (dx * dx + dy * dy);
        *t = fmin(fmax(*t, 0), 1);
    }
    return distance_at(c, x, *t);
}
