// meshes/shape_frame.h
// Directions of a material that a shape brings along, from the case to the elements of the mesh.
#pragma once

#include "base/mesh.h"
#include "meshes/shape.h"

// The shape's angles at arclength s, on top of its axes, into o->frame; the rest of the outline is
// frozen before. ERR_INPUT, with the shape's place, for an angle that is not finite.
status shape_frame_freeze(const shape_spec *shape, double s, outline *o);

bool shape_frame_varies(const shape_spec *shape); // along the rod

// owner: [elements, block after block] the shape of each. Nothing is taken where no shape has a
// frame.
status shape_frames_to_mesh(const section_outline *o, const int *owner, mesh *m);
