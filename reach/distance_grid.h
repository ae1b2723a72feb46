// reach/distance_grid.h
// What a distance is at least and at most, without a look at the tree: from the node of a grid that
// is nearest, for it changes no faster than the point moves. Nodes are filled when they are first
// asked for; any number of threads may ask at once.
#pragma once

#include "base/status.h"
#include "reach/distance.h"

typedef struct distance_grid distance_grid;

// About the surface's box. `exact` answers for the nodes; it is asked the same for a node whoever
// asks first.
typedef nearest_point exact_distance(const void *context, vec3 p);
status distance_grid_make(const surface *s, exact_distance *exact, const void *context,
                          distance_grid **out);
void distance_grid_free(distance_grid *g); // NULL is nothing

// From the node that is nearest, or from all eight about it, of which one is mostly on the far side
// from the wall and says three times more. Outside of the box nothing is known: everything,
// INFINITY.
distance_range distance_grid_nearest(distance_grid *g, vec3 p);
distance_range distance_grid_eight(distance_grid *g, vec3 p);
