// tests/unit/meshes/test_free.c
#include "base/door.h"
#include "tests/shapes.h"
#include "tests/test.h"

enum { CATHETER = 5 };

// disc, wedge down to the centre, three lumens that neither touch the wedge nor one another
static void draw_catheter(shape_spec *s)
{
    s[0] = a_disc(2e-3, 0.3e-3, -0.1e-3, 0);
    s[1] = a_sector(2e-3, 0, 1.2, 0.8, 1);
    s[1].sector.centre[0] = fixed(0.3e-3);
    s[1].sector.centre[1] = fixed(-0.1e-3);
    s[2] = a_disc(0.6e-3, 0.6e-3, -1.0e-3, -1);
    s[3] = a_disc(0.4e-3, -0.7e-3, 0.5e-3, -1);
    s[4] = a_disc(0.25e-3, 1.8e-3, 0.1e-3, -1);
}

static void a_catheter_is_meshed_at_every_order(void)
{
    for (int p = 1; p <= 4; p++) {
        shape_spec s[CATHETER];
        draw_catheter(s);
        mesh m = {0};
        CHECK_OK(mesh_of(CATHETER, s, MESH_AUTO, p, 0, &m));
        CHECK_OK(mesh_check(&m));
        CHECK(m.block[0].shape == SHAPE_TRIANGLE && m.order == p);
        CHECK(mesh_is_conforming(&m));
        double least = 0;
        CHECK_OK(mesh_min_jacobian(&m, &least));
        CHECK(least > 0.1);
        // closed forms; the size by default bounds the geometry's error: angle^(2p) / (2p)! or so
        const double tolerance[] = {1, 1e-3, 1e-6, 1e-8, 1e-10};
        const double wedge = 0.8 / 2 * 4e-6, lumens = PI * (0.36 + 0.16 + 0.0625) * 1e-6;
        CHECK_NEAR(mesh_moments(&m, 1).a[0], wedge, tolerance[p]);
        CHECK_NEAR(mesh_moments(&m, 0).a[0], 4e-6 * PI - wedge - lumens, tolerance[p]);
        const double x = 4e-6 * PI * 0.3e-3 - PI * 1e-9 * (0.36 * 0.6 - 0.16 * 0.7 + 0.0625 * 1.8);
        CHECK_NEAR(mesh_moments(&m, -1).a[1], x, 10 * tolerance[p]);
        mesh_free(&m);
    }
    CHECK(door_is_open("gmsh"));
}

static void the_same_outlines_give_the_same_mesh(void)
{
    shape_spec s[CATHETER];
    draw_catheter(s);
    mesh m[2] = {{0}, {0}};
    for (int i = 0; i < 2; i++) {
        CHECK_OK(mesh_of(CATHETER, s, MESH_FREE, 3, 0, &m[i]));
    }
    CHECK(m[0].nnode == m[1].nnode);
    CHECK(memcmp(m[0].xyz, m[1].xyz, 3 * (size_t)m[0].nnode * sizeof(double)) == 0);
    CHECK(memcmp(m[0].block[0].conn, m[1].block[0].conn,
                 (size_t)m[0].block[0].nelem * 10 * sizeof(int)) == 0);
    mesh_free(&m[0]);
    mesh_free(&m[1]);
}

static void later_shapes_lie_on_top(void)
{
    // disc over a rectangle that it leaves on one side, then a smaller rectangle of the first
    // material, then a hole
    const shape_spec s[] = {a_rectangle(4, 2, 0, 0, 0, 0), a_disc(0.9, 2, 0, 1),
                            a_rectangle(0.5, 0.5, 0.4, 2, 0, 0), a_disc(0.1, 2, 0, -1)};
    mesh m = {0};
    CHECK_OK(mesh_of(4, s, MESH_FREE, 4, 0, &m));
    CHECK_NEAR(mesh_moments(&m, 0).a[0], 8 - 0.81 * PI / 2 + 0.25 - 0.01 * PI, 1e-10);
    CHECK_NEAR(mesh_moments(&m, 1).a[0], 0.81 * PI - 0.25, 1e-10);
    mesh_free(&m);
    // the other way round the rectangle hides half of the disc
    const shape_spec back[] = {s[1], s[0]};
    CHECK_OK(mesh_of(2, back, MESH_FREE, 4, 0, &m));
    CHECK_NEAR(mesh_moments(&m, 0).a[0], 8, 1e-10);
    CHECK_NEAR(mesh_moments(&m, 1).a[0], 0.81 * PI / 2, 1e-10);
    mesh_free(&m);
}

static void polygons_keep_their_holes(void)
{
    const double outer[] = {0, 0, 5, 0, 6, 3, 2, 4, 0, 2};
    const double a[] = {1, 1, 2, 1, 1, 2}, b[] = {3, 1, 4, 1, 4, 2, 3, 2};
    hole_spec holes[] = {{.points = {.nrow = 3, .ncol = 2, .a = (double *)(size_t)a}},
                         {.points = {.nrow = 4, .ncol = 2, .a = (double *)(size_t)b}}};
    shape_spec s = a_polygon(5, outer, 0);
    s.polygon.holes = (key_list){.count = 2, .items = holes};
    s.polygon.angle = fixed(0.5);
    s.polygon.centre[1] = fixed(1);
    for (int p = 1; p <= 4; p++) {
        mesh m = {0};
        CHECK_OK(mesh_of(1, &s, MESH_AUTO, p, 1, &m));
        // shoelace: (0 + 15 + 18 + 4 + 0) / 2 less the holes
        CHECK_NEAR(mesh_moments(&m, -1).a[0], 18.5 - 0.5 - 1, 1e-12);
        CHECK(mesh_is_conforming(&m));
        const double around = 5 + hypot(1, 3) + hypot(4, 1) + hypot(2, 2) + 2 + 2 + hypot(1, 1) + 4;
        CHECK_NEAR(mesh_boundary_length(&m), around, 1e-12);
        mesh_free(&m);
    }
}

// the wall between them is 1/400 of the radius: curved edges must become short there, and only
// there
static void thin_gaps_are_refined_where_they_are(void)
{
    const shape_spec s[] = {a_disc(2e-3, 0, 0, 0), a_disc(1e-3, 0.995e-3, 0, -1)};
    for (int p = 2; p <= 4; p++) {
        mesh m = {0};
        CHECK_OK(mesh_of(2, s, MESH_FREE, p, 0, &m));
        double least = 0;
        CHECK_OK(mesh_min_jacobian(&m, &least));
        CHECK(least >= 0.1);
        CHECK(mesh_element_count(&m) < 6000);
        CHECK_NEAR(mesh_moments(&m, -1).a[0], 3e-6 * PI, 1e-6);
        mesh_free(&m);
    }
}

static void check_refused(int n, const shape_spec *s, const char *who, const char *why)
{
    mesh m = {0};
    CHECK(mesh_of(n, s, MESH_FREE, 2, 0, &m) == ERR_INPUT);
    const bool told = strstr(status_message(), who) && strstr(status_message(), why);
    if (!told) {
        printf("message: %s, wanted: %s ... %s\n", status_message(), who, why);
    }
    CHECK(told);
    status_clear();
    mesh_free(&m);
}

static void sections_that_cannot_be_meshed_are_refused(void)
{
    const shape_spec apart[] = {a_disc(1, -2, 0, 0), a_disc(1, 2, 0, 1)};
    check_refused(2, apart, "shape 2 (disc", "does not touch the rest");
    const shape_spec point[] = {
        a_rectangle(1, 1, 0.1, 0, 0, 0),
        a_rectangle(1, 1, 0.1, cos(0.1) - sin(0.1), sin(0.1) + cos(0.1), 1)};
    check_refused(2, point, "shape 2 (rectangle", "single points");
    const shape_spec kiss[] = {a_disc(1, -1, 0, 0), a_disc(1, 1, 0, 1)};
    check_refused(2, kiss, "shape 2 (disc", "touch");
    const shape_spec gone[] = {a_disc(1, 0, 0, 0), a_rectangle(3, 3, 0, 0, 0, -1)};
    check_refused(2, gone, "empty", "cut away");
    const shape_spec rim[] = {a_disc(1, 0, 0, 0), a_disc(1 - 3e-6, 0, 0, 1)};
    check_refused(2, rim, "shape 1", "sliver");
    const shape_spec wedge[] = {a_rectangle(4, 1, 0, 0, 0, 0), a_rectangle(4, 1, 2e-6, 0, 0, 1)};
    check_refused(2, wedge, "", "sliver");
    const shape_spec thin[] = {a_disc(1, 0, 0, 0), a_rectangle(1, 1e-7, 0, 0, 0, 1)};
    check_refused(2, thin, "shape 2 (rectangle", "thinner");
    // a hole that touches the outline from inside leaves a cusp on either side
    const shape_spec cusp[] = {a_disc(2, 0, 0, 0), a_disc(1, 1, 0, -1)};
    check_refused(2, cusp, "shape 1 (disc", "too small an angle");
}

int main(void)
{
    a_catheter_is_meshed_at_every_order();
    the_same_outlines_give_the_same_mesh();
    later_shapes_lie_on_top();
    polygons_keep_their_holes();
    thin_gaps_are_refined_where_they_are();
    sections_that_cannot_be_meshed_are_refused();
    return test_failures != 0;
}
