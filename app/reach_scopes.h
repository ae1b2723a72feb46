// app/reach_scopes.h
// The scopes of a case, ready to be searched with: rods of this case or another, with some keys
// set, or arcs.
#pragma once

#include "app/case.h"
#include "app/reach_scene.h"
#include "app/variation.h"
#include "reach/scope.h"
#include "section/strain_along.h"

// In place: must not move.
typedef struct reach_scope {
    const scope_case *said;
    scope scope;
    char kind[REACH_NAME];       // "constant curvature", "rod, full K, 1 tendon"
    char limit_note[REACH_TEXT]; // "tension at most 0.8 N, where ..."; "" where nothing is limited
    variation *v;                // what its rod is a variation of; NULL: no rod
    varied rod;
    case_data other; // another case, where its rod is from there ...
    variation own;   // ... and v is this
} reach_scope;

// Scope i of the case. base: the case's own laws, opened by reach_base_open. more: settings that
// come after those of the scope (a design's), NULL: none. Mistakes come with the scope's place.
status reach_scope_make(const case_data *c, variation *base, int i, const settings *more,
                        reach_scope *out);
void reach_scope_free(reach_scope *s);

// `st` as it is, or with the scope's place and name in front of its words where they have no place
// of this case.
status reach_scope_tell(const case_data *c, const scope_case *said, status st);

// Whether scope i could be made: its case is read, nothing is solved.
status reach_scope_check(const case_data *c, int i);

// Whether any scope is the case's own rod; then its laws. section: as variation_open has it.
bool reach_base_needed(const case_data *c);
status reach_base_open(const case_data *c, const section_result *section, variation *out);

// app/reach_strain.c

// Where the materials of a rod are strained: its sections are solved once for all poses.
typedef struct reach_strain_probe reach_strain_probe;
status reach_strain_probe_make(reach_scope *s, reach_strain_probe **out);
void reach_strain_probe_free(reach_strain_probe *p);

// The largest strains of all materials of its case [nmaterial] in a pose.
status reach_strain_at(const reach_strain_probe *p, const double *q, section_strain_place *out);

// Whether poses are refused for their strains: with one tendon its tension is limited before.
bool reach_strain_is_searched(const reach_scope *s);

// The material that is strained furthest past its linear_strain, and by how much of it; *share is
// above 1 past it. -1: no material has one.
int reach_worst_strain(const reach_scope *s, const section_strain_place *strain, double *share);

// That share in a pose.
status reach_strain_share(const reach_strain_probe *p, const double *q, double *share);

// One tendon that is no held one: its tension's upper limit becomes the largest up to which no
// material passes its linear_strain, and limit_note says so.
status reach_limit_tension(reach_scope *s);
