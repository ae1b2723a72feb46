// section/section.h
// A cross section's 6x6 stiffness and centres at one place, or along the rod. docs/theory.md,
// sections 2 and 3.
#pragma once

#include "base/hash.h"
#include "base/law_along.h"
#include "base/material.h"
#include "base/mesh.h"
#include "meshes/drawing.h"
#include "meshes/mesher.h"
#include "meshes/shape.h"

typedef enum section_model { MODEL_FULL, MODEL_CLASSICAL } section_model;

// A 6x6 that someone published, for `compare`.
typedef struct section_reference {
    mark at;
    const char *source; // where it stands; NULL: not said
    double tolerance;   // of an entry, relative to sqrt(K_ii K_jj)
    key_rows K;         // [n][3]: row and column from 1 in the order nx ny nz mx my mz, value in SI
} section_reference;

enum { WRENCH_AT_GEOMETRIC_CENTRE, WRENCH_AT_STIFFNESS_CENTRE };

// A wrench that the part of the rod beyond the section puts on it: strains and stresses under it
// are asked for.
typedef struct section_wrench {
    mark at;
    const char *name;           // owned by the case
    double force[3], moment[3]; // [N, N m], the moment about the place where the force acts
    int at_kind;                // -1: by point, or the geometric centre where it is empty
    key_rows point;             // [1][2] [m]
} section_wrench;

extern const key_table section_wrench_keys; // one entry of `section.wrenches`

// Laws by the fingerprint of their sections, from an earlier run.
typedef struct section_known {
    int count, capacity;
    hash *key;          // [count]
    beam_law *law;      // [count] in the body frame
    mesh_options *mesh; // [count] what the law was solved with
} section_known;
status section_known_add(section_known *k, hash key, const beam_law *law, const mesh_options *mesh);
void section_known_free(section_known *k);

// Most that a tolerance makes of a mesh: layers at corners beyond the default ones (more make
// rounding larger than what they take), and elements for one of the default length.
enum { SECTION_MOST_LAYERS = 4 };
#define SECTION_MOST_FINER 6.0

typedef struct section_case {
    mark at;
    int model;           // section_model
    key_list shapes;     // of shape_spec; or else one of the files
    drawing_files files; // png, msh, step, dxf, geo
    field turn;          // of the whole section about its origin [rad], beside what the shapes say
    field scale;         // of all its lengths about its origin
    field pattern_turn;  // of what the slices of a stack show [rad]; only its rate matters
    mesh_options mesh;
    key_rows stations; // arclengths that the user asks for, `stations_mm: [[...]]`; empty: chosen
    double tolerance;  // of K, relative, along s too; 0: the mesh as it is, and a small one along s
    key_list wrenches; // of section_wrench: what stresses are asked for
    section_reference reference;
    key_rows points; // [n][2] places about which K is asked for too [m]
    // by section_case_bind
    int nmaterial;
    drawing *drawing;           // the open file; NULL: shapes
    const section_known *known; // the caller's, from an earlier run; NULL: nobody asks, and nothing
                                // is kept for the next run either
} section_case;

extern const key_table section_keys; // `section`
section_case section_case_default(void);

// Two wrenches of one name, or one of nothing: ERR_INPUT and the place.
status section_wrenches_check(const section_case *c, mark *where);

// What the case's files may need.
typedef struct section_surroundings {
    const char *directory; // of the case file; NULL: the current one
    bool allow_scripts;
} section_surroundings;

// Resolves material names and opens the section's file; ERR_INPUT "FILE-less" message: the caller
// puts file, line and column of *where in front. Then section_case_release.
status section_case_bind(section_case *c, const key_list *materials,
                         const section_surroundings *around, mark *where);
void section_case_release(section_case *c);

// --- one section
// ---------------------------------------------------------------------------------------------------

// Classical: E-weighted integrals over the mesh (2.2)-(2.5), (2.9), no factorization. G (Ixx + Iyy)
// about the stiffness centre for torsion, int G for both shears, as the paper has it.
status section_classical_mesh(const mesh *m, const material *materials, beam_law *out);

// Classical without a mesh: exact integrals over concentric annuli, sectors and discs laid on one
// another. *done = false where the outlines are of another kind, or a material is not isotropic or
// is graded over x and y.
status section_classical_closed(const section_outline *o, const material *materials, beam_law *out,
                                bool *done);

// Full: warping solved on the mesh, one factorization, twelve right-hand sides (3.1)-(3.6).
typedef struct section_warping {
    int nnode;
    double *w;      // [6][nnode][3] warping for six unit end wrenches (n, m)
    double *dw;     // [6][nnode][3] its derivative along z
    mat6 psi, dpsi; // generalized strains: column j for unit wrench j
} section_warping;

// The same where the pattern turns at turn_rate [rad/m], in the frame that turns with it (3.9);
// 0 gives section_full_mesh.
status section_turning_mesh(const mesh *m, const material *materials, double turn_rate,
                            beam_law *out, section_warping *warping);

// warping may be NULL. relative_error holds the rounding only, by how far the stresses miss the
// end wrenches, and what that does to K: section_solve adds the mesh's.
status section_full_mesh(const mesh *m, const material *materials, beam_law *out,
                         section_warping *warping);
void section_warping_free(section_warping *w);

// K at one place by the case's model, with its error estimate (full and meshed classical: lower
// orders of the same mesh, extrapolated; closed form: rounding).
// A pattern that turns does so at the rate that it has on a rod of this length; 0: as if nothing
// turned.
status section_solve(const section_case *c, const material *materials, double s, double length,
                     beam_law *out);

// The paper's closed forms for the two-material annulus, corrected Eq. 18 to 20 of the paper,
// docs/theory.md (2.6).
typedef struct annulus_two_materials {
    double outer, inner, mid_angle, width; // stiff sector's full width [m, rad]
    double E_soft, E_stiff;                // [Pa]
} annulus_two_materials;
typedef struct annulus_closed_form {
    double EA, r_nc, EI_centre[2]; // r_nc signed along mid_angle; EI about the axis of symmetry and
                                   // across it, at NC
} annulus_closed_form;
annulus_closed_form annulus_closed(const annulus_two_materials *a);

// --- along the rod
// -------------------------------------------------------------------------------------------------

// How many sections were solved, and why no more.
typedef struct section_effort {
    int nsolved;
    int nsame, nturned, nscaled, nmirrored; // found among the solved ones, by what they are of them
    int nstored;                            // found in an earlier run's result
    bool meshed;                            // false: closed form, no mesh was made
    bool uneven; // shapes turn at different rates somewhere: their K is as if nothing turned
} section_effort;

// "3 solved, 8 turned copies of these, 2 equal to others" and the like, in `words`.
enum { SECTION_EFFORT_WORDS = 200 };
const char *section_effort_words(const section_effort *e, char words[SECTION_EFFORT_WORDS]);

typedef struct section_station {
    double s;          // [m]
    double turn_rate;  // of the pattern, that K knows [rad/m]
    beam_law law;      // in the body frame at s
    mesh_options mesh; // the law's: the case's, or what met the tolerance; not in the store
    beam_centres centres;
} section_station;

typedef struct section_result {
    int nstation;
    section_station
        *station;      // the user's stations, else the interpolation's own nodes in order of s
    law_along along;   // K(s) over [0, length]
    double resolution; // of an image: how far K of its first slice moves where its pixels are twice
                       // as wide, relative as in (6.1); 0: no image
    section_effort effort;
    section_known solved; // for the next run, where the case has `known`
} section_result;

// length: the rod's (or the segment's where there is no rod). Chooses stations by the decay of
// Chebyshev coefficients to c->tolerance; one station where nothing varies; one solve where the
// pattern only turns.
status section_along(const section_case *c, const material *materials, double length,
                     section_result *out);
void section_result_free(section_result *r);

// What section_solve refuses at arclength s as the case's mistake, without solving: the outlines,
// and the mesh where one is needed. libraries false: not where the mesh would start one. out: that
// mesh, without nodes where none was made; NULL: nobody asks.
status section_check(const section_case *c, const material *materials, double s, bool libraries,
                     mesh *out);

// The area of each material on a mesh [nmaterial] [m^2].
status section_areas(const mesh *m, int nmaterial, double *area);

// The mesh at arclength s; section_mesh_with: by other options than the case's, as a station's.
status section_mesh_at(const section_case *c, double s, mesh *out);
status section_mesh_with(const section_case *c, double s, const mesh_options *options, mesh *out);

// Whether anything of it depends on s.
bool section_varies(const section_case *c);
// A stack's thickness, all in all [m]; 0 for the others.
double section_own_length(const section_case *c);
// The outlines in the body frame at s; *found false where its file holds none (meshes, images).
status section_outline_at(const section_case *c, double s, section_outline *out, bool *found);
// How far it reaches from its origin [m]; of a stack its first slice.
status section_reach_at(const section_case *c, double s, double *reach);
// How far its material reaches in the direction of a place [m], looked for in steps of a thousandth
// of its size; 0 where none lies there. The outlines unknown: as section_reach_at.
status section_reach_towards(const section_case *c, double s, const double place[2], double *reach);
