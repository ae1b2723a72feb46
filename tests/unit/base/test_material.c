// tests/unit/base/test_material.c
#include "base/material.h"
#include "tests/test.h"

#include <string.h>

// sums of 81 products near 1, relative to the largest entry
static const double ROUNDING = 1e-13;

static const int pair[6][2] = {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};

static material glass(void)
{
    return (material){.name = "glass",
                      .E1 = 41e9,
                      .E2 = 10.4e9,
                      .E3 = 9.1e9,
                      .G12 = 4.3e9,
                      .G13 = 4.1e9,
                      .G23 = 3.5e9,
                      .nu12 = 0.28,
                      .nu13 = 0.31,
                      .nu23 = 0.45};
}

static double entry_size(mat6 Q)
{
    double most = 0;
    for (int i = 0; i < 36; i++) {
        most = fmax(most, fabs(Q.a[i / 6][i % 6]));
    }
    return most;
}

static void check_same(mat6 a, mat6 b)
{
    const double size = entry_size(b);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            CHECK_WITHIN(a.a[i][j], b.a[i][j], ROUNDING * size);
        }
    }
}

// C_ijkl in x, y, z = a_pi a_qj a_rk a_sl C_pqrs: the tensor itself, without engineering strains
static mat6 turned_as_tensor(mat6 own, mat3 axes)
{
    int index[3][3];
    for (int k = 0; k < 6; k++) {
        index[pair[k][0]][pair[k][1]] = index[pair[k][1]][pair[k][0]] = k;
    }
    mat6 out = {0};
    for (int n = 0; n < 81 * 36; n++) {
        const int to = n / 81, p = n % 3, q = n / 3 % 3, r = n / 9 % 3, s = n / 27 % 3;
        const int *ij = pair[to / 6], *kl = pair[to % 6];
        out.a[to / 6][to % 6] += axes.a[p][ij[0]] * axes.a[q][ij[1]] * axes.a[r][kl[0]] *
                                 axes.a[s][kl[1]] * own.a[index[p][q]][index[r][s]];
    }
    return out;
}

static mat6 own_stiffness(const material *m)
{
    const mat3 same = mat3_identity();
    return material_stiffness_along(m, same);
}

static void a_turned_stiffness_is_the_turned_tensor(void)
{
    material m = glass();
    CHECK_OK(material_bind(&m));
    const mat6 own = own_stiffness(&m);
    const double angle[][2] = {{0, 0}, {0.3, 0}, {0, 0.7}, {-1.1, 2.3}, {3, -0.4}};
    for (int i = 0; i < 5; i++) {
        const material_frame f = material_frame_make(angle[i][0], angle[i][1]);
        check_same(material_stiffness_in(&m, &f, 1, 2), turned_as_tensor(own, f.axes));
    }
}

// the fibre in the plane of z and x at an angle to z: the classical laminate formulas
static void an_off_axis_modulus_follows_the_laminate_formula(void)
{
    material m = glass();
    const double t = 0.6, c = cos(t), s = sin(t);
    m.fibre_angle = t;
    CHECK_OK(material_bind(&m));
    const double wanted = c * c * c * c / m.E1 + (1 / m.G12 - 2 * m.nu12 / m.E1) * s * s * c * c +
                          s * s * s * s / m.E2;
    CHECK_NEAR(1 / m.E, wanted, 1e-13);

    mat6 S;
    CHECK(mat6_inverse_spd(material_stiffness(&m), &S));
    const double shear = 2 * (2 / m.E1 + 2 / m.E2 + 4 * m.nu12 / m.E1 - 1 / m.G12) * s * s * c * c +
                         (s * s * s * s + c * c * c * c) / m.G12;
    CHECK_NEAR(S.a[4][4], shear, 1e-13); // 1 / G_zx
}

static void own_angles_and_those_of_a_frame_are_the_same_turn(void)
{
    material straight = glass(), turned = glass();
    turned.plane_angle = 0.4, turned.fibre_angle = -0.9;
    CHECK_OK(material_bind(&straight));
    CHECK_OK(material_bind(&turned));
    const material_frame f = material_frame_make(0.4, -0.9);
    check_same(material_stiffness(&turned), material_stiffness_in(&straight, &f, 0, 0));
}

// the default axes: 1 = z, 2 = x, 3 = y
static void unturned_axes_are_z_x_and_y(void)
{
    material m = glass();
    CHECK_OK(material_bind(&m));
    mat6 S;
    CHECK(mat6_inverse_spd(material_stiffness(&m), &S));
    CHECK_NEAR(1 / S.a[2][2], m.E1, 1e-13);
    CHECK_NEAR(1 / S.a[0][0], m.E2, 1e-13);
    CHECK_NEAR(1 / S.a[1][1], m.E3, 1e-13);
    CHECK_NEAR(1 / S.a[4][4], m.G12, 1e-13); // xz
    CHECK_NEAR(1 / S.a[3][3], m.G13, 1e-13); // yz
    CHECK_NEAR(1 / S.a[5][5], m.G23, 1e-13); // xy
    CHECK_NEAR(-S.a[2][0] / S.a[2][2], m.nu12, 1e-12);
    CHECK_NEAR(m.nu, (m.nu12 + m.nu13) / 2, 1e-12);
}

// at the angle phi about the centre the polar axes are those of x, y turned by phi + 90 degrees
static void a_polar_frame_goes_round_its_centre(void)
{
    material m = glass();
    CHECK_OK(material_bind(&m));
    const material_frame plain = material_frame_make(0.2, 1.0);
    material_frame polar = plain;
    polar.polar = true;
    polar.centre[0] = 0.5, polar.centre[1] = -2;
    for (int i = 0; i < 7; i++) {
        const double phi = 0.9 * i, r = 0.1 + i;
        const mat3 turn = mat3_rot_z(phi + acos(0));
        const material_frame turned = {.axes = mat3_mul(plain.axes, mat3_transpose(turn))};
        const double x = 0.5 + r * cos(phi), y = -2 + r * sin(phi);
        check_same(material_stiffness_in(&m, &polar, x, y),
                   material_stiffness_in(&m, &turned, 0, 0));
    }
    check_same(material_stiffness_in(&m, &polar, 0.5, -2),
               material_stiffness_in(&m, &polar, 1.5, -2));
}

// equal constants in all directions and in whatever axes: the isotropic Q
static void isotropic_constants_give_the_isotropic_stiffness(void)
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
                     .nu23 = 0.29};
    CHECK_OK(material_bind(&same));
    CHECK(same.kind == MATERIAL_ORTHOTROPIC);
    const material_frame f = material_frame_make(1, 2);
    check_same(material_stiffness_in(&same, &f, 0, 0), material_stiffness(&steel));
    CHECK_NEAR(same.E, steel.E, 1e-13);
    CHECK_NEAR(same.nu, steel.nu, 1e-12);
}

static void six_by_six_numbers_are_the_stiffness_in_own_axes(void)
{
    material m = glass(), full = {.name = "full"};
    CHECK_OK(material_bind(&m));
    mat6 own = own_stiffness(&m);
    own.a[0][3] = own.a[3][0] = 0.7e9; // nothing orthotropic
    full.stiffness = (key_rows){.nrow = 6, .ncol = 6, .a = &own.a[0][0]};
    CHECK_OK(material_bind(&full));
    CHECK(full.kind == MATERIAL_ANISOTROPIC);
    const material_frame f = material_frame_make(-0.8, 0.3);
    check_same(material_stiffness_in(&full, &f, 0, 0), turned_as_tensor(own, f.axes));
}

static void check_refused(material m, const char *words)
{
    m.name = "x";
    m.at = (mark){7, 3};
    CHECK(material_bind(&m) == ERR_INPUT);
    int line = 0, column = 0;
    CHECK(status_place(&line, &column) && line == 7 && column == 3);
    if (!strstr(status_message(), words)) {
        test_failures++;
        printf("wanted '%s' in '%s'\n", words, status_message());
    }
    status_clear();
}

static void constants_of_no_solid_are_refused_by_the_inequality_they_break(void)
{
    check_refused((material){.E = 1e6, .nu = 0.6}, "nu = 0.6 breaks -1 < nu < 0.5");
    check_refused((material){.E = 1e6, .nu = 0.5}, "nu = 0.5 breaks -1 < nu < 0.5");
    check_refused((material){.E = 1e6, .nu = -1}, "nu = -1 breaks -1 < nu < 0.5");

    material m = glass();
    m.nu12 = 2.1; // E1 / E2 = 3.942
    check_refused(m, "nu12 = 2.1 breaks nu12^2 < E1/E2 = 3.94231");
    m = glass();
    m.nu13 = -2.2; // E1 / E3 = 4.505
    check_refused(m, "nu13 = -2.2 breaks nu13^2 < E1/E3 = 4.50549");
    m = glass();
    m.nu23 = 1.2; // E2 / E3 = 1.143
    check_refused(m, "nu23 = 1.2 breaks nu23^2 < E2/E3 = 1.14286");

    // each ratio alone is fine: 1 - 3 * 0.36 - 2 * 0.216 = -0.512
    m = (material){.E1 = 1e9,
                   .E2 = 1e9,
                   .E3 = 1e9,
                   .G12 = 1e9,
                   .G13 = 1e9,
                   .G23 = 1e9,
                   .nu12 = 0.6,
                   .nu13 = 0.6,
                   .nu23 = 0.6};
    check_refused(m, "1 - nu12 nu21 - nu23 nu32 - nu31 nu13 - 2 nu21 nu32 nu13 = -0.512, it must "
                     "be more than 0");
}

static void a_stiffness_of_no_solid_is_refused(void)
{
    material m = glass(), full = {0};
    CHECK_OK(material_bind(&m));
    mat6 own = own_stiffness(&m);
    full.stiffness = (key_rows){.nrow = 6, .ncol = 6, .a = &own.a[0][0]};
    own.a[1][4] = 1e9;
    check_refused(full, "row 5, column 2 is 0 Pa while row 2, column 5 is 1e+09 Pa");
    own.a[1][4] = 0;
    own.a[3][3] = -2;
    check_refused(full, "row 4, column 4 is -2 Pa, it must be more than 0");
    own.a[3][3] = 1e9, own.a[4][4] = 1e9;
    own.a[3][4] = own.a[4][3] = 1.1e9; // 1 - 1.21
    check_refused(full, "first 5 rows and columns, over the product of their diagonal");
}

static void contradicting_constants_are_refused(void)
{
    material m = glass();
    m.G13 = 0;
    check_refused(m, "G13 is missing");
    m = glass();
    m.nu23 = NAN;
    check_refused(m, "nu23 is missing");
    m = glass();
    m.nu = 0.3;
    check_refused(m, "nu does not belong here");
    check_refused((material){.E = 1e6, .nu = NAN}, "nu is missing");
    check_refused((material){.E = 1e6, .nu = 0.3, .E2 = 1e6}, "E2 does not belong here");
}

int main(void)
{
    a_turned_stiffness_is_the_turned_tensor();
    an_off_axis_modulus_follows_the_laminate_formula();
    own_angles_and_those_of_a_frame_are_the_same_turn();
    unturned_axes_are_z_x_and_y();
    a_polar_frame_goes_round_its_centre();
    isotropic_constants_give_the_isotropic_stiffness();
    six_by_six_numbers_are_the_stiffness_in_own_axes();
    constants_of_no_solid_are_refused_by_the_inequality_they_break();
    a_stiffness_of_no_solid_is_refused();
    contradicting_constants_are_refused();
    return test_failures != 0;
}
