// tests/verify/rodsolver/full_rod.h
// A rod with a full K(s), curved and twisted at rest, two tendons, and every kind of load, as it is
// seen in other units, from another base, in a mirror or from its other end.
#pragma once

#include "tests/verify/rodsolver/loaded_rods.h"

// How the rod is seen: its unit of length and of force, from the mirror's other side (y < 0), from
// another base, from the other end.
typedef struct view {
    double length, force, mirror; // mirror: 1 or -1
    bool reversed;
    pose base;
} view;

static const double FULL_LENGTH = 0.12, FULL_GRAVITY = 9.81; // [m, m/s^2]

// a number that varies along the rod: mean + wave sin(rate s + phase), times scale
typedef struct wave {
    double mean, wave, rate, phase, scale;
    const view *v;
} wave;

static inline double wave_at(const void *expression, double s)
{
    const wave *w = (const wave *)expression;
    const double mine = s / w->v->length, here = w->v->reversed ? FULL_LENGTH - mine : mine;
    return w->scale * (w->mean + w->wave * sin(w->rate * here + w->phase));
}

static inline field wave_field(const wave *w)
{
    return (field){.at = wave_at, .expression = w};
}

typedef struct full_rod {
    view v;
    law_along law;
    wave curvature[3], place[2][2], line[3];
    tendon_spec tendon[2];
    point_load point[2];
    line_load along[2];
    rod_spec spec;
    double tension[2];
    rod_request request;
} full_rod;

// --- K(s): diagonally dominant, every entry coupled

static inline mat6 full_K(double s)
{
    static const double diagonal[6] = {4, 5, 12, 8e-5, 1.1e-4, 6e-5};
    mat6 K;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            const double c = cos((i + 1) * (j + 1) + 2 * s / FULL_LENGTH);
            K.a[i][j] = sqrt(diagonal[i] * diagonal[j]) * ((i == j) + 0.15 * c);
        }
    }
    return K;
}

// scaled, and the y axis turned round: by the mirror (y), or seen from the other end (x about pi)
static inline mat6 seen_K(const view *v, mat6 K)
{
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            const double moments = (i > 2) + (j > 2);
            const double end[6] = {1, -1, -1, 1, -1, -1}, side[6] = {1, -1, 1, -1, 1, -1};
            K.a[i][j] *= v->force * pow(v->length, moments);
            K.a[i][j] *= v->reversed ? end[i] * end[j] : 1;
            K.a[i][j] *= v->mirror < 0 ? side[i] * side[j] : 1;
        }
    }
    return K;
}

static inline void make_law(full_rod *p)
{
    const view *v = &p->v;
    const double flip = v->reversed ? -1 : 1;
    CHECK_OK(law_along_make(FULL_LENGTH * v->length, 1, 17, &p->law));
    for (int i = 0; i < 17; i++) {
        const double mine = law_along_node(&p->law, 0, i) / v->length;
        const double s = v->reversed ? FULL_LENGTH - mine : mine;
        beam_law *law = &p->law.law[i];
        law->K = seen_K(v, full_K(s));
        p->law.turn[i] = flip * v->mirror * 1.3 * s / FULL_LENGTH;
        law->mass = 0.02 * (1 + s / FULL_LENGTH) * v->force / v->length;
        law->mass_centre[0] = 1e-3 * v->length;
        law->mass_centre[1] = -5e-4 * v->length * v->mirror * flip;
    }
}

// --- vectors as they are seen: moments and curvatures are axial

static inline vec3 seen_force(const view *v, double x, double y, double z)
{
    return vec3_scale(v->force, vector(x, v->mirror * y, z));
}

static inline vec3 seen_moment(const view *v, double x, double y, double z)
{
    return vec3_scale(v->force * v->length, vector(v->mirror * x, y, v->mirror * z));
}

static inline void make_path(full_rod *p)
{
    const view *v = &p->v;
    const double flip = v->reversed ? -1 : 1, m = v->mirror;
    // -R_x(pi) w from the other end
    p->curvature[0] = (wave){3, 4, 40, 0, m * flip / v->length, v};
    p->curvature[1] = (wave){-5, 2, 25, 1, 1 / v->length, v};
    p->curvature[2] = (wave){2, 3, 30, 2, m / v->length, v};
    p->spec.rest = (rest_shape){.curvature_x = wave_field(&p->curvature[0]),
                                .curvature_y = wave_field(&p->curvature[1]),
                                .twist = wave_field(&p->curvature[2])};
    for (int i = 0; i < 2; i++) {
        p->place[i][0] = (wave){0, 3.6e-3, 20 + 30 * i, 1.5 + i, v->length, v};
        p->place[i][1] = (wave){1e-3 * i, 3.6e-3, 20 + 30 * i, i, m * flip * v->length, v};
        p->tendon[i] =
            (tendon_spec){.x = wave_field(&p->place[i][0]), .y = wave_field(&p->place[i][1])};
        p->tension[i] = (0.3 - 0.1 * i) * v->force;
    }
    p->spec.ntendon = 2;
    p->spec.tendons = p->tendon;
    p->request.tension = p->tension;
}

static inline void copy3(double to[3], vec3 from)
{
    memcpy(to, from.a, sizeof from.a);
}

static inline void make_point_loads(full_rod *p)
{
    const view *v = &p->v;
    const mat3 R = v->base.R;
    for (int i = 0; i < 2; i++) {
        point_load *l = &p->point[i];
        *l = (point_load){.s = FULL_LENGTH * v->length * (0.4 + 0.25 * i),
                          .frame = i == 0 ? LOAD_SPACE : LOAD_BODY,
                          .place = {1e-3 * v->length, -2e-3 * v->mirror * v->length}};
        const vec3 f = seen_force(v, 2e-3, -3e-3, 1e-3), m = seen_moment(v, 1e-5, 2e-5, -4e-5);
        copy3(l->force, i == 0 ? mat3_mul_vec(R, f) : f);
        copy3(l->moment, i == 0 ? mat3_mul_vec(R, m) : m);
    }
    p->spec.npoint_load = 2;
    p->spec.point_loads = p->point;
}

static inline void make_line_loads(full_rod *p)
{
    const view *v = &p->v;
    const double per = v->force / v->length;
    // dead along the world's axes, which a turn mixes: constants there, a wave for the follower
    const vec3 dead = mat3_mul_vec(v->base.R, seen_force(v, 0.02, 0.03, -0.01));
    p->along[0] = (line_load){.from = 0.2 * FULL_LENGTH * v->length, .frame = LOAD_SPACE};
    for (int c = 0; c < 3; c++) {
        p->along[0].force[c] = field_constant(dead.a[c] / v->length);
        const double sign = c == 1 ? v->mirror : 1;
        p->line[c] = (wave){0.01, 0.03, 20, c, per * sign, v};
        p->along[1].force[c] = wave_field(&p->line[c]);
    }
    p->along[1].frame = LOAD_BODY;
    p->along[1].to = 0.7 * FULL_LENGTH * v->length;
    p->along[1].place[0] = field_constant(1e-3 * v->length);
    p->along[1].place[1] = field_constant(2e-3 * v->mirror * v->length);
    p->spec.nline_load = 2;
    p->spec.line_loads = p->along;
}

static inline void make_loads(full_rod *p)
{
    const view *v = &p->v;
    const mat3 R = v->base.R;
    make_point_loads(p);
    make_line_loads(p);
    const vec3 down =
        mat3_mul_vec(R, vector(0.4 * FULL_GRAVITY, -0.5 * v->mirror * FULL_GRAVITY, -FULL_GRAVITY));
    copy3(p->spec.gravity, down);
    p->request.tip_space = wrench_of(mat3_mul_vec(R, seen_force(v, 8e-3, 5e-3, -6e-3)),
                                     mat3_mul_vec(R, seen_moment(v, 1e-4, -2e-4, 1e-4)));
    p->request.tip_body =
        wrench_of(seen_force(v, -2e-3, 1e-3, 3e-3), seen_moment(v, 5e-5, 4e-5, -9e-5));
}

static inline void full_rod_make(full_rod *p, view v, bool loads)
{
    memset(p, 0, sizeof *p);
    p->v = v;
    make_law(p);
    make_path(p);
    if (loads) {
        make_loads(p);
    }
    p->spec.law = &p->law;
    p->request.base = &p->v.base;
    p->request.cold = true;
}

static const view full_plain = {1, 1, 1, false, {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {{0}}}};
