// tests/verify/rodsolver/verify_rod_invariance.c
// A rod with a full K(s), curved and twisted at rest, two tendons, and every kind of load: turned
// and moved, mirrored, in other units, and from its other end it is the same rod.
#include "tests/verify/rodsolver/full_rod.h"

// pairs of panels as they come, so that all of them integrate alike
static const rod_options options = {.npanel = 48};
// of the length: what rounding leaves
static const double SAME = 1e-13;

// the tip seen from the base, in the first view's units and on its side
static pose first_tip(const full_rod *p, pose tip)
{
    pose g = pose_mul(pose_inverse(p->v.base), tip);
    g.p = vec3_scale(1 / p->v.length, g.p);
    if (p->v.mirror < 0) {
        g.p.a[1] *= -1;
        g.R.a[0][1] *= -1;
        g.R.a[1][0] *= -1;
        g.R.a[1][2] *= -1;
        g.R.a[2][1] *= -1;
    }
    return g;
}

static void same_rod(const char *what, view v, bool loads)
{
    about("%s", what);
    full_rod first, other;
    full_rod_make(&first, full_plain, loads);
    full_rod_make(&other, v, loads);
    solved a, b;
    solve_well(&a, &first.spec, options, &first.request);
    solve_well(&b, &other.spec, options, &other.request);
    const pose tip = first_tip(&other, b.out.tip);
    const double moved = gap(a.out.tip.p, tip.p) / FULL_LENGTH,
                 turned = turn_gap(a.out.tip.R, tip.R);
    double drawn = 0;
    for (int i = 0; i < 2; i++) {
        drawn = fmax(drawn, fabs(a.length[i] - b.length[i] / v.length) / FULL_LENGTH);
    }
    printf("%-28s %s  tip %9.2e  turn %9.2e  tendons %9.2e\n", what, loads ? "loaded" : "      ",
           moved, turned, drawn);
    CHECK_WITHIN(moved, 0, SAME);
    CHECK_WITHIN(turned, 0, SAME);
    CHECK_WITHIN(drawn, 0, SAME);
    CHECK_ABOVE(gap(a.out.tip.p, vector(0, 0, FULL_LENGTH)),
                0.2 * FULL_LENGTH); // and it bends a good deal
    solved_free(&a);
    solved_free(&b);
    law_along_free(&first.law);
    law_along_free(&other.law);
}

static void units_do_not_matter(bool loads)
{
    static const double length[] = {1e-8, 1e-5, 1e-3, 10, 1e4};
    for (int i = 0; i < 5; i++) {
        view v = full_plain;
        v.length = length[i];
        same_rod("other lengths", v, loads);
        v.force = v.length * v.length;
        same_rod("other lengths, same stress", v, loads);
    }
}

static void turns_and_moves_do_not_matter(bool loads)
{
    for (int i = 0; i < 4; i++) {
        view v = full_plain;
        v.base.R = so3_exp(vector(1.1 * i, -2 + i, 0.7 + i * i));
        v.base.p = vec3_scale(FULL_LENGTH, vector(0.3, -0.5 * i, 0.4));
        same_rod("turned and moved", v, loads);
        v.mirror = -1;
        same_rod("mirrored, turned, moved", v, loads);
    }
}

// From the other end: clamped where the tip was, with the wall's reaction at the old base as a
// wrench that turns with it. Under a dead wrench (F, M) that is -(F, M + p x F).
static void other_end_does_not_matter(bool loads)
{
    full_rod first, other;
    view v = full_plain;
    full_rod_make(&first, v, false);
    v.reversed = true;
    full_rod_make(&other, v, false);
    const vec3 F = vec3_scale(loads, vector(0.01, 0.006, -0.008));
    const vec3 M = vec3_scale(loads, vector(2e-4, -1e-4, 3e-4));
    first.request.tip_space = wrench_of(F, M);
    solved a, b;
    solve_well(&a, &first.spec, options, &first.request);
    const vec3 base_moment = vec3_add(M, vec3_cross(a.out.tip.p, F));
    const mat3 flip = {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
    other.request.tip_body = wrench_of(vec3_scale(-1, mat3_mul_vec(flip, F)),
                                       vec3_scale(-1, mat3_mul_vec(flip, base_moment)));
    solve_well(&b, &other.spec, options, &other.request);
    const pose end = {flip, {{0}}};
    const pose wanted = pose_mul(end, pose_mul(pose_inverse(a.out.tip), end));
    printf("%-28s %s  tip %9.2e  turn %9.2e\n", "from the other end", loads ? "loaded" : "      ",
           gap(b.out.tip.p, wanted.p) / FULL_LENGTH, turn_gap(b.out.tip.R, wanted.R));
    CHECK_WITHIN(gap(b.out.tip.p, wanted.p) / FULL_LENGTH, 0, SAME);
    CHECK_WITHIN(turn_gap(b.out.tip.R, wanted.R), 0, SAME);
    solved_free(&a);
    solved_free(&b);
    law_along_free(&first.law);
    law_along_free(&other.law);
}

// nothing across the plane of x and z: y, and the turns out of the plane, are 0 and not merely
// small
static void plane_stays_plane(void)
{
    law_along law = uniform_law(FULL_LENGTH, diagonal_K(4, 5, 12, 8e-5, 1.1e-4, 6e-5));
    law.law[0].K.a[NZ][MY] = law.law[0].K.a[MY][NZ] = 5e-3;
    law.law[0].mass = 0.03;
    const tendon_spec tendon = {.x = field_constant(3e-3)};
    const line_load line = {.frame = LOAD_BODY, .force[0] = field_constant(0.03)};
    const double tau = 0.5;
    const rod_spec spec = {.law = &law,
                           .rest = {.curvature_y = field_constant(4)},
                           .ntendon = 1,
                           .tendons = &tendon,
                           .nline_load = 1,
                           .line_loads = &line,
                           .gravity = {3, 0, -9}};
    const rod_request request = {
        .tension = &tau, .cold = true, .tip_space = {{0.01, 0, -0.02, 0, 1e-4, 0}}};
    solved s;
    solve_well(&s, &spec, (rod_options){.tolerance = 1e-10}, &request);
    const pose g = s.out.tip;
    CHECK(g.p.a[1] == 0 && g.R.a[0][1] == 0 && g.R.a[1][0] == 0 && g.R.a[1][2] == 0 &&
          g.R.a[2][1] == 0 && g.R.a[1][1] == 1);
    CHECK_ABOVE(fabs(g.p.a[0]), 0.1 * FULL_LENGTH);
    solved_free(&s);
    law_along_free(&law);
}

// cold answers are the same bits whatever was solved before; warm ones agree to the tolerance
static void history_does_not_matter(void)
{
    full_rod p;
    full_rod_make(&p, full_plain, true);
    solved s;
    solve_well(&s, &p.spec, options, &p.request);
    const rod_solution first = s.out;
    rod_request other = p.request;
    other.tip_space = vec6_scale(-0.5, other.tip_space);
    CHECK_OK(solved_again(&s, &other));
    CHECK_OK(solved_again(&s, &p.request));
    CHECK(memcmp(&first.tip, &s.out.tip, sizeof first.tip) == 0);
    CHECK_OK(solved_again(&s, &other));
    other = p.request;
    other.cold = false;
    CHECK_OK(solved_again(&s, &other));
    printf("%-28s         tip %9.2e\n", "warm from another",
           gap(first.tip.p, s.out.tip.p) / FULL_LENGTH);
    CHECK_WITHIN(gap(first.tip.p, s.out.tip.p) / FULL_LENGTH, 0, 10 * SAME);
    solved_free(&s);
    law_along_free(&p.law);
}

int main(void)
{
    against(BY_SYMMETRY, "the same rod turned, moved, in other units, from its other end");
    for (int loads = 0; loads < 2; loads++) {
        turns_and_moves_do_not_matter(loads);
        units_do_not_matter(loads);
        other_end_does_not_matter(loads);
    }
    plane_stays_plane();
    history_does_not_matter();
    return test_failures != 0;
}
