// rodsolver/collocation.c
#include "rodsolver/collocation.h"

#include <math.h>

#define ROOT_15 3.87298334620741688518

const double gauss_inner[GAUSS_STATIONS][GAUSS_STATIONS] = {
    {5.0 / 36, 2.0 / 9 - ROOT_15 / 15, 5.0 / 36 - ROOT_15 / 30},
    {5.0 / 36 + ROOT_15 / 24, 2.0 / 9, 5.0 / 36 - ROOT_15 / 24},
    {5.0 / 36 + ROOT_15 / 30, 2.0 / 9 + ROOT_15 / 15, 5.0 / 36},
};

const double gauss_outer[GAUSS_STATIONS][GAUSS_STATIONS] = {
    {5.0 / 36, 2.0 / 9 + ROOT_15 / 15, 5.0 / 36 + ROOT_15 / 30},
    {5.0 / 36 - ROOT_15 / 24, 2.0 / 9, 5.0 / 36 + ROOT_15 / 24},
    {5.0 / 36 - ROOT_15 / 30, 2.0 / 9 - ROOT_15 / 15, 5.0 / 36},
};

// Each sweep of the fixed-point iteration gains one order; the first guess leaves h^3, so that four
// leave less than the collocation's own h^7
enum { SWEEPS = 4 };

// (1 - (t/2) cot(t/2)) / t^2 by its series, good to 1e-13 up to t = 1 and to 1e-8 up to t = 2
static inline double inverse_coefficient(double x)
{
    return 1.0 / 12 +
           x * (1.0 / 720 +
                x * (1.0 / 30240 +
                     x * (1.0 / 1209600 + x * (1.0 / 47900160 + x * (691.0 / 1307674368000.0 +
                                                                     x * (1.0 / 74724249600.0))))));
}

// Theta' = w + Theta x w / 2 + c Theta x (Theta x w): the inverse of the exponential's differential
static inline vec3 rate(vec3 theta, vec3 w)
{
    const vec3 once = vec3_cross(theta, w), twice = vec3_cross(theta, once);
    const double c = inverse_coefficient(vec3_dot(theta, theta));
    return (vec3){{w.a[0] + once.a[0] / 2 + c * twice.a[0], w.a[1] + once.a[1] / 2 + c * twice.a[1],
                   w.a[2] + once.a[2] / 2 + c * twice.a[2]}};
}

static inline vec3 weighted(double h, const double *b, const vec3 *f)
{
    vec3 sum;
    for (int c = 0; c < 3; c++) {
        sum.a[c] = h * (b[0] * f[0].a[c] + b[1] * f[1].a[c] + b[2] * f[2].a[c]);
    }
    return sum;
}

// I + a hat(w) + b hat(w)^2 with a = sin t / t, b = (1 - cos t) / t^2, by their series where
// they are good to rounding
static inline mat3 turn(vec3 w)
{
    static const double odd[] = {1.0 / 1.0,
                                 -1.0 / 6.0,
                                 1.0 / 120.0,
                                 -1.0 / 5040.0,
                                 1.0 / 362880.0,
                                 -1.0 / 39916800.0,
                                 1.0 / 6227020800.0,
                                 -1.0 / 1307674368000.0,
                                 1.0 / 355687428096000.0};
    static const double even[] = {1.0 / 2.0,
                                  -1.0 / 24.0,
                                  1.0 / 720.0,
                                  -1.0 / 40320.0,
                                  1.0 / 3628800.0,
                                  -1.0 / 479001600.0,
                                  1.0 / 87178291200.0,
                                  -1.0 / 20922789888000.0,
                                  1.0 / 6402373705728000.0};
    const double x = vec3_dot(w, w);
    double a, b;
    if (x < 1) {
        a = odd[8];
        b = even[8];
        for (int k = 7; k >= 0; k--) {
            a = odd[k] + x * a;
            b = even[k] + x * b;
        }
    } else {
        const double t = sqrt(x);
        a = sin(t) / t;
        b = (1 - cos(t)) / x;
    }
    const double p = w.a[0], q = w.a[1], r = w.a[2];
    return (mat3){{{1 - b * (q * q + r * r), b * p * q - a * r, b * p * r + a * q},
                   {b * p * q + a * r, 1 - b * (p * p + r * r), b * q * r - a * p},
                   {b * p * r - a * q, b * q * r + a * p, 1 - b * (p * p + q * q)}}};
}

void collocate_rotation(double h, mat3 R, const vec3 w[GAUSS_STATIONS], mat3 stage[GAUSS_STATIONS],
                        mat3 *end)
{
    vec3 theta[GAUSS_STATIONS], f[GAUSS_STATIONS];
    for (int i = 0; i < GAUSS_STATIONS; i++) {
        f[i] = w[i];
    }
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
        for (int i = 0; i < GAUSS_STATIONS; i++) {
            theta[i] = weighted(h, gauss_inner[i], f);
        }
        for (int i = 0; i < GAUSS_STATIONS; i++) {
            f[i] = rate(theta[i], w[i]);
        }
    }
    for (int i = 0; i < GAUSS_STATIONS; i++) {
        stage[i] = mat3_mul(R, turn(weighted(h, gauss_inner[i], f)));
    }
    *end = mat3_mul(R, turn(weighted(h, gauss_weight, f)));
}
