// tests/unit/meshes/test_shape_frame.c
#include "tests/shapes.h"
#include "tests/test.h"

// exact input, a handful of operations
static const double ROUNDING = 1e-14;

// the frame of the element whose nodes surround the point best; NULL: the section's own
static const material_frame *frame_near(const mesh *m, double x, double y)
{
    const material_frame *found = NULL;
    double nearest = INFINITY;
    for (int b = 0; b < m->nblock; b++) {
        const mesh_block *k = &m->block[b];
        for (int e = 0; e < k->nelem; e++) {
            double mean[2] = {0};
            for (int i = 0; i < k->per_elem; i++) {
                const double *p = m->xyz + 3 * k->conn[e * k->per_elem + i];
                mean[0] += p[0] / k->per_elem;
                mean[1] += p[1] / k->per_elem;
            }
            const double off = hypot(mean[0] - x, mean[1] - y);
            if (off < nearest) {
                nearest = off;
                found = k->frame && k->frame[e] >= 0 ? &m->frame[k->frame[e]] : NULL;
            }
        }
    }
    return found;
}

static void check_direction(const double *a, double x, double y, double z)
{
    CHECK_WITHIN(a[0], x, ROUNDING);
    CHECK_WITHIN(a[1], y, ROUNDING);
    CHECK_WITHIN(a[2], z, ROUNDING);
}

static void shapes_without_axes_leave_the_mesh_without_frames(void)
{
    const shape_spec ring = an_annulus(4e-3, 3e-3, 0);
    mesh m = {0};
    CHECK_OK(mesh_of(1, &ring, MESH_AUTO, 2, 0, &m));
    CHECK(m.nframe == 0 && !m.frame && !m.block[0].frame);
    mesh_free(&m);
}

static void tangent_axes_follow_the_circle_and_others_stay(void)
{
    shape_spec shapes[] = {an_annulus(4e-3, 3e-3, 0), a_sector(4e-3, 3e-3, 1, 0.5, 1)};
    shapes[1].axes = SHAPE_AXES_TANGENT;
    mesh m = {0}, lower = {0};
    CHECK_OK(mesh_of(2, shapes, MESH_AUTO, 3, 0, &m));
    CHECK(m.nframe == 1);
    CHECK(frame_near(&m, -3.5e-3, 0) == NULL);

    const double x = 3.5e-3 * cos(1), y = 3.5e-3 * sin(1);
    CHECK_OK(mesh_of_order(&m, 2, &lower)); // frames stay with coarser meshes
    const mesh *both[] = {&m, &lower};
    for (int i = 0; i < 2; i++) {
        const material_frame *f = frame_near(both[i], x, y);
        CHECK(f != NULL);
        if (f) {
            const mat3 a = material_frame_axes_at(f, x, y);
            check_direction(a.a[0], 0, 0, 1);
            check_direction(a.a[1], -sin(1), cos(1), 0);
            check_direction(a.a[2], -cos(1), -sin(1), 0);
        }
    }
    mesh_free(&m);
    mesh_free(&lower);
}

// a rectangle turned by 0.3: its own x axis is the 2 axis, and a fibre at 90 degrees lies along it
static void tangent_axes_of_a_rectangle_are_its_own(void)
{
    shape_spec shapes[] = {a_rectangle(2, 1, 0.3, 0, 0, 0), a_rectangle(1, 0.5, 0.3, 0, 0, 1)};
    shapes[0].axes = shapes[1].axes = SHAPE_AXES_TANGENT;
    shapes[1].fibre_angle = fixed(PI / 2);
    shapes[1].plane_angle = fixed(0.2);
    mesh m = {0};
    CHECK_OK(mesh_of(2, shapes, MESH_AUTO, 1, 0, &m));
    const material_frame *outer = frame_near(&m, 0.9 * cos(0.3), 0.9 * sin(0.3));
    const material_frame *inner = frame_near(&m, 0, 0);
    CHECK(m.nframe == 2 && outer && inner);
    if (outer && inner) {
        check_direction(outer->axes.a[0], 0, 0, 1);
        check_direction(outer->axes.a[1], cos(0.3), sin(0.3), 0);
        check_direction(inner->axes.a[0], cos(0.5), sin(0.5), 0); // the fibre
        check_direction(inner->axes.a[2], -sin(0.5), cos(0.5), 0);
    }
    mesh_free(&m);
}

// both meshers: a disc off the middle of a rectangle wants the free one
static void free_meshes_carry_frames_too(void)
{
    shape_spec shapes[] = {a_rectangle(4, 3, 0, 0, 0, 0), a_disc(0.5, 1, 0.5, 1)};
    shapes[0].plane_angle = fixed(0.7);
    shapes[1].axes = SHAPE_AXES_TANGENT;
    mesh m = {0};
    CHECK_OK(mesh_of(2, shapes, MESH_FREE, 2, 0, &m));
    const material_frame *outside = frame_near(&m, -1, -1), *inside = frame_near(&m, 1.2, 0.5);
    CHECK(m.nframe == 2 && outside && inside);
    if (outside && inside) {
        CHECK(!outside->polar && inside->polar);
        check_direction(outside->axes.a[1], cos(0.7), sin(0.7), 0);
        const mat3 a = material_frame_axes_at(inside, 1, 0.8); // above its centre
        check_direction(a.a[1], -1, 0, 0);
    }
    mesh_free(&m);
}

static double twice(const void *unused, double s)
{
    (void)unused;
    return 2 * s;
}

static void angles_may_vary_along_the_rod(void)
{
    shape_spec ring = an_annulus(4e-3, 3e-3, 0);
    CHECK(!shapes_vary((shape_list){1, &ring}));
    ring.fibre_angle = (field){.at = twice};
    CHECK(shapes_vary((shape_list){1, &ring}));
    section_outline o = {0};
    CHECK_OK(shapes_at((shape_list){1, &ring}, 0.2, &o));
    CHECK(o.items[0].has_frame);
    check_direction(o.items[0].frame.axes.a[0], sin(0.4), 0, cos(0.4));
    section_outline_free(&o);
    ring.fibre_angle = fixed(NAN);
    CHECK(shapes_at((shape_list){1, &ring}, 0, &o) == ERR_INPUT);
    status_clear();
}

int main(void)
{
    shapes_without_axes_leave_the_mesh_without_frames();
    tangent_axes_follow_the_circle_and_others_stay();
    tangent_axes_of_a_rectangle_are_its_own();
    free_meshes_carry_frames_too();
    angles_may_vary_along_the_rod();
    return test_failures != 0;
}
