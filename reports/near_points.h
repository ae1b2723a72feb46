// reports/near_points.h
// Which of many points is nearest.
#pragma once

#include "base/dense.h"
#include "base/status.h"

typedef struct near_points {
    int n;
    const double (*point)[3];
    int *order; // [n] the middle one of a range parts it: less along one axis before it, more after
} near_points;

// `point` is kept by reference.
status near_points_make(int n, const double (*point)[3], near_points *out);
void near_points_free(near_points *t);

// -1 where there is none.
int near_points_find(const near_points *t, vec3 p);
