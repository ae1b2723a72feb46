// fem/segment_material.h
// What the 3D segment can be made of.
#pragma once

#include "base/material.h"
#include "base/mesh.h"

// Isotropic materials, uniform over the section and along the rod: else ERR_INPUT, with the
// material's place.
status segment_takes_material(const material *m);

// The same of all that a mesh is made of.
status segment_check_materials(const mesh *plane, const material *materials);
