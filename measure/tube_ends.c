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
static const double shell = 3; // deviations: points on the surface

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

// log likelihood of a step at s, smeared by the noise; a, b densities before and behind it  (7.10)
static double smeared(const edge *e, double a, double b, double s)
{
    double sum = -a * s - b * (e->length - s);
    for (size_t i = 0; i < e->count; i++) {
        const double z = (s - e->s[i]) / e->smear;
        sum += z > 6 ? log(a) : z < -6 ? log(b) : log(b + (a - b) * 0.5 * erfc(-z / sqrt(2)));
    }
    return sum;
}

// mean and deviation of the likelihood round a sharp step
static void smeared_step(const edge *e, double *at, double *sigma)
{
    const double half = 8 * e->smear + 3 * e->length / COARSE, start = *at;
    const double from = fmax(1e-3 * e->length, start - half);
    const double to = fmin(e->length, start + half);
    size_t before = 0, behind = 0;
    for (size_t i = 0; i < e->count; i++) {
        before += e->s[i] < from;
        behind += e->s[i] > to;
    }
    const double a = fmax(1, (double)before) / from;
    const double b = fmin(0.5 * a, ((double)behind + 0.5) / (e->length - to + 10 * e->smear));
    double value[FINE], top = -INFINITY, sum = 0, mean = 0, square = 0;
    for (int i = 0; i < FINE; i++) {
        value[i] = smeared(e, a, b, from + (to - from) * i / (FINE - 1));
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

typedef struct cap {
    size_t flat, round, all;
    double *z;
    double lift, weight; // of a half ball's points beyond it, least squares
} cap;

static status look_at_cap(const tube_fit *f, int side, double end, cap *c)
{
    status st = OK;
    vec3 t;
    const vec3 p = tube_curve_at(&f->curve, end, &t, NULL);
    t = vec3_scale(side / vec3_norm(t), t);
    TRY(TAKE(c->z, f->count));
    for (size_t i = 0; i < f->count; i++) {
        const vec3 v = vec3_sub((vec3){{f->p[i][0], f->p[i][1], f->p[i][2]}}, p);
        const double z = vec3_dot(v, t), r = f->radius, ball = vec3_norm(v) - r;
        const double d = sqrt(fmax(0, vec3_dot(v, v) - z * z));
        if (d > r - 5 * f->noise || z < -0.5 * r || z > 1.5 * r) {
            continue;
        }
        c->z[c->all++] = z;
        if (z > 0 && fabs(ball) < 0.1 * r) {
            c->round++;
            c->lift += ball * z / (r + ball);
            c->weight += pow(z / (r + ball), 2);
        }
    }
    qsort(c->z, c->all, sizeof *c->z, by_value);

done:
    return st;
}

// closed by a plane: its points say where the end is, better than the step; by a half ball: the
// end is a radius further
static status close_end(const tube_fit *f, int side, tube_end *out)
{
    status st = OK;
    cap c = {0};
    TRY(look_at_cap(f, side, out->u, &c));
    const double z = c.all ? c.z[c.all / 2] : 0;
    for (size_t i = 0; i < c.all; i++) {
        c.flat += fabs(c.z[i] - z) < 3 * f->noise;
    }
    if (c.flat >= CAP_POINTS && 2 * c.flat > c.all) {
        out->kind = TUBE_TIP_FLAT;
        out->u += side * z;
        out->sigma = 1.25 * f->noise / sqrt((double)c.flat);
    } else if (c.round >= CAP_POINTS && 2 * c.round > c.all) {
        const double lift = c.lift / c.weight;
        out->kind = TUBE_TIP_ROUND;
        out->u += side * (f->radius + lift);
        out->sigma = hypot(f->noise / sqrt(c.weight), f->radius_sigma);
    }

done:
    free(c.z);
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
    smeared_step(&e, &at, &sigma);
    *out = (tube_end){.u = from + side * at, .sigma = sigma, .kind = TUBE_TIP_OPEN};
    TRY(close_end(f, side, out));

done:
    free(e.s);
    return st;
}
