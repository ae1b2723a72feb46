// rodsolver/rod_solve.c
#include "rodsolver/rod_plan.h"

#include <math.h>

// rounding of one panel's exponential and product, in units of the length it carries
static const double rounding = 2e-16;
// The local error of a step of order 6 is of degree 7: one of twice the length makes 2^7, the two
// fine ones 2, so that the coarse chain is 63 times as far off. Three times that, since plans may
// be too coarse to follow the law; and a share of all local differences without their signs, since
// those may cancel by chance at the tip
static const double doubled = 63;
static const double margin = 3, unsigned_share = 0.1;

static const char *tendon_name(const rod *r, int i)
{
    return r->spec[i].name ? r->spec[i].name : "?";
}

static status fail_eaten(const rod *r, int tendon, double s, const char *more)
{
    const plan *p = &r->plans[r->nplan - 1];
    return status_fail(ERR_NUMERIC,
                       "rod: tendon '%s' has eaten its own length at s = %.6g m under %.6g N%s "
                       "(alone it can pull less than %.6g N)",
                       tendon_name(r, tendon), s, r->tension[tendon], more,
                       p->tendon[tendon].critical);
}

static void load_lanes(const plan_tendon *t, int first, int count, double m[3][SECULAR_LANES],
                       double b[3][SECULAR_LANES])
{
    for (int j = 0; j < 3; j++) {
        const double *mj = t->row + (size_t)(ROW_M + j) * (size_t)t->nstation + first;
        const double *bj = t->row + (size_t)(ROW_B + j) * (size_t)t->nstation + first;
        for (int k = 0; k < SECULAR_LANES; k++) {
            // idle lanes repeat the last station
            const int i = k < count ? k : count - 1;
            m[j][k] = mj[i];
            b[j][k] = bj[i];
        }
    }
}

// one tendon pulls on the stations first .. last - 1
static status solve_single(rod *r, const plan *p, int tendon, int first, int last, int *steps)
{
    const plan_tendon *t = &p->tendon[tendon];
    const double tau = r->tension[tendon];
    if (!(tau < t->critical)) {
        return fail_eaten(r, tendon, t->critical_at, "");
    }
    double m[3][SECULAR_LANES], b[3][SECULAR_LANES], y[3][SECULAR_LANES];
    for (int i = first; i < last; i += SECULAR_LANES) {
        const int count = last - i < SECULAR_LANES ? last - i : SECULAR_LANES;
        load_lanes(t, i, count, m, b);
        const int taken = secular_solve(tau, (const double(*)[SECULAR_LANES])m,
                                        (const double(*)[SECULAR_LANES])b, y);
        if (taken < 0) {
            return status_fail(ERR_NUMERIC,
                               "rod: no convergence at s = %.6g m under %.6g N of '%s'", p->s[i],
                               tau, tendon_name(r, tendon));
        }
        *steps += taken * count;
        for (int c = 0; c < 6; c++) {
            const double *G = t->row + (size_t)(ROW_G + 3 * c) * (size_t)t->nstation + i;
            const double *rest = p->rest + (size_t)c * (size_t)p->nstation + i;
            double *xi = r->xi + (size_t)c * (size_t)p->nstation + i;
            for (int k = 0; k < count; k++) {
                xi[k] = rest[k] - tau * (G[k] * y[0][k] + G[t->nstation + k] * y[1][k] +
                                         G[2 * t->nstation + k] * y[2][k]);
            }
        }
    }
    return OK;
}

static vec6 gather(const double *rows, int n, int i)
{
    vec6 x;
    for (int c = 0; c < 6; c++) {
        x.a[c] = rows[(size_t)c * (size_t)n + (size_t)i];
    }
    return x;
}

// several tendons pull: each station from its neighbour's answer
static status solve_several(rod *r, const plan *p, const int *active, int nactive, int first,
                            int last, int *steps)
{
    local_problem q = {.ntendon = nactive};
    vec6 strain = {0};
    for (int i = first; i < last; i++) {
        q.K = &p->K[i];
        q.rest = gather(p->rest, p->nstation, i);
        for (int j = 0; j < nactive; j++) {
            q.place[j] = p->tendon[active[j]].place[i];
            q.tension[j] = r->tension[active[j]];
        }
        vec6 xi = vec6_add(q.rest, strain);
        int which = 0;
        const local_outcome outcome = local_solve(&q, &xi, steps, &which);
        if (outcome == LOCAL_EATEN) {
            return fail_eaten(r, active[which], p->s[i], " beside the others");
        }
        if (outcome == LOCAL_FAILED) {
            return status_fail(ERR_NUMERIC,
                               "rod: no convergence at s = %.6g m, tendon '%s' is shortest",
                               p->s[i], tendon_name(r, active[which]));
        }
        strain = vec6_sub(xi, q.rest);
        for (int c = 0; c < 6; c++) {
            r->xi[(size_t)c * (size_t)p->nstation + (size_t)i] = xi.a[c];
        }
    }
    return OK;
}

// stations up to the next tendon's end, and who pulls there
static int next_stretch(const rod *r, const plan *p, int first, int *active, int *nactive)
{
    int last = p->nstation;
    *nactive = 0;
    for (int j = 0; j < r->nactive; j++) {
        const int n = p->tendon[r->active[j]].nstation;
        if (n > first) {
            active[(*nactive)++] = r->active[j];
            last = n < last ? n : last;
        }
    }
    return last;
}

static status solve_stations(rod *r, const plan *p, int *steps)
{
    status st = OK;
    int active[ROD_MAX_TENDONS], nactive = 0;
    for (int first = 0; first < p->nstation;) {
        const int last = next_stretch(r, p, first, active, &nactive);
        if (nactive == 1) {
            TRY(solve_single(r, p, active[0], first, last, steps));
        } else if (nactive > 1) {
            TRY(solve_several(r, p, active, nactive, first, last, steps));
        } else {
            for (int c = 0; c < 6; c++) {
                for (int i = first; i < last; i++) {
                    const size_t k = (size_t)c * (size_t)p->nstation + (size_t)i;
                    r->xi[k] = p->rest[k];
                }
            }
        }
        first = last;
    }

done:
    return st;
}

// difference of two motions over the same pair, as a displacement and an angle
static void motion_difference(const pose *g, const pose *h, double *displacement, double *angle)
{
    double square = 0;
    for (int i = 0; i < 9; i++) {
        const double d = g->R.a[i / 3][i % 3] - h->R.a[i / 3][i % 3];
        square += d * d;
    }
    *displacement = vec3_norm(vec3_sub(g->p, h->p));
    *angle = sqrt(square / 2);
}

// strains at the Gauss points of one panel of twice the length, from the pair's own stations
static void coarse_strains(const rod *r, const vec6 xi[PAIR_STATIONS], vec6 coarse[GAUSS_STATIONS])
{
    for (int i = 0; i < GAUSS_STATIONS; i++) {
        for (int c = 0; c < 6; c++) {
            double value = 0;
            for (int j = 0; j < PAIR_STATIONS; j++) {
                value += r->pair_weight[i][j] * xi[j].a[c];
            }
            coarse[i].a[c] = value;
        }
    }
}

// the chain of panels, docs/theory.md (4.6), and beside it a chain of one step per pair on the same
// stations, (4.8)
static double integrate(rod *r, const plan *p)
{
    double sum = 0;
    pose coarse_tip = pose_identity();
    r->pair_pose[0] = pose_identity();
    for (int k = 0; k < p->npair; k++) {
        vec6 xi[PAIR_STATIONS], coarse[GAUSS_STATIONS];
        for (int i = 0; i < PAIR_STATIONS; i++) {
            xi[i] = gather(r->xi, p->nstation, PAIR_STATIONS * k + i);
        }
        coarse_strains(r, xi, coarse);
        const double h = (p->pair_edge[2 * k + 1] - p->pair_edge[2 * k]) / 2;
        const pose fine = pose_mul(se3_exp(lie_step_twist(h, xi)),
                                   se3_exp(lie_step_twist(h, xi + GAUSS_STATIONS)));
        const pose once = se3_exp(lie_step_twist(2 * h, coarse));
        double displacement, angle;
        motion_difference(&fine, &once, &displacement, &angle);
        // the lever to the tip is at most the length that is left
        sum += displacement + angle * (r->length - p->pair_edge[2 * k + 1]);
        r->pair_pose[k + 1] = pose_mul(r->pair_pose[k], fine);
        coarse_tip = pose_mul(coarse_tip, once);
    }
    const double tip = vec3_norm(vec3_sub(r->pair_pose[p->npair].p, coarse_tip.p));
    const double estimate = (margin * tip + unsigned_share * sum) / (doubled * r->length);
    return r->doubt * estimate + rounding * 2 * p->npair;
}

static void tendon_lengths(const rod *r, const plan *p, double *length)
{
    for (int j = 0; j < r->ntendon; j++) {
        const plan_tendon *t = &p->tendon[j];
        double sum = 0;
        for (int i = 0; i < t->nstation; i++) {
            const double *edge = &p->pair_edge[2 * (i / PAIR_STATIONS)];
            const vec6 xi = gather(r->xi, p->nstation, i);
            sum += gauss_weight[i % GAUSS_STATIONS] * (edge[1] - edge[0]) / 2 *
                   vec3_norm(tendon_direction(&t->place[i], &xi));
        }
        length[j] = sum;
    }
}

// strains of both frames differ by Ad(T): reported at the geometric centre
static vec6 largest_strain(const rod *r, const plan *p)
{
    vec6 worst = {0};
    for (int i = 0; i < p->nstation; i++) {
        vec6 e = vec6_sub(gather(r->xi, p->nstation, i), gather(p->rest, p->nstation, i));
        if (p->frame) {
            e = mat6_mul_vec(se3_adjoint(centre_frame_pose(&p->frame[i])), e);
        }
        for (int c = 0; c < 6; c++) {
            worst.a[c] = fmax(worst.a[c], fabs(e.a[c]));
        }
    }
    return worst;
}

status solve_on_plan(struct rod *r, const plan *p, rod_solution *out)
{
    status st = OK;
    int steps = 0;
    r->solved = NULL;
    TRY(solve_stations(r, p, &steps));
    out->relative_error = integrate(r, p);
    r->solved = p;
    out->tip = pose_mul(r->base, pose_mul(r->pair_pose[p->npair], pose_inverse(r->tip)));
    out->iterations = steps;

done:
    return st;
}

static status take_tensions(rod *r, const double *tension)
{
    r->nactive = 0;
    for (int i = 0; i < r->ntendon; i++) {
        if (!(tension[i] >= 0) || !isfinite(tension[i])) {
            return status_fail(ERR_INPUT,
                               "rod: tension of tendon '%s' is %g N, tendons cannot push",
                               tendon_name(r, i), tension[i]);
        }
        r->tension[i] = tension[i];
        if (tension[i] > 0) {
            r->active[r->nactive++] = i;
        }
    }
    return OK;
}

// by the share of the critical tension, so that the answer does not depend on what was solved
// before
static int first_plan(const rod *r)
{
    const plan *p = &r->plans[r->nplan - 1];
    double share = 0;
    for (int i = 0; i < r->ntendon; i++) {
        share += r->tension[i] / p->tendon[i].critical;
    }
    int k = 0;
    while (k < ROD_PROBES - 1 && share > rod_probe_share[k]) {
        k++;
    }
    return r->first_plan[k];
}

// the coarsest finer plan whose error should be half the tolerance at most
static int finer_plan(const rod *r, int k, double error)
{
    const double n = r->plans[k].npair;
    for (k++; k < r->nplan - 1; k++) {
        if (error * pow(n / r->plans[k].npair, 6) < r->options.tolerance / 2) {
            break;
        }
    }
    return k;
}

status rod_solve(rod *r, const double *tension, rod_solution *out)
{
    status st = OK;
    const bool fixed = r->options.npanel > 0;
    TRY(take_tensions(r, tension));
    int k = fixed ? 0 : first_plan(r), steps = 0;
    for (;;) {
        TRY(solve_on_plan(r, &r->plans[k], out));
        steps += out->iterations;
        if (fixed || out->relative_error <= r->options.tolerance) {
            break;
        }
        if (k == r->nplan - 1) {
            r->solved = NULL;
            TRY(status_fail(
                ERR_NUMERIC,
                "rod: the estimated error of the tip, %.2g of the length, stays above the "
                "tolerance %.2g with %d panels",
                out->relative_error, r->options.tolerance, 2 * r->plans[k].npair));
        }
        k = finer_plan(r, k, out->relative_error);
    }
    out->iterations = steps;
    out->max_strain = largest_strain(r, r->solved);
    if (out->tendon_length) {
        tendon_lengths(r, r->solved, out->tendon_length);
    }

done:
    return st;
}
