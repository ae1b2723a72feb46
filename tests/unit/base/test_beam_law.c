// tests/unit/base/test_beam_law.c
#include "base/beam_law.h"
#include "tests/test.h"

static const double pi = 3.14159265358979323846;

// a section with centre (x, y), moments EIx <= EIy about axes turned by phi, shears and torsion
// about its own shear centre
static mat6 section(double EA, double EIx, double EIy, double x, double y, double phi)
{
    mat6 K = {0};
    const double diagonal[6] = {3, 4, EA, EIx, EIy, 2};
    for (int i = 0; i < 6; i++) {
        K.a[i][i] = diagonal[i];
    }
    // K is given at the centre: seen from the origin, which lies at -R^T p
    K = beam_law_move(K, 0, 0, -phi);
    return beam_law_move(K, -x, -y, 0);
}

// Steiner: a move by a along x adds EA a^2 to bending about y and GA a^2 to twist
static void move_adds_the_steiner_term(void)
{
    const double a = 0.5;
    mat6 K = {0};
    const double k[6] = {3, 4, 10, 5, 6, 2};
    for (int i = 0; i < 6; i++) {
        K.a[i][i] = k[i];
    }
    const mat6 moved = beam_law_move(K, -a, 0, 0);
    CHECK_NEAR(moved.a[MY][MY], 6 + 10 * a * a, 1e-14);
    CHECK_NEAR(moved.a[MZ][MZ], 2 + 4 * a * a, 1e-14);
    CHECK_NEAR(moved.a[NZ][MY], -10 * a, 1e-14); // centre at x = +a
    CHECK_NEAR(moved.a[NY][MZ], 4 * a, 1e-14);
}

static void centres_find_what_the_section_was_made_of(void)
{
    for (int i = 0; i < 7; i++) {
        const double phi = -pi / 2 + pi * (i + 1) / 7, x = 0.3, y = -0.2;
        const beam_law law = {.K = section(10, 5, 7, x, y, phi)};
        beam_centres c = {0};
        CHECK_OK(beam_law_centres(&law, &c));
        CHECK_NEAR(c.EA, 10, 1e-13);
        CHECK_NEAR(c.stiffness_centre[0], x, 1e-13);
        CHECK_NEAR(c.stiffness_centre[1], y, 1e-13);
        CHECK_NEAR(c.EI[0], 5, 1e-13);
        CHECK_NEAR(c.EI[1], 7, 1e-13);
        CHECK_WITHIN(c.principal_angle, phi, 1e-13);
        CHECK_WITHIN(c.EI_centre[2], sin(2 * phi), 1e-13);
        CHECK_NEAR(c.GJ, 2, 1e-13);
        CHECK_NEAR(c.shear_centre[0], x, 1e-13);
        CHECK_NEAR(c.shear_centre[1], y, 1e-13);
        CHECK(!c.isotropic);
    }
}

// the constant-NC section with warping, mm and N: independent solver's figures, torsion at the
// shear centre
static void shear_centre_of_the_constant_section(void)
{
    beam_law law = {0};
    const double diagonal[6] = {2.138247702752114, 2.86796990887283,  29.21304176918158,
                                81.23604110956464, 302.0390668747022, 65.88819989436854};
    for (int i = 0; i < 6; i++) {
        law.K.a[i][i] = diagonal[i];
    }
    law.K.a[NZ][MY] = law.K.a[MY][NZ] = 62.02736034231311;
    law.K.a[NY][MZ] = law.K.a[MZ][NY] = -1.5960168842158597;
    beam_centres c = {0};
    CHECK_OK(beam_law_centres(&law, &c));
    CHECK_WITHIN(c.stiffness_centre[0], -2.123276337844983, 1e-9);
    CHECK_NEAR(c.EI[0], 81.23604110926298, 1e-9);
    CHECK_NEAR(c.EI[1], 170.33784036586016, 1e-9);
    CHECK_NEAR(c.GJ, 65.0000, 1e-6);
    CHECK_WITHIN(c.shear_centre[0], -0.556497, 1e-6);
    CHECK_WITHIN(c.shear_centre[1], 0, 1e-12);
}

static void angle_near_a_declared_axis_is_not_reduced(void)
{
    const beam_law law = {.K = section(10, 5, 7, 0.1, 0, 0.2)};
    beam_centres c = {0};
    CHECK_OK(beam_law_centres_near(&law, 0.2 + pi, &c));
    CHECK_NEAR(c.principal_angle, 0.2 + pi, 1e-13);
    CHECK_NEAR(c.EI[1], 7, 1e-13);
    // the other axis, for a pattern whose symmetry axis has the smaller moment
    CHECK_OK(beam_law_centres_near(&law, 0.2 - pi / 2 + 0.1, &c));
    CHECK_NEAR(c.principal_angle, 0.2 - pi / 2, 1e-13);
    CHECK_NEAR(c.EI[0], 7, 1e-13);
    CHECK_NEAR(c.EI[1], 5, 1e-13);
}

static void equal_moments_have_no_axes(void)
{
    const beam_law law = {.K = section(10, 6, 6 * (1 + 1e-9), 0.1, 0, 0.7)};
    beam_centres c = {0};
    CHECK_OK(beam_law_centres(&law, &c));
    CHECK(c.isotropic);
    CHECK(c.principal_angle == 0);
    CHECK_OK(beam_law_centres_near(&law, 1.25, &c));
    CHECK(c.principal_angle == 1.25);
    CHECK_NEAR(c.EI[0], 6, 1e-8);
}

static void bad_stiffness_is_refused(void)
{
    beam_law law = {.K = section(10, 5, 7, 0.1, 0, 0)};
    CHECK(beam_law_check(&law) == OK);
    law.K.a[NX][NY] += 1e-6;
    CHECK(beam_law_check(&law) == ERR_NUMERIC);
    status_clear();
    law.K.a[NY][NX] = law.K.a[NX][NY] = 4;
    CHECK(beam_law_check(&law) == ERR_NUMERIC);
    status_clear();
    law.K.a[NX][NY] = law.K.a[NY][NX] = NAN;
    CHECK(beam_law_check(&law) == ERR_NUMERIC);
    status_clear();
    law.K = mat6_scale(-1, section(10, 5, 7, 0.1, 0, 0));
    beam_centres c = {0};
    CHECK(beam_law_centres(&law, &c) == ERR_NUMERIC);
    status_clear();
}

// seen from a frame turned by a quarter, the centre of mass is turned back by one
static void mass_centre_turns_with_the_frame(void)
{
    beam_law law = {.K = mat6_identity(), .mass = 3, .mass_centre = {2, 1}};
    const beam_law turned = beam_law_turn(law, acos(0));
    CHECK(turned.mass == 3);
    CHECK_WITHIN(turned.mass_centre[0], 1, 1e-15);
    CHECK_WITHIN(turned.mass_centre[1], -2, 1e-15);
}

int main(void)
{
    mass_centre_turns_with_the_frame();
    move_adds_the_steiner_term();
    centres_find_what_the_section_was_made_of();
    shear_centre_of_the_constant_section();
    angle_near_a_declared_axis_is_not_reduced();
    equal_moments_have_no_axes();
    bad_stiffness_is_refused();
    return test_failures != 0;
}
