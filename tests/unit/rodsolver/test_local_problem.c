// tests/unit/rodsolver/test_local_problem.c
#include "rodsolver/local_problem.h"
#include "tests/unit/rodsolver/prototypes.h"

#include <string.h>

enum { MOST_TENDONS = 200 };

static double uniform(unsigned *state)
{
    // a linear congruence: the same numbers on every machine
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) / 16777216.0;
}

// stiffness of a stiff-sector section about an arbitrary axis, and tendons anywhere in the wall
static void random_problem(unsigned *state, int ntendon, mat6 *K, local_problem *p)
{
    static local_tendon tendon[MOST_TENDONS];
    const prototype tube = constant_nc();
    *K = beam_law_move(prototype_stiffness(&tube, 0.2 + uniform(state)), 0, 0, 7 * uniform(state));
    *p =
        (local_problem){.K = K, .rest = {{0, 0, 1, 0, 0, 0}}, .ntendon = ntendon, .tendon = tendon};
    for (int i = 0; i < ntendon; i++) {
        const double angle = 7 * uniform(state);
        tendon[i] =
            (local_tendon){.place = {3.6e-3 * cos(angle), 3.6e-3 * sin(angle),
                                     0.4 * (uniform(state) - 0.5), 0.4 * (uniform(state) - 0.5)}};
        tendon[i].tension = uniform(state);
    }
}

static void prepare(const mat6 *K, const vec6 *rest, const tendon_place *place, secular_station *s)
{
    mat6 F;
    CHECK(mat6_inverse_spd(*K, &F));
    secular_prepare(&F, rest, place, s);
}

// the balance K (xi - xi*) + sum tau (t, r x t) = 0, written out by vector products; relative to
// the tensions
static double imbalance(const local_problem *p, vec6 xi)
{
    vec6 sum = mat6_mul_vec(*p->K, vec6_sub(xi, p->rest));
    double scale = 0;
    const vec3 v = {{xi.a[0], xi.a[1], xi.a[2]}}, w = {{xi.a[3], xi.a[4], xi.a[5]}};
    for (int i = 0; i < p->ntendon; i++) {
        const tendon_place *q = &p->tendon[i].place;
        const vec3 r = {{q->x, q->y, 0}}, slope = {{q->dx, q->dy, 0}};
        const vec3 d = vec3_add(vec3_add(v, vec3_cross(w, r)), slope);
        const vec3 force = vec3_scale(p->tendon[i].tension / vec3_norm(d), d);
        const vec3 moment = vec3_cross(r, force);
        for (int c = 0; c < 3; c++) {
            sum.a[c] += force.a[c];
            sum.a[c + 3] += moment.a[c];
        }
        scale += p->tendon[i].tension;
    }
    double worst = 0;
    for (int c = 0; c < 6; c++) {
        worst = fmax(worst, fabs(sum.a[c]) / (scale * (c < 3 ? 1 : 4e-3)));
    }
    return worst;
}

static void newton_balances_the_wrenches(void)
{
    unsigned state = 7;
    for (int k = 0; k < 300; k++) {
        mat6 K;
        local_problem p;
        random_problem(&state, 1 + k % 4, &K, &p);
        vec6 xi = p.rest;
        int steps = 0, which = 0;
        CHECK(local_solve(&p, &xi, &steps, &which) == LOCAL_SOLVED);
        CHECK(imbalance(&p, xi) < 1e-12);
        CHECK(imbalance(&p, p.rest) > 1e-3); // the test can tell
        CHECK(steps < 20);
    }
}

// convex: from wherever it starts, the same strain
static void newton_finds_the_same_minimum_from_anywhere(void)
{
    unsigned state = 11;
    for (int k = 0; k < 100; k++) {
        mat6 K;
        local_problem p;
        random_problem(&state, 3, &K, &p);
        vec6 wanted = p.rest;
        int steps = 0, which = 0;
        CHECK(local_solve(&p, &wanted, &steps, &which) == LOCAL_SOLVED);
        vec6 xi = p.rest;
        for (int c = 0; c < 6; c++) {
            xi.a[c] += (uniform(&state) - 0.5) * (c < 3 ? 1.5 : 300);
        }
        CHECK(local_solve(&p, &xi, &steps, &which) == LOCAL_SOLVED);
        for (int c = 0; c < 6; c++) {
            CHECK_WITHIN(xi.a[c], wanted.a[c], 1e-11 * (c < 3 ? 1 : 300));
        }
    }
}

// two ways to the same strain: the secular equation in M's axes and Newton in six unknowns
static void secular_equation_agrees_with_newton(void)
{
    unsigned state = 3;
    for (int k = 0; k < 200; k++) {
        mat6 K;
        local_problem p;
        secular_station s;
        random_problem(&state, 1, &K, &p);
        prepare(&K, &p.rest, &p.tendon[0].place, &s);
        // up to 99 % of what this tendon can pull
        const double tau = p.tendon[0].tension = 0.99 * uniform(&state) * secular_critical(&s);
        lanes m[3], b[3], y[3];
        for (int j = 0; j < 3; j++) {
            for (int i = 0; i < LANES; i++) {
                m[j][i] = s.m[j];
                b[j][i] = s.b[j];
            }
        }
        CHECK(secular_solve(tau, LANES, m, b, y) > 0);
        CHECK_NEAR(hypot(hypot(y[0][5], y[1][5]), y[2][5]), 1, 1e-14);
        vec6 xi = p.rest, newton = p.rest;
        for (int c = 0; c < 6; c++) {
            for (int j = 0; j < 3; j++) {
                xi.a[c] -= tau * s.G[c][j] * y[j][0];
            }
        }
        CHECK(imbalance(&p, xi) < 1e-12);
        int steps = 0, which = 0;
        CHECK(local_solve(&p, &newton, &steps, &which) == LOCAL_SOLVED);
        for (int c = 0; c < 6; c++) {
            CHECK_WITHIN(newton.a[c], xi.a[c], 1e-11 * (c < 3 ? 1 : 300));
        }
    }
}

// one straight tendon on a homogeneous section: tau = 1 / (1/EA + r^2/EI)
static void critical_tension_has_its_closed_form(void)
{
    const prototype tube = homogeneous_tube();
    const prototype_section q = prototype_integrals(&tube, 0);
    const mat6 K = prototype_stiffness(&tube, 0);
    const vec6 rest = {{0, 0, 1, 0, 0, 0}};
    const tendon_place place = {3.6e-3, 0, 0, 0};
    secular_station s;
    prepare(&K, &rest, &place, &s);
    const double wanted = 1 / (1 / q.EA + 3.6e-3 * 3.6e-3 / q.EIx);
    CHECK_NEAR(secular_critical(&s), wanted, 1e-13);
    CHECK_NEAR(wanted, 4.01, 1e-3);
}

// past the critical tension the minimum sits at the kink |d| = 0: Newton must say so and not find a
// root behind it
static void newton_sees_a_tendon_that_is_eaten(void)
{
    unsigned state = 5;
    for (int k = 0; k < 100; k++) {
        mat6 K;
        local_problem p;
        secular_station s;
        random_problem(&state, 1, &K, &p);
        prepare(&K, &p.rest, &p.tendon[0].place, &s);
        int steps = 0, which = -1;
        vec6 xi = p.rest;
        p.tendon[0].tension = secular_critical(&s) * (1.01 + uniform(&state));
        CHECK(local_solve(&p, &xi, &steps, &which) == LOCAL_EATEN);
        CHECK(which == 0);
    }
}

// just below the critical tension a tendon is short, and its strain a minimum like any other
static void newton_solves_tendons_that_are_nearly_eaten(void)
{
    const double share[3] = {1e-2, 1e-3, 1e-4};
    unsigned state = 17;
    for (int k = 0; k < 90; k++) {
        mat6 K;
        local_problem p;
        secular_station s;
        random_problem(&state, 1, &K, &p);
        prepare(&K, &p.rest, &p.tendon[0].place, &s);
        const double critical = secular_critical(&s);
        int steps = 0, which = -1;
        vec6 xi = p.rest;
        p.tendon[0].tension = critical * (1 - share[k % 3]);
        CHECK(local_solve(&p, &xi, &steps, &which) == LOCAL_SOLVED);
        CHECK(imbalance(&p, xi) < 1e-9);
        const double left = vec3_norm(tendon_direction(&p.tendon[0].place, &xi));
        CHECK(left > 1e-6 && left < 10 * share[k % 3]);
    }
}

// --- eight stations at once

typedef struct eight {
    mat6 K[LANES];
    local_problem one[LANES];
    local_tendon tendon[LANES][MOST_TENDONS];
    double K_row[21 * LANES], rest[6 * LANES], place[MOST_TENDONS][4 * LANES];
    lane_tendon lane[MOST_TENDONS];
} eight;

// eight random stations of one rod: the same tensions everywhere
static lane_problem random_eight(unsigned *state, int ntendon, double scale, eight *e)
{
    for (int k = 0; k < LANES; k++) {
        random_problem(state, ntendon, &e->K[k], &e->one[k]);
        memcpy(e->tendon[k], e->one[k].tendon, (size_t)ntendon * sizeof *e->tendon[k]);
        e->one[k].tendon = e->tendon[k];
        for (int i = 0, entry = 0; i < 6; i++) {
            e->rest[LANES * i + k] = e->one[k].rest.a[i];
            for (int j = 0; j <= i; j++) {
                e->K_row[LANES * entry++ + k] = e->K[k].a[i][j];
            }
        }
        for (int i = 0; i < ntendon; i++) {
            local_tendon *t = &e->tendon[k][i];
            t->tension = scale * e->tendon[0][i].tension / (k == 0 ? 1 : scale);
            const double place[4] = {t->place.x, t->place.y, t->place.dx, t->place.dy};
            for (int j = 0; j < 4; j++) {
                e->place[i][LANES * j + k] = place[j];
            }
            e->lane[i] = (lane_tendon){e->place[i], LANES, t->tension};
        }
    }
    return (lane_problem){.K = e->K_row,
                          .rest = e->rest,
                          .stride = LANES,
                          .count = LANES,
                          .ntendon = ntendon,
                          .tendon = e->lane};
}

static vec6 lane_of(const lanes xi[6], int k)
{
    vec6 one;
    for (int c = 0; c < 6; c++) {
        one.a[c] = xi[c][k];
    }
    return one;
}

static void lanes_balance_the_wrenches(void)
{
    static eight e;
    const int count[6] = {2, 3, 4, 7, 20, 200};
    unsigned state = 23;
    for (int n = 0; n < 60; n++) {
        const int ntendon = count[n % 6];
        const lane_problem p = random_eight(&state, ntendon, 1.5 / ntendon, &e);
        lanes xi[6], energy, misfit;
        unsigned unsolved = 0;
        for (int c = 0; c < 6; c++) {
            memcpy(&xi[c], e.rest + LANES * c, sizeof xi[c]);
        }
        local_check_lanes(&p, xi, &energy, &misfit);
        for (int k = 0; k < LANES; k++) {
            CHECK(energy[k] == 0 && misfit[k] > 1e-8); // at rest nothing is balanced
        }
        CHECK(local_solve_lanes(&p, xi, &unsolved) <= 9);
        CHECK(unsolved == 0);
        local_check_lanes(&p, xi, &energy, &misfit);
        for (int k = 0; k < LANES; k++) {
            const vec6 found = lane_of(xi, k);
            vec6 wanted = e.one[k].rest;
            int steps = 0, which = 0;
            CHECK(imbalance(&e.one[k], found) < 1e-12);
            CHECK(local_solve(&e.one[k], &wanted, &steps, &which) == LOCAL_SOLVED);
            for (int c = 0; c < 6; c++) {
                CHECK_WITHIN(found.a[c], wanted.a[c], 1e-11 * (c < 3 ? 1 : 300));
            }
            const vec6 strain = vec6_sub(found, e.one[k].rest);
            CHECK_NEAR(energy[k], vec6_dot(strain, mat6_mul_vec(e.K[k], strain)), 1e-12);
            CHECK(misfit[k] <= 1e-26 * energy[k]);
        }
    }
}

// a station where a tendon is eaten is left to local_solve, and does not disturb the others
static void lanes_leave_hard_stations_alone(void)
{
    static eight e;
    unsigned state = 29, unsolved = 0;
    lane_problem p = random_eight(&state, 2, 0.5, &e);
    for (int i = 0; i < 21; i++) {
        e.K_row[LANES * i + 3] *= 0.03; // far too soft for these tensions
    }
    lanes xi[6];
    for (int c = 0; c < 6; c++) {
        memcpy(&xi[c], e.rest + LANES * c, sizeof xi[c]);
    }
    (void)local_solve_lanes(&p, xi, &unsolved);
    CHECK(unsolved == 1u << 3);
    for (int k = 0; k < LANES; k++) {
        CHECK(k == 3 || imbalance(&e.one[k], lane_of(xi, k)) < 1e-12);
    }
    // idle lanes are not waited for
    p.count = 3;
    for (int c = 0; c < 6; c++) {
        memcpy(&xi[c], e.rest + LANES * c, sizeof xi[c]);
    }
    CHECK(local_solve_lanes(&p, xi, &unsolved) <= 9);
    CHECK(unsolved == 0);
}

int main(void)
{
    lanes_balance_the_wrenches();
    lanes_leave_hard_stations_alone();
    newton_balances_the_wrenches();
    newton_finds_the_same_minimum_from_anywhere();
    secular_equation_agrees_with_newton();
    critical_tension_has_its_closed_form();
    newton_solves_tendons_that_are_nearly_eaten();
    newton_sees_a_tendon_that_is_eaten();
    return test_failures != 0;
}
