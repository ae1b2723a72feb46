// tests/verify/section/verify_becas.c
// BECAS user's guide (Risoe-R-1785), sections S1, S2 and S3: 10 x 10 bilinear quads with 2 x 2
// Gauss points, all published digits.
#include "tests/verify/section/hand_meshes.h"

static void place_in_square(double u, double v, double *xyz)
{
    xyz[0] = 0.1 * (u - 0.5);
    xyz[1] = 0.1 * (v - 0.5);
    xyz[2] = 0;
}

static int right_half(double u, double v)
{
    (void)v;
    return u > 0.5;
}

typedef struct published {
    int i, j; // from 1, order nx ny nz mx my mz
    double value, last_digit;
} published;

static void compare(const char *name, const beam_law *law, int n, const published *p)
{
    for (int k = 0; k < n; k++) {
        const double value = law->K.a[p[k].i - 1][p[k].j - 1];
        about("%s, K%d%d", name, p[k].i, p[k].j);
        printf("%s K%d%d %.6g, published %.6g\n", name, p[k].i, p[k].j, value, p[k].value);
        CHECK_WITHIN(value, p[k].value, 0.51 * p[k].last_digit);
    }
}

static beam_law solve(int (*where)(double, double), const material *m)
{
    const lattice g = {.order = 1, .n0 = 10, .n1 = 10, .place = place_in_square, .material = where};
    mesh square = lattice_mesh(&g);
    beam_law law = {0};
    CHECK_OK(section_full_mesh(&square, m, &law, NULL));
    mesh_free(&square);
    return law;
}

// S3: one orthotropic material, its fibres turned about y from z towards x
static beam_law solve_turned(double degrees)
{
    material m = {.name = "ply",
                  .E1 = 480,
                  .E2 = 120,
                  .E3 = 120,
                  .G12 = 60,
                  .G13 = 50,
                  .G23 = 60,
                  .nu12 = 0.19,
                  .nu13 = 0.26,
                  .nu23 = 0.19,
                  .fibre_angle = degrees * pi / 180};
    CHECK_OK(material_bind(&m));
    return solve(one_material, &m);
}

static void compare_turned_fibres(void)
{
    static const published along[] = {{1, 1, 0.5039, 1e-4},   {2, 2, 0.4201, 1e-4},
                                      {3, 3, 4.8, 1e-1},      {4, 4, 0.004001, 1e-6},
                                      {5, 5, 0.004001, 1e-6}, {6, 6, 0.0007737, 1e-7}};
    static const published turned[] = {{1, 1, 0.7598, 1e-4},   {2, 2, 0.4129, 1e-4},
                                       {3, 3, 3.435, 1e-3},    {4, 4, 0.002489, 1e-6},
                                       {5, 5, 0.002274, 1e-6}, {6, 6, 0.0009499, 1e-7},
                                       {1, 3, 0.7387, 1e-4},   {4, 6, -0.0004613, 1e-7}};
    static const published across[] = {{1, 1, 0.50202, 1e-5},   {2, 2, 0.50406, 1e-5},
                                       {3, 3, 1.2, 1e-1},       {4, 4, 0.0010004, 1e-7},
                                       {5, 5, 0.0010002, 1e-7}, {6, 6, 0.00085081, 1e-8}};
    const beam_law s0 = solve_turned(0), s22 = solve_turned(22.5), s90 = solve_turned(90);
    compare("S3, 0 deg", &s0, 6, along);
    compare("S3, 22.5 deg", &s22, 8, turned);
    compare("S3, 90 deg", &s90, 6, across);
}

int main(void)
{
    against(BY_PUBLISHED,
            "BECAS user's guide (Risoe-R-1785): sections S1, S2 and S3, all printed digits");
    const material m[2] = {{.E = 100, .nu = 0.2}, {.E = 10, .nu = 0.2}};
    static const published S1[] = {{1, 1, 0.34899, 1e-5},    {2, 2, 0.34899, 1e-5},
                                   {3, 3, 1.0, 1e-5},        {4, 4, 0.00083384, 1e-8},
                                   {5, 5, 0.00083384, 1e-8}, {6, 6, 0.00059084, 1e-8}};
    static const published S2[] = {{1, 1, 0.128, 1e-3},    {2, 2, 0.192, 1e-3},
                                   {3, 3, 0.55, 1e-2},     {4, 4, 0.000459, 1e-6},
                                   {5, 5, 0.000459, 1e-6}, {6, 6, 0.000277, 1e-6},
                                   {2, 6, -0.00393, 1e-5}, {3, 5, 0.0113, 1e-4}};
    const beam_law one = solve(one_material, m), two = solve(right_half, m);
    compare("S1", &one, 6, S1);
    compare("S2", &two, 8, S2);
    const beam_centres c = centres_of(&two);
    CHECK_WITHIN(c.shear_centre[0], -0.02045, 0.51e-5);
    CHECK_WITHIN(c.stiffness_centre[0], -0.02045, 0.51e-5);
    CHECK_WITHIN(c.shear_centre[1], 0, 1e-14);
    compare_turned_fibres();
    return test_failures != 0;
}
