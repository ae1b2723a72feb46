// app/chain.h
// The whole order: case -> sections -> rods -> 3D segment -> comparisons. Each step starts only
// what it needs: sections no MPI, rods with closed-form or mapped sections neither gmsh nor MPI.
#pragma once

#include "app/case.h"
#include "app/command.h"
#include "reports/result.h"

typedef struct chain_parts {
    bool section, rod, fit, segment, compare, sensitivity;
    bool reach;    // which targets scopes reach; no design search
    bool design;   // the search, and what its design and the case's scopes reach
    bool measured; // the rod against measured shapes
    bool pictures; // what only figures and the store need: the section's mesh, displacements
    bool answers;  // mass, kern, warping constant of the sections, stresses under their wrenches
} chain_parts;

// Everything that the case asks for.
chain_parts chain_all_parts(const case_data *c);

// `out` keeps references to texts of the case, which must outlive it. cmd is asked for progress
// only.
status chain_run(const command *cmd, const case_data *c, chain_parts parts, run_result *out);

// The steps. chain_about fills what does not need computing: title, text, materials.
status chain_about(const command *cmd, const case_data *c, run_result *out);
status chain_section(const case_data *c, bool mesh, run_result *out);
// What the case asks of its stations beyond K; fields: strains and stresses at the nodes of the
// first one too. After chain_section.
status chain_answers(const case_data *c, bool fields, run_result *out);
status chain_points(const case_data *c, run_result *out);
status chain_rods(const command *cmd, const case_data *c, run_result *out); // after chain_section
status chain_measured(const command *cmd, const case_data *c, run_result *out); // after chain_rods
// x and y of a tendon at s as its keys say; of a table what lies between its points.
void chain_tendon_place(const tendon_spec *t, double s, double place[2]);
// What tables and figures call tendon or load i: its name, else its kind and number.
void chain_tendon_name(const rod_case *rc, int i, char name[RESULT_NAME]);
void chain_load_name(const rod_case *rc, int i, char name[RESULT_NAME]);
// Of all tendons and loads; rods has room for them.
void chain_rod_names(const rod_case *rc, rod_result *rods);
// What pictures show beside the solutions; solves for the shape at rest.
status chain_rod_sketch(const rod_case *rc, rod_state *state, rod_result *rods);
// ERR_NUMERIC where a solution ended at a limit point: the result is whole all the same, and marks
// it.
status chain_rod_verdict(const case_data *c, const run_result *r);
// The case's open numbers by its measured shapes.
status chain_fit(const command *cmd, const case_data *c, run_result *out);
status chain_segment(const case_data *c, bool displacements, run_result *out);

// Which targets the case's scopes reach, and its map. With the section where that is solved.
status chain_reach(const command *cmd, const case_data *c, run_result *out);
// One scope more: another one's rod with more of its case's keys set, under a name of its own.
typedef struct reach_extra {
    int scope;
    const struct settings *more;
    char name[REACH_NAME];
} reach_extra;
status chain_reach_with(const command *cmd, const case_data *c, const reach_extra *extra,
                        run_result *out);
// The design that reaches most; nothing is told but on the first rank.
status chain_design(const command *cmd, const case_data *c, run_result *out);

// The plane mesh of the section at arclength s: `order` and `size` of the elements, 0 for the
// case's own.
status chain_plane_mesh(const case_data *c, double s, int order, double size, mesh *out);

// The angle between the tangents at the two ends of a shape, followed continuously along it: past
// pi it goes on [rad].
double chain_total_bend(int npose, const pose *shape);
