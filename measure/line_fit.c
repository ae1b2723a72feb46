// measure/line_fit.c
#include "measure/line_fit.h"

// Monic polynomials q_0 = 1, q_1 = x - a, q_2 = (x - b) q_1 - c, orthogonal over the places; x is
// s less `at`, over the largest of them.
typedef struct basis {
    int n, degree;
    double at, scale; // x = (s - at) / scale
    double a, b, c, norm[3];
} basis;

static double value(const basis *q, int k, double x)
{
    return k == 0 ? 1 : k == 1 ? x - q->a : (x - q->b) * (x - q->a) - q->c;
}

static basis basis_over(int n, const double *s, double at)
{
    basis q = {.n = n, .degree = n > 2 ? 2 : n - 1, .at = at};
    double top = 0;
    for (int i = 0; i < n; i++) {
        q.scale = fmax(q.scale, fabs(s[i] - at));
    }
    for (int i = 0; i < n; i++) {
        q.a += (s[i] - at) / q.scale / n;
    }
    q.norm[0] = n;
    for (int i = 0; i < n; i++) {
        const double x = (s[i] - at) / q.scale, v = x - q.a;
        q.norm[1] += v * v;
        top += x * v * v;
    }
    q.b = top / q.norm[1];
    q.c = q.norm[1] / q.norm[0];
    for (int i = 0; i < n; i++) {
        const double v = value(&q, 2, (s[i] - at) / q.scale);
        q.norm[2] += v * v;
    }
    return q;
}

line_fit line_fit_at(int n, const double *s, const vec3 *p, double at)
{
    const basis q = basis_over(n, s, at);
    vec3 c[3] = {{{0}}};
    for (int i = 0; i < n; i++) {
        for (int k = 0; k <= q.degree; k++) {
            c[k] = vec3_add_scaled(c[k], value(&q, k, (s[i] - at) / q.scale) / q.norm[k], p[i]);
        }
    }
    line_fit f = {.place = c[0]};
    f.place = vec3_add_scaled(f.place, value(&q, 1, 0), c[1]);
    f.place = vec3_add_scaled(f.place, value(&q, 2, 0), c[2]);
    f.slope = vec3_scale(1 / q.scale, vec3_add_scaled(c[1], -q.a - q.b, c[2]));
    f.bend = vec3_scale(2 / (q.scale * q.scale), c[2]);
    return f;
}

void line_fit_slope_weights(int n, const double *s, double at, double *weight)
{
    const basis q = basis_over(n, s, at);
    for (int i = 0; i < n; i++) {
        const double x = (s[i] - at) / q.scale;
        weight[i] = value(&q, 1, x) / q.norm[1];
        weight[i] += q.degree > 1 ? (-q.a - q.b) * value(&q, 2, x) / q.norm[2] : 0;
        weight[i] /= q.scale;
    }
}

void line_fit_bend_weights(int n, const double *s, double at, double *weight)
{
    const basis q = basis_over(n, s, at);
    for (int i = 0; i < n; i++) {
        weight[i] = 2 / (q.scale * q.scale) * value(&q, 2, (s[i] - at) / q.scale) / q.norm[2];
    }
}

// neighbours hand on what came before: e_i = r e_(i-1) + ..., so one walk along the line will do
double correlated_variance(int n, const double *s, const vec3 *part, double length)
{
    double sum = 0;
    vec3 before = {{0, 0, 0}};
    for (int i = 0; i < n; i++) {
        if (i > 0 && length > 0) {
            before =
                vec3_scale(exp(-fabs(s[i] - s[i - 1]) / length), vec3_add(before, part[i - 1]));
        }
        sum += vec3_dot(part[i], part[i]) + 2 * vec3_dot(part[i], before);
    }
    return sum;
}
