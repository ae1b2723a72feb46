// reach/sample_grid.h
// Points in the cells of a grid, for what is near a place; those that are done are left out.
#pragma once

#include "base/dense.h"
#include "base/status.h"

#include <stdbool.h>

typedef struct sample_grid {
    const double (*point)[3];
    vec3 low;
    double step;
    int n[3];
    int *first; // [cells] into `order`
    int *open;  // [cells] how many of the cell's points are not done; they stand first
    int *order; // [npoint]
    int left;   // points that are not done
} sample_grid;

// Cells of about this size.
status sample_grid_make(int npoint, const double (*point)[3], double size, sample_grid *out);
void sample_grid_free(sample_grid *g);

// Whether a point that is not done is within `radius` of p.
bool sample_grid_any(const sample_grid *g, vec3 p, double radius);

// Calls `visit` for each that is not done within `radius`; one for which it says true is done.
typedef bool sample_visit(void *context, int point);
void sample_grid_near(sample_grid *g, vec3 p, double radius, sample_visit *visit, void *context);
