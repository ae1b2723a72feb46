// rodsolver/chain.h
#pragma once

#include "rodsolver/rod_plan.h"

// state->pair_pose from state->xi on one plan, docs/theory.md (4.6); the estimate of the tip's
// error over the length, (4.8).
double chain_pairs(rod_state *state, const plan *p);
