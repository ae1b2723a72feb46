// reach/arc.c
#include "reach/arc.h"

#include <stdbool.h>

// Under this angle the series, which leaves a^8 / 10! there.
static const double small_angle = 1e-2;

// sin a / a
static double sinc(double a)
{
    const double q = a * a;
    return fabs(a) < small_angle ? 1 - q / 6 * (1 - q / 20 * (1 - q / 42)) : sin(a) / a;
}

// its derivative
static double sinc_slope(double a)
{
    const double q = a * a;
    return fabs(a) < small_angle ? -a / 3 * (1 - q / 10 * (1 - q / 28 * (1 - q / 54)))
                                 : (a * cos(a) - sin(a)) / q;
}

// (1 - cos a) / a = sin(a/2) sinc(a/2)
static double cosc(double a)
{
    return sin(a / 2) * sinc(a / 2);
}

static double cosc_slope(double a)
{
    return (cos(a / 2) * sinc(a / 2) + sin(a / 2) * sinc_slope(a / 2)) / 2;
}

vec3 arc_point(double length, double bend, double s)
{
    const double a = bend * s / length;
    return (vec3){{s * cosc(a), 0, s * sinc(a)}};
}

vec3 arc_derivative(double length, double bend, double s)
{
    const double a = bend * s / length, da = s / length;
    return (vec3){{s * cosc_slope(a) * da, 0, s * sinc_slope(a) * da}};
}

// --- the bend of an end

enum { BISECTIONS = 200 };
// What misses an end of a piece by this share of the length is rounding of who made the target.
static const double rounding = 1e-14;

// cosc(a) = wanted between a and b, where it is monotone; false where it is not met
static bool root_between(double wanted, double a, double b, double *root)
{
    double fa = cosc(a) - wanted;
    const double fb = cosc(b) - wanted;
    if (fmin(fabs(fa), fabs(fb)) < rounding) {
        *root = fabs(fa) < fabs(fb) ? a : b;
        return true;
    }
    if ((fa < 0) == (fb < 0)) {
        return false;
    }
    double x = (a + b) / 2;
    for (int i = 0; i < BISECTIONS && b - a > 0; i++) {
        const double f = cosc(x) - wanted, step = f / cosc_slope(x);
        if ((f < 0) == (fa < 0)) {
            a = x;
            fa = f;
        } else {
            b = x;
        }
        const double next = x - step > a && x - step < b ? x - step : (a + b) / 2;
        if (f == 0 || next == x || next == a || next == b) {
            break;
        }
        x = next;
    }
    *root = x;
    return true;
}

int arc_bends(double length, double rho, double low, double high, double bend[ARC_MOST_BENDS])
{
    static const double edge[] = {-6.283185307179586476925287, -ARC_FARTHEST_BEND, 0,
                                  ARC_FARTHEST_BEND, 6.283185307179586476925287};
    int n = 0;
    double share = rho / length;
    if (share > cosc(ARC_FARTHEST_BEND) && share < ARC_FARTHEST * (1 + rounding)) {
        share = cosc(ARC_FARTHEST_BEND);
    }
    for (int i = 0; i < 4; i++) {
        const double a = fmax(edge[i], low), b = fmin(edge[i + 1], high);
        double root;
        if (a <= b && root_between(i < 2 ? -share : share, a, b, &root) &&
            (n == 0 || root > bend[n - 1])) {
            bend[n++] = root;
        }
    }
    return n;
}
