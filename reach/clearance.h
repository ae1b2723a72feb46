// reach/clearance.h
// How much room a body leaves: a tube about a curve, inside a surface.
#pragma once

#include "reach/distance.h"

// A curve s -> p(s). |p(s) - p(t)| <= stretch |s - t| must hold: 1 for a curve by its arc length,
// 1 + its largest strain for a rod.
typedef struct body_curve {
    vec3 (*at)(const void *context, double s);
    const void *context;
    double begin, end; // s [m]
    double stretch;
    // room that a point has whatever the wall, as in a channel; it changes no faster than the point
    // moves. NULL: none
    double (*anyway)(const void *context, vec3 p);
} body_curve;

typedef struct clearance {
    double least; // at s, anyway's room included; negative: the skin is within the tissue by so
                  // much [m]
    double bound; // it is nowhere less: least - tolerance <= bound <= least [m]
    double s;     // where
    vec3 point;   // on the curve
    nearest_point wall; // the wall's point that is nearest to it
    int queries;        // distances asked for
} clearance;

// The least of distance - radius over the whole curve, not of samples: between two places the
// distance changes at most as the curve's length does. Takes |end - begin| / tolerance queries at
// most, tolerance > 0 [m]. A curve's point that is not finite is no room: least is NAN.
void clearance_along(const distance_tree *t, const body_curve *body, double radius,
                     double tolerance, clearance *out);

// The same as far as it decides: where the clearance is below `below`, `least` is only some number
// under it that the clearance does not exceed, as soon as there is one. Quicker where the place s =
// `first` is near the one where it is least.
typedef struct clearance_wish {
    double tolerance, below, first;
    double above; // > 0: a clearance of more is told as this one, which is quicker too; 0: as it is
} clearance_wish;
void clearance_until(const distance_tree *t, const body_curve *body, double radius,
                     const clearance_wish *wish, clearance *out);

// Whether the clearance is nowhere below `least`, as soon as that is known: true only where the
// bound says so, so that a body within `tolerance` of it counts as not free. *at (may be NULL)
// where it is least so far; the first place found to be too near where it is not free.
bool clearance_is_free(const distance_tree *t, const body_curve *body, double radius, double least,
                       double tolerance, clearance *at);
