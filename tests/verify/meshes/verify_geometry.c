// tests/verify/meshes/verify_geometry.c
// Areas and second moments of curved meshes fall at the order of Lobatto interpolation, 2 p, for p
// = 1 to 4; gmsh's equally spaced curves would stop at 2, 4, 4, 6. Mapped and free meshes of the
// same outlines agree.
#include "tests/shapes.h"
#include "tests/test.h"

typedef struct exact {
    double area, second; // int 1, int x^2 + y^2
} exact;

static void check_orders(const char *what, int n, const shape_spec *s, int kind, double radius,
                         int material, exact wanted)
{
    printf("%s\n  p   edges   error of area   of second moment\n", what);
    for (int p = 1; p <= 4; p++) {
        const int edges[] = {8, 12, 16, 24}, count = p == 4 ? 3 : 4;
        double h[4], area[4], second[4];
        for (int k = 0; k < count; k++) {
            mesh m = {0};
            h[k] = 2 * PI * radius / edges[k];
            CHECK_OK(mesh_of(n, s, kind, p, h[k], &m));
            const moments q = mesh_moments(&m, material);
            area[k] = fabs(q.a[0] / wanted.area - 1);
            second[k] = fabs((q.a[3] + q.a[4]) / wanted.second - 1);
            printf("  %d %7d   %13.3e   %13.3e\n", p, edges[k], area[k], second[k]);
            mesh_free(&m);
        }
        about("%s, order %d", what, p);
        printf("  observed order %.2f and %.2f\n", observed_order(count, h, area),
               observed_order(count, h, second));
        CHECK_NEAR(observed_order(count, h, area), 2.0 * p, 0.05);
        CHECK_NEAR(observed_order(count, h, second), 2.0 * p, 0.05);
    }
}

static exact ring(double outer, double inner, double angle)
{
    return (exact){.area = angle / 2 * (outer * outer - inner * inner),
                   .second = angle / 4 * (pow(outer, 4) - pow(inner, 4))};
}

static void geometry_converges_at_twice_the_order(void)
{
    const shape_spec annulus = an_annulus(4, 3.2, 0), disc = a_disc(4, 0, 0, 0);
    check_orders("mapped annulus", 1, &annulus, MESH_MAPPED, 4, -1, ring(4, 3.2, 2 * PI));
    // a full circle alone: with edges in proportion to the radius the errors of two circles would
    // cancel
    check_orders("free disc", 1, &disc, MESH_FREE, 4, -1, ring(4, 0, 2 * PI));
    // a quarter has edges of the same length
    const shape_spec quarter[] = {annulus, a_sector(4, 3.2, 1, PI / 2, 1)};
    check_orders("mapped sector", 2, quarter, MESH_MAPPED, 4, 1, ring(4, 3.2, PI / 2));
    const shape_spec slice[] = {disc, a_sector(4, 0, 1, PI / 2, 1)};
    check_orders("free slice", 2, slice, MESH_FREE, 4, 1, ring(4, 0, PI / 2));
}

static void mapped_and_free_meshes_agree(void)
{
    const shape_spec s[] = {an_annulus(4, 3, 0), a_sector(4, 3.5, 6.2, 1.1, 1),
                            a_sector(4.2, 3.7, 0.4, 0.5, 1), a_sector(3.4, 2, 2, 0.3, -1),
                            a_sector(4, 3, 4, 5.5, 0)};
    const double angle = 0.4;
    const shape_spec r[] = {a_rectangle(4, 2, angle, 0, 0, 0), a_rectangle(1, 3, angle, 0.5, 0, 1),
                            a_rectangle(2, 1, angle, 0.5, 0.2, -1)};
    const struct {
        int n;
        const shape_spec *s;
    } trials[] = {{5, s}, {3, r}};
    for (size_t t = 0; t < sizeof trials / sizeof *trials; t++) {
        mesh m[2] = {{0}, {0}};
        for (int k = 0; k < 2; k++) {
            CHECK_OK(mesh_of(trials[t].n, trials[t].s, MESH_MAPPED + k, 4, 0, &m[k]));
        }
        for (int material = 0; material < 2; material++) {
            const moments a = mesh_moments(&m[0], material), b = mesh_moments(&m[1], material);
            for (int i = 0; i < 6; i++) {
                // both at 1e-11 of geometry; OpenCASCADE places corners to 1e-10 or better
                CHECK_WITHIN(b.a[i], a.a[i], 1e-9 * (a.a[0] + a.a[3] + a.a[4]));
            }
        }
        mesh_free(&m[0]);
        mesh_free(&m[1]);
    }
}

int main(void)
{
    against(BY_CLOSED_FORM, "areas and second moments of rings and sectors");
    geometry_converges_at_twice_the_order();
    mapped_and_free_meshes_agree();
    return test_failures != 0;
}
