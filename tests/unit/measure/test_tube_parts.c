// tests/unit/measure/test_tube_parts.c
#include "measure/tube_inside.h"
#include "tests/test.h"
#include "tests/verify/measure/made_cloud.h"

#include <string.h>

static const gsl_spline_door *the_door(void)
{
    const gsl_spline_door *door = NULL;
    CHECK_OK(gsl_spline_door_open(&door));
    return door;
}

// every point within reach, by looking at all
static void the_grid_finds_what_a_loop_finds(void)
{
    enum { POINTS = 4000 };
    point_cloud c = {.count = POINTS, .p = malloc(POINTS * sizeof *c.p)};
    uint32_t *near = malloc(POINTS * sizeof *near);
    tube_grid g = {0};
    unsigned long state = 1;
    for (int i = 0; i < 3 * POINTS && c.p; i++) {
        state = state * 6364136223846793005UL + 1442695040888963407UL;
        c.p[i / 3][i % 3] = (double)(state >> 11) / 9007199254740992.0 - 0.5;
    }
    c.p[7][1] = NAN;
    c.p[8][2] = 1e30;
    CHECK_OK(tube_grid_make(&c, (vec3){{0, 0, 0}}, 0.11, &g));
    CHECK(g.count == POINTS - 2);
    for (int k = 0; k < 20; k++) {
        const vec3 at = {{c.p[100 + k][0], c.p[200 + k][1], c.p[300 + k][2]}};
        size_t wanted = 0;
        for (size_t i = 0; i < POINTS; i++) {
            wanted += vec3_norm(vec3_sub((vec3){{c.p[i][0], c.p[i][1], c.p[i][2]}}, at)) < 0.2;
        }
        CHECK(tube_grid_near(&g, at, 0.2, near, POINTS) == wanted);
        CHECK(tube_grid_near(&g, at, 0.2, near, 3) == (wanted < 3 ? wanted : 3));
    }
    tube_grid_free(&g);
    point_cloud_free(&c);
    free(near);
}

// B-splines add up to one everywhere, and carry x^3 exactly: the curve through places of a cubic
// is that cubic, with its derivatives, also beyond the ends
static void a_curve_holds_a_cubic(void)
{
    enum { PLACES = 60 };
    tube_curve c = {0};
    vec3 p[PLACES], d1, d2;
    double u[PLACES], b[TUBE_ORDER], x = 0;
    for (int i = 0; i < PLACES; i++) {
        const double s = u[i] = 2.0 * i / (PLACES - 1);
        p[i] = (vec3){{s, s * s, s * s * s}};
    }
    CHECK_OK(tube_curve_make(the_door(), 7, 2, &c));
    CHECK_OK(tube_curve_through(&c, PLACES, u, p, 1e-3));
    for (double s = -0.2; s < 2.3; s += 0.13) {
        const int piece = tube_curve_piece(&c, s, &x);
        tube_curve_basis(&c, piece, x, 0, b);
        CHECK_WITHIN(b[0] + b[1] + b[2] + b[3] + b[4] + b[5], 1, 1e-9);
        const vec3 q = tube_curve_at(&c, s, &d1, &d2);
        CHECK_WITHIN(q.a[2], s * s * s, 1e-8);
        CHECK_WITHIN(d1.a[2], 3 * s * s, 1e-7);
        CHECK_WITHIN(d2.a[2], 6 * s, 1e-6);
    }
    const vec3 n = {{-2 * 1.2, 1, 0}}; // across the line at 1.2
    const vec3 q = vec3_add_scaled(tube_curve_at(&c, 1.2, &d1, NULL), 0.05, n);
    const double foot = tube_curve_foot(&c, q, 1.0, 20);
    const vec3 f = tube_curve_at(&c, foot, &d1, NULL);
    CHECK_WITHIN(vec3_dot(vec3_sub(q, f), d1), 0, 1e-12);
    tube_curve_free(&c);
}

// arclength of a quarter of a circle, and feet on it
static void a_cut_is_in_arclength(void)
{
    enum { PLACES = 80 };
    tube_curve c = {0}, cut = {0};
    vec3 p[PLACES], d1;
    double u[PLACES];
    for (int i = 0; i < PLACES; i++) {
        u[i] = 3.0 * i / (PLACES - 1);
        const double turn = u[i] * u[i] / 9 * M_PI / 2; // ever faster
        p[i] = (vec3){{10 * cos(turn), 10 * sin(turn), 0}};
    }
    CHECK_OK(tube_curve_make(the_door(), 10, 3, &c));
    CHECK_OK(tube_curve_through(&c, PLACES, u, p, 1e-3));
    CHECK_OK(tube_curve_cut(&c, 1, 3, 1, &cut));
    CHECK_NEAR(cut.length, 10 * M_PI / 2 * 8 / 9, 1e-5);
    for (double s = 0.5; s < cut.length; s += 1) {
        (void)tube_curve_at(&cut, s, &d1, NULL);
        CHECK_NEAR(vec3_norm(d1), 1, 1e-3);
    }
    tube_curve_free(&c);
    tube_curve_free(&cut);
}

// (9.2): the centre of a bent piece without the bias kappa l^2 / 6 of a straight cylinder
static void a_station_bends_with_the_body(void)
{
    static made_line line;
    const double curvature[3] = {33, 0, 0}, none[3] = {0};
    const made_scan scan = {.radius = 4e-3, .count = 60000, .noise = 1e-6, .seed = 1};
    for (int bent = 0; bent < 2; bent++) {
        point_cloud cloud = {0};
        tube_window w = {0};
        made_line_make(0.06, made_arc, bent ? curvature : none, &line);
        CHECK_OK(made_cloud(&line, &scan, &cloud));
        CHECK_OK(tube_window_make(the_door(), &w));
        const pose g = made_line_at(&line, 0.03);
        for (size_t i = 0; i < cloud.count && w.count < TUBE_WINDOW_POINTS; i += 4) {
            const vec3 q = {{cloud.p[i][0], cloud.p[i][1], cloud.p[i][2]}};
            if (vec3_norm(vec3_sub(q, g.p)) < 2.1 * scan.radius) {
                memcpy(w.p[w.count++], q.a, sizeof q.a);
            }
        }
        tube_station s = {.c = vec3_add(g.p, mat3_mul_vec(g.R, (vec3){{3e-4, -4e-4, 0}})),
                          .t = mat3_mul_vec(g.R, (vec3){{0.1, 0.05, 1}}),
                          .radius = 3.8e-3};
        s.t = vec3_scale(1 / vec3_norm(s.t), s.t);
        CHECK_OK(tube_station_fit(&w, 1.4e-3, true, &s));
        CHECK_OK(tube_station_fit(&w, 1.4e-3, true, &s)); // from its curvature, as in a trace
        const vec3 off = mat3_tmul_vec(g.R, vec3_sub(s.c, g.p));
        CHECK(s.good);
        CHECK_WITHIN(hypot(off.a[0], off.a[1]), 0, 0.005e-3); // straight: 0.14 mm
        CHECK_WITHIN(s.radius, 4e-3, 0.01e-3);
        CHECK_WITHIN(vec3_norm(s.k), bent ? 33 : 0, 1);
        tube_window_free(&w);
        point_cloud_free(&cloud);
    }
}

int main(void)
{
    the_grid_finds_what_a_loop_finds();
    a_curve_holds_a_cubic();
    a_cut_is_in_arclength();
    a_station_bends_with_the_body();
    return test_failures != 0;
}
