// section/place.h
// What the section is at one arclength, before anything is meshed or solved: outlines, or a slice
// of a file, and how its pattern lies and turns.
#pragma once

#include "section/section.h"

typedef struct section_place {
    double s;                // [m]
    bool drawn;              // outlines are known; else a slice of the case's file
    section_outline outline; // in the body frame at s
    int slice;
    double scale;     // of a slice; outlines are scaled already
    double turn;      // of the pattern in the body frame [rad]
    double turn_rate; // [rad/m]; 0 where shapes turn at different rates: `uneven`
    bool uneven;
    bool has_symmetry;
} section_place;

// length: of the rod, for the turn's rate near its ends.
status section_place_at(const section_case *c, double s, double length, section_place *out);
void section_place_free(section_place *p);

// In the body frame at s.
status section_place_mesh(const section_case *c, const section_place *p,
                          const mesh_options *options, mesh *out);
