// The centreline of a tube (a round body of one radius) from points of its surface, docs/theory.md
// section "Measurements": traced along the body by short curved cylinders, then one smoothing
// spline for the whole line. Points that belong to something else (a hand, the base plate, strays)
// are left out; places without points are bridged.
#pragma once

#include "measure/centreline.h"
#include "measure/point_cloud.h"

#include <stdbool.h>

typedef struct tube_options {
    double radius;      // outer radius [m]; NAN: found, one for the whole body
    vec3 base;          // where the line begins [m], to half a radius; first entry NAN: not known,
                        // the line then begins at the end that is nearer to the frame's origin
    vec3 direction;     // of the line at `base`, into the body, to 20 degrees; NAN: found
    bool base_is_plane; // s = 0 is the plane through `base` normal to `direction`; else the end of
                        // the points there
    double length;      // expected [m]: nothing is traced beyond it by more than a diameter; NAN
    double noise;       // of the scanner [m]; NAN: found
    double longest_gap; // without points that is bridged [m]; NAN: six radii
    double spacing;     // of the answer's points along s [m]; NAN: a quarter radius
    double smoothing;   // length below which the line is smoothed [m]; NAN: by cross-validation
    unsigned long seed; // of the random choice of places to begin at
    void (*progress)(void *context, double share); // 0 to 1; may be NULL
    void *context;
} tube_options;

typedef enum tube_tip { TUBE_TIP_OPEN, TUBE_TIP_FLAT, TUBE_TIP_ROUND } tube_tip;

enum { TUBE_MOST_GAPS = 16 };

typedef struct tube_gap {
    double from, to; // [m] along s: less than a quarter of the circumference is seen here
    double angle;    // seen at its emptiest place [rad]
} tube_gap;

typedef struct tube_report {
    size_t points; // in the cloud
    size_t
        thinned;  // near the tube, and looked at for its line: every so manyth where there are many
    size_t used;  // of these, on the tube: within the loss' reach
    size_t stray; // of these, not: something else's
    int ncylinder;       // fitted while tracing
    double length;       // of the line [m]
    double unseen_base;  // length from the base on without points [m]
    double missing;      // of the expected length [m]; NAN: none was given
    bool length_differs; // it is much: not all of the tip is seen, or another length is meant
    double length_sigma; // from both ends', and what is missing [m]
    double base_sigma,
        tip_sigma;   // of the ends along the line [m]; base_sigma 0: given by the plane
    int tip;         // tube_tip: what closes the tip
    double rms;      // of the used points' distances from the tube [m]
    double noise;    // of one point across the surface, robustly [m]
    double coverage; // share of the surface that was seen
    double radius_free,
        radius_free_sigma;     // what the points alone say, also where a radius was given
    double taper, taper_sigma; // the radius at the tip less that at the base [m]; 0: one radius
    double beyond,
        beyond_radius;   // a tube of another radius goes on behind the tip, so far [m]; 0: none
    bool radius_differs; // a given radius differs from that by more than 1 % and 6 sigma
    double smoothing;    // length that was used [m]
    double freedom;      // parameters that the points decided, of the line
    int ngap;
    tube_gap gap[TUBE_MOST_GAPS];
} tube_report;

tube_options tube_options_default(void); // nothing known, seed 1

// line->sigma: root mean square of the standard deviations in the two directions across the line.
// ERR_FILE "..." where the points show no tube (too few, a plane, a ball, a volume), or two that
// could be meant; ERR_INPUT where options contradict one another or the points.
status tube_centreline(const point_cloud *cloud, const tube_options *options, centreline *line,
                       tube_report *report);
