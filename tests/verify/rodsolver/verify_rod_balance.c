// tests/verify/rodsolver/verify_rod_balance.c
// Pulled lengths, slack, elastic tendons and friction on straight and curved uniform rods, where
// the curvature is constant or follows from one integral; and the balance of energies.
#include "tests/verify/rodsolver/loaded_rods.h"

#include <complex.h>

static const double LENGTH = 0.12, EA = 12, EI = 8e-5, RADIUS = 3.6e-3; // [m, N, N m^2, m]
static const rod_options options = {.tolerance = 1e-12};
// the table's row
static const double AGREE = 1e-9;

enum { MAX = 3 };

static law_along soft_law(void)
{
    return uniform_law(LENGTH, diagonal_K(4, 4, EA, EI, EI, 6e-5));
}

// straight tendons at equal angles round the axis, the first at x > 0; two of them are antagonists
static void ring_of_tendons(int n, tendon_spec *t)
{
    for (int i = 0; i < n; i++) {
        t[i] = (tendon_spec){.radius = field_constant(RADIUS),
                             .angle = field_constant(2 * LOADED_PI * i / n)};
    }
}

// what is drawn out of tendon i by 1 N on tendon j: L (1/EA + r_i . r_j / EI), and its own stretch
static double drawn_by(const tendon_spec *t, int i, int j)
{
    const double r = RADIUS * RADIUS * cos(t[i].angle.value - t[j].angle.value);
    const double own = i == j && t[i].EA > 0 ? (LENGTH + t[i].outside) / t[i].EA : 0;
    return LENGTH * (1 / EA + r / EI) + own;
}

// tensions that are wanted, given as the lengths that they draw; NAN in `given`: pulled
static void pull_finds_tensions(const char *what, int n, const tendon_spec *t, const double *wanted,
                                const double *slack, const double *given)
{
    about("%s", what);
    double pull[MAX] = {0};
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            pull[i] += drawn_by(t, i, j) * wanted[j];
        }
        pull[i] -= slack[i];
        pull[i] = given && !isnan(given[i]) ? NAN : pull[i];
    }
    law_along law = soft_law();
    solved s;
    solve_well(&s, &(rod_spec){.law = &law, .ntendon = n, .tendons = t}, options,
               &(rod_request){.tension = given, .pull = pull, .cold = true, .stability = true});
    double worst = 0;
    for (int i = 0; i < n; i++) {
        worst = fmax(worst, fabs(s.tension[i] - wanted[i]));
        if (wanted[i] == 0) {
            CHECK_WITHIN(s.tension[i], 0, 0); // slack is exactly slack
        }
        const double own = t[i].EA > 0 ? wanted[i] * (LENGTH + t[i].outside) / t[i].EA : 0;
        if (!isnan(pull[i]) && wanted[i] > 0) {
            CHECK_NEAR(s.length[i], LENGTH - (pull[i] - own), 1e-12);
        }
    }
    printf("%-44s tensions to %9.2e N, stable %d\n", what, worst, s.out.stable);
    CHECK_WITHIN(worst, 0, AGREE);
    CHECK(s.out.stable == 1);
    solved_free(&s);
    law_along_free(&law);
}

static void pulled_lengths_make_tensions(void)
{
    static const double none[MAX] = {0};
    tendon_spec t[MAX];
    ring_of_tendons(2, t);
    pull_finds_tensions("one pulled, none else", 1, t, (double[]){0.7}, none, NULL);
    pull_finds_tensions("antagonists, both tight", 2, t, (double[]){0.7, 0.2}, none, NULL);
    pull_finds_tensions("antagonists, one slack by 1 mm", 2, t, (double[]){0.7, 0},
                        (double[]){0, 1e-3}, NULL);
    pull_finds_tensions("antagonists, one slack by 1 nm", 2, t, (double[]){0.7, 0},
                        (double[]){0, 1e-9}, NULL);
    pull_finds_tensions("antagonists, one given, one pulled", 2, t, (double[]){0.4, 0.3}, none,
                        (double[]){0.4, NAN});
    pull_finds_tensions("antagonists, both slack", 2, t, none, (double[]){1e-3, 2e-3}, NULL);
    t[0].EA = 500;
    t[0].outside = 0.3;
    t[1].EA = 200;
    pull_finds_tensions("elastic antagonists", 2, t, (double[]){0.7, 0.2}, none, NULL);
    pull_finds_tensions("elastic antagonists, one slack", 2, t, (double[]){0.7, 0},
                        (double[]){0, 1e-4}, NULL);
    ring_of_tendons(3, t);
    pull_finds_tensions("three, all tight", 3, t, (double[]){0.5, 0.3, 0.1}, none, NULL);
    pull_finds_tensions("three, one slack", 3, t, (double[]){0.5, 0, 0.1}, (double[]){0, 1e-4, 0},
                        NULL);
    pull_finds_tensions("three, two given", 3, t, (double[]){0.5, 0.3, 0.1}, none,
                        (double[]){0.5, NAN, 0.1});
}

// --- friction: tau' = -mu tau |kappa|. On the straight rod kappa = tau r / EI, so with u = 1 + mu
// r tau0 s / EI tau = tau0 / u, theta = ln u / mu, and the shape is a power of u

static pose friction_tip(double mu, double tau0, double *tau, double *drawn)
{
    const double c = mu * RADIUS * tau0 / EI, u = 1 + c * LENGTH, theta = log(u) / mu;
    const double complex i = I / mu;
    const double complex end = cexp(I * theta); // u^(i / mu)
    const double complex p = ((u * end - 1) / (1 + i) - tau0 / EA * (end - 1) / i) / c;
    *tau = tau0 / u;
    *drawn = (1 / EA + RADIUS * RADIUS / EI) * tau0 / c * log(u);
    pose g = {.p = vector(cimag(p), 0, creal(p))};
    g.R = (mat3){{{cos(theta), 0, sin(theta)}, {0, 1, 0}, {-sin(theta), 0, cos(theta)}}};
    return g;
}

static void friction_takes_tension_away(double mu, double tau0, bool pulled, rod_options how)
{
    double tip_tension, drawn, tension = tau0;
    const pose wanted = friction_tip(mu, tau0, &tip_tension, &drawn);
    law_along law = soft_law();
    const tendon_spec t = {.radius = field_constant(RADIUS), .friction = mu};
    solved s;
    solve_well(&s, &(rod_spec){.law = &law, .ntendon = 1, .tendons = &t}, how,
               &(rod_request){.tension = pulled ? NULL : &tension,
                              .pull = pulled ? &drawn : NULL,
                              .cold = true});
    vec6 wrench;
    double end = 0, inside = 0, worst = 0;
    CHECK_OK(rod_wrench_at(s.state, LENGTH, &wrench, &end));
    for (int i = 0; i <= 20; i++) {
        const double at = i * LENGTH / 20;
        CHECK_OK(rod_wrench_at(s.state, at, &wrench, &inside));
        worst = fmax(worst, fabs(inside * (1 / tau0 + mu * RADIUS * at / EI) - 1));
        CHECK_NEAR(wrench.a[MY], inside * RADIUS, AGREE);
    }
    printf("friction %.2f, %.2f N %s: tip %.2e, tension at the tip %.2e, along it %.2e\n", mu, tau0,
           pulled ? "pulled" : "given ", gap(s.out.tip.p, wanted.p) / LENGTH, end / tip_tension - 1,
           worst);
    CHECK_WITHIN(gap(s.out.tip.p, wanted.p) / LENGTH, 0, AGREE);
    CHECK_WITHIN(turn_gap(s.out.tip.R, wanted.R), 0, AGREE);
    CHECK_NEAR(s.tension[0], tau0, AGREE);
    CHECK_NEAR(end, tip_tension, AGREE);
    // between the stations it is interpolated: as good as there are panels, which the tip alone
    // does not ask for
    if (how.npanel != 0) {
        CHECK_AT_MOST(worst, AGREE);
    }
    CHECK_NEAR(LENGTH - s.length[0], drawn, AGREE);
    CHECK(s.out.stable == -1); // no potential
    solved_free(&s);
    law_along_free(&law);
}

// Curved at rest by k: y = 1 / tau obeys y' = a y + b, a = mu |k|, b = mu r sign(k) / EI, as long
// as kappa keeps k's sign; without an arm this is the capstan's tau0 exp(-mu k s)
static void capstan_takes_its_share(double mu, double k, double radius, double tau0)
{
    const double a = mu * fabs(k), b = mu * radius * (k > 0 ? 1 : -1) / EI;
    const double wanted = 1 / ((1 / tau0 + b / a) * exp(a * LENGTH) - b / a);
    const double turned = (k > 0 ? 1 : -1) * log(tau0 / wanted) / mu;
    law_along law = soft_law();
    const tendon_spec t = {.radius = field_constant(radius), .friction = mu};
    const rest_shape rest = {.curvature_y = field_constant(k)};
    solved s;
    solve_well(&s, &(rod_spec){.law = &law, .rest = rest, .ntendon = 1, .tendons = &t}, options,
               &(rod_request){.tension = &tau0, .cold = true});
    vec6 wrench;
    double end = 0;
    CHECK_OK(rod_wrench_at(s.state, LENGTH, &wrench, &end));
    const double angle = atan2(s.out.tip.R.a[0][2], s.out.tip.R.a[0][0]);
    printf("capstan, friction %.2f over %6.2f rad, arm %g m: tension at the tip to %.2e, turn to "
           "%.2e\n",
           mu, turned, radius, end / wanted - 1, remainder(angle - turned, 2 * LOADED_PI));
    CHECK_NEAR(end, wanted, AGREE);
    CHECK_WITHIN(remainder(angle - turned, 2 * LOADED_PI), 0, AGREE);
    solved_free(&s);
    law_along_free(&law);
}

// --- energies

// stored: L / 2 tau^T (1/EA + r r / EI) tau
static void stored_energy_is_that_of_the_arc(void)
{
    tendon_spec t[MAX];
    ring_of_tendons(3, t);
    const double tau[] = {0.5, 0.2, 0.1};
    double wanted = 0;
    for (int i = 0; i < 9; i++) {
        wanted += drawn_by(t, i / 3, i % 3) * tau[i / 3] * tau[i % 3] / 2;
    }
    law_along law = soft_law();
    solved s;
    solve_well(&s, &(rod_spec){.law = &law, .ntendon = 3, .tendons = t}, options,
               &(rod_request){.tension = tau, .cold = true});
    printf("energy of an arc to %.2e, work to %.2e\n", s.out.energy / wanted - 1,
           s.out.work / wanted - 1);
    CHECK_NEAR(s.out.energy, wanted, AGREE);
    CHECK_NEAR(s.out.work, wanted, AGREE);
    solved_free(&s);
    law_along_free(&law);
}

// Dead loads and tendons at once: what they do on the way is what is stored. The same rod twice, so
// that a balance that always closes would show.
static void work_is_stored(void)
{
    tendon_spec t[MAX];
    ring_of_tendons(3, t);
    law_along law = soft_law();
    law.law[0].mass = 0.03;
    const double tau[] = {0.3, 0.1, 0.2};
    const rod_spec spec = {.law = &law, .ntendon = 3, .tendons = t, .gravity = {4, 0, -9}};
    solved s;
    double stored[2];
    for (int i = 0; i < 2; i++) {
        solve_well(&s, &spec, options,
                   &(rod_request){.tension = tau,
                                  .cold = true,
                                  .stability = true,
                                  .tip_space = {{0.01 * i, -0.02 * i, 0.005 * i}}});
        printf("energy %.9e J, work %.9e J, residual %.2e\n", s.out.energy, s.out.work,
               s.out.residual);
        CHECK_NEAR(s.out.work, s.out.energy, AGREE);
        CHECK_BELOW(s.out.residual, 1e-10);
        stored[i] = s.out.energy;
        solved_free(&s);
    }
    CHECK_ABOVE(fabs(stored[1] / stored[0] - 1), 0.02);
    law_along_free(&law);
}

// Under a load too a pulled tendon has the length that is left, and the tensions found give the
// same rod when they are asked for
static void pulled_under_load_is_the_same_rod(void)
{
    tendon_spec t[MAX];
    ring_of_tendons(3, t);
    law_along law = soft_law();
    const rod_spec spec = {.law = &law, .ntendon = 3, .tendons = t};
    const double pull[] = {4e-3, 1e-3, -5e-3};
    const vec6 force = {{0.005, 0.01, -0.01}};
    solved a, b;
    solve_well(&a, &spec, options, &(rod_request){.pull = pull, .tip_space = force, .cold = true});
    solve_well(&b, &spec, options,
               &(rod_request){.tension = a.tension, .tip_space = force, .cold = true});
    printf("pulled and loaded: %.6f %.6f %.6f N, tips differ by %.2e\n", a.tension[0], a.tension[1],
           a.tension[2], gap(a.out.tip.p, b.out.tip.p) / LENGTH);
    for (int i = 0; i < 3; i++) {
        CHECK_AT_LEAST(a.tension[i], 0);
        if (a.tension[i] > 0) {
            CHECK_NEAR(a.length[i], LENGTH - pull[i], 1e-11);
        } else {
            CHECK_AT_MOST(a.length[i], LENGTH - pull[i]);
        }
    }
    CHECK_ABOVE(a.tension[0], 0.01); // it does pull
    CHECK_WITHIN(gap(a.out.tip.p, b.out.tip.p) / LENGTH, 0, AGREE);
    solved_free(&a);
    solved_free(&b);
    law_along_free(&law);
}

// --- the wrench along the rod against statics: R^T (F, M + (p_L - p) x F), less what the tendon
// carries

static void wrenches_are_those_of_statics(double tau)
{
    enum { POINTS = 25 };
    law_along law = soft_law();
    const tendon_spec t = {.radius = field_constant(RADIUS), .angle = field_constant(1)};
    const rest_shape rest = {.curvature_x = field_constant(6), .twist = field_constant(9)};
    const vec3 F = vector(0.01, 0.02, -0.01), M = vector(3e-4, 0, -2e-4);
    solved s;
    // the strain is interpolated between stations, and beyond them at both ends: more panels than
    // the tip needs
    solve_well(&s, &(rod_spec){.law = &law, .rest = rest, .ntendon = 1, .tendons = &t},
               (rod_options){.npanel = 128},
               &(rod_request){.tension = &tau, .tip_space = wrench_of(F, M), .cold = true});
    double at[POINTS], worst = 0;
    pose g[POINTS];
    CHECK_OK(rod_shape(s.state, POINTS, at, g));
    for (int i = 0; i < POINTS; i++) {
        vec6 xi, own;
        CHECK_OK(rod_strain_at(s.state, at[i], &xi));
        CHECK_OK(rod_wrench_at(s.state, at[i], &own, NULL));
        const vec3 moment = vec3_add(M, vec3_cross(vec3_sub(s.out.tip.p, g[i].p), F));
        const vec3 r = vector(RADIUS * cos(1), RADIUS * sin(1), 0);
        const vec3 d = vec3_add(vector(xi.a[0], xi.a[1], xi.a[2]),
                                vec3_cross(vector(xi.a[3], xi.a[4], xi.a[5]), r));
        const vec3 pull = vec3_scale(tau / vec3_norm(d), d);
        const vec6 all = vec6_add(own, wrench_of(pull, vec3_cross(r, pull)));
        const vec6 wanted = wrench_of(mat3_tmul_vec(g[i].R, F), mat3_tmul_vec(g[i].R, moment));
        for (int c = 0; c < 6; c++) {
            const double scale = c < 3 ? vec3_norm(F) : vec3_norm(F) * LENGTH;
            worst = fmax(worst, fabs(all.a[c] - wanted.a[c]) / scale);
        }
    }
    printf("wrenches along the rod, %.1f N on the tendon: to %.2e\n", tau, worst);
    CHECK_WITHIN(worst, 0, AGREE);
    solved_free(&s);
    law_along_free(&law);
}

int main(void)
{
    against(BY_CLOSED_FORM, "uniform rods of constant curvature, the capstan, statics, energies");
    wrenches_are_those_of_statics(0);
    wrenches_are_those_of_statics(0.4);
    pulled_lengths_make_tensions();
    for (int pulled = 0; pulled < 2; pulled++) {
        friction_takes_tension_away(0.1, 0.7, pulled, options);
        friction_takes_tension_away(0.5, 0.3, pulled, options);
        friction_takes_tension_away(1.2, 2.0, pulled, options);
        friction_takes_tension_away(0.5, 0.3, pulled, (rod_options){.npanel = 64});
    }
    capstan_takes_its_share(0.3, 20, 0, 0.5);
    capstan_takes_its_share(0.3, 20, RADIUS, 0.5);
    capstan_takes_its_share(0.5, -60, RADIUS, 0.5);
    capstan_takes_its_share(0.2, -60, 0, 2);
    stored_energy_is_that_of_the_arc();
    work_is_stored();
    pulled_under_load_is_the_same_rod();
    return test_failures != 0;
}
