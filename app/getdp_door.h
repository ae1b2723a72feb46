// app/getdp_door.h
// GetDP as a child process: an outside finite element program that solves torsion and plane strain
// on a mesh of ours. Nothing of it is linked; files are exchanged in a private directory that is
// removed again.
#pragma once

#include "base/dense.h"
#include "base/material.h"
#include "base/mesh.h"
#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

// Path of the program; false where it is not installed.
bool getdp_find(char *path, size_t size);

// "3.2.0"; ERR_RESOURCE where it cannot be run.
status getdp_version(char *text, size_t size);

// GJ = min over w of int G |grad w + (-y, x)|^2 by scalar order-2 (order 1: order-1) triangles on
// the elements of `plane`, quadrilaterals cut in two. Right for the warping problem where all
// Poisson's ratios are equal. [N m^2] ERR_RESOURCE: not installed, out of time; ERR_NUMERIC: no
// result; ERR_INTERRUPTED.
status getdp_torsion(const mesh *plane, int nmaterial, const material *materials, double *GJ);

// The block [[EA, ESx, -ESy], [ESx, EIxx, -EIxy], [-ESy, -EIxy, EIyy]] of a section free to deform
// in its plane: generalized plane strain (6.4) under the axial strains 1, y and -x, for any
// Poisson's ratios, isotropic materials; elements and failures as getdp_torsion. [N, N m, N m^2]
status getdp_axial_bending(const mesh *plane, int nmaterial, const material *materials, mat3 *out);
