// rodsolver/lie_step.h
// One step of g' = g hat(xi) on SE(3): Magnus expansion of order 6 on the three Gauss-Legendre
// stations of a panel.
#pragma once

#include "base/se3.h"
#include "rodsolver/lanes.h"

enum { GAUSS_STATIONS = 3 };

// Gauss-Legendre points on [0, 1] and their weights.
extern const double gauss_point[GAUSS_STATIONS], gauss_weight[GAUSS_STATIONS];

// The twist whose exponential carries g over a panel of length h with strains xi at its three Gauss
// points.
vec6 lie_step_twist(double h, const vec6 xi[GAUSS_STATIONS]);

// The motion over eight panels at once.
typedef struct lanes_pose {
    lanes R[3][3], p[3];
} lanes_pose;

void lie_step_lanes(const lanes *h, const lanes xi[GAUSS_STATIONS][6], lanes_pose *out);

// Cardinal polynomials of the six Gauss stations of two equal panels, at t in [0, 2] panel lengths:
// weight[6].
void lie_pair_weights(double t, double *weight);

// The motion over the first t in [0, 2] panel lengths of a pair of panels of length h each, by the
// polynomial through the strains at its six stations.
pose lie_pair_pose(double h, const vec6 xi[2 * GAUSS_STATIONS], double t);
