// tests/verify/reach/dense_arc.h
// Where a tip of constant curvature gets nearest to a target, by trying all bends and turns.
#pragma once

#include "reach/arc.h"
#include "reach/scope.h"

#include <math.h>

enum { BENDS = 20000, DENSE_BENDS = 400, DENSE_TURNS = 360 };

// how far at these joints, the insertion the best in its limits
static inline double miss_of(const scope *s, vec3 local, double bend, double turn)
{
    const vec3 h = arc_point(s->length, bend, s->length);
    const double x = h.a[0] * cos(turn), y = h.a[0] * sin(turn);
    const double z = h.a[2] + fmin(fmax(local.a[2] - h.a[2], s->low[0]), s->high[0]);
    return sqrt(pow(x - local.a[0], 2) + pow(y - local.a[1], 2) + pow(z - local.a[2], 2));
}

// smaller and smaller about a place
static inline double refined(const scope *s, vec3 local, double bend, double turn)
{
    double du = (s->high[2] - s->low[2]) / DENSE_BENDS, dt = (s->high[1] - s->low[1]) / DENSE_TURNS;
    double best = miss_of(s, local, bend, turn);
    while (du > 1e-13) {
        const double at[2] = {bend, turn}, was = best;
        for (int i = 0; i < 25; i++) {
            const double u = fmin(fmax(at[0] + (i / 5 - 2) * du / 2, s->low[2]), s->high[2]);
            const double t = fmin(fmax(at[1] + (i % 5 - 2) * dt / 2, s->low[1]), s->high[1]);
            const double m = miss_of(s, local, u, t);
            if (m < best) {
                best = m;
                bend = u;
                turn = t;
            }
        }
        if (best == was) {
            du /= 2;
            dt /= 2;
        }
    }
    return best;
}

// over all of bend and turn, and about every bend that may be the best between its steps
static inline double dense_miss(const scope *s, vec3 local)
{
    double row[DENSE_BENDS + 1], turn[DENSE_BENDS + 1], least = INFINITY, best = INFINITY;
    const double du = (s->high[2] - s->low[2]) / DENSE_BENDS;
    const double dt = (s->high[1] - s->low[1]) / DENSE_TURNS;
    for (int i = 0; i <= DENSE_BENDS; i++) {
        row[i] = INFINITY;
        for (int k = 0; k <= DENSE_TURNS; k++) {
            const double m = miss_of(s, local, s->low[2] + i * du, s->low[1] + k * dt);
            turn[i] = m < row[i] ? s->low[1] + k * dt : turn[i];
            row[i] = fmin(m, row[i]);
        }
        least = fmin(least, row[i]);
    }
    for (int i = 0; i <= DENSE_BENDS; i++) {
        // half a step of bend and of turn move the tip by less
        if (row[i] < least + 3e-4) {
            best = fmin(best, refined(s, local, s->low[2] + i * du, turn[i]));
        }
    }
    return best;
}

// how often the distance from the line passes the target's, with the insertion in its limits
static inline int dense_count(const scope *s, double rho, double z)
{
    int n = 0;
    const double du = (s->high[2] - s->low[2]) / BENDS;
    for (int i = 0; i < BENDS; i++) {
        const vec3 a = arc_point(s->length, s->low[2] + i * du, s->length);
        const vec3 b = arc_point(s->length, s->low[2] + (i + 1) * du, s->length);
        const double in = z - (a.a[2] + b.a[2]) / 2;
        n += (fabs(a.a[0]) < rho) != (fabs(b.a[0]) < rho) && in >= s->low[0] && in <= s->high[0];
    }
    return n;
}
