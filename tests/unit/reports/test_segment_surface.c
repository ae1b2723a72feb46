// tests/unit/reports/test_segment_surface.c
#include "reports/plane_edges.h"
#include "reports/segment_surface.h"
#include "tests/test.h"
#include "tests/unit/reports/synthetic.h"

// a polygon through the nodes of a circle: its area falls short by (step)^2 / 6, 96 Gauss-Lobatto
// steps around
static const double polygon_error = 2e-3;

static void a_region_s_loops_hold_its_area(void)
{
    mesh m = {0};
    plane_edges e = {0};
    plane_loops stiff = {0}, soft = {0}, whole = {0};
    CHECK_OK(ring_mesh(3.2e-3, 4e-3, pi, pi / 8, &m));
    CHECK_OK(plane_edges_make(&m, &e));
    CHECK_OK(plane_loops_make(&e, 1, &stiff));
    CHECK_OK(plane_loops_make(&e, 0, &soft));
    CHECK_OK(plane_loops_make(&e, PLANE_WHOLE, &whole));
    CHECK(e.count == 4 * AROUND * RADIAL);

    const double ring = pi * (16 - 10.24) * 1e-6;
    CHECK(stiff.nloop == 1 && soft.nloop == 1 && whole.nloop == 2);
    CHECK_NEAR(plane_loop_area(&e, &stiff, 0), ring / 16, polygon_error);
    CHECK_NEAR(plane_loop_area(&e, &soft, 0), ring * 15 / 16, polygon_error);
    double sum = 0, largest = 0, least = 0;
    for (int i = 0; i < whole.nloop; i++) {
        const double area = plane_loop_area(&e, &whole, i);
        sum += area;
        largest = fmax(largest, area);
        least = fmin(least, area);
    }
    CHECK_NEAR(sum, ring, polygon_error);
    CHECK_NEAR(largest, pi * 16e-6, polygon_error);
    CHECK_NEAR(least, -pi * 10.24e-6, polygon_error); // around a hole
    plane_loops_free(&stiff);
    plane_loops_free(&soft);
    plane_loops_free(&whole);
    plane_edges_free(&e);
    mesh_free(&m);
}

// six triangles around a point, one of them of another material
static void triangles_have_sides_too(void)
{
    mesh m = {0};
    plane_edges e = {0};
    plane_loops loops = {0};
    CHECK_OK(mesh_make(1, 7, 1, &(shape){SHAPE_TRIANGLE}, &(int){6}, &m));
    m.dim = 2;
    for (int i = 0; i < 6; i++) {
        m.xyz[3 * i] = cos(pi / 3 * i);
        m.xyz[3 * i + 1] = sin(pi / 3 * i);
        const int corner[3] = {6, i, (i + 1) % 6};
        memcpy(m.block[0].conn + 3 * (size_t)i, corner, sizeof corner);
        m.block[0].material[i] = i == 2;
    }
    CHECK_OK(plane_edges_make(&m, &e));
    CHECK_OK(plane_loops_make(&e, 0, &loops));
    CHECK(loops.nloop == 1);
    CHECK_NEAR(plane_loop_area(&e, &loops, 0), 5 * sqrt(3) / 4, 1e-14);
    plane_loops_free(&loops);
    CHECK_OK(plane_loops_make(&e, PLANE_WHOLE, &loops));
    CHECK(loops.nloop == 1);
    CHECK_NEAR(plane_loop_area(&e, &loops, 0), 6 * sqrt(3) / 4, 1e-14);
    plane_loops_free(&loops);
    plane_edges_free(&e);
    mesh_free(&m);
}

static void points_on_an_edge_lie_on_the_circle(void)
{
    mesh m = {0};
    plane_edges e = {0};
    CHECK_OK(ring_mesh(3.2e-3, 4e-3, pi, pi / 8, &m));
    CHECK_OK(plane_edges_make(&m, &e));
    for (int i = 0; i < e.count; i++) {
        double p[2];
        plane_edge_point(&e, &e.edge[i], 0.3, p);
        const double r = hypot(p[0], p[1]);
        if (e.edge[i].other < 0) {
            // a cubic through four points of an arc of 2 h: R h^4 / 4! bounds its error; a chord's
            // is 2e-5 m
            const double bound = 4e-3 * pow(pi / AROUND, 4) / 24;
            CHECK(fabs(r - 4e-3) < bound || fabs(r - 3.2e-3) < bound);
        }
    }
    plane_edges_free(&e);
    mesh_free(&m);
}

static double paper_area(const facet *f)
{
    double twice = 0;
    for (int i = 0; i < f->ncorner; i++) {
        const double *a = f->at[i], *b = f->at[(i + 1) % f->ncorner];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return twice / 2;
}

// What faces the eye, projected: outside 2 R L cos(el), the ring's face pi (R^2 - r^2) sin(el), and
// inside the bore again 2 r L cos(el): all of it is painted, from the farthest to the nearest
static void facets_cover_what_is_seen(void)
{
    run_result r = {0};
    plane_edges e = {0};
    segment_surface s = {0};
    const double elevation = 0.33;
    const camera eye = camera_from(0.7, elevation);
    CHECK_OK(make_segment(&r, -0.5));
    CHECK_OK(segment_surface_make(&r.segment.body, &r.segment.load[1], SURFACE_DISPLACEMENT, 0,
                                  &eye, &s));

    double area = 0;
    for (int i = 0; i < s.count; i++) {
        CHECK(paper_area(&s.facet[i]) > 0);
        CHECK(i == 0 || s.facet[i].depth >= s.facet[i - 1].depth);
        area += paper_area(&s.facet[i]);
    }
    const double sides = 2 * (4e-3 + 3.2e-3) * 20e-3 * cos(elevation);
    const double end = pi * (16 - 10.24) * 1e-6 * sin(elevation);
    CHECK_NEAR(area, sides + end, polygon_error);
    segment_surface_free(&s);
    plane_edges_free(&e);
    synthetic_free(&r);
}

// the tip's displacement of a beam is known; the facets carry its size and stand where it moved
// them
static void facets_move_and_carry_the_displacement(void)
{
    run_result r = {0};
    plane_edges e = {0};
    segment_surface rest = {0}, moved = {0};
    const camera eye = camera_from(0, 0.4);
    CHECK_OK(make_segment(&r, -0.5));
    const segment_load_result *load = &r.segment.load[0];
    double *u = load->displacement;
    for (int i = 0; i < r.segment.body.nlevel * r.segment.body.plane.nnode; i++) {
        u[3 * i] = 3e-3;
        u[3 * i + 1] = 0;
        u[3 * i + 2] = 4e-3;
    }
    CHECK_NEAR(segment_largest(&r.segment.body, load, SURFACE_DISPLACEMENT), 5e-3, 1e-14);
    CHECK_OK(segment_surface_make(&r.segment.body, load, SURFACE_DISPLACEMENT, 0, &eye, &rest));
    CHECK_OK(segment_surface_make(&r.segment.body, load, SURFACE_DISPLACEMENT, 2, &eye, &moved));
    CHECK(rest.count == moved.count && rest.count > 0);
    double shift[2] = {0};
    for (int i = 0; i < rest.count; i++) {
        CHECK_NEAR(moved.facet[i].value, 5e-3, 1e-12);
        shift[0] += (moved.facet[i].at[0][0] - rest.facet[i].at[0][0]) / rest.count;
        shift[1] += (moved.facet[i].at[0][1] - rest.facet[i].at[0][1]) / rest.count;
    }
    // x is to the right, z is seen at cos(elevation)
    CHECK_NEAR(shift[0], 6e-3, 1e-9);
    CHECK_NEAR(shift[1], 8e-3 * cos(0.4), 1e-9);
    segment_surface_free(&rest);
    segment_surface_free(&moved);
    plane_edges_free(&e);
    synthetic_free(&r);
}

static void the_camera_is_right_handed(void)
{
    const camera c = camera_from(0.3, 0.5);
    const vec3 cross = vec3_cross(c.right, c.up);
    CHECK(vec3_norm(vec3_sub(cross, c.eye)) < 1e-15);
    CHECK_NEAR(vec3_norm(c.eye), 1, 1e-15);
    CHECK(c.up.a[2] > 0 && c.eye.a[2] > 0 && c.right.a[2] == 0);
}

int main(void)
{
    a_region_s_loops_hold_its_area();
    triangles_have_sides_too();
    points_on_an_edge_lie_on_the_circle();
    facets_cover_what_is_seen();
    facets_move_and_carry_the_displacement();
    the_camera_is_right_handed();
    return test_failures != 0;
}
