// meshes/carrier.h
// The curves that outlines are made of: straight lines, arcs of ellipses (circles among them) and
// cubic Bezier curves.
#pragma once

#include <stdbool.h>

typedef enum carrier_kind { CARRIER_LINE, CARRIER_ELLIPSE, CARRIER_CUBIC } carrier_kind;

// A piece of a curve, x(t) for t between `from` and `to`.
//   line      p0 + (p1 - p0) t, from 0 to 1
//   ellipse   p0 + p1 cos t + p2 sin t: centre and two conjugate half axes; |to - from| < pi, and
//             to < from runs backwards
//   cubic     its control points p0 to p3, from 0 to 1
typedef struct carrier {
    carrier_kind kind;
    double p[4][2], from, to;
} carrier;

carrier carrier_line(const double a[2], const double b[2]);
// half axes `first` at `angle` and `second` across it [rad]
carrier carrier_arc(const double centre[2], double first, double second, double angle, double from,
                    double to);
// An arc of any length up to a full turn, to >= from, as pieces that end where the tangent runs
// along an axis, and on a long ellipse also where it runs between them: its sharp ends are pieces
// of their own. Returns how many.
enum { CARRIER_MOST_PIECES = 10 };
int carrier_divided(const double centre[2], double first, double second, double angle, double from,
                    double to, carrier out[CARRIER_MOST_PIECES]);
carrier carrier_cubic(const double *control); // [4][2]

void carrier_point(const carrier *c, double t, double x[2]);
void carrier_slope(const carrier *c, double t, double dx[2]); // dx/dt
void carrier_start(const carrier *c, double x[2]);
void carrier_end(const carrier *c, double x[2]);

// The piece turned about the origin by `angle`, then moved; `mirror` -1 flips y before that.
carrier carrier_moved(const carrier *c, double angle, const double shift[2], int mirror);
carrier carrier_scaled(const carrier *c, double factor);
carrier carrier_reversed(const carrier *c);

// The piece with its ends moved a little: an arc becomes part of another ellipse about its centre.
carrier carrier_bent(const carrier *c, const double by_start[2], const double by_end[2]);

// Points whose convex hull holds the part between two parameters; they begin and end with its ends,
// and in between turn at least as much as it does. Returns how many, 2 to 4.
enum { CARRIER_HULL = 4 };
int carrier_hull(const carrier *c, double from, double to, double hull[CARRIER_HULL][2]);

// Largest angle that the tangent can turn by along the piece [rad]; 0 for a straight one.
double carrier_turn(const carrier *c);

// Twice the area that the piece sweeps seen from `about`, positive where it runs
// counter-clockwise.
double carrier_sweep(const carrier *c, const double about[2]);

// Parity of the piece's crossings with the ray from (x, y) towards larger x.
bool carrier_crosses(const carrier *c, double x, double y);

// Distance to the nearest point of the piece, or of the whole ellipse, and the parameter there;
// exact where the point is near the curve, which it is asked for.
double carrier_distance(const carrier *c, const double x[2], double *t);
