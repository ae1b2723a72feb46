// tests/rod_shooting_path.h
// The second method, part 4: the path of equilibria from rest, lambda from 0 to 1 on tensions and
// loads together, by pseudo-arclength in (wrench at the base, lambda). A limit point is where
// lambda turns, a bifurcation where the determinant of the boundary condition changes its sign and
// lambda does not.
#pragma once

#include "tests/rod_shooting.h"

enum { SHOOT_UNKNOWNS = 6, SHOOT_CRITICALS = 16 };

typedef struct shoot_critical {
    int kind; // critical_kind
    double fraction;
} shoot_critical;

typedef struct shoot_answer {
    bool solved; // false: no convergence, nothing else holds
    pose tip;
    double length[SHOOT_TENDONS], base_wrench[6];
    double fraction; // 1, or that of the first limit point
    int ncritical;
    shoot_critical critical[SHOOT_CRITICALS];
    int sign; // of the determinant: -1 where the number of negative directions is odd, 0 at a limit
    int negative; // directions of the second variation; -1: no potential, or a limit point
    double error; // of the tip, by half as many steps [m]
    int points, marches;
} shoot_answer;

// z: (unknown wrench at the base, scaled; lambda)
typedef struct shoot_point {
    double z[SHOOT_UNKNOWNS + 1], tangent[SHOOT_UNKNOWNS + 1];
    double determinant;
} shoot_point;

typedef struct shoot_path {
    shoot_case c;
    int n, first;                // unknowns, and the first of them in (N, M)
    double scale[6], total[3];   // of wrenches, and of all forces at lambda = 1
    double bend, longest, close; // most turn of the tangent per step [rad], longest step, residual
    int marches;
} shoot_path;

// all forces at lambda = 1, where their directions are fixed in space; and how large loads are
static inline bool shoot_total(const shoot_case *c, double total[3], double *force, double *moment)
{
    const rod_spec *spec = c->sh->spec;
    const double L = spec->law->length;
    bool dead = true;
    *force = *moment = 0;
    for (int i = 0; i < 3; i++) {
        total[i] = c->tip_space[i];
        *force += fabs(c->tip_space[i]) + fabs(c->tip_body[i]);
        *moment += fabs(c->tip_space[3 + i]) + fabs(c->tip_body[3 + i]);
        dead = dead && c->tip_body[i] == 0;
    }
    for (int j = 0; j < spec->npoint_load; j++) {
        const point_load *p = &spec->point_loads[j];
        for (int i = 0; i < 3; i++) {
            total[i] += c->factor[j] * p->force[i];
            *force += fabs(c->factor[j] * p->force[i]);
            *moment += fabs(c->factor[j] * p->moment[i]);
            dead = dead && (p->frame == LOAD_SPACE || p->force[i] == 0);
        }
    }
    for (int k = 0; k < c->sh->nstep * SHOOT_NODES * c->sh->nline; k++) {
        const shoot_step *step = &c->sh->step[k / (SHOOT_NODES * c->sh->nline)];
        const int node = k / c->sh->nline % SHOOT_NODES, j = k % c->sh->nline;
        const shoot_line *l = &step->node[node].line[j];
        const double weight = shoot_node_weight[node] * step->h * c->factor[spec->npoint_load + j];
        for (int i = 0; i < 3; i++) {
            total[i] += weight * l->force[i];
            *force += fabs(weight * l->force[i]);
            *moment += fabs(weight * l->moment[i]);
            dead = dead && (l->frame == LOAD_SPACE || l->force[i] == 0);
        }
    }
    *moment += *force * L;
    return dead;
}

static inline shoot_path shoot_path_make(shooting *sh, const rod_request *rq)
{
    shoot_path p = {.c = shoot_case_make(sh, rq), .bend = 0.12, .longest = 0.15, .close = 1e-7};
    double force, moment;
    const bool dead = shoot_total(&p.c, p.total, &force, &moment);
    p.n = moment == 0 ? 0 : dead ? 3 : 6;
    p.first = 6 - p.n;
    for (int i = 0; i < 6; i++) {
        p.scale[i] = i < 3 ? moment / sh->spec->law->length : moment;
    }
    p.c.ncolumn = p.n + 1;
    p.c.lambda_column = p.n;
    return p;
}

// LU with pivoting in place, b overwritten by the solution; the determinant
static inline double shoot_eliminate(int n, double a[][SHOOT_UNKNOWNS + 1], double *b)
{
    double determinant = 1;
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++) {
            best = fabs(a[i][k]) > fabs(a[best][k]) ? i : best;
        }
        for (int j = 0; j < n && best != k; j++) {
            const double swap = a[k][j];
            a[k][j] = a[best][j];
            a[best][j] = swap;
        }
        if (best != k) {
            const double swap = b[k];
            b[k] = b[best];
            b[best] = swap;
            determinant = -determinant;
        }
        determinant *= a[k][k];
        for (int i = k + 1; i < n && a[k][k] != 0; i++) {
            const double f = a[i][k] / a[k][k];
            b[i] -= f * b[k];
            for (int j = k; j < n; j++) {
                a[i][j] -= f * a[k][j];
            }
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int j = i + 1; j < n; j++) {
            b[i] -= a[i][j] * b[j];
        }
        b[i] /= a[i][i];
    }
    return determinant;
}

// scaled residual at the tip and its derivatives by z [n][n + 1]; the state there
static inline bool shoot_boundary(shoot_path *p, const double *z, double y[SHOOT_SIZE], double *r,
                                  double J[][SHOOT_UNKNOWNS + 1])
{
    shoot_case *c = &p->c;
    const double lambda = z[p->n];
    memset(y, 0, SHOOT_SIZE * sizeof *y);
    shoot_put_pose(c->base, y);
    for (int i = 0; i < 3 && p->n <= 3; i++) {
        y[AT_N + i] = lambda * p->total[i];
        y[SHOOT_STATE + SHOOT_COLUMN * p->n + 3 + i] = p->total[i];
    }
    for (int i = p->first; i < 6; i++) {
        y[AT_N + i] = z[i - p->first] * p->scale[i];
        y[SHOOT_STATE + SHOOT_COLUMN * (i - p->first) + 3 + i] = p->scale[i];
    }
    p->marches++;
    if (!shoot_march(c, 1, lambda, y, NULL)) {
        return false;
    }
    // what the tip itself carries
    const double none[3] = {0};
    const shoot_push dead =
        shoot_push_at(y + AT_R, LOAD_SPACE, c->tip_space, c->tip_space + 3, 0, 0, 1);
    const shoot_push follower =
        shoot_push_at(y + AT_R, LOAD_BODY, c->tip_body, c->tip_body + 3, none[0], 0, 1);
    double end[SHOOT_SIZE];
    memcpy(end, y, sizeof end);
    shoot_add_push(c, end, y, &dead, lambda, -1);
    shoot_add_push(c, end, y, &follower, lambda, -1);
    for (int i = p->first; i < 6; i++) {
        r[i - p->first] = end[AT_N + i] / p->scale[i];
        for (int k = 0; k <= p->n; k++) {
            J[i - p->first][k] = end[SHOOT_STATE + SHOOT_COLUMN * k + 3 + i] / p->scale[i];
        }
    }
    return true;
}

// unit tangent that goes on as `like` does, and the determinant by the unknowns
static inline void shoot_tangent_of(int n, const double J[][SHOOT_UNKNOWNS + 1], const double *like,
                                    shoot_point *out)
{
    double a[SHOOT_UNKNOWNS + 1][SHOOT_UNKNOWNS + 1], b[SHOOT_UNKNOWNS + 1] = {0}, size = 0;
    memcpy(a, J, sizeof a[0] * (size_t)n);
    out->determinant = shoot_eliminate(n, a, b);
    memcpy(a, J, sizeof a[0] * (size_t)n);
    memcpy(a[n], like, sizeof a[0]);
    memset(b, 0, sizeof b);
    b[n] = 1;
    (void)shoot_eliminate(n + 1, a, b);
    for (int i = 0; i <= n; i++) {
        size += b[i] * b[i];
    }
    for (int i = 0; i <= n; i++) {
        out->tangent[i] = b[i] / sqrt(size);
    }
}

// Newton from z on the hyperplane through it across `across`; the tangent goes on as `like` does
static inline bool shoot_correct(shoot_path *p, const double *across, const double *like,
                                 const double *z, shoot_point *out, double y[SHOOT_SIZE])
{
    enum { MOST = 8 };
    const int n = p->n;
    double J[SHOOT_UNKNOWNS + 1][SHOOT_UNKNOWNS + 1], b[SHOOT_UNKNOWNS + 1], before = HUGE_VAL;
    shoot_point q = {0};
    memcpy(q.z, z, sizeof q.z);
    for (int step = 0; step < MOST; step++) {
        if (!shoot_boundary(p, q.z, y, b, J)) {
            return false;
        }
        shoot_tangent_of(n, (const double(*)[SHOOT_UNKNOWNS + 1]) J, like, &q);
        double size = 0;
        memcpy(J[n], across, sizeof J[n]);
        b[n] = 0;
        (void)shoot_eliminate(n + 1, J, b);
        for (int i = 0; i <= n; i++) {
            q.z[i] -= b[i];
            size += b[i] * b[i];
        }
        size = sqrt(size);
        if (size < p->close) {
            *out = q;
            return true;
        }
        if (!(size < before / 2) || size > 0.3) {
            return false;
        }
        before = size;
    }
    return false;
}
