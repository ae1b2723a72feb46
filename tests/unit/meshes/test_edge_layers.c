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

// a tenth of the fifth of the wall, then five times that, and one element in the middle
static void a_wall_has_layers_from_both_sides(void)
{
    const shape_spec shapes[] = {an_annulus(4, 3, 0), a_sector(4, 3, PI, PI / 8, 1)};
    const mesh_options options = {.order = 4, .edge_layers = 2};
    const double wall[] = {3, 3.02, 3.12, 3.88, 3.98, 4};
    ladder l[2] = {{0}, {0}};
    CHECK_OK(ladders_of(2, shapes, &options, l));
    CHECK(l[0].n == 5);
    for (int i = 0; i <= l[0].n && l[0].n == 5; i++) {
        CHECK_NEAR(l[0].edge[i], wall[i], 1e-14);
    }
    // four times that at the interfaces, along the outer arc
    CHECK_NEAR(l[1].edge[1] - l[1].edge[0], 0.08 / 4, 1e-14);
    CHECK_NEAR(l[1].edge[l[1].n] - l[1].edge[l[1].n - 1], 0.08 / 4, 1e-13);
    for (int i = 0; i < l[1].n; i++) {
        CHECK(l[1].edge[i + 1] - l[1].edge[i] < 1.0001);
    }
    CHECK(l[1].n <= 18);
    free_ladders(l);
    // the first layer can be said
    const mesh_options said = {.order = 4, .edge_layers = 1, .edge_first = 0.01};
    CHECK_OK(ladders_of(2, shapes, &said, l));
    CHECK_NEAR(l[0].edge[1], 3.04, 1e-14);
    CHECK(l[0].n == 5);
    free_ladders(l);
    // longer than anything can take: the largest elements there are
    const mesh_options none = {.order = 4, .edge_layers = 1, .edge_first = 1};
    CHECK_OK(ladders_of(2, shapes, &none, l));
    CHECK(l[0].n == 1 && l[1].n == 3 + 9);
    CHECK_NEAR(l[1].edge[1], 0.3 * PI / 8, 1e-14);
    free_ladders(l);
}

// all free edges begin with the same length, so that thicker parts take more layers; the hole's
// width counts where there is material beside it
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
            CHECK(before < 1.001 * SIZING_GROWTH * SIZING_STRETCH &&
                  before * SIZING_GROWTH * SIZING_STRETCH > 0.999);
        }
        CHECK_NEAR(least, 0.1, 1e-13);
    }
    // 4.5, 1 and 14.5 across with 0.1 from both ends; 1, 2 and 1 the other way
    CHECK(l[0].n == 5 + 3 + 7 && l[1].n == 3 + 5 + 3);
    free_ladders(l);
}

// the node at (x, -y) of every node, to rounding
static bool is_mirrored(const mesh *m, double angle, double tolerance)
{
    const double c = cos(2 * angle), s = sin(2 * angle);
    bool found = true;
    for (int i = 0; i < m->nnode && found; i++) {
        const double *p = m->xyz + 3 * i, x = c * p[0] + s * p[1], y = s * p[0] - c * p[1];
        found = false;
        for (int k = 0; k < m->nnode && !found; k++) {
            found = fabs(m->xyz[3 * k] - x) + fabs(m->xyz[3 * k + 1] - y) < tolerance;
        }
    }
    return found;
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

static double area_of(const mesh *m, int material)
{
    double sum = 0;
    for (int b = 0; b < m->nblock; b++) {
        mesh one = *m;
        one.block[0] = m->block[b];
        sum += mesh_moments(&one, material).a[0];
    }
    return sum;
}

// shortest edge of an element
static double shortest_edge(const mesh *m)
{
    int nside = 0, *corner = NULL;
    double least = INFINITY;
    CHECK_OK(mesh_corners(m, &nside, &corner));
    for (int i = 0; corner && i < mesh_element_count(m) * nside; i++) {
        const int a = corner[i], b = corner[i - i % nside + (i % nside + 1) % nside];
        const double *x = m->xyz + 3 * a, *y = m->xyz + 3 * b;
        least = a != b ? fmin(least, hypot(x[0] - y[0], x[1] - y[1])) : least;
    }
    free(corner);
    return least;
}

typedef struct drawn {
    int n;
    shape_spec shapes[4];
    double area;
} drawn;

// triangles whose sides ask for layers in every combination: walls thinner than a triangle is
// long, corners, interfaces that end on free edges, lined holes
static void triangles_are_cut_along_their_edges(void)
{
    static const double angle[] = {0, 0, 6, 0, 6, 1, 1, 1, 1, 10, 0, 10};
    static const double triangle[] = {0, 0, 1, 0, 0.3, 0.8};
    const drawn cases[] = {
        {2, {an_annulus(4, 3.2, 0), a_sector(4, 3.2, PI, PI / 8, 1)}, PI * (16 - 3.2 * 3.2)},
        {3,
         {a_disc(4, 0, 0, 0), lumens_on_a_circle(0.6, 4, 2.4, 0, 1),
          lumens_on_a_circle(0.5, 4, 2.4, 0, -1)},
         PI * (16 - 1)},
        {1, {a_polygon(6, angle, 0)}, 15},
        {1, {a_polygon(3, triangle, 0)}, 0.4},
        {2,
         {an_ellipse(4, 2, 0.3, 0, 0, 0), a_rounded_rectangle(2, 1, 0.2, 0.3, -1)},
         PI * 8 - 2 + 0.04 * (4 - PI)},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        for (int p = 1; p <= 4; p++) {
            const drawn *c = &cases[i];
            const mesh_options options = {.kind = MESH_FREE,
                                          .order = p,
                                          .edge_layers = 1 + p / 3,
                                          .edge_first = p % 2 ? 0.003 : 0};
            mesh m = {0};
            CHECK_OK(layered(c->n, c->shapes, &options, &m));
            CHECK(m.nblock == 2 && m.block[0].nelem > 0 && m.block[1].nelem > 0);
            CHECK(mesh_is_conforming(&m));
            const double off[] = {0, 5e-3, 1e-4, 2e-5, 2e-6}; // theory (8.2)
            CHECK_NEAR(area_of(&m, -1), c->area, off[p]);
            mesh_free(&m);
        }
    }
}

// the cuts lie on edges that lean, so that the smallest side is a part of the first layer; the
// triangles to be cut are the same ones
static void first_layers_of_triangles_are_as_thick_as_asked_for(void)
{
    const shape_spec plate = a_rectangle(6, 8, 0, 0, 0, 0);
    double part = 0;
    for (int k = 0; k < 4; k++) {
        const double first = 0.01 * pow(4, -k); // of a radius of 5
        const mesh_options options = {
            .kind = MESH_FREE, .order = 2, .size = 2, .edge_layers = 1, .edge_first = first};
        mesh m = {0};
        CHECK_OK(layered(1, &plate, &options, &m));
        part = k ? part : shortest_edge(&m) / (5 * first);
        CHECK(part > 0.5 && part < 1.0001);
        CHECK_NEAR(shortest_edge(&m), part * 5 * first, 1e-9);
        mesh_free(&m);
    }
}

static void materials_stay_in_their_triangles(void)
{
    const shape_spec shapes[] = {an_annulus(4, 3.2, 0), a_sector(4, 3.2, PI, PI / 8, 1)};
    const mesh_options options = {
        .kind = MESH_FREE, .order = 3, .edge_layers = 2, .edge_first = 0.001};
    const double stiff = PI / 16 * (16 - 3.2 * 3.2);
    mesh m = {0};
    CHECK_OK(layered(2, shapes, &options, &m));
    CHECK_NEAR(area_of(&m, 0), 15 * stiff, 2e-5);
    CHECK_NEAR(area_of(&m, 1), stiff, 2e-5);
    mesh_free(&m);
}

static void nonsense_is_refused(void)
{
    const shape_spec plate = a_rectangle(6, 8, 0, 0, 0, 0);
    const mesh_options bad[] = {{.order = 2, .edge_layers = -1},
                                {.order = 2, .edge_layers = 9},
                                {.order = 2, .edge_layers = 1, .edge_first = -1},
                                {.order = 2, .edge_layers = 1, .edge_first = NAN},
                                {.order = 4, .edge_layers = 1, .edge_first = 0.1, .size = 1e-9}};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        mesh m = {0};
        CHECK(layered(1, &plate, &bad[i], &m) == ERR_INPUT);
        status_clear();
    }
}

int main(void)
{
    triangles_are_cut_along_their_edges();
    first_layers_of_triangles_are_as_thick_as_asked_for();
    materials_stay_in_their_triangles();
    nonsense_is_refused();
    a_wall_has_layers_from_both_sides();
    thick_parts_take_more_layers();
    symmetric_sections_get_symmetric_meshes();
    areas_stay_exact();
    return test_failures != 0;
}
