// rodsolver/stations.c
// The strains at all stations of a plan under tensions alone: each station is its own problem.
#include "rodsolver/stations.h"

#include <math.h>

static const char *tendon_name(const rod *r, int i)
{
    return r->spec[i].name ? r->spec[i].name : "?";
}

static status fail_eaten(const rod_state *state, int tendon, double s, const char *more)
{
    const rod *r = state->rod;
    const plan *p = &r->plans[r->nplan - 1];
    return status_fail(ERR_NUMERIC,
                       "rod: tendon '%s' has eaten its own length at s = %.6g mm under %.6g N%s "
                       "(alone it can pull less than %.6g N)",
                       tendon_name(r, tendon), 1e3 * s, state->tension[tendon], more,
                       p->tendon[tendon].critical);
}

// strains of the first `count` stations from i on; on a uniform plan the first of a pair stands
// for all of them
static void store(rod_state *state, const plan *p, int i, int count, const lanes xi[6])
{
    for (int c = 0; c < 6; c++) {
        double *row = state->xi + (size_t)c * (size_t)p->nstation + i;
        for (int k = 0; p->uniform && k < PAIR_STATIONS; k++) {
            row[k] = xi[c][0];
        }
        if (!p->uniform && count == LANES) {
            *(loose_lanes *)row = xi[c];
        }
        for (int k = 0; !p->uniform && count < LANES && k < count; k++) {
            row[k] = xi[c][k];
        }
    }
}

LANES_CODE static void strain_of(const plan_tendon *t, const plan *p, double tau, int i,
                                 const lanes y[3], lanes xi[6])
{
    const double *G = t->row + (size_t)ROW_G * (size_t)t->nstation + i;
    const double *rest = p->rest + i;
    for (int c = 0; c < 6; c++) {
        lanes g[3], x;
        for (int j = 0; j < 3; j++) {
            lanes_load(G + (size_t)(3 * c + j) * (size_t)t->nstation, &g[j]);
        }
        lanes_load(rest + (size_t)c * (size_t)p->nstation, &x);
        xi[c] = x - tau * (g[0] * y[0] + g[1] * y[1] + g[2] * y[2]);
    }
}

// one tendon pulls on eight stations
static status solve_single(rod_state *state, const plan *p, int tendon, int i, int count,
                           int *steps)
{
    const plan_tendon *t = &p->tendon[tendon];
    const double tau = state->tension[tendon];
    if (!(tau < t->critical)) {
        return fail_eaten(state, tendon, t->critical_at, "");
    }
    const double *row = t->row + i;
    const size_t n = (size_t)t->nstation;
    lanes m[3], b[3], y[3], xi[6];
    for (size_t j = 0; j < 3; j++) {
        lanes_load(row + (ROW_M + j) * n, &m[j]);
        lanes_load(row + (ROW_B + j) * n, &b[j]);
    }
    const int taken = secular_solve(tau, count, m, b, y);
    if (taken < 0) {
        return status_fail(ERR_NUMERIC, "rod: no convergence at s = %.6g mm under %.6g N of '%s'",
                           1e3 * p->s[i], tau, tendon_name(state->rod, tendon));
    }
    *steps += taken * count;
    strain_of(t, p, tau, i, y, xi);
    store(state, p, i, count, xi);
    return OK;
}

// the tendons in state->pulling, seen from eight stations
static lane_problem lanes_at(const rod_state *state, const plan *p, int npulling, int i, int count)
{
    for (int j = 0; j < npulling; j++) {
        const plan_tendon *t = &p->tendon[state->pulling[j]];
        state->lane_tendon[j] = (lane_tendon){.place = t->place_row + i,
                                              .stride = t->nstation,
                                              .tension = state->tension[state->pulling[j]]};
    }
    return (lane_problem){.K = p->K_row + i,
                          .rest = p->rest + i,
                          .stride = p->nstation,
                          .count = count,
                          .ntendon = npulling,
                          .tendon = state->lane_tendon};
}

// a station where a tendon is nearly eaten, or is
static status solve_hard(rod_state *state, const plan *p, int npulling, int i, vec6 *xi, int *steps)
{
    local_problem q = {.K = &p->K[i],
                       .rest = station_gather(p->rest, p->nstation, i),
                       .ntendon = npulling,
                       .tendon = state->local.tendon};
    for (int j = 0; j < npulling; j++) {
        q.tendon[j] = (local_tendon){.place = p->tendon[state->pulling[j]].place[i],
                                     .tension = state->tension[state->pulling[j]]};
    }
    int which = 0;
    *xi = q.rest;
    const local_outcome outcome = local_solve(&q, xi, steps, &which);
    if (outcome == LOCAL_EATEN) {
        return fail_eaten(state, state->pulling[which], p->s[i], " beside the others");
    }
    if (outcome == LOCAL_FAILED) {
        return status_fail(ERR_NUMERIC,
                           "rod: no convergence at s = %.6g mm, tendon '%s' is shortest",
                           1e3 * p->s[i], tendon_name(state->rod, state->pulling[which]));
    }
    return OK;
}

// several tendons pull on eight stations; from the last answer, or from the strains of the stations
// before
static status solve_several(rod_state *state, const plan *p, int npulling, int i, int count,
                            lanes e[6], int *steps)
{
    status st = OK;
    lanes xi[6], rest[6];
    unsigned unsolved = 0;
    const lane_problem q = lanes_at(state, p, npulling, i, count);
    for (int c = 0; c < 6; c++) {
        lanes_load(p->rest + (size_t)c * (size_t)p->nstation + i, &rest[c]);
        xi[c] = rest[c] + e[c];
        if (state->warm == p) {
            lanes_load(state->xi + (size_t)c * (size_t)p->nstation + i, &xi[c]);
        }
    }
    *steps += local_solve_lanes(&q, xi, &unsolved) * count;
    for (int k = 0; unsolved && k < count; k++) {
        vec6 one;
        if (unsolved >> k & 1) {
            TRY(solve_hard(state, p, npulling, i + k, &one, steps));
            for (int c = 0; c < 6; c++) {
                xi[c][k] = one.a[c];
            }
        }
    }
    for (int c = 0; c < 6; c++) {
        // the next stations begin where the last one of these ended
        const lanes zero = {0};
        e[c] = zero + (xi[c][count - 1] - rest[c][count - 1]);
    }
    store(state, p, i, count, xi);

done:
    return st;
}

static void leave_at_rest(rod_state *state, const plan *p, int first, int last)
{
    for (int c = 0; c < 6; c++) {
        const size_t row = (size_t)c * (size_t)p->nstation;
        for (int i = first; i < last; i++) {
            state->xi[row + (size_t)i] = p->rest[row + (size_t)i];
        }
    }
}

// stations up to the next tendon's end, and who pulls there
static int next_stretch(const rod_state *state, const plan *p, int first, int *npulling)
{
    int last = p->nstation;
    *npulling = 0;
    for (int j = 0; j < state->nactive; j++) {
        const int n = p->tendon[state->active[j]].nstation;
        if (n > first) {
            state->pulling[(*npulling)++] = state->active[j];
            last = n < last ? n : last;
        }
    }
    return last;
}

static int block_size(const plan *p, int i, int last, int *count)
{
    if (p->uniform) {
        *count = 1;
        return PAIR_STATIONS;
    }
    *count = last - i < LANES ? last - i : LANES;
    return *count;
}

status stations_solve(rod_state *state, const plan *p, int *steps)
{
    status st = OK;
    int npulling = 0, count = 0;
    lanes e[6] = {{0}};
    for (int first = 0; first < p->nstation;) {
        const int last = next_stretch(state, p, first, &npulling);
        if (npulling == 0) {
            leave_at_rest(state, p, first, last);
        }
        for (int i = first; npulling > 0 && i < last; i += block_size(p, i, last, &count)) {
            (void)block_size(p, i, last, &count);
            if (npulling == 1) {
                TRY(solve_single(state, p, state->pulling[0], i, count, steps));
            } else {
                TRY(solve_several(state, p, npulling, i, count, e, steps));
            }
        }
        first = last;
    }

done:
    return st;
}

// --- what the strains tell

// e at the geometric centre: Ad(T) e = (R v + p x R w, R w), docs/theory.md (1.3)
LANES_INLINE void to_centre(const plan *p, int i, lanes e[6])
{
    lanes f[4], q[6];
    for (size_t j = 0; j < 4; j++) {
        lanes_load(p->turn + j * (size_t)p->nstation + i, &f[j]);
    }
    for (int j = 0; j < 6; j += 3) {
        q[j] = f[0] * e[j] - f[1] * e[j + 1];
        q[j + 1] = f[1] * e[j] + f[0] * e[j + 1];
    }
    e[0] = q[0] + f[3] * e[5];
    e[1] = q[1] - f[2] * e[5];
    e[2] += f[2] * q[4] - f[3] * q[3];
    e[3] = q[3];
    e[4] = q[4];
}

LANES_CODE static void largest_of(const plan *p, int i, int count, const lanes xi[6], vec6 *worst)
{
    lanes e[6];
    for (int c = 0; c < 6; c++) {
        lanes_load(p->rest + (size_t)c * (size_t)p->nstation + i, &e[c]);
        e[c] = xi[c] - e[c];
    }
    if (p->frame) {
        to_centre(p, i, e);
    }
    for (int c = 0; c < 6; c++) {
        for (int k = 0; k < count; k++) {
            worst->a[c] = fmax(worst->a[c], fabs(e[c][k]));
        }
    }
}

// weight of a station's share in an integral along the rod [m]
static double station_weight(const plan *p, int i)
{
    const double *edge = &p->pair_edge[2 * (i / PAIR_STATIONS)];
    return gauss_weight[i % GAUSS_STATIONS] * (edge[1] - edge[0]) / 2;
}

void stations_check(const rod_state *state, const plan *p, rod_solution *out)
{
    double largest = 0, worst = 0, sum = 0;
    int npulling = 0, count = 0;
    vec6 most = {0};
    for (int first = 0; first < p->nstation;) {
        const int last = next_stretch(state, p, first, &npulling);
        for (int i = first; i < last; i += block_size(p, i, last, &count)) {
            (void)block_size(p, i, last, &count);
            lanes xi[6], energy, misfit;
            for (int c = 0; c < 6; c++) {
                lanes_load(state->xi + (size_t)c * (size_t)p->nstation + i, &xi[c]);
            }
            const lane_problem q = lanes_at(state, p, npulling, i, count);
            local_check_lanes(&q, xi, &energy, &misfit);
            largest_of(p, i, count, xi, &most);
            for (int k = 0; k < count; k++) {
                const double *edge = &p->pair_edge[2 * (i / PAIR_STATIONS)];
                sum += (p->uniform ? edge[1] - edge[0] : station_weight(p, i + k)) * energy[k];
                largest = fmax(largest, energy[k]);
                worst = fmax(worst, misfit[k]);
            }
        }
        first = last;
    }
    out->max_strain = most;
    out->energy = sum / 2;
    out->residual = largest > 0 ? sqrt(worst / largest) : 0;
}

void stations_lengths(const rod_state *state, const plan *p, double *length)
{
    for (int j = 0; j < state->rod->ntendon; j++) {
        const plan_tendon *t = &p->tendon[j];
        double sum = 0;
        for (int i = 0; i < t->nstation; i++) {
            const vec6 xi = station_gather(state->xi, p->nstation, i);
            sum += station_weight(p, i) * vec3_norm(tendon_direction(&t->place[i], &xi));
        }
        length[j] = sum;
    }
}
