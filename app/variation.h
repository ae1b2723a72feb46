// app/variation.h
// A case solved again with other values of some of its keys, for fits and sensitivities: what the
// values do not touch is not computed again.
//
//   variation_open   once: the laws of the case as it stands
//   varied_make      the case with other values: its laws where they moved, its rod
//   varied_solve     its shapes
//   variation_solve  both
#pragma once

#include "app/case.h"
#include "app/parameter.h"

typedef struct variation {
    const case_data *base;  // the caller's, open as long as this
    mesh_options mesh;      // what the base's sections were solved on: a change of the parameters
                            // is not to be one of the mesh
    section_result section; // of the base
    section_known known;    // sections solved on the way
    int nsection, nrod;     // how often laws and rods were made
} variation;

// section: the base's where it was solved already, else NULL. Its laws are copied.
status variation_open(const case_data *base, const section_result *section, variation *out);
void variation_free(variation *v);

// Whether the case can be read with these settings: ERR_INPUT as varied_make, nothing is solved.
status variation_check(const case_data *base, const settings *s, mark at);
// ... and the case with them.
status variation_read(const case_data *base, const settings *s, mark at, case_data *out);

// The case with other values. In place: *out must not move, and v outlives it.
typedef struct varied {
    case_data c;
    section_result section; // its own where the settings touch the section, else empty
    const law_along *law;   // that, or the base's
    rod *rod;
    rod_state *state;
} varied;

// s NULL: as the case stands. Failures are told as "tendon radius = 5: ...", at `at` in the case.
status varied_make(variation *v, const settings *s, mark at, varied *out);
void varied_free(varied *w);

// Its section on the mesh that its laws were solved on, for more questions about it.
section_case varied_section(const variation *v, const varied *w);

// Which shapes, where.
typedef struct variation_places {
    int nsolution;       // 0: all of the case
    const int *solution; // [nsolution] of the case's solutions; NULL: the first ones
    int npoint;
    const double *s; // [npoint] arclengths [m], those beyond the length at the tip; NULL: equally
                     // spaced over the length, ends included
} variation_places;

typedef struct variation_answer {
    int nsolution, npoint;
    pose *tip;        // [nsolution] in the world
    double *fraction; // [nsolution] below 1: the rod ends at a limit point, and this is there
    double *s;        // [npoint] [m]
    pose *shape;      // [nsolution][npoint]
} variation_answer;

// In the frame of the base's clamp where local is true: z along the rod at its base; else in the
// world.
status varied_solve(varied *w, const variation_places *where, bool local, variation_answer *out);
void variation_answer_free(variation_answer *a);

status variation_solve(variation *v, const settings *s, mark at, const variation_places *where,
                       bool local, variation_answer *out);
