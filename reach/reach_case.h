// reach/reach_case.h
// What a case says about where its scopes reach: `reach`.
#pragma once

#include "base/key.h"
#include "base/status.h"
#include "reach/scope.h"

enum {
    REACH_SCOPES = 16,
    REACH_TARGETS = 10000,
    REACH_MAP_POINTS = 1000000,
    DESIGN_PARAMETERS = 16
};

// of the numbers in a surface's file
typedef enum reach_unit { REACH_MM, REACH_M, REACH_CM, REACH_UM, REACH_IN } reach_unit;
double reach_unit_metres(int unit);

// A scope's tip as a rod: the case's own, or that of another case file, with some of its keys set.
typedef struct scope_rod_case {
    mark at;
    key_text file; // another case; none: this one
    key_list set;  // of key_text, KEY=VALUE as --set takes them
} scope_rod_case;

// ... or an arc whose curvature is the same all along it.
typedef struct scope_arc_case {
    mark at;
    double length;  // [m]
    double bend[2]; // of its end [rad]
} scope_arc_case;

typedef struct scope_case {
    mark at;
    const char *name;
    double radius;       // of shaft and tip [m]
    double insertion[2]; // of the tip's base along the line, from the entry point [m]
    double turn[2];      // about the line [rad]
    key_rows tensions;   // rod: [least, most] of every tendon [N], a row each
    bool strain_limit;   // rod: no tension that strains a material past its linear_strain
    scope_rod_case rod;
    scope_arc_case constant_curvature;
} scope_case;

// Where scopes come in, and the line that the shaft stays on.
typedef struct entry_case {
    mark at;
    double point[3];     // [m]
    double direction[3]; // of insertion, of any length
    double towards[3];   // a point further along the line [m]; NAN: `direction` is given
    double free; // of the line behind the point, where the shaft may be in tissue (a burr hole's
                 // channel) [m]; NAN: until the line first has room for the shaft
} entry_case;

// towards the inside, not normalized
void entry_direction(const entry_case *e, double direction[3]);

typedef enum reach_tip { REACH_TIP_CENTRE, REACH_TIP_SKIN } reach_tip;
typedef enum reach_path { REACH_FINAL_POSE, REACH_INSERTION } reach_path;

typedef enum reach_paper { REACH_PAPER_NONE, REACH_PAPER_TABLE_4 } reach_paper;

typedef struct reach_map_case {
    mark at;
    int points, seed;
} reach_map_case;

// A number that the design search chooses; its name stands in the expressions of `set`.
typedef struct design_parameter_case {
    mark at;
    const char *name, *unit; // unit: for tables only
    double lower, upper, start;
} design_parameter_case;

typedef enum design_goal { DESIGN_TARGETS, DESIGN_AREA } design_goal;

typedef struct design_case {
    mark at;
    key_text scope;      // by name: whose rod is varied
    key_list parameters; // of design_parameter_case
    key_list set;    // of key_text: KEY=EXPRESSION in the parameters' names, as well as pi, L, s
    int goal;        // design_goal
    int islands;     // searches side by side, each from its own seed; the answer does not
                     // depend on how many run at once
    int evaluations; // of each
    int seed;
} design_case;

typedef struct reach_case {
    mark at;
    key_text tissue;
    int tissue_unit;  // reach_unit
    double merge;     // corners of the file within this are one [m]; 0: by the surface's size
    key_text targets; // a table x, y, z and maybe a name; none: a map alone
    entry_case entry;
    double tolerance; // how near the tip comes [m]
    int tip;          // reach_tip: what of it
    double clearance; // between body and tissue that is left at least [m]
    int path;         // reach_path: what is checked
    bool synthetic;   // said wherever the anatomy is shown
    const char *source;
    int paper; // reach_paper: whose published counts stand beside
    reach_map_case map;
    key_list scopes; // of scope_case
    design_case design;
} reach_case;

extern const key_table reach_keys;  // `reach`
extern const key_table design_keys; // `reach.design`
reach_case reach_case_default(void);

// What no single key shows: names twice, ranges the wrong way round, lines without a direction,
// nothing to reach. ERR_INPUT, *where is the place of it.
status reach_case_check(const reach_case *c, mark *where);
