// base/se3.h
// Rotations and rigid motions. A twist is (v, w): linear part first. docs/theory.md, section 1.
#pragma once

#include "base/dense.h"

typedef struct pose {
    mat3 R;
    vec3 p; // [m]
} pose;

pose pose_identity(void);
pose pose_mul(pose g, pose h);
pose pose_inverse(pose g);

mat3 so3_exp(vec3 w);
vec3 so3_log(mat3 r); // |w| <= pi; from a rotation, good near 0 and near pi

// exp of the twist (v, w): R = exp(hat w), p = V(w) v
pose se3_exp(vec6 twist);

// Ad(R, p) (v, w) = (R v + p x (R w), R w)
mat6 se3_adjoint(pose g);

// ad(a) b: the Lie bracket [a, b] of two twists
vec6 se3_bracket(vec6 a, vec6 b);
