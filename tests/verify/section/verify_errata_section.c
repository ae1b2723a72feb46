// tests/verify/section/verify_errata_section.c
// Rows marked T of the paper's errata that concern the section: the right form, and the printed one
// giving another number.
#include "tests/verify/section/hand_meshes.h"

static const double E1 = 0.66e6, E2 = 15.93e6, ro = 4e-3, ri = 3.2e-3,
                    width = 3.14159265358979323846 / 8;

static annulus_closed_form closed(double w)
{
    return annulus_closed(&(annulus_two_materials){
        .outer = ro, .inner = ri, .mid_angle = pi, .width = w, .E_soft = E1, .E_stiff = E2});
}

static beam_law solve(int model)
{
    material m[2];
    prototype p;
    beam_law law = {0};
    bool done = false;
    prototype_materials(0.3, 0.3, m);
    prototype_set(&p, 2, pi, width);
    if (model == MODEL_FULL) {
        return full_law(&p.all, m, 0.4e-3);
    }
    CHECK_OK(section_classical_closed(&p.all, m, &law, &done));
    CHECK(done);
    return law;
}

// Table I: the text's 22.5 degrees and Fig. 4's r_nc = 2.12 mm need theta_w = pi/8
static void table_one_width(void)
{
    CHECK_WITHIN(closed(pi / 8).r_nc, 2.12e-3, 0.005e-3);
    CHECK_WITHIN(closed(pi / 16).r_nc, 1.514e-3, 0.0005e-3);
}

// Eq. 14 prints E x^2 for m_x: the mesh with warping, which knows no such formula, says E y^2
static void eq_14_bending_entries(void)
{
    const beam_law law = solve(MODEL_FULL);
    const annulus_closed_form c = closed(width);
    const double Exx = c.EI_centre[1] + c.EA * c.r_nc * c.r_nc; // int E x^2 at GC, symmetry axis x
    CHECK_NEAR(law.K.a[MX][MX], c.EI_centre[0], 1e-9);
    CHECK_NEAR(law.K.a[MY][MY], Exx, 1e-9);
    CHECK_NEAR(Exx / law.K.a[MX][MX], 3.718, 1e-3);
}

// Eq. 19, second line as printed
static void eq_19_second_line(void)
{
    const double rest = 2 * pi - width;
    const double radii = (pow(ro, 3) - pow(ri, 3)) / (ro * ro - ri * ri);
    const double printed =
        4.0 / 3 * sin(width / 2) * radii * (E1 * width - E2 * rest) / (E1 * width + E2 * rest);
    CHECK_WITHIN(printed, -1.403e-3, 0.0005e-3);
    CHECK_WITHIN(closed(width).r_nc, 2.123276337844983e-3, 1e-15);

    // the first line: the two centroids weighted with E, that of the stiff sector by the corrected
    // Eq. 18
    const double stiff =
        4 * sin(width / 2) * (pow(ro, 3) - pow(ri, 3)) / (3 * width * (ro * ro - ri * ri));
    const double soft = -stiff * width / rest;
    const double first = (E2 * width * stiff + E1 * rest * soft) / (E2 * width + E1 * rest);
    CHECK_NEAR(first, closed(width).r_nc, 1e-13);
}

// int over radii and angles a to b of (r cos - c)^2 r, by its antiderivative
static double second_moment(double c, double a, double b)
{
    const double r4 = (pow(ro, 4) - pow(ri, 4)) / 4, r3 = (pow(ro, 3) - pow(ri, 3)) / 3;
    const double r2 = (ro * ro - ri * ri) / 2;
    return r4 * ((b - a) / 2 + (sin(2 * b) - sin(2 * a)) / 4) - 2 * c * r3 * (sin(b) - sin(a)) +
           c * c * r2 * (b - a);
}

// Eq. 20: limits theta_m -+ theta_w/2 count the angle from the x axis, the integrand from the axis
// of symmetry
static void eq_20_limits(void)
{
    const double c = closed(width).r_nc, half = width / 2;
    const double right =
        E2 * second_moment(c, -half, half) + E1 * second_moment(c, half, 2 * pi - half);
    CHECK_NEAR(right, closed(width).EI_centre[1], 1e-13);
    CHECK_NEAR(right, 170.33784036586016e-6, 1e-12);
    const double printed = E2 * second_moment(c, pi - half, pi + half) +
                           E1 * second_moment(c, pi + half, 3 * pi - half);
    printf("Eq. 20: %.4f N mm^2, with the printed limits %.4f\n", right * 1e6, printed * 1e6);
    CHECK_ABOVE(printed, 3 * right);
}

static void eq_12_torsion(void)
{
    const beam_law paper = solve(MODEL_CLASSICAL), law = solve(MODEL_FULL);
    CHECK_WITHIN(centres_of(&paper).GJ, 96.76e-6, 0.005e-6);
    CHECK_WITHIN(centres_of(&law).GJ, 65.00e-6, 0.001e-6);
}

static void eq_12_shear(void)
{
    const beam_law paper = solve(MODEL_CLASSICAL), law = solve(MODEL_FULL);
    const beam_centres a = centres_of(&paper), b = centres_of(&law);
    CHECK_WITHIN(paper.K.a[NX][NX], 11.24, 0.005);
    CHECK_WITHIN(paper.K.a[NY][NY], 11.24, 0.005);
    CHECK_WITHIN(law.K.a[NX][NX], 2.138, 0.0005);
    CHECK_WITHIN(law.K.a[NY][NY], 2.868, 0.0005);

    // the paper's shear centre is NC
    CHECK_WITHIN(a.stiffness_centre[0], -2.1233e-3, 1e-7);
    CHECK_WITHIN(a.shear_centre[0], -2.1233e-3, 1e-7);
    CHECK_WITHIN(b.stiffness_centre[0], -2.1233e-3, 1e-7);
    CHECK_WITHIN(b.shear_centre[0], -0.5565e-3, 1e-7);
}

// homogeneous annulus: 4.593 N printed, 2.343 N with warping
static void eq_12_shear_of_a_tube(void)
{
    material m[2];
    prototype p;
    beam_law paper = {0};
    bool done = false;
    prototype_materials(0.3, 0.3, m);
    prototype_set(&p, 1, 0, 0);
    CHECK_OK(section_classical_closed(&p.all, m, &paper, &done));
    CHECK_WITHIN(paper.K.a[NX][NX], 4.593, 0.0005);
    CHECK_WITHIN(full_law(&p.all, m, 0).K.a[NX][NX], 2.343, 0.0005);
    // torsion of an axisymmetric section is right in the paper
    CHECK_NEAR(centres_of(&paper).GJ, 60.26661217321418e-6, 1e-12);
}

int main(void)
{
    against(BY_CLOSED_FORM,
            "the paper's Eq. 12 to 20, corrected, and the printed forms beside them: theory (2.6)");
    table_one_width();
    eq_14_bending_entries();
    eq_19_second_line();
    eq_20_limits();
    eq_12_torsion();
    eq_12_shear();
    eq_12_shear_of_a_tube();
    return test_failures != 0;
}
