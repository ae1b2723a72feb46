// tests/verify/rodsolver/rod_stress.h
// Rods at the ends of what can be asked: soft and stiff, jumps of K, pressed flat, coiled, under
// many tendons and loads of many Euler loads. In each the tip is right within the tolerance, or
// there is a refusal; never a NaN.
#pragma once

#include "tests/verify/rodsolver/elliptic.h"
#include "tests/verify/rodsolver/loaded_rods.h"

#define STRESS_LENGTH 0.12 // [m]
#define STRESS_EI 8e-5     // [N m^2]
#define STRESS_TOLERANCE 1e-9

typedef struct stress_count {
    int rows, refused, outside, silent; // silent: something that is not finite without a refusal
} stress_count;

static inline void stress_head(void)
{
    printf("| rod | value | true error of the tip / length | estimate | steps | |\n"
           "|---|---|---|---|---|---|\n");
}

static inline bool finite_solution(const rod_solution *out)
{
    double sum = out->relative_error + out->energy + out->fraction + out->residual;
    for (int i = 0; i < 3; i++) {
        sum += out->tip.p.a[i] + out->tip.R.a[i][0] + out->tip.R.a[i][1] + out->tip.R.a[i][2];
    }
    for (int i = 0; i < 6; i++) {
        sum += out->max_strain.a[i];
    }
    return isfinite(sum);
}

// the same with twice the panels
static inline bool finer_tip(const solved *s, const rod_spec *spec, const rod_request *request,
                             vec3 *tip)
{
    solved fine;
    solve_from_rest(&fine, spec, (rod_options){.npanel = 2 * rod_panel_count(s->state)}, request);
    *tip = fine.out.tip.p;
    const bool known = fine.st == OK;
    status_clear();
    solved_free(&fine);
    return known;
}

static inline void stress_refusal(const solved *s, stress_count *n)
{
    n->refused++;
    printf(" | | | %s |\n", status_message());
    // a limit point says where it is
    n->silent += s->out.fraction < 0 || s->out.fraction > 1;
    status_clear();
}

// truth: where the tip is; NULL: where a finer solution has it
static inline void stress_row(const char *what, double value, const rod_spec *spec,
                              const rod_request *request, const vec3 *truth, stress_count *n)
{
    solved s;
    n->rows++;
    printf("| %s | %g |", what, value);
    solve_from_rest(&s, spec, (rod_options){.tolerance = STRESS_TOLERANCE}, request);
    if (s.st != OK) {
        stress_refusal(&s, n);
    } else {
        vec3 tip = truth ? *truth : s.out.tip.p;
        const bool known = truth || finer_tip(&s, spec, request, &tip);
        const double error = gap(s.out.tip.p, tip) / spec->law->length;
        const bool right = known && error <= STRESS_TOLERANCE, finite = finite_solution(&s.out);
        n->outside += !right;
        n->silent += !finite;
        printf(" %.1e | %.1e | %d | %s%s%s |\n", error, s.out.relative_error, s.out.iterations,
               right   ? ""
               : known ? "**wrong**"
                       : "**not confirmed**",
               finite ? "" : " **NaN**", s.out.stable == 0 ? "unstable, as it says" : "");
    }
    solved_free(&s);
}

// --- EA / EI [1/mm^2], a dead force of 5 EI / L^2 across: exact elastica where EA = GA

static inline vec3 elastica_across(double alpha, double EA, double F)
{
    double low = sqrt(0.5), high = 1 - 1e-15;
    for (int i = 0; i < 200; i++) {
        const double k = (low + high) / 2, first = asin(1 / (k * sqrt(2)));
        const double length = jacobi_functions(0, k).K - legendre_f(first, k);
        *(length < sqrt(alpha) ? &low : &high) = k;
    }
    const double first = asin(1 / (low * sqrt(2)));
    const double E = jacobi_functions(0, low).E - legendre_e(first, low);
    return vec3_scale(STRESS_LENGTH, vector(1 - 2 * E / sqrt(alpha) + F / EA, 0,
                                            sqrt(2 * (2 * low * low - 1) / alpha)));
}

static inline void stress_stiffness(double per_mm2, stress_count *n)
{
    const double EA = per_mm2 * 1e6 * STRESS_EI;
    const double F = 5 * STRESS_EI / (STRESS_LENGTH * STRESS_LENGTH);
    law_along law =
        uniform_law(STRESS_LENGTH, diagonal_K(EA, EA, EA, STRESS_EI, STRESS_EI, 0.7 * STRESS_EI));
    const vec3 truth = elastica_across(5, EA, F);
    stress_row("force across, EA / EI [1/mm^2]", per_mm2, &(rod_spec){.law = &law},
               &(rod_request){.tip_space = {{F}}, .cold = true}, &truth, n);
    law_along_free(&law);
}

// all three directions at once, and a tendon: against finer
static inline void stress_stiffness_full(double per_mm2, stress_count *n)
{
    const double EA = per_mm2 * 1e6 * STRESS_EI, unit = STRESS_EI / (STRESS_LENGTH * STRESS_LENGTH);
    law_along law = uniform_law(
        STRESS_LENGTH, diagonal_K(EA / 3, EA / 3, EA, STRESS_EI, 1.4 * STRESS_EI, 0.7 * STRESS_EI));
    const tendon_spec tendon = {.radius = field_constant(2e-3), .angle = field_constant(1)};
    const double tau = 0.05;
    stress_row(
        "tendon and force, EA / EI [1/mm^2]", per_mm2,
        &(rod_spec){.law = &law, .ntendon = 1, .tendons = &tendon},
        &(rod_request){.tension = &tau, .tip_space = {{2 * unit, -unit, unit}}, .cold = true}, NULL,
        n);
    law_along_free(&law);
}

// --- K jumps in the middle; the load bends the softer half

static inline void stress_jump(double contrast, stress_count *n)
{
    law_along law = {0};
    CHECK_OK(law_along_make(STRESS_LENGTH, 2, 1, &law));
    const double soft = fmin(1, contrast), half = STRESS_LENGTH / 2;
    const mat6 K = diagonal_K(4, 4, 12, STRESS_EI, 1.3 * STRESS_EI, 0.8 * STRESS_EI);
    law.law[0].K = K;
    law.law[1].K = mat6_scale(contrast, K);
    // the arm of the force on a soft lower half is the whole rod
    const double arm = contrast < 1 ? half : STRESS_LENGTH, F = 3 * soft * STRESS_EI / (arm * arm);
    const vec3 force = vector(F, 0.5 * F, -0.4 * F);
    stress_row("K of the outer half over the inner's", contrast, &(rod_spec){.law = &law},
               &(rod_request){.tip_space = wrench_of(force, vector(0, 0, 0)), .cold = true}, NULL,
               n);
    law_along_free(&law);
}

// --- pressed to a part of the length; EA below 4 Euler loads never buckles

static inline void stress_pressed(double part, stress_count *n)
{
    const double euler = LOADED_PI * LOADED_PI / 4 * STRESS_EI / (STRESS_LENGTH * STRESS_LENGTH);
    const double EA = 3 * euler, P = (1 - part) * EA;
    law_along law = uniform_law(
        STRESS_LENGTH, diagonal_K(1e4 * EA, 1e4 * EA, EA, STRESS_EI, STRESS_EI, STRESS_EI));
    const vec3 truth = vector(0, 0, part * STRESS_LENGTH);
    stress_row("pressed to this part of its length", part, &(rod_spec){.law = &law},
               &(rod_request){.tip_space = {{0, 0, -P}}, .cold = true}, &truth, n);
    law_along_free(&law);
}

// by tendons: three at 120 degrees
static inline void stress_pulled_short(double part, stress_count *n)
{
    tendon_spec t[3];
    double tau[3];
    for (int i = 0; i < 3; i++) {
        t[i] = (tendon_spec){.radius = field_constant(1e-3),
                             .angle = field_constant(2 * LOADED_PI * i / 3)};
        tau[i] = (1 - part) * 12 / 3;
    }
    law_along law = uniform_law(STRESS_LENGTH, diagonal_K(4, 4, 12, STRESS_EI, STRESS_EI, 6e-5));
    const vec3 truth = vector(0, 0, part * STRESS_LENGTH);
    stress_row("pulled to this part of its length", part,
               &(rod_spec){.law = &law, .ntendon = 3, .tendons = t},
               &(rod_request){.tension = tau, .cold = true}, &truth, n);
    law_along_free(&law);
}

// --- coils

static inline void stress_coils(double coils, bool loaded, stress_count *n)
{
    const double radius = 1e-3, EA = 1e4;
    const double tau = 2 * LOADED_PI * coils * STRESS_EI / (STRESS_LENGTH * radius);
    const tendon_spec t = {.radius = field_constant(radius)};
    law_along law =
        uniform_law(STRESS_LENGTH, diagonal_K(EA, EA, EA, STRESS_EI, STRESS_EI, 0.7 * STRESS_EI));
    const vec3 truth = {{0}};
    stress_row(loaded ? "coiled by a tendon, force of 0.02 N" : "coiled by a tendon, turns", coils,
               &(rod_spec){.law = &law, .ntendon = 1, .tendons = &t},
               &(rod_request){.tension = &tau, .tip_space = {{0, 0.02 * loaded}}, .cold = true},
               loaded ? NULL : &truth, n);
    law_along_free(&law);
}

// --- many tendons, their tensions such that all together bend by pi / 2

static inline void stress_many(double count, bool loaded, stress_count *n)
{
    static tendon_spec t[LOADED_MAX_TENDONS];
    static double tau[LOADED_MAX_TENDONS];
    const int number = (int)count;
    const double radius = 3e-3, EA = 12, total = 0.7;
    double kx = 0, ky = 0;
    for (int i = 0; i < number; i++) {
        const double a = 2 * LOADED_PI * i / number;
        t[i] = (tendon_spec){.radius = field_constant(radius), .angle = field_constant(a)};
        tau[i] = total / number * (1 + cos(a - 0.5));
        // curvature about y from x, about -x from y
        kx += tau[i] * radius * cos(a) / STRESS_EI;
        ky += tau[i] * radius * sin(a) / STRESS_EI;
    }
    double sum = 0;
    for (int i = 0; i < number; i++) {
        sum += tau[i];
    }
    const vec6 xi = {{0, 0, 1 - sum / EA, -ky, kx, 0}};
    const vec3 truth = se3_exp(vec6_scale(STRESS_LENGTH, xi)).p;
    law_along law =
        uniform_law(STRESS_LENGTH, diagonal_K(4, 4, EA, STRESS_EI, STRESS_EI, 0.7 * STRESS_EI));
    stress_row(loaded ? "tendons, force of 0.01 N" : "tendons", count,
               &(rod_spec){.law = &law, .ntendon = number, .tendons = t},
               &(rod_request){.tension = tau, .tip_space = {{0, 0.01 * loaded}}, .cold = true},
               loaded ? NULL : &truth, n);
    law_along_free(&law);
}
