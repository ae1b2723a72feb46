// rodsolver/lie_step.c
#include "rodsolver/lie_step.h"

#define HALF_SQRT_3_5 0.38729833462074168852 // sqrt(3/5) / 2
#define SQRT_15_3 1.29099444873580562839     // sqrt(15) / 3

const double gauss_point[GAUSS_STATIONS] = {0.5 - HALF_SQRT_3_5, 0.5, 0.5 + HALF_SQRT_3_5};
const double gauss_weight[GAUSS_STATIONS] = {5.0 / 18, 8.0 / 18, 5.0 / 18};

// Blanes, Casas and Ros (2000), docs/theory.md (4.7). They integrate Y' = A Y; here g' = g hat(xi),
// which turns every bracket round
vec6 lie_step_twist(double h, const vec6 xi[GAUSS_STATIONS])
{
    vec6 a1, a2, a3, inner, left, right;
    for (int i = 0; i < 6; i++) {
        const double x = xi[0].a[i], y = xi[1].a[i], z = xi[2].a[i];
        a1.a[i] = h * y;
        a2.a[i] = h * SQRT_15_3 * (z - x);
        a3.a[i] = h * (10.0 / 3) * (x - 2 * y + z);
    }
    const vec6 c1 = se3_bracket(a2, a1);
    for (int i = 0; i < 6; i++) {
        inner.a[i] = 2 * a3.a[i] + c1.a[i];
    }
    const vec6 c2 = se3_bracket(a1, inner); // = -60 C2 of the paper after the turn
    for (int i = 0; i < 6; i++) {
        left.a[i] = -20 * a1.a[i] - a3.a[i] + c1.a[i];
        right.a[i] = a2.a[i] + c2.a[i] / 60;
    }
    const vec6 c3 = se3_bracket(right, left);
    for (int i = 0; i < 6; i++) {
        a1.a[i] += a3.a[i] / 12 + c3.a[i] / 240;
    }
    return a1;
}

void lie_pair_weights(double t, double *weight)
{
    double node[2 * GAUSS_STATIONS];
    for (int i = 0; i < 2 * GAUSS_STATIONS; i++) {
        node[i] = gauss_point[i % GAUSS_STATIONS] + (i < GAUSS_STATIONS ? 0 : 1);
    }
    for (int i = 0; i < 2 * GAUSS_STATIONS; i++) {
        weight[i] = 1;
        for (int j = 0; j < 2 * GAUSS_STATIONS; j++) {
            weight[i] *= j == i ? 1 : (t - node[j]) / (node[i] - node[j]);
        }
    }
}

pose lie_pair_pose(double h, const vec6 xi[2 * GAUSS_STATIONS], double t)
{
    pose g = pose_identity();
    const double part[3] = {0, t < 1 ? t : 1, t};
    for (int k = 0; k < (t > 1 ? 2 : 1); k++) {
        const double from = part[k], to = part[k + 1];
        vec6 inside[GAUSS_STATIONS];
        for (int i = 0; i < GAUSS_STATIONS; i++) {
            double weight[2 * GAUSS_STATIONS];
            lie_pair_weights(from + (to - from) * gauss_point[i], weight);
            inside[i] = (vec6){{0}};
            for (int j = 0; j < 2 * GAUSS_STATIONS; j++) {
                inside[i] = vec6_add(inside[i], vec6_scale(weight[j], xi[j]));
            }
        }
        g = pose_mul(g, se3_exp(lie_step_twist((to - from) * h, inside)));
    }
    return g;
}
