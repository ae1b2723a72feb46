// reach/surface_inside.h
// The steps of surface_make, in their order.
#pragma once

#include "reach/surface.h"

typedef struct surface_work {
    surface s;
    const surface_options *options;
    surface_report *report;
    double diagonal; // of the box [m]
    int *part;       // [ntriangle]
} surface_work;

// surface_merge.c: fills vertex, triangle and the box
status surface_merge(surface_work *w, int ntriangle, const double (*corner)[3][3]);
// surface_edges.c: fills across; every edge has two triangles
status surface_pair_edges(surface_work *w);
// surface_orient.c: fills part; the pieces' triangles alike, each piece's volume positive
status surface_orient(surface_work *w);
// surface_flat.c: turns edges where a triangle has three corners on one line
status surface_flip_flat(surface_work *w);
// surface_cross.c: no two triangles cross or touch but at what they share
status surface_check_crossings(surface_work *w);
// surface_nest.c: turns pieces that bound islands
status surface_nest(surface_work *w);

// ERR_FILE "FILE: words, one at (x, y, z) mm"
status surface_fail(const surface_work *w, const double place[3], const char *format, ...)
    __attribute__((format(printf, 3, 4)));
// turns triangle t round, and keeps `across` right
void surface_turn(surface *s, int t);
double surface_part_volume(const surface_work *w, int part);
