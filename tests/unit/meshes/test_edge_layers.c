// tests/unit/meshes/test_edge_layers.c
// Elements that shrink towards free edges and interfaces.
#include "meshes/grid_ladders.h"
#include "meshes/sizing.h"
#include "tests/shapes.h"
#include "tests/test.h"

static status layered(int n, const shape_spec *shapes, const mesh_options *options, mesh *out)
{
    section_outline o = {0};
    status st = shapes_at((shape_list){.count = n, .items = shapes}, 0, &o);
    st = st == OK ? section_mesh_make(&o, options, out) : st;
    section_outline_free(&o);
    return st;
}

static status ladders_of(int n, const shape_spec *shapes, const mesh_options *options, ladder l[2])
{
    section_outline o = {0};
    grid g = {0};
    bool found = false;
    status st = shapes_at((shape_list){.count = n, .items = shapes}, 0, &o);
    st = st == OK ? grid_make(&o, &g, &found) : st;
    CHECK(found);
    st = st == OK ? grid_ladders_make(&o, &g, options, l) : st;
    grid_free(&g);
    section_outline_free(&o);
    return st;
}

static void free_ladders(ladder l[2])
{
    ladder_free(&l[0]);
    ladder_free(&l[1]);
}

// a fifth of the fifth of the wall, then five times that, and one element in the middle
static void a_wall_has_layers_from_both_sides(void)
{
    const shape_spec shapes[] = {an_annulus(4, 3, 0), a_sector(4, 3, PI, PI / 8, 1)};
    const mesh_options options = {.order = 4, .edge_layers = 2};
    const double wall[] = {3, 3.04, 3.24, 3.76, 3.96, 4};
    ladder l[2] = {{0}, {0}};
    CHECK_OK(ladders_of(2, shapes, &options, l));
    CHECK(l[0].n == 5);
    for (int i = 0; i <= l[0].n && l[0].n == 5; i++) {
        CHECK_NEAR(l[0].edge[i], wall[i], 1e-14);
    }
    // one layer less at the interfaces: a fifth of the wall along the outer arc
    CHECK_NEAR(l[1].edge[1] - l[1].edge[0], 0.2 / 4, 1e-14);
    CHECK_NEAR(l[1].edge[l[1].n] - l[1].edge[l[1].n - 1], 0.2 / 4, 1e-13);
    for (int i = 0; i < l[1].n; i++) {
        CHECK(l[1].edge[i + 1] - l[1].edge[i] < 1.2001);
    }
    CHECK(l[1].n <= 14);
    free_ladders(l);
    // the first layer can be said, and then interfaces without any
    const mesh_options said = {.order = 4, .edge_layers = 1, .edge_first = 0.01};
    CHECK_OK(ladders_of(2, shapes, &said, l));
    CHECK_NEAR(l[0].edge[1], 3.04, 1e-14);
    CHECK(l[0].n == 5 && l[1].cell[0] == 0 && l[1].cell[1] == 1);
    free_ladders(l);
    // longer than the wall can take: its fifth
    const mesh_options thick = {.order = 4, .edge_layers = 1, .edge_first = 0.5};
    CHECK_OK(ladders_of(2, shapes, &thick, l));
    CHECK(l[0].n == 3);
    CHECK_NEAR(l[0].edge[1], 3.2, 1e-14);
    free_ladders(l);
}

// all free edges begin with the same length, so that thicker parts take more layers; the hole's
// width does not count
static void thick_parts_take_more_layers(void)
{
    const shape_spec box[] = {a_rectangle(20, 4, 0, 0, 0, 0), a_rectangle(1, 2, 0, -5, 0, -1)};
    const mesh_options options = {.order = 3, .edge_layers = 1, .size = 100};
    ladder l[2] = {{0}, {0}};
    CHECK_OK(ladders_of(2, box, &options, l));
    for (int d = 0; d < 2; d++) {
        double least = INFINITY;
        for (int i = 0; i < l[d].n; i++) {
            const double h = l[d].edge[i + 1] - l[d].edge[i];
            const double before = i ? h / (l[d].edge[i] - l[d].edge[i - 1]) : 1;
            least = fmin(least, h);
            CHECK(before < SIZING_GROWTH * SIZING_STRETCH && before * SIZING_GROWTH > 1.0 / 3);
        }
        CHECK_NEAR(least, 0.2, 1e-13);
    }
    CHECK(l[0].n == 5 + 3 + 5 && l[1].n == 3 + 3 + 3);
    free_ladders(l);
}

// the node at (x, -y) of every node, to rounding
static bool is_mirrored(const mesh *m, double angle, double tolerance)
{
    const double c = cos(2 * angle), s = sin(2 * angle);
    int missing = 0;
    for (int i = 0; i < m->nnode; i++) {
        const double *p = m->xyz + 3 * i, x = c * p[0] + s * p[1], y = s * p[0] - c * p[1];
        bool found = false;
        for (int k = 0; k < m->nnode && !found; k++) {
            found = fabs(m->xyz[3 * k] - x) + fabs(m->xyz[3 * k + 1] - y) < tolerance;
        }
        missing += !found;
    }
    return missing == 0;
}

static void symmetric_sections_get_symmetric_meshes(void)
{
    const double rounding = 4e-15; // of coordinates up to 5, and angles up to 10
    for (int k = 0; k < 8; k++) {
        const double mid = k ? 0.9 * k - 3 : PI, turn = 0.7 * k;
        const shape_spec ring[] = {an_annulus(4, 3.2, 0), a_sector(3.9, 3.2, mid, 0.5, 1)};
        const shape_spec one[] = {an_annulus(4, 3.2, 0)};
        const shape_spec box[] = {a_rectangle(8, 6, turn, 0, 0, 0),
                                  a_rectangle(5, 4, turn, 0, 0, -1),
                                  a_rectangle(1, 6, turn, 0, 0, 1)};
        const mesh_options options = {.order = 1 + k % 4, .edge_layers = k / 2};
        mesh m = {0};
        CHECK_OK(layered(2, ring, &options, &m));
        CHECK(is_mirrored(&m, mid, 10 * rounding));
        CHECK(!is_mirrored(&m, mid + 0.1, 10 * rounding));
        mesh_free(&m);
        CHECK_OK(layered(1, one, &options, &m));
        CHECK(is_mirrored(&m, 0, 10 * rounding));
        mesh_free(&m);
        CHECK_OK(layered(3, box, &options, &m));
        CHECK(is_mirrored(&m, turn, 10 * rounding));
        CHECK(is_mirrored(&m, turn + PI / 2, 10 * rounding));
        mesh_free(&m);
    }
}

static void areas_stay_exact(void)
{
    const shape_spec shapes[] = {an_annulus(4, 3.2, 0), a_sector(4, 3.2, PI, PI / 8, 1)};
    const double stiff = PI / 16 * (16 - 3.2 * 3.2), soft = 15 * stiff;
    const double off[] = {0, 2e-3, 4e-5, 4e-6, 3e-7}; // theory (8.2) with the longest arcs
    for (int p = 1; p <= 4; p++) {
        const mesh_options options = {.order = p, .edge_layers = 2};
        mesh m = {0};
        CHECK_OK(layered(2, shapes, &options, &m));
        CHECK(mesh_is_conforming(&m));
        CHECK_NEAR(mesh_moments(&m, 0).a[0], soft, off[p]);
        CHECK_NEAR(mesh_moments(&m, 1).a[0], stiff, off[p]);
        mesh_free(&m);
    }
}

int main(void)
{
    a_wall_has_layers_from_both_sides();
    thick_parts_take_more_layers();
    symmetric_sections_get_symmetric_meshes();
    areas_stay_exact();
    return test_failures != 0;
}
