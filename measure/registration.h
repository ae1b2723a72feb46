// measure/registration.h
// From a scanner's frame to the rod's: z along the rod at its base, the base's centre at the
// origin. docs/theory.md (9.40) to (9.44).
#pragma once

#include "base/se3.h"
#include "measure/centreline.h"
#include "measure/point_cloud.h"

typedef struct registration {
    pose place;      // rod = R cloud + p
    mat6 covariance; // of (u, w) [m, rad]: a place p of the rod's frame is p + u + w x p
} registration;

// Where the same feature lies in both frames.
typedef struct fiducial {
    vec3 cloud, rod;
    double sigma;    // of its place, per direction [m]; NAN: from the residuals
    double residual; // distance that remains [m]; filled
} fiducial;

typedef struct fiducial_report {
    double rms;   // of the residuals [m]
    double sigma; // per direction: as stated, or what the residuals say [m]
    double chi2;  // sum of squared residuals over sigma^2; of 3 count - 6 where sigmas were stated
    int freedom;
} fiducial_report;

// Weighted least squares over the rigid motions. ERR_INPUT for fewer than three, all in one line, a
// mirrored frame, or distances that another unit would explain. Sigmas: all stated or none.
status registration_fiducials(int count, fiducial *f, registration *out, fiducial_report *report);

typedef struct plane_options {
    vec3 near;    // a point of the plane, roughly; first entry NAN: anywhere
    double reach; // points within it count [m]; INFINITY
    double noise; // of the scanner [m], roughly: points within three of it lie on the plane
    unsigned long seed;
} plane_options;

typedef struct cloud_plane {
    vec3 centre, normal; // of the points on it
    size_t count;        // of them
    double sigma;        // their distance from it, root mean square [m]
    mat3 axes;           // rows: two directions in the plane, the normal
    double spread[2];    // root mean square of the points along these [m]
} cloud_plane;

// The plane that holds most points, by random triples, then least squares over the points on it.
// ERR_FILE where no plane has more of them than chance.
status plane_find(const point_cloud *cloud, const plane_options *options, cloud_plane *out);

// A known direction across the rod: the feature `cloud` is seen from the axis at `angle`.
typedef struct axis_mark {
    vec3 cloud;
    double angle; // from x about z in the rod's frame [rad]
    double sigma; // of the feature's place [m]; 0 where it is taken as exact
} axis_mark;

// What the frame at the rod's base stands on.
typedef struct base_frame {
    vec3 origin, axis;     // in the cloud; axis into the rod, of length 1
    double origin_sigma;   // across the axis [m]
    double height_sigma;   // along it [m]
    double tilt_sigma;     // of the axis, per direction [rad]
    const axis_mark *mark; // NULL: the turn about the axis is free; x is the cloud's x then, or
                           // its y where that runs along the axis
} base_frame;

// ERR_INPUT where the mark lies on the axis.
status registration_axis(const base_frame *base, registration *out);

// Where the plane cuts a line through p along `direction`; and how well the plane says so [m].
vec3 plane_cut(const cloud_plane *plane, vec3 p, vec3 direction, double *height_sigma);

// The covariance that the registration alone gives to a place of the rod's frame [m^2].
mat3 registration_covariance_at(const registration *r, vec3 rod);

// The root mean square of its deviations in the two directions across `tangent` [m].
double registration_sigma_across(const registration *r, vec3 rod, vec3 tangent);

vec3 registration_place(const registration *r, vec3 cloud);
