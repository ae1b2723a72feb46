// fem/segment.h
// The 3D segment: an extruded section, linear elastic, fixed at its base, loaded at its tip.
// docs/theory.md, section 5.
#pragma once

#include "base/beam_law.h"
#include "base/key.h"
#include "base/material.h"
#include "base/mesh.h"
#include "base/status.h"
#include "fem/load.h"

typedef struct segment_load {
    mark at;
    const char *name;
    double force[3];  // on the tip [N]
    double moment[3]; // [N m], about the point where the force acts
    key_rows point;   // at_mm: [x, y] in one row; not given: geometric centre
    int at_kind; // at: 0 geometric_centre, 1 stiffness_centre (of the section analysis); -1 not
                 // given: 0
} segment_load;

typedef struct segment_case {
    mark at;
    double length;     // [m]
    int base, tip;     // segment_base, segment_tip
    int order;         // of the 3D elements, 1..4
    int layers;        // along z; 0: chosen
    double grading;    // middle layer over end layer; 0: chosen
    double size;       // in-plane edge length [m]; 0: chosen
    double section_at; // arclength of the section that is extruded [m]
    key_list loads;    // of segment_load
} segment_case;

extern const key_table segment_keys; // `fem`
segment_case segment_case_default(void);

// Contradictions that the table cannot see; *where is the place of the key at fault. ERR_INPUT with
// words without a place.
status segment_case_check(const segment_case *c, mark *where);

// The case with every 0 of order, layers, grading and size filled in for a section that a circle of
// `radius` about the origin holds [m]: cubic elements, layers fine at both ends and long in the
// middle. Call before meshing.
segment_case segment_choose(const segment_case *c, double radius);

// ERR_RESOURCE where a plane mesh of nplane nodes gives more unknowns than one process can number
// and hold; the case is as segment_choose left it. Call before extruding.
status segment_check_size(const segment_case *c, int nplane);

// The rank under mpirun, 0 without it, from the environment alone: MPI is not started. Only rank 0
// should print or save.
int segment_rank(void);

// What the mesh side hands over: an extruded mesh and its plane mesh (base/mesh.h; node = plane
// node + nplane * level).
typedef struct segment_model {
    const mesh *plane;
    const mesh *solid;
    int nlevel;
    const double *level; // [nlevel] z [m]
    const material *materials;
    int base, tip;
} segment_model;

typedef struct segment_load_result {
    const char *name;
    double point[2];            // where the force acted [m]; the area's centroid with a uniform tip
    double force[3];            // on the tip [N]
    double moment[3];           // about that point [N m]
    double shortening;          // E-weighted mean of -u_z over the tip [m]
    double tip_displacement[3]; // of the E-weighted fit, at the geometric centre [m]
    double tip_rotation[3];     // E-weighted least squares over the tip [rad]
    double mid_curvature[2];    // (kappa_x, kappa_y) over the middle of the segment [1/m]
    double strain_energy;       // [J]
    double *displacement;       // [solid nnode][3], owned by the result; NULL unless asked for
} segment_load_result;

typedef struct segment_result {
    int dofs;
    beam_law middle; // of this segment's own middle, ends' layers and all: inverse of the energy
                     // per length for six unit wrenches, docs/theory.md (5.5). relative_error: of
                     // the mesh, the difference from a run one order lower
    double stiffness_centre[2]; // the load position at which the mid-segment curvature vanishes [m]
    double tip_centre[2];       // the load position at which the tip's rotation vanishes: the ends'
                                // layers move it [m]
    mat6 tip_compliance; // E-weighted tip motion for six unit tip wrenches at the geometric centre,
                         // C
    int nload;
    segment_load_result *load;
    double relative_error; // estimate of max |C - C_exact|_ij / sqrt(C_ii C_jj): the difference
                           // from a run one order lower, so it assumes that the error halves per
                           // order; 1 (nothing known) for order 1
    double residual;       // largest |f - K u| / (|K| |u| + |f|) of the linear solves
    double assemble_seconds, factor_seconds,
        solve_seconds; // wall time, without the run for relative_error
} segment_result;

// All loads (and six unit wrenches) from one factorization. The caller has resolved where each load
// acts: `point` [nload][2]. Opens the PETSc door; under mpirun every rank calls it and every rank
// gets the result.
//
// Rigid tip and E_proportional: any wrench. Uniform: a force at the area's centroid; point (0, 0)
// stands for "not given", any other place or a moment is ERR_INPUT. There the six unit wrenches,
// and so middle, centres and tip_compliance, are those of the E_proportional tip, since a uniform
// traction has no moment.
status segment_solve(const segment_model *model, int nload, const segment_load *loads,
                     const double (*point)[2], int keep_displacements, segment_result *out);
void segment_result_free(segment_result *r);

// The law of the section by 3D FEM, from the middle of a column of its own with these plane
// elements, clamped, capped and 32 radii long: a short segment has no middle free of its ends.
// relative_error counts the mesh's order and what the ends still do. Opens the PETSc door.
status segment_section_law(const mesh *plane, const material *materials, beam_law *out);
