// reports/wall_view.h
// A closed surface of triangles as seen from one side, on a raster: a picture of it is as large as
// its outlines are long, however many triangles it has.
#pragma once

#include "reports/contours.h"
#include "reports/segment_surface.h"

typedef struct wall {
    int nvertex, ntriangle;
    const double (*vertex)[3];
    const int (*triangle)[3];
    double (*normal)[3]; // [nvertex] outwards, of unit length
} wall;

// `vertex` and `triangle` are kept by reference.
status wall_make(int nvertex, const double (*vertex)[3], int ntriangle, const int (*triangle)[3],
                 wall *out);
void wall_free(wall *w);

typedef struct wall_view {
    camera camera;
    int nx, ny;         // 0 where the surface has no size
    double low[2];      // of raster point (0, 0) on the paper [m]
    double step;        // between points [m]
    double *thick;      // [nx ny] how much of the line of sight is enclosed [m]; 0 outside
    double *near, *far; // the first and the last of the wall on the line of sight, towards the eye
                        // [m]; -INFINITY, INFINITY outside
    double *near_light, *far_light; // how squarely those face the eye, 0..1
} wall_view;

// `most` raster points along the longer side.
status wall_view_make(const wall *w, const camera *c, int most, wall_view *out);
void wall_view_free(wall_view *v);

// The place in the world of a raster point of the near (or far) wall.
vec3 wall_view_place(const wall_view *v, int k, bool near);

enum { SHADES = 4 };

// Its outline, and areas of more and more enclosed thickness, as an X-ray shows it.
typedef struct wall_shade {
    contours outline, level[SHADES];
    int nlevel;
} wall_shade;

status wall_shade_make(const wall_view *v, int nlevel, double slack, wall_shade *out);
void wall_shade_free(wall_shade *s);
void wall_shade_draw(canvas *c, const wall_shade *s, double x, double y, double step);
