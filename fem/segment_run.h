// fem/segment_run.h
// One column solved: the displacements for six unit wrenches on the tip, and what the middle of the
// segment says.
#pragma once

#include "base/beam_law.h"
#include "fem/petsc_door.h"
#include "fem/section_fit.h"
#include "fem/segment.h"

typedef struct segment_run {
    int nsolution; // six unit wrenches at the origin of the tip; with a uniform tip three uniform
                   // unit forces follow
    int nplane, nlevel, dofs;
    double *u;    // [nsolution][nlevel][nplane][3] [m per N or N m]
    vec6 *motion; // [nsolution][nlevel] E-weighted fits of the sections
    section_fit by_E, by_area;
    double residual;
    double assemble_seconds, factor_seconds, solve_seconds;
} segment_run;

status segment_run_make(const petsc_door *door, const column *c, int base, int tip,
                        segment_run *out);
void segment_run_free(segment_run *run);

static inline const double *segment_run_level(const segment_run *run, int solution, int level)
{
    const size_t n = 3 * (size_t)run->nplane;
    return run->u + ((size_t)solution * (size_t)run->nlevel + (size_t)level) * n;
}

// Motion of the tip by solution, columns for the six unit wrenches.
mat6 segment_run_compliance(const segment_run *run);

// Strain energy of unit solutions i and j is U[i][j] / 2; three by three for the uniform forces of
// a uniform tip.
void segment_run_uniform_work(const segment_run *run, double (*work)[3]);

// --- fem/middle.c: the middle of the segment

typedef struct middle {
    double curvature[9][2];     // (kappa_x, kappa_y) of each solution [1/m per N or N m]
    double stiffness_centre[2]; // [m]
} middle;

status middle_make(const column *c, const segment_run *run, middle *out);
