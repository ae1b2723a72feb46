// measure/scan.h
// A scan: points of a tube and what is known of it in, its centreline in the rod's frame out.
#pragma once

#include "base/key.h"
#include "measure/cloud_read.h"
#include "measure/registration.h"
#include "measure/tube.h"

typedef struct scan_fiducial {
    mark at;
    const char *name; // NULL: by its number
    double cloud[3], rod[3];
    double sigma; // NAN: from the residuals
} scan_fiducial;

typedef struct scan_base {
    mark at;
    double point[3], direction[3]; // in the cloud; first entry NAN: not given
} scan_base;

typedef struct scan_plate {
    mark at;
    double point[3]; // near it; first entry NAN: anywhere
    double reach, noise;
} scan_plate;

typedef struct scan_mark {
    mark at;
    double point[3];
    double angle, sigma;
} scan_mark;

enum { SCAN_UNITS = 5, SCAN_MOST_FIDUCIALS = 32, SCAN_SHOWN = 5000 };

// What a scan's file, or --set scan.KEY=..., says; NAN where a number was not given.
typedef struct scan_settings {
    mark at;
    key_text cloud;
    int unit;       // of scan_units; -1: not said
    bool synthetic; // not from a bench
    double radius, length, noise, longest_gap, spacing, smoothing;
    key_rows box; // two corners; nothing outside counts
    scan_base base;
    key_list fiducials; // of scan_fiducial
    scan_plate plate;
    scan_mark mark;
    int seed;
} scan_settings;

extern const key_table scan_keys;

double scan_unit(int unit); // [m]; NAN for -1
const char *scan_unit_name(double metres);

// Words about a body that no soft robot is, with the unit that would make it one; "" for others.
// unit: in which it was read [m].
const char *scan_unit_doubt(double radius, double length, double unit, char *words, size_t size);

// What the rod's frame stands on.
typedef enum scan_frame { SCAN_BY_FIDUCIALS, SCAN_BY_PLATE, SCAN_BY_BODY } scan_frame;

typedef struct scan_residual {
    char name[64];
    double distance; // [m]
} scan_residual;

typedef struct scan_result {
    cloud_report cloud;
    size_t boxed; // points outside the box
    tube_report tube;
    centreline line;   // in the rod's frame; sigma with that of the registration in it
    double *fit_sigma; // [line.count] of the fit alone [m]
    scan_frame frame;
    bool turn_free; // nothing says where x lies
    registration place;
    fiducial_report fiducials;
    int nresidual;
    scan_residual residual[SCAN_MOST_FIDUCIALS];
    cloud_plane plate; // in the cloud
    double lean;       // of the body's first stretch from the frame's z [rad]
    point_cloud shown; // some of the cloud's points, in the rod's frame
    bool synthetic;
    bool radius_given;
} scan_result;

typedef struct scan_progress {
    void (*tell)(void *context, double share); // may be NULL
    void *context;
} scan_progress;

// out->cloud: the reader's report, filled already. `cloud` loses what lies outside the box. name:
// the file's, for messages. ERR_FILE where the points show no tube or cannot have the unit that was
// said, ERR_INPUT where settings contradict each other.
status scan_measure(point_cloud *cloud, const char *name, const scan_settings *settings,
                    scan_progress progress, scan_result *out);
void scan_result_free(scan_result *r);
