// meshes/morph_knots.h
// How places on the curves of a section move along the rod: corners stay corners and meetings of
// curves stay meetings; between them places move in proportion.
#pragma once

#include "meshes/morph_marks.h"

typedef struct curve_knot {
    int curve;
    double from, to; // place at the base, and now
} curve_knot;

typedef struct curve_knots {
    int nknot;
    curve_knot *knot; // by curve, then by place
    int *first;       // [ncurve + 1] into knot
} curve_knots;

// base and now have as many curves of as many pieces. *same false where curves no longer meet, or
// in another order.
status curve_knots_make(const shape_curves *base, const shape_curves *now, const node_mark *mark,
                        int nmark, double size, curve_knots *out, bool *same);
void curve_knots_free(curve_knots *k);

double curve_knots_place(const curve_knots *k, int curve, int npiece, double from);
