// tests/verify/section/verify_materials.c
// The full model with graded and directed materials against exact solutions.
#include "section/section.h"
#include "tests/shapes.h"
#include "tests/test.h"

// the solutions below are polynomials that the elements hold: rounding of the solves is left
static const double SOLVED = 1e-10;
// circles drawn by elements of order 4
static const double CURVED = 1e-9;

static const double ratio = 0.35;

static material glass(double plane_angle, double fibre_angle)
{
    material m = {.name = "glass",
                  .E1 = 41e9,
                  .E2 = 10.4e9,
                  .E3 = 9.1e9,
                  .G12 = 4.3e9,
                  .G13 = 3.1e9,
                  .G23 = 3.5e9,
                  .nu12 = 0.28,
                  .nu13 = 0.31,
                  .nu23 = 0.45,
                  .plane_angle = plane_angle,
                  .fibre_angle = fibre_angle};
    CHECK_OK(material_bind(&m));
    return m;
}

static beam_law law_of_size(const shape_spec *shape, int kind, double size, const material *m)
{
    mesh made = {0};
    beam_law law = {0};
    CHECK_OK(mesh_of(1, shape, kind, 4, size, &made));
    CHECK_OK(section_full_mesh(&made, m, &law, NULL));
    mesh_free(&made);
    return law;
}

static beam_law law_of(const shape_spec *shape, int kind, const material *m)
{
    return law_of_size(shape, kind, 0, m);
}

static mat6 compliance(const beam_law *law)
{
    mat6 F = {0};
    CHECK(mat6_inverse_spd(law->K, &F));
    return F;
}

// --- graded

static double plane_modulus(const void *unused, double x, double y, double s)
{
    (void)unused, (void)s;
    return 3e6 + 2e8 * x + 5e8 * y;
}

static double round_modulus(const void *unused, double x, double y, double s)
{
    (void)unused, (void)s;
    return 1e6 + 3e11 * (x * x + y * y);
}

static material graded(double (*at)(const void *, double, double, double))
{
    material m = {.name = "graded", .nu = ratio, .modulus = {.at = at, .across = true}};
    CHECK_OK(material_bind(&m));
    return m;
}

// one Poisson's ratio: stretch and bending keep sections plane, whatever E(x, y)
static void a_graded_bar_stretches_and_bends_by_its_integrals(void)
{
    const double w = 0.01, h = 0.004, A = w * h, Iyy = A * w * w / 12, Ixx = A * h * h / 12;
    const double a = 3e6, b = 2e8, c = 5e8;
    const double x = b * Iyy / (a * A), y = c * Ixx / (a * A);
    const material m = graded(plane_modulus);
    const shape_spec bar = a_rectangle(w, h, 0, 0, 0, 0);
    const beam_law law = law_of(&bar, MESH_MAPPED, &m);
    beam_centres centres = {0};
    CHECK_OK(beam_law_centres(&law, &centres));
    CHECK_NEAR(centres.EA, a * A, SOLVED);
    CHECK_NEAR(centres.stiffness_centre[0], x, SOLVED);
    CHECK_NEAR(centres.stiffness_centre[1], y, SOLVED);
    CHECK_NEAR(centres.EI_centre[0], a * Ixx - a * A * y * y, SOLVED);
    CHECK_NEAR(centres.EI_centre[1], a * Iyy - a * A * x * x, SOLVED);
}

// G over the radius alone: circles stay circles, GJ = int G r^2
static void a_disc_graded_over_its_radius_twists_by_its_integral(void)
{
    const double r = 4e-3, shear = 2 * (1 + ratio);
    const material m = graded(round_modulus);
    const shape_spec disc = a_disc(r, 0, 0, 0);
    const beam_law law = law_of(&disc, MESH_FREE, &m);
    beam_centres centres = {0};
    CHECK_OK(beam_law_centres(&law, &centres));
    CHECK_NEAR(centres.GJ, 2 * PI * (1e6 * pow(r, 4) / 4 + 3e11 * pow(r, 6) / 6) / shear, CURVED);
    CHECK_NEAR(centres.EA, PI * (1e6 * r * r + 3e11 * pow(r, 4) / 2), CURVED);
}

// --- directed

// Uniform and linear axial stresses alone satisfy all equations in any homogeneous bar: with the
// material's compliance S, docs/theory.md (2.10)
static void an_off_axis_bar_follows_its_compliance(void)
{
    enum { ZZ = 2, YZ = 3, XZ = 4 };
    const double angle[][2] = {{0, 0.6}, {0.5, -0.9}, {1.3, 0.2}};
    const double w = 0.01, h = 0.004, A = w * h, Iyy = A * w * w / 12, Ixx = A * h * h / 12;
    const shape_spec bar = a_rectangle(w, h, 0, 0, 0, 0);
    for (int i = 0; i < 3; i++) {
        const material m = glass(angle[i][0], angle[i][1]);
        mat6 S = {0};
        CHECK(mat6_inverse_spd(material_stiffness(&m), &S));
        const beam_law law = law_of(&bar, MESH_MAPPED, &m);
        const mat6 F = compliance(&law);
        CHECK_NEAR(F.a[NZ][NZ], S.a[ZZ][ZZ] / A, SOLVED);
        CHECK_NEAR(F.a[MX][MX], S.a[ZZ][ZZ] / Ixx, SOLVED);
        CHECK_NEAR(F.a[MY][MY], S.a[ZZ][ZZ] / Iyy, SOLVED);
        // stretch shears, bending twists
        const double size = S.a[ZZ][ZZ] / A;
        CHECK_WITHIN(F.a[NX][NZ], S.a[XZ][ZZ] / A, SOLVED * size);
        CHECK_WITHIN(F.a[NY][NZ], S.a[YZ][ZZ] / A, SOLVED * size);
        CHECK_WITHIN(F.a[MZ][MX], -S.a[XZ][ZZ] / (2 * Ixx), SOLVED * S.a[ZZ][ZZ] / Ixx);
        CHECK_WITHIN(F.a[MZ][MY], -S.a[YZ][ZZ] / (2 * Iyy), SOLVED * S.a[ZZ][ZZ] / Iyy);
        CHECK_WITHIN(F.a[MX][NZ], 0, SOLVED * sqrt(F.a[MX][MX] * F.a[NZ][NZ]));
    }
}

static material wound(double nu12, double nu13)
{
    material m = {.name = "wound",
                  .E1 = 20e9,
                  .E2 = 30e9,
                  .E3 = 5e9,
                  .G12 = 4e9,
                  .G13 = 2e9,
                  .G23 = 3e9,
                  .nu12 = nu12,
                  .nu13 = nu13,
                  .nu23 = 0.2};
    CHECK_OK(material_bind(&m));
    return m;
}

// round about an axis: twist shears along circles only; stretch keeps circles where nu12 = nu13
static void a_wound_ring_stretches_and_twists_by_its_own_constants(void)
{
    const double ro = 4e-3, ri = 3e-3;
    material m = wound(0.28, 0.28);
    shape_spec ring = an_annulus(ro, ri, 0);
    ring.axes = SHAPE_AXES_TANGENT;
    const beam_law law = law_of(&ring, MESH_MAPPED, &m);
    beam_centres centres = {0};
    CHECK_OK(beam_law_centres(&law, &centres));
    CHECK_NEAR(centres.GJ, m.G12 * PI / 2 * (pow(ro, 4) - pow(ri, 4)), CURVED);
    CHECK_NEAR(centres.EA, m.E1 * PI * (ro * ro - ri * ri), CURVED);
    CHECK_NEAR(centres.EI[0], m.E1 * PI / 4 * (pow(ro, 4) - pow(ri, 4)), CURVED);
}

// Lekhnitskii's tube of a material with E2, E3 and nu12, nu13 that differ, wound round its axis:
// stretched by e its radial displacement is a r + b r^k + c r^-k. The stresses' free constants
// follow from the free inner and outer circle.
static void a_wound_tube_of_unequal_ratios_stretches_as_lekhnitskii_has_it(void)
{
    const double ro = 4e-3, ri = 2e-3;
    const material m = wound(0.1, 0.45);
    shape_spec ring = an_annulus(ro, ri, 0);
    ring.axes = SHAPE_AXES_TANGENT;
    const beam_law law = law_of_size(&ring, MESH_MAPPED, 4e-4, &m);
    // along z, theta, r: 1, 2, 3
    const mat3 own = mat3_identity();
    const mat6 Q = material_stiffness_along(&m, own);
    const double Qr = Q.a[2][2], Qt = Q.a[1][1], Qrt = Q.a[1][2], Qrz = Q.a[0][2];
    const double Qtz = Q.a[0][1], Qz = Q.a[0][0], k = sqrt(Qt / Qr);
    // r sigma_r' + sigma_r - sigma_t = 0 with u = a r, e = 1
    const double a = (Qtz - Qrz) / (Qr - Qt);
    // sigma_r(r) = (Qr + Qrt) a + Qrz + (k Qr + Qrt) b r^(k-1) + (-k Qr + Qrt) c r^(-k-1) = 0
    const double p = k * Qr + Qrt, q = -k * Qr + Qrt, s = -(Qr + Qrt) * a - Qrz;
    const double po = p * pow(ro, k - 1), pi = p * pow(ri, k - 1);
    const double qo = q * pow(ro, -k - 1), qi = q * pow(ri, -k - 1), det = po * qi - pi * qo;
    const double b = s * (qi - qo) / det, c = s * (po - pi) / det;
    // EA = int sigma_z = int (Qz + Qtz u / r + Qrz u') 2 pi r
    const double EA = 2 * PI *
                      ((Qz + (Qtz + Qrz) * a) * (ro * ro - ri * ri) / 2 +
                       b * (Qtz + k * Qrz) * (pow(ro, k + 1) - pow(ri, k + 1)) / (k + 1) +
                       c * (Qtz - k * Qrz) * (pow(ro, 1 - k) - pow(ri, 1 - k)) / (1 - k));
    beam_centres centres = {0};
    CHECK_OK(beam_law_centres(&law, &centres));
    CHECK_ABOVE(fabs(EA / (m.E1 * PI * (ro * ro - ri * ri)) - 1), 1e-3); // ratios matter
    CHECK_NEAR(centres.EA, EA, CURVED);
}

static void isotropic_constants_in_any_directions_are_isotropic(void)
{
    const material steel = {.E = 200e9, .nu = 0.29};
    const double G = material_shear_modulus(&steel);
    material same = {.E1 = steel.E,
                     .E2 = steel.E,
                     .E3 = steel.E,
                     .G12 = G,
                     .G13 = G,
                     .G23 = G,
                     .nu12 = 0.29,
                     .nu13 = 0.29,
                     .nu23 = 0.29,
                     .fibre_angle = 0.3};
    CHECK_OK(material_bind(&same));
    shape_spec sector = a_sector(4e-3, 3e-3, 1, 2, 0);
    const beam_law a = law_of(&sector, MESH_MAPPED, &steel);
    sector.axes = SHAPE_AXES_TANGENT;
    sector.plane_angle = fixed(0.8);
    const beam_law b = law_of(&sector, MESH_MAPPED, &same);
    CHECK_BELOW(mat6_relative_error(b.K, a.K), SOLVED);
}

// the shape turned, its own axes with it
static void a_turned_shape_has_the_turned_law(void)
{
    const double angle = 0.7;
    const material m = glass(0.4, 0.5);
    shape_spec bar = a_rectangle(0.01, 0.004, 0.1, 0, 0, 0);
    shape_spec turned = a_rectangle(0.01, 0.004, 0.1 + angle, 0, 0, 0);
    bar.axes = turned.axes = SHAPE_AXES_TANGENT;
    const beam_law a = law_of(&bar, MESH_MAPPED, &m), b = law_of(&turned, MESH_MAPPED, &m);
    CHECK_BELOW(mat6_relative_error(beam_law_move(b.K, 0, 0, angle), a.K), SOLVED);
}

int main(void)
{
    against(BY_CLOSED_FORM, "graded bars; Lekhnitskii, Theory of Elasticity of an Anisotropic "
                            "Body: bars and wound tubes; theory (2.10)");
    a_graded_bar_stretches_and_bends_by_its_integrals();
    a_disc_graded_over_its_radius_twists_by_its_integral();
    an_off_axis_bar_follows_its_compliance();
    a_wound_ring_stretches_and_twists_by_its_own_constants();
    a_wound_tube_of_unequal_ratios_stretches_as_lekhnitskii_has_it();
    isotropic_constants_in_any_directions_are_isotropic();
    a_turned_shape_has_the_turned_law();
    return test_failures != 0;
}
