// tests/unit/meshes/test_mapped.c
#include "base/door.h"
#include "tests/shapes.h"
#include "tests/test.h"

static bool is_mapped(int n, const shape_spec *shapes)
{
    section_outline o = {0};
    CHECK_OK(shapes_at((shape_list){.count = n, .items = shapes}, 0, &o));
    const bool mapped = section_mesh_is_mapped(&o);
    section_outline_free(&o);
    return mapped;
}

static void outlines_on_one_grid_are_mapped_and_others_are_not(void)
{
    const double l[] = {0, 0, 6, 0, 6, 1, 1, 1, 1, 10, 0, 10};
    const double slanted[] = {0, 0, 6, 0, 6, 1, 1, 2, 1, 10, 0, 10};
    const shape_spec annulus = an_annulus(4, 3.2, 0);
    const shape_spec yes[][2] = {
        {annulus, a_sector(4, 3.2, PI, PI / 8, 1)},
        {a_disc(4, 0, 0, 0), a_disc(3.2, 0, 0, -1)},
        {annulus, a_sector(5, 0, 1, 1, -1)},
        {a_rectangle(2, 1, 0.3, 0, 0, 0), a_rectangle(1, 3, 0.3 + PI / 2, 1, 1, 1)},
        {a_polygon(6, l, 0), a_rectangle(1, 1, PI, 1, 1, 1)},
    };
    const shape_spec no[][2] = {
        {annulus, a_disc(0.1, 3.6, 0, -1)},            // another centre
        {a_disc(4, 0, 0, 0), a_sector(4, 3, 0, 1, 1)}, // the centre stays
        {annulus, a_rectangle(1, 1, 0, 3.6, 0, 1)},    // round and straight
        {a_rectangle(2, 1, 0.3, 0, 0, 0), a_rectangle(1, 1, 0.4, 1, 1, 1)},
        {a_polygon(6, slanted, 0), a_rectangle(1, 1, 0, 1, 1, 1)},
        {annulus, a_sector(4 * (1 + 1e-7), 3.2, PI, 1, 1)}, // a sliver
    };
    for (size_t i = 0; i < sizeof yes / sizeof *yes; i++) {
        CHECK(is_mapped(2, yes[i]));
    }
    for (size_t i = 0; i < sizeof no / sizeof *no; i++) {
        CHECK(!is_mapped(2, no[i]));
        mesh m = {0};
        CHECK(mesh_of(2, no[i], MESH_MAPPED, 2, 0, &m) == ERR_INPUT);
        CHECK(strstr(status_message(), "one polar or Cartesian grid"));
        status_clear();
    }
}

static void nodes_lie_on_the_circles(void)
{
    const shape_spec shapes[] = {an_annulus(4e-3, 3.2e-3, 0),
                                 a_sector(4e-3, 3.2e-3, PI, PI / 8, 1)};
    for (int p = 1; p <= 4; p++) {
        mesh m = {0};
        CHECK_OK(mesh_of(2, shapes, MESH_AUTO, p, 0, &m));
        CHECK_OK(mesh_check(&m));
        CHECK(m.block[0].shape == SHAPE_QUAD && m.order == p);
        CHECK(mesh_is_conforming(&m));
        int outer = 0, inner = 0;
        for (int i = 0; i < m.nnode; i++) {
            const double r = hypot(m.xyz[3 * i], m.xyz[3 * i + 1]);
            outer += fabs(r - 4e-3) < 1e-17 * 4;
            inner += fabs(r - 3.2e-3) < 1e-17 * 4;
            CHECK(r < 4e-3 + 4e-17 && r > 3.2e-3 - 4e-17 && m.xyz[3 * i + 2] == 0);
        }
        CHECK(outer == inner && outer > 0 && m.nnode % outer == 0);
        // at least two elements across the sector, each no longer than asked for
        int stiff = 0;
        for (int e = 0; e < m.block[0].nelem; e++) {
            stiff += m.block[0].material[e] == 1;
        }
        CHECK(stiff >= 2);
        mesh_free(&m);
    }
    CHECK(!door_is_open("gmsh"));
}

// the same numbers to rounding, so that a solved section can be turned instead of being solved
// again
static void a_turn_of_the_pattern_turns_the_mesh(void)
{
    for (int k = 1; k < 40; k++) {
        const double turn = k * 0.37 - 6;
        mesh m[2] = {{0}, {0}};
        for (int i = 0; i < 2; i++) {
            const shape_spec shapes[] = {an_annulus(4e-3, 3.2e-3, 0),
                                         a_sector(3.8e-3, 3.2e-3, 2 + i * turn, PI / 8, 1),
                                         a_sector(4e-3, 3.2e-3, 0.3 + i * turn, 1, 1)};
            CHECK_OK(mesh_of(3, shapes, MESH_AUTO, 3, k % 2 ? 0.7e-3 : 0, &m[i]));
        }
        CHECK(m[0].nnode == m[1].nnode && m[0].block[0].nelem == m[1].block[0].nelem);
        const double c = cos(turn), s = sin(turn);
        for (int i = 0; i < m[0].nnode && m[0].nnode == m[1].nnode; i++) {
            const double *x = m[0].xyz + 3 * i, *y = m[1].xyz + 3 * i;
            CHECK_WITHIN(c * x[0] - s * x[1], y[0], 1e-16);
            CHECK_WITHIN(s * x[0] + c * x[1], y[1], 1e-16);
        }
        CHECK(memcmp(m[0].block[0].material, m[1].block[0].material,
                     (size_t)m[0].block[0].nelem * sizeof(int)) == 0);
        mesh_free(&m[0]);
        mesh_free(&m[1]);
    }
}

static void straight_outlines_are_exact_at_every_order(void)
{
    const double l[] = {0, 0, 6, 0, 6, 1, 1, 1, 1, 10, 0, 10};
    for (int p = 1; p <= 4; p++) {
        // reference/sections.json d2: an angle
        mesh m = {0};
        const shape_spec angle = a_polygon(6, l, 0);
        CHECK_OK(mesh_of(1, &angle, MESH_AUTO, p, 0.8, &m));
        const moments q = mesh_moments(&m, -1);
        CHECK_NEAR(q.a[0], 15, 1e-13);
        CHECK_NEAR(q.a[1] / q.a[0], 1.5, 1e-13);
        CHECK_NEAR(q.a[2] / q.a[0], 3.5, 1e-13);
        CHECK_NEAR(q.a[4] - 15 * 3.5 * 3.5, 151.25, 1e-12);
        CHECK_NEAR(q.a[3] - 15 * 1.5 * 1.5, 41.25, 1e-12);
        CHECK_NEAR(q.a[5] - 15 * 1.5 * 3.5, -45, 1e-12);
        CHECK_NEAR(mesh_boundary_length(&m), 32, 1e-13);
        CHECK(mesh_is_conforming(&m));
        mesh_free(&m);

        // a box with a rib, turned
        const shape_spec box[] = {a_rectangle(6, 4, 0.7, 1, 2, 0), a_rectangle(5, 3, 0.7, 1, 2, -1),
                                  a_rectangle(0.5, 3, 0.7, 1, 2, 1)};
        CHECK_OK(mesh_of(3, box, MESH_MAPPED, p, 0, &m));
        CHECK_NEAR(mesh_moments(&m, 0).a[0], 9, 1e-13);
        CHECK_NEAR(mesh_moments(&m, 1).a[0], 1.5, 1e-13);
        CHECK_NEAR(mesh_moments(&m, 1).a[1], 1.5, 1e-13); // centre at x = 1
        CHECK_NEAR(mesh_moments(&m, 0).a[2], 18, 1e-13);  // and y = 2
        CHECK_NEAR(mesh_boundary_length(&m), 20 + 2 * (2 * 2.25 + 2 * 3), 1e-13);
        mesh_free(&m);
    }
}

static void the_size_is_kept(void)
{
    const shape_spec plate = a_rectangle(4e-3, 1e-3, 0, 0, 0, 0);
    mesh m = {0};
    CHECK_OK(mesh_of(1, &plate, MESH_AUTO, 2, 0.5e-3, &m));
    CHECK(m.block[0].nelem == 8 * 2);
    mesh_free(&m);
    const shape_spec ring = an_annulus(1, 0.8, 0);
    CHECK_OK(mesh_of(1, &ring, MESH_AUTO, 2, 0.1, &m));
    CHECK(m.block[0].nelem == 63 * 2); // 2 pi / 0.1 rounded up
    mesh_free(&m);
    CHECK(mesh_of(1, &ring, MESH_AUTO, 2, 1e-6, &m) == ERR_INPUT);
    CHECK(strstr(status_message(), "more than"));
    status_clear();
}

static void check_refused(int n, const shape_spec *shapes, int kind, const char *why)
{
    mesh m = {0};
    CHECK(mesh_of(n, shapes, kind, 2, 0, &m) == ERR_INPUT);
    if (!strstr(status_message(), why)) {
        printf("message: %s, wanted: %s\n", status_message(), why);
    }
    CHECK(strstr(status_message(), why));
    status_clear();
}

static void sections_that_do_not_hold_together_are_refused(void)
{
    const shape_spec apart[] = {an_annulus(4, 3, 0), an_annulus(2, 1, 1)};
    check_refused(2, apart, MESH_AUTO, "does not touch the rest");
    const shape_spec corner[] = {a_rectangle(1, 1, 0, 0, 0, 0), a_rectangle(1, 1, 0, 1, 1, 1)};
    check_refused(2, corner, MESH_AUTO, "single points");
    const shape_spec cut[] = {an_annulus(4, 3, 0), a_disc(5, 0, 0, -1)};
    check_refused(2, cut, MESH_AUTO, "empty");
    // a ring cut through twice
    const shape_spec halves[] = {an_annulus(4, 3, 0), a_sector(4, 3, 0, 0.1, -1),
                                 a_sector(4, 3, PI, 0.1, -1)};
    check_refused(3, halves, MESH_AUTO, "does not touch the rest");
    CHECK(!door_is_open("gmsh"));
}

int main(void)
{
    outlines_on_one_grid_are_mapped_and_others_are_not();
    nodes_lie_on_the_circles();
    a_turn_of_the_pattern_turns_the_mesh();
    straight_outlines_are_exact_at_every_order();
    the_size_is_kept();
    sections_that_do_not_hold_together_are_refused();
    return test_failures != 0;
}
