// base/dense.c
#include "base/dense.h"

#include <math.h>

vec3 vec3_add(vec3 u, vec3 v)
{
    return (vec3){{u.a[0] + v.a[0], u.a[1] + v.a[1], u.a[2] + v.a[2]}};
}

vec3 vec3_sub(vec3 u, vec3 v)
{
    return (vec3){{u.a[0] - v.a[0], u.a[1] - v.a[1], u.a[2] - v.a[2]}};
}

vec3 vec3_scale(double c, vec3 v)
{
    return (vec3){{c * v.a[0], c * v.a[1], c * v.a[2]}};
}

vec3 vec3_cross(vec3 u, vec3 v)
{
    return (vec3){{u.a[1] * v.a[2] - u.a[2] * v.a[1], u.a[2] * v.a[0] - u.a[0] * v.a[2],
                   u.a[0] * v.a[1] - u.a[1] * v.a[0]}};
}

double vec3_dot(vec3 u, vec3 v)
{
    return u.a[0] * v.a[0] + u.a[1] * v.a[1] + u.a[2] * v.a[2];
}

double vec3_norm(vec3 v)
{
    return sqrt(vec3_dot(v, v));
}

mat3 mat3_identity(void)
{
    return (mat3){{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
}

mat3 mat3_mul(mat3 a, mat3 b)
{
    mat3 c = {0};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            c.a[i][j] = a.a[i][0] * b.a[0][j] + a.a[i][1] * b.a[1][j] + a.a[i][2] * b.a[2][j];
        }
    }
    return c;
}

mat3 mat3_transpose(mat3 a)
{
    mat3 t = {0};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            t.a[i][j] = a.a[j][i];
        }
    }
    return t;
}

vec3 mat3_mul_vec(mat3 a, vec3 v)
{
    vec3 w = {0};
    for (int i = 0; i < 3; i++) {
        w.a[i] = a.a[i][0] * v.a[0] + a.a[i][1] * v.a[1] + a.a[i][2] * v.a[2];
    }
    return w;
}

vec3 mat3_tmul_vec(mat3 a, vec3 v)
{
    vec3 w = {0};
    for (int i = 0; i < 3; i++) {
        w.a[i] = a.a[0][i] * v.a[0] + a.a[1][i] * v.a[1] + a.a[2][i] * v.a[2];
    }
    return w;
}

mat3 mat3_hat(vec3 v)
{
    return (mat3){{{0, -v.a[2], v.a[1]}, {v.a[2], 0, -v.a[0]}, {-v.a[1], v.a[0], 0}}};
}

mat3 mat3_rot_z(double angle)
{
    const double c = cos(angle), s = sin(angle);
    return (mat3){{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
}

vec6 vec6_add(vec6 u, vec6 v)
{
    for (int i = 0; i < 6; i++) {
        u.a[i] += v.a[i];
    }
    return u;
}

vec6 vec6_sub(vec6 u, vec6 v)
{
    for (int i = 0; i < 6; i++) {
        u.a[i] -= v.a[i];
    }
    return u;
}

vec6 vec6_scale(double c, vec6 v)
{
    for (int i = 0; i < 6; i++) {
        v.a[i] *= c;
    }
    return v;
}

double vec6_dot(vec6 u, vec6 v)
{
    double sum = 0;
    for (int i = 0; i < 6; i++) {
        sum += u.a[i] * v.a[i];
    }
    return sum;
}

mat6 mat6_identity(void)
{
    mat6 a = {0};
    for (int i = 0; i < 6; i++) {
        a.a[i][i] = 1;
    }
    return a;
}

mat6 mat6_add(mat6 a, mat6 b)
{
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            a.a[i][j] += b.a[i][j];
        }
    }
    return a;
}

mat6 mat6_scale(double c, mat6 a)
{
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            a.a[i][j] *= c;
        }
    }
    return a;
}

mat6 mat6_mul(mat6 a, mat6 b)
{
    mat6 c = {0};
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < 6; k++) {
            for (int j = 0; j < 6; j++) {
                c.a[i][j] += a.a[i][k] * b.a[k][j];
            }
        }
    }
    return c;
}

mat6 mat6_transpose(mat6 a)
{
    mat6 t = {0};
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            t.a[i][j] = a.a[j][i];
        }
    }
    return t;
}

mat6 mat6_symmetric(mat6 a)
{
    return mat6_scale(0.5, mat6_add(a, mat6_transpose(a)));
}

mat6 mat6_congruence(mat6 t, mat6 k)
{
    return mat6_mul(mat6_transpose(t), mat6_mul(k, t));
}

vec6 mat6_mul_vec(mat6 a, vec6 v)
{
    vec6 w = {0};
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            w.a[i] += a.a[i][j] * v.a[j];
        }
    }
    return w;
}

bool mat6_cholesky(mat6 a, mat6 *lower)
{
    mat6 l = {0};
    for (int j = 0; j < 6; j++) {
        double d = a.a[j][j];
        for (int k = 0; k < j; k++) {
            d -= l.a[j][k] * l.a[j][k];
        }
        if (!(d > 0)) {
            return false;
        }
        l.a[j][j] = sqrt(d);
        for (int i = j + 1; i < 6; i++) {
            double c = a.a[i][j];
            for (int k = 0; k < j; k++) {
                c -= l.a[i][k] * l.a[j][k];
            }
            l.a[i][j] = c / l.a[j][j];
        }
    }
    *lower = l;
    return true;
}

vec6 mat6_cholesky_solve(const mat6 *lower, vec6 b)
{
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < i; k++) {
            b.a[i] -= lower->a[i][k] * b.a[k];
        }
        b.a[i] /= lower->a[i][i];
    }
    for (int i = 5; i >= 0; i--) {
        for (int k = i + 1; k < 6; k++) {
            b.a[i] -= lower->a[k][i] * b.a[k];
        }
        b.a[i] /= lower->a[i][i];
    }
    return b;
}

bool mat6_inverse_spd(mat6 a, mat6 *inverse)
{
    double scale[6];
    for (int i = 0; i < 6; i++) {
        if (!(a.a[i][i] > 0) || !isfinite(a.a[i][i])) {
            return false;
        }
        scale[i] = 1 / sqrt(a.a[i][i]);
    }
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            a.a[i][j] *= scale[i] * scale[j];
        }
    }
    mat6 lower;
    if (!mat6_cholesky(a, &lower)) {
        return false;
    }
    for (int j = 0; j < 6; j++) {
        vec6 unit = {0};
        unit.a[j] = 1;
        const vec6 column = mat6_cholesky_solve(&lower, unit);
        for (int i = 0; i < 6; i++) {
            inverse->a[i][j] = column.a[i] * scale[i] * scale[j];
        }
    }
    *inverse = mat6_symmetric(*inverse);
    return true;
}

double mat6_relative_error(mat6 a, mat6 b)
{
    double worst = 0;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            const double e = fabs(a.a[i][j] - b.a[i][j]) / sqrt(fabs(b.a[i][i] * b.a[j][j]));
            // written so that a NaN wins
            worst = isnan(worst) || e <= worst ? worst : e;
        }
    }
    return worst;
}
