// tests/rod_shooting_station.h
// The second method for rods under load, part 1: what is known at the nodes of its steps.
// Independent of rodsolver but for the structs that say what the rod is.
#pragma once

#include "base/memory.h"
#include "rodsolver/rod.h"

#include <math.h>
#include <string.h>

enum { SHOOT_TENDONS = 8, SHOOT_LINES = 4, SHOOT_POINTS = 4, SHOOT_NODES = 5, SHOOT_STAGES = 11 };

#define SQRT_21 4.5825756949558400066

// Lobatto's points on [0, 1]: all that Cooper and Verner's method of order 8 looks at
static const double shoot_node_at[SHOOT_NODES] = {0, (7 - SQRT_21) / 14, 0.5, (7 + SQRT_21) / 14,
                                                  1};
static const double shoot_node_weight[SHOOT_NODES] = {1.0 / 20, 49.0 / 180, 16.0 / 45, 49.0 / 180,
                                                      1.0 / 20};

typedef struct shoot_place {
    double x, y, dx, dy;
    double share; // of the tension at the base that is left here; 0 past the tendon's end
} shoot_place;

typedef struct shoot_line {
    int frame;
    double force[3], moment[3], x, y; // zero outside the load's stretch
} shoot_line;

typedef struct shoot_node {
    double K[6][6], rest[6];
    shoot_place place[SHOOT_TENDONS];
    shoot_line line[SHOOT_LINES];
} shoot_node;

typedef struct shoot_step {
    double s, h;
    shoot_node node[SHOOT_NODES];
    double strain[SHOOT_STAGES][6];  // the last local answers: where the next Newton begins
    int npoint, point[SHOOT_POINTS]; // loads at the right end
    int stretch;                     // steps of one stretch are equal, and all is smooth on it
} shoot_step;

typedef struct shooting {
    const rod_spec *spec;
    int nstep, nline; // gravity is a line load more
    shoot_step *step;
} shooting;

static inline void shoot_free(shooting *sh)
{
    free(sh->step);
    *sh = (shooting){0};
}

static inline void shoot_cross(const double *a, const double *b, double *c)
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

// --- tables

static inline double shoot_end(const rod_spec *spec, double end)
{
    return end == 0 || end > spec->law->length ? spec->law->length : end;
}

static inline void shoot_xy(const tendon_spec *t, double s, double *x, double *y)
{
    const double radius = field_at(&t->radius, s), angle = field_at(&t->angle, s);
    *x = radius * cos(angle) + field_at(&t->x, s);
    *y = radius * sin(angle) + field_at(&t->y, s);
}

// slopes by differences of order 8: truncation and rounding both near 1e-13
static inline shoot_place shoot_place_at(const rod_spec *spec, const tendon_spec *t, double s)
{
    static const double weight[4] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
    const double h = 2e-3 * spec->law->length;
    shoot_place p = {.share = s < shoot_end(spec, t->end) ? 1 : 0};
    shoot_xy(t, s, &p.x, &p.y);
    if (field_varies(&t->radius) || field_varies(&t->angle) || field_varies(&t->x) ||
        field_varies(&t->y)) {
        for (int k = 1; k <= 4; k++) {
            double a[2], b[2];
            shoot_xy(t, s + k * h, &a[0], &a[1]);
            shoot_xy(t, s - k * h, &b[0], &b[1]);
            p.dx += weight[k - 1] * (a[0] - b[0]) / h;
            p.dy += weight[k - 1] * (a[1] - b[1]) / h;
        }
    }
    return p;
}

static inline shoot_line shoot_line_at(const rod_spec *spec, const line_load *load, double s)
{
    shoot_line l = {.frame = load->frame};
    if (s > load->from && s < shoot_end(spec, load->to)) {
        for (int c = 0; c < 3; c++) {
            l.force[c] = field_at(&load->force[c], s);
            l.moment[c] = field_at(&load->moment[c], s);
        }
        l.x = field_at(&load->place[0], s);
        l.y = field_at(&load->place[1], s);
    }
    return l;
}

static inline bool shoot_has_gravity(const rod_spec *spec)
{
    return spec->gravity[0] != 0 || spec->gravity[1] != 0 || spec->gravity[2] != 0;
}

static inline shoot_line shoot_gravity_at(const rod_spec *spec, double s)
{
    double centre[2];
    const double mass = law_along_mass(spec->law, s, centre);
    shoot_line l = {.frame = LOAD_SPACE, .x = centre[0], .y = centre[1]};
    for (int c = 0; c < 3; c++) {
        l.force[c] = mass * spec->gravity[c];
    }
    return l;
}

static inline void shoot_node_make(const rod_spec *spec, double s, shoot_node *out)
{
    mat6 K;
    law_along_at(spec->law, s, &K, NULL);
    memcpy(out->K, K.a, sizeof out->K);
    const double rest[6] = {0,
                            0,
                            1,
                            field_at(&spec->rest.curvature_x, s),
                            field_at(&spec->rest.curvature_y, s),
                            field_at(&spec->rest.twist, s)};
    memcpy(out->rest, rest, sizeof rest);
    for (int i = 0; i < spec->ntendon; i++) {
        out->place[i] = shoot_place_at(spec, &spec->tendons[i], s);
    }
    for (int i = 0; i < spec->nline_load; i++) {
        out->line[i] = shoot_line_at(spec, &spec->line_loads[i], s);
    }
    if (shoot_has_gravity(spec)) {
        out->line[spec->nline_load] = shoot_gravity_at(spec, s);
    }
}

static inline int shoot_compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

enum { SHOOT_BREAKS = 256 };

// arclengths between which everything is smooth
static inline int shoot_breaks(const rod_spec *spec, double *s)
{
    const double L = spec->law->length;
    int n = 0;
    for (int i = 0; i <= spec->law->npanel && n < SHOOT_BREAKS / 2; i++) {
        s[n++] = spec->law->edge[i];
    }
    for (int i = 0; i < spec->ntendon; i++) {
        s[n++] = shoot_end(spec, spec->tendons[i].end);
    }
    for (int i = 0; i < spec->npoint_load; i++) {
        s[n++] = fmin(spec->point_loads[i].s, L);
    }
    for (int i = 0; i < spec->nline_load; i++) {
        s[n++] = spec->line_loads[i].from;
        s[n++] = shoot_end(spec, spec->line_loads[i].to);
    }
    for (int i = 0; i < spec->nbreak && n < SHOOT_BREAKS; i++) {
        s[n++] = spec->breaks[i];
    }
    qsort(s, (size_t)n, sizeof *s, shoot_compare);
    int kept = 1;
    for (int i = 1; i < n; i++) {
        if (s[i] - s[kept - 1] > 1e-10 * L) {
            s[kept++] = s[i];
        }
    }
    return kept;
}

static inline void shoot_step_make(const rod_spec *spec, double s, double h, shoot_step *out)
{
    // nodes at a jump belong to this side of it
    const double L = spec->law->length, inside = 1e-13 * L;
    out->s = s;
    out->h = h;
    for (int i = 0; i < SHOOT_NODES; i++) {
        const double at = s + h * shoot_node_at[i];
        shoot_node_make(spec, fmin(fmax(at, s + inside), s + h - inside), &out->node[i]);
    }
    for (int i = 0; i < SHOOT_STAGES; i++) {
        memcpy(out->strain[i], out->node[0].rest, sizeof out->strain[i]);
    }
    for (int i = 0; i < spec->npoint_load; i++) {
        if (fabs(fmin(spec->point_loads[i].s, L) - s - h) < 1e-9 * L &&
            out->npoint < SHOOT_POINTS) {
            out->point[out->npoint++] = i;
        }
    }
}

// about nstep steps over the rod
static inline status shoot_make(const rod_spec *spec, int nstep, shooting *out)
{
    status st = OK;
    double s[SHOOT_BREAKS + 64];
    shooting sh = {.spec = spec, .nline = spec->nline_load + (shoot_has_gravity(spec) ? 1 : 0)};
    if (spec->ntendon > SHOOT_TENDONS || sh.nline > SHOOT_LINES || spec->npoint_load > 16) {
        TRY(status_fail(ERR_BUG, "shooting: more tendons or loads than it was made for"));
    }
    const int n = shoot_breaks(spec, s);
    TRY(TAKE(sh.step, (size_t)(nstep + n)));
    for (int i = 1; i < n; i++) {
        const double part = (s[i] - s[i - 1]) / spec->law->length * nstep;
        const int m = part > 1 ? (int)ceil(part - 1e-6) : 1;
        for (int k = 0; k < m; k++) {
            const double h = (s[i] - s[i - 1]) / m;
            sh.step[sh.nstep].stretch = i;
            shoot_step_make(spec, s[i - 1] + k * h, h, &sh.step[sh.nstep++]);
        }
    }
    *out = sh; // ownership passes only when all is well
    sh = (shooting){0};

done:
    shoot_free(&sh);
    return st;
}
