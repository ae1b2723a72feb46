// tests/unit/rodsolver/test_rod.c
#include "tests/unit/rodsolver/prototypes.h"

#include <string.h>

static double uniform(unsigned *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (*state >> 8) / 16777216.0;
}

static void unloaded_rod_is_straight(int frame)
{
    const prototype p = helical_nc();
    law_along law = {0};
    prototype_law(&p, &law);
    const tendon_spec t = straight_tendon("a", 3.6e-3, 1);
    double none = 0, length = 0;
    rod_solution out = {.tendon_length = &length};
    const made_rod r =
        solved_rod(&law, 1, &t, (rod_options){.frame = frame, .tolerance = 1e-12}, &none, &out);
    CHECK_WITHIN(distance(out.tip.p, (vec3){{0, 0, p.length}}), 0, 1e-12 * p.length);
    CHECK_WITHIN(rotation_difference(out.tip.R, mat3_identity()), 0, 1e-11);
    CHECK_NEAR(length, p.length, 1e-14);
    free_rod(r);
    law_along_free(&law);
}

// homogeneous tube: eps = -tau / EA, kappa = tau r / EI, an arc of a circle of length (1 + eps) L
static void homogeneous_tube_bends_into_a_circle(void)
{
    const prototype p = homogeneous_tube();
    const prototype_section q = prototype_integrals(&p, 0);
    law_along law = {0};
    prototype_law(&p, &law);
    const tendon_spec t = straight_tendon("a", 3.6e-3, 0);
    const double tau = 0.7, L = p.length;
    const double eps = -tau / q.EA, kappa = tau * 3.6e-3 / q.EIy;
    double length = 0;
    rod_solution out = {.tendon_length = &length};
    const made_rod r = solved_rod(&law, 1, &t, (rod_options){.tolerance = 1e-9}, &tau, &out);
    CHECK_WITHIN(out.tip.p.a[0], (1 + eps) / kappa * (1 - cos(kappa * L)), 1e-15);
    CHECK_WITHIN(out.tip.p.a[2], (1 + eps) / kappa * sin(kappa * L), 1e-15);
    CHECK_NEAR(length, L * (1 + eps - kappa * 3.6e-3), 1e-13);
    CHECK_NEAR(out.max_strain.a[4], kappa, 1e-13);
    CHECK_NEAR(out.max_strain.a[2], -eps, 1e-13);
    CHECK(out.relative_error < 1e-14);
    free_rod(r);
    law_along_free(&law);
}

// a tendon that ends at a third of the rod: bent so far, straight beyond
static void beyond_its_end_a_tendon_does_nothing(void)
{
    const prototype p = homogeneous_tube();
    law_along law = {0};
    prototype_law(&p, &law);
    tendon_spec t[2] = {straight_tendon("short", 3.6e-3, 0),
                        straight_tendon("long", 3.6e-3, PROTOTYPE_PI)};
    t[0].end = 0.04;
    const double tau[2] = {0.7, 0};
    double s[4];
    pose shape[4];
    vec6 xi;
    rod_solution out = {0};
    const made_rod r = solved_rod(&law, 2, t, (rod_options){.tolerance = 1e-9}, tau, &out);
    CHECK_OK(rod_shape(r.state, 4, s, shape));
    CHECK_WITHIN(rotation_difference(shape[1].R, shape[3].R), 0, 1e-14);
    CHECK_NEAR(distance(shape[1].p, shape[3].p), 0.08, 1e-13);
    CHECK(rotation_difference(shape[0].R, shape[1].R) > 0.1);
    CHECK_OK(rod_strain_at(r.state, 0.041, &xi));
    CHECK_WITHIN(xi.a[4], 0, 1e-12);
    CHECK_OK(rod_strain_at(r.state, 0.039, &xi));
    CHECK_NEAR(xi.a[4], out.max_strain.a[4], 1e-10);
    // both pull: antagonists cancel up to the end, and the long one bends the rest
    const double both[2] = {0.7, 0.7};
    CHECK_OK(solve_tensions(r.state, both, &out));
    CHECK_OK(rod_shape(r.state, 4, s, shape));
    CHECK_WITHIN(rotation_difference(shape[1].R, mat3_identity()), 0, 1e-13);
    CHECK(rotation_difference(shape[3].R, mat3_identity()) > 0.1);
    free_rod(r);
    law_along_free(&law);
}

// the shape between panel edges: its first and last points, its tangents, and a rod that is cut
// there
static void shape_is_as_good_as_the_tip(int frame)
{
    enum { POINTS = 31 };
    const prototype p = helical_nc();
    law_along law = {0};
    prototype_law(&p, &law);
    const tendon_spec t = straight_tendon("a", 3.6e-3, PROTOTYPE_PI / 2);
    const double tau = 0.98;
    rod_solution out = {0}, fine = {0};
    const made_rod r =
        solved_rod(&law, 1, &t, (rod_options){.frame = frame, .tolerance = 1e-9}, &tau, &out);
    const made_rod f =
        solved_rod(&law, 1, &t, (rod_options){.frame = frame, .npanel = 240}, &tau, &fine);
    double s[POINTS];
    pose shape[POINTS], wanted[POINTS];
    CHECK_OK(rod_shape(r.state, POINTS, s, shape));
    CHECK_OK(rod_shape(f.state, POINTS, s, wanted));
    CHECK_WITHIN(distance(shape[0].p, (vec3){{0}}), 0, 1e-16);
    CHECK_WITHIN(distance(shape[POINTS - 1].p, out.tip.p), 0, 1e-15);
    CHECK(s[POINTS - 1] == p.length);
    for (int i = 0; i < POINTS; i++) {
        CHECK_WITHIN(distance(shape[i].p, wanted[i].p), 0, 1e-9 * p.length);
        CHECK_WITHIN(rotation_difference(shape[i].R, wanted[i].R), 0, 1e-8);
    }
    // half of the rod is a rod of its own: the middle from cutting the law there
    CHECK_WITHIN(shape[15].p.a[0], -0.02418314919928287, 1e-9);
    CHECK_WITHIN(shape[15].p.a[1], 0.03415454744841623, 1e-9);
    CHECK_WITHIN(shape[15].p.a[2], 0.032364148805866605, 1e-9);
    free_rod(r);
    free_rod(f);
    law_along_free(&law);
}

// the strain at s against the shape's own derivative there, body frame: v = R^T p'
static void strain_is_the_derivative_of_the_shape(int frame)
{
    enum { POINTS = 601 };
    const prototype p = helical_nc();
    law_along law = {0};
    prototype_law(&p, &law);
    const tendon_spec t[2] = {straight_tendon("a", 3.6e-3, PROTOTYPE_PI / 2),
                              straight_tendon("b", 3.6e-3, 0.3)};
    const double tau[2] = {0.98, 0.2};
    rod_solution out = {0};
    const made_rod r =
        solved_rod(&law, 2, t, (rod_options){.frame = frame, .npanel = 64}, tau, &out);
    static double s[POINTS];
    static pose g[POINTS];
    CHECK_OK(rod_shape(r.state, POINTS, s, g));
    for (int i = 50; i < POINTS - 1; i += 100) {
        vec6 xi;
        CHECK_OK(rod_strain_at(r.state, s[i], &xi));
        const double h = s[i + 1] - s[i - 1];
        // central differences of order 2 with a step of 0.2 mm: about 1e-4 of the strain's scale
        const vec3 v = mat3_tmul_vec(g[i].R, vec3_scale(1 / h, vec3_sub(g[i + 1].p, g[i - 1].p)));
        const vec3 w = vec3_scale(1 / h, so3_log(mat3_mul(mat3_transpose(g[i - 1].R), g[i + 1].R)));
        for (int c = 0; c < 3; c++) {
            CHECK_WITHIN(v.a[c], xi.a[c], 1e-4);
            CHECK_WITHIN(w.a[c], xi.a[c + 3], 0.02);
        }
    }
    free_rod(r);
    law_along_free(&law);
}

static void impossible_tensions_are_refused(void)
{
    const prototype p = homogeneous_tube();
    const prototype_section q = prototype_integrals(&p, 0);
    law_along law = {0};
    prototype_law(&p, &law);
    const tendon_spec t[2] = {straight_tendon("left", 3.6e-3, 0),
                              straight_tendon("right", 3.6e-3, PROTOTYPE_PI)};
    rod_solution out = {0};
    const made_rod r = make_rod(&law, 2, t, (rod_options){.tolerance = 1e-9});
    const double critical = 1 / (1 / q.EA + 3.6e-3 * 3.6e-3 / q.EIx);
    CHECK_NEAR(rod_critical_tension(r.rod, 1, NULL), critical, 1e-12);

    const double below[2] = {0, critical * (1 - 1e-6)}, above[2] = {0, critical * (1 + 1e-6)};
    const double negative[2] = {0.1, -0.1}, infinite[2] = {INFINITY, 0};
    const double both[2] = {critical * 0.9, 2 * critical};
    CHECK_OK(solve_tensions(r.state, below, &out));
    CHECK(solve_tensions(r.state, above, &out) == ERR_NUMERIC);
    CHECK(strstr(status_message(), "'right' has eaten its own length") != NULL);
    status_clear();
    CHECK(solve_tensions(r.state, both, &out) == ERR_NUMERIC);
    CHECK(strstr(status_message(), "eaten") != NULL);
    status_clear();
    CHECK(solve_tensions(r.state, negative, &out) == ERR_INPUT);
    status_clear();
    CHECK(solve_tensions(r.state, infinite, &out) == ERR_INPUT);
    status_clear();
    double s[2];
    pose g[2];
    CHECK(rod_shape(r.state, 2, s, g) == ERR_BUG); // nothing solved to show
    status_clear();
    free_rod(r);
    law_along_free(&law);
}

static status attempt(const law_along *law, const tendon_spec *t, double tolerance)
{
    rod *r = NULL;
    const rod_spec spec = {.law = law, .ntendon = t ? 1 : 0, .tendons = t};
    const status st = rod_make(&spec, &(rod_options){.tolerance = tolerance}, &r);
    CHECK(r == NULL);
    rod_free(r);
    status_clear();
    return st;
}

static void bad_rods_are_refused(void)
{
    const prototype p = homogeneous_tube();
    law_along law = {0};
    prototype_law(&p, &law);
    tendon_spec t = straight_tendon("a", 3.6e-3, 0);
    t.end = 0.121;
    CHECK(attempt(&law, &t, 1e-9) == ERR_INPUT);
    t.end = 0;
    CHECK(attempt(&law, &t, 1e-17) == ERR_INPUT);
    t.friction = -0.1;
    CHECK(attempt(&law, &t, 1e-9) == ERR_INPUT);
    t.friction = 0;
    t.EA = NAN;
    CHECK(attempt(&law, &t, 1e-9) == ERR_INPUT);
    t.EA = 0;
    t.x = field_constant(NAN);
    CHECK(attempt(&law, &t, 1e-9) == ERR_INPUT);
    law.law[0].K = mat6_scale(-1, law.law[0].K);
    CHECK(attempt(&law, NULL, 1e-9) == ERR_NUMERIC);
    law_along_free(&law);
}

static double wave(const void *expression, double s)
{
    return *(const double *)expression * s + 0.3 * sin(90 * s);
}

// the share of `direction` that can just be pulled, by bisection on the refusal
static double limit_along(made_rod r, int n, const double *direction)
{
    double low = 0, high = 50, tension[4];
    rod_solution out = {0};
    for (int k = 0; k < 40; k++) {
        const double middle = (low + high) / 2;
        for (int i = 0; i < n; i++) {
            tension[i] = middle * direction[i];
        }
        if (solve_tensions(r.state, tension, &out) == OK) {
            low = middle;
        } else {
            high = middle;
        }
        status_clear();
    }
    return low;
}

// four tendons of any routing, random tensions: up to 95 % of what can be pulled in that direction
// all converge within the tolerance, and the limit is a refusal that names a tendon
static void random_tensions_converge_up_to_the_limit(void)
{
    const prototype p = helical_nc();
    const double rate[2] = {20, -35};
    law_along law = {0};
    prototype_law(&p, &law);
    tendon_spec t[4] = {straight_tendon("a", 3.6e-3, 0), straight_tendon("b", 3.6e-3, 2),
                        straight_tendon("c", 3.6e-3, 0), straight_tendon("d", 3.6e-3, 0)};
    t[1].end = 0.07;
    t[2].angle = (field){.at = wave, .expression = &rate[0]};
    t[3].angle = (field){.at = wave, .expression = &rate[1]};
    unsigned state = 1;
    const made_rod r = make_rod(&law, 4, t, (rod_options){.tolerance = 1e-6});
    for (int k = 0; k < 12; k++) {
        double direction[4], tension[4];
        rod_solution out = {0};
        for (int i = 0; i < 4; i++) {
            direction[i] = uniform(&state) < 0.3 ? 0 : uniform(&state);
        }
        direction[k % 4] = 1;
        const double limit = limit_along(r, 4, direction);
        CHECK(limit > 0.5 && limit < 49);
        for (int j = 1; j <= 4; j++) {
            for (int i = 0; i < 4; i++) {
                tension[i] = (j < 4 ? 0.3 * j + 0.05 : 1.001) * limit * direction[i];
            }
            const status st = solve_tensions(r.state, tension, &out);
            if (j < 4) {
                CHECK(st == OK && out.relative_error <= 1e-6);
            } else {
                CHECK(st == ERR_NUMERIC && strstr(status_message(), "eaten its own length"));
            }
            status_clear();
        }
    }
    free_rod(r);
    law_along_free(&law);
}

// the plan depends on the tensions only, not on what was solved before
static void the_same_tension_gives_the_same_bits(void)
{
    const prototype p = helical_nc();
    law_along law = {0};
    prototype_law(&p, &law);
    const tendon_spec t = straight_tendon("a", 3.6e-3, PROTOTYPE_PI / 2);
    const double tau = 0.98, strong = 4;
    rod_solution first = {0}, again = {0};
    const made_rod r = solved_rod(&law, 1, &t, (rod_options){.tolerance = 1e-8}, &tau, &first);
    CHECK_OK(solve_tensions(r.state, &strong, &again));
    CHECK(rod_panel_count(r.state) > 16);
    CHECK_OK(solve_tensions(r.state, &tau, &again));
    CHECK(memcmp(&first.tip, &again.tip, sizeof first.tip) == 0);
    free_rod(r);
    law_along_free(&law);
}

// K(s) of a section without any symmetry that tapers and turns: centre off both axes, principal
// axes at an angle of their own
static mat6 lopsided(double t)
{
    const prototype p = constant_nc();
    const prototype_section q = prototype_integrals(&p, PROTOTYPE_PI / 4 * (1 - t / 3));
    const double diagonal[6] = {
        q.EA / 3, q.EA / 4, q.EA, q.EIx * (1 - 0.3 * t), q.EIy * (2 + 0.5 * t), q.GJ};
    mat6 K = {0};
    for (int i = 0; i < 6; i++) {
        K.a[i][i] = diagonal[i];
    }
    K = beam_law_move(K, 0, 0, -0.7 * t * t);
    return beam_law_move(K, -1.5e-3 * cos(t), -1e-3 * sin(2 * t) - 0.4e-3, 0);
}

// the same rod along two curves: every term of the stiffness-centre frame and its rates takes part
static void frames_agree_without_symmetry(void)
{
    law_along law = {0};
    CHECK_OK(law_along_make(0.12, 1, 25, &law));
    for (int i = 0; i < law.nnode; i++) {
        const double t = law_along_node(&law, 0, i) / law.length;
        law.law[i].K = lopsided(t);
        law.turn[i] = 2 * t;
    }
    const tendon_spec t[2] = {straight_tendon("a", 3.6e-3, 1), straight_tendon("b", 3.6e-3, 4)};
    const double tau[2] = {0.9, 0.3};
    rod_solution out[2] = {0};
    for (int frame = FRAME_GC; frame <= FRAME_NC; frame++) {
        const made_rod r = solved_rod(&law, 2, t, (rod_options){.frame = frame, .tolerance = 1e-12},
                                      tau, &out[frame]);
        free_rod(r);
    }
    CHECK_WITHIN(distance(out[FRAME_GC].tip.p, out[FRAME_NC].tip.p), 0, 1e-12);
    CHECK_WITHIN(rotation_difference(out[FRAME_GC].tip.R, out[FRAME_NC].tip.R), 0, 1e-11);
    CHECK(fabs(out[FRAME_GC].tip.p.a[0]) > 1e-3 && fabs(out[FRAME_GC].tip.p.a[1]) > 1e-3);
    law_along_free(&law);
}

int main(void)
{
    for (int frame = FRAME_GC; frame <= FRAME_NC; frame++) {
        unloaded_rod_is_straight(frame);
        shape_is_as_good_as_the_tip(frame);
        strain_is_the_derivative_of_the_shape(frame);
    }
    homogeneous_tube_bends_into_a_circle();
    beyond_its_end_a_tendon_does_nothing();
    impossible_tensions_are_refused();
    bad_rods_are_refused();
    random_tensions_converge_up_to_the_limit();
    the_same_tension_gives_the_same_bits();
    frames_agree_without_symmetry();
    return test_failures != 0;
}
