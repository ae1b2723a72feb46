// tests/rod_shooting.h
// The second method, part 3: pose and wrench marched along the rod as an initial-value problem with
// its variations, by Cooper and Verner's explicit Runge-Kutta method of order 8 (SIAM J. Numer.
// Anal. 9, 1972). N and M are the wrench that the rod behind s carries, about p(s), in the frame of
// the world:
//
//   R' = R hat(w),  p' = R v,  N' = -f,  M' = -p' x N - (m + R r x f),  K (xi - xi*) + ... = R^T
//   (N, M)
//
// Variations are space rotations phi, and changes of N and M.
#pragma once

#include "tests/rod_shooting_local.h"

enum {
    AT_R = 0,
    AT_P = 9,
    AT_N = 12,
    AT_M = 15,
    AT_LENGTH = 18,
    SHOOT_STATE = AT_LENGTH + SHOOT_TENDONS,
    SHOOT_COLUMN = 9, // phi, dN, dM
    SHOOT_COLUMNS = 7,
    SHOOT_SIZE = SHOOT_STATE + SHOOT_COLUMN * SHOOT_COLUMNS
};

// What is asked of a rod; everything grows with lambda.
typedef struct shoot_case {
    shooting *sh;
    double tension[SHOOT_TENDONS], factor[16 + SHOOT_LINES];
    double tip_space[6], tip_body[6];
    pose base;
    // of the columns that are marched
    int ncolumn, lambda_column; // -1: none of them is by lambda
} shoot_case;

static inline shoot_case shoot_case_make(shooting *sh, const rod_request *rq)
{
    shoot_case c = {.sh = sh, .base = rq->base ? *rq->base : pose_identity(), .lambda_column = -1};
    for (int i = 0; i < sh->spec->ntendon; i++) {
        c.tension[i] = rq->tension ? rq->tension[i] : 0;
    }
    for (int i = 0; i < sh->spec->npoint_load + sh->nline; i++) {
        c.factor[i] = rq->load ? rq->load[i] : 1;
    }
    memcpy(c.tip_space, rq->tip_space.a, sizeof c.tip_space);
    memcpy(c.tip_body, rq->tip_body.a, sizeof c.tip_body);
    return c;
}

static inline void shoot_turn(const double *R, const double *a, double *b) // b = R a
{
    for (int i = 0; i < 3; i++) {
        b[i] = R[3 * i] * a[0] + R[3 * i + 1] * a[1] + R[3 * i + 2] * a[2];
    }
}

static inline void shoot_unturn(const double *R, const double *a, double *b) // b = R^T a
{
    for (int i = 0; i < 3; i++) {
        b[i] = R[i] * a[0] + R[3 + i] * a[1] + R[6 + i] * a[2];
    }
}

// A load in the world: its force, its moment about the centre, and what turns with the section.
typedef struct shoot_push {
    bool turns;
    double force[3], moment[3], arm[3];
} shoot_push;

static inline shoot_push shoot_push_at(const double *R, int frame, const double *force,
                                       const double *moment, double x, double y, double factor)
{
    shoot_push q = {.turns = frame == LOAD_BODY};
    const double place[3] = {x, y, 0};
    double f[3], m[3], couple[3];
    for (int c = 0; c < 3; c++) {
        f[c] = factor * force[c];
        m[c] = factor * moment[c];
    }
    memcpy(q.force, f, sizeof f);
    memcpy(q.moment, m, sizeof m);
    if (q.turns) {
        shoot_turn(R, f, q.force);
        shoot_turn(R, m, q.moment);
    }
    shoot_turn(R, place, q.arm);
    shoot_cross(q.arm, q.force, couple);
    for (int c = 0; c < 3; c++) {
        q.moment[c] += couple[c];
    }
    return q;
}

// change of the push's force and moment when the section turns by phi
static inline void shoot_push_turned(const shoot_push *q, const double *phi, double *df, double *dm)
{
    if (q->turns) {
        shoot_cross(phi, q->force, df);
        shoot_cross(phi, q->moment, dm);
        return;
    }
    double arm[3];
    memset(df, 0, 3 * sizeof *df);
    shoot_cross(phi, q->arm, arm);
    shoot_cross(arm, q->force, dm);
}

// y += sign * a push, columns too
static inline void shoot_add_push(const shoot_case *c, double *y, const double *state,
                                  const shoot_push *unit, double lambda, double sign)
{
    for (int i = 0; i < 3; i++) {
        y[AT_N + i] += sign * lambda * unit->force[i];
        y[AT_M + i] += sign * lambda * unit->moment[i];
    }
    for (int k = 0; k < c->ncolumn; k++) {
        double *column = y + SHOOT_STATE + SHOOT_COLUMN * k, df[3], dm[3];
        shoot_push_turned(unit, state + SHOOT_STATE + SHOOT_COLUMN * k, df, dm);
        const double more = k == c->lambda_column ? 1 : 0;
        for (int i = 0; i < 3; i++) {
            column[3 + i] += sign * (lambda * df[i] + more * unit->force[i]);
            column[6 + i] += sign * (lambda * dm[i] + more * unit->moment[i]);
        }
    }
}

static inline void shoot_columns(const shoot_case *c, const shoot_node *q, const double H[6][6],
                                 const double *xi, const double *y, const double *dp, double *dy)
{
    const double *R = y + AT_R, *N = y + AT_N, *M = y + AT_M;
    for (int k = 0; k < c->ncolumn; k++) {
        const double *phi = y + SHOOT_STATE + SHOOT_COLUMN * k, *dN = phi + 3, *dM = phi + 6;
        double *out = dy + SHOOT_STATE + SHOOT_COLUMN * k;
        double a[3], b[3], dW[6], v[3], p[3], turned[3];
        // W = R^T (N, M), so dW = R^T (dN - phi x N, dM - phi x M)
        shoot_cross(phi, N, a);
        shoot_cross(phi, M, b);
        for (int i = 0; i < 3; i++) {
            a[i] = dN[i] - a[i];
            b[i] = dM[i] - b[i];
        }
        shoot_unturn(R, a, dW);
        shoot_unturn(R, b, dW + 3);
        if (k == c->lambda_column) {
            for (int i = 0; i < c->sh->spec->ntendon; i++) {
                double t[3];
                (void)shoot_tangent(&q->place[i], xi, t);
                shoot_add_wrench(&q->place[i], -c->tension[i] * q->place[i].share, t, dW);
            }
        }
        shoot_cholesky_solve(H, dW);
        shoot_turn(R, dW, v);
        shoot_turn(R, dW + 3, out);
        shoot_cross(phi, dp, turned);
        for (int i = 0; i < 3; i++) {
            p[i] = turned[i] + v[i];
        }
        shoot_cross(N, p, a);
        shoot_cross(dN, dp, b);
        for (int i = 0; i < 3; i++) {
            out[3 + i] = 0;
            out[6 + i] = a[i] + b[i];
        }
    }
}

static inline bool shoot_slopes(const shoot_case *c, const shoot_node *q, double lambda,
                                const double *y, double *xi, double *dy)
{
    const rod_spec *spec = c->sh->spec;
    const double *R = y + AT_R;
    double W[6], H[6][6], tau[SHOOT_TENDONS] = {0};
    shoot_unturn(R, y + AT_N, W);
    shoot_unturn(R, y + AT_M, W + 3);
    for (int i = 0; i < spec->ntendon; i++) {
        tau[i] = lambda * c->tension[i];
    }
    if (!shoot_local(q, spec->ntendon, tau, W, xi, H)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        const double w[3] = {xi[3], xi[4], xi[5]}, *row = R + 3 * i;
        shoot_cross(row, w, dy + AT_R + 3 * i);
    }
    shoot_turn(R, xi, dy + AT_P);
    memset(dy + AT_N, 0, 3 * sizeof *dy);
    shoot_cross(y + AT_N, dy + AT_P, dy + AT_M);
    for (int i = 0; i < SHOOT_TENDONS; i++) {
        double t[3];
        const bool there = i < spec->ntendon && q->place[i].share > 0;
        dy[AT_LENGTH + i] = there ? shoot_tangent(&q->place[i], xi, t) : 0;
    }
    shoot_columns(c, q, (const double(*)[6])H, xi, y, dy + AT_P, dy);
    for (int j = 0; j < c->sh->nline; j++) {
        const shoot_line *l = &q->line[j];
        const shoot_push unit = shoot_push_at(R, l->frame, l->force, l->moment, l->x, l->y,
                                              c->factor[spec->npoint_load + j]);
        shoot_add_push(c, dy, y, &unit, lambda, -1);
    }
    return true;
}

// --- Cooper and Verner's method

typedef struct shoot_stage {
    int node;
    double a[SHOOT_STAGES - 1];
} shoot_stage;

#define Q SQRT_21
static const shoot_stage shoot_stages[SHOOT_STAGES] = {
    {0, {0}},
    {2, {1.0 / 2}},
    {2, {1.0 / 4, 1.0 / 4}},
    {3, {1.0 / 7, (-7 - 3 * Q) / 98, (21 + 5 * Q) / 49}},
    {3, {(11 + Q) / 84, 0, (18 + 4 * Q) / 63, (21 - Q) / 252}},
    {2, {(5 + Q) / 48, 0, (9 + Q) / 36, (-231 + 14 * Q) / 360, (63 - 7 * Q) / 80}},
    {1,
     {(10 - Q) / 42, 0, (-432 + 92 * Q) / 315, (633 - 145 * Q) / 90, (-504 + 115 * Q) / 70,
      (63 - 13 * Q) / 35}},
    {1, {1.0 / 14, 0, 0, 0, (14 - 3 * Q) / 126, (13 - 3 * Q) / 63, 1.0 / 9}},
    {2,
     {1.0 / 32, 0, 0, 0, (91 - 21 * Q) / 576, 11.0 / 72, (-385 - 75 * Q) / 1152,
      (63 + 13 * Q) / 128}},
    {3,
     {1.0 / 14, 0, 0, 0, 1.0 / 9, (-733 - 147 * Q) / 2205, (515 + 111 * Q) / 504,
      (-51 - 11 * Q) / 56, (132 + 28 * Q) / 245}},
    {4,
     {0, 0, 0, 0, (-42 + 7 * Q) / 18, (-18 + 28 * Q) / 45, (-273 - 53 * Q) / 72,
      (301 + 53 * Q) / 72, (28 - 28 * Q) / 45, (49 - 7 * Q) / 18}}};
#undef Q
static const double shoot_weight[SHOOT_STAGES] = {
    1.0 / 20, 0, 0, 0, 0, 0, 0, 49.0 / 180, 16.0 / 45, 49.0 / 180, 1.0 / 20};

static inline void shoot_add_slopes(int size, double h, int n, const double *a,
                                    double slope[][SHOOT_SIZE], double *y)
{
    for (int j = 0; j < n; j++) {
        if (a[j] != 0) {
            for (int i = 0; i < size; i++) {
                y[i] += h * a[j] * slope[j][i];
            }
        }
    }
}

// direction 1: from the left end of the step to its right one; -1: back
static inline bool shoot_advance(const shoot_case *c, shoot_step *step, int direction,
                                 double lambda, double *y)
{
    const int size = SHOOT_STATE + SHOOT_COLUMN * c->ncolumn;
    const double h = direction * step->h;
    double slope[SHOOT_STAGES][SHOOT_SIZE], at[SHOOT_SIZE];
    for (int i = 0; i < SHOOT_STAGES; i++) {
        memcpy(at, y, (size_t)size * sizeof *at);
        shoot_add_slopes(size, h, i, shoot_stages[i].a, slope, at);
        const int node = shoot_stages[i].node;
        if (!shoot_slopes(c, &step->node[direction > 0 ? node : SHOOT_NODES - 1 - node], lambda, at,
                          step->strain[i], slope[i])) {
            return false;
        }
    }
    shoot_add_slopes(size, h, SHOOT_STAGES, shoot_weight, slope, y);
    return true;
}

// loads at points: what is behind them loses them
static inline void shoot_pass_points(const shoot_case *c, const shoot_step *step, double lambda,
                                     double sign, double *y)
{
    double before[SHOOT_SIZE];
    for (int j = 0; j < step->npoint; j++) {
        const point_load *p = &c->sh->spec->point_loads[step->point[j]];
        const shoot_push unit = shoot_push_at(y + AT_R, p->frame, p->force, p->moment, p->place[0],
                                              p->place[1], c->factor[step->point[j]]);
        memcpy(before, y, sizeof before);
        shoot_add_push(c, y, before, &unit, lambda, sign);
    }
}

// over the whole rod; seen [nstep + 1] states, in order of s, may be NULL
static inline bool shoot_march(const shoot_case *c, int direction, double lambda, double *y,
                               double (*seen)[SHOOT_SIZE])
{
    const int n = c->sh->nstep;
    for (int k = 0; k < n; k++) {
        shoot_step *step = &c->sh->step[direction > 0 ? k : n - 1 - k];
        if (seen) {
            memcpy(seen[direction > 0 ? k : n - k], y, sizeof *seen);
        }
        if (direction < 0) {
            shoot_pass_points(c, step, lambda, 1, y);
        }
        if (!shoot_advance(c, step, direction, lambda, y)) {
            return false;
        }
        if (direction > 0) {
            shoot_pass_points(c, step, lambda, -1, y);
        }
    }
    if (seen) {
        memcpy(seen[direction > 0 ? n : 0], y, sizeof *seen);
    }
    return true;
}

static inline void shoot_put_pose(pose g, double *y)
{
    for (int i = 0; i < 3; i++) {
        memcpy(y + AT_R + 3 * i, g.R.a[i], 3 * sizeof *y);
        y[AT_P + i] = g.p.a[i];
    }
}

static inline pose shoot_get_pose(const double *y)
{
    pose g;
    for (int i = 0; i < 3; i++) {
        memcpy(g.R.a[i], y + AT_R + 3 * i, 3 * sizeof *y);
        g.p.a[i] = y[AT_P + i];
    }
    return g;
}
