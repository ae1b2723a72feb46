// rodsolver/lie_lanes.c
#include "rodsolver/lie_step.h"

#define SQRT_15_3 1.29099444873580562839 // sqrt(15) / 3

// [a, b] of two twists, docs/theory.md (1.3)
LANES_INLINE void bracket(const lanes a[6], const lanes b[6], lanes out[6])
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = a[3 + j] * b[k] - a[3 + k] * b[j] + a[j] * b[3 + k] - a[k] * b[3 + j];
        out[3 + i] = a[3 + j] * b[3 + k] - a[3 + k] * b[3 + j];
    }
}

// lie_step_twist in lanes, docs/theory.md (4.7)
LANES_INLINE void twist_lanes(const lanes *h, const lanes xi[GAUSS_STATIONS][6], lanes out[6])
{
    lanes a1[6], a2[6], a3[6], inner[6], left[6], right[6], c1[6], c2[6], c3[6];
    for (int i = 0; i < 6; i++) {
        a1[i] = *h * xi[1][i];
        a2[i] = *h * SQRT_15_3 * (xi[2][i] - xi[0][i]);
        a3[i] = *h * (10.0 / 3) * (xi[0][i] - 2 * xi[1][i] + xi[2][i]);
    }
    bracket(a2, a1, c1);
    for (int i = 0; i < 6; i++) {
        inner[i] = 2 * a3[i] + c1[i];
    }
    bracket(a1, inner, c2);
    for (int i = 0; i < 6; i++) {
        left[i] = -20 * a1[i] - a3[i] + c1[i];
        right[i] = a2[i] + c2[i] * (1.0 / 60);
    }
    bracket(right, left, c3);
    for (int i = 0; i < 6; i++) {
        out[i] = a1[i] + a3[i] * (1.0 / 12) + c3[i] * (1.0 / 240);
    }
}

// Turns of at most two: there the series' first term left out is below 1e-17
static const double widest_square = 4;

// (1 - cos t) / t^2 and (t - sin t) / t^3 as series in t^2: 1/2! - t^2/4! + ..., 1/3! - t^2/5! ...
LANES_INLINE void exp_series(const lanes *square, lanes *b, lanes *c)
{
    enum { TERMS = 13 };
    const lanes zero = {0};
    lanes sum_b = zero + 1, sum_c = zero + 1;
    for (int k = TERMS; k > 0; k--) {
        const double n = 2 * k;
        sum_b = 1 - *square * sum_b * (1 / ((n + 1) * (n + 2)));
        sum_c = 1 - *square * sum_c * (1 / ((n + 2) * (n + 3)));
    }
    *b = sum_b * 0.5;
    *c = sum_c * (1.0 / 6);
}

// se3_exp in lanes: R = I + a hat(w) + b hat(w)^2, p = v + b w x v + c w x (w x v)
LANES_INLINE void exp_lanes(const lanes twist[6], const lanes *square, lanes_pose *g)
{
    const lanes *v = twist, *w = twist + 3;
    lanes b, c;
    exp_series(square, &b, &c);
    const lanes a = 1 - *square * c;
    const lanes along = w[0] * v[0] + w[1] * v[1] + w[2] * v[2];
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        g->R[i][i] = 1 + b * (w[i] * w[i] - *square);
        g->R[j][i] = b * w[i] * w[j] + a * w[k];
        g->R[i][j] = b * w[i] * w[j] - a * w[k];
        g->p[i] = v[i] + b * (w[j] * v[k] - w[k] * v[j]) + c * (w[i] * along - *square * v[i]);
    }
}

static void exp_wide_lane(const lanes twist[6], int lane, lanes_pose *g)
{
    vec6 one;
    for (int i = 0; i < 6; i++) {
        one.a[i] = twist[i][lane];
    }
    const pose wide = se3_exp(one);
    for (int i = 0; i < 3; i++) {
        g->p[i][lane] = wide.p.a[i];
        for (int j = 0; j < 3; j++) {
            g->R[i][j][lane] = wide.R.a[i][j];
        }
    }
}

LANES_CODE void lie_step_lanes(const lanes *h, const lanes xi[GAUSS_STATIONS][6], lanes_pose *out)
{
    lanes twist[6];
    twist_lanes(h, xi, twist);
    const lanes square = twist[3] * twist[3] + twist[4] * twist[4] + twist[5] * twist[5];
    exp_lanes(twist, &square, out);
    for (int k = 0; k < LANES; k++) {
        if (square[k] > widest_square) {
            exp_wide_lane(twist, k, out);
        }
    }
}
