// section/follow.h
// The section along the rod as one and the same mesh with moved nodes: what a 3D body stands on.
// docs/theory.md (5.16)
#pragma once

#include "section/section.h"

typedef struct section_follow section_follow;

// plane: a mesh of the section at arclength `from`, by section_mesh_with; it is followed up to
// `to`. The case and its materials must outlive the result. ERR_INPUT for stacks: their slices are
// voxels; and where the section cannot be followed.
status section_follow_make(const section_case *c, const material *materials, double from, double to,
                           const mesh *plane, section_follow **out);
void section_follow_free(section_follow *f); // NULL is nothing

// xyz [nnode][3]: the nodes in the body frame at s, z = 0. ERR_INPUT where the section cannot be
// followed up to there.
status section_follow_nodes(const section_follow *f, double s, double *xyz);

// The plane mesh's frame `index` at s, in the body frame there; frames move only where
// section_follow_turns_frames.
status section_follow_frame(const section_follow *f, double s, int index, material_frame *out);
bool section_follow_turns_frames(const section_follow *f);

// How the section changes between two arclengths.
typedef struct section_course {
    bool constant;
    bool one_grid; // outlines lie on grids of the same cells everywhere

    bool turns_only;  // all of it turns at one constant rate: shapes, and directions of materials
                      // that have any
    double turn_rate; // then [rad/m]
    double way; // how far its parts move in the body frame, over its radius: turns count in radians
} section_course;
status section_course_between(const section_case *c, const material *materials, double from,
                              double to, section_course *out);
