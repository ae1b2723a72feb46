// base/chebyshev.c
#include "base/chebyshev.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

double chebyshev_node(int n, int i)
{
    // as a sine the nodes are symmetric to the last bit
    return n > 1 ? sin(pi * (2 * i - (n - 1)) / (2.0 * (n - 1))) : 0;
}

// barycentric weight of node i
static double weight(int n, int i)
{
    const double sign = i % 2 ? -1 : 1;
    return i == 0 || i == n - 1 ? 0.5 * sign : sign;
}

static void cardinal_values(int n, double t, double *value)
{
    double sum = 0;
    for (int i = 0; i < n; i++) {
        const double d = t - chebyshev_node(n, i);
        if (d == 0) {
            for (int j = 0; j < n; j++) {
                value[j] = j == i;
            }
            return;
        }
        value[i] = weight(n, i) / d;
        sum += value[i];
    }
    for (int i = 0; i < n; i++) {
        value[i] /= sum;
    }
}

// by the differentiation matrix, whose rows sum to zero: its diagonal is minus the rest
static void cardinal_slopes(int n, const double *value, double *slope)
{
    // t_i - t_j = 2 sin(a (i + j)) sin(a (i - j)) does not cancel
    double sine[2 * CHEBYSHEV_MAX_NODES];
    for (int k = 0; k < 2 * n - 1; k++) {
        sine[k] = sin(pi * k / (2.0 * (n - 1)));
    }
    for (int j = 0; j < n; j++) {
        slope[j] = 0;
    }
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < i; j++) {
            const double ratio = weight(n, j) / weight(n, i);
            const double inverse = 1 / (2 * sine[i + j] * sine[i - j]);
            slope[j] += value[i] * ratio * inverse;
            slope[i] -= value[i] * ratio * inverse;
            slope[i] -= value[j] / ratio * inverse;
            slope[j] += value[j] / ratio * inverse;
        }
    }
}

void chebyshev_weights(int n, double t, double *value, double *slope)
{
    if (n == 1) {
        value[0] = 1;
        if (slope) {
            slope[0] = 0;
        }
        return;
    }
    cardinal_values(n, t, value);
    if (!slope) {
        return;
    }
    cardinal_slopes(n, value, slope);
}

void chebyshev_coefficients(int n, const double *at_node, double *coefficient)
{
    if (n == 1) {
        coefficient[0] = at_node[0];
        return;
    }
    for (int k = 0; k < n; k++) {
        double sum = 0;
        for (int i = 0; i < n; i++) {
            // T_k(t_i) = cos(k arccos t_i) with t_i = cos(pi - pi i / (n - 1))
            const double half = i == 0 || i == n - 1 ? 0.5 : 1;
            sum += half * at_node[i] * cos(pi * k * (n - 1 - i) / (n - 1));
        }
        coefficient[k] = sum * (k == 0 || k == n - 1 ? 1.0 : 2.0) / (n - 1);
    }
}
