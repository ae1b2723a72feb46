// tests/verify/rodsolver/verify_rod_derivatives.c
// Derivatives by Taylor's remainder: g(x + h) against g(x) exp(h J) is off by h^2, for every
// parameter of a rod with all that there is, loaded and unloaded, at the tip and inside.
#include "tests/verify/rodsolver/full_rod.h"

enum { STEPS = 4, POINTS = 101, INSIDE = 37, PLACES = 2, LOADS = 5, DESIGNS = 4 };

static const rod_options options = {.npanel = 48};
static const double AT[PLACES] = {1, INSIDE / (POINTS - 1.0)}; // of the length
// of Taylor's 2: the next order still shows in the largest step
static const double SLOPE = 0.15;

// what a request points to, to be changed one number at a time
typedef struct inputs {
    double tension[2], pull[2], load[LOADS];
    vec6 tip_space, tip_body;
    pose base;
    bool pulled;
} inputs;

typedef enum kind { BY_TENSION, BY_PULL, BY_LOAD, BY_SPACE, BY_BODY, BY_BASE, KINDS } kind;

typedef struct parameter {
    const char *name;
    int count;
    double scale; // of the first step: a change that bends the rod visibly
} parameter;

static const parameter parameters[KINDS] = {
    {"tension", 2, 0.04},        {"pull", 2, 4e-4},          {"load's factor", LOADS, 0.4},
    {"tip wrench, space", 6, 0}, {"tip wrench, body", 6, 0}, {"base", 6, 0},
};

// loaded, the rod is near a load at which it swings over fast: smaller steps there
static double first_step(kind k, int i, bool loads)
{
    const double force = 2e-3, moment = 1e-4, angle = 0.05, part = loads ? 0.01 : 1;
    if (k == BY_BASE) {
        return part * (i < 3 ? angle * FULL_LENGTH : angle);
    }
    return part * (k < BY_SPACE ? parameters[k].scale : i < 3 ? force : moment);
}

static inputs changed(inputs x, kind k, int i, double h)
{
    double *by[] = {x.tension, x.pull, x.load, x.tip_space.a, x.tip_body.a};
    if (k == BY_BASE) {
        vec6 twist = {0};
        twist.a[i] = h;
        x.base = pose_mul(x.base, se3_exp(twist));
    } else {
        by[k][i] += h;
    }
    return x;
}

static rod_request request_of(const inputs *x, bool loads)
{
    return (rod_request){.tension = x->tension,
                         .pull = x->pulled ? x->pull : NULL,
                         .load = loads ? x->load : NULL,
                         .tip_space = x->tip_space,
                         .tip_body = x->tip_body,
                         .base = &x->base,
                         .cold = true};
}

typedef struct answer {
    pose g[PLACES];
    double length[2];
} answer;

static answer solve(solved *s, const inputs *x, bool loads)
{
    static double at[POINTS];
    static pose g[POINTS];
    const rod_request request = request_of(x, loads);
    CHECK_OK(solved_again(s, &request));
    CHECK_OK(rod_shape(s->state, POINTS, at, g));
    answer a = {{g[POINTS - 1], g[INSIDE]}, {s->length[0], s->length[1]}};
    return a;
}

// the size of a twist, turns counted by the length
static double twist_size(pose from, pose to)
{
    const pose d = pose_mul(pose_inverse(from), to);
    return hypot(vec3_norm(d.p) / FULL_LENGTH, vec3_norm(so3_log(d.R)));
}

static void remainder_is_of_order_two(const char *what, int i, double place, const double *h,
                                      const double *error, double first)
{
    about("%s", what);
    const double slope = observed_order(STEPS, h, error);
    printf("%-20s %d at %.2f: remainder %9.2e of a change of %9.2e, order %.3f\n", what, i, place,
           error[STEPS - 1], first, slope);
    // what depends on x linearly leaves rounding only
    if (!(error[0] < 1e-11)) {
        CHECK_AT_MOST(fabs(slope - 2), SLOPE);
    }
    CHECK_BELOW(error[0], 0.5 * first); // and the derivative is most of the change
}

// --- all derivatives at once

typedef struct jacobian {
    vec6 column[KINDS][6];
} jacobian;

static jacobian derive(solved *s, double at)
{
    jacobian J = {0};
    mat6 space, body, base;
    const rod_derivatives out = {.tension = J.column[BY_TENSION],
                                 .pull = J.column[BY_PULL],
                                 .load = J.column[BY_LOAD],
                                 .tip_space = &space,
                                 .tip_body = &body,
                                 .base = &base};
    CHECK_OK(rod_derive(s->state, at, &out));
    const mat6 *by[] = {&space, &body, &base};
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 36; i++) {
            J.column[BY_SPACE + k][i % 6].a[i / 6] = by[k]->a[i / 6][i % 6];
        }
    }
    return J;
}

static void parameter_is_derived(solved *s, const inputs *x, const answer *g, const jacobian *J,
                                 kind k, int i, bool loads)
{
    double h[STEPS], error[PLACES][STEPS], first[PLACES];
    for (int n = 0; n < STEPS; n++) {
        h[n] = first_step(k, i, loads) / (1 << n);
        const inputs y = changed(*x, k, i, h[n]);
        const answer there = solve(s, &y, loads);
        for (int p = 0; p < PLACES; p++) {
            const pose wanted = pose_mul(g->g[p], se3_exp(vec6_scale(h[n], J[p].column[k][i])));
            error[p][n] = twist_size(wanted, there.g[p]);
            first[p] = n == 0 ? twist_size(g->g[p], there.g[p]) : first[p];
        }
    }
    for (int p = 0; p < PLACES; p++) {
        remainder_is_of_order_two(parameters[k].name, i, AT[p], h, error[p], first[p]);
    }
}

static void lengths_are_derived(solved *s, const inputs *x, const answer *g, const double by[4],
                                bool loads)
{
    for (int j = 0; j < 2; j++) {
        double h[STEPS], error[STEPS], first = 0;
        for (int n = 0; n < STEPS; n++) {
            h[n] = first_step(BY_TENSION, j, loads) / (1 << n);
            const inputs y = changed(*x, BY_TENSION, j, h[n]);
            const answer there = solve(s, &y, loads);
            error[n] = 0;
            for (int i = 0; i < 2; i++) {
                const double change = there.length[i] - g->length[i];
                error[n] += fabs(change - h[n] * by[2 * i + j]) / FULL_LENGTH;
                first += n == 0 ? fabs(change) / FULL_LENGTH : 0;
            }
        }
        remainder_is_of_order_two("lengths by tension", j, 1, h, error, first);
    }
    // Maxwell and Betti, where there is a potential
    if (!loads) {
        CHECK_BELOW(fabs(by[1] / by[2] - 1), 1e-9);
    }
}

static void all_are_derived(bool loads, bool pulled)
{
    full_rod p;
    full_rod_make(&p, full_plain, loads);
    inputs x = {.tension = {0.3, 0.2},
                .load = {1, 1, 1, 1, 1},
                .tip_space = p.request.tip_space,
                .tip_body = p.request.tip_body,
                .base = p.v.base};
    const inputs nothing = {.base = p.v.base};
    solved s;
    rod_request request = request_of(&nothing, loads);
    solve_well(&s, &p.spec, options, &request);
    CHECK(rod_load_count(s.r) == (loads ? LOADS : 0));
    const double rest[2] = {s.length[0], s.length[1]};
    // pulled by as much as these tensions draw
    request = request_of(&x, loads);
    CHECK_OK(solved_again(&s, &request));
    for (int i = 0; i < 2 && pulled; i++) {
        x.pull[i] = rest[i] - s.length[i];
        x.pulled = true;
    }
    const answer g = solve(&s, &x, loads);
    jacobian J[PLACES];
    for (int i = 0; i < PLACES; i++) {
        J[i] = derive(&s, AT[i] * FULL_LENGTH);
    }
    for (int i = 0; i < 2; i++) {
        CHECK_NEAR(s.tension[i], x.tension[i], 1e-9);
    }
    double by[4];
    CHECK_OK(rod_derive(s.state, FULL_LENGTH, &(rod_derivatives){.length_by_tension = by}));
    for (kind k = 0; k < KINDS; k++) {
        const int count = k == BY_LOAD && !loads ? 0 : parameters[k].count;
        for (int i = 0; i < count && (k != BY_TENSION || !pulled) && (k != BY_PULL || pulled);
             i++) {
            parameter_is_derived(&s, &x, &g, J, k, i, loads);
        }
    }
    if (!pulled) {
        lengths_are_derived(&s, &x, &g, by, loads);
    }
    solved_free(&s);
    law_along_free(&p.law);
}

// --- design parameters

static const char *const design_names[DESIGNS] = {"stiffness", "tendon's place",
                                                  "curvature at rest", "point load's place"};
static const double design_step[DESIGNS] = {0.05, 2e-4, 0.5, 1e-3};

static void design_make(full_rod *p, int design, double by, bool loads)
{
    full_rod_make(p, full_plain, loads);
    for (int i = 0; i < p->law.nnode && design == 0; i++) {
        p->law.law[i].K = mat6_scale(1 + by, p->law.law[i].K);
    }
    p->place[0][0].mean += design == 1 ? by : 0;
    p->curvature[1].mean += design == 2 ? by : 0;
    p->point[0].place[0] += design == 3 ? by : 0;
}

static rod *design_rod(full_rod *p, int design, double by, bool loads)
{
    rod *r = NULL;
    design_make(p, design, by, loads);
    CHECK_OK(rod_make(&p->spec, &options, &r));
    return r;
}

static void design_is_derived(int design, bool loads)
{
    full_rod at, more, less;
    design_make(&at, design, 0, loads);
    solved s;
    solve_well(&s, &at.spec, options, &at.request);
    const double small = 1e-4 * design_step[design];
    rod *plus = design_rod(&more, design, small, loads);
    rod *minus = design_rod(&less, design, -small, loads);
    vec6 column;
    CHECK_OK(rod_derive_design(s.state, plus, minus, small, FULL_LENGTH, &column));
    double h[STEPS], error[STEPS], first = 0;
    for (int n = 0; n < STEPS; n++) {
        full_rod there;
        solved t;
        h[n] = (loads ? 0.01 : 1) * design_step[design] / (1 << n);
        design_make(&there, design, h[n], loads);
        solve_well(&t, &there.spec, options, &there.request);
        const pose wanted = pose_mul(s.out.tip, se3_exp(vec6_scale(h[n], column)));
        error[n] = twist_size(wanted, t.out.tip);
        first = n == 0 ? twist_size(s.out.tip, t.out.tip) : first;
        solved_free(&t);
        law_along_free(&there.law);
    }
    remainder_is_of_order_two(design_names[design], 0, 1, h, error, first);
    rod_free(plus);
    rod_free(minus);
    solved_free(&s);
    law_along_free(&at.law);
    law_along_free(&more.law);
    law_along_free(&less.law);
}

int main(void)
{
    against(BY_SECOND_WAY, "Taylor's remainder by whole solves");
    for (int loads = 0; loads < 2; loads++) {
        all_are_derived(loads, false);
        all_are_derived(loads, true);
        for (int design = 0; design < (loads ? DESIGNS : DESIGNS - 1); design++) {
            design_is_derived(design, loads);
        }
    }
    return test_failures != 0;
}
