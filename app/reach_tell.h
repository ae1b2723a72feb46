// app/reach_tell.h
// What is told of the poses that a search found: strains, the body for pictures, the reason in
// words.
#pragma once

#include "app/reach_run.h"

// Of all answers of a scope that is a rod; one whose material is strained past its limit does not
// count as reached where the case says so.
status reach_tell_strains(const reach_study *how, const reach_scope *s,
                          const reach_strain_probe *strains, reach_scope_result *r);

// Last of all: every tendon as a joint, also those whose tension nothing changes.
void reach_tell_tendons(const reach_scope *s, int ntarget, reach_scope_result *r);

// Samples of the body from the entry to the tip [a->npoint], and the room at each; of the way in
// some bodies too.
status reach_tell_body(const reach_study *how, scope_state *state, reach_answer *a);

// a->why where the target is not reached, and what of the tip `miss` is about.
void reach_tell_reason(const reach_study *how, const reach_scope *s, reach_answer *a);
