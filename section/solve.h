// section/solve.h
// One section from its outlines, with its error estimate. section_solve and section_along meet
// here.
#pragma once

#include "section/place.h"

// What a law was solved on.
typedef struct section_used {
    bool meshed;       // false: closed form, no mesh was made
    mesh_options mesh; // the case's, or what met its tolerance
} section_used;

// The law in the body frame at the place, of a pattern that turns there as it does.
status section_solve_place(const section_case *c, const material *materials, const section_place *p,
                           beam_law *out, section_used *used);

// What the resolution of the section's file is worth: K of the place drawn at half of it against
// `law`, relative; 0 where the file has none.
status section_resolution(const section_case *c, const material *materials, const section_place *p,
                          const beam_law *law, double *out);
