// rodsolver/collocation.c
#include "rodsolver/collocation.h"

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
enum { SWEEPS = 4, TERMS = 8 };

// (1 - (t/2) cot(t/2)) / t^2 by its series, good to rounding up to t = 1 and to 1e-9 up to t = 2
static double inverse_coefficient(double t2)
{
    static const double term[TERMS] = {1.0 / 12,
                                       1.0 / 720,
                                       1.0 / 30240,
                                       1.0 / 1209600,
                                       1.0 / 47900160,
                                       691.0 / 1307674368000.0,
                                       1.0 / 74724249600.0,
                                       3617.0 / 10670622842880000.0};
    double sum = 0;
    for (int k = TERMS - 1; k >= 0; k--) {
        sum = sum * t2 + term[k];
    }
    return sum;
}

// Theta' = w + Theta x w / 2 + c Theta x (Theta x w): the inverse of the exponential's differential
static vec3 rate(vec3 theta, vec3 w)
{
    const vec3 once = vec3_cross(theta, w), twice = vec3_cross(theta, once);
    const double c = inverse_coefficient(vec3_dot(theta, theta));
    return (vec3){{w.a[0] + once.a[0] / 2 + c * twice.a[0], w.a[1] + once.a[1] / 2 + c * twice.a[1],
                   w.a[2] + once.a[2] / 2 + c * twice.a[2]}};
}

static vec3 weighted(double h, const double *b, const vec3 *f)
{
    vec3 sum;
    for (int c = 0; c < 3; c++) {
        sum.a[c] = h * (b[0] * f[0].a[c] + b[1] * f[1].a[c] + b[2] * f[2].a[c]);
    }
    return sum;
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
        stage[i] = mat3_mul(R, so3_exp(weighted(h, gauss_inner[i], f)));
    }
    *end = mat3_mul(R, so3_exp(weighted(h, gauss_weight, f)));
}
