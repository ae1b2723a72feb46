// tests/verify/app/verify_plane_strain.c
// GetDP's generalized plane strain on meshes of ours against closed forms and published numbers,
// with unequal Poisson's ratios. Passes without a word where GetDP is not installed.
#include "app/getdp_door.h"
#include "base/beam_law.h"

#include "tests/shapes.h"
#include "tests/test.h"

static mat3 getdp_of(int n, const shape_spec *shapes, const material *materials, int nmaterial,
                     int kind, double size)
{
    mesh m = {0};
    mat3 B = {{{NAN}}};
    CHECK_OK(mesh_of(n, shapes, kind, 2, size, &m));
    CHECK_OK(getdp_axial_bending(&m, nmaterial, materials, &B));
    mesh_free(&m);
    return B;
}

// one material contracts freely: E times the moments, wherever the origin is; the field is of
// degree 2, which the elements hold
static void a_rectangle_off_the_origin_is_exact(int kind)
{
    const material soft = {.name = "soft", .E = 2e6, .nu = 0.45};
    const double w = 4e-3, h = 1e-3, x = 3e-3, y = -2e-3, EA = soft.E * w * h;
    const shape_spec shape = a_rectangle(w, h, 0, x, y, 0);
    const mat3 B = getdp_of(1, &shape, &soft, 1, kind, 0.5e-3);
    const double exact[3][3] = {
        {EA, EA * y, -EA * x},
        {EA * y, EA * (h * h / 12 + y * y), -EA * x * y},
        {-EA * x, -EA * x * y, EA * (w * w / 12 + x * x)},
    };
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            CHECK_NEAR(B.a[i][j], exact[i][j], 1e-9); // GetDP's solver and twelve printed digits
        }
    }
}

// Stretch of a core in a ring that contracts otherwise: displacement A r inside, B r + C / r
// outside, from continuity at r = a and no traction at r = b.
static double composite_cylinder(double a, double b, const material *core, const material *ring)
{
    const double G1 = material_shear_modulus(core), G2 = material_shear_modulus(ring);
    const double l1 = 2 * G1 * core->nu / (1 - 2 * core->nu);
    const double l2 = 2 * G2 * ring->nu / (1 - 2 * ring->nu);
    // the free surface gives C = b^2 ((l2 + G2) B + l2 / 2) / G2, continuity A = B + C / a^2
    const double q = b * b / (a * a), slope = 1 + q * (l2 + G2) / G2, rest = q * l2 / (2 * G2);
    // radial stress: 2 (l1 + G1) A + l1 = 2 (l2 + G2) B - 2 G2 C / a^2 + l2
    const double B = (l2 - q * l2 - l1 - 2 * (l1 + G1) * rest) /
                     (2 * (l1 + G1) * slope - 2 * (l2 + G2) * (1 - q));
    const double A = slope * B + rest;
    return PI * a * a * (2 * l1 * A + l1 + 2 * G1) +
           PI * (b * b - a * a) * (2 * l2 * B + l2 + 2 * G2);
}

static void a_core_in_a_ring_agrees_with_the_closed_form(void)
{
    const material both[2] = {{.name = "core", .E = 1e6, .nu = 0.1},
                              {.name = "ring", .E = 3e6, .nu = 0.45}};
    const shape_spec shapes[2] = {a_disc(4e-3, 0, 0, 1), a_disc(2.5e-3, 0, 0, 0)};
    const double exact = composite_cylinder(2.5e-3, 4e-3, &both[0], &both[1]);
    const double classical = PI * (1e6 * 2.5 * 2.5 + 3e6 * (16 - 2.5 * 2.5)) * 1e-6;
    const double EA = getdp_of(2, shapes, both, 2, MESH_FREE, 0.25e-3).a[0][0];
    printf("core in a ring: EA %.7f, closed form %.7f, without the ratios' difference %.7f\n", EA,
           exact, classical);
    CHECK_NEAR(EA, exact, 3e-6); // circles by parabolas
    CHECK_ABOVE(exact, 1.002 * classical);
}

// the two-material annulus with nu 0.45 in the soft part and 0.3 in the stiff: the axial and
// bending entries of a published-quality 6x6 (N, mm), good to 1e-5 because of the corners at the
// interfaces
static void the_annulus_with_two_ratios_agrees(void)
{
    const material both[2] = {{.name = "soft", .E = 0.66e6, .nu = 0.45},
                              {.name = "stiff", .E = 15.93e6, .nu = 0.3}};
    const shape_spec shapes[2] = {an_annulus(4e-3, 3.2e-3, 0),
                                  a_sector(4e-3, 3.2e-3, PI, PI / 8, 1)};
    const mat3 B = getdp_of(2, shapes, both, 2, MESH_MAPPED, 0.1e-3);
    printf("annulus, two ratios: EA %.6f, coupling %.6f, EI %.6f, %.6f\n", B.a[0][0],
           1e3 * B.a[0][2], 1e6 * B.a[1][1], 1e6 * B.a[2][2]);
    CHECK_NEAR(B.a[0][0], 29.215678393, 1e-5);
    CHECK_NEAR(1e3 * B.a[0][2], 62.036588257, 1e-5);
    CHECK_NEAR(1e6 * B.a[1][1], 81.237609111, 1e-5);
    CHECK_NEAR(1e6 * B.a[2][2], 302.071647905, 1e-5);
}

int main(void)
{
    against(BY_CLOSED_FORM, "rectangles and composite cylinders: GetDP itself is checked");
    char path[4096];
    if (!getdp_find(path, sizeof path)) {
        printf("getdp is not installed\n");
        return 0;
    }
    a_rectangle_off_the_origin_is_exact(MESH_MAPPED);
    a_rectangle_off_the_origin_is_exact(MESH_FREE);
    a_core_in_a_ring_agrees_with_the_closed_form();
    against(BY_OTHER_CODE, "6x6 of an independent finite-element code, good to 1e-6");
    the_annulus_with_two_ratios_agrees();
    return test_failures != 0;
}
