// tests/verify/rodsolver/verify_rod_load_order.c
// Under load too the pose is of order 6 down to rounding, its error estimate is honest, and a
// tolerance that is asked for is kept.
#include "tests/unit/rodsolver/prototypes.h"
#include "tests/verify/rodsolver/loaded_rods.h"

enum { CASES = 7, LEVELS = 4, FINEST = 320 };

typedef struct study {
    const char *what;
    rod_spec spec;
    rod_request request;
} study;

static double helix(const void *expression, double s)
{
    return *(const double *)expression * s;
}

static const double TURN = 50, TENSION[2] = {0.5, 0.2}, PULL[2] = {4e-3, NAN};

// what the loads that are kept by reference stand in
typedef struct stock {
    law_along law;
    tendon_spec tendon[2], rubbing[2];
    line_load line;
    point_load point;
    study study[CASES];
} stock;

static void stock_make(stock *k)
{
    memset(k, 0, sizeof *k);
    const prototype p = helical_nc();
    prototype_law(&p, &k->law);
    for (int i = 0; i < k->law.nnode; i++) {
        k->law.law[i].mass = 0.04;
    }
    k->tendon[0] = straight_tendon("straight", 3.6e-3, PROTOTYPE_PI / 2);
    k->tendon[1] = straight_tendon("helix", 3.6e-3, 0);
    k->tendon[1].angle = (field){.at = helix, .expression = &TURN};
    memcpy(k->rubbing, k->tendon, sizeof k->tendon);
    k->rubbing[0].friction = k->rubbing[1].friction = 0.2;
    k->line = (line_load){.frame = LOAD_BODY, .force[1] = field_constant(0.15)};
    k->point = (point_load){.s = 0.5 * p.length, .force = {0.01, -0.01, 0}};

    const rod_spec bare = {.law = &k->law},
                   pulled = {.law = &k->law, .ntendon = 2, .tendons = k->tendon};
    const vec6 force = {{0.015, -0.01, 0.008}};
    study *s = k->study;
    s[0] = (study){"tip force", bare, {.tip_space = force}};
    s[1] = (study){"follower tip force", bare, {.tip_body = force}};
    s[2] = (study){"gravity", bare, {0}};
    memcpy(s[2].spec.gravity, (double[]){6, 3, -7}, 3 * sizeof(double));
    s[3] = (study){"tendons, tip force", pulled, {.tip_space = force, .tension = TENSION}};
    s[4] = (study){
        "pulled, tip force", pulled, {.tip_space = force, .tension = TENSION, .pull = PULL}};
    s[5] = (study){"friction", pulled, {.tension = TENSION}};
    s[5].spec.tendons = k->rubbing;
    s[6] = (study){"line and point loads", bare, {0}};
    s[6].spec.nline_load = s[6].spec.npoint_load = 1;
    s[6].spec.line_loads = &k->line;
    s[6].spec.point_loads = &k->point;
    for (int i = 0; i < CASES; i++) {
        s[i].request.cold = true;
    }
}

static rod_solution answer(const study *t, rod_options options)
{
    solved s;
    solve_well(&s, &t->spec, options, &t->request);
    const rod_solution out = s.out;
    solved_free(&s);
    return out;
}

static void order_is_six(const study *t)
{
    const double length = t->spec.law->length;
    const rod_solution exact = answer(t, (rod_options){.npanel = FINEST});
    double h[LEVELS], tip[LEVELS];
    for (int i = 0; i < LEVELS; i++) {
        const int n = 8 << i;
        const rod_solution out = answer(t, (rod_options){.npanel = n});
        h[i] = 1.0 / n;
        tip[i] = gap(out.tip.p, exact.tip.p) / length;
        printf("%-22s %4d panels: tip / L %9.2e, estimate %9.2e\n", t->what, n, tip[i],
               out.relative_error);
        // errors may cancel at the tip by chance: then the estimate is larger
        CHECK_AT_LEAST(out.relative_error, tip[i] / 3 - 1e-14);
        CHECK_AT_MOST(out.relative_error, 200 * tip[i] + 1e-13);
    }
    about("%s", t->what);
    // the last three: the first is not yet small
    const double order = observed_order(LEVELS - 1, h + 1, tip + 1);
    printf("%-22s order %.2f\n", t->what, order);
    CHECK_WITHIN(order, 6.0, 0.35);
    // and down to rounding
    const rod_solution nearly = answer(t, (rod_options){.npanel = FINEST * 3 / 4});
    printf("%-22s down to %.2e m\n", t->what, gap(nearly.tip.p, exact.tip.p));
    CHECK_WITHIN(gap(nearly.tip.p, exact.tip.p), 0, 1e-12);
}

static void tolerance_is_kept(const study *t)
{
    const rod_solution exact = answer(t, (rod_options){.npanel = FINEST});
    for (double tolerance = 1e-4; tolerance > 1e-12; tolerance /= 100) {
        const rod_solution out = answer(t, (rod_options){.tolerance = tolerance});
        const double error = gap(out.tip.p, exact.tip.p) / t->spec.law->length;
        CHECK_AT_MOST(error, tolerance);
        CHECK_AT_MOST(out.relative_error, tolerance);
        CHECK_AT_LEAST(out.relative_error, error / 3 - 1e-14);
    }
}

int main(void)
{
    against(BY_SECOND_WAY, "the same rod on many more panels");
    static stock k;
    stock_make(&k);
    for (int i = 0; i < CASES; i++) {
        order_is_six(&k.study[i]);
        tolerance_is_kept(&k.study[i]);
    }
    law_along_free(&k.law);
    return test_failures != 0;
}
