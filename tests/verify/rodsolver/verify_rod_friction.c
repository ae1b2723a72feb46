// tests/verify/rodsolver/verify_rod_friction.c
// Friction along tendons that pull: weak to very strong against a closed form, the capstan's law on
// a loaded rod of any shape, derivatives, the steps of Newton's method and the order of the error.
#include "tests/verify/rodsolver/loaded_rods.h"

#include <complex.h>
#include <time.h>

static const double LENGTH = 0.12, EA = 12, EI = 8e-5, RADIUS = 3.6e-3; // [m, N, N m^2, m]
// the row "pulled length, slack, friction" of what the rod must meet
static const double AGREE = 1e-9;

static law_along soft_law(void)
{
    return uniform_law(LENGTH, diagonal_K(4, 4, EA, EI, EI, 6e-5));
}

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

// --- a straight rod, one tendon: kappa = tau r / EI, so that with c = mu r tau0 L / EI and u = 1 +
// c s / L the tension is tau0 / u, the turn ln u / mu and the shape a power of u

typedef struct closed_form {
    double mu, tau0, strength; // strength: c
    double angle, tip_tension;
    double drawn, stretched; // out of the body; by the tendon's own stretch
    vec3 tip;
} closed_form;

static closed_form rubbed_arc(double strength, double tau0, const tendon_spec *t)
{
    const double c = strength, u = 1 + c, mu = c * EI / (RADIUS * tau0 * LENGTH);
    const double mean = log(u) / c; // of tau / tau0 over the length
    closed_form f = {.mu = mu, .tau0 = tau0, .strength = c, .angle = log(u) / mu};
    const double complex i = I / mu, end = cexp(I * f.angle);
    const double complex p = LENGTH / c * ((u * end - 1) / (1 + i) - tau0 / EA * (end - 1) / i);
    f.tip = vector(cimag(p), 0, creal(p));
    f.tip_tension = tau0 / u;
    f.drawn = (1 / EA + RADIUS * RADIUS / EI) * tau0 * mean * LENGTH;
    f.stretched = t->EA > 0 ? tau0 / t->EA * (t->outside + mean * LENGTH) : 0;
    return f;
}

static void rubbed_arc_is_found(double strength, bool pulled, bool elastic)
{
    // all points of the way, on all plans tried; a linear rate would take hundreds
    enum { MOST_GIVEN = 50, MOST_PULLED = 100, REPEATS = 3 };
    tendon_spec t = {.radius = field_constant(RADIUS)};
    if (elastic) {
        t.EA = 300;
        t.outside = 0.2;
    }
    const closed_form f = rubbed_arc(strength, 1, &t);
    t.friction = f.mu;
    const double tension = f.tau0, pull = f.drawn + f.stretched;
    const rod_request request = {
        .tension = pulled ? NULL : &tension, .pull = pulled ? &pull : NULL, .cold = true};
    law_along law = soft_law();
    solved s;
    solve_well(&s, &(rod_spec){.law = &law, .ntendon = 1, .tendons = &t},
               (rod_options){.tolerance = 1e-11}, &request);
    double best = HUGE_VAL;
    for (int k = 0; k < REPEATS; k++) {
        const double start = seconds();
        solved_again(&s, &request);
        best = fmin(best, seconds() - start);
    }
    vec6 wrench;
    double end = 0;
    CHECK_OK(rod_wrench_at(s.state, LENGTH, &wrench, &end));
    const double turned = atan2(s.out.tip.R.a[0][2], s.out.tip.R.a[0][0]);
    printf("mu r tau0 L / EI = %5.1f, %s%s: tip / L %8.1e, tension %8.1e, %3d steps, %6.2f ms\n",
           strength, pulled ? "pulled" : "given ", elastic ? ", elastic" : "",
           gap(s.out.tip.p, f.tip) / LENGTH, s.tension[0] - f.tau0, s.out.iterations, 1e3 * best);
    CHECK_WITHIN(gap(s.out.tip.p, f.tip) / LENGTH, 0, AGREE);
    CHECK_WITHIN(remainder(turned - f.angle, 2 * LOADED_PI), 0, AGREE);
    CHECK_NEAR(s.tension[0], f.tau0, AGREE);
    CHECK_NEAR(end, f.tip_tension, AGREE);
    CHECK_NEAR(LENGTH - s.length[0], f.drawn, AGREE);
    CHECK_AT_MOST(s.out.iterations, (pulled ? MOST_PULLED : MOST_GIVEN));
    solved_free(&s);
    law_along_free(&law);
}

// From an answer next to it few steps do, however strong the friction: Newton's rate is quadratic.
// Counted are those on half the panels too
static void next_answers_take_few_steps(double strength)
{
    enum { MOST = 5 };
    tendon_spec t = {.radius = field_constant(RADIUS)};
    t.friction = rubbed_arc(strength, 1, &t).mu;
    law_along law = soft_law();
    double tension = 1;
    solved s;
    solve_well(&s, &(rod_spec){.law = &law, .ntendon = 1, .tendons = &t},
               (rod_options){.npanel = 64}, &(rod_request){.tension = &tension, .cold = true});
    tension = 1.01;
    CHECK_OK(solved_again(&s, &(rod_request){.tension = &tension}));
    printf("mu r tau0 L / EI = %5.1f: %d steps to 1 %% more tension\n", strength, s.out.iterations);
    CHECK_AT_MOST(s.out.iterations, MOST);
    solved_free(&s);
    law_along_free(&law);
}

// --- the capstan's law: tau(s) = tau0 exp(-mu times the angle that the path has turned), from the
// answer's own poses and strains

static vec3 path_tangent(const rod_state *state, const pose *g, double s, vec3 r)
{
    vec6 xi;
    CHECK_OK(rod_strain_at(state, s, &xi));
    const vec3 v = vector(xi.a[0], xi.a[1], xi.a[2]), w = vector(xi.a[3], xi.a[4], xi.a[5]);
    const vec3 d = mat3_mul_vec(g->R, vec3_add(v, vec3_cross(w, r)));
    return vec3_scale(1 / vec3_norm(d), d);
}

// along chords: of second order in their length
static double turned_angle(const rod_state *state, int npoint, vec3 r)
{
    static double at[8001];
    static pose g[8001];
    CHECK_OK(rod_shape(state, npoint, at, g));
    vec3 before = path_tangent(state, &g[0], at[0], r);
    double sum = 0;
    for (int i = 1; i < npoint; i++) {
        const vec3 here = path_tangent(state, &g[i], at[i], r);
        sum += atan2(vec3_norm(vec3_cross(before, here)), vec3_dot(before, here));
        before = here;
    }
    return sum;
}

static void capstan_holds_on_a_loaded_helix(void)
{
    const double mu[2] = {0.4, 0.15}, tension[2] = {0.4, 0.2}, angle[2] = {1, 3.5};
    tendon_spec t[2];
    for (int j = 0; j < 2; j++) {
        t[j] = (tendon_spec){
            .radius = field_constant(RADIUS), .angle = field_constant(angle[j]), .friction = mu[j]};
    }
    const line_load line = {.force = {field_constant(0.1), field_constant(-0.1)}};
    const rest_shape rest = {.curvature_x = field_constant(14), .twist = field_constant(40)};
    law_along law = soft_law();
    const rod_spec spec = {.law = &law,
                           .rest = rest,
                           .ntendon = 2,
                           .tendons = t,
                           .nline_load = 1,
                           .line_loads = &line};
    solved s;
    solve_well(&s, &spec, (rod_options){.npanel = 128},
               &(rod_request){.tension = tension, .cold = true});
    double end[2] = {0};
    vec6 wrench;
    CHECK_OK(rod_wrench_at(s.state, LENGTH, &wrench, end));
    for (int j = 0; j < 2; j++) {
        const vec3 r = vector(RADIUS * cos(angle[j]), RADIUS * sin(angle[j]), 0);
        const double coarse = turned_angle(s.state, 4001, r);
        const double turned = (4 * turned_angle(s.state, 8001, r) - coarse) / 3;
        const double wanted = exp(-mu[j] * turned);
        printf("capstan, loaded helix, %.3f rad: %.9f of the tension left, off by %.1e\n", turned,
               end[j] / tension[j], end[j] / tension[j] - wanted);
        CHECK_ABOVE(turned, 0.8);
        CHECK_NEAR(end[j] / tension[j], wanted, 1e-7);
    }
    solved_free(&s);
    law_along_free(&law);
}

// --- derivatives against central differences, one tendon given and one pulled and elastic

typedef struct knob {
    double tension[2], pull[2];
    vec6 force;
} knob;

static status turn_knobs(solved *s, const knob *k)
{
    return solved_again(
        s, &(rod_request){
               .tension = k->tension, .pull = k->pull, .tip_space = k->force, .cold = true});
}

static void derivative_is_a_difference(solved *s, const knob *k, double *number, double step,
                                       const vec6 *column, const char *what)
{
    const double kept = *number;
    pose g[4];
    for (int i = 0; i < 4; i++) {
        *number = kept + step * (i < 2 ? 1 : 2) * (i % 2 ? -1 : 1);
        CHECK_OK(turn_knobs(s, k));
        g[i] = s->out.tip;
    }
    *number = kept;
    CHECK_OK(turn_knobs(s, k));
    const vec3 narrow = vec3_scale(0.5 / step, vec3_sub(g[0].p, g[1].p));
    const vec3 wide = vec3_scale(0.25 / step, vec3_sub(g[2].p, g[3].p));
    const vec3 rate = vec3_sub(vec3_scale(4.0 / 3, narrow), vec3_scale(1.0 / 3, wide));
    const vec3 told = mat3_mul_vec(s->out.tip.R, vector(column->a[0], column->a[1], column->a[2]));
    printf("derivative by %-12s %.9e, off by %.1e of it\n", what, vec3_norm(told),
           gap(told, rate) / vec3_norm(rate));
    CHECK_WITHIN(gap(told, rate) / vec3_norm(rate), 0, AGREE);
}

static void derivatives_follow_friction(void)
{
    tendon_spec t[2] = {{.radius = field_constant(RADIUS), .friction = 0.6},
                        {.radius = field_constant(RADIUS),
                         .angle = field_constant(2),
                         .friction = 0.3,
                         .EA = 100,
                         .outside = 0.1}};
    law_along law = soft_law();
    const rest_shape rest = {.curvature_x = field_constant(10), .twist = field_constant(20)};
    const rod_spec spec = {.law = &law, .rest = rest, .ntendon = 2, .tendons = t};
    knob k = {{0.9, 0}, {NAN, 6e-3}, {{0.02, 0.01, -0.01}}};
    solved s;
    solve_well(
        &s, &spec, (rod_options){.npanel = 128, .tolerance = 1e-12},
        &(rod_request){.tension = k.tension, .pull = k.pull, .tip_space = k.force, .cold = true});
    CHECK_ABOVE(s.tension[1], 0.05); // it does pull
    vec6 by_tension[2], by_pull[2], column;
    mat6 by_force;
    CHECK_OK(rod_derive(
        s.state, LENGTH,
        &(rod_derivatives){.tension = by_tension, .pull = by_pull, .tip_space = &by_force}));
    derivative_is_a_difference(&s, &k, &k.tension[0], 1e-3, &by_tension[0], "tension");
    derivative_is_a_difference(&s, &k, &k.pull[1], 1e-5, &by_pull[1], "pulled length");
    for (int c = 0; c < 3; c++) {
        for (int i = 0; i < 6; i++) {
            column.a[i] = by_force.a[i][c];
        }
        derivative_is_a_difference(&s, &k, &k.force.a[c], 1e-4, &column, "tip force");
    }
    solved_free(&s);
    law_along_free(&law);
}

// --- the error falls with the fourth power where the path bends one way; where it bends back, the
// rate of turning has a corner, and the estimate knows

enum { LEVELS = 5 };

static void errors_fall(const char *what, vec6 force, bool bent_back)
{
    about("%s", what);
    const tendon_spec t = {.radius = field_constant(RADIUS), .friction = 0.5};
    const double tension = 0.8;
    const rod_request request = {.tension = &tension, .tip_space = force, .cold = true};
    law_along law = soft_law();
    const rod_spec spec = {.law = &law, .ntendon = 1, .tendons = &t};
    double h[LEVELS], error[LEVELS];
    solved exact;
    solve_well(&exact, &spec, (rod_options){.npanel = 1024}, &request);
    for (int i = 0; i < LEVELS; i++) {
        solved s;
        solve_well(&s, &spec, (rod_options){.npanel = 8 << i}, &request);
        h[i] = 1.0 / (8 << i);
        error[i] = gap(s.out.tip.p, exact.out.tip.p) / LENGTH;
        printf("%-20s %4d panels: tip / L %8.1e, estimate %8.1e\n", what, 8 << i, error[i],
               s.out.relative_error);
        CHECK_AT_LEAST(s.out.relative_error, (bent_back ? error[i] : error[i] / 3));
        solved_free(&s);
    }
    const double order = observed_order(LEVELS - 1, h + 1, error + 1);
    printf("%-20s order %.2f\n", what, order);
    if (bent_back) {
        CHECK_ABOVE(order, 1.7);
    } else {
        CHECK_WITHIN(order, 4, 0.2);
    }
    solved_free(&exact);
    law_along_free(&law);
}

int main(void)
{
    against(BY_CLOSED_FORM, "the capstan; differences of whole solves; order of the error");
    const double strength[] = {0.1, 0.8, 5, 13};
    for (int i = 0; i < 4; i++) {
        rubbed_arc_is_found(strength[i], false, false);
        rubbed_arc_is_found(strength[i], true, false);
        rubbed_arc_is_found(strength[i], true, true);
        next_answers_take_few_steps(strength[i]);
    }
    capstan_holds_on_a_loaded_helix();
    derivatives_follow_friction();
    errors_fall("bends one way", (vec6){{-0.08, 0.04, 0}}, false);
    errors_fall("bends back", (vec6){{-0.08, 0, 0}}, true);
    return test_failures != 0;
}
