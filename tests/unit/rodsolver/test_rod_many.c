// tests/unit/rodsolver/test_rod_many.c
// Many tendons, and many rows of tensions.
#include "tests/unit/rodsolver/prototypes.h"

#include <string.h>

enum { MOST = 200 };

static double turn(const void *expression, double s)
{
    return *(const double *)expression + 40 * s;
}

// n tendons side by side, each with its share of the tension, are one tendon
static void equal_tendons_are_one(int n, int frame)
{
    const prototype p = helical_nc();
    const double start[2] = {0.3, 2.5};
    law_along law = {0};
    prototype_law(&p, &law);
    static tendon_spec t[MOST + 1];
    double tau[MOST + 1], length[MOST + 1], wanted_length[2];
    for (int i = 0; i <= n; i++) {
        t[i] = straight_tendon("one of many", 3.6e-3, 0);
        t[i].angle = (field){.at = turn, .expression = &start[i == n]};
        t[i].end = i == n ? 0.08 : 0;
        tau[i] = i == n ? 0.4 : 0.9 / n;
    }
    const tendon_spec two[2] = {t[0], t[n]};
    const double two_tau[2] = {0.9, 0.4};
    const rod_options options = {.frame = frame, .npanel = 24};
    rod_solution out = {.tendon_length = length}, wanted = {.tendon_length = wanted_length};
    const made_rod m = solved_rod(&law, n + 1, t, options, tau, &out);
    const made_rod w = solved_rod(&law, 2, two, options, two_tau, &wanted);
    CHECK_WITHIN(distance(out.tip.p, wanted.tip.p), 0, 1e-14);
    CHECK_WITHIN(rotation_difference(out.tip.R, wanted.tip.R), 0, 1e-13);
    CHECK_NEAR(out.energy, wanted.energy, 1e-12);
    CHECK(out.residual < 1e-12 && wanted.residual < 1e-12);
    CHECK_NEAR(length[n / 2], wanted_length[0], 1e-13);
    CHECK_NEAR(length[n], wanted_length[1], 1e-13);
    vec6 xi, wanted_xi;
    CHECK_OK(rod_strain_at(m.state, 0.05, &xi));
    CHECK_OK(rod_strain_at(w.state, 0.05, &wanted_xi));
    for (int c = 0; c < 6; c++) {
        CHECK_WITHIN(xi.a[c], wanted_xi.a[c], 1e-12 * (c < 3 ? 1 : 300));
    }
    free_rod(m);
    free_rod(w);
    law_along_free(&law);
}

// a ring of equal tendons only compresses a tube: eps = -sum tau / EA
static void symmetric_ring_compresses(int n)
{
    const prototype p = homogeneous_tube();
    const prototype_section q = prototype_integrals(&p, 0);
    law_along law = {0};
    prototype_law(&p, &law);
    static tendon_spec t[MOST];
    double tau[MOST], length[MOST];
    for (int i = 0; i < n; i++) {
        t[i] = straight_tendon("of a ring", 3.6e-3, 0.1 + 2 * PROTOTYPE_PI * i / n);
        tau[i] = 2.0 / n;
    }
    rod_solution out = {.tendon_length = length};
    const made_rod m = solved_rod(&law, n, t, (rod_options){.tolerance = 1e-9}, tau, &out);
    CHECK_WITHIN(distance(out.tip.p, (vec3){{0, 0, p.length * (1 - 2.0 / q.EA)}}), 0, 1e-14);
    CHECK_WITHIN(rotation_difference(out.tip.R, mat3_identity()), 0, 1e-12);
    CHECK_NEAR(length[n - 1], p.length * (1 - 2.0 / q.EA), 1e-13);
    CHECK_NEAR(out.energy, 2.0 * 2.0 / q.EA * p.length / 2, 1e-13);
    free_rod(m);
    law_along_free(&law);
}

// the energy of the strains under one straight tendon: tau^2 / 2 (1/EA + r^2/EI) L
static void energy_has_its_closed_form(void)
{
    const prototype p = homogeneous_tube();
    const prototype_section q = prototype_integrals(&p, 0);
    law_along law = {0};
    prototype_law(&p, &law);
    const tendon_spec t = straight_tendon("a", 3.6e-3, 0);
    const double tau = 0.8, r = 3.6e-3;
    const double wanted = tau * tau / 2 * (1 / q.EA + r * r / q.EIx) * p.length;
    for (int npanel = 0; npanel < 9; npanel += 8) {
        rod_solution out = {0};
        const made_rod m =
            solved_rod(&law, 1, &t, (rod_options){.tolerance = 1e-9, .npanel = npanel}, &tau, &out);
        CHECK_NEAR(out.energy, wanted, 1e-13);
        CHECK(out.residual < 1e-13);
        CHECK(out.fraction == 1 && out.stable == 1 && out.ncritical == 0);
        free_rod(m);
    }
    law_along_free(&law);
}

// everything is carried along by the base
static void base_carries_the_rod(void)
{
    enum { POINTS = 5 };
    const prototype p = helical_nc();
    law_along law = {0};
    prototype_law(&p, &law);
    const tendon_spec t[2] = {straight_tendon("a", 3.6e-3, 0), straight_tendon("b", 3.6e-3, 2)};
    const double tau[2] = {0.9, 0.3};
    const pose base = {so3_exp((vec3){{0.3, -2, 1}}), {{0.1, -0.2, 0.5}}};
    rod_solution out = {0}, moved = {0};
    double s[POINTS];
    pose shape[POINTS], carried[POINTS];
    const made_rod m = solved_rod(&law, 2, t, (rod_options){.tolerance = 1e-9}, tau, &out);
    CHECK_OK(rod_shape(m.state, POINTS, s, shape));
    CHECK_OK(
        rod_solve(m.state, &(rod_request){.tension = tau, .base = &base, .cold = true}, &moved));
    CHECK_OK(rod_shape(m.state, POINTS, s, carried));
    CHECK_WITHIN(distance(pose_mul(base, out.tip).p, moved.tip.p), 0, 1e-15);
    for (int i = 0; i < POINTS; i++) {
        const pose wanted = pose_mul(base, shape[i]);
        CHECK_WITHIN(distance(wanted.p, carried[i].p), 0, 1e-15);
        CHECK_WITHIN(rotation_difference(wanted.R, carried[i].R), 0, 1e-15);
    }
    free_rod(m);
    law_along_free(&law);
}

// from the last answer: the same strains to rounding
static void warm_is_as_good_as_cold(void)
{
    const prototype p = helical_nc();
    const double start[3] = {0, 2, 4};
    law_along law = {0};
    prototype_law(&p, &law);
    tendon_spec t[3];
    for (int i = 0; i < 3; i++) {
        t[i] = straight_tendon("a", 3.6e-3, 0);
        t[i].angle = (field){.at = turn, .expression = &start[i]};
    }
    const made_rod m = make_rod(&law, 3, t, (rod_options){.tolerance = 1e-9});
    for (int k = 0; k < 20; k++) {
        const double tau[3] = {0.5 + 0.02 * k, 0.9 - 0.04 * k, 0.1 * (k % 4)};
        rod_solution warm = {0}, cold = {0};
        CHECK_OK(rod_solve(m.state, &(rod_request){.tension = tau}, &warm));
        CHECK_OK(solve_tensions(m.state, tau, &cold));
        CHECK_WITHIN(distance(warm.tip.p, cold.tip.p), 0, 1e-15);
    }
    free_rod(m);
    law_along_free(&law);
}

enum { ROWS = 97, COLUMNS = 3 };

static void check_batch(const made_rod *m, const double *tension, int nthread)
{
    static pose tip[ROWS];
    static status outcome[ROWS];
    int failed = 0, wanted_failed = 0;
    CHECK_OK(rod_batch(m->rod, nthread, ROWS, tension, NULL, tip, outcome, &failed));
    for (int i = 0; i < ROWS; i++) {
        rod_solution out = {0};
        const status st = solve_tensions(m->state, tension + (size_t)(COLUMNS * i), &out);
        status_clear();
        CHECK(outcome[i] == st);
        CHECK(st != OK || memcmp(&out.tip, &tip[i], sizeof out.tip) == 0);
        CHECK(st == OK || isnan(tip[i].p.a[0]));
        wanted_failed += st != OK;
    }
    CHECK(failed == wanted_failed && failed > 0 && failed < ROWS / 2);
}

// row by row the bits of rod_solve, whatever the number of threads; also where a row is refused
static void batches_are_single_solves(int frame)
{
    const prototype p = helical_nc();
    const double start = 1;
    law_along law = {0};
    prototype_law(&p, &law);
    tendon_spec t[COLUMNS] = {straight_tendon("a", 3.6e-3, 0), straight_tendon("b", 3.6e-3, 2),
                              straight_tendon("c", 3.6e-3, 0)};
    t[1].end = 0.07;
    t[2].angle = (field){.at = turn, .expression = &start};
    double tension[ROWS * COLUMNS];
    for (int i = 0; i < ROWS * COLUMNS; i++) {
        tension[i] = i % 7 == 0 ? 0 : 0.017 * (i % 61);
    }
    tension[COLUMNS * 11] = 1e3;
    tension[COLUMNS * 40 + 1] = -1;
    const made_rod m = make_rod(&law, COLUMNS, t, (rod_options){.frame = frame, .tolerance = 1e-7});
    const int nthread[4] = {1, 2, 5, 0};
    for (int k = 0; k < 4; k++) {
        check_batch(&m, tension, nthread[k]);
    }
    int failed = -1;
    CHECK_OK(rod_batch(m.rod, 0, 0, NULL, NULL, NULL, NULL, &failed));
    CHECK(failed == 0);
    free_rod(m);
    law_along_free(&law);
}

int main(void)
{
    const int count[5] = {1, 2, 3, 30, 200};
    for (int i = 0; i < 5; i++) {
        equal_tendons_are_one(count[i], i % 2 ? FRAME_NC : FRAME_GC);
        symmetric_ring_compresses(count[i] + 2 < MOST ? count[i] + 2 : MOST);
    }
    energy_has_its_closed_form();
    base_carries_the_rod();
    warm_is_as_good_as_cold();
    batches_are_single_solves(FRAME_GC);
    batches_are_single_solves(FRAME_NC);
    return test_failures != 0;
}
