// fem/load.h
// What loads and what holds a body, as the solvers want it. docs/theory.md (5.6) to (5.8), (5.11)
#pragma once

#include "fem/body.h"

typedef enum segment_base { BASE_CLAMPED, BASE_FREE_TO_CONTRACT, BASE_FREE } segment_base;
typedef enum segment_tip { TIP_RIGID, TIP_E_PROPORTIONAL, TIP_UNIFORM, TIP_FREE } segment_tip;

// Faces: of the ends, and of the walls: loops of the plane mesh's border. FACE_OUTSIDE is what no
// other loop surrounds, FACE_INSIDE all holes; FACE_HOLE + k is the k-th hole, from the largest.
enum { FACE_BASE = -2, FACE_TIP = -1, FACE_OUTSIDE = 0, FACE_INSIDE = 1, FACE_HOLE = 2 };

// A part of a face between two arclengths (walls only); to = INFINITY: up to the tip.
typedef struct face_part {
    int face;
    double from, to; // [m]
} face_part;

// An elastic foundation: force per area = - stiffness x displacement, along the face's normal and
// across it. In the base's axes where `axes`: stiffness along x, y, z.
typedef struct face_spring {
    face_part on;
    bool axes;
    double stiffness[3]; // [N/m^3] normal, tangential (twice the same), or x, y, z
} face_spring;

// Held nodes: the directions of `mask` (bit 0: x) move by `motion`, in the base's axes. A motion
// that is not zero is one right-hand side of its own: `column`.
typedef struct face_hold {
    face_part on;
    int mask;
    double motion[3]; // [m]
} face_hold;

// One right-hand side beside the six unit wrenches on the tip: whatever acts together.
typedef struct face_pressure {
    face_part on;
    double pressure;    // against the face, positive inwards [Pa]
    double traction[3]; // along x, y, z [Pa]
} face_pressure;

typedef struct load_column {
    int npressure;
    const face_pressure *pressure;
    double body_force[3];   // [N/m^3]
    double acceleration[3]; // times the density of each material [m/s^2]
    bool holds_move;        // the motions of the holds
    bool uniform_tip;       // uniform traction on the tip with the resultant `tip_force`
    double tip_force[3];    // [N]
} load_column;

// The linear problem on a body. Columns: unit wrenches nx ny nz mx my mz at the origin of the tip
// (the section's origin there, in the base's axes; by the rigid cap, or else by E-proportional
// traction), then `extra`.
typedef struct segment_problem {
    const body *body;
    int base, tip; // segment_base, segment_tip
    int nspring, nhold, nextra;
    const face_spring *spring;
    const face_hold *hold;
    const load_column *extra;
} segment_problem;

static inline int problem_columns(const segment_problem *p)
{
    return 6 + p->nextra;
}

// Whether springs, holds, loads or matter make it a problem that only the general solvers take.
bool problem_is_plain(const segment_problem *p);
