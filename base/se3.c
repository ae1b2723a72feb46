// base/se3.c
#include "base/se3.h"

#include <math.h>

pose pose_identity(void)
{
    return (pose){.R = mat3_identity()};
}

pose pose_mul(pose g, pose h)
{
    return (pose){.R = mat3_mul(g.R, h.R), .p = vec3_add(g.p, mat3_mul_vec(g.R, h.p))};
}

pose pose_inverse(pose g)
{
    return (pose){.R = mat3_transpose(g.R), .p = vec3_scale(-1, mat3_tmul_vec(g.R, g.p))};
}

// sin t / t, (1 - cos t) / t^2 and (t - sin t) / t^3, by series where the quotients cancel
static void exp_coefficients(double t2, double *a, double *b, double *c)
{
    if (t2 < 0.0625) {
        // seven terms: the first left out is below 1e-17 for t < 1/4
        double term = 1, sum_a = 0, sum_b = 0, sum_c = 0;
        for (int k = 0; k < 7; k++) {
            const double n = 2.0 * k;
            sum_a += term / (n + 1);
            sum_b += term / ((n + 1) * (n + 2));
            sum_c += term / ((n + 1) * (n + 2) * (n + 3));
            term *= -t2 / ((n + 1) * (n + 2));
        }
        *a = sum_a;
        *b = sum_b;
        *c = sum_c;
        return;
    }
    const double t = sqrt(t2);
    *a = sin(t) / t;
    *b = (1 - cos(t)) / t2;
    *c = (t - sin(t)) / (t2 * t);
}

// I + a hat(w) + b hat(w)^2
static mat3 hat_polynomial(vec3 w, double a, double b)
{
    const double t2 = vec3_dot(w, w);
    const mat3 h = mat3_hat(w);
    mat3 r;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const double square = w.a[i] * w.a[j] - (i == j ? t2 : 0);
            r.a[i][j] = (i == j ? 1 : 0) + a * h.a[i][j] + b * square;
        }
    }
    return r;
}

mat3 so3_exp(vec3 w)
{
    double a, b, c;
    exp_coefficients(vec3_dot(w, w), &a, &b, &c);
    return hat_polynomial(w, a, b);
}

pose se3_exp(vec6 twist)
{
    const vec3 v = {{twist.a[0], twist.a[1], twist.a[2]}};
    const vec3 w = {{twist.a[3], twist.a[4], twist.a[5]}};
    double a, b, c;
    exp_coefficients(vec3_dot(w, w), &a, &b, &c);
    return (pose){.R = hat_polynomial(w, a, b), .p = mat3_mul_vec(hat_polynomial(w, b, c), v)};
}

vec3 so3_log(mat3 r)
{
    const double m[3][3] = {{r.a[0][0], r.a[0][1], r.a[0][2]},
                            {r.a[1][0], r.a[1][1], r.a[1][2]},
                            {r.a[2][0], r.a[2][1], r.a[2][2]}};
    // the unit quaternion from its largest component, which never cancels
    const double trace = m[0][0] + m[1][1] + m[2][2];
    double q[4];
    int k = 0;
    for (int i = 1; i < 3; i++) {
        k = m[i][i] > m[k][k] ? i : k;
    }
    if (trace > m[k][k]) {
        q[0] = 1 + trace;
        q[1] = m[2][1] - m[1][2];
        q[2] = m[0][2] - m[2][0];
        q[3] = m[1][0] - m[0][1];
    } else {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        q[0] = m[j][i] - m[i][j];
        q[1 + k] = 1 + m[k][k] - m[i][i] - m[j][j];
        q[1 + i] = m[i][k] + m[k][i];
        q[1 + j] = m[j][k] + m[k][j];
    }
    const double sign = q[0] < 0 ? -1 : 1;
    const vec3 axis = {{sign * q[1], sign * q[2], sign * q[3]}};
    const double sine = vec3_norm(axis);
    // atan2(sine, cosine) / sine -> 1 / cosine
    const double ratio = sine > 0 ? 2 * atan2(sine, fabs(q[0])) / sine : 0;
    return vec3_scale(ratio, axis);
}

mat6 se3_adjoint(pose g)
{
    const mat3 pr = mat3_mul(mat3_hat(g.p), g.R);
    mat6 ad = {0};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            ad.a[i][j] = g.R.a[i][j];
            ad.a[i][j + 3] = pr.a[i][j];
            ad.a[i + 3][j + 3] = g.R.a[i][j];
        }
    }
    return ad;
}

vec6 se3_bracket(vec6 a, vec6 b)
{
    const vec3 va = {{a.a[0], a.a[1], a.a[2]}}, wa = {{a.a[3], a.a[4], a.a[5]}};
    const vec3 vb = {{b.a[0], b.a[1], b.a[2]}}, wb = {{b.a[3], b.a[4], b.a[5]}};
    const vec3 v = vec3_add(vec3_cross(wa, vb), vec3_cross(va, wb));
    const vec3 w = vec3_cross(wa, wb);
    return (vec6){{v.a[0], v.a[1], v.a[2], w.a[0], w.a[1], w.a[2]}};
}
