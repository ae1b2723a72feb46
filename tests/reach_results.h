// tests/reach_results.h
// A reach study made by hand, for tests of what is told of one: an egg as the wall, arcs as scopes,
// every verdict once, a map that is half reached, a search for a design. Nothing is computed by the
// rooms that compute such a thing.
#pragma once

#include "reach/reach_case.h"
#include "reports/reach_result.h"

#include <math.h>
#include <stdio.h>

enum {
    EGG_AROUND = 24,
    EGG_RINGS = 15, // between the poles
    EGG_TARGETS = 6,
    EGG_SAMPLES = 240,
    EGG_SCOPES = 3,
    EGG_BODY = 25,
    EGG_WAY = 5,
    EGG_PARAMETERS = 2,
    EGG_ROWS = 4
};

static const double egg_middle = 35e-3, egg_axis[3] = {18e-3, 14e-3, 36e-3};
static const double egg_length = 30e-3, egg_radius = 1.4e-3;

// a point of the wall: u in [0, 2 pi) around, v in [0, pi] from the upper pole
static inline void egg_place(double u, double v, double to[3])
{
    to[0] = egg_axis[0] * sin(v) * cos(u);
    to[1] = egg_axis[1] * sin(v) * sin(u);
    to[2] = egg_middle + egg_axis[2] * cos(v);
}

// how far a place is from the wall, roughly; positive inside
static inline double egg_depth(const double p[3])
{
    const double x = p[0] / egg_axis[0], y = p[1] / egg_axis[1],
                 z = (p[2] - egg_middle) / egg_axis[2];
    return egg_axis[1] * (1 - sqrt(x * x + y * y + z * z));
}

static inline int egg_corner(int ring, int i)
{
    return 1 + EGG_AROUND * ring + i % EGG_AROUND;
}

static inline void egg_triangle(reach_result *r, int n, int a, int b, int c)
{
    r->triangle[n][0] = a;
    r->triangle[n][1] = b;
    r->triangle[n][2] = c;
}

static inline void egg_wall(reach_result *r)
{
    const double pi = acos(-1.0);
    const int south = r->nvertex - 1;
    int n = 0;
    egg_place(0, 0, r->vertex[0]);
    egg_place(0, pi, r->vertex[south]);
    for (int i = 0; i < EGG_AROUND; i++) {
        egg_triangle(r, n++, 0, egg_corner(0, i), egg_corner(0, i + 1));
        for (int j = 0; j < EGG_RINGS; j++) {
            const int here = egg_corner(j, i), next = egg_corner(j, i + 1);
            egg_place(2 * pi * i / EGG_AROUND, pi * (j + 1) / (EGG_RINGS + 1), r->vertex[here]);
            if (j + 1 < EGG_RINGS) {
                egg_triangle(r, n++, here, egg_corner(j + 1, i), egg_corner(j + 1, i + 1));
                egg_triangle(r, n++, here, egg_corner(j + 1, i + 1), next);
            } else {
                egg_triangle(r, n++, here, south, next);
            }
        }
    }
    r->area = 6.2e-3; // roughly
    r->volume = 4.0 / 3 * pi * egg_axis[0] * egg_axis[1] * egg_axis[2];
}

// the body of an arc: insertion, turn, bend
static inline void egg_point(const double *q, double s, double to[3])
{
    const double a = q[2] * s / egg_length, d = fabs(q[2]) > 1e-9 ? egg_length / q[2] : 0;
    const double across = s > 0 ? d * (1 - cos(a)) : 0;
    to[0] = across * cos(q[1]);
    to[1] = across * sin(q[1]);
    to[2] = q[0] + (s > 0 && d != 0 ? d * sin(a) : s);
}

static inline status egg_answer(int verdict, const double *q, const double *target, reach_answer *a)
{
    status st = OK;
    const int npath = verdict == REACH_REACHED ? EGG_WAY : 0;
    a->verdict = verdict;
    a->joint = verdict == REACH_JOINT_LIMIT ? SCOPE_BEND : -1;
    a->looks = 120;
    a->starts = 7;
    a->clearance = a->s = a->strain = a->path_clearance = NAN;
    a->bound = verdict == REACH_COLLISION ? -0.2e-3 : INFINITY;
    if (verdict == REACH_FAILED) {
        a->miss = NAN;
        return OK;
    }
    TRY(reach_answer_room(a, EGG_BODY, npath));
    a->clearance = INFINITY;
    for (int k = 0; k < EGG_BODY; k++) {
        a->along[k] = -q[0] + (q[0] + egg_length) * k / (EGG_BODY - 1);
        egg_point(q, a->along[k], a->point[k]);
        a->room[k] = egg_depth(a->point[k]) - egg_radius;
        if (a->room[k] < a->clearance) {
            a->clearance = a->room[k];
            a->s = a->along[k];
        }
    }
    for (int k = 0; k < 3; k++) {
        a->q[k] = q[k];
    }
    for (int k = 0; k < npath; k++) {
        const double t = (double)k / (EGG_WAY - 1);
        a->path[k][0] = q[0] * fmin(1, 2 * t);
        a->path[k][1] = q[1];
        a->path[k][2] = q[2] * fmax(0, 2 * t - 1);
        a->path_clearance = 0.4e-3;
    }
    TRY(reach_answer_way(a, npath));
    for (int k = 0; k < npath; k++) {
        const double *from = a->path[k], whole = from[0] + egg_length;
        for (int i = 0; i < REACH_WAY_POINTS; i++) {
            egg_point(from, -from[0] + whole * i / (REACH_WAY_POINTS - 1), a->way[k][i]);
        }
    }
    const double *tip = a->point[EGG_BODY - 1];
    a->miss = hypot(hypot(tip[0] - target[0], tip[1] - target[1]), tip[2] - target[2]);
    a->strain = verdict == REACH_REACHED ? 0.021 : NAN;

done:
    return st;
}

static inline status egg_scope(reach_result *r, int i, bool hostile)
{
    static const char *const names[EGG_SCOPES] = {"clinical", "helical", "two tendons"};
    static const char *const hostile_names[EGG_SCOPES] = {"</script><script>alert(1)</script>",
                                                          "=cmd|' /C calc'!A0", "a \"b\" & c"};
    static const char *const kinds[EGG_SCOPES] = {"constant curvature", "rod, full K, 1 tendon",
                                                  "rod, full K, 2 tendons"};
    static const char *const why[] = {"",
                                      "the nearest pose misses by more than the tolerance",
                                      "the bend stands at its limit",
                                      "the body is in tissue at s = 12.5 mm",
                                      "no way in was found",
                                      "the rod has no equilibrium <there>"};
    status st = OK;
    const double pi = acos(-1.0);
    reach_scope_result *s = &r->scope[i];
    (void)snprintf(s->name, sizeof s->name, "%s", (hostile ? hostile_names : names)[i]);
    (void)snprintf(s->kind, sizeof s->kind, "%s", kinds[i]);
    (void)snprintf(s->limit_note, sizeof s->limit_note, "%s",
                   i == 1 ? "tension limited by the strain of soft" : "");
    s->length = egg_length;
    s->radius = egg_radius;
    s->arc = i == 0;
    s->njoint = i == 2 ? 4 : 3;
    const double high[4] = {60e-3, pi, i == 0 ? 1.5 * pi : 2, 2};
    for (int k = 0; k < s->njoint; k++) {
        s->high[k] = high[k];
        s->low[k] = k == SCOPE_TURN ? -pi : 0;
    }
    s->spacing = 0.2e-3;
    for (int k = 0; k < r->ntarget; k++) {
        const int verdict = (k + i) % (REACH_FAILED + 1);
        const double q[SCOPE_JOINTS] = {20e-3 + 2e-3 * k, 0.9 * k - 2, 0.3 + 0.15 * k};
        reach_answer *a = &s->answer[k];
        TRY(egg_answer(verdict, q, r->target[k], a));
        (void)snprintf(a->why, sizeof a->why, "%s", why[verdict]);
        s->nreached += verdict == REACH_REACHED;
    }
    for (int k = 0; k < r->nmap; k++) {
        const double *p = r->map_point[k], edge = (10 + 8 * i) * 1e-3;
        s->state[k] = fabs(p[2] - egg_middle) < edge          ? MAP_REACHED
                      : fabs(p[2] - egg_middle) < edge + 2e-3 ? MAP_UNDECIDED
                                                              : MAP_NOT_REACHED;
        s->area_reached += (double)(s->state[k] == MAP_REACHED) / r->nmap;
        s->area_undecided += (double)(s->state[k] == MAP_UNDECIDED) / r->nmap;
    }
    s->area_error = 0.03;
    s->map_spacing = 0.5e-3;
    s->seconds = 0.25 + i;

done:
    return st;
}

static inline void egg_targets(reach_result *r, bool hostile)
{
    for (int k = 0; k < r->ntarget; k++) {
        const double q[3] = {20e-3 + 2e-3 * k, 0.9 * k - 2, 0.3 + 0.15 * k};
        egg_point(q, egg_length, r->target[k]);
        r->target[k][0] += 0.1e-3; // the tip is that far from it
        r->target_depth[k] = egg_depth(r->target[k]);
        (void)snprintf(r->target_name[k], REACH_NAME,
                       hostile && k == 0 ? "<img src=x>, \"%d\"" : "t%d", k + 1);
    }
}

static inline void egg_design(reach_design_result *d)
{
    static const char *const names[EGG_PARAMETERS] = {"width", "turns"};
    (void)snprintf(d->scope, sizeof d->scope, "helical");
    d->goal = DESIGN_TARGETS;
    for (int i = 0; i < EGG_PARAMETERS; i++) {
        (void)snprintf(d->name[i], REACH_NAME, "%s", names[i]);
        (void)snprintf(d->unit[i], REACH_NAME, "%s", i == 0 ? "rad" : "");
        d->lower[i] = i == 0 ? 0.3 : -2;
        d->upper[i] = i == 0 ? 2.5 : 2;
        d->start[i] = i == 0 ? 1.57 : -1;
    }
    for (int i = 0; i < EGG_ROWS; i++) {
        reach_design_row *row = &d->row[i];
        row->value[0] = 1.57 - 0.1 * i;
        row->value[1] = -1 + 0.3 * i;
        row->goal = i % 2 ? 5 : 4;
        row->score = row->goal + 0.1 * i;
        row->island = i / 2;
        row->evaluation = 1 + 17 * (i % 2);
    }
    d->best = 3;
    d->start_goal = 4;
    d->start_score = 4.05;
    d->evaluations = 80;
    d->failed = 3;
    d->islands = 2;
    d->seed = 1;
}

// hostile: names that are markup, formulas and quotes. map, design: with these parts.
static inline status reach_results_make(bool hostile, bool map, bool design, reach_result *out)
{
    status st = OK;
    const reach_result sizes = {
        .nvertex = EGG_AROUND * EGG_RINGS + 2,
        .ntriangle = 2 * EGG_AROUND * EGG_RINGS,
        .ntarget = EGG_TARGETS,
        .nmap = map ? EGG_SAMPLES : 0,
        .nscope = EGG_SCOPES,
        .design = {.there = design, .nparameter = EGG_PARAMETERS, .nrow = EGG_ROWS}};
    TRY(reach_result_make(&sizes, out));
    reach_result *r = out;
    r->synthetic = true;
    (void)snprintf(r->source, sizeof r->source, "%s", hostile ? "<b>&</b>" : "an egg of formulas");
    (void)snprintf(r->tissue, sizeof r->tissue, "egg.stl");
    r->entry_free = 4e-3;
    r->tolerance = 1e-3;
    r->resolution = 5e-5;
    r->map_seed = 1;
    r->path = REACH_INSERTION;
    r->paper = hostile ? REACH_PAPER_NONE : REACH_PAPER_TABLE_4;
    egg_wall(r);
    egg_targets(r, hostile);
    for (int k = 0; k < r->nmap; k++) { // a spiral from pole to pole
        const double z = 1 - (2 * k + 1.0) / r->nmap;
        egg_place(2.4 * k, acos(z), r->map_point[k]);
    }
    for (int i = 0; i < r->nscope; i++) {
        TRY(egg_scope(r, i, hostile));
    }
    if (design) {
        egg_design(&r->design);
    }

done:
    return st;
}
