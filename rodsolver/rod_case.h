// rodsolver/rod_case.h
// What a case file says about the rod.
#pragma once

#include "base/key.h"
#include "rodsolver/rod.h"

enum {
    ROD_CASE_TENDONS = 256, // as many as a case may have
    ROD_CASE_LOADS = 100,   // at points, and along lines
    ROD_CASE_SOLUTIONS = 100000,
    ROD_CASE_POINTS = 4000000, // of all shapes together: some 200 bytes each
};

typedef struct tendon_case {
    tendon_spec spec; // its table is filled by rod_case_bind
    key_rows path;    // rows (s, x, y) [m]
    key_text path_csv;
    int nread; // rows of that file: filled by who opens files, freed by rod_case_release
    double *read;
} tendon_case;

typedef struct base_case {
    mark at;
    double position[3]; // [m]
    double rotation[3]; // rotation vector [rad]
    double insertion;   // along its own axis, after that [m]
    double turn;        // about its own axis [rad]
} base_case;

// One range of solutions; several make a grid, the last one running fastest.
typedef enum sweep_kind { SWEEP_TENSION, SWEEP_PULL, SWEEP_LOAD, SWEEP_KINDS } sweep_kind;
typedef struct sweep_case {
    mark at;
    key_text of[SWEEP_KINDS];                  // whose tension, pulled length or factor
    double from[SWEEP_KINDS], to[SWEEP_KINDS]; // [N], [m], [-]; NAN: not given
    int steps;
    int kind, index; // filled by rod_case_bind
} sweep_case;

typedef enum rod_start { START_REST, START_LAST } rod_start;

typedef struct rod_case {
    mark at;
    double length; // [m]
    base_case base;
    rest_shape rest;
    key_rows breaks;     // [m]
    key_list tendons;    // of tendon_case
    key_list loads;      // of point_load
    key_list line_loads; // of line_load
    double gravity[3];   // [m/s^2]
    key_rows tensions;   // [nrow][ntendon] [N], >= 0; NAN: the pulled length is given
    key_rows pulls;      // [nrow][ntendon] [m]; NAN: the tension is given
    key_rows factors;    // [nrow][rod_case_loads]
    key_list sweep;      // of sweep_case
    int start;           // rod_start
    bool past, derivatives;
    bool unpulled; // tendons may be without tensions, for somebody else pulls them; no key
    int frame;     // rod_frame in which the rod is solved; the shape is the geometric centreline in
                   // both
    double tolerance;  // |p - p_exact| / L wanted at the tip
    int points;        // of the shape that is written
    tendon_spec *spec; // [tendons.count], filled by rod_case_bind
} rod_case;

extern const key_table rod_keys; // `rod`
rod_case rod_case_default(void);

// Finds what names stand for and makes the tendons ready. ERR_INPUT and the place for
// contradictions that no single key shows: rows that do not fit the tendons, loads beyond the tip,
// both or neither of tension and pulled length.
status rod_case_bind(rod_case *c, mark *where);
void rod_case_release(rod_case *c);

// Loads that a row of factors scales: at points, along lines, then gravity where there is any.
int rod_case_loads(const rod_case *c);
bool rod_case_has_gravity(const rod_case *c);

// How many solutions the case asks for (one more than ROD_CASE_SOLUTIONS: too many), and what one
// of them is: [ntendon], [ntendon], [nload]. pull: NAN where the tension is given; tension: 0 where
// the pulled length is.
int rod_case_solutions(const rod_case *c);
void rod_case_solution(const rod_case *c, int i, double *tension, double *pull, double *load);

// Where the rows stand, for messages about a solution.
mark rod_case_rows(const rod_case *c);

pose rod_case_base(const rod_case *c);

// The rod of a case that is bound, on this law; it points into both.
rod_spec rod_case_spec(const rod_case *c, const law_along *law);
