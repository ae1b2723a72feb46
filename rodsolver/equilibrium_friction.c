// rodsolver/equilibrium_friction.c
// Coulomb friction along the tendons' paths while they pull: tau' = -mu tau |(R t)'|, so that
// tau(s) = tau(0) exp(-mu times the angle that the path has turned), and how tensions change when
// strains do. docs/theory.md (4.26)
#include "rodsolver/collocation.h"
#include "rodsolver/equilibrium.h"

#include <math.h>
#include <string.h>

// between the directions in which a path turns at two stations next to each other
static const double cos_bent_back = 0;

typedef struct pair_matrix {
    double a[PAIR_STATIONS][PAIR_STATIONS];
} pair_matrix;

// the derivative of the polynomial through a pair's six stations, at them, per panel length
static pair_matrix pair_slopes(void)
{
    pair_matrix D;
    double x[PAIR_STATIONS], w[PAIR_STATIONS];
    for (int i = 0; i < PAIR_STATIONS; i++) {
        x[i] = gauss_point[i % GAUSS_STATIONS] + i / GAUSS_STATIONS;
    }
    for (int i = 0; i < PAIR_STATIONS; i++) {
        w[i] = 1;
        for (int j = 0; j < PAIR_STATIONS; j++) {
            w[i] *= j == i ? 1 : 1 / (x[i] - x[j]);
        }
    }
    for (int i = 0; i < PAIR_STATIONS; i++) {
        D.a[i][i] = 0;
        for (int j = 0; j < PAIR_STATIONS; j++) {
            if (j != i) {
                D.a[i][j] = w[j] / w[i] / (x[i] - x[j]);
                D.a[i][i] -= D.a[i][j];
            }
        }
    }
    return D;
}

// how a tendon's path turns in space at the stations of a pair, and how its tangent moves when the
// strains change
typedef struct path_turn_rate {
    vec3 turn[PAIR_STATIONS];     // w x t + t' [1/m]
    double rate[PAIR_STATIONS];   // |w x t + t'| [1/m]
    double change[PAIR_STATIONS]; // of it, where strains change
} path_turn_rate;

// change of t = d / |d| by a change of strains
static vec3 tangent_change(const tendon_place *place, double length, vec3 t, const vec6 *step)
{
    tendon_place straight = *place;
    straight.dx = straight.dy = 0;
    const vec3 change = tendon_direction(&straight, step);
    const vec3 across = vec3_sub(change, vec3_scale(vec3_dot(t, change), t));
    return vec3_scale(1 / length, across);
}

// sum_j D_ij t_j / h
static vec3 slope_at(const pair_matrix *D, int i, double h, const vec3 *t)
{
    vec3 sum = {{0, 0, 0}};
    for (int j = 0; j < PAIR_STATIONS; j++) {
        sum = vec3_add(sum, vec3_scale(D->a[i][j] / h, t[j]));
    }
    return sum;
}

// step: [nstation] changes of the strains, NULL for none
static path_turn_rate turn_rate(const equilibrium *e, const plan_tendon *tendon, int pair,
                                const pair_matrix *D, const vec6 *step)
{
    const double h = panel_length(e->plan, 2 * pair);
    const int first = PAIR_STATIONS * pair;
    path_turn_rate out = {.rate = {0}};
    vec3 t[PAIR_STATIONS], dt[PAIR_STATIONS];
    for (int i = 0; i < PAIR_STATIONS; i++) {
        const tendon_place *place = &tendon->place[first + i];
        const vec3 d = tendon_direction(place, &e->xi[first + i]);
        const double length = vec3_norm(d);
        t[i] = vec3_scale(1 / length, d);
        if (step) {
            dt[i] = tangent_change(place, length, t[i], &step[first + i]);
        }
    }
    for (int i = 0; i < PAIR_STATIONS; i++) {
        const vec3 w = vec6_angular(e->xi[first + i]);
        out.turn[i] = vec3_add(vec3_cross(w, t[i]), slope_at(D, i, h, t));
        out.rate[i] = vec3_norm(out.turn[i]);
        // where the path does not turn at all its rate has no derivative: none is taken
        if (step && out.rate[i] > 0) {
            const vec3 dw = vec6_angular(step[first + i]);
            vec3 change = vec3_add(vec3_cross(dw, t[i]), vec3_cross(w, dt[i]));
            change = vec3_add(change, slope_at(D, i, h, dt));
            out.change[i] = vec3_dot(out.turn[i], change) / out.rate[i];
        }
    }
    return out;
}

// integrals of a rate from `start` on up to a pair's stations; returned: to its end
static double integrate_pair(double h, const double *rate, double start, double *upto)
{
    for (int k = 0; k < PAIR_STATIONS; k += GAUSS_STATIONS) {
        double end = start;
        for (int i = 0; i < GAUSS_STATIONS; i++) {
            upto[k + i] = start;
            for (int j = 0; j < GAUSS_STATIONS; j++) {
                upto[k + i] += h * gauss_inner[i][j] * rate[k + j];
            }
            end += h * gauss_weight[i] * rate[k + i];
        }
        start = end;
    }
    return start;
}

static double *decay_of(const equilibrium *e, int tendon)
{
    return e->decay + (size_t)tendon * (size_t)e->room;
}

// Where a path straightens and bends to another side within a panel, its rate of turning has a
// corner there, or nearly so, and the panels' order is lost: tau'' jumps
static bool is_bent_back(const vec3 *turn, vec3 before)
{
    for (int i = 0; i < PAIR_STATIONS; i++) {
        if (vec3_dot(turn[i], before) < cos_bent_back * vec3_norm(turn[i]) * vec3_norm(before)) {
            return true;
        }
        before = turn[i];
    }
    return false;
}

void balance_friction(equilibrium *e)
{
    e->bent_back = false;
    const pair_matrix D = pair_slopes();
    for (int j = 0; j < e->rod->ntendon; j++) {
        const plan_tendon *t = &e->plan->tendon[j];
        const double mu = e->rod->spec[j].friction;
        double *decay = decay_of(e, j), angle = 0;
        vec3 last = {{0, 0, 0}};
        for (int pair = 0; mu > 0 && PAIR_STATIONS * pair < t->nstation; pair++) {
            double upto[PAIR_STATIONS];
            const path_turn_rate turn = turn_rate(e, t, pair, &D, NULL);
            angle = integrate_pair(panel_length(e->plan, 2 * pair), turn.rate, angle, upto);
            e->bent_back = e->bent_back || is_bent_back(turn.turn, last);
            last = turn.turn[PAIR_STATIONS - 1];
            for (int i = 0; i < PAIR_STATIONS; i++) {
                decay[PAIR_STATIONS * pair + i] = exp(-mu * upto[i]);
            }
        }
    }
}

// --- elongation

// arclength of the tendon at rest that belongs to a station
static double rest_weight(const equilibrium *e, const plan_tendon *t, int station)
{
    const plan *p = e->plan;
    const vec6 rest = station_gather(p->rest, p->nstation, station);
    return gauss_weight[station % GAUSS_STATIONS] * panel_length(p, station / GAUSS_STATIONS) *
           vec3_norm(tendon_direction(&t->place[station], &rest));
}

double friction_stretched_length(const equilibrium *e, int tendon)
{
    if (!e->friction || !(e->rod->spec[tendon].friction > 0)) {
        return e->rest_length[tendon];
    }
    const plan_tendon *t = &e->plan->tendon[tendon];
    const double *decay = decay_of(e, tendon);
    double sum = 0;
    for (int i = 0; i < t->nstation; i++) {
        sum += decay[i] * rest_weight(e, t, i);
    }
    return sum;
}

// --- how tensions follow the strains

bool friction_follows(const equilibrium *e)
{
    for (int j = 0; e->friction && j < e->rod->ntendon; j++) {
        if (e->rod->spec[j].friction > 0 && e->tension[j] > 0) {
            return true;
        }
    }
    return false;
}

static void add_tension_change(equilibrium *e, int tendon, int station, double change)
{
    const vec6 f = vec6_scale(change, balance_tendon(e, tendon, station));
    const mat3 *R = &e->state[station].R;
    vec3 *rv = &e->rv[station], *rw = &e->rw[station];
    *rv = vec3_add(*rv, mat3_mul_vec(*R, vec6_linear(f)));
    *rw = vec3_add(*rw, mat3_mul_vec(*R, vec6_angular(f)));
}

void friction_misfits(equilibrium *e, const vec6 *step, double *change)
{
    const pair_matrix D = pair_slopes();
    for (int j = 0; j < e->rod->ntendon; j++) {
        const plan_tendon *t = &e->plan->tendon[j];
        const tendon_spec *spec = &e->rod->spec[j];
        const double *decay = decay_of(e, j), lost = -spec->friction * e->tension[j];
        double angle = 0, stretched = 0;
        for (int pair = 0; lost < 0 && PAIR_STATIONS * pair < t->nstation; pair++) {
            double upto[PAIR_STATIONS];
            const path_turn_rate turn = turn_rate(e, t, pair, &D, step);
            angle = integrate_pair(panel_length(e->plan, 2 * pair), turn.change, angle, upto);
            for (int i = 0; i < PAIR_STATIONS; i++) {
                const int station = PAIR_STATIONS * pair + i;
                const double tau = lost * decay[station] * upto[i];
                add_tension_change(e, j, station, tau);
                stretched += spec->EA > 0 ? tau * rest_weight(e, t, station) : 0;
            }
        }
        change[j] += spec->EA > 0 ? stretched / spec->EA : 0;
    }
}
