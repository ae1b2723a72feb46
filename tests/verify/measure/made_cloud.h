// Synthetic clouds: points of a tube of known centreline, as a scanner could give them. Made for
// tests, not measured. The line is integrated from its curvature here, without rodsolver.
#pragma once

#include "base/memory.h"
#include "measure/gsl_door.h"
#include "measure/point_cloud.h"

#include <math.h>

enum { MADE_STATIONS = 2001, MADE_PATCHES = 64 };

// --- the line: rotation-free frame, curvatures about its own x and y

typedef struct made_line {
    double length;
    pose at[MADE_STATIONS]; // uniform in s, from the origin along z
} made_line;

typedef vec3 (*made_curvature)(double s, double length, const double *parameter); // x, y, twist

static inline vec3 made_arc(double s, double length, const double *parameter)
{
    (void)s, (void)length;
    return (vec3){{parameter[0], parameter[1], parameter[2]}}; // an arc; with a twist a helix
}

// the size of the helical prototype's curvature under load: 37 1/m, 6 near the middle, 45; one
// component changes its sign there
static inline vec3 made_prototype(double s, double length, const double *parameter)
{
    (void)parameter;
    const double x = s / length;
    return (vec3){{41 * (x - 0.47) * 1.9, 6.2 + 18 * pow(x - 0.5, 2), 8 * sin(M_PI * x)}};
}

// straight, then parameter[0] radians at parameter[1] 1/m from the middle on, straight again
static inline vec3 made_bend(double s, double length, const double *parameter)
{
    const double half = parameter[0] / parameter[1] / 2, x = fabs(s - length / 2);
    return (vec3){{x < half ? parameter[1] : 0, 0, 0}};
}

static inline void made_line_make(double length, made_curvature curvature, const double *parameter,
                                  made_line *out)
{
    const double ds = length / (MADE_STATIONS - 1);
    out->length = length;
    out->at[0] = pose_identity();
    for (int i = 0; i + 1 < MADE_STATIONS; i++) {
        const vec3 k = curvature((i + 0.5) * ds, length, parameter);
        const vec6 twist = {{0, 0, ds, k.a[0] * ds, k.a[1] * ds, k.a[2] * ds}};
        out->at[i + 1] = pose_mul(out->at[i], se3_exp(twist));
    }
}

// between two stations along the arc that joins them
static inline pose made_line_at(const made_line *line, double s)
{
    const double x = s / line->length * (MADE_STATIONS - 1);
    const int i = x < 0 ? 0 : x >= MADE_STATIONS - 2 ? MADE_STATIONS - 2 : (int)x;
    const pose step = pose_mul(pose_inverse(line->at[i]), line->at[i + 1]);
    const vec3 w = so3_log(step.R);
    const double h = line->length / (MADE_STATIONS - 1);
    vec6 twist = {{0, 0, h, w.a[0], w.a[1], w.a[2]}};
    return pose_mul(line->at[i], se3_exp(vec6_scale(x - i, twist)));
}

// the direction that is most across all of the line: where a scanner would stand
static inline vec3 made_view(const made_line *line)
{
    vec3 best = {{1, 0, 0}};
    double least = INFINITY;
    for (int k = 0; k < 500; k++) {
        const double z = 1 - (k + 0.5) / 250, turn = 2.39996323 * k, rho = sqrt(1 - z * z);
        const vec3 v = {{rho * cos(turn), rho * sin(turn), z}};
        double along = 0;
        for (int i = 0; i < MADE_STATIONS; i += 20) {
            along = fmax(along, fabs(vec3_dot(v, mat3_mul_vec(line->at[i].R, (vec3){{0, 0, 1}}))));
        }
        best = along < least ? v : best;
        least = fmin(along, least);
    }
    return best;
}

// --- the cloud

typedef enum made_cap { MADE_OPEN, MADE_FLAT, MADE_ROUND } made_cap;

typedef struct made_scan {
    double radius;  // in the middle
    double taper;   // that at the tip less that at the base
    size_t count;   // points on the tube, before any are taken away
    double noise;   // deviation in every direction [m]
    double missing; // share of the surface in patches without points
    double gap[2];  // from, to along s without points; 0, 0: none
    double visible; // angle seen from one side [rad]; 0: all around
    vec3 view;      // from where; 0: from x
    double stray;   // share of the points, uniform in the box
    bool hand;      // three fingers of 8 mm radius that touch the body, and a palm
    bool plate;     // round it at the base, 30 mm wide
    int cap;        // made_cap
    unsigned long seed;
} made_scan;

typedef struct made_patch {
    double s, angle, half_length, half_angle;
} made_patch;

typedef struct made_work {
    const gsl_random_door *door;
    gsl_random *random;
    const made_line *line;
    const made_scan *scan;
    int npatch;
    made_patch patch[MADE_PATCHES];
    size_t room;
    point_cloud cloud;
} made_work;

static inline double made_uniform(made_work *w, double from, double to)
{
    return from + (to - from) * w->door->uniform(w->random);
}

static inline void made_put(made_work *w, vec3 p, double noise)
{
    if (w->cloud.count < w->room) {
        for (int d = 0; d < 3; d++) {
            w->cloud.p[w->cloud.count][d] = p.a[d] + noise * w->door->normal(w->random);
        }
        w->cloud.count++;
    }
}

static inline bool made_patched(const made_work *w, double s, double angle)
{
    for (int i = 0; i < w->npatch; i++) {
        const made_patch *p = &w->patch[i];
        if (fabs(s - p->s) < p->half_length &&
            fabs(remainder(angle - p->angle, 2 * M_PI)) < p->half_angle) {
            return true;
        }
    }
    return false;
}

// patches of 4 to 14 mm by 60 to 180 degrees until the share is reached
static inline void made_patches(made_work *w)
{
    double share = 0;
    while (share < w->scan->missing && w->npatch < MADE_PATCHES) {
        w->patch[w->npatch++] =
            (made_patch){made_uniform(w, 0, w->line->length), made_uniform(w, 0, 2 * M_PI),
                         made_uniform(w, 2e-3, 7e-3), made_uniform(w, M_PI / 6, M_PI / 2)};
        share = 0;
        for (int i = 0; i < 10000; i++) {
            share += made_patched(w, (i / 100 + 0.5) * w->line->length / 100,
                                  (i % 100 + 0.5) * 2 * M_PI / 100) /
                     1e4;
        }
    }
}

// a bent tube has more surface outside: a place is kept by its share of area
static inline void made_tube_point(made_work *w)
{
    const double s = made_uniform(w, 0, w->line->length);
    const double r = w->scan->radius + w->scan->taper * (s / w->line->length - 0.5);
    const double angle = made_uniform(w, 0, 2 * M_PI);
    const pose g = made_line_at(w->line, s);
    const pose g1 = made_line_at(w->line, s + 1e-5);
    const vec3 across = {{cos(angle), sin(angle), 0}};
    const vec3 n = mat3_mul_vec(g.R, across), n1 = mat3_mul_vec(g1.R, across);
    const vec3 p = vec3_add_scaled(g.p, r, n), p1 = vec3_add_scaled(g1.p, r, n1);
    const vec3 axis = mat3_mul_vec(g.R, (vec3){{0, 0, 1}});
    const double area = vec3_dot(vec3_sub(p1, p), axis) / 1e-5;
    const bool in_gap = s > w->scan->gap[0] && s < w->scan->gap[1];
    const vec3 x = {{1, 0, 0}}, view = vec3_norm(w->scan->view) > 0 ? w->scan->view : x;
    const bool hidden = w->scan->visible > 0 && vec3_dot(n, view) < cos(w->scan->visible / 2);
    if (made_uniform(w, 0, 2) < area && !in_gap && !hidden && !made_patched(w, s, angle)) {
        made_put(w, p, w->scan->noise);
    }
}

static inline void made_cap_points(made_work *w, size_t count)
{
    const pose g = made_line_at(w->line, w->line->length);
    const double r = w->scan->radius;
    for (size_t i = 0; i < count && w->scan->cap != MADE_OPEN; i++) {
        const double angle = made_uniform(w, 0, 2 * M_PI), x = made_uniform(w, 0, 1);
        const bool flat = w->scan->cap == MADE_FLAT;
        const double rho = flat ? r * sqrt(x) : r * sqrt(1 - x * x);
        const vec3 at = {{rho * cos(angle), rho * sin(angle), flat ? 0 : r * x}};
        made_put(w, vec3_add(g.p, mat3_mul_vec(g.R, at)), w->scan->noise);
    }
}

static inline void made_plate_points(made_work *w, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const double angle = made_uniform(w, 0, 2 * M_PI);
        const double rho = 30e-3 * sqrt(made_uniform(w, 0, 1));
        if (rho > w->scan->radius) {
            made_put(w, (vec3){{rho * cos(angle), rho * sin(angle), 0}}, w->scan->noise);
        }
    }
}

// fingers across the body at 45, 60 and 75 % of its length, on the side of the frame's -x
static inline void made_hand_points(made_work *w, size_t count)
{
    const double finger = 8e-3;
    const pose middle = made_line_at(w->line, 0.6 * w->line->length);
    for (size_t i = 0; i < count; i++) {
        const pose g = made_line_at(w->line, (0.45 + 0.15 * (double)(i % 3)) * w->line->length);
        const double angle = made_uniform(w, 0, 2 * M_PI), along = made_uniform(w, -25e-3, 40e-3);
        const vec3 at = {
            {-(w->scan->radius + finger) + finger * cos(angle), along, finger * sin(angle)}};
        made_put(w, vec3_add(g.p, mat3_mul_vec(g.R, at)), w->scan->noise);
    }
    for (size_t i = 0; i < count; i++) {
        const double z = made_uniform(w, -1, 1), angle = made_uniform(w, 0, 2 * M_PI);
        const double rho = 35e-3 * sqrt(1 - z * z);
        const vec3 at = {{-12e-3 + rho * cos(angle), 75e-3 + rho * sin(angle), 35e-3 * z}};
        made_put(w, vec3_add(middle.p, mat3_mul_vec(middle.R, at)), w->scan->noise);
    }
}

static inline void made_stray_points(made_work *w, size_t count)
{
    double low[3] = {0}, high[3] = {0};
    for (int i = 0; i < MADE_STATIONS; i++) {
        for (int d = 0; d < 3; d++) {
            low[d] = fmin(low[d], w->line->at[i].p.a[d] - 15e-3);
            high[d] = fmax(high[d], w->line->at[i].p.a[d] + 15e-3);
        }
    }
    for (size_t i = 0; i < count; i++) {
        made_put(w,
                 (vec3){{made_uniform(w, low[0], high[0]), made_uniform(w, low[1], high[1]),
                         made_uniform(w, low[2], high[2])}},
                 0);
    }
}

// the cloud is the caller's: point_cloud_free
static inline status made_cloud(const made_line *line, const made_scan *scan, point_cloud *out)
{
    status st = OK;
    made_work w = {.line = line, .scan = scan, .room = 3 * scan->count + 1000};
    TRY(gsl_random_door_open(&w.door));
    TRY(w.door->make(scan->seed, &w.random));
    TRY(TAKE(w.cloud.p, w.room));
    made_patches(&w);
    for (size_t i = 0; i < 2 * scan->count; i++) { // every other falls to the rule of areas
        made_tube_point(&w);
    }
    made_cap_points(&w, (size_t)((double)scan->count * scan->radius / line->length / 2));
    made_plate_points(&w, scan->plate ? scan->count / 3 : 0);
    made_hand_points(&w, scan->hand ? scan->count / 4 : 0);
    made_stray_points(&w, (size_t)((double)w.cloud.count * scan->stray / (1 - scan->stray)));
    *out = w.cloud;
    w.cloud = (point_cloud){0};

done:
    point_cloud_free(&w.cloud);
    if (w.door) {
        w.door->free(w.random);
    }
    return st;
}
