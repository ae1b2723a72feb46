// tests/verify/rodsolver/elliptic.h
// Elliptic integrals by Carlson's forms and Jacobi's functions by the arithmetic-geometric mean:
// Carlson, Numerical Algorithms 10 (1995); Abramowitz and Stegun 16.4, 17.6.
#pragma once

#include <math.h>

// R_F(x, y, z) = 1/2 int_0^inf dt / sqrt((t + x) (t + y) (t + z))
static inline double carlson_rf(double x, double y, double z)
{
    for (int i = 0; i < 60; i++) {
        const double mean = (x + y + z) / 3;
        const double X = 1 - x / mean, Y = 1 - y / mean, Z = 1 - z / mean;
        if (fmax(fabs(X), fmax(fabs(Y), fabs(Z))) < 1e-3) {
            const double e2 = X * Y - Z * Z, e3 = X * Y * Z;
            // the next terms are of order 6 in X, Y, Z
            return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / sqrt(mean);
        }
        const double l = sqrt(x * y) + sqrt(y * z) + sqrt(z * x);
        x = (x + l) / 4;
        y = (y + l) / 4;
        z = (z + l) / 4;
    }
    return NAN;
}

// R_D(x, y, z) = 3/2 int_0^inf dt / (sqrt((t + x) (t + y)) (t + z)^(3/2))
static inline double carlson_rd(double x, double y, double z)
{
    double sum = 0, power = 1;
    for (int i = 0; i < 60; i++) {
        const double mean = (x + y + 3 * z) / 5;
        const double X = 1 - x / mean, Y = 1 - y / mean, Z = -(X + Y) / 3;
        if (fmax(fabs(X), fmax(fabs(Y), fabs(Z))) < 1e-3) {
            const double e2 = X * Y - 6 * Z * Z, e3 = (3 * X * Y - 8 * Z * Z) * Z;
            const double e4 = 3 * (X * Y - Z * Z) * Z * Z, e5 = X * Y * Z * Z * Z;
            const double series = 1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 -
                                  9 * e2 * e3 / 52 + 3 * e5 / 26;
            return 3 * sum + power * series / (mean * sqrt(mean));
        }
        const double l = sqrt(x * y) + sqrt(y * z) + sqrt(z * x);
        sum += power / (sqrt(z) * (z + l));
        power /= 4;
        x = (x + l) / 4;
        y = (y + l) / 4;
        z = (z + l) / 4;
    }
    return NAN;
}

// Legendre's F(phi, k) and E(phi, k), |phi| <= pi/2
static inline double legendre_f(double phi, double k)
{
    const double s = sin(phi), c = cos(phi);
    return s * carlson_rf(c * c, 1 - k * k * s * s, 1);
}

static inline double legendre_e(double phi, double k)
{
    const double s = sin(phi), c = cos(phi), q = 1 - k * k * s * s;
    return s * carlson_rf(c * c, q, 1) - k * k * s * s * s * carlson_rd(c * c, q, 1) / 3;
}

typedef struct jacobi {
    double sn, cn, dn;
    double am;      // the amplitude, continuous in u
    double epsilon; // E(am u, k) = int_0^u dn^2
    double K, E;    // complete integrals
} jacobi;

// k in (0, 1)
static inline jacobi jacobi_functions(double u, double k)
{
    double a[32] = {1}, c[32] = {k}, b = sqrt((1 - k) * (1 + k)), sum = k * k / 2, power = 1;
    int n = 0;
    while (n < 31 && c[n] > 1e-17 * a[n]) {
        a[n + 1] = (a[n] + b) / 2;
        c[n + 1] = (a[n] - b) / 2;
        b = sqrt(a[n] * b);
        n++;
        sum += power * c[n] * c[n];
        power *= 2;
    }
    jacobi j = {.K = 1.57079632679489661923 / a[n]};
    j.E = j.K * (1 - sum);
    double phi = ldexp(a[n] * u, n), zeta = 0;
    for (int i = n; i > 0; i--) {
        zeta += c[i] * sin(phi);
        phi = (phi + asin(c[i] / a[i] * sin(phi))) / 2;
    }
    j.am = phi;
    j.sn = sin(phi);
    j.cn = cos(phi);
    j.dn = sqrt(1 - k * k * j.sn * j.sn);
    j.epsilon = j.E / j.K * u + zeta;
    return j;
}
