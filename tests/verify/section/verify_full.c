// tests/verify/section/verify_full.c
// The 6x6 with warping against closed forms and against an independent program's numbers (N, mm).
#include "tests/verify/section/hand_meshes.h"

// homogeneous annulus: docs/theory.md (3.7)
static double shear_coefficient(double nu, double m)
{
    const double a = (1 + nu) * (1 + nu) * (1 + m * m) * (1 + m * m);
    const double b = (7 + 14 * nu + 8 * nu * nu) * (1 + m * m) * (1 + m * m) +
                     4 * m * m * (5 + 10 * nu + 4 * nu * nu);
    return 6 * a / b;
}

static void homogeneous_annulus(double nu)
{
    material m[2];
    prototype p;
    prototype_materials(nu, nu, m);
    prototype_set(&p, 1, 0, 0);
    const beam_law law = full_law(&p.all, m, 0);
    const beam_centres c = centres_of(&law);
    const double ro = 4e-3, ri = 3.2e-3, G = 0.66e6 / 2 / (1 + nu);
    const double A = pi * (ro * ro - ri * ri), J = pi / 2 * (pow(ro, 4) - pow(ri, 4));
    const double shear = shear_coefficient(nu, ri / ro) * G * A;

    printf("annulus, nu %.2f: GJ %.3g, shear %.3g and %.3g from closed form\n", nu,
           c.GJ / (G * J) - 1, law.K.a[NX][NX] / shear - 1, law.K.a[NY][NY] / shear - 1);
    // the default mesh's own geometry gives 5e-10
    CHECK_NEAR(c.GJ, G * J, 1e-8);
    CHECK_NEAR(law.K.a[NX][NX], shear, 1e-8);
    CHECK_NEAR(law.K.a[NY][NY], shear, 1e-8);
    CHECK_NEAR(c.EA, 0.66e6 * A, 1e-8);
    CHECK(c.isotropic);
    CHECK_WITHIN(c.shear_centre[0], 0, 1e-12 * ro);
}

// sections.json b: theta_w = pi/8 about pi
static const mat6 constant_nc = {{
    {2.138247702752114, 0, 0, 0, 0, 0},
    {0, 2.86796990887283, 0, 0, 0, -1.5960168842158597},
    {0, 0, 29.21304176918158, 0, 62.02736034231311, 0},
    {0, 0, 0, 81.23604110956464, 0, 0},
    {0, 0, 62.02736034231476, 0, 302.0390668747022, 0},
    {0, -1.5960168842153217, 0, 0, 0, 65.88819989436854},
}};

static void constant_nc_section(double size, double tolerance)
{
    material m[2];
    prototype p;
    prototype_materials(0.3, 0.3, m);
    prototype_set(&p, 2, pi, pi / 8);
    const beam_law law = full_law(&p.all, m, size);
    beam_centres c = {0};
    CHECK_OK(beam_law_centres_near(&law, pi, &c));
    const double miss = mat6_relative_error(law.K, from_mm(constant_nc));
    printf("constant NC, size %.1g: K %.2e, GJ %.7f N mm^2, shear centre %.7f mm\n", size, miss,
           c.GJ * 1e6, c.shear_centre[0] * 1e3);
    CHECK_BELOW(miss, tolerance);
    CHECK_NEAR(c.GJ, 65.0000e-6, 5e-6);
    CHECK_WITHIN(c.shear_centre[0], -0.556497e-3, 1e-9);

    // axial force and bending are the mesh's own integrals where all nu are equal: geometry at
    // 1e-11
    const annulus_closed_form closed =
        annulus_closed(&(annulus_two_materials){4e-3, 3.2e-3, pi, pi / 8, 0.66e6, 15.93e6});
    CHECK_NEAR(c.EA, closed.EA, 1e-9);
    CHECK_NEAR(c.stiffness_centre[0], -closed.r_nc, 1e-9);
    CHECK_NEAR(c.EI[0], closed.EI_centre[0], 1e-9);
    CHECK_NEAR(c.EI[1], closed.EI_centre[1], 1e-9);
    CHECK_NEAR(c.EA, 29.213041767200757, 1e-9);
    CHECK_NEAR(c.EI[0], 81.23604110926298e-6, 1e-9);
    CHECK_NEAR(c.EI[1], 170.33784036586016e-6, 1e-9);
    CHECK_NEAR(remainder(c.principal_angle, pi) + 1, 1, 1e-9);
}

// sections.json bnu: soft nu 0.45, stiff 0.3. The materials' corners at the free edges are
// singular: the reference is good to 1e-4 / 58 and 1e-4 / 29 itself
static void unequal_poisson(void)
{
    static const mat6 wanted = {{
        {1.9171989717429265, 0, 0, 0, 0, 0},
        {0, 2.5725019987149222, 0, 0, 0, -1.4384935273274955},
        {0, 0, 29.215678393197155, 0, 62.03658825673125, 0},
        {0, 0, 0, 81.2376091108135, 0, 0},
        {0, 0, 62.03658825673125, 0, 302.071647904571, 0},
        {0, -1.4384935273274955, 0, 0, 0, 59.195464622345135},
    }};
    material m[2];
    prototype p;
    prototype_materials(0.45, 0.3, m);
    prototype_set(&p, 2, pi, pi / 8);
    const beam_law law = full_law(&p.all, m, 0.4e-3);
    const beam_centres c = centres_of(&law);
    printf("unequal nu: K %.2e, EA %.6f N, GJ %.6f N mm^2\n",
           mat6_relative_error(law.K, from_mm(wanted)), c.EA, c.GJ * 1e6);
    CHECK_BELOW(mat6_relative_error(law.K, from_mm(wanted)), 5e-6);
    CHECK_NEAR(c.GJ, 58.3911e-6, 5e-6);
    CHECK_NEAR(c.EA, 29.2157, 5e-6);
    // not the classical value: equal nu would give 29.213042
    CHECK_ABOVE(fabs(c.EA - 29.213042), 1e-3);
}

// sections.json d1: Saint-Venant's series for a >= b, G = 1
static double rectangle_torsion(double a, double b)
{
    double sum = 0;
    for (int n = 1; n < 200; n += 2) {
        sum += tanh(n * pi * a / (2 * b)) / pow(n, 5);
    }
    return a * b * b * b / 3 * (1 - 192 * b / (pow(pi, 5) * a) * sum);
}

static void rectangle(void)
{
    const material m = {.name = "one", .E = 1, .nu = 0.3};
    outline r = {.kind = KIND_RECTANGLE, .size = {4, 1}};
    const section_outline o = {.count = 1, .items = &r, .size = 2.1};
    const beam_law law = full_law(&o, &m, 0.25);
    const beam_centres c = centres_of(&law);
    printf("rectangle: GJ %.3g from the series, GAx %.7f, GAy %.7f\n",
           c.GJ / (rectangle_torsion(4, 1) / 2.6) - 1, law.K.a[NX][NX], law.K.a[NY][NY]);
    // corners of 90 degrees limit the order to 4: (1/16)^4 of a wall of four elements
    CHECK_NEAR(c.GJ, rectangle_torsion(4, 1) / 2.6, 2e-6);
    CHECK_NEAR(law.K.a[NX][NX], 1.2820102, 1e-6);
    CHECK_NEAR(law.K.a[NY][NY], 0.89800, 3e-6); // the reference's last digit
    CHECK_NEAR(c.EA, 4, 1e-11);
    CHECK_NEAR(c.EI[0], 1.0 / 3, 1e-11);
    CHECK_NEAR(c.EI[1], 16.0 / 3, 1e-11);
}

// sections.json d2: two legs as overlapping rectangles; the re-entrant corner makes GJ converge
// like h^(4/3)
static void angle_section(void)
{
    const material m = {.name = "one", .E = 1, .nu = 0.3};
    outline legs[2] = {{.kind = KIND_RECTANGLE, .size = {6, 1}, .centre = {3, 0.5}},
                       {.kind = KIND_RECTANGLE, .size = {1, 10}, .centre = {0.5, 5}}};
    const section_outline o = {.count = 2, .items = legs, .size = 11.7};
    const beam_law coarse = full_law(&o, &m, 0.5), law = full_law(&o, &m, 0.25),
                   fine = full_law(&o, &m, 0.125);
    const beam_centres c0 = centres_of(&coarse), c1 = centres_of(&law), c2 = centres_of(&fine);
    const double ratio = (c0.GJ - c1.GJ) / (c1.GJ - c2.GJ), gain = pow(2, 4.0 / 3) - 1;
    const double GJ = c2.GJ - (c1.GJ - c2.GJ) / gain;
    printf("angle: GJ %.6f, extrapolated %.6f, order %.3f\n", c2.GJ, GJ, log2(ratio));
    CHECK_NEAR(log2(ratio), 4.0 / 3, 0.05);
    CHECK_NEAR(GJ, 1.87017, 2e-5 / 1.87);
    CHECK_NEAR(fine.K.a[NX][NX], 1.8007, 1e-4);
    CHECK_NEAR(fine.K.a[NY][NY], 3.2707, 1e-4);
    CHECK_WITHIN(c2.shear_centre[0], 0.48483, 1e-4);
    CHECK_WITHIN(c2.shear_centre[1], 0.65591, 1e-4);
    CHECK_NEAR(c2.EA, 15, 1e-10);
    CHECK_NEAR(c2.stiffness_centre[0], 1.5, 1e-10);
    CHECK_NEAR(c2.stiffness_centre[1], 3.5, 1e-10);
    CHECK_NEAR(c2.EI_centre[0], 151.25, 1e-10);
    CHECK_NEAR(c2.EI_centre[1], 41.25, 1e-10);
    CHECK_NEAR(c2.EI_centre[2], -45, 1e-10);
    CHECK_NEAR(c2.principal_angle * 180 / pi, 19.64470343125018 - 90, 1e-10);
}

int main(void)
{
    against(BY_OTHER_CODE, "6x6 of an independent finite-element code, good to 1e-6");
    against(BY_CLOSED_FORM, "annulus: GJ, and shear by theory (3.7)");
    homogeneous_annulus(0.3);
    homogeneous_annulus(0.45);
    against(BY_OTHER_CODE, "6x6 of an independent finite-element code, good to 1e-6");
    // the default mesh, fine where materials meet, is within 3e-8 of the reference, whose own error
    // is 1e-6; so is one of two elements through the wall
    constant_nc_section(0, 2e-6);
    constant_nc_section(0.4e-3, 2e-6);
    unequal_poisson();
    against(BY_CLOSED_FORM, "Saint-Venant's series of a rectangle");
    rectangle();
    against(BY_OTHER_CODE, "GJ of an angle, extrapolated by an independent code");
    angle_section();
    return test_failures != 0;
}
