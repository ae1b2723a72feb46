// tests/verify/rodsolver/verify_rod_second_tendons.c
// Tendons under load whose drawn-out length is given, that stretch, let go or rub, against the
// second method.
#include "tests/verify/rodsolver/second.h"

static bool steps_make(const sample *q, shooting *coarse, shooting *fine)
{
    CHECK_OK(shoot_make(&q->spec, q->steps, coarse));
    CHECK_OK(shoot_make(&q->spec, 2 * q->steps, fine));
    return coarse->step && fine->step;
}

// tensions are found by both
static void pulls_agree(const char *what, sample *q)
{
    about("%s", what);
    shooting coarse = {0}, fine = {0};
    ours o = {0};
    double tension[SHOOT_TENDONS] = {0};
    q->rq.pull = q->pull;
    for (int i = 0; i < q->spec.ntendon; i++) {
        tension[i] = isnan(q->pull[i]) ? q->tension[i] : 0;
    }
    if (steps_make(q, &coarse, &fine)) {
        const shoot_answer a = shoot_pulled(&coarse, &fine, &q->rq, 1, tension);
        if (ours_solve(q, &o)) {
            compare(what, q, &o, &a);
        }
        for (int i = 0; i < q->spec.ntendon; i++) {
            printf("  tension %.9f and %.9f N\n", o.tension[i], tension[i]);
            CHECK_WITHIN(o.tension[i], tension[i], 1e-8);
        }
    }
    ours_free(&o);
    shoot_free(&coarse);
    shoot_free(&fine);
    law_along_free(&q->law);
}

static void one_pulled_one_given_one_slack(void)
{
    sample q;
    sample_make(homogeneous_tube(), 3, &q);
    q.tendon[1].angle = field_constant(2);
    q.tendon[2].angle = field_constant(-2.5);
    q.pull[0] = 0.012;
    q.pull[1] = NAN;
    q.pull[2] = -0.01;
    q.rq.tip_space = (vec6){{0.005, 0.01, 0.002, 0, 0, 0}};
    pulls_agree("tube: pulled, given and slack, tip force", &q);
}

static void elastic_and_pulled(void)
{
    sample q;
    sample_make(helical_nc(), 3, &q);
    q.tendon[0].EA = 20;
    q.tendon[0].outside = 0.3;
    q.tendon[1].end = 0.08;
    q.pull[0] = 0.008;
    q.pull[1] = 0.002;
    q.pull[2] = 0.004;
    q.rq.tip_space = (vec6){{-0.01, 0.005, 0.01, 0, 0, 0}};
    pulls_agree("helical: all pulled, one stretches", &q);
}

static void pulled_under_weight(void)
{
    sample q;
    sample_make(constant_nc(), 2, &q);
    const line_load weight = {.force = {{.value = 0.1}, {0}, {.value = -0.1}}};
    q.spec.nline_load = 1;
    q.spec.line_loads = &weight;
    q.pull[0] = 0.006;
    q.pull[1] = 0.003;
    pulls_agree("constant: pulled under a line load", &q);
}

// shares of the base's tension at the tip too
static void rubs(const char *what, sample *q)
{
    about("%s", what);
    shooting coarse = {0}, fine = {0};
    ours o = {0};
    if (steps_make(q, &coarse, &fine)) {
        const shoot_answer a = shoot_rubbing(&coarse, &fine, &q->rq);
        if (ours_solve(q, &o)) {
            double left[TENDONS];
            vec6 wrench;
            const double s = fine.step[fine.nstep / 2].s;
            compare(what, q, &o, &a);
            CHECK_OK(rod_wrench_at(o.state, s, &wrench, left));
            for (int i = 0; i < q->spec.ntendon; i++) {
                const double wanted =
                    q->tension[i] * fine.step[fine.nstep / 2].node[0].place[i].share;
                printf("  left in the middle: %.9f and %.9f of %.3f N\n", left[i], wanted,
                       q->tension[i]);
                CHECK_WITHIN(left[i], wanted, 1e-8);
            }
        }
    }
    ours_free(&o);
    shoot_free(&coarse);
    shoot_free(&fine);
    law_along_free(&q->law);
}

static void friction_without_load(void)
{
    sample q;
    sample_make(helical_nc(), 2, &q);
    q.tendon[0].friction = 0.3;
    q.tendon[1].friction = 0.1;
    q.steps = 48;
    rubs("helical: two tendons rub", &q);
}

static void friction_under_a_tip_force(void)
{
    sample q;
    sample_make(homogeneous_tube(), 2, &q);
    q.tendon[0].friction = 0.2;
    q.steps = 48;
    q.rq.tip_space = (vec6){{0.003, 0.01, 0.002, 0, 0, 0}};
    rubs("tube: one of two tendons rubs, tip force", &q);
}

int main(void)
{
    against(BY_SECOND_WAY, "the second method, shooting (tests/rod_shooting.h)");
    one_pulled_one_given_one_slack();
    elastic_and_pulled();
    pulled_under_weight();
    friction_without_load();
    friction_under_a_tip_force();
    return test_failures != 0;
}
