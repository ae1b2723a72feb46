// tests/rod_shooting_solve.h
// The second method, part 6: walks the path, tells what is met on it, and ends with twice as many
// steps, whose difference tells the error.
#pragma once

#include "tests/rod_shooting_index.h"

typedef struct shoot_walk {
    shoot_path *p;
    bool potential;
    int negative;           // directions at `at`, where there is a potential
    shoot_point at, before; // before.z only serves its tangent
    double last, step;      // arclength of the last step and of the next
    double y[SHOOT_SIZE];
} shoot_walk;

static inline double shoot_dot(int n, const double *a, const double *b)
{
    double sum = 0;
    for (int i = 0; i < n; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

// the point about h ahead; the guess is a parabola by the last two tangents
static inline bool shoot_ahead(shoot_walk *w, double h, shoot_point *out)
{
    const int n = w->p->n + 1;
    double z[SHOOT_UNKNOWNS + 1] = {0}, off = 0;
    for (int i = 0; i < n; i++) {
        const double bend = w->last > 0 ? (w->at.tangent[i] - w->before.tangent[i]) / w->last : 0;
        z[i] = w->at.z[i] + h * (w->at.tangent[i] + h / 2 * bend);
    }
    if (!shoot_correct(w->p, w->at.tangent, w->at.tangent, z, out, w->y)) {
        return false;
    }
    for (int i = 0; i < n; i++) {
        off += (out->z[i] - z[i]) * (out->z[i] - z[i]);
    }
    // farther than that it may be another path's point
    return sqrt(off) < 0.1 * h;
}

// lambda between two points by its values and slopes rises, or falls, all the way
static inline bool shoot_monotone(int n, const shoot_point *a, const shoot_point *b)
{
    double h = 0;
    for (int i = 0; i <= n; i++) {
        h += (b->z[i] - a->z[i]) * (b->z[i] - a->z[i]);
    }
    h = sqrt(h);
    const double rise = b->z[n] - a->z[n], u = h * a->tangent[n], v = h * b->tangent[n];
    if (u * v <= 0) {
        return true; // a limit point that is seen anyway
    }
    // slope u + 2 t (3 rise - 2 u - v) + 3 t^2 (u + v - 2 rise) at its extreme
    const double k = 3 * rise - 2 * u - v, q = 3 * (u + v - 2 * rise);
    const double t = q != 0 ? -k / q : -1;
    return t <= 0 || t >= 1 || (u + t * k) * u > 0.05 * u * u;
}

static inline double shoot_watched(const shoot_walk *w, int kind, const shoot_point *q)
{
    return kind == CRITICAL_LIMIT ? q->tangent[w->p->n] : q->determinant;
}

// where the watched figure vanishes, less than h ahead: regula falsi, Illinois
static inline bool shoot_locate(shoot_walk *w, int kind, double h, const shoot_point *end,
                                shoot_point *out)
{
    double a = 0, b = h, fa = shoot_watched(w, kind, &w->at), fb = shoot_watched(w, kind, end);
    for (int step = 0; step < 60; step++) {
        const double c = (a * fb - b * fa) / (fb - fa);
        if (!shoot_ahead(w, c, out)) {
            return false;
        }
        const double fc = shoot_watched(w, kind, out);
        if (fabs(b - a) < 1e-7 || fabs(fc) < 1e-8) {
            return true;
        }
        if (fc * fb < 0) {
            a = b;
            fa = fb;
        } else {
            fa /= 2;
        }
        b = c;
        fb = fc;
    }
    return true;
}

static inline void shoot_tell(shoot_answer *out, int kind, double fraction)
{
    if (out->ncritical < SHOOT_CRITICALS) {
        out->critical[out->ncritical++] = (shoot_critical){kind, fraction};
    }
}

// from a point below lambda = 1 to the one on it, where the step to `b` crosses it
static inline bool shoot_land(shoot_walk *w, const shoot_point *b, shoot_point *out)
{
    const int n = w->p->n;
    const double t = (1 - w->at.z[n]) / (b->z[n] - w->at.z[n]);
    double z[SHOOT_UNKNOWNS + 1] = {0}, across[SHOOT_UNKNOWNS + 1] = {0};
    for (int i = 0; i < n; i++) {
        z[i] = w->at.z[i] + t * (b->z[i] - w->at.z[i]);
    }
    z[n] = across[n] = 1;
    return shoot_correct(w->p, across, w->at.tangent, z, out, w->y) && out->tangent[n] > 0;
}

// The number of negative directions changes by one where the determinant's sign changes, and else
// not at all: otherwise the step went past two critical points, or across to another path. y: the
// state at the tip.
static inline bool shoot_counts(const shoot_walk *w, const shoot_point *b, const double *y,
                                int *negative)
{
    *negative = 0;
    if (!w->potential) {
        return true;
    }
    *negative = shoot_count(&w->p->c, b->z[w->p->n], shoot_get_pose(y));
    const int change = abs(*negative - w->negative);
    return change == (w->at.determinant * b->determinant < 0 ? 1 : 0);
}

// Two zeros of the determinant may hide in a step h: the parabola through it and the point before
// would come close to zero inside.
static inline bool shoot_hides(const shoot_walk *w, const shoot_point *b, double h)
{
    const double shortest = 1e-4;
    if (w->last == 0 || h < shortest) {
        return false;
    }
    const double at = w->at.determinant, f = (b->determinant - at) / h;
    const double g = (at - w->before.determinant) / w->last;
    const double bend = (f - g) / (h + w->last), slope = f - bend * h;
    const double t = -slope / (2 * bend);
    return at * b->determinant > 0 && t > 0 && t < h &&
           (at + t * (slope + t * bend)) / at < 0.25 * fmin(1, b->determinant / at);
}

// whether the step to b may be kept: short enough to see all that lies on it
static inline bool shoot_keeps(const shoot_walk *w, const shoot_point *b)
{
    const int n = w->p->n;
    const double turn = acos(fmin(1, shoot_dot(n + 1, w->at.tangent, b->tangent)));
    const bool limit = w->at.tangent[n] * b->tangent[n] < 0;
    const bool odd = w->at.determinant * b->determinant < 0;
    // it comes down to zero in several steps, from 1 at rest
    const double most = fmax(fmax(fabs(w->at.determinant), fabs(b->determinant)), 0.02);
    const bool calm = fabs(w->at.determinant - b->determinant) <= 0.35 * most;
    return turn <= w->p->bend && calm && shoot_monotone(n, &w->at, b) && (!limit || odd);
}

// The next point and whether it is the end; short steps until nothing on the way is missed. Two
// critical points at once, as those of a round column, stay together however short the step.
static inline bool shoot_step_on(shoot_walk *w, shoot_point *b, double *h, bool *landed, int *count)
{
    const int n = w->p->n;
    const double shortest = 1e-9, together = 1e-5;
    shoot_point end;
    for (*h = w->step; *h > shortest; *h /= 2) {
        if (!shoot_ahead(w, *h, b) || !shoot_keeps(w, b) || shoot_hides(w, b, *h)) {
            continue;
        }
        *landed = w->at.z[n] < 1 && b->z[n] >= 1;
        if (*landed) {
            if (!shoot_land(w, b, &end) || !shoot_keeps(w, &end)) {
                continue;
            }
            *b = end;
        }
        if (shoot_counts(w, b, w->y, count) || *h < together) {
            return true;
        }
    }
    return false;
}

// what lies between here and b; false: no convergence
static inline bool shoot_meet(shoot_walk *w, const shoot_point *b, int count, shoot_answer *out,
                              shoot_point *limit)
{
    const int n = w->p->n;
    shoot_point critical;
    double chord = 0;
    if (w->at.determinant * b->determinant > 0) {
        if (w->potential && count != w->negative) {
            shoot_tell(out, CRITICAL_BIFURCATION, b->z[n]);
        }
        return true;
    }
    const int kind = w->at.tangent[n] * b->tangent[n] < 0 ? CRITICAL_LIMIT : CRITICAL_BIFURCATION;
    for (int i = 0; i <= n; i++) {
        chord += (b->z[i] - w->at.z[i]) * w->at.tangent[i];
    }
    if (!shoot_locate(w, kind, chord, b, &critical)) {
        return false;
    }
    shoot_tell(out, kind, critical.z[n]);
    if (kind == CRITICAL_LIMIT) {
        *limit = critical;
    }
    return true;
}

// true: go on; false: the walk ends, out says how
static inline bool shoot_walk_on(shoot_walk *w, bool past, shoot_answer *out)
{
    const int n = w->p->n;
    shoot_point b, limit = {0};
    double h = 0;
    bool landed = false;
    int count = 0;
    if (!shoot_step_on(w, &b, &h, &landed, &count)) {
        return false;
    }
    const double turn = acos(fmin(1, shoot_dot(n + 1, w->at.tangent, b.tangent)));
    if (!shoot_meet(w, &b, count, out, &limit)) {
        return false;
    }
    if (limit.z[n] > 0 && !past) {
        out->fraction = limit.z[n];
        out->solved = true;
        w->at = limit;
        return false;
    }
    w->before = w->at;
    w->last = h;
    w->at = b;
    w->negative = count;
    w->step = fmin(w->p->longest, h * fmin(2, fmax(0.5, 0.6 * w->p->bend / fmax(turn, 1e-9))));
    out->points++;
    if (landed) {
        out->solved = true;
        out->fraction = 1;
        out->negative = w->potential ? count : -1;
    }
    return !landed && out->points < 5000;
}

static inline void shoot_finish(const shoot_path *p, const double *z, const double *y,
                                shoot_answer *out)
{
    out->tip = shoot_get_pose(y);
    memcpy(out->length, y + AT_LENGTH, sizeof out->length);
    for (int i = 0; i < 6; i++) {
        out->base_wrench[i] =
            i >= p->first ? z[i - p->first] * p->scale[i] : z[p->n] * p->total[i % 3];
    }
}

// rods without loads: nothing to be found
static inline bool shoot_unloaded(shoot_path *p, shoot_answer *out)
{
    double y[SHOOT_SIZE] = {0};
    const double z[1] = {1};
    shoot_put_pose(p->c.base, y);
    p->c.ncolumn = 0;
    p->c.lambda_column = -1;
    out->solved = shoot_march(&p->c, 1, 1, y, NULL);
    out->fraction = 1;
    out->sign = 1;
    shoot_finish(p, z, y, out);
    return out->solved;
}

// z at fraction 1, on the steps of p
static inline bool shoot_polish(shoot_path *p, double *z, shoot_answer *out)
{
    double across[SHOOT_UNKNOWNS + 1] = {0}, y[SHOOT_SIZE];
    shoot_point end;
    p->close = 1e-11;
    across[p->n] = 1;
    if (p->n == 0) {
        out->negative = 0;
        return shoot_unloaded(p, out);
    }
    if (!shoot_correct(p, across, across, z, &end, y)) {
        return false;
    }
    memcpy(z, end.z, sizeof end.z);
    out->sign = end.determinant > 0 ? 1 : -1;
    shoot_finish(p, end.z, y, out);
    return true;
}

// The equilibrium that continuation from rest reaches, with criticals on the way. `fine` is the
// same rod with twice the steps; care >= 1 shortens the steps of the continuation.
static inline shoot_answer shoot_solve(shooting *sh, shooting *fine, const rod_request *rq,
                                       double care)
{
    shoot_answer out = {.negative = -1};
    shoot_path p = shoot_path_make(sh, rq), q = shoot_path_make(fine, rq);
    shoot_walk w = {.p = &p, .step = 0.03 / care, .potential = shoot_has_potential(&p.c)};
    p.bend /= care;
    p.longest /= care;
    if (p.n > 0) {
        double J[SHOOT_UNKNOWNS + 1][SHOOT_UNKNOWNS + 1], r[SHOOT_UNKNOWNS];
        double like[SHOOT_UNKNOWNS + 1] = {0};
        like[p.n] = 1;
        if (!shoot_boundary(&p, w.at.z, w.y, r, J)) {
            return out;
        }
        shoot_tangent_of(p.n, (const double(*)[SHOOT_UNKNOWNS + 1]) J, like, &w.at);
        while (shoot_walk_on(&w, rq->past, &out)) {
        }
        if (out.solved && out.fraction < 1) {
            shoot_finish(&p, w.at.z, w.y, &out);
            out.marches = p.marches;
            return out;
        }
        if (!out.solved) {
            return out;
        }
    }
    shoot_answer coarse = out;
    out.solved = shoot_polish(&p, w.at.z, &coarse) && shoot_polish(&q, w.at.z, &out);
    // order 8 leaves 1/255 of the difference; counted five times as much
    out.error = vec3_norm(vec3_sub(out.tip.p, coarse.tip.p)) / 50;
    out.marches = p.marches + q.marches;
    return out;
}
