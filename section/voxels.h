// section/voxels.h
// The section of a stack as voxels: what a 3D body stands on. docs/theory.md (5.16)
#pragma once

#include "section/section.h"

// Whether the section is a stack of images.
bool section_is_stack(const section_case *c);

// Layers of a body from one arclength to another: those of the slices, each in as many equal parts
// as are needed for none to be longer than `longest`. layer [*nlayer + 1] [m] from 0, the caller's
// to free. ERR_INPUT beyond the stack, and where it turns or scales along the rod.
status section_voxel_layers(const section_case *c, double from, double to, double longest,
                            int *nlayer, double **layer);

// One plane mesh for all of them, and what its elements are made of in each layer
// [nlayer][elements]
// (-1: nothing), the caller's to free. ERR_INPUT where it does not hang together.
status section_voxel_plane(const section_case *c, double from, double to,
                           const mesh_options *options, mesh *out);
status section_voxel_matter(const section_case *c, double from, int nlayer, const double *layer,
                            const mesh *plane, int **matter);
