// fem/segment.h
// The 3D segment: an extruded section, linear elastic, fixed at its base, loaded at its tip.
// docs/theory.md, section 5.
#pragma once

#include "base/beam_law.h"
#include "base/key.h"
#include "base/material.h"
#include "base/mesh.h"
#include "base/status.h"
#include "fem/body.h"
#include "fem/load.h"
#include "fem/way.h"

// A pressure, a traction or a force per volume that one load may bring along with its tip wrench.
typedef struct segment_pressure {
    mark at;
    int face;           // of the key; FACE_... by segment_face_part
    double range[2];    // arclengths between which it acts, on walls [m]; to INFINITY: the tip
    double pressure;    // against the face [Pa]
    double traction[3]; // [Pa]
} segment_pressure;

// Imposed on the tip, in one row of three each; not given or NAN: free.
typedef struct segment_motion {
    mark at;
    key_rows translation, rotation; // of the geometric centre [m], [rad]
} segment_motion;

typedef struct segment_load {
    mark at;
    const char *name;
    double force[3];  // on the tip [N]
    double moment[3]; // [N m], about the point where the force acts
    key_rows point;   // at_mm: [x, y] in one row; not given: geometric centre
    int at_kind; // at: 0 geometric_centre, 1 stiffness_centre (of the section analysis); -1 not
                 // given: 0
    key_list pressures;        // of segment_pressure
    double body_force[3];      // [N/m^3]
    double acceleration[3];    // gravity and the like; needs the materials' densities [m/s^2]
    segment_motion tip_motion; // instead of a wrench; by segment_tip_motion
    bool holds_move;           // the motions of the case's `holds`
} segment_load;

// Springs and held faces of the case.
typedef struct segment_spring {
    mark at;
    int face;
    double range[2];
    double normal, tangential; // [N/m^3]
} segment_spring;

typedef struct segment_hold {
    mark at;
    int face;
    double range[2];
    key_rows motion; // [1][3]; NAN: that direction is free [m]
} segment_hold;

// Between the tip, at its geometric centre, and the ground, along and about x, y, z.
typedef struct segment_tip_spring {
    mark at;
    double translation[3], rotation[3]; // [N/m], [N m/rad]
} segment_tip_spring;

typedef enum segment_course { COURSE_ALONG, COURSE_PRISM } segment_course;
typedef enum segment_mixed { MIXED_AUTO, MIXED_YES, MIXED_NO } segment_mixed;

typedef struct segment_case {
    mark at;
    double length;     // [m]
    int base, tip;     // segment_base, segment_tip
    int order;         // of the 3D elements, 1..4; 0: chosen
    int layers;        // along z; 0: chosen
    double grading;    // middle layer over end layer; 0: chosen
    double size;       // in-plane edge length [m]; 0: chosen
    double section_at; // arclength of the rod's section at the base [m]
    int course;        // segment_course: follows the section along the rod, or keeps it
    int way;           // segment_way
    double tolerance; // of each load's work and tip motion, without loads of the tip compliance and
                      // the middle's law, relative; 0: the mesh as it is
    int mixed;        // segment_mixed; MIXED_AUTO: by Poisson's ratio
    segment_tip_spring tip_spring; // there where its mark is given
    key_list loads;                // of segment_load
    key_list springs;              // of segment_spring
    key_list holds;                // of segment_hold
    bool stress;                   // stresses into the result
} segment_case;

// below this estimates are rounding
#define SEGMENT_MIN_TOLERANCE 1e-9

extern const key_table segment_keys; // `fem`
segment_case segment_case_default(void);

// Contradictions that the table cannot see; *where is the place of the key at fault. ERR_INPUT with
// words without a place.
status segment_case_check(const segment_case *c, mark *where);

// The case with every 0 of order, layers, grading and size filled in for a section that a circle of
// `radius` about the origin holds [m]: cubic elements, layers fine at both ends and long in the
// middle.
segment_case segment_choose(const segment_case *c, double radius);

// The case's entries as a segment_problem has them. A motion of the tip: false where none is
// imposed; translation and rotation, NAN where free.
face_part segment_face_part(int face, const double range[2]);
face_pressure segment_face_pressure(const segment_pressure *p);
face_spring segment_face_spring(const segment_spring *s);
face_hold segment_face_hold(const segment_hold *h);
bool segment_tip_motion(const segment_load *load, double motion[6]);

// The rank under mpirun, 0 without it, from the environment alone: MPI is not started. Only rank 0
// should print or save.
int segment_rank(void);

// A mesh of the section to ask for: what a rung of the ladder towards a tolerance changes.
typedef struct segment_mesh {
    int order;       // of the plane elements
    double size;     // edge length [m]; 0: chosen from the outlines
    int edge_layers; // of elements that shrink towards free edges and interfaces, where the clamp's
                     // singular line is
    double edge_first; // the last of them over the section's radius
} segment_mesh;

// What the caller provides: meshes of the section and the body that stands on one.
typedef struct segment_source {
    void *self;
    double radius; // of the section at the base about its origin [m]
    // The plane mesh of the section at the base; the caller of it frees it.
    status (*plane)(void *self, const segment_mesh *ask, mesh *out);
    // Fills shape, turn_rate and matter of a body on such a mesh; what it points to lives until
    // `release` with the same spec. NULL: a prism.
    status (*course)(void *self, const mesh *plane, body_spec *spec);
    void (*release)(void *self, body_spec *spec);
    const material *materials;
    int nmaterial;
    double nu;          // the largest Poisson's ratio of what it is made of
    int sections_along; // changes of course: layers are no longer than 1 / this of the length; 0:
                        // none
    bool fixed_layers;  // a stack: layers are the slices'
    int nlayer;
    const double *layer;                             // [nlayer + 1]
    void (*progress)(void *self, const char *words); // may be NULL
} segment_source;

typedef struct segment_slice {
    double s;       // [m]
    vec6 motion;    // E-weighted, about the section's origin, in the base's axes
    vec6 resultant; // of the stresses; what the load puts on it is `load`
    vec6 load;
    vec6 strain; // generalized (v, w) of the fitted motions, in the body's frame: the base's axes,
                 // or those of the course
} segment_slice;

// What the fields stand on: nodes of a plane mesh on the levels of a body. Without fields the plane
// mesh alone.
typedef struct segment_body {
    mesh plane;
    mesh apart; // the plane mesh, its nodes apart where materials or their frames meet; nnode 0
                // without stresses
    int order, nlayer, nlevel; // of the layers; nlevel = nlayer order + 1
    double *level;             // [nlevel] s [m]
    int *matter; // [nlayer][elements of the plane mesh] material, -1: nothing; NULL: as in the mesh
    bool shared; // ranks share the levels out
    int first, last; // levels that are here
    double *node;    // [last - first][plane nnode][3] places [m]
} segment_body;
void segment_body_free(segment_body *b);

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
    double shortening_error, tip_displacement_error, tip_rotation_error, mid_curvature_error,
        strain_energy_error; // estimates, in the quantity's own unit
    int nslice;
    segment_slice *slice; // [nslice] from base to tip; owned by the result
    double balance;       // largest miss of the resultants, moments over the radius, relative to
                          // the load's largest
    double *displacement; // [levels here][plane nnode][3] [m]; NULL unless asked for
    double *stress;       // [levels here][apart nnode][6] xx yy zz yz xz xy in the section's axes
                          // [Pa], of the best points, mean of a node's elements of one material;
                          // NULL unless asked for
} segment_load_result;

// One mesh of the ladder towards a tolerance.
typedef struct segment_step {
    double dofs;         // more than an int holds
    double seconds;      // CPU time of this mesh
    mat6 tip_compliance; // as segment_result has it
} segment_step;

enum { SEGMENT_MOST_STEPS = 6 };

typedef struct segment_result {
    int way;       // segment_way that was taken
    char why[200]; // in words: what the cost model said
    long long dofs;
    int rungs;                             // meshes that were solved
    segment_step step[SEGMENT_MOST_STEPS]; // the first `rungs`; all zero where they were not kept
    bool met;                              // the tolerance
    segment_mesh mesh_used;
    int order, layers;
    int plane_nodes; // of the section's mesh
    beam_law middle; // of this segment's own middle, ends' layers and all: inverse of the energy
                     // per length for six unit wrenches, docs/theory.md (5.5)
    double stiffness_centre[2]; // the load position at which the mid-segment curvature vanishes [m]
    double stiffness_centre_error;
    double tip_centre[2]; // the load position at which the tip's rotation vanishes: the ends'
                          // layers move it [m]
    mat6 tip_compliance; // E-weighted tip motion for six unit tip wrenches at the geometric centre,
                         // C
    double end_length[6]; // of both ends together: a segment that much shorter (positive) and
                          // without end layers has C; per strain x y z (n) and x y z (m) [m]
    int nload;
    segment_load_result *load;
    double relative_error; // estimate of max |C - C_exact|_ij / sqrt(C_ii C_jj)
    double residual;       // largest |f - K u| / (|K| |u| + |f|) of the linear solves
    int iterations;
    double assemble_seconds, factor_seconds, solve_seconds; // CPU time, all rungs
    segment_body body;
} segment_result;

// How far a mesh is from the answer at most: max |C - C_last|_ij / sqrt(C_ii C_jj) from the last
// one, and the estimate of that one's own error
double segment_step_error(const segment_result *r, int step);

// All loads (and six unit wrenches) from one factorization per rung. The caller has resolved where
// each load acts: `point` [nload][2]. Under mpirun every rank calls it and every rank gets the
// result.
//
// Rigid tip and E_proportional: any wrench. Uniform: a force at the area's centroid; point (0, 0)
// stands for "not given", any other place or a moment is ERR_INPUT. There the six unit wrenches,
// and so middle, centres and tip_compliance, are those of the E_proportional tip, since a uniform
// traction has no moment.
status segment_solve(const segment_case *c, const segment_source *source, const double (*point)[2],
                     int keep_fields, segment_result *out);
void segment_result_free(segment_result *r);

// What the mesh that counts takes, from counts alone: nothing is solved, no library is started but
// for what `plane` starts. With a tolerance it is the mesh on which loads of its kind usually meet
// it.
typedef struct segment_forecast {
    int order, layers, plane_nodes;
    double size;           // of the section's elements [m]; 0: chosen from the outlines
    long long dofs;        // held ones among them, unless slabs are doubled
    const char *way;       // what the cost model takes, or the case
    double seconds, bytes; // of it, on one rank
    bool fits;             // the machine has as many bytes
} segment_forecast;
status segment_forecast_make(const segment_case *c, const segment_source *source,
                             segment_forecast *out);

// The law of the section by 3D FEM, from the middle of a column of its own with these plane
// elements, clamped, capped and 32 radii long: a short segment has no middle free of its ends.
// relative_error counts the mesh's order and what the ends still do.
status segment_section_law(const mesh *plane, const material *materials, beam_law *out);
