// rodsolver/rod.h
// The shape of a rod under its tendons, docs/theory.md section 4. Needs base only; starts no
// library; allocates nothing while it solves: rod_make does the allocating, rod_solve may run at
// some kHz.
#pragma once

#include "base/key.h"
#include "base/law_along.h"
#include "base/se3.h"
#include "base/status.h"

typedef struct tendon_spec {
    mark at;
    const char *name;    // owned by the case; NULL where not given
    field radius, angle; // polar position in the section [m, rad], ...
    field x, y;          // ... or Cartesian, added to it [m]
    double end;          // arclength where it is anchored [m]; 0: the tip
} tendon_spec;

enum { ROD_MAX_TENDONS = 16 };

// The rounding of the chain of panels: no estimate falls reliably below this.
#define ROD_MIN_TOLERANCE 1e-13

typedef enum rod_frame { FRAME_GC, FRAME_NC } rod_frame;

typedef struct rod_case {
    mark at;
    double length;     // [m]
    key_list tendons;  // of tendon_spec
    key_rows tensions; // [nsolution][ntendon] [N], >= 0
    int frame; // rod_frame in which the rod is solved; the shape is the geometric centreline in
               // both
    double tolerance; // |p - p_exact| / L wanted at the tip
    int points;       // of the shape that is written
} rod_case;

extern const key_table rod_keys; // `rod`
rod_case rod_case_default(void);

// Contradictions that no single key shows (tension rows and tendons, end beyond the tip): ERR_INPUT
// and the place.
status rod_case_check(const rod_case *c, mark *where);

typedef struct rod_options {
    int frame;        // rod_frame
    double tolerance; // |p - p_exact| / L at the tip
    int npanel; // integration panels, rounded up to pairs in every smooth stretch; 0: as many as
                // the tolerance needs, chosen anew for every tension among plans that rod_make
                // prepares
} rod_options;

// A rod made ready: compliance, reference strain and tendon positions at every quadrature station.
typedef struct rod rod; // defined in rodsolver/rod_plan.h

// law: K(s) (kept by reference, must outlive the rod, as must names and expressions of the
// tendons).
status rod_make(const law_along *law, int ntendon, const tendon_spec *tendons,
                const rod_options *options, rod **out);
void rod_free(rod *r);
// Panels of the last solution; before one, those that a load near the critical one begins with.
int rod_panel_count(const rod *r);

// The tension at which this tendon alone eats its own length somewhere, docs/theory.md (4.5), and
// where; s may be NULL.
double rod_critical_tension(const rod *r, int tendon, double *s);

typedef struct rod_solution {
    pose tip;              // geometric centre; base at the identity
    double *tendon_length; // [ntendon] inside the body [m], the caller's, filled; may be NULL
    int iterations;        // Newton steps over all stations and plans tried
    double relative_error; // of the tip, |p - p_exact| / L: from one step per pair of panels on the
                           // same stations, docs/theory.md (4.8)
    vec6 max_strain;       // largest size of each component of xi - xi* over the stations
} rod_solution;

// The shape for these tensions [ntendon]. ERR_NUMERIC where a tendon has eaten its own length (no
// smooth minimum) or an iteration did not converge, or the tolerance cannot be met; ERR_INPUT for a
// negative tension. The answer depends on the tensions alone, not on what was solved before.
// Allocates nothing.
status rod_solve(rod *r, const double *tension, rod_solution *out);

// After rod_solve: poses of the geometric centreline at npoint equally spaced arclengths, ends
// included [npoint].
status rod_shape(const rod *r, int npoint, double *s, pose *out);

// After rod_solve: the strain xi (in the frame of the geometric centre) at arclength s, by the
// stored local problem.
status rod_strain_at(const rod *r, double s, vec6 *xi);

// The compliance of the straight rod clamped at its base: the linear limit, for `compare`. Wrench
// (F, M) at the tip -> motion (u, phi) of the tip, fixed base axes, by ngauss <= 32 points per
// panel of the law.
//   C = int_0^L P^T K^-1 P ds, P = [I, 0; hat((L - s) e_z), I]     docs/theory.md (4.10)
status rod_linear_compliance(const law_along *law, double length, int ngauss, mat6 *out);
