// rodsolver/local_lanes.c
#include "rodsolver/local_problem.h"

#include <math.h>
#include <stdbool.h>

enum { MAX_STEPS = 12, TRIANGLE = 21 };

// Newton's next step, foreseen from the last two, below this part of the strain: nothing left to do
static const double stop_step = 1e-16;
// ... foreseen only where the last one was that small: there steps shrink by their squares
static const double quadratic = 1e-2;
// ... and not at all after one as small as this, which may be rounding
static const double small_step = 1e-11;

// place of entry (i, j <= i) of a lower triangle
#define AT(i, j) ((i) * ((i) + 1) / 2 + (j))

// y = K e by the lower triangle
LANES_INLINE void symmetric_mul(const lanes K[TRIANGLE], const lanes e[6], lanes y[6])
{
#pragma GCC unroll 6
    for (int i = 0; i < 6; i++) {
        lanes sum = K[AT(i, i)] * e[i];
#pragma GCC unroll 6
        for (int j = 0; j < 6; j++) {
            if (j != i) {
                sum += (j < i ? K[AT(i, j)] : K[AT(j, i)]) * e[j];
            }
        }
        y[i] = sum;
    }
}

// H = L D L^T in place, D inverted; then H x = b
LANES_INLINE void symmetric_solve(lanes H[TRIANGLE], lanes b[6])
{
#pragma GCC unroll 6
    for (int j = 0; j < 6; j++) {
        lanes scaled[6];
#pragma GCC unroll 6
        for (int k = 0; k < j; k++) {
            // row j holds L D until here
            scaled[k] = H[AT(j, k)] * H[AT(k, k)];
            H[AT(j, j)] -= scaled[k] * H[AT(j, k)];
            b[j] -= scaled[k] * b[k];
        }
        H[AT(j, j)] = 1 / H[AT(j, j)];
#pragma GCC unroll 6
        for (int i = j + 1; i < 6; i++) {
#pragma GCC unroll 6
            for (int k = 0; k < j; k++) {
                H[AT(i, j)] -= H[AT(i, k)] * scaled[k];
            }
        }
#pragma GCC unroll 6
        for (int k = 0; k < j; k++) {
            H[AT(j, k)] = scaled[k];
        }
    }
#pragma GCC unroll 6
    for (int i = 5; i >= 0; i--) {
        b[i] *= H[AT(i, i)];
    }
#pragma GCC unroll 6
    for (int i = 5; i >= 0; i--) {
#pragma GCC unroll 6
        for (int k = i + 1; k < 6; k++) {
            b[i] -= H[AT(k, i)] * b[k];
        }
    }
}

typedef struct lane_place {
    lanes x, y, dx, dy;
} lane_place;

LANES_INLINE void load_place(const lane_tendon *t, lane_place *r)
{
    lanes_load(t->place, &r->x);
    lanes_load(t->place + t->stride, &r->y);
    lanes_load(t->place + 2 * t->stride, &r->dx);
    lanes_load(t->place + 3 * t->stride, &r->dy);
}

// unit tangent t and 1 / |d|
LANES_INLINE void tangent(const lane_place *r, const lanes xi[6], lanes t[3], lanes *inverse)
{
    t[0] = xi[0] - xi[5] * r->y + r->dx;
    t[1] = xi[1] + xi[5] * r->x + r->dy;
    t[2] = xi[2] + xi[3] * r->y - xi[4] * r->x;
    const lanes square = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
    lanes size;
    for (int k = 0; k < LANES; k++) {
        size[k] = sqrt(square[k]);
    }
    *inverse = 1 / size;
    for (int i = 0; i < 3; i++) {
        t[i] *= *inverse;
    }
}

// g += tau A^T t
LANES_INLINE void add_wrench(const lane_place *r, double tau, const lanes t[3], lanes g[6])
{
    const lanes f0 = tau * t[0], f1 = tau * t[1], f2 = tau * t[2];
    g[0] += f0;
    g[1] += f1;
    g[2] += f2;
    g[3] += r->y * f2;
    g[4] -= r->x * f2;
    g[5] += r->x * f1 - r->y * f0;
}

// H += q A^T (I - t t^T) A
LANES_INLINE void add_stiffness(const lane_place *r, const lanes *q, const lanes t[3],
                                lanes H[TRIANGLE])
{
    const lanes q0 = *q * t[0], q1 = *q * t[1], q2 = *q * t[2];
    const lanes P00 = *q - q0 * t[0], P11 = *q - q1 * t[1], P22 = *q - q2 * t[2];
    const lanes P10 = -q1 * t[0], P20 = -q2 * t[0], P21 = -q2 * t[1];
    const lanes x = r->x, y = r->y;
    // rows of P under w_z
    const lanes z0 = x * P10 - y * P00, z1 = x * P11 - y * P10, z2 = x * P21 - y * P20;
    H[AT(0, 0)] += P00;
    H[AT(1, 0)] += P10;
    H[AT(1, 1)] += P11;
    H[AT(2, 0)] += P20;
    H[AT(2, 1)] += P21;
    H[AT(2, 2)] += P22;
    H[AT(3, 0)] += y * P20;
    H[AT(3, 1)] += y * P21;
    H[AT(3, 2)] += y * P22;
    H[AT(3, 3)] += y * y * P22;
    H[AT(4, 0)] -= x * P20;
    H[AT(4, 1)] -= x * P21;
    H[AT(4, 2)] -= x * P22;
    H[AT(4, 3)] -= x * y * P22;
    H[AT(4, 4)] += x * x * P22;
    H[AT(5, 0)] += z0;
    H[AT(5, 1)] += z1;
    H[AT(5, 2)] += z2;
    H[AT(5, 3)] += y * z2;
    H[AT(5, 4)] -= x * z2;
    H[AT(5, 5)] += x * z1 - y * z0;
}

LANES_INLINE void load_rows(const double *row, int stride, int n, lanes *out)
{
    for (int i = 0; i < n; i++) {
        lanes_load(row + i * stride, &out[i]);
    }
}

// one Newton step: its decrement g^T H^-1 g over the energy e^T K e before it
LANES_INLINE void newton_step(const lane_problem *p, const lanes rest[6], lanes xi[6], lanes *ratio)
{
    lanes H[TRIANGLE], e[6], g[6], step[6];
    load_rows(p->K, p->stride, TRIANGLE, H);
    for (int c = 0; c < 6; c++) {
        e[c] = xi[c] - rest[c];
    }
    symmetric_mul(H, e, g);
    lanes energy = e[0] * g[0];
    for (int c = 1; c < 6; c++) {
        energy += e[c] * g[c];
    }
    for (int i = 0; i < p->ntendon; i++) {
        const lane_tendon *tendon = &p->tendon[i];
        lane_place r;
        lanes t[3], inverse;
        load_place(tendon, &r);
        tangent(&r, xi, t, &inverse);
        const lanes q = tendon->tension * inverse;
        add_wrench(&r, tendon->tension, t, g);
        add_stiffness(&r, &q, t, H);
    }
    for (int c = 0; c < 6; c++) {
        step[c] = g[c];
    }
    symmetric_solve(H, step);
    lanes decrement = step[0] * g[0];
    for (int c = 1; c < 6; c++) {
        decrement += step[c] * g[c];
    }
    for (int c = 0; c < 6; c++) {
        xi[c] -= step[c];
    }
    *ratio = decrement / energy;
}

// Steps shrink as r, c r^2, ...: the one after the last two is r^3 / before^2. All are squares here
static unsigned not_yet(int count, const lanes *before, const lanes *now)
{
    unsigned wait = 0;
    for (int k = 0; k < count; k++) {
        // from rest the first step is infinitely larger than the strain
        const double r = (*now)[k], b = fmin((*before)[k], 1);
        const bool done =
            r <= quadratic * quadratic &&
            (r * r * r <= stop_step * stop_step * b * b || r <= small_step * small_step);
        wait |= (done ? 0u : 1u) << k;
    }
    return wait;
}

LANES_CODE int local_solve_lanes(const lane_problem *p, lanes xi[6], unsigned *unsolved)
{
    lanes rest[6], before = {0};
    load_rows(p->rest, p->stride, 6, rest);
    int steps = 0;
    do {
        lanes now;
        newton_step(p, rest, xi, &now);
        *unsolved = not_yet(p->count, &before, &now);
        before = now;
        steps++;
    } while (*unsolved && steps < MAX_STEPS);
    return steps;
}

LANES_CODE void local_check_lanes(const lane_problem *p, const lanes xi[6], lanes *energy,
                                  lanes *misfit)
{
    lanes K[TRIANGLE], e[6], g[6];
    load_rows(p->K, p->stride, TRIANGLE, K);
    load_rows(p->rest, p->stride, 6, e);
    for (int c = 0; c < 6; c++) {
        e[c] = xi[c] - e[c];
    }
    symmetric_mul(K, e, g);
    *energy = e[0] * g[0];
    for (int c = 1; c < 6; c++) {
        *energy += e[c] * g[c];
    }
    for (int i = 0; i < p->ntendon; i++) {
        lane_place r;
        lanes t[3], inverse;
        load_place(&p->tendon[i], &r);
        tangent(&r, xi, t, &inverse);
        add_wrench(&r, p->tendon[i].tension, t, g);
    }
    *misfit = g[0] * g[0] / K[AT(0, 0)];
    for (int c = 1; c < 6; c++) {
        *misfit += g[c] * g[c] / K[AT(c, c)];
    }
}
