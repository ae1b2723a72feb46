// stiffaxis.h
// stiffaxis as a library: a case file, its cross sections along s, its rod. What the program's
// `section` and `rod` compute, to the last bit.
//
//   stiffaxis_case_open     once: reads and checks
//   stiffaxis_section_make  once: solves the sections that the rod needs
//   stiffaxis_rod_make      once per rod, also with other values of the case's keys
//   stiffaxis_state_make    once per thread: the last answer, and all room that a solve needs
//   stiffaxis_solve         many times; allocates nothing
//   stiffaxis_shape ...     what else the last answer tells
//
// SI throughout: m, N, N m, rad. Matrices are rows, in the order nx ny nz mx my mz at the geometric
// centre (the origin of the case's x and y); wrenches (force, moment), twists and strains (v, w).
// Functions that can fail return a stiffaxis_status, whose numbers are the program's exit codes.
// Nothing is printed. Cases, sections and rods are made one at a time, whoever asks; solves run
// side by side, one state per thread. A section keeps its case, a rod its section, a state its rod:
// they may be freed in any order, by any thread, when no call uses them. NULL may be freed, and
// given nowhere else but where it says so. A child process may go on with what was there at a fork.
#pragma once

#include <stddef.h>

#define STIFFAXIS_API __attribute__((visibility("default")))

#ifdef __cplusplus
extern "C" {
#endif

typedef struct stiffaxis_case stiffaxis_case;
typedef struct stiffaxis_section stiffaxis_section;
typedef struct stiffaxis_rod stiffaxis_rod;
typedef struct stiffaxis_state stiffaxis_state;

enum stiffaxis_status {
    STIFFAXIS_OK = 0,
    STIFFAXIS_INPUT = 2,    // a mistake in the case, "FILE:LINE:COL: error: ...", or in a request
    STIFFAXIS_FILE = 3,     // an input file is damaged or of an unsupported kind
    STIFFAXIS_NUMERIC = 4,  // no convergence
    STIFFAXIS_RESOURCE = 5, // out of memory, disk or time, or a module is missing
    STIFFAXIS_BUG = 6       // our own mistake
};

// "0.1.0"
STIFFAXIS_API const char *stiffaxis_version(void);
// Why the calling thread's last call failed, one line; "" where it did not. Until its next call
// that may fail: what went wrong may be freed before it is told.
STIFFAXIS_API const char *stiffaxis_error(void);

// --- cases

// settings: [nsetting] "section.shapes.1.sector.width_rad=pi/16", as --set takes them.
// allow_scripts: a `geo:` section may run.
STIFFAXIS_API int stiffaxis_case_open(const char *path, int nsetting, const char *const *settings,
                                      int allow_scripts, stiffaxis_case **out);
// A text that no file holds. name: what messages call it, and in whose folder its files are.
STIFFAXIS_API int stiffaxis_case_read(const char *text, const char *name, int nsetting,
                                      const char *const *settings, int allow_scripts,
                                      stiffaxis_case **out);
STIFFAXIS_API void stiffaxis_case_free(stiffaxis_case *c);

STIFFAXIS_API const char *stiffaxis_case_title(const stiffaxis_case *c); // NULL: it has none
STIFFAXIS_API double stiffaxis_case_length(const stiffaxis_case *c);     // [m]
STIFFAXIS_API int stiffaxis_case_has_section(const stiffaxis_case *c);
STIFFAXIS_API int stiffaxis_case_has_rod(const stiffaxis_case *c);

// --- sections

// One section; the names are those of `stiffaxis section --json`.
typedef struct stiffaxis_station {
    double s;                   // [m]
    double area;                // [m^2]
    double EA;                  // [N]
    double stiffness_centre[2]; // [m]
    double principal_angle;     // [rad]
    double EI[2];               // about x', about y' [N m^2]
    double EI_centre[3];        // EIxx, EIyy, EIxy [N m^2]
    double GJ;                  // [N m^2]
    double shear_centre[2];     // [m]
    double mass;                // per length [kg/m]; 0 where no density is known
    double mass_centre[2];      // [m]
    double relative_error;      // of K: an estimate, the largest of
    double K_relative_error[6][6];
    double K[6][6]; // [N, N m, N m^2]
    int isotropic;  // no preferred axes
} stiffaxis_station;

STIFFAXIS_API int stiffaxis_section_make(stiffaxis_case *c, stiffaxis_section **out);
STIFFAXIS_API void stiffaxis_section_free(stiffaxis_section *section);

// Stations: the case's, else those between which K(s) is interpolated.
STIFFAXIS_API int stiffaxis_section_count(const stiffaxis_section *section);
STIFFAXIS_API int stiffaxis_section_station(const stiffaxis_section *section, int i,
                                            stiffaxis_station *out);
// K and dK/ds at n arclengths [m], clipped to the length: [n][6][6] each; dK may be NULL.
STIFFAXIS_API int stiffaxis_section_at(const stiffaxis_section *section, int n, const double *s,
                                       double *K, double *dK);
// How many were solved: turned and equal ones need not be.
STIFFAXIS_API int stiffaxis_section_solved(const stiffaxis_section *section);
// Of K(s) between the stations, relative.
STIFFAXIS_API double stiffaxis_section_interpolation_error(const stiffaxis_section *section);

// All that `stiffaxis section --json` tells, as that document: besides the stations kern, warping
// constant, mass, K about further points, stresses under the case's wrenches. For
// stiffaxis_text_free.
STIFFAXIS_API int stiffaxis_section_json(const stiffaxis_section *section, char **out);
STIFFAXIS_API void stiffaxis_text_free(char *text);

// --- rods

// The rod of the section's case, with other values of its keys where there are settings; the
// section is solved again only where they touch it.
STIFFAXIS_API int stiffaxis_rod_make(stiffaxis_section *section, int nsetting,
                                     const char *const *settings, stiffaxis_rod **out);
STIFFAXIS_API void stiffaxis_rod_free(stiffaxis_rod *rod);

STIFFAXIS_API double stiffaxis_rod_length(const stiffaxis_rod *rod); // [m]
STIFFAXIS_API int stiffaxis_rod_tendons(const stiffaxis_rod *rod);
STIFFAXIS_API int stiffaxis_rod_loads(const stiffaxis_rod *rod);
// The i-th tendon's or load's name, in `room` bytes.
STIFFAXIS_API int stiffaxis_rod_tendon_name(const stiffaxis_rod *rod, int i, char *name,
                                            size_t room);
STIFFAXIS_API int stiffaxis_rod_load_name(const stiffaxis_rod *rod, int i, char *name, size_t room);
// The tension at which this tendon alone eats its own length [N]; NAN for no such tendon.
STIFFAXIS_API double stiffaxis_rod_critical_tension(const stiffaxis_rod *rod, int tendon);

// How many solutions the case asks for, with how many points of the shape, and what the i-th is:
// tension [ntendon], pull [ntendon] (NAN: the tension is given), load [nload].
STIFFAXIS_API int stiffaxis_rod_solutions(const stiffaxis_rod *rod);
STIFFAXIS_API int stiffaxis_rod_points(const stiffaxis_rod *rod);
STIFFAXIS_API int stiffaxis_rod_solution(const stiffaxis_rod *rod, int i, double *tension,
                                         double *pull, double *load);

STIFFAXIS_API int stiffaxis_state_make(stiffaxis_rod *rod, stiffaxis_state **out);
STIFFAXIS_API void stiffaxis_state_free(stiffaxis_state *state);

// --- solving. All from {0}.

typedef struct stiffaxis_request {
    const double *tension; // [ntendon] at the base [N], >= 0; NULL: none
    const double *pull; // [ntendon] length drawn out of the base [m], NAN: this tendon's tension is
                        // given; NULL: all tensions are given
    const double *load; // [nload] factors of the case's loads; NULL: 1 each
    const double *base; // [4][4] pose of the base in the world; NULL: the case's
    double tip_space[6]; // wrench on the tip's centre, directions fixed in the world [N, N m]
    double tip_body[6];  // ... turning with the tip
    int cold; // from rest, not from the state's last answer: the same bits for the same request
    int past; // follow the equilibria past limit points
    int stability; // the smallest eigenvalue and the work too
} stiffaxis_request;

typedef struct stiffaxis_critical {
    double fraction; // of the way to the request
    int kind;        // 0 limit point, 1 bifurcation
    int negative;    // negative directions of the second variation behind it; -1: no potential
} stiffaxis_critical;

enum { STIFFAXIS_MAX_CRITICAL = 16 };

typedef struct stiffaxis_solution {
    double *tendon_length;  // [ntendon] inside the body [m], the caller's, filled; may be NULL
    double *tension;        // [ntendon] as given or found (0: slack) [N], the caller's; may be NULL
    double tip_position[3]; // of the geometric centre, in the world [m]
    double tip_rotation[3][3]; // rows
    double relative_error;     // of the tip, |p - p_exact| / L: an estimate
    double max_strain[6];      // largest size of each component of xi - xi* over the rod
    double fraction;           // of the request that was reached; below 1 at a limit point
    double eigenvalue;         // 1 at rest, 0 critical; NAN: not asked for, or no potential
    double energy, work;       // [J]; NAN: not known
    double residual;           // of the balance, over the largest strain
    int iterations;
    int stable;  // 1, 0, or -1: not known
    int limited; // a limit point stands in the way, and this is the answer there
    int ncritical;
    stiffaxis_critical critical[STIFFAXIS_MAX_CRITICAL];
} stiffaxis_solution;

// STIFFAXIS_INPUT: a negative tension, a number that is not finite, a base that is no pose;
// STIFFAXIS_NUMERIC: no convergence, or out->limited.
STIFFAXIS_API int stiffaxis_solve(stiffaxis_state *state, const stiffaxis_request *request,
                                  stiffaxis_solution *out);

// Tips for n rows of tensions [n][ntendon] on nthread threads (0: all cores), cold; all else as in
// `like` (NULL: nothing else). position [n][3], rotation [n][3][3] (may be NULL), outcome [n] (may
// be NULL): NAN and the reason's status where a row failed.
STIFFAXIS_API int stiffaxis_batch(const stiffaxis_rod *rod, int nthread, int n,
                                  const double *tension, const stiffaxis_request *like,
                                  double *position, double *rotation, int *outcome);

// --- after a solve

// The geometric centreline at n arclengths [m], clipped to the length, in the world: position
// [n][3], rotation [n][3][3]; s NULL: n equally spaced ones, ends included. Any of the two may be
// NULL.
STIFFAXIS_API int stiffaxis_shape(const stiffaxis_state *state, int n, const double *s,
                                  double *position, double *rotation);
// Strains xi [n][6] (without load and straight: 0 0 1 0 0 0), the wrench that the section carries
// [n][6] and the tendons' tensions [n][ntendon] there; any of the three may be NULL.
STIFFAXIS_API int stiffaxis_along(const stiffaxis_state *state, int n, const double *s,
                                  double *strain, double *wrench, double *tension);

// Derivatives of the pose at s as body twists (g^-1 dg/dx)^vee. Any pointer may be NULL.
typedef struct stiffaxis_derivatives {
    double *tension;           // [ntendon][6] by tensions; 0 where the pull is given
    double *pull;              // [ntendon][6] by pulled lengths; 0 where the tension is given
    double *load;              // [nload][6] by factors of loads
    double *tip_space;         // [6][6] column j: by entry j of the tip's wrench, fixed in space
    double *tip_body;          // [6][6] ... turning with the tip
    double *base;              // [6][6] by the base's body twist
    double *length_by_tension; // [ntendon][ntendon] of tendons' lengths by tensions [m/N]
} stiffaxis_derivatives;

STIFFAXIS_API int stiffaxis_derive(stiffaxis_state *state, double s,
                                   const stiffaxis_derivatives *out);

#ifdef __cplusplus
}
#endif
