// tests/verify/rodsolver/loaded_rods.h
// Rods under load for the tests: uniform laws, one solve from rest, and an equilibrium's own
// differential equation, integrated independently of the solver.
#pragma once

#include "rodsolver/rod.h"
#include "tests/test.h"

#include <string.h>

#define LOADED_PI 3.14159265358979323846

enum { LOADED_MAX_TENDONS = 200 };

// K the same all along; the caller frees it
static inline law_along uniform_law(double length, mat6 K)
{
    law_along law = {0};
    CHECK_OK(law_along_make(length, 1, 1, &law));
    law.law[0].K = K;
    return law;
}

static inline mat6 diagonal_K(double GAx, double GAy, double EA, double EIx, double EIy, double GJ)
{
    const double diagonal[6] = {GAx, GAy, EA, EIx, EIy, GJ};
    mat6 K = {0};
    for (int i = 0; i < 6; i++) {
        K.a[i][i] = diagonal[i];
    }
    return K;
}

// EA = GA = stiff EI / L^2. p' = R e_z + N / EA then, so that a tip force leaves R alone but adds
// its part of s N / EA to p: the inextensible solution is exact at any `stiff`.
static inline law_along even_law(double length, double EI, double GJ, double stiff)
{
    const double EA = stiff * EI / (length * length);
    return uniform_law(length, diagonal_K(EA, EA, EA, EI, EI, GJ));
}

typedef struct solved {
    rod *r;
    rod_state *state;
    rod_solution out;
    double tension[LOADED_MAX_TENDONS], length[LOADED_MAX_TENDONS];
    status st;
} solved;

static inline void solved_free(solved *s)
{
    rod_state_free(s->state);
    rod_free(s->r);
    s->state = NULL;
    s->r = NULL;
}

// the answer's own arrays move with it
static inline status solved_again(solved *s, const rod_request *request)
{
    s->out = (rod_solution){.tension = s->tension, .tendon_length = s->length};
    s->st = rod_solve(s->state, request, &s->out);
    return s->st;
}

// made and solved from rest; s->st is the solve's outcome, whatever it is. The caller frees it.
static inline void solve_from_rest(solved *s, const rod_spec *spec, rod_options options,
                                   const rod_request *request)
{
    memset(s, 0, sizeof *s);
    s->st = ERR_BUG;
    CHECK_OK(rod_make(spec, &options, &s->r));
    if (s->r) {
        CHECK_OK(rod_state_make(s->r, &s->state));
    }
    if (s->state) {
        solved_again(s, request);
    }
}

// the same where nothing may go wrong
static inline void solve_well(solved *s, const rod_spec *spec, rod_options options,
                              const rod_request *request)
{
    solve_from_rest(s, spec, options, request);
    CHECK_OK(s->st);
    if (s->st == OK) {
        CHECK_WITHIN(s->out.fraction, 1, 0);
    }
}

static inline double gap(vec3 p, vec3 q)
{
    return vec3_norm(vec3_sub(p, q));
}

static inline double turn_gap(mat3 a, mat3 b)
{
    double worst = 0;
    for (int i = 0; i < 9; i++) {
        worst = fmax(worst, fabs(a.a[i / 3][i % 3] - b.a[i / 3][i % 3]));
    }
    return worst;
}

static inline vec3 vector(double x, double y, double z)
{
    return (vec3){{x, y, z}};
}

static inline vec6 wrench_of(vec3 force, vec3 moment)
{
    return (vec6){{force.a[0], force.a[1], force.a[2], moment.a[0], moment.a[1], moment.a[2]}};
}

// --- the differential equation: p' = R v, R' = R hat(w), N' = -f, M' = -p' x N, the wrench (N, M)
// along fixed axes, f dead

typedef struct marching {
    const law_along *law;
    const rest_shape *rest; // NULL: straight
    vec3 f;                 // dead force per arclength [N/m]
} marching;

typedef struct march_state {
    pose g;
    vec3 N, M;
} march_state;

enum { MARCH_SIZE = sizeof(march_state) / sizeof(double) };

static inline march_state march_rate(const marching *m, double s, const march_state *y)
{
    mat6 K, F;
    law_along_at(m->law, s, &K, NULL);
    CHECK(mat6_inverse_spd(K, &F));
    const vec3 n = mat3_tmul_vec(y->g.R, y->N), moment = mat3_tmul_vec(y->g.R, y->M);
    vec6 xi = mat6_mul_vec(F, wrench_of(n, moment));
    xi.a[2] += 1;
    if (m->rest) {
        xi.a[3] += field_at(&m->rest->curvature_x, s);
        xi.a[4] += field_at(&m->rest->curvature_y, s);
        xi.a[5] += field_at(&m->rest->twist, s);
    }
    march_state rate = {0};
    rate.g.p = mat3_mul_vec(y->g.R, vector(xi.a[0], xi.a[1], xi.a[2]));
    rate.g.R = mat3_mul(y->g.R, mat3_hat(vector(xi.a[3], xi.a[4], xi.a[5])));
    rate.N = vec3_scale(-1, m->f);
    rate.M = vec3_cross(y->N, rate.g.p);
    return rate;
}

static inline march_state march_add(march_state y, double h, march_state rate)
{
    double a[MARCH_SIZE], b[MARCH_SIZE];
    memcpy(a, &y, sizeof a);
    memcpy(b, &rate, sizeof b);
    for (int i = 0; i < MARCH_SIZE; i++) {
        a[i] += h * b[i];
    }
    memcpy(&y, a, sizeof a);
    return y;
}

// classical Runge-Kutta from one end to the other, `step` of them; backwards where from > to
static inline march_state march(const marching *m, double from, double to, int step, march_state y)
{
    const double h = (to - from) / step;
    for (int i = 0; i < step; i++) {
        const double s = from + i * h;
        const march_state k1 = march_rate(m, s, &y), y2 = march_add(y, h / 2, k1);
        const march_state k2 = march_rate(m, s + h / 2, &y2), y3 = march_add(y, h / 2, k2);
        const march_state k3 = march_rate(m, s + h / 2, &y3), y4 = march_add(y, h, k3);
        const march_state k4 = march_rate(m, s + h, &y4);
        y = march_add(y, h / 6, k1);
        y = march_add(y, h / 3, k2);
        y = march_add(y, h / 3, k3);
        y = march_add(y, h / 6, k4);
    }
    return y;
}

// Where the rod ends that starts at the identity under the reaction to a dead tip force and moment
// when the tip is at p: p itself, if p is an equilibrium.
static inline march_state march_to_tip(const marching *m, vec3 p, vec3 force, vec3 moment, int step)
{
    march_state y = {.g = pose_identity(), .N = force, .M = moment};
    y.M = vec3_add(y.M, vec3_cross(p, force));
    return march(m, 0, m->law->length, step, y);
}
