// tests/verify/rodsolver/verify_rod_rates.c
// Derivatives against central differences of order 6 of whole solves, to the rod's own tolerance:
// also where constant sections need two panels for a pose, and derivatives more.
#include "tests/verify/rodsolver/full_rod.h"

enum { STENCIL = 3, MOST = 2 + 6 + 6 };

// f' h = sum of c_k (f(k h) - f(-k h))
static const double stencil[STENCIL] = {45.0 / 60, -9.0 / 60, 1.0 / 60};

// all that a request holds and this test derives by
typedef struct inputs {
    double tension[2];
    vec6 wrench[2]; // on the tip, of the world and of the body
} inputs;

enum { TOLERANCES = 3 };
static const double tolerances[TOLERANCES] = {1e-12, 1e-9, 1e-6};
// a derivative may be off by this many tolerances, of its own size; differences tell no better than
// `least`
static const double least = 1e-9;

// forces at the tip: inside, the moments that they make at the stages are of order 4 only
static double times(int k, bool inside)
{
    return inside && k >= 2 && (k - 2) % 6 < 3 ? 300 : 10;
}

// steps: what bends the rod by a few hundredths, so that both the seventh order and rounding over
// the step are below the bound
static const double tension_step = 4e-3, force_step = 5e-5, moment_step = 2e-6;

static double *input(inputs *x, int k)
{
    return k < 2 ? &x->tension[k] : &x->wrench[(k - 2) / 6].a[(k - 2) % 6];
}

static double step_of(int k)
{
    return k < 2 ? tension_step : (k - 2) % 6 < 3 ? force_step : moment_step;
}

static pose solve_at(solved *s, const inputs *x, double place)
{
    pose g = pose_identity();
    const rod_request request = {
        .tension = x->tension, .tip_space = x->wrench[0], .tip_body = x->wrench[1], .cold = true};
    CHECK_OK(solved_again(s, &request));
    CHECK_OK(rod_pose(s->state, place, &g));
    return g;
}

static vec6 difference(solved *s, inputs x, int k, double place, mat3 R)
{
    const double h = step_of(k);
    vec3 v = {{0}}, w = {{0}};
    double *changed = input(&x, k);
    const double middle = *changed;
    for (int i = 0; i < STENCIL; i++) {
        *changed = middle + (i + 1) * h;
        const pose plus = solve_at(s, &x, place);
        *changed = middle - (i + 1) * h;
        const pose minus = solve_at(s, &x, place);
        const vec3 up = so3_log(mat3_mul(mat3_transpose(R), plus.R));
        const vec3 down = so3_log(mat3_mul(mat3_transpose(R), minus.R));
        v = vec3_add_scaled(v, stencil[i] / h, vec3_sub(plus.p, minus.p));
        w = vec3_add_scaled(w, stencil[i] / h, vec3_sub(up, down));
    }
    // at the middle the logarithm's own derivative is the body's turning rate
    return wrench_of(mat3_tmul_vec(R, v), w);
}

static double size(vec6 twist)
{
    return hypot(vec3_norm(vec6_linear(twist)) / FULL_LENGTH, vec3_norm(vec6_angular(twist)));
}

static void derive(solved *s, double place, vec6 column[MOST])
{
    mat6 by[2];
    CHECK_OK(
        rod_derive(s->state, place,
                   &(rod_derivatives){.tension = column, .tip_space = &by[0], .tip_body = &by[1]}));
    for (int i = 0; i < 72; i++) {
        column[2 + i / 36 * 6 + i % 6].a[i % 36 / 6] = by[i / 36].a[i % 36 / 6][i % 6];
    }
}

// A rod of each tolerance is held to the differences of the sharpest one's solves.
static void rates_are_those_of_solves(const char *what, const rod_spec *spec, inputs x)
{
    const rod_request rest = {.cold = true};
    solved s[TOLERANCES];
    for (int n = 0; n < TOLERANCES; n++) {
        solve_well(&s[n], spec, (rod_options){.tolerance = tolerances[n]}, &rest);
    }
    for (int i = 0; i < 2; i++) {
        const double place = (i == 0 ? 1 : 0.37) * FULL_LENGTH;
        const pose g = solve_at(&s[0], &x, place);
        vec6 wanted[MOST], column[MOST];
        for (int k = 0; k < MOST; k++) {
            wanted[k] = difference(&s[0], x, k, place, g.R);
        }
        for (int n = 0; n < TOLERANCES; n++) {
            double worst = 0;
            solve_at(&s[n], &x, place);
            derive(&s[n], place, column);
            for (int k = 0; k < MOST; k++) {
                const double off = size(vec6_sub(column[k], wanted[k])) / size(wanted[k]);
                const double bound = fmax(times(k, i == 1) * tolerances[n], least);
                worst = fmax(worst, off / bound);
            }
            printf("%-16s %s, tolerance %.0e: %.2f of the bound\n", what,
                   i == 0 ? "tip   " : "inside", tolerances[n], worst);
            CHECK_BELOW(worst, 1);
        }
    }
    for (int n = 0; n < TOLERANCES; n++) {
        solved_free(&s[n]);
    }
}

int main(void)
{
    against(BY_SECOND_WAY, "central differences of order 6 of whole solves");
    // the constant-offset prototype's size, two tendons at the wall
    law_along law = uniform_law(FULL_LENGTH, diagonal_K(8, 8, 22, 8.5e-5, 2e-4, 6e-5));
    const tendon_spec tendon[2] = {{.x = field_constant(3.6e-3)},
                                   {.x = field_constant(-1e-3), .y = field_constant(3.4e-3)}};
    const rod_spec constant = {.law = &law, .ntendon = 2, .tendons = tendon};
    inputs x = {.tension = {0.49, 0.1}};
    rates_are_those_of_solves("constant", &constant, x);
    x.wrench[0] = (vec6){{2e-3, -3e-3, 1e-3, 1e-5, 2e-5, -4e-5}};
    x.wrench[1] = (vec6){{1e-3}};
    rates_are_those_of_solves("constant, loaded", &constant, x);
    law_along_free(&law);
    for (int loads = 0; loads < 2; loads++) {
        full_rod p;
        full_rod_make(&p, full_plain, loads);
        x = (inputs){.tension = {0.3, 0.2}};
        rates_are_those_of_solves(loads ? "varying, loaded" : "varying", &p.spec, x);
        law_along_free(&p.law);
    }
    return test_failures != 0;
}
