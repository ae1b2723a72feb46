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
    vec6 xi;
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

static bool evaluate(const local_problem *p, state *s)
{
    mat6 H = *p->K, lower;
    vec6 g = {0};
    for (int i = 0; i < p->ntendon; i++) {
        const local_tendon *t = &p->tendon[i];
        const double q = t->tension / t->l;
        add_tendon(&t->place, q, &H);
        g = vec6_sub(g, tendon_wrench(&t->place, vec3_scale(q, t->d0)));
    }
    if (!mat6_cholesky(H, &lower)) {
        return false;
    }
    s->xi = vec6_add(p->rest, mat6_cholesky_solve(&lower, g));
    s->energy = s->residual = 0;
    for (int i = 0; i < p->ntendon; i++) {
        local_tendon *t = &p->tendon[i];
        t->y = vec3_scale(1 / t->l, tendon_direction(&t->place, &s->xi));
        t->size = vec3_norm(t->y);
        s->energy += t->tension * (vec3_dot(t->d0, t->y) + t->l) / 2;
        const double off = fabs(t->size - 1);
        s->residual = s->residual >= off ? s->residual : off;
    }
    return isfinite(s->energy);
}

// The second derivatives in the lengths are S = D - U U^T with D_i = q_i |y_i|^2, q_i = tau_i /
// l_i, and rows u_i = q_i L^-1 A_i^T y_i of six numbers. By Woodbury's formula S^-1 needs only the
// second derivatives in the strain, H = K + sum q_i A_i^T (I - t_i t_i^T) A_i:
//   S^-1 b = D^-1 (b + q_i y_i . A_i z),   H z = sum A_j^T y_j b_j / |y_j|^2
static bool factor_strain(const local_problem *p, mat6 *lower)
{
    mat6 H = *p->K;
    for (int i = 0; i < p->ntendon; i++) {
        const local_tendon *t = &p->tendon[i];
        const double q = t->tension / t->l;
        add_tendon(&t->place, q, &H);
        const vec6 along = tendon_wrench(&t->place, vec3_scale(1 / t->size, t->y));
        for (int c = 0; c < 36; c++) {
            H.a[c / 6][c % 6] -= q * along.a[c / 6] * along.a[c % 6];
        }
    }
    return mat6_cholesky(H, lower);
}

// step <- S^-1 step
static void solve_lengths(const local_problem *p, const mat6 *lower)
{
    vec6 g = {0};
    for (int i = 0; i < p->ntendon; i++) {
        const local_tendon *t = &p->tendon[i];
        const double share = t->step / (t->size * t->size);
        g = vec6_add(g, tendon_wrench(&t->place, vec3_scale(share, t->y)));
    }
    const vec6 z = mat6_cholesky_solve(lower, g);
    for (int i = 0; i < p->ntendon; i++) {
        local_tendon *t = &p->tendon[i];
        const double q = t->tension / t->l;
        const tendon_place straight = {.x = t->place.x, .y = t->place.y};
        t->step = (t->step + q * vec3_dot(t->y, tendon_direction(&straight, &z))) /
                  (q * t->size * t->size);
    }
}

// Newton for 1/|y_i| = 1, nearly linear in l; where that is no descent, Newton for the gradient
// itself. The slope of the energy along the step
static double length_step(const local_problem *p)
{
    mat6 lower;
    if (!factor_strain(p, &lower)) {
        return 0;
    }
    double slope = 0;
    for (int attempt = 0; attempt < 2; attempt++) {
        for (int i = 0; i < p->ntendon; i++) {
            local_tendon *t = &p->tendon[i];
            const double y = t->size;
            t->step = t->tension * (attempt == 0 ? y * y * (y - 1) : (y * y - 1) / 2);
        }
        solve_lengths(p, &lower);
        slope = 0;
        for (int i = 0; i < p->ntendon; i++) {
            const local_tendon *t = &p->tendon[i];
            slope += t->tension * (1 - t->size * t->size) / 2 * t->step;
        }
        if (slope < 0) {
            break;
        }
    }
    return slope;
}

// the longest of 1, 1/2, 1/4 ... of the step that lowers the energy
static bool advance(const local_problem *p, double slope, state *s, int *steps)
{
    double share = 1;
    for (int i = 0; i < p->ntendon; i++) {
        p->tendon[i].kept = p->tendon[i].l;
    }
    for (int k = 0; k < MAX_HALVINGS; k++) {
        state trial;
        for (int i = 0; i < p->ntendon; i++) {
            local_tendon *t = &p->tendon[i];
            t->l = fmax(t->kept + share * t->step, shrink * t->kept);
        }
        ++*steps;
        if (evaluate(p, &trial) &&
            (s->residual < trust_residual || trial.energy <= s->energy + 1e-4 * share * slope)) {
            *s = trial;
            return true;
        }
        share /= 2;
    }
    return false;
}

static int shortest(const local_problem *p)
{
    int which = 0;
    for (int i = 1; i < p->ntendon; i++) {
        which = p->tendon[i].l < p->tendon[which].l ? i : which;
    }
    return which;
}

local_outcome local_solve(const local_problem *p, vec6 *xi, int *steps, int *which)
{
    state s;
    for (int i = 0; i < p->ntendon; i++) {
        local_tendon *t = &p->tendon[i];
        t->d0 = tendon_direction(&t->place, &p->rest);
        t->l = fmax(vec3_norm(tendon_direction(&t->place, xi)), 1e3 * eaten);
    }
    ++*steps;
    bool good = evaluate(p, &s);
    for (int k = 0; good && k < MAX_STEPS; k++) {
        const bool last = s.residual <= stop_residual;
        const double slope = length_step(p);
        *which = shortest(p);
        if (p->tendon[*which].l <= eaten) {
            return LOCAL_EATEN;
        }
        // at rest to the last bit there is no slope left
        good = last || slope < 0;
        good = good && advance(p, slope, &s, steps);
        if (last && good) {
            *xi = s.xi;
            return LOCAL_SOLVED;
        }
    }
    return LOCAL_FAILED;
}
