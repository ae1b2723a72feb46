// reports/rod_outline.h
// The outline of a rod's section, a few points around it, as pictures in space wear it.
#pragma once

#include "reports/result.h"
#include "reports/scene.h"

typedef struct rod_outline {
    int nloop, npoint;
    int *loop;          // [nloop] points of each: the outside counter-clockwise, holes clockwise
    double (*point)[2]; // [npoint] [m]
    unsigned char *ink; // [npoint] material of the piece from there to the next point
    int nink;
    colour colour[16]; // of the materials
    bool used[16];     // whether any of it lies at the surface
    bool plain;        // one colour, which is no material's
    double radius;     // of the point farthest out [m]
    double *turn;      // [nring] of the outline along the rod [rad]
    char why[200];     // what is not as the section is; "" where all is
} rod_outline;

// s [nring]: where along the rod. Of a section that was not meshed, a circle of its area.
status rod_outline_make(const run_result *r, int nring, const double *s, rod_outline *out);
void rod_outline_free(rod_outline *o);

// A result that was not told its shape at rest holds zeros.
bool rod_rest_is_known(const rod_result *rod);
