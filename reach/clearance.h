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

// How much of it is asked for, within `tolerance` > 0 [m]. below = -INFINITY, above = 0: all of it.
typedef struct clearance_wish {
    double tolerance;
    double below; // where the clearance is below this, `least` is only some number under it that
                  // the clearance does not exceed, as soon as there is one
    double first; // quicker where this s is near the one where it is least
    double above; // > 0: a clearance of more is told as this one, which is quicker too; 0: as it is
} clearance_wish;

// The least of distance - radius over the whole curve, not of samples: between two places the
// distance changes at most as the curve's length does. Takes |end - begin| / tolerance queries at
// most. A curve's point that is not finite is no room: least is NAN.
void clearance_until(const distance_tree *t, const body_curve *body, double radius,
                     const clearance_wish *wish, clearance *out);
