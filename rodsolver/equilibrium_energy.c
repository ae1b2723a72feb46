// rodsolver/equilibrium_energy.c
// What the potential tells about an answer: the smallest eigenvalue of its second variation, and
// the balance of energies on the way from rest. docs/theory.md (4.28), (4.29)
#include "rodsolver/collocation.h"
#include "rodsolver/equilibrium.h"

#include <math.h>
#include <string.h>

// --- the smallest eigenvalue: A x = lambda K x by inverse iteration

enum { ITERATIONS = 400, SHIFTS = 12, NODES = 10 };

// relative change of the eigenvalue at which the iteration stops
static const double settled = 1e-9;

// e->rv, e->rw = K x; x . K x
static double elastic_misfits(equilibrium *e, const vec6 *x)
{
    const plan *p = e->plan;
    double sum = 0;
    for (int i = 0; i < p->nstation; i++) {
        const vec6 f = mat6_mul_vec(p->K[i], x[i]);
        const mat3 *R = &e->state[i].R;
        e->rv[i] = mat3_mul_vec(*R, vec6_linear(f));
        e->rw[i] = mat3_mul_vec(*R, vec6_angular(f));
        sum += gauss_weight[i % GAUSS_STATIONS] * panel_length(p, i / GAUSS_STATIONS) *
               vec6_dot(x[i], f);
    }
    return sum;
}

static double elastic_product(const equilibrium *e, const vec6 *x, const vec6 *y)
{
    const plan *p = e->plan;
    double sum = 0;
    for (int i = 0; i < p->nstation; i++) {
        sum += gauss_weight[i % GAUSS_STATIONS] * panel_length(p, i / GAUSS_STATIONS) *
               vec6_dot(x[i], mat6_mul_vec(p->K[i], y[i]));
    }
    return sum;
}

// any field will do that no symmetry of the rod makes blind to a mode
static void start_field(equilibrium *e, vec6 *x)
{
    const double length = e->rod->length;
    for (int i = 0; i < e->plan->nstation; i++) {
        const double t = e->plan->s[i] / length;
        x[i] = (vec6){{0.01 * t, 0.02 - 0.01 * t, 0.01, (1 - 0.8 * t) / length,
                       (0.7 - 0.3 * t * t) / length, 0.5 * (t - 0.3) / length}};
    }
}

static double inverse_iteration(equilibrium *e)
{
    double value = HUGE_VAL;
    vec6 *x = e->direction, *y = e->step;
    for (int k = 0; k < ITERATIONS; k++) {
        const double size = sqrt(elastic_misfits(e, x));
        memset(e->tension_step, 0, (size_t)e->rod->ntendon * sizeof *e->tension_step);
        pull_solve(e, e->tension_step, y);
        // y = -A^-1 K x
        const double xy = -elastic_product(e, x, y), yy = elastic_product(e, y, y);
        const double next = xy / yy;
        for (int i = 0; i < e->plan->nstation; i++) {
            x[i] = vec6_scale(-1 / sqrt(yy), y[i]);
        }
        if (!(size > 0) || !isfinite(next)) {
            return NAN;
        }
        if (fabs(next - value) <= settled * fabs(next)) {
            return next - e->shift;
        }
        value = next;
    }
    return value - e->shift;
}

double energy_eigenvalue(equilibrium *e)
{
    if (!e->conservative) {
        return NAN;
    }
    double value = NAN;
    e->shift = 0;
    start_field(e, e->direction);
    for (int k = 0; k < SHIFTS; k++) {
        if (newton_linearize(e) && e->negative == 0) {
            value = inverse_iteration(e);
            // a shift close to the eigenvalue for the last digits
            if (e->shift == 0 || k == SHIFTS - 1) {
                break;
            }
        }
        e->shift = e->shift == 0 ? 0.25 : 2 * e->shift;
        if (!isnan(value)) {
            break;
        }
    }
    e->shift = 0;
    return value;
}

// --- the balance of energies

// positions of the dead loads times their forces, less lengths times the tensions given
static double load_potential(equilibrium *e)
{
    const plan *p = e->plan;
    double sum = 0;
    for (int k = 0; k <= 2 * p->npair; k++) {
        const mat3 x = mat3_mul(e->node_R[k], e->node_to[k].dyad);
        sum += vec3_dot(e->node_to[k].dead, e->node_p[k]) + x.a[0][0] + x.a[1][1] + x.a[2][2];
    }
    for (int i = 0; e->lines && i < p->nstation; i++) {
        const int k = i / GAUSS_STATIONS;
        const double h = panel_length(p, k);
        vec3 at = e->node_p[k];
        for (int j = 0; j < GAUSS_STATIONS; j++) {
            at = vec3_add(at, vec3_scale(h * gauss_inner[i % GAUSS_STATIONS][j],
                                         e->state[GAUSS_STATIONS * k + j].slope));
        }
        const mat3 x = mat3_mul(e->state[i].R, e->line_to[i].dyad);
        const double trace = x.a[0][0] + x.a[1][1] + x.a[2][2];
        sum += h * gauss_weight[i % GAUSS_STATIONS] * (vec3_dot(e->line_to[i].dead, at) + trace);
    }
    balance_lengths(e, e->length);
    for (int i = 0; i < e->rod->ntendon; i++) {
        sum -= e->pulled[i] ? 0 : e->to.tension[i] * e->length[i];
    }
    return sum;
}

// Gauss-Legendre nodes and weights on [0, 1]
static void gauss_rule(int n, double *x, double *w)
{
    for (int i = 0; i < n; i++) {
        double t = cos(3.14159265358979323846 * (i + 0.75) / (n + 0.5)), slope = 1;
        for (int k = 0; k < 60; k++) {
            double before = 1, here = t;
            for (int j = 2; j <= n; j++) {
                const double next = ((2 * j - 1) * t * here - (j - 1) * before) / j;
                before = here;
                here = next;
            }
            slope = n * (t * here - before) / (t * t - 1);
            const double change = here / slope;
            t -= change;
            if (fabs(change) < 1e-15) {
                break;
            }
        }
        x[n - 1 - i] = (1 + t) / 2;
        w[n - 1 - i] = 1 / ((1 - t * t) * slope * slope);
    }
}

static bool go_to(equilibrium *e, double from, double factor)
{
    double moved;
    newton_slope(e);
    newton_advance(e, factor - from, e->slope, e->tension_slope);
    e->factor = factor;
    loads_at_factor(e);
    return newton_correct(e, 1e-12, 12, &moved) && newton_linearize(e);
}

// what the quadrature may leave of the balance, over the energy, before shorter parts are tried
static const double balanced = 1e-10;
enum { PARTS_MORE = 4, MOST_PARTS = 64 };

// The way from rest in `npart` equal parts; false where it cannot be followed so.
static bool work_in_parts(equilibrium *e, int npart, const double *x, const double *w, double *work)
{
    double mean = 0, drawn = 0, last = 0;
    equilibrium_start_at_rest(e, e->plan);
    if (!newton_linearize(e)) {
        return false;
    }
    for (int k = 0; k < NODES * npart; k++) {
        const double at = (k / NODES + x[k % NODES]) / npart, part = w[k % NODES] / npart;
        if (!go_to(e, last, at)) {
            return false;
        }
        balance_poses(e);
        mean += part * load_potential(e);
        for (int i = 0; i < e->rod->ntendon; i++) {
            drawn += e->pulled[i] ? part * e->tension[i] * e->to.pull[i] : 0;
        }
        last = at;
    }
    if (!go_to(e, last, 1)) {
        return false;
    }
    balance_poses(e);
    for (int i = 0; i < e->rod->ntendon; i++) {
        const tendon_spec *t = &e->rod->spec[i];
        const double give = t->EA > 0 ? (e->rest_length[i] + t->outside) / t->EA : 0;
        drawn -= e->pulled[i] ? give * e->tension[i] * e->tension[i] / 2 : 0;
    }
    *work = load_potential(e) - mean + drawn;
    return true;
}

// with P(f) the loads' potential at factor f: energy = P(1) - int_0^1 P df, and what pulled tendons
// are drawn out times their tension, less what they store. Sharp turns of the path take short
// parts: so many that the balance holds, if that many are enough.
double energy_work(equilibrium *e)
{
    double x[NODES], w[NODES], work = NAN, energy = 0, residual;
    if (!e->conservative) {
        return NAN;
    }
    demand_nothing(e->rod, &e->to, &e->from);
    gauss_rule(NODES, x, w);
    for (int npart = 1; npart <= MOST_PARTS; npart *= PARTS_MORE) {
        double found;
        if (work_in_parts(e, npart, x, w, &found)) {
            work = found;
            balance_check(e, &energy, &residual);
            if (fabs(work - energy) <= balanced * fabs(energy)) {
                break;
            }
        }
    }
    return work;
}
