// tests/verify/rodsolver/verify_rod_second.c
// Rods under everything that a case can ask for, against the second method: K(s) that turns and
// tapers, gravity, loads at points and along lines, dead and following, rods that are bent and
// twisted at rest, tendons of all kinds.
#include "tests/verify/rodsolver/second.h"

static double line(const void *expression, double s)
{
    return *(const double *)expression * s;
}

typedef shoot_answer (*second_method)(shooting *sh, shooting *fine, const rod_request *rq);

static shoot_answer by_path(shooting *sh, shooting *fine, const rod_request *rq)
{
    return shoot_solve(sh, fine, rq, 1);
}

static shoot_answer from_tip(shooting *sh, shooting *fine, const rod_request *rq)
{
    const shoot_answer coarse = shoot_follow(sh, rq, NULL);
    shoot_answer a = shoot_follow(fine, rq, NULL);
    a.error = distance(a.tip.p, coarse.tip.p) / 50;
    return a;
}

static void agree(const char *what, sample *q, second_method second)
{
    about("%s", what);
    shooting coarse = {0}, fine = {0};
    ours o = {0};
    CHECK_OK(shoot_make(&q->spec, q->steps, &coarse));
    CHECK_OK(shoot_make(&q->spec, 2 * q->steps, &fine));
    const shoot_answer a = second(&coarse, &fine, &q->rq);
    if (ours_solve(q, &o)) {
        compare(what, q, &o, &a);
    }
    if (second == by_path) {
        const int negative = a.negative;
        CHECK(o.out.ncritical == a.ncritical);
        CHECK(o.out.stable == (negative < 0 ? -1 : negative == 0));
    }
    ours_free(&o);
    shoot_free(&coarse);
    shoot_free(&fine);
    law_along_free(&q->law);
}

static void dead_tip_wrench(void)
{
    sample q;
    sample_make(helical_nc(), 2, &q);
    q.rq.tip_space = (vec6){{0.01, -0.015, 0.02, 1e-4, -2e-4, 1e-4}};
    agree("helical, dead force and moment at the tip", &q, by_path);
}

static void own_weight(void)
{
    sample q;
    sample_make(helical_nc(), 1, &q);
    for (int i = 0; i < q.law.nnode; i++) {
        q.law.law[i].mass = 0.02;
        q.law.law[i].mass_centre[0] = 0.5e-3;
        q.law.law[i].mass_centre[1] = -0.2e-3;
    }
    q.spec.gravity[0] = 6;
    q.spec.gravity[2] = -7;
    const point_load half = {
        .s = 0.05, .force = {-0.01, 0.02, 0}, .moment = {0, 1e-4, 0}, .place = {1e-3, 3e-3}};
    q.spec.npoint_load = 1;
    q.spec.point_loads = &half;
    q.rq.load = (double[]){0.8, 1.2};
    agree("helical, weight and a point load beside", &q, by_path);
}

static void loads_that_follow(void)
{
    sample q;
    sample_make(helical_nc(), 3, &q);
    q.tendon[1].end = 0.07;
    q.tendon[2].end = 0.045;
    const double profile[3] = {0.03, 0.05, 40};
    const point_load half = {
        .s = 0.06, .frame = LOAD_BODY, .force = {0.01, 0.004, -0.01}, .place = {0, 2e-3}};
    const line_load part = {.from = 0.03, .to = 0.1, .frame = LOAD_BODY, .force = {waves(profile)}};
    const pose base = se3_exp((vec6){{0.1, 0.2, 0.3, 0.4, -0.5, 0.6}});
    q.spec.npoint_load = q.spec.nline_load = 1;
    q.spec.point_loads = &half;
    q.spec.line_loads = &part;
    q.rq.base = &base;
    q.rq.tip_body = (vec6){{0.02, 0, -0.02, 0, 1e-4, 1e-4}};
    agree("helical, everything follows, turned base", &q, from_tip);
}

static void dead_and_following(void)
{
    sample q;
    sample_make(helical_nc(), 2, &q);
    q.rq.tip_body = (vec6){{0.01, 0.005, 0, 0, 0, 1e-4}};
    q.rq.tip_space = (vec6){{0, 0.01, -0.01, 0, 0, 0}};
    agree("helical, dead and following at the tip", &q, by_path);
}

static void bent_at_rest(void)
{
    sample q;
    sample_make(constant_nc(), 2, &q);
    const double x[3] = {4, 6, 30}, twist[3] = {10, 5, 50}, across[3] = {0.02, 0.1, 20};
    q.spec.rest.curvature_x = waves(x);
    q.spec.rest.curvature_y = field_constant(-5);
    q.spec.rest.twist = waves(twist);
    const line_load wind = {.force = {waves(across), {.value = -0.05}}};
    q.spec.nline_load = 1;
    q.spec.line_loads = &wind;
    q.rq.tip_space = (vec6){{0, 0.01, 0.01, 0, 0, 0}};
    agree("constant, bent and twisted at rest", &q, by_path);
}

static void tendons_of_all_routes(void)
{
    sample q;
    sample_make(helical_nc(), 5, &q);
    const double turn = 40, radius[3] = {3e-3, 0.5e-3, 60}, way[3] = {0, 1e-3, 35};
    q.tendon[0].angle = (field){.at = line, .expression = &turn};
    q.tendon[1].radius = waves(radius);
    q.tendon[1].end = 0.08;
    q.tendon[2].x = waves(way);
    q.tendon[3].end = 0.05;
    q.tendon[4].end = 0.1;
    q.rq.tip_space = (vec6){{0.01, 0.01, -0.01, 0, 0, 0}};
    agree("helical, five tendons, three ends", &q, by_path);
}

static void breaks_are_met(void)
{
    sample q;
    sample_make(constant_nc(), 2, &q);
    law_along_free(&q.law);
    const prototype p = constant_nc();
    CHECK_OK(law_along_make(p.length, 3, 1, &q.law));
    for (int k = 0; k < 3; k++) {
        q.law.law[k].K = mat6_scale(k == 1 ? 20 : 1, prototype_stiffness(&p, p.width[0]));
        q.law.turn[k] = k;
    }
    q.rq.tip_space = (vec6){{0.02, 0.01, -0.02, 0, 0, 0}};
    agree("three pieces, the middle twenty times stiffer", &q, by_path);
}

int main(void)
{
    against(BY_SECOND_WAY, "the second method, shooting (tests/rod_shooting.h)");
    dead_tip_wrench();
    own_weight();
    loads_that_follow();
    dead_and_following();
    bent_at_rest();
    tendons_of_all_routes();
    breaks_are_met();
    return test_failures != 0;
}
