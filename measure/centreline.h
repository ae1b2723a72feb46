// measure/centreline.h
// The centreline of a tube as it was measured: a scan's answer, and what `compare` reads.
#pragma once

#include "base/se3.h"
#include "base/status.h"

#include <stdbool.h>

typedef struct centreline {
    int count;
    double *s;     // [count] arclength from the base [m], ascending from 0
    vec3 *p;       // [count] [m]
    double *sigma; // [count] standard deviation of the place across the line [m]; NAN: unknown
    double *own; // [count] the part of sigma that does not move the whole line, as an error of its
                 // registration does [m]; NAN: unknown
    double radius;       // of the tube [m]; NAN: unknown
    double radius_sigma; // [m]
    bool turn_free;      // of the frame: nothing told how the body stood turned about its own z
    double correlation_length; // over which errors along the line go together [m]; NAN: unknown
} centreline;

status centreline_make(int count, centreline *out);
void centreline_free(centreline *c);

// The standard deviation of point i against its neighbours: its own where it is known, else sigma.
double centreline_own_sigma(const centreline *c, int i);

// The place at s, by a cubic through four neighbours; beyond the ends by the last ones.
vec3 centreline_at(const centreline *c, double s);
