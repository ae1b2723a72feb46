// tests/verify/rodsolver/verify_rod_shooting.c
// The second method itself, before anything is held against it: references that are good to 1e-11
// m, closed forms, its order, and itself by another way.
#include "tests/rod_shooting_tendons.h"
#include "tests/unit/rodsolver/prototypes.h"

typedef struct pair {
    law_along law;
    tendon_spec tendon[2];
    rod_spec spec;
    shooting coarse, fine;
} pair;

static void pair_make(pair *q, int nstep)
{
    q->spec.law = &q->law;
    q->spec.tendons = q->tendon;
    CHECK_OK(shoot_make(&q->spec, nstep, &q->coarse));
    CHECK_OK(shoot_make(&q->spec, 2 * nstep, &q->fine));
}

static void pair_free(pair *q)
{
    shoot_free(&q->coarse);
    shoot_free(&q->fine);
    law_along_free(&q->law);
}

static double off(const shoot_answer *a, const double tip[3])
{
    return distance(a->tip.p, (vec3){{tip[0], tip[1], tip[2]}});
}

// the homogeneous annulus under 0.02 N across, without and with 0.5 N of tension
static void tip_force_is_the_reference(void)
{
    static const double tip[2][3] = {
        {0, 0.07852296901404067, 0.08310723449111658},
        {0.054729954587487015, 0.06225301055928794, 0.023125766351884125}};
    static const double length[2] = {0.12013155749227616, 0.10597663451039735};
    const prototype p = homogeneous_tube();
    pair q = {.tendon = {straight_tendon("a", 3.6e-3, 0)}, .spec = {.ntendon = 1}};
    prototype_law(&p, &q.law);
    pair_make(&q, 16);
    for (int i = 0; i < 2; i++) {
        const double tau = 0.5 * i;
        const rod_request rq = {.tension = &tau, .tip_space = {{0, 0.02, 0, 0, 0, 0}}};
        const shoot_answer a = shoot_solve(&q.coarse, &q.fine, &rq, 1);
        CHECK(a.solved && a.ncritical == 0 && a.sign == 1);
        CHECK_WITHIN(off(&a, tip[i]), 0, 1e-11);
        CHECK_WITHIN(a.length[0], length[i], 1e-11);
        CHECK(a.negative == 0);
        printf("tip force, %.1f N: %.1e m off the reference, own estimate %.1e m\n", tau,
               off(&a, tip[i]), a.error);
    }
    pair_free(&q);
}

// K(s) that turns and tapers
static void helical_prototype_is_the_reference(void)
{
    static const double tip[2][3] = {
        {-0.03127907696297282, 0.08485895950768964, 0.02897760051018824},
        {-0.005438892654100678, 0.03703327984881886, -0.036215048325144994}};
    const prototype p = helical_nc();
    pair q = {.tendon = {straight_tendon("a", 3.6e-3, PROTOTYPE_PI / 2)}, .spec = {.ntendon = 1}};
    prototype_law(&p, &q.law);
    pair_make(&q, 32);
    for (int i = 0; i < 2; i++) {
        const double tau = 0.98 * (i + 1);
        const rod_request rq = {.tension = &tau};
        const shoot_answer a = shoot_solve(&q.coarse, &q.fine, &rq, 1);
        CHECK_WITHIN(off(&a, tip[i]), 0, 1e-11);
    }
    pair_free(&q);
}

static void order_is_eight(void)
{
    enum { N = 4 };
    const prototype p = helical_nc();
    const double tau = 0.98;
    const rod_request rq = {.tension = &tau, .tip_space = {{0.004, 0.003, 0.01, 0, 0, 0}}};
    double h[N], error[N];
    vec3 exact = {0};
    for (int i = N; i >= 0; i--) {
        pair q = {.tendon = {straight_tendon("a", 3.6e-3, 1)}, .spec = {.ntendon = 1}};
        const int steps = i == N ? 64 : 4 << i;
        prototype_law(&p, &q.law);
        pair_make(&q, steps / 2);
        const shoot_answer a = shoot_solve(&q.coarse, &q.fine, &rq, 1);
        if (i == N) {
            exact = a.tip.p;
        } else {
            h[i] = 1.0 / steps;
            error[i] = distance(a.tip.p, exact);
            printf("%3d steps: %.2e m\n", steps, error[i]);
        }
        pair_free(&q);
    }
    CHECK_WITHIN(observed_order(N, h, error), 8, 0.5);
}

static law_along column_law(double L, const double diagonal[6])
{
    law_along law = {0};
    CHECK_OK(law_along_make(L, 1, 1, &law));
    for (int i = 0; i < 6; i++) {
        law.law[0].K.a[i][i] = diagonal[i];
    }
    return law;
}

// P (1 + P / GA - P / EA) = EI (k pi / 2 L)^2, k = 1, 3, ...: buckling with shear and shortening,
// and one more negative direction behind each
static void column_buckles_at_its_closed_form(void)
{
    const double L = 2, GA = 40, EA = 100, EI = 3, most = 30;
    pair q = {.law = column_law(L, (double[]){GA, GA, EA, EI, 500, 5})};
    pair_make(&q, 16);
    const rod_request rq = {.tip_space = {{0, 0, -most, 0, 0, 0}}};
    const shoot_answer a = shoot_solve(&q.coarse, &q.fine, &rq, 1);
    const double c = 1 / GA - 1 / EA;
    int count = 0;
    for (int k = 1;; k += 2) {
        const double e = EI * pow(k * PROTOTYPE_PI / (2 * L), 2);
        const double P = 2 * e / (1 + sqrt(1 + 4 * c * e));
        if (P > most) {
            break;
        }
        CHECK(a.critical[count].kind == CRITICAL_BIFURCATION);
        CHECK_NEAR(a.critical[count].fraction, P / most, 1e-7);
        count++;
    }
    CHECK(count == 2 && a.ncritical == count && a.solved && a.sign == 1);
    CHECK(a.negative == count);
    CHECK_WITHIN(a.tip.p.a[2], L * (1 - most / EA), 1e-12);
    pair_free(&q);
}

// Greenhill: a column that cannot be stretched buckles under its own weight at q L^3 = 7.8373 EI
static void heavy_column_buckles_at_greenhills_length(void)
{
    const double stiff = 1e7, weight = 10;
    pair q = {.law = column_law(1, (double[]){stiff, stiff, stiff, 1, 50, 1})};
    const line_load own = {.force = {{0}, {0}, {.value = -weight}}};
    q.spec.nline_load = 1;
    q.spec.line_loads = &own;
    pair_make(&q, 16);
    const rod_request rq = {0};
    const shoot_answer a = shoot_solve(&q.coarse, &q.fine, &rq, 1);
    CHECK(a.ncritical == 1 && a.critical[0].kind == CRITICAL_BIFURCATION);
    CHECK_NEAR(a.critical[0].fraction * weight, 7.837347438943, 1e-6); // shortening
    pair_free(&q);
}

// loads that follow: marched back from the tip, and as a boundary problem in all six unknowns
static void follower_by_two_ways(void)
{
    const prototype p = helical_nc();
    pair q = {.tendon = {straight_tendon("a", 3.6e-3, 1), straight_tendon("b", 3e-3, 3)},
              .spec = {.ntendon = 2}};
    q.tendon[1].end = 0.07;
    const point_load half = {
        .s = 0.05, .frame = LOAD_BODY, .force = {0.004, -0.01, 0.003}, .place = {0, 2e-3}};
    const line_load line = {
        .from = 0.03, .to = 0.1, .frame = LOAD_BODY, .force = {{.value = 0.05}}};
    q.spec.npoint_load = q.spec.nline_load = 1;
    q.spec.point_loads = &half;
    q.spec.line_loads = &line;
    prototype_law(&p, &q.law);
    pair_make(&q, 24);
    const double tau[2] = {0.3, 0.2};
    const pose base = se3_exp((vec6){{0.1, 0.2, 0.3, 0.4, -0.5, 0.6}});
    const rod_request rq = {
        .tension = tau, .base = &base, .tip_body = {{0, 0.01, -0.01, 1e-4, 0, 0}}};
    const shoot_answer a = shoot_follow(&q.fine, &rq, NULL);
    const shoot_answer b = shoot_solve(&q.coarse, &q.fine, &rq, 1);
    CHECK(a.solved && b.solved);
    CHECK_WITHIN(distance(a.tip.p, b.tip.p), 0, 1e-11);
    CHECK_WITHIN(rotation_difference(a.tip.R, b.tip.R), 0, 1e-10);
    CHECK_WITHIN(a.length[1], b.length[1], 1e-11);
    pair_free(&q);
}

// a straight tendon that rubs: tau' = -mu tau kappa, kappa = tau r / EI
static void friction_has_its_closed_form(void)
{
    const prototype p = homogeneous_tube();
    const double tau = 0.8, mu = 0.3, r = 3.6e-3;
    pair q = {.tendon = {straight_tendon("a", r, 0)}, .spec = {.ntendon = 1}};
    q.tendon[0].friction = mu;
    prototype_law(&p, &q.law);
    pair_make(&q, 12);
    const rod_request rq = {.tension = &tau};
    const shoot_answer a = shoot_rubbing(&q.coarse, &q.fine, &rq);
    const double c = mu * tau * r / prototype_integrals(&p, 0).EIx;
    CHECK(a.solved);
    for (int k = 0; k < q.fine.nstep; k++) {
        const shoot_step *step = &q.fine.step[k];
        CHECK_NEAR(step->node[2].place[0].share, 1 / (1 + c * (step->s + step->h / 2)), 1e-7);
    }
    // the angle at the tip: int kappa ds
    CHECK_WITHIN(atan2(a.tip.R.a[0][2], a.tip.R.a[2][2]),
                 remainder(log(1 + c * p.length) / mu, 2 * PROTOTYPE_PI), 1e-7);
    pair_free(&q);
}

// tau = q / (L (1/EA + r^2/EI)) where two opposite tendons let go of each other
static void pulled_length_has_its_closed_form(void)
{
    const prototype p = homogeneous_tube();
    const prototype_section k = prototype_integrals(&p, 0);
    const double r = 3.6e-3, pull[2] = {0.01, -0.02};
    pair q = {.tendon = {straight_tendon("a", r, 0), straight_tendon("b", r, PROTOTYPE_PI)},
              .spec = {.ntendon = 2}};
    prototype_law(&p, &q.law);
    pair_make(&q, 6);
    const rod_request rq = {.pull = pull};
    double tension[2];
    const shoot_answer a = shoot_pulled(&q.coarse, &q.fine, &rq, 1, tension);
    CHECK(a.solved);
    CHECK_NEAR(tension[0], pull[0] / (p.length * (1 / k.EA + r * r / k.EIx)), 1e-10);
    CHECK_WITHIN(tension[1], 0, 0); // slack: it was given 20 mm, and the bend asks for less
    pair_free(&q);
}

int main(void)
{
    against(BY_OTHER_CODE, "rods of an independent code, good to 1e-11 m; closed forms");
    friction_has_its_closed_form();
    pulled_length_has_its_closed_form();
    tip_force_is_the_reference();
    helical_prototype_is_the_reference();
    order_is_eight();
    column_buckles_at_its_closed_form();
    heavy_column_buckles_at_greenhills_length();
    follower_by_two_ways();
    return test_failures != 0;
}
