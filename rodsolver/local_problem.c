// rodsolver/local_problem.c
#include "rodsolver/local_problem.h"

#include <math.h>

// With |d| = min over l > 0 of (|d|^2 / l + l) / 2 the problem is jointly convex in the strain and
// the lengths l_i, and for given l it is linear in the strain: docs/theory.md (4.4). What remains
// is a convex function of the lengths alone, with gradient tau_i (1 - |y_i|^2) / 2, y_i = d_i /
// l_i, and y_i is the tendon's unit tangent at the solution.

enum { MAX_STEPS = 100, MAX_HALVINGS = 40 };

// | |y| - 1 | after which one more step leaves the rounding
static const double stop_residual = 1e-8;
// below this the energy's own rounding would decide a comparison: steps are taken as they are
static const double trust_residual = 1e-5;
// a tendon shorter than this part of the rod's length is eaten up
static const double eaten = 1e-7;
// no length shrinks to less than this part in one step
static const double shrink = 0.1;

vec3 tendon_direction(const tendon_place *r, const vec6 *xi)
{
    return (vec3){{xi->a[0] - xi->a[5] * r->y + r->dx, xi->a[1] + xi->a[5] * r->x + r->dy,
                   xi->a[2] + xi->a[3] * r->y - xi->a[4] * r->x}};
}

vec6 tendon_wrench(const tendon_place *r, vec3 f)
{
    return (vec6){
        {f.a[0], f.a[1], f.a[2], r->y * f.a[2], -r->x * f.a[2], r->x * f.a[1] - r->y * f.a[0]}};
}

// the linear problem at given lengths
typedef struct state {
    double l[ROD_MAX_TENDONS];
    mat6 lower; // Cholesky factor of K + sum tau_i / l_i A_i^T A_i
    vec6 xi;
    vec3 y[ROD_MAX_TENDONS];
    double size[ROD_MAX_TENDONS]; // |y|
    double energy, residual;
} state;

// lower triangle of H += q A^T A
static void add_tendon(const tendon_place *r, double q, mat6 *H)
{
    const double qx = q * r->x, qy = q * r->y;
    for (int i = 0; i < 3; i++) {
        H->a[i][i] += q;
    }
    H->a[3][2] += qy;
    H->a[4][2] -= qx;
    H->a[5][0] -= qy;
    H->a[5][1] += qx;
    H->a[3][3] += qy * r->y;
    H->a[4][3] -= qx * r->y;
    H->a[4][4] += qx * r->x;
    H->a[5][5] += qx * r->x + qy * r->y;
}

static bool evaluate(const local_problem *p, const vec3 *d0, state *s)
{
    mat6 H = *p->K;
    vec6 g = {0};
    for (int i = 0; i < p->ntendon; i++) {
        const double q = p->tension[i] / s->l[i];
        add_tendon(&p->place[i], q, &H);
        g = vec6_sub(g, tendon_wrench(&p->place[i], vec3_scale(q, d0[i])));
    }
    if (!mat6_cholesky(H, &s->lower)) {
        return false;
    }
    s->xi = vec6_add(p->rest, mat6_cholesky_solve(&s->lower, g));
    s->energy = s->residual = 0;
    for (int i = 0; i < p->ntendon; i++) {
        s->y[i] = vec3_scale(1 / s->l[i], tendon_direction(&p->place[i], &s->xi));
        s->size[i] = vec3_norm(s->y[i]);
        s->energy += p->tension[i] * (vec3_dot(d0[i], s->y[i]) + s->l[i]) / 2;
        const double off = fabs(s->size[i] - 1);
        s->residual = s->residual >= off ? s->residual : off;
    }
    return isfinite(s->energy);
}

// u = L^-1 b
static vec6 forward(const mat6 *L, vec6 b)
{
    for (int i = 0; i < 6; i++) {
        for (int k = 0; k < i; k++) {
            b.a[i] -= L->a[i][k] * b.a[k];
        }
        b.a[i] /= L->a[i][i];
    }
    return b;
}

// second derivatives in the lengths, factored: S_ij = delta_ij |y_i|^2 tau_i / l_i - (tau_i / l_i)
// (tau_j / l_j) u_i . u_j
static bool factor_lengths(const local_problem *p, const state *s,
                           double S[ROD_MAX_TENDONS][ROD_MAX_TENDONS])
{
    vec6 u[ROD_MAX_TENDONS];
    for (int i = 0; i < p->ntendon; i++) {
        const double q = p->tension[i] / s->l[i];
        u[i] = vec6_scale(q, forward(&s->lower, tendon_wrench(&p->place[i], s->y[i])));
        for (int j = 0; j <= i; j++) {
            S[i][j] = (i == j ? s->size[i] * s->size[i] * q : 0) - vec6_dot(u[i], u[j]);
        }
    }
    for (int j = 0; j < p->ntendon; j++) {
        for (int i = j; i < p->ntendon; i++) {
            for (int k = 0; k < j; k++) {
                S[i][j] -= S[i][k] * S[j][k];
            }
            if (i == j) {
                if (!(S[j][j] > 0)) {
                    return false;
                }
                S[j][j] = sqrt(S[j][j]);
            } else {
                S[i][j] /= S[j][j];
            }
        }
    }
    return true;
}

static void solve_lengths(int n, double S[ROD_MAX_TENDONS][ROD_MAX_TENDONS], double *b)
{
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < i; k++) {
            b[i] -= S[i][k] * b[k];
        }
        b[i] /= S[i][i];
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int k = i + 1; k < n; k++) {
            b[i] -= S[k][i] * b[k];
        }
        b[i] /= S[i][i];
    }
}

// Newton for 1/|y_i| = 1, nearly linear in l; where that is no descent, Newton for the gradient
// itself. The slope of the energy along the step
static double length_step(const local_problem *p, const state *s, double *step)
{
    double S[ROD_MAX_TENDONS][ROD_MAX_TENDONS];
    if (!factor_lengths(p, s, S)) {
        return 0;
    }
    double slope = 0;
    for (int attempt = 0; attempt < 2; attempt++) {
        for (int i = 0; i < p->ntendon; i++) {
            const double y = s->size[i];
            step[i] = p->tension[i] * (attempt == 0 ? y * y * (y - 1) : (y * y - 1) / 2);
        }
        solve_lengths(p->ntendon, S, step);
        slope = 0;
        for (int i = 0; i < p->ntendon; i++) {
            slope += p->tension[i] * (1 - s->size[i] * s->size[i]) / 2 * step[i];
        }
        if (slope < 0) {
            break;
        }
    }
    return slope;
}

// the longest of 1, 1/2, 1/4 ... of the step that lowers the energy
static bool advance(const local_problem *p, const vec3 *d0, const double *step, double slope,
                    state *s, int *steps)
{
    double share = 1;
    for (int k = 0; k < MAX_HALVINGS; k++) {
        state trial;
        for (int i = 0; i < p->ntendon; i++) {
            trial.l[i] = fmax(s->l[i] + share * step[i], shrink * s->l[i]);
        }
        ++*steps;
        if (evaluate(p, d0, &trial) &&
            (s->residual < trust_residual || trial.energy <= s->energy + 1e-4 * share * slope)) {
            *s = trial;
            return true;
        }
        share /= 2;
    }
    return false;
}

static int shortest(const local_problem *p, const state *s)
{
    int which = 0;
    for (int i = 1; i < p->ntendon; i++) {
        which = s->l[i] < s->l[which] ? i : which;
    }
    return which;
}

local_outcome local_solve(const local_problem *p, vec6 *xi, int *steps, int *which)
{
    state s;
    vec3 d0[ROD_MAX_TENDONS];
    for (int i = 0; i < p->ntendon; i++) {
        d0[i] = tendon_direction(&p->place[i], &p->rest);
        s.l[i] = fmax(vec3_norm(tendon_direction(&p->place[i], xi)), 1e3 * eaten);
    }
    ++*steps;
    bool good = evaluate(p, d0, &s);
    for (int k = 0; good && k < MAX_STEPS; k++) {
        const bool last = s.residual <= stop_residual;
        double step[ROD_MAX_TENDONS] = {0};
        const double slope = length_step(p, &s, step);
        *which = shortest(p, &s);
        if (s.l[*which] <= eaten) {
            return LOCAL_EATEN;
        }
        // at rest to the last bit there is no slope left
        good = last || slope < 0;
        good = good && advance(p, d0, step, slope, &s, steps);
        if (last && good) {
            *xi = s.xi;
            return LOCAL_SOLVED;
        }
    }
    return LOCAL_FAILED;
}
