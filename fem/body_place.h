// fem/body_place.h
// Where the nodes of a body's levels lie: what body_make asks for.
#pragma once

#include "fem/body.h"

// node, axes and origin of the levels held, by the spec's shape or its turn rate.
status body_place(body *b);

// ERR_INPUT where an element of a layer is inverted at one of its nodes, of the layers whose levels
// are held.
status body_check(const body *b);
