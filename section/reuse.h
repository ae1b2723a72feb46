// section/reuse.h
// Sections already solved along a rod: the same section, turned, scaled or mirrored, is solved
// once.
#pragma once

#include "section/place.h"

typedef struct solved_section {
    section_place place;
    beam_law body;     // in the body frame at place.s
    beam_law turned;   // in the frame that is turned by place.turn
    mesh_options mesh; // what it was solved with
} solved_section;

// b is a, mirrored if need be (y -> -y), scaled, and turned by b.turn - a.turn.
typedef struct section_likeness {
    double scale;
    bool mirror;
} section_likeness;

// What all materials of a case allow.
typedef struct material_traits {
    bool along, across; // graded: E over s; E over x and y
    bool anisotropic;
} material_traits;

typedef struct section_store {
    const section_case *request;
    const material *materials; // [request->nmaterial]
    double length;             // of the rod [m]
    material_traits traits;
    material *frozen; // the materials at the place at hand; NULL where none is graded along s
    int count, capacity;
    solved_section *solved;
    section_known laws; // of them, and of those found in request->known
    double resolution;  // of the first one solved, see section_result
    section_effort effort;
} section_store;

status section_store_make(const section_case *c, const material *materials, double length,
                          section_store *out);
void section_store_free(section_store *store);

// The section at s, solved or found; the caller frees its place.
status section_store_law(section_store *store, double s, solved_section *out);

// What the section is at s, with the turning that its K knows.
status section_store_place(const section_store *store, double s, section_place *out);
// Whether the section at b is that at a, moved.
status section_store_alike(const section_store *store, const section_place *a,
                           const section_place *b, section_likeness *k, bool *alike);
// The materials as they are at s; until the next call.
const material *section_store_materials(section_store *store, double s);
