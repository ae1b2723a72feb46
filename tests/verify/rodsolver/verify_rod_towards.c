// How the tip moves with what the rod is made of, from the rod's own derivative, against converged
// solves of other rods: central differences, extrapolated once by Richardson. Both prototypes,
// under tensions, friction, pulled tendons and a force at the tip.
#include "tests/unit/rodsolver/prototypes.h"

#include <string.h>

typedef enum parameter { RADIUS, ANGLE, FRICTION, STIFF, WIDTH, CURVATURE, PARAMETERS } parameter;
static const char *const names[PARAMETERS] = {"radius",  "angle", "friction",
                                              "E ratio", "width", "rest curvature"};
// steps of the differences: large enough that rounding stays below 1e-10, small enough that the
// fourth order does too
static const double step[PARAMETERS] = {1e-5, 2e-3, 5e-3, 5e-3, 1e-3, 2e-2};
static const double start[PARAMETERS] = {3.6e-3, 0.3, 0, 1, 1, 2};

typedef struct design {
    bool helical, pulled, loaded;
    double friction;
    double x[PARAMETERS];
} design;

typedef struct built {
    law_along law;
    made_rod made;
    rod_solution out;
} built;

// so fine that solves with friction and without, which integrate otherwise, agree to 1e-11
static const rod_options options = {.npanel = 48, .tolerance = ROD_MIN_TOLERANCE};

static void build(const design *d, built *b)
{
    prototype p = d->helical ? helical_nc() : constant_nc();
    *b = (built){0};
    p.stiff *= d->x[STIFF];
    p.width[0] *= d->x[WIDTH];
    p.width[1] *= d->x[WIDTH];
    prototype_law(&p, &b->law);
    tendon_spec tendon = straight_tendon("t", d->x[RADIUS], d->x[ANGLE]);
    tendon.friction = d->x[FRICTION];
    tendon.EA = 300;
    const rod_spec spec = {.law = &b->law,
                           .ntendon = 1,
                           .tendons = &tendon,
                           .rest = {.curvature_x = field_constant(d->x[CURVATURE])}};
    CHECK_OK(rod_make(&spec, &options, &b->made.rod));
    CHECK_OK(rod_state_make(b->made.rod, &b->made.state));
}

static pose solve(const design *d, built *b)
{
    const double tension = d->helical ? 0.98 : 0.67, pull = 4e-3;
    const rod_request request = {.tension = d->pulled ? NULL : &tension,
                                 .pull = d->pulled ? &pull : NULL,
                                 .tip_space = {{d->loaded ? 3e-3 : 0, d->loaded ? -2e-3 : 0, 0}},
                                 .cold = true};
    CHECK_OK(rod_solve(b->made.state, &request, &b->out));
    return b->out.tip;
}

static void discard(built *b)
{
    free_rod(b->made);
    law_along_free(&b->law);
}

// the body twist of the tip per step, from two whole solves
static vec6 between(const design *d, parameter k, double h, const mat3 *R)
{
    pose tip[2];
    for (int i = 0; i < 2; i++) {
        built b;
        design other = *d;
        other.x[k] += i == 0 ? h : -h;
        build(&other, &b);
        tip[i] = solve(&other, &b);
        discard(&b);
    }
    const vec3 v = mat3_tmul_vec(*R, vec3_scale(1 / (2 * h), vec3_sub(tip[0].p, tip[1].p)));
    const vec3 turn = so3_log(mat3_mul(mat3_transpose(tip[1].R), tip[0].R));
    // the turn between the two is that of the middle to second order, as the rest of the difference
    const vec3 w = vec3_scale(1 / (2 * h), turn);
    return (vec6){{v.a[0], v.a[1], v.a[2], w.a[0], w.a[1], w.a[2]}};
}

static vec6 richardson(const design *d, parameter k, const mat3 *R)
{
    const vec6 coarse = between(d, k, 2 * step[k], R), fine = between(d, k, step[k], R);
    return vec6_scale(1.0 / 3, vec6_sub(vec6_scale(4, fine), coarse));
}

static vec6 towards(const design *d, const built *b, parameter k, double h)
{
    built other;
    design there = *d;
    vec6 twist = {{0}};
    there.x[k] += h;
    build(&there, &other);
    CHECK_OK(rod_derive_towards(b->made.state, other.made.rod, h, 0.12, &twist));
    discard(&other);
    return twist;
}

static double size(vec6 x)
{
    return hypot(vec3_norm(vec6_linear(x)) / 0.12, vec3_norm(vec6_angular(x)));
}

static double off(vec6 x, vec6 y)
{
    return size(vec6_sub(x, y)) / size(y);
}

// (D(h) + D(-h)) / 2 and, on one side of a friction of 0, 2 D(h) - D(2 h)
static vec6 derived(const design *d, const built *b, parameter k)
{
    const double h = 1e-2 * step[k];
    if (d->x[k] - h < 0) {
        const vec6 near = towards(d, b, k, h), far = towards(d, b, k, 2 * h);
        return vec6_sub(vec6_scale(2, near), far);
    }
    return vec6_scale(0.5, vec6_add(towards(d, b, k, h), towards(d, b, k, -h)));
}

// rounding of the misfits over the step, and its square
static const double accuracy = 1e-7;

static void every_parameter_moves_the_tip_as_solves_do(design d)
{
    built b;
    memcpy(d.x, start, sizeof start);
    d.x[FRICTION] = d.friction;
    build(&d, &b);
    const pose tip = solve(&d, &b);
    for (parameter k = 0; k < PARAMETERS; k++) {
        if (d.x[k] - 2 * step[k] < 0) {
            continue; // friction from 0: the next check
        }
        const vec6 own = derived(&d, &b, k), wanted = richardson(&d, k, &tip.R);
        printf("%-8s %-6s %-6s mu %.1f by %-14s: tip %10.4g m per unit, off by %.1e\n",
               d.helical ? "helical" : "constant", d.pulled ? "pulled" : "",
               d.loaded ? "loaded" : "", d.friction, names[k], vec3_norm(vec6_linear(own)),
               off(own, wanted));
        CHECK_BELOW(off(own, wanted), accuracy);
    }
    discard(&b);
}

// from no friction on: against one-sided differences of solves, three points and Richardson
static void friction_begins(bool helical, bool loaded)
{
    design d = {.helical = helical, .loaded = loaded};
    built b;
    memcpy(d.x, start, sizeof start);
    build(&d, &b);
    const pose tip = solve(&d, &b);
    const vec6 own = derived(&d, &b, FRICTION);
    vec3 p[5];
    const double h = 1e-3;
    for (int i = 0; i < 5; i++) {
        built other;
        design there = d;
        there.x[FRICTION] = i * h;
        build(&there, &other);
        p[i] = solve(&there, &other).p;
        discard(&other);
    }
    // the derivative at the first of five points, of order 4
    static const double weight[5] = {-25.0 / 12, 4, -3, 4.0 / 3, -0.25};
    vec3 slope = {{0, 0, 0}};
    for (int i = 0; i < 5; i++) {
        slope = vec3_add_scaled(slope, weight[i] / h, p[i]);
    }
    const vec3 mine = mat3_mul_vec(tip.R, vec6_linear(own));
    const double error = distance(mine, slope) / vec3_norm(slope);
    printf("%-8s %-6s from no friction on: tip %10.4g m per unit, off by %.1e\n",
           helical ? "helical" : "constant", loaded ? "loaded" : "", vec3_norm(mine), error);
    CHECK_BELOW(error, accuracy);
    discard(&b);
}

static void one_side_is_of_first_order(void)
{
    design d = {.helical = true};
    built b;
    memcpy(d.x, start, sizeof start);
    build(&d, &b);
    (void)solve(&d, &b);
    const vec6 wanted = derived(&d, &b, ANGLE);
    double h[4], error[4];
    for (int i = 0; i < 4; i++) {
        h[i] = 8e-3 / (1 << i);
        error[i] = off(towards(&d, &b, ANGLE, h[i]), wanted);
        printf("one side, step %g: off by %.2e\n", h[i], error[i]);
    }
    CHECK_NEAR(observed_order(4, h, error), 1, 0.05);
    discard(&b);
}

static void mistakes_are_told(void)
{
    design d = {0};
    built b;
    vec6 twist;
    memcpy(d.x, start, sizeof start);
    build(&d, &b);
    CHECK(rod_derive_towards(b.made.state, b.made.rod, 1e-3, 0.12, &twist) == ERR_BUG); // no answer
    status_clear();
    (void)solve(&d, &b);
    CHECK(rod_derive_towards(b.made.state, b.made.rod, 0, 0.12, &twist) == ERR_INPUT);
    status_clear();
    CHECK(rod_derive_towards(b.made.state, b.made.rod, NAN, 0.12, &twist) == ERR_INPUT);
    status_clear();
    rod *none = NULL;
    CHECK_OK(rod_make(&(rod_spec){.law = &b.law}, &options, &none));
    CHECK(rod_derive_towards(b.made.state, none, 1e-3, 0.12, &twist) == ERR_INPUT);
    status_clear();
    rod_free(none);
    // towards itself nothing moves
    CHECK_OK(rod_derive_towards(b.made.state, b.made.rod, 1e-3, 0.12, &twist));
    CHECK_WITHIN(size(twist), 0, 0);
    discard(&b);
}

int main(void)
{
    against(BY_SECOND_WAY, "central differences of converged solves, extrapolated");
    for (int i = 0; i < 16; i++) {
        const design d = {
            .helical = i & 1, .loaded = i & 2, .pulled = i & 4, .friction = i & 8 ? 0.2 : 0};
        every_parameter_moves_the_tip_as_solves_do(d);
    }
    for (int i = 0; i < 4; i++) {
        friction_begins(i & 1, i & 2);
    }
    one_side_is_of_first_order();
    mistakes_are_told();
    return test_failures != 0;
}
