// rodsolver/rod_solve.c
#include "rodsolver/equilibrium.h"
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

static status fail_eaten(const rod_state *state, int tendon, double s, const char *more)
{
    const rod *r = state->rod;
    const plan *p = &r->plans[r->nplan - 1];
    return status_fail(ERR_NUMERIC,
                       "rod: tendon '%s' has eaten its own length at s = %.6g m under %.6g N%s "
                       "(alone it can pull less than %.6g N)",
                       tendon_name(r, tendon), s, state->tension[tendon], more,
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
static status solve_single(rod_state *state, const plan *p, int tendon, int first, int last,
                           int *steps)
{
    const plan_tendon *t = &p->tendon[tendon];
    const double tau = state->tension[tendon];
    if (!(tau < t->critical)) {
        return fail_eaten(state, tendon, t->critical_at, "");
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
                               tau, tendon_name(state->rod, tendon));
        }
        *steps += taken * count;
        for (int c = 0; c < 6; c++) {
            const double *G = t->row + (size_t)(ROW_G + 3 * c) * (size_t)t->nstation + i;
            const double *rest = p->rest + (size_t)c * (size_t)p->nstation + i;
            double *xi = state->xi + (size_t)c * (size_t)p->nstation + i;
            for (int k = 0; k < count; k++) {
                xi[k] = rest[k] - tau * (G[k] * y[0][k] + G[t->nstation + k] * y[1][k] +
                                         G[2 * t->nstation + k] * y[2][k]);
            }
        }
    }
    return OK;
}

// several tendons pull: each station from its neighbour's answer
static status solve_several(rod_state *state, const plan *p, const int *active, int nactive,
                            int first, int last, int *steps)
{
    local_problem q = {.ntendon = nactive};
    vec6 strain = {0};
    for (int i = first; i < last; i++) {
        q.K = &p->K[i];
        q.rest = station_gather(p->rest, p->nstation, i);
        for (int j = 0; j < nactive; j++) {
            q.place[j] = p->tendon[active[j]].place[i];
            q.tension[j] = state->tension[active[j]];
        }
        vec6 xi = vec6_add(q.rest, strain);
        int which = 0;
        const local_outcome outcome = local_solve(&q, &xi, steps, &which);
        if (outcome == LOCAL_EATEN) {
            return fail_eaten(state, active[which], p->s[i], " beside the others");
        }
        if (outcome == LOCAL_FAILED) {
            return status_fail(ERR_NUMERIC,
                               "rod: no convergence at s = %.6g m, tendon '%s' is shortest",
                               p->s[i], tendon_name(state->rod, active[which]));
        }
        strain = vec6_sub(xi, q.rest);
        for (int c = 0; c < 6; c++) {
            state->xi[(size_t)c * (size_t)p->nstation + (size_t)i] = xi.a[c];
        }
    }
    return OK;
}

// stations up to the next tendon's end, and who pulls there
static int next_stretch(const rod_state *state, const plan *p, int first, int *active, int *nactive)
{
    int last = p->nstation;
    *nactive = 0;
    for (int j = 0; j < state->nactive; j++) {
        const int n = p->tendon[state->active[j]].nstation;
        if (n > first) {
            active[(*nactive)++] = state->active[j];
            last = n < last ? n : last;
        }
    }
    return last;
}

static status solve_stations(rod_state *state, const plan *p, int *steps)
{
    status st = OK;
    int active[ROD_MAX_TENDONS], nactive = 0;
    for (int first = 0; first < p->nstation;) {
        const int last = next_stretch(state, p, first, active, &nactive);
        if (nactive == 1) {
            TRY(solve_single(state, p, active[0], first, last, steps));
        } else if (nactive > 1) {
            TRY(solve_several(state, p, active, nactive, first, last, steps));
        } else {
            for (int c = 0; c < 6; c++) {
                for (int i = first; i < last; i++) {
                    const size_t k = (size_t)c * (size_t)p->nstation + (size_t)i;
                    state->xi[k] = p->rest[k];
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
static double integrate(rod_state *state, const plan *p)
{
    const rod *r = state->rod;
    double sum = 0;
    pose coarse_tip = pose_identity();
    state->pair_pose[0] = pose_identity();
    for (int k = 0; k < p->npair; k++) {
        vec6 xi[PAIR_STATIONS], coarse[GAUSS_STATIONS];
        for (int i = 0; i < PAIR_STATIONS; i++) {
            xi[i] = station_gather(state->xi, p->nstation, PAIR_STATIONS * k + i);
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
        state->pair_pose[k + 1] = pose_mul(state->pair_pose[k], fine);
        coarse_tip = pose_mul(coarse_tip, once);
    }
    const double tip = vec3_norm(vec3_sub(state->pair_pose[p->npair].p, coarse_tip.p));
    const double estimate = (margin * tip + unsigned_share * sum) / (doubled * r->length);
    return r->doubt * estimate + rounding * 2 * p->npair;
}

static void tendon_lengths(const rod_state *state, const plan *p, double *length)
{
    for (int j = 0; j < state->rod->ntendon; j++) {
        const plan_tendon *t = &p->tendon[j];
        double sum = 0;
        for (int i = 0; i < t->nstation; i++) {
            const double *edge = &p->pair_edge[2 * (i / PAIR_STATIONS)];
            const vec6 xi = station_gather(state->xi, p->nstation, i);
            sum += gauss_weight[i % GAUSS_STATIONS] * (edge[1] - edge[0]) / 2 *
                   vec3_norm(tendon_direction(&t->place[i], &xi));
        }
        length[j] = sum;
    }
}

// strains of both frames differ by Ad(T): reported at the geometric centre
static vec6 largest_strain(const rod_state *state, const plan *p)
{
    vec6 worst = {0};
    for (int i = 0; i < p->nstation; i++) {
        vec6 e = vec6_sub(station_gather(state->xi, p->nstation, i),
                          station_gather(p->rest, p->nstation, i));
        if (p->frame) {
            e = mat6_mul_vec(se3_adjoint(centre_frame_pose(&p->frame[i])), e);
        }
        for (int c = 0; c < 6; c++) {
            worst.a[c] = fmax(worst.a[c], fabs(e.a[c]));
        }
    }
    return worst;
}

// docs/theory.md (4.2): the energy of the strains, and the misfit of the balance as a strain,
// relative to the largest strain, in the norm of the energy
static void check_balance(const rod_state *state, const plan *p, rod_solution *out)
{
    double largest = 0, worst = 0;
    out->energy = 0;
    for (int i = 0; i < p->nstation; i++) {
        const double *edge = &p->pair_edge[2 * (i / PAIR_STATIONS)];
        const vec6 xi = station_gather(state->xi, p->nstation, i);
        const vec6 e = vec6_sub(xi, station_gather(p->rest, p->nstation, i));
        vec6 g = mat6_mul_vec(p->K[i], e);
        const double twice = vec6_dot(e, g);
        for (int j = 0; j < state->nactive; j++) {
            const plan_tendon *t = &p->tendon[state->active[j]];
            if (i < t->nstation) {
                const vec3 d = tendon_direction(&t->place[i], &xi);
                const double q = state->tension[state->active[j]] / vec3_norm(d);
                g = vec6_add(g, tendon_wrench(&t->place[i], vec3_scale(q, d)));
            }
        }
        mat6 lower;
        if (mat6_cholesky(p->K[i], &lower)) {
            worst = fmax(worst, vec6_dot(g, mat6_cholesky_solve(&lower, g)));
        }
        largest = fmax(largest, twice);
        out->energy += gauss_weight[i % GAUSS_STATIONS] * (edge[1] - edge[0]) / 4 * twice;
    }
    out->residual = largest > 0 ? sqrt(worst / largest) : 0;
}

status solve_on_plan(rod_state *state, const plan *p, rod_solution *out)
{
    status st = OK;
    const rod *r = state->rod;
    int steps = 0;
    state->solved = NULL;
    TRY(solve_stations(state, p, &steps));
    out->relative_error = integrate(state, p);
    state->solved = p;
    out->tip = pose_mul(r->base, pose_mul(state->pair_pose[p->npair], pose_inverse(r->tip)));
    out->iterations = steps;

done:
    return st;
}

static bool all_finite(const double *a, int n)
{
    for (int i = 0; i < n; i++) {
        if (!isfinite(a[i])) {
            return false;
        }
    }
    return true;
}

static status check_request(const rod *r, const rod_request *q)
{
    if (!all_finite(q->tip_space.a, 6) || !all_finite(q->tip_body.a, 6)) {
        return status_fail(ERR_INPUT, "rod: the wrench on the tip is not finite");
    }
    if (q->base && !(all_finite(q->base->p.a, 3) && all_finite(q->base->R.a[0], 9))) {
        return status_fail(ERR_INPUT, "rod: the pose of the base is not finite");
    }
    if (q->load && !all_finite(q->load, rod_load_count(r))) {
        return status_fail(ERR_INPUT, "rod: a factor of a load is not finite");
    }
    for (int i = 0; q->pull && i < r->ntendon; i++) {
        if (isinf(q->pull[i])) {
            return status_fail(ERR_INPUT, "rod: the pulled length of tendon '%s' is not finite",
                               tendon_name(r, i));
        }
    }
    return OK;
}

// a tendon whose pulled length is given pulls as hard as that needs
static status take_tensions(rod_state *state, const rod_request *q)
{
    const rod *r = state->rod;
    state->nactive = 0;
    for (int i = 0; i < r->ntendon; i++) {
        const bool pulled = q->pull && !isnan(q->pull[i]);
        const double tension = q->tension && !pulled ? q->tension[i] : 0;
        if (!(tension >= 0) || !isfinite(tension)) {
            return status_fail(ERR_INPUT,
                               "rod: tension of tendon '%s' is %g N, tendons cannot push",
                               tendon_name(r, i), tension);
        }
        state->tension[i] = tension;
        if (tension > 0) {
            state->active[state->nactive++] = i;
        }
    }
    return OK;
}

// whether anything acts besides tensions that stay the same along their tendons
static bool stations_depend_on_each_other(const rod_state *state, const rod_request *q)
{
    const rod *r = state->rod;
    for (int c = 0; c < 6; c++) {
        if (q->tip_space.a[c] != 0 || q->tip_body.a[c] != 0) {
            return true;
        }
    }
    for (int i = 0; i < rod_load_count(r); i++) {
        if (r->acts[i] && !(q->load && q->load[i] == 0)) {
            return true;
        }
    }
    for (int i = 0; i < r->ntendon; i++) {
        if ((q->pull && !isnan(q->pull[i])) || (state->tension[i] > 0 && r->spec[i].friction > 0)) {
            return true;
        }
    }
    return false;
}

// by the share of the critical tension, so that the answer does not depend on what was solved
// before
static int first_plan(const rod_state *state)
{
    const rod *r = state->rod;
    const plan *p = &r->plans[r->nplan - 1];
    double share = 0;
    for (int i = 0; i < r->ntendon; i++) {
        share += state->tension[i] / p->tendon[i].critical;
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

static status solve_stationwise(rod_state *state, rod_solution *out)
{
    status st = OK;
    const rod *r = state->rod;
    const bool fixed = r->options.npanel > 0;
    int k = fixed ? 0 : first_plan(state), steps = 0;
    for (;;) {
        TRY(solve_on_plan(state, &r->plans[k], out));
        steps += out->iterations;
        if (fixed || out->relative_error <= r->options.tolerance) {
            break;
        }
        if (k == r->nplan - 1) {
            state->solved = NULL;
            TRY(status_fail(
                ERR_NUMERIC,
                "rod: the estimated error of the tip, %.2g of the length, stays above the "
                "tolerance %.2g with %d panels",
                out->relative_error, r->options.tolerance, 2 * r->plans[k].npair));
        }
        k = finer_plan(r, k, out->relative_error);
    }
    out->iterations = steps;

done:
    return st;
}

static void tell(const rod_state *state, rod_solution *out)
{
    const plan *p = state->solved;
    out->tip = pose_mul(state->base, out->tip);
    out->max_strain = largest_strain(state, p);
    out->fraction = 1;
    out->stable = 1; // the energy is convex: docs/theory.md (4.3)
    out->eigenvalue = NAN;
    out->ncritical = 0;
    check_balance(state, p, out);
    out->work = out->energy;
    if (out->tendon_length) {
        tendon_lengths(state, p, out->tendon_length);
    }
    for (int i = 0; out->tension && i < state->rod->ntendon; i++) {
        out->tension[i] = state->tension[i];
    }
}

status rod_solve(rod_state *state, const rod_request *request, rod_solution *out)
{
    status st = OK;
    TRY(check_request(state->rod, request));
    TRY(take_tensions(state, request));
    state->base = request->base ? *request->base : pose_identity();
    if (stations_depend_on_each_other(state, request)) {
        return equilibrium_solve(state, request, out);
    }
    state->by_load = false;
    TRY(solve_stationwise(state, out));
    tell(state, out);
    equilibrium_remember(state);

done:
    if (st != OK) {
        state->solved = NULL;
    }
    return st;
}
