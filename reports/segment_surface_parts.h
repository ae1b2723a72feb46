// reports/segment_surface_parts.h
// What the files of segment_surface.h share.
#pragma once

#include "reports/segment_surface.h"

// a copy of a node for the material that it belongs to
typedef struct surface_copy {
    int node, material, apart;
} surface_copy;

typedef struct surface_point surface_point;
typedef struct surface_maker surface_maker;

struct surface_maker {
    const segment_body *body;
    const segment_load_result *load;
    surface_value value;
    double magnify;
    const camera *camera;
    vec3 light;
    double radius; // of a circle about the origin that holds the section [m]
    int ncopy;
    surface_copy *copy; // [ncopy], by node and material
    int room;
    segment_surface out;
    int wanted_around, wanted_along; // facets, so that a circle looks round
    int material, part;              // of the facet at hand: sides 0, faces across 1
    bool below;                      // faces that look down too
    // who takes the facets instead of `out`, whatever side they face; NULL: nobody
    status (*take)(surface_maker *m, int n, const surface_point *const *corner);
    void *taker;
};

struct surface_point {
    vec3 at; // deformed, magnified [m]
    double value;
    vec3 rest, move; // [m]
};

// nodes of a side or of a plane element, and their copies
typedef struct surface_nodes {
    int count;
    const int *node, *apart; // apart: only looked at where stresses are
} surface_nodes;

// sum of N_i M_k over the nodes and levels
surface_point surface_point_of(const surface_maker *m, const surface_nodes *at, const double *N,
                               int level, int nlevel, const double *M);

// Facets that do not face the eye are left out.
status surface_add_facet(surface_maker *m, int n, const surface_point *const *corner, bool border);

double surface_radius(const segment_body *body);

int surface_copy_of(const surface_maker *m, int node, int material);

// Sides of all layers and what is open above: reports/segment_sides.c
status surface_add_all(surface_maker *m);
