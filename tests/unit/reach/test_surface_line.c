// tests/unit/reach/test_surface_line.c
#include "reach/surface_line.h"

#include "reach/distance.h"

#include "tests/surfaces.h"
#include "tests/test.h"

// middles of the stretches between passages lie inside and outside by turns
static void check_line(const surface *s, const distance_tree *t, vec3 p, vec3 d)
{
    surface_passage *list = NULL;
    int n = 0;
    CHECK_OK(surface_line(s, p, d, &list, &n));
    CHECK(n % 2 == 0);
    const vec3 u = vec3_scale(1 / vec3_norm(d), d);
    for (int i = 0; i < n; i++) {
        CHECK(list[i].inward == (i % 2 == 0));
        const nearest_point on = distance_to(t, vec3_add_scaled(p, list[i].along, u));
        CHECK_WITHIN(on.distance, 0, 1e-15);
        const double next = i + 1 < n ? list[i + 1].along : list[i].along + 1;
        const double middle = 0.5 * (list[i].along + next);
        if (next - list[i].along > 1e-9) {
            CHECK((distance_to(t, vec3_add_scaled(p, middle, u)).distance > 0) == list[i].inward);
        }
    }
    free(list);
}

static void random_lines_go_in_and_out(void)
{
    made_surface m = {0};
    surface s = {0};
    surface_report r;
    distance_tree *t = NULL;
    made_ball(&m, 12, made_bumpy);
    CHECK_OK(made_closed(&m, &s, &r));
    CHECK_OK(distance_tree_make(&s, &t));
    unsigned state = 11;
    for (int i = 0; i < 500; i++) {
        double x[6];
        for (int d = 0; d < 6; d++) {
            state = state * 1664525u + 1013904223u;
            x[d] = (state >> 8) / 16777216.0 - 0.5;
        }
        check_line(&s, t, (vec3){{0.1 * x[0], 0.1 * x[1], 0.1 * x[2]}}, (vec3){{x[3], x[4], x[5]}});
    }
    // through vertices, and along edges
    for (int i = 0; i < s.nvertex; i += 3) {
        check_line(&s, t, (vec3){{0, 0, 0}}, surface_vertex(&s, i));
        check_line(&s, t, (vec3){{0, 0, 0}}, (vec3){{i % 3 - 1, 1, 0}});
    }
    distance_tree_free(t);
    surface_free(&s);
    made_free(&m);
}

static void a_box_is_passed_at_its_sides(void)
{
    made_surface m = {0};
    surface s = {0};
    surface_report r;
    surface_passage *list = NULL;
    int n = 0;
    made_box(&m, (vec3){{0, 0, 0}}, (vec3){{10e-3, 20e-3, 30e-3}});
    CHECK_OK(made_closed(&m, &s, &r));
    // through the diagonals of both sides
    CHECK_OK(surface_line(&s, (vec3){{5e-3, 10e-3, 50e-3}}, (vec3){{0, 0, -2}}, &list, &n));
    CHECK(n == 2);
    if (n == 2) {
        CHECK_WITHIN(list[0].along, 20e-3, 1e-16);
        CHECK_WITHIN(list[1].along, 50e-3, 1e-16);
    }
    free(list);
    CHECK_OK(surface_line(&s, (vec3){{5e-3, 21e-3, 50e-3}}, (vec3){{0, 0, -2}}, &list, &n));
    CHECK(n == 0);
    free(list);
    surface_free(&s);
    made_free(&m);
}

int main(void)
{
    random_lines_go_in_and_out();
    a_box_is_passed_at_its_sides();
    return test_failures != 0;
}
