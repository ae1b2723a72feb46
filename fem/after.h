// fem/after.h
// What follows from a solved segment: compliance, middle, centres, ends, slices and loads. Pure
// functions of a way_run and its problem; the same on every rank. docs/theory.md (5.2) to (5.5),
// (5.17), (5.18), (5.20), (5.21)
#pragma once

#include "base/beam_law.h"
#include "fem/load.h"
#include "fem/segment.h"
#include "fem/way.h"

// The section at a height: axes as columns and origin in the base's axes.
typedef struct section_pose {
    mat3 axes;
    vec3 origin; // [m]
} section_pose;

typedef struct after {
    const segment_problem *problem;
    const way_run *run;
    double middle, middle_half; // the energy's window [m]
    double radius, length;      // of the body [m]
    section_pose *pose;         // [run->nlevel]
    section_pose centre;        // at the window's centre
    bool straight;              // the origins lie on the base's z
    bool walled; // springs or holds on walls take part of every wrench: no law, no centres, NaN
    double area; // of the section at the window's centre [m^2]
    double EA;   // of the tip [N]
    double tip_centroid[2];  // of E over the tip, from the section's origin, base's axes [m]
    double area_centroid[2]; // of the area over the tip
    mat6 compliance;         // C: E-weighted motion of the tip, columns for six unit wrenches
    double (*curvature)[2];  // [ncolumn] over the middle, (5.3) [1/m per N or N m]
    mat6 F;                  // compliance per length of the middle, section's axes there, (5.5)
} after;

// `wants` as the way had them. What it points to must outlive it. ERR_NUMERIC where the energy of
// the middle is not that of an elastic body.
status after_make(const segment_problem *p, const way_run *run, const way_wants *wants, after *out);
void after_free(after *a);

// K of the middle in the axes of the base (of the section there where the body bends), area.
status after_middle(const after *a, beam_law *out);

// Where an axial force leaves the middle uncurved (5.4), and where it leaves the tip unturned [m].
status after_centre(const after *a, double centre[2]);
status after_tip_centre(const after *a, double centre[2]);

// Length that both ends together take, per generalized strain, (5.17) [m]; NaN where the law is not
// the same all along, or springs or holds take part.
status after_end_length(const after *a, double length[6]);

// What acts on the tip, and what it answers. docs/theory.md (5.18)
typedef struct tip_load {
    vec6 wrench;      // about the section's origin at the tip
    double spring[6]; // between tip and ground [N/m, N m/rad]
    double motion[6]; // imposed; NaN: free, then `wrench` acts
} tip_load;

// Factors of the columns [ncolumn]: those beyond the six stay as they are, the six become the
// wrench that leaves the tip where springs and imposed motions want it. ERR_NUMERIC where they
// contradict.
status after_combine(const after *a, const tip_load *load, double *factor);

// E-weighted motion of the tip by factors, and half the work of all that acts [J]: the strain
// energy, with what the problem's own springs hold.
vec6 after_tip_motion(const after *a, const double *factor);
double after_energy(const after *a, const double *factor);

// One slice per height of the run: [nlevel] motion and resultant in the base's axes about the
// section's origin, what the tip's wrench puts on it, and strains of the fitted motions in the
// body's frame, (5.20).
typedef struct slice_arrays {
    vec6 *motion, *resultant, *load, *strain;
} slice_arrays;
status after_slices(const after *a, const double *factor, const slice_arrays *out);

// Largest miss of the resultants against the loads, moments over the radius, over the largest load
// or, where loads balance themselves (a pressure in a tube), over the axial force that would store
// as much energy; NaN where the run does not tell all that acts.
double after_balance(const after *a, const double *factor, const vec6 *resultant, const vec6 *load);

// A wrench at one point as seen from another: `from` - `to` is the arm.
vec6 wrench_about(vec6 wrench, vec3 from, vec3 to);

// --- into a segment_result

// All that belongs to no load: compliance, middle, centres, end lengths, dofs, residual and
// iterations; CPU seconds are added to what is there.
status after_fill(const after *a, segment_result *r);

typedef struct after_ask {
    const segment_load *load;
    const double *point;      // [2] where its force acts, as the case resolved it [m]
    const double *tip_spring; // [6] of the case
    int column;               // of the run: what it brings along beside its wrench; -1: none
    int uniform; // first of three columns for unit forces by uniform traction, which then carry
                 // its force; -1: the six unit wrenches do
    const segment_body *here; // fields too, on what after_keep_body kept; NULL: none
} after_ask;

// One load from the run's columns, but for its errors and stresses. ERR_INPUT where a uniform
// traction cannot be what it asks for. What out owns is the caller's to free, after a failure too.
status after_load(const after *a, const after_ask *ask, segment_load_result *out);

// All estimates of `fine` from the differences to a coarser mesh, times factor: 1 where nothing is
// known of the rate, 1 / (rate - 1) where it is; the middle's law has its own.
void after_errors(const segment_result *coarse, double factor, double law_factor,
                  segment_result *fine);

// No estimate of `fine` below that of the coarser one: where a mesh only changes along s, what the
// section's elements leave does not show in the difference.
void after_no_better(const segment_result *coarse, segment_result *fine);

// The plane mesh, and with fields what they stand on: this rank's own levels; with stresses nodes
// apart too.
status after_keep_body(const segment_problem *p, const way_run *run, bool fields, bool stress,
                       segment_body *out);

// Stresses at the nodes of `here`, [levels here][apart nnode][6], of displacements u [run->last -
// run->first][nplane][3]: the mean of what a node's elements say, each material by itself; an
// element says the polynomial through its best points. docs/theory.md (5.21)
status after_stress(const segment_body *here, const body *b, const way_run *run, const double *u,
                    double **stress);
