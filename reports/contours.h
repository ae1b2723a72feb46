// reports/contours.h
// Closed lines round where a field on a raster is at least a level: shaded areas whose size in a
// picture goes with the length of their outlines.
#pragma once

#include "base/status.h"
#include "reports/cairo_door.h"

typedef struct raster {
    int nx, ny;    // points; value [i + nx j]
    double *value; // NAN: below any level
} raster;

typedef struct contours {
    int nloop, npoint;
    int *start;      // [nloop + 1] of each loop's points
    double (*at)[2]; // [npoint] in steps of the raster, counter-clockwise round what is above
} contours;

// The raster's border counts as below. Points that are within `slack` of the line without them are
// left out, and so are loops whose area is less than `least` [steps, steps^2].
status contours_make(const raster *r, double level, double slack, double least, contours *out);
void contours_free(contours *c);

// Means over three by three points, 1 2 1 each way; `from` and `to` differ and are of one size.
void raster_smooth(const raster *from, raster *to);

// Leaves out points of an open line that is nowhere more than `slack` off without them; returns how
// many are left.
int line_simplify(int n, double (*at)[2], double slack);

// A path of all loops: raster point (i, j) at (x + step i, y - step j) on the canvas.
void contours_path(canvas *c, const contours *lines, double x, double y, double step);
