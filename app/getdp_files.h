// app/getdp_files.h
// The two files that GetDP reads: the mesh in MSH 2.2 (mm) and the torsion problem (N, mm).
#pragma once

#include "base/material.h"
#include "base/mesh.h"

#include <stdio.h>

// Triangles of order 1 or 2 on a plane mesh of that order; quadrilaterals are cut along a diagonal.
// Region = material + 1; region GETDP_PIN is the first node, where the warping is held at 0.
enum { GETDP_PIN = 100000 };
void getdp_write_mesh(const mesh *plane, FILE *file);

void getdp_write_problem(int nmaterial, const material *materials, FILE *file);
