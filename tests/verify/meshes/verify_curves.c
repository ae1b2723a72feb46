// Areas and second moments of sections with ellipses, round corners, splines and arrays, against
// their closed forms, and at the order of Lobatto interpolation.
#include "tests/shapes.h"
#include "tests/test.h"

static void check_ellipse(double a, double b, double angle)
{
    const shape_spec s = an_ellipse(a, b, angle, 0.7e-3, -0.4e-3, 0);
    mesh m = {0};
    CHECK_OK(mesh_of(1, &s, MESH_AUTO, 4, 0, &m));
    const moments q = mesh_moments(&m, -1);
    const double area = PI * a * b, long_way = area * a * a / 4, short_way = area * b * b / 4;
    const double x = 0.7e-3, y = -0.4e-3, c = cos(angle), s1 = sin(angle);
    printf("ellipse %g : 1, %4d elements: area %.1e\n", a / b, mesh_element_count(&m),
           q.a[0] / area - 1);
    const double tolerance = 1e-10; // the geometry's own at order 4, see test_free.c
    CHECK_NEAR(q.a[0], area, tolerance);
    CHECK_NEAR(q.a[1], area * x, tolerance);
    CHECK_NEAR(q.a[3], area * x * x + c * c * long_way + s1 * s1 * short_way, tolerance);
    CHECK_NEAR(q.a[4], area * y * y + s1 * s1 * long_way + c * c * short_way, tolerance);
    CHECK_NEAR(q.a[5], area * x * y + c * s1 * (long_way - short_way), tolerance);
    mesh_free(&m);
}

static void ellipses_have_their_areas_and_moments(void)
{
    check_ellipse(2e-3, 1.9e-3, 0.3);
    check_ellipse(2e-3, 1e-3, 2.0);
    check_ellipse(2e-3, 0.2e-3, -0.5);
    check_ellipse(0.05e-3, 2e-3, 1.0);
}

// of a quarter of an ellipse; the trapezoidal rule is exact to rounding on a full period
static double quarter_length(double a, double b)
{
    double sum = 0;
    for (int i = 0; i < 400; i++) {
        sum += hypot(a * sin(PI * i / 200), b * cos(PI * i / 200));
    }
    return sum * PI / 800;
}

static void an_ellipse_converges_at_twice_the_order(void)
{
    const double a = 3, b = 2.4;
    const shape_spec s = an_ellipse(a, b, 0.3, 0, 0, 0);
    for (int p = 1; p <= 4; p++) {
        const int edges[] = {4, p == 4 ? 6 : 8, p == 4 ? 8 : 16};
        double h[3], error[3];
        for (int k = 0; k < 3; k++) {
            mesh m = {0};
            h[k] = quarter_length(a, b) / edges[k];
            CHECK_OK(mesh_of(1, &s, MESH_FREE, p, h[k] * 1.001, &m));
            error[k] = fabs(mesh_moments(&m, -1).a[0] / (PI * a * b) - 1);
            mesh_free(&m);
        }
        about("order %d", p);
        printf("ellipse, order %d: %.1e %.1e %.1e, observed %.2f\n", p, error[0], error[1],
               error[2], observed_order(3, h, error));
        CHECK_NEAR(observed_order(3, h, error), 2.0 * p, 0.05);
    }
}

static void rounded_rectangles_have_their_areas_and_moments(void)
{
    const double w = 3e-3, h = 2e-3, r[] = {0, 0.3e-3, 1e-3};
    for (int i = 0; i < 3; i++) {
        const shape_spec s = a_rounded_rectangle(w, h, r[i], 0, 0);
        mesh m = {0};
        CHECK_OK(mesh_of(1, &s, MESH_AUTO, 4, 0, &m));
        const moments q = mesh_moments(&m, -1);
        // four quarter discs at (w/2 - r, h/2 - r), and a cross of rectangles
        const double a = w / 2 - r[i], b = h / 2 - r[i], quarter = PI * r[i] * r[i] / 4;
        const double lever = 4 * r[i] / (3 * PI);
        const double own = (PI / 16 - 4 / (9 * PI)) * pow(r[i], 4);
        const double disc_x = 4 * (own + quarter * (a + lever) * (a + lever));
        const double cross_x = 2 * b * w * w * w / 12 + 2 * r[i] * 8 * a * a * a / 12;
        CHECK_NEAR(q.a[0], 4 * quarter + 2 * b * w + 2 * r[i] * 2 * a, 1e-10);
        CHECK_NEAR(q.a[3], disc_x + cross_x, 1e-10);
        CHECK_WITHIN(q.a[5], 0, 1e-10 * q.a[3]);
        mesh_free(&m);
    }
}

static void a_spline_through_a_circle_converges_at_fourth_order(void)
{
    double step[4], error[4];
    for (int k = 0; k < 4; k++) {
        const int n = 8 << k;
        double points[2 * 64];
        for (int i = 0; i < n; i++) {
            points[2 * i] = cos(2 * PI * i / n);
            points[2 * i + 1] = sin(2 * PI * i / n);
        }
        const shape_spec s = a_spline(n, points, 0);
        mesh m = {0};
        CHECK_OK(mesh_of(1, &s, MESH_FREE, 3, 0, &m));
        step[k] = 2 * PI / n;
        error[k] = fabs(mesh_moments(&m, -1).a[0] / PI - 1);
        printf("spline through %2d points of a circle: area off by %.2e\n", n, error[k]);
        mesh_free(&m);
    }
    CHECK_NEAR(observed_order(4, step, error), 4, 0.1);
}

// curves over curves: each fragment has its share, and what is cut is gone
static void curved_shapes_lie_on_one_another(void)
{
    const shape_spec s[] = {an_ellipse(3e-3, 2e-3, 0.4, 0, 0, 0),
                            an_ellipse(1.5e-3, 1e-3, 0.4, 0, 0, 1), a_disc(0.5e-3, 0, 0, -1),
                            in_array(an_ellipse(0.3e-3, 0.15e-3, 0, 1.65e-3, 0, -1), 5, 0.1, true)};
    mesh m = {0};
    CHECK_OK(mesh_of(4, s, MESH_AUTO, 4, 0, &m));
    CHECK(mesh_is_conforming(&m));
    const double cut = 5 * PI * 0.045e-6, inner = PI * 1.5e-6, hole = PI * 0.25e-6;
    CHECK_NEAR(mesh_moments(&m, -1).a[0], PI * 6e-6 - hole - cut, 1e-9);
    CHECK_BELOW(mesh_moments(&m, 1).a[0], inner - hole);
    mesh_free(&m);
    // half of a rectangle under an ellipse with the same axis
    const shape_spec half[] = {an_ellipse(2, 1, 0, 0, 0, 0), a_rectangle(4, 3, 0, 2, 0, 1)};
    CHECK_OK(mesh_of(2, half, MESH_AUTO, 4, 0, &m));
    CHECK_NEAR(mesh_moments(&m, 0).a[0], PI, 1e-9);
    CHECK_NEAR(mesh_moments(&m, 1).a[0], 12, 1e-9);
    mesh_free(&m);
}

int main(void)
{
    against(BY_CLOSED_FORM, "areas and second moments of ellipses, round corners, splines");
    ellipses_have_their_areas_and_moments();
    an_ellipse_converges_at_twice_the_order();
    rounded_rectangles_have_their_areas_and_moments();
    a_spline_through_a_circle_converges_at_fourth_order();
    curved_shapes_lie_on_one_another();
    return test_failures != 0;
}
