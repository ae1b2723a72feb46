// bench/methods_shooting.h
// Single and multiple shooting on wrenches: the rod is cut into `cuts` pieces, each marched by the
// second method's Runge-Kutta steps of order 8 (tests/rod_shooting.h). Unknown are the moment at
// the base, and rotation and moment at every cut; one piece is single shooting. Each Newton step
// condenses the pieces onto the base's moment.
#pragma once

#include "bench/methods.h"

enum { SHOT_PIECES = 16, SHOT_UNKNOWNS = 12 }; // per piece: R by rows, M

typedef struct shot {
    shooting *sh;
    int cuts; // pieces, of about as many steps each
    shoot_case c;
    double force[3], scale;
    double end[SHOT_PIECES][SHOOT_SIZE]; // states behind the pieces
    vec3 tip;
} shot;

static inline void shot_rest(void *self, double *x)
{
    const shot *m = self;
    static const double identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    for (int k = 0; k < m->cuts; k++) {
        memcpy(x + SHOT_UNKNOWNS * k, identity, sizeof identity);
        memset(x + SHOT_UNKNOWNS * k + 9, 0, 3 * sizeof *x);
    }
    for (int k = 0; k < m->sh->nstep; k++) {
        for (int i = 0; i < SHOOT_STAGES; i++) {
            memcpy(m->sh->step[k].strain[i], m->sh->step[k].node[0].rest, 6 * sizeof *x);
        }
    }
}

static inline void shot_load(void *self, const method_load *load)
{
    shot *m = self;
    memcpy(m->c.tension, load->tension, sizeof load->tension);
    memcpy(m->force, load->force, sizeof m->force);
    // a moment of order 1
    const double f = fabs(load->force[0]) + fabs(load->force[1]) + fabs(load->force[2]);
    m->scale = f * m->sh->spec->law->length;
}

// all pieces from x; the squared size of all jumps at cuts and of the moment at the tip
static inline bool shot_march(shot *m, double lambda, const double *x, bool columns, double *size)
{
    const int n = m->sh->nstep;
    double y[SHOOT_SIZE] = {0};
    *size = 0;
    for (int k = 0; k < m->cuts; k++) {
        double p[3];
        memcpy(p, y + AT_P, sizeof p);
        memset(y, 0, sizeof y);
        memcpy(y + AT_R, x + SHOT_UNKNOWNS * k, 9 * sizeof *x);
        memcpy(y + AT_M, x + SHOT_UNKNOWNS * k + 9, 3 * sizeof *x);
        memcpy(y + AT_P, p, sizeof p);
        for (int i = 0; i < 3; i++) {
            y[AT_N + i] = lambda * m->force[i];
        }
        // by the moment first, then by the rotation, which the base has not
        m->c.ncolumn = columns ? (k == 0 ? 3 : 6) : 0;
        for (int j = 0; j < 3; j++) {
            y[SHOOT_STATE + SHOOT_COLUMN * j + 6 + j] = m->scale;
            y[SHOOT_STATE + SHOOT_COLUMN * (3 + j) + j] = 1;
        }
        for (int i = k * n / m->cuts; i < (k + 1) * n / m->cuts; i++) {
            if (!shoot_advance(&m->c, &m->sh->step[i], 1, lambda, y)) {
                return false;
            }
        }
        memcpy(m->end[k], y, sizeof y);
        const bool last = k + 1 == m->cuts;
        const double *next = x + SHOT_UNKNOWNS * (k + 1);
        for (int i = 0; i < 12; i++) {
            const double r = i < 9 ? (last ? 0 : y[i] - next[i])
                                   : (y[AT_M + i - 9] - (last ? 0 : next[i])) / m->scale;
            *size += r * r;
        }
    }
    m->tip = (vec3){{y[AT_P], y[AT_P + 1], y[AT_P + 2]}};
    return true;
}

// rotation that takes next to end, as a vector in space, and the moment's jump
static inline void shot_jump(const shot *m, int k, const double *x, double jump[6])
{
    const double *end = m->end[k], *next = x + SHOT_UNKNOWNS * (k + 1);
    mat3 a, b;
    memcpy(a.a, end + AT_R, sizeof a.a);
    memcpy(b.a, next, sizeof b.a);
    const vec3 turn = so3_log(mat3_mul(a, mat3_transpose(b)));
    for (int i = 0; i < 3; i++) {
        jump[i] = turn.a[i];
        jump[3 + i] = (end[AT_M + i] - next[9 + i]) / m->scale;
    }
}

// Newton's change of all unknowns, condensed: (phi, dM)_k = A_k dM_0 + b_k
static inline bool shot_change(const shot *m, const double *x, double d[SHOT_PIECES][6])
{
    double A[SHOT_PIECES + 1][6][3] = {0}, b[SHOT_PIECES + 1][6] = {0}, J[9], r[3];
    for (int j = 0; j < 3; j++) {
        A[0][3 + j][j] = 1;
    }
    for (int k = 0; k < m->cuts; k++) {
        const double *column = m->end[k] + SHOOT_STATE;
        double jump[6] = {0};
        if (k + 1 < m->cuts) {
            shot_jump(m, k, x, jump);
        } else {
            for (int i = 0; i < 3; i++) {
                jump[3 + i] = m->end[k][AT_M + i] / m->scale;
            }
        }
        for (int i = 0; i < 6; i++) {
            const int at = i < 3 ? i : 3 + i;
            b[k + 1][i] = jump[i];
            for (int j = 0; j < (k == 0 ? 3 : 6); j++) {
                const int from = j < 3 ? 3 + j : j - 3;
                const double slope = column[SHOOT_COLUMN * j + at] / (i < 3 ? 1 : m->scale);
                b[k + 1][i] += slope * b[k][from];
                for (int c = 0; c < 3; c++) {
                    A[k + 1][i][c] += slope * A[k][from][c];
                }
            }
        }
    }
    for (int i = 0; i < 3; i++) {
        r[i] = -b[m->cuts][3 + i];
        memcpy(J + 3 * i, A[m->cuts][3 + i], 3 * sizeof *J);
    }
    if (!method_solve(3, J, r)) {
        return false;
    }
    for (int k = 0; k < m->cuts; k++) {
        for (int i = 0; i < 6; i++) {
            d[k][i] = b[k][i] + A[k][i][0] * r[0] + A[k][i][1] * r[1] + A[k][i][2] * r[2];
        }
    }
    return true;
}

static inline void shot_moved(const shot *m, const double *x, double part,
                              const double d[SHOT_PIECES][6], double *out)
{
    for (int k = 0; k < m->cuts; k++) {
        mat3 R;
        memcpy(R.a, x + SHOT_UNKNOWNS * k, sizeof R.a);
        R = mat3_mul(so3_exp((vec3){{part * d[k][0], part * d[k][1], part * d[k][2]}}), R);
        memcpy(out + SHOT_UNKNOWNS * k, R.a, sizeof R.a);
        for (int i = 9; i < 12; i++) {
            out[SHOT_UNKNOWNS * k + i] =
                x[SHOT_UNKNOWNS * k + i] + part * m->scale * d[k][3 + i - 9];
        }
    }
}

static inline bool shot_newton(void *self, double lambda, double *x, int *steps)
{
    shot *m = self;
    double d[SHOT_PIECES][6], next[SHOT_PIECES * SHOT_UNKNOWNS], size, trial;
    if (!shot_march(m, lambda, x, true, &size)) {
        return false;
    }
    for (int step = 0; step < METHOD_MOST_STEPS; step++) {
        double largest = 0, part = 1;
        ++*steps;
        if (!shot_change(m, x, d)) {
            return false;
        }
        for (int i = 0; i < 6 * m->cuts; i++) {
            largest = fmax(largest, fabs(d[i / 6][i % 6]));
        }
        for (;; part /= 2) {
            shot_moved(m, x, part, (const double(*)[6])d, next);
            const bool last = largest < method_last;
            if (last) {
                memcpy(x, next, sizeof *x * SHOT_UNKNOWNS * (size_t)m->cuts);
                return true;
            }
            if (shot_march(m, lambda, next, true, &trial) && trial < size) {
                break;
            }
            if (part < 1e-3) {
                return false;
            }
        }
        size = trial;
        memcpy(x, next, sizeof *x * SHOT_UNKNOWNS * (size_t)m->cuts);
    }
    return false;
}

// pieces joined without a jump, as the tendons alone bend them
static inline void shot_guess(void *self, double *x)
{
    shot *m = self;
    double force[3], size;
    memcpy(force, m->force, sizeof force);
    memset(m->force, 0, sizeof m->force);
    for (int k = 1; k <= m->cuts; k++) {
        if (!shot_march(m, 1, x, false, &size)) {
            break;
        }
        for (int j = 1; j < m->cuts; j++) {
            memcpy(x + SHOT_UNKNOWNS * j, m->end[j - 1] + AT_R, 9 * sizeof *x);
        }
    }
    memcpy(m->force, force, sizeof force);
}

static inline void shot_extend(const void *self, const double *a, const double *b, double t,
                               double *x)
{
    const shot *m = self;
    double d[SHOT_PIECES][6];
    for (int k = 0; k < m->cuts; k++) {
        mat3 A, B;
        memcpy(A.a, a + SHOT_UNKNOWNS * k, sizeof A.a);
        memcpy(B.a, b + SHOT_UNKNOWNS * k, sizeof B.a);
        const vec3 turn = so3_log(mat3_mul(B, mat3_transpose(A)));
        for (int i = 0; i < 3; i++) {
            const int at = SHOT_UNKNOWNS * k + 9 + i;
            d[k][i] = turn.a[i];
            d[k][3 + i] = (b[at] - a[at]) / m->scale;
        }
    }
    shot_moved(m, b, t, (const double(*)[6])d, x);
}

static inline vec3 shot_tip(void *self, double lambda, const double *x)
{
    shot *m = self;
    double size;
    (void)shot_march(m, lambda, x, false, &size);
    return m->tip;
}

static inline method shot_method(shot *m, const char *name)
{
    return (method){.name = name,
                    .n = SHOT_UNKNOWNS * m->cuts,
                    .rest = shot_rest,
                    .load = shot_load,
                    .guess = shot_guess,
                    .newton = shot_newton,
                    .extend = shot_extend,
                    .tip = shot_tip,
                    .self = m};
}
