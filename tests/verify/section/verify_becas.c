// tests/verify/section/verify_becas.c
// BECAS user's guide (Risoe-R-1785), sections S1 and S2: 10 x 10 bilinear quads with 2 x 2 Gauss
// points, all published digits.
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

int main(void)
{
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
    return test_failures != 0;
}
