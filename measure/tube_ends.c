// measure/tube_ends.c
// Where the points end along the line: a step in their density that the noise has smeared.
#include "measure/tube_inside.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

enum { COARSE = 400, FINE = 241, CAP_POINTS = 20 };

// radii that are looked at: the last cylinder, and what the line goes on beyond it; no further,
// lest the other side of a bridged gap is taken for the end
static const double edge_reach = 2.7;
static const double shell = 3;           // deviations: points on the surface
static const double zone_length = 0.5;   // radii before an end whose density counts
static const double still_surface = 0.1; // density behind an end against that before it
static const double cap_reach = 0.9;     // radii: points within close the end

// places along the line of the points on the surface, measured outward from `from`
typedef struct edge {
    size_t count;
    double *s;     // ascending
    double length; // that was looked at
    double smear;
} edge;

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double outward(int side, double from, double u)
{
    return side > 0 ? u - from : from - u;
}

static status take_edge(const tube_fit *f, int side, double from, edge *e)
{
    status st = OK;
    e->length = side > 0 ? f->curve.length - from : from;
    e->smear = fmax(f->noise, 1e-5 * f->radius);
    TRY(TAKE(e->s, f->count));
    for (size_t i = 0; i < f->count; i++) {
        const double s = outward(side, from, f->u[i]);
        if (fabs(f->res[i]) < shell * f->noise && s > 0 && s < e->length) {
            e->s[e->count++] = s;
        }
    }
    qsort(e->s, e->count, sizeof *e->s, by_value);

done:
    return st;
}

static double log_of(double count, double length)
{
    return count > 0 && length > 0 ? count * log(count / length) : 0;
}

// the sharp step that is most likely, density free on both sides
static double sharp_step(const edge *e)
{
    double best = -INFINITY, at = e->length;
    size_t k = 0;
    for (int i = 1; i < COARSE; i++) {
        const double s = e->length * i / COARSE;
        while (k < e->count && e->s[k] < s) {
            k++;
        }
        const double n = (double)k, m = (double)(e->count - k);
        const double likely = log_of(n, s) + log_of(m, e->length - s);
        if (likely > best && n / s > m / (e->length - s)) {
            best = likely;
            at = s;
        }
    }
    return at;
}

// log likelihood of a step at s, smeared by the noise, b behind it; the density before it is what
// holds the zone's points                                                                   (9.10)
static double smeared(const edge *zone, double b, double s)
{
    const double before = ((double)zone->count - b * (zone->length - s)) / s;
    const double a = fmax(before, 2 * b);
    double sum = -a * s - b * (zone->length - s);
    for (size_t i = 0; i < zone->count; i++) {
        const double z = (s - zone->s[i]) / zone->smear;
        sum += z > 6 ? log(a) : z < -6 ? log(b) : log(b + (a - b) * 0.5 * erfc(-z / sqrt(2)));
    }
    return sum;
}

// mean and deviation of the likelihood between two places
static void mean_place(const edge *zone, double b, double from, double to, double *at,
                       double *sigma)
{
    double value[FINE], top = -INFINITY, sum = 0, mean = 0, square = 0;
    for (int i = 0; i < FINE; i++) {
        value[i] = smeared(zone, b, from + (to - from) * i / (FINE - 1));
        top = fmax(top, value[i]);
    }
    for (int i = 0; i < FINE; i++) {
        const double s = from + (to - from) * i / (FINE - 1), w = exp(value[i] - top);
        sum += w;
        mean += w * s;
        square += w * s * s;
    }
    *at = mean / sum;
    *sigma = sqrt(fmax(square / sum - *at * *at, pow((to - from) / FINE, 2) / 12));
}

// the zone round a sharp step: short, for patches without points change the density further away
static void smeared_step(const edge *e, double radius, double *at, double *sigma)
{
    const double start = *at, half = 5 * e->smear + 3 * e->length / COARSE;
    const double begin = fmax(0, start - fmax(3 * half, zone_length * radius));
    const double beyond = fmin(e->length, start + half);
    size_t before = 0, behind = 0;
    for (size_t i = 0; i < e->count; i++) {
        e->s[i] -= begin;
        before += e->s[i] <= 0;
        behind += e->s[i] > beyond - begin;
    }
    const edge zone = {e->count - before, e->s + before, e->length - begin, e->smear};
    const double b = ((double)behind + 0.5) / (e->length - beyond + 10 * e->smear);
    mean_place(&zone, b, fmax(0.5 * (start - begin), start - half - begin), beyond - begin, at,
               sigma);
    *at += begin;
    if (b > still_surface * ((double)e->count - (double)behind) / *at) {
        *sigma = fmax(*sigma, e->length - *at); // the surface seems to go on
    }
}

// where points in front of the end lie, if it is a plane, and if it is a half ball
typedef struct cap {
    size_t count;
    double *flat, *round; // [count] each point's opinion of how far beyond the end
} cap;

static status look_at_cap(const tube_fit *f, int side, double end, cap *c)
{
    status st = OK;
    vec3 t;
    const double r = tube_fit_radius(f, end);
    const vec3 p = tube_curve_at(&f->curve, end, &t, NULL);
    t = vec3_scale(side / vec3_norm(t), t);
    TRY(TAKE(c->flat, f->count));
    TRY(TAKE(c->round, f->count));
    for (size_t i = 0; i < f->count; i++) {
        const vec3 v = vec3_sub((vec3){{f->p[i][0], f->p[i][1], f->p[i][2]}}, p);
        const double z = vec3_dot(v, t), d = sqrt(fmax(0, vec3_dot(v, v) - z * z));
        // no further back: a bent tube's own wall comes near the straight axis there
        if (d < fmin(cap_reach * r, r - 5 * f->noise) && z > -0.5 * r && z < 1.5 * r) {
            c->flat[c->count] = z;
            c->round[c->count++] = z - sqrt(r * r - d * d) + r;
        }
    }
    qsort(c->flat, c->count, sizeof *c->flat, by_value);
    qsort(c->round, c->count, sizeof *c->round, by_value);

done:
    return st;
}

// how many are of the middle one's opinion
static size_t agreed(const double *x, size_t count, double within)
{
    size_t n = 0;
    for (size_t i = 0; i < count; i++) {
        n += fabs(x[i] - x[count / 2]) < within;
    }
    return n;
}

// points that close the end say where it is, better than the step does
static status close_end(const tube_fit *f, int side, tube_end *out)
{
    status st = OK;
    cap c = {0};
    TRY(look_at_cap(f, side, out->u, &c));
    const size_t flat = agreed(c.flat, c.count, 4 * f->noise);
    const size_t round = agreed(c.round, c.count, 4 * f->noise);
    const size_t most = flat > round ? flat : round;
    if (most >= CAP_POINTS && 2 * most > c.count) {
        out->kind = flat > round ? TUBE_TIP_FLAT : TUBE_TIP_ROUND;
        out->straight = flat > round ? 0 : tube_fit_radius(f, out->u);
        out->u += side * (flat > round ? c.flat : c.round)[c.count / 2];
        // a median's deviation; a half ball's points are at a slope
        out->sigma = (flat > round ? 1.25 : 1.8) * f->noise / sqrt((double)most);
    }

done:
    free(c.flat);
    free(c.round);
    return st;
}

status tube_find_end(const tube_fit *f, int side, tube_end *out)
{
    status st = OK;
    edge e = {0};
    const double reach = fmin(edge_reach * f->radius, 0.7 * f->curve.length);
    const double from = side > 0 ? f->curve.length - reach : reach;
    TRY(take_edge(f, side, from, &e));
    if (e.count < 2) {
        TRY(status_fail(ERR_FILE, "the tube's end is not to be seen"));
    }
    double at = sharp_step(&e), sigma = 0;
    smeared_step(&e, f->radius, &at, &sigma);
    *out = (tube_end){.u = from + side * at, .sigma = sigma, .kind = TUBE_TIP_OPEN};
    TRY(close_end(f, side, out));

done:
    free(e.s);
    return st;
}
