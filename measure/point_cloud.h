// measure/point_cloud.h
// Points of a surface as a scanner gives them.
#pragma once

#include "base/se3.h"
#include "base/status.h"

#include <stddef.h>

typedef struct point_cloud {
    size_t count;
    double (*p)[3]; // [count] [m]
} point_cloud;

enum { CLOUD_MOST_POINTS = 20 * 1000 * 1000 };

void point_cloud_free(point_cloud *c);
