// base/dense.h
// Small vectors and matrices as values: pass, return and assign them.
// Matrices are stored by rows: a[row][column].
#pragma once

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

vec3 vec3_add(vec3 u, vec3 v);
vec3 vec3_sub(vec3 u, vec3 v);
vec3 vec3_scale(double c, vec3 v);
vec3 vec3_cross(vec3 u, vec3 v);
double vec3_dot(vec3 u, vec3 v);
double vec3_norm(vec3 v);

mat3 mat3_identity(void);
mat3 mat3_mul(mat3 a, mat3 b);
mat3 mat3_transpose(mat3 a);
vec3 mat3_mul_vec(mat3 a, vec3 v);
vec3 mat3_tmul_vec(mat3 a, vec3 v); // a^T v
mat3 mat3_hat(vec3 v);              // hat(v) w = v x w
mat3 mat3_rot_z(double angle);

vec6 vec6_add(vec6 u, vec6 v);
vec6 vec6_sub(vec6 u, vec6 v);
vec6 vec6_scale(double c, vec6 v);
double vec6_dot(vec6 u, vec6 v);

mat6 mat6_identity(void);
mat6 mat6_add(mat6 a, mat6 b);
mat6 mat6_scale(double c, mat6 a);
mat6 mat6_mul(mat6 a, mat6 b);
mat6 mat6_transpose(mat6 a);
mat6 mat6_symmetric(mat6 a);          // (a + a^T) / 2
mat6 mat6_congruence(mat6 t, mat6 k); // t^T k t
vec6 mat6_mul_vec(mat6 a, vec6 v);

// Cholesky of a symmetric positive definite matrix, lower triangle; false when it is not.
bool mat6_cholesky(mat6 a, mat6 *lower);
vec6 mat6_cholesky_solve(const mat6 *lower, vec6 b);

// Inverse of a symmetric positive definite matrix, scaled to unit diagonal first so that N and N m
// mix safely; false when it is not positive definite to rounding.
bool mat6_inverse_spd(mat6 a, mat6 *inverse);

// max |a - b|_ij / sqrt(b_ii b_jj): the project's relative error of a stiffness or compliance
// (theory, section 6).
double mat6_relative_error(mat6 a, mat6 b);
