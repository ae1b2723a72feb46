// app/getdp_files.h
// The files that GetDP reads: the mesh in MSH 2.2 (mm) and a problem on it (N, mm).
#pragma once

#include "base/material.h"
#include "base/mesh.h"

#include <stdio.h>

// Triangles of order 1 or 2 on a plane mesh of that order; quadrilaterals are cut along a diagonal.
// Region = material + 1; region GETDP_PIN is the first node, GETDP_FAR_PIN the one farthest from
// it.
enum { GETDP_PIN = 100000, GETDP_FAR_PIN };
void getdp_write_mesh(const mesh *plane, FILE *file);

// The warping of torsion, held at 0 at the pin; the answer is gj.txt [N mm^2].
void getdp_write_torsion(int nmaterial, const material *materials, FILE *file);

// The plane displacement under the axial strains 1, y and -x, held at the pins; the answers are
// k00.txt to k22.txt [N, N mm, N mm^2]. Isotropic materials.
void getdp_write_plane(const mesh *plane, int nmaterial, const material *materials, FILE *file);
