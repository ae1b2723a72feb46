// meshes/outline_turn.h
// How the pattern of a section lies: its declared turn, and whether that is an axis of symmetry.
#pragma once

#include "meshes/shape.h"

// The mid angle of the last sector; without one the angle of the last rectangle or polygon; else 0
// [rad]
double section_declared_turn(const section_outline *o);

// Whether the last sector's middle is an axis of symmetry of all shapes: each mirrors onto itself,
// or onto another of the same material.
bool section_is_symmetric(const section_outline *o);
