// tests/verify/rodsolver/rod_stress_loads.h
// More of rod_stress.h: loads of hundreds of Euler loads, random ones, and bad numbers.
#pragma once

#include "tests/verify/rodsolver/rod_stress.h"

// A dead force far above EI / L^2 at the angle psi draws the rod straight but for a layer at the
// base: tan(eta / 4) = tan(psi / 4) exp(-a s), a = sqrt(F / EI), up to exp(-2 a L). With EA = GA.
static inline void stress_drawn(double alpha, double degrees, stress_count *n)
{
    const double unit = STRESS_EI / (STRESS_LENGTH * STRESS_LENGTH), EA = 1e6 * unit;
    const double psi = degrees * LOADED_PI / 180, a = sqrt(alpha), F = alpha * unit;
    const double along = 1 - 2 / a * (1 - cos(psi / 2)) + F / EA, across = 2 / a * sin(psi / 2);
    const vec3 truth = vec3_scale(STRESS_LENGTH, vector(along * sin(psi) - across * cos(psi), 0,
                                                        along * cos(psi) + across * sin(psi)));
    law_along law =
        uniform_law(STRESS_LENGTH, diagonal_K(EA, EA, EA, STRESS_EI, STRESS_EI, 0.7 * STRESS_EI));
    char what[80];
    (void)snprintf(what, sizeof what, "drawn at %g deg, F L^2 / EI", degrees);
    stress_row(what, alpha, &(rod_spec){.law = &law},
               &(rod_request){.tip_space = {{F * sin(psi), 0, F * cos(psi)}}, .cold = true}, &truth,
               n);
    law_along_free(&law);
}

// hanging from a base that points `degrees` away from down
static inline void stress_hanging(double alpha, double degrees, stress_count *n)
{
    const double unit = STRESS_EI / (STRESS_LENGTH * STRESS_LENGTH), g = 9.81;
    const double psi = degrees * LOADED_PI / 180;
    law_along law = uniform_law(STRESS_LENGTH, diagonal_K(1e5 * unit, 1e5 * unit, 1e5 * unit,
                                                          STRESS_EI, STRESS_EI, 0.7 * STRESS_EI));
    law.law[0].mass = alpha * unit / (STRESS_LENGTH * g);
    char what[80];
    (void)snprintf(what, sizeof what, "hanging at %g deg, q L^3 / EI", degrees);
    stress_row(what, alpha, &(rod_spec){.law = &law, .gravity = {g * sin(psi), 0, g * cos(psi)}},
               &(rod_request){.cold = true}, NULL, n);
    law_along_free(&law);
}

// --- random dead loads of any size: the differential equation, marched from the base, ends there

static inline double stress_uniform(unsigned *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) / 16777216.0;
}

static inline vec3 stress_direction(unsigned *state)
{
    const double z = 2 * stress_uniform(state) - 1, a = 2 * LOADED_PI * stress_uniform(state);
    return vector(sqrt(1 - z * z) * cos(a), sqrt(1 - z * z) * sin(a), z);
}

typedef struct stress_tally {
    int right, wrong, refused, limits;
    double worst;
} stress_tally;

// marching multiplies errors by about exp(sqrt(F L^2 / EI)): it is believed up to that
static inline void stress_random_one(const law_along *law, double alpha, unsigned *seed,
                                     stress_tally *tally)
{
    const double unit = STRESS_EI / (STRESS_LENGTH * STRESS_LENGTH);
    const vec3 F = vec3_scale(alpha * unit, stress_direction(seed));
    const vec3 M = vec3_scale(sqrt(alpha) * STRESS_EI / STRESS_LENGTH, stress_direction(seed));
    solved s;
    solve_from_rest(&s, &(rod_spec){.law = law}, (rod_options){.tolerance = STRESS_TOLERANCE},
                    &(rod_request){.tip_space = wrench_of(F, M), .cold = true});
    if (s.st == OK) {
        const marching m = {.law = law};
        const double error =
            gap(march_to_tip(&m, s.out.tip.p, F, M, 800).g.p, s.out.tip.p) / STRESS_LENGTH;
        const bool right =
            error <= 10 * STRESS_TOLERANCE * exp(1.5 * sqrt(alpha)) && finite_solution(&s.out);
        tally->worst = fmax(tally->worst, error);
        *(right ? &tally->right : &tally->wrong) += 1;
    } else {
        tally->limits += s.out.ncritical > 0;
        tally->refused++;
    }
    status_clear();
    solved_free(&s);
}

static inline void stress_random(double alpha, int count, stress_count *n)
{
    unsigned seed = 7;
    stress_tally tally = {0};
    law_along law = uniform_law(STRESS_LENGTH,
                                diagonal_K(4, 5, 12, STRESS_EI, 1.5 * STRESS_EI, 0.7 * STRESS_EI));
    for (int i = 0; i < count; i++) {
        stress_random_one(&law, alpha, &seed, &tally);
    }
    law_along_free(&law);
    n->rows++;
    n->outside += tally.wrong > 0;
    printf("| random force and moment, F L^2 / EI | %g | %.1e | | | %d: %d right, %d at a limit "
           "point, "
           "%d otherwise refused%s |\n",
           alpha, tally.worst, count, tally.right, tally.limits, tally.refused - tally.limits,
           tally.wrong > 0 ? ", **some wrong**" : "");
}

// --- bad numbers in every place of a request

typedef struct stress_request {
    double tension[2], pull[2], load[2];
    vec6 space, body;
    pose base;
} stress_request;

enum { STRESS_NUMBERS = sizeof(stress_request) / sizeof(double) };

static inline void stress_bad_one(solved *s, const stress_request *good, int place, double bad,
                                  stress_tally *tally)
{
    double numbers[STRESS_NUMBERS];
    stress_request x;
    memcpy(numbers, good, sizeof numbers);
    numbers[place] = bad;
    memcpy(&x, numbers, sizeof x);
    const rod_request request = {.tension = x.tension,
                                 .pull = x.pull,
                                 .load = x.load,
                                 .tip_space = x.space,
                                 .tip_body = x.body,
                                 .base = &x.base,
                                 .cold = place % 2 == 0};
    const bool refused = solved_again(s, &request) != OK;
    const bool said = status_message()[0] != 0;
    status_clear();
    tally->refused += refused && said;
    tally->right += !refused && finite_solution(&s->out);
    tally->wrong += refused ? !said : !finite_solution(&s->out);
}

static inline void stress_bad_numbers(int step, stress_count *n)
{
    static const double bad[] = {NAN, INFINITY, -INFINITY, 1e308, -1e308, 1e30, -1e30, 1e-310, -1};
    const stress_request good = {{0.2, 0.1},      {NAN, 1e-3},          {1, 0.5},
                                 {{0.01, 0.005}}, {{0, 0, 0.01, 1e-4}}, pose_identity()};
    law_along law = uniform_law(STRESS_LENGTH,
                                diagonal_K(4, 5, 12, STRESS_EI, 1.5 * STRESS_EI, 0.7 * STRESS_EI));
    const tendon_spec t[2] = {{.x = field_constant(3e-3)}, {.y = field_constant(3e-3)}};
    const point_load point = {.s = 0.05, .force = {0.01}};
    const line_load line = {.frame = LOAD_BODY, .force[1] = field_constant(0.05)};
    const rod_spec spec = {.law = &law,
                           .ntendon = 2,
                           .tendons = t,
                           .npoint_load = 1,
                           .point_loads = &point,
                           .nline_load = 1,
                           .line_loads = &line};
    stress_tally tally = {0};
    solved s;
    solve_from_rest(&s, &spec, (rod_options){.tolerance = 1e-6}, &(rod_request){.cold = true});
    int count = 0;
    for (int i = 0; i < STRESS_NUMBERS * 9; i += step == 1 ? 1 : 26, count++) {
        stress_bad_one(&s, &good, i / 9, bad[i % 9], &tally);
    }
    solved_free(&s);
    law_along_free(&law);
    n->rows++;
    n->silent += tally.wrong;
    printf(
        "| bad numbers in a request | %d | | | | %d refused, %d answered in finite numbers%s |\n",
        count, tally.refused, tally.right, tally.wrong > 0 ? ", **others silent or NaN**" : "");
}

// all of them, or every third of a row
static inline stress_count stress_all(int step)
{
    stress_count n = {0};
    stress_head();
#define EACH(list, call)                                                                           \
    do {                                                                                           \
        const double values[] = list;                                                              \
        for (int i = 0; i < (int)(sizeof values / sizeof *values); i += step) {                    \
            const double v = values[i];                                                            \
            call;                                                                                  \
        }                                                                                          \
    } while (0)
#define VALUES(...) {__VA_ARGS__}
    EACH(VALUES(1e-2, 1, 1e2, 1e4, 1e6, 1e8), stress_stiffness(v, &n));
    EACH(VALUES(1e-2, 1, 1e2, 1e4, 1e6, 1e8), stress_stiffness_full(v, &n));
    EACH(VALUES(1e-6, 1e-4, 1e-2, 1, 1e2, 1e4, 1e6), stress_jump(v, &n));
    EACH(VALUES(0.9, 0.7, 0.5, 0.3, 0.1), stress_pressed(v, &n));
    EACH(VALUES(0.9, 0.7, 0.5, 0.3, 0.1), stress_pulled_short(v, &n));
    EACH(VALUES(1, 2, 5, 10, 15), stress_coils(v, false, &n));
    EACH(VALUES(1, 2, 5, 10, 15), stress_coils(v, true, &n));
    EACH(VALUES(1, 2, 3, 10, 50, 200), stress_many(v, false, &n));
    EACH(VALUES(1, 2, 3, 10, 50, 200), stress_many(v, true, &n));
    EACH(VALUES(5e2, 1e3, 1e4, 1e5), stress_drawn(v, 5, &n));
    EACH(VALUES(5e2, 1e3, 1e4, 1e5), stress_drawn(v, 90, &n));
    EACH(VALUES(5e2, 1e3, 1e4, 1e5), stress_drawn(v, 170, &n));
    EACH(VALUES(1e1, 1e2, 1e3, 1e4), stress_hanging(v, 10, &n));
    EACH(VALUES(1e1, 1e2, 1e3, 1e4), stress_hanging(v, 120, &n));
    EACH(VALUES(0.1, 1, 3, 10, 30), stress_random(v, step == 1 ? 100 : 20, &n));
    stress_bad_numbers(step, &n);
#undef VALUES
#undef EACH
    return n;
}
