// base/dense.h
// Small vectors and matrices as values: pass, return and assign them.
// Matrices are stored by rows: a[row][column].
#pragma once

#include <math.h>
#include <stdbool.h>

typedef struct vec3 {
    double a[3];
} vec3;

typedef struct vec6 {
    double a[6];
} vec6;

typedef struct mat3 {
    double a[3][3];
} mat3;

typedef struct mat6 {
    double a[6][6];
} mat6;

// --- small enough to be written out where they are used

static inline vec3 vec3_add(vec3 u, vec3 v)
{
    return (vec3){{u.a[0] + v.a[0], u.a[1] + v.a[1], u.a[2] + v.a[2]}};
}

static inline vec3 vec3_sub(vec3 u, vec3 v)
{
    return (vec3){{u.a[0] - v.a[0], u.a[1] - v.a[1], u.a[2] - v.a[2]}};
}

static inline vec3 vec3_scale(double c, vec3 v)
{
    return (vec3){{c * v.a[0], c * v.a[1], c * v.a[2]}};
}

// u + c v
static inline vec3 vec3_add_scaled(vec3 u, double c, vec3 v)
{
    return (vec3){{u.a[0] + c * v.a[0], u.a[1] + c * v.a[1], u.a[2] + c * v.a[2]}};
}

static inline vec3 vec3_cross(vec3 u, vec3 v)
{
    return (vec3){{u.a[1] * v.a[2] - u.a[2] * v.a[1], u.a[2] * v.a[0] - u.a[0] * v.a[2],
                   u.a[0] * v.a[1] - u.a[1] * v.a[0]}};
}

static inline double vec3_dot(vec3 u, vec3 v)
{
    return u.a[0] * v.a[0] + u.a[1] * v.a[1] + u.a[2] * v.a[2];
}

static inline double vec3_norm(vec3 v)
{
    return sqrt(vec3_dot(v, v));
}

static inline mat3 mat3_identity(void)
{
    return (mat3){{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
}

static inline mat3 mat3_mul(mat3 a, mat3 b)
{
    mat3 c = {0};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            c.a[i][j] = a.a[i][0] * b.a[0][j] + a.a[i][1] * b.a[1][j] + a.a[i][2] * b.a[2][j];
        }
    }
    return c;
}

static inline mat3 mat3_transpose(mat3 a)
{
    mat3 t = {0};
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            t.a[i][j] = a.a[j][i];
        }
    }
    return t;
}

static inline vec3 mat3_mul_vec(mat3 a, vec3 v)
{
    vec3 w = {0};
    for (int i = 0; i < 3; i++) {
        w.a[i] = a.a[i][0] * v.a[0] + a.a[i][1] * v.a[1] + a.a[i][2] * v.a[2];
    }
    return w;
}

// a^T v
static inline vec3 mat3_tmul_vec(mat3 a, vec3 v)
{
    vec3 w = {0};
    for (int i = 0; i < 3; i++) {
        w.a[i] = a.a[0][i] * v.a[0] + a.a[1][i] * v.a[1] + a.a[2][i] * v.a[2];
    }
    return w;
}

// hat(v) w = v x w
static inline mat3 mat3_hat(vec3 v)
{
    return (mat3){{{0, -v.a[2], v.a[1]}, {v.a[2], 0, -v.a[0]}, {-v.a[1], v.a[0], 0}}};
}

static inline mat3 mat3_rot_z(double angle)
{
    const double c = cos(angle), s = sin(angle);
    return (mat3){{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
}

static inline vec6 vec6_add(vec6 u, vec6 v)
{
    for (int i = 0; i < 6; i++) {
        u.a[i] += v.a[i];
    }
    return u;
}

static inline vec6 vec6_sub(vec6 u, vec6 v)
{
    for (int i = 0; i < 6; i++) {
        u.a[i] -= v.a[i];
    }
    return u;
}

static inline vec6 vec6_scale(double c, vec6 v)
{
    for (int i = 0; i < 6; i++) {
        v.a[i] *= c;
    }
    return v;
}

// its first three entries, and its last
static inline vec3 vec6_linear(vec6 u)
{
    return (vec3){{u.a[0], u.a[1], u.a[2]}};
}

static inline vec3 vec6_angular(vec6 u)
{
    return (vec3){{u.a[3], u.a[4], u.a[5]}};
}

static inline double vec6_dot(vec6 u, vec6 v)
{
    double sum = 0;
    for (int i = 0; i < 6; i++) {
        sum += u.a[i] * v.a[i];
    }
    return sum;
}

static inline vec6 mat6_mul_vec(mat6 a, vec6 v)
{
    vec6 w = {0};
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            w.a[i] += a.a[i][j] * v.a[j];
        }
    }
    return w;
}

// --- 6x6

mat6 mat6_identity(void);
mat6 mat6_add(mat6 a, mat6 b);
mat6 mat6_scale(double c, mat6 a);
mat6 mat6_mul(mat6 a, mat6 b);
mat6 mat6_transpose(mat6 a);
mat6 mat6_symmetric(mat6 a);          // (a + a^T) / 2
mat6 mat6_congruence(mat6 t, mat6 k); // t^T k t

// Cholesky of a symmetric positive definite matrix, lower triangle; false when it is not.
bool mat6_cholesky(mat6 a, mat6 *lower);
vec6 mat6_cholesky_solve(const mat6 *lower, vec6 b);

// Inverse of a symmetric positive definite matrix, scaled to unit diagonal first so that N and N m
// mix safely; false when it is not positive definite to rounding.
bool mat6_inverse_spd(mat6 a, mat6 *inverse);

// max |a - b|_ij / sqrt(b_ii b_jj): the project's relative error of a stiffness or compliance
// (theory, section 6).
double mat6_relative_error(mat6 a, mat6 b);
