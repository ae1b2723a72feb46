// tests/unit/section/test_classical.c
#include "section/section.h"
#include "tests/test.h"

static const double pi = 3.14159265358979323846;

static const material soft = {.name = "soft", .E = 2e6, .nu = 0.25};

// b x h about (x, y) as one bilinear quad
static mesh one_quad(double x, double y, double b, double h)
{
    mesh m = {0};
    const shape quad = SHAPE_QUAD;
    const int one = 1;
    CHECK_OK(mesh_make(1, 4, 1, &quad, &one, &m));
    for (int i = 0; i < 4; i++) {
        m.xyz[3 * i] = x + (i % 2 ? b : -b) / 2;
        m.xyz[3 * i + 1] = y + (i / 2 ? h : -h) / 2;
        m.block[0].conn[i] = i;
    }
    return m;
}

static void rectangle_by_parallel_axes(void)
{
    const double x = 0.3, y = -0.2, b = 0.02, h = 0.05, A = b * h, E = soft.E, G = E / 2.5;
    mesh m = one_quad(x, y, b, h);
    beam_law law = {0};
    CHECK_OK(section_classical_mesh(&m, &soft, &law));
    mesh_free(&m);
    const double Ixx = b * h * h * h / 12, Iyy = h * b * b * b / 12;
    CHECK_NEAR(law.area, A, 1e-14);
    CHECK_NEAR(law.K.a[NX][NX], G * A, 1e-14);
    CHECK_NEAR(law.K.a[NZ][NZ], E * A, 1e-14);
    CHECK_NEAR(law.K.a[NZ][MX], E * A * y, 1e-14);
    CHECK_NEAR(law.K.a[NZ][MY], -E * A * x, 1e-14);
    CHECK_NEAR(law.K.a[MX][MX], E * (Ixx + A * y * y), 1e-14);
    CHECK_NEAR(law.K.a[MY][MY], E * (Iyy + A * x * x), 1e-14);
    CHECK_NEAR(law.K.a[MX][MY], -E * A * x * y, 1e-14);
    CHECK_NEAR(law.K.a[NY][MZ], G * A * x, 1e-14);
    CHECK_NEAR(law.K.a[MZ][MZ], G * (Ixx + Iyy + A * (x * x + y * y)), 1e-14);
}

// --- rings, discs and sectors

static beam_law closed(int count, outline *items, const material *materials)
{
    const section_outline o = {.count = count, .items = items, .size = 1};
    beam_law law = {0};
    bool done = false;
    CHECK_OK(section_classical_closed(&o, materials, &law, &done));
    CHECK(done);
    return law;
}

static void disc_with_a_hole_off_the_origin(void)
{
    outline items[2] = {{.kind = KIND_DISC, .outer = 0.4, .centre = {0.1, 0.2}},
                        {.kind = KIND_DISC, .outer = 0.3, .centre = {0.1, 0.2}, .material = -1}};
    const beam_law law = closed(2, items, &soft);
    const double A = pi * (0.16 - 0.09), I = pi / 4 * (0.0256 - 0.0081);
    CHECK_NEAR(law.area, A, 1e-14);
    CHECK_NEAR(law.K.a[MX][MX], soft.E * (I + A * 0.04), 1e-14);
    CHECK_NEAR(law.K.a[MY][MY], soft.E * (I + A * 0.01), 1e-14);
    CHECK_NEAR(law.K.a[MX][MY], -soft.E * A * 0.02, 1e-13);
}

// the same region drawn in two ways: a half ring, and a ring from which the other half is cut
// across the angle 0
static void layers_cover_one_another(void)
{
    outline half[1] = {{.kind = KIND_SECTOR, .outer = 2, .inner = 1, .mid_angle = pi, .width = pi}};
    outline cut[2] = {{.kind = KIND_ANNULUS, .outer = 2, .inner = 1},
                      {.kind = KIND_SECTOR,
                       .outer = 3,
                       .inner = 0,
                       .mid_angle = -4 * pi,
                       .width = pi,
                       .material = -1}};
    const beam_law a = closed(1, half, &soft), b = closed(2, cut, &soft);
    CHECK(mat6_relative_error(a.K, b.K) < 1e-14);
    CHECK_NEAR(a.area, 1.5 * pi, 1e-14);
    // centroid of a half ring: 4 (ro^3 - ri^3) / (3 pi (ro^2 - ri^2))
    CHECK_NEAR(-a.K.a[NZ][MY] / a.K.a[NZ][NZ], -28 / (9 * pi), 1e-14);
}

static void closed_form_agrees_with_the_papers(void)
{
    const material two[2] = {{.E = 0.66e6, .nu = 0.45}, {.E = 15.93e6, .nu = 0.45}};
    const annulus_two_materials a = {4e-3, 3.2e-3, 2.5, 0.7, two[0].E, two[1].E};
    outline items[2] = {{.kind = KIND_ANNULUS, .outer = a.outer, .inner = a.inner},
                        {.kind = KIND_SECTOR,
                         .outer = a.outer,
                         .inner = a.inner,
                         .mid_angle = a.mid_angle,
                         .width = a.width,
                         .material = 1}};
    const beam_law law = closed(2, items, two);
    const annulus_closed_form c = annulus_closed(&a);
    beam_centres centres = {0};
    CHECK_OK(beam_law_centres_near(&law, a.mid_angle, &centres));
    CHECK_NEAR(centres.EA, c.EA, 1e-13);
    CHECK_NEAR(centres.stiffness_centre[0], c.r_nc * cos(a.mid_angle), 1e-13);
    CHECK_NEAR(centres.stiffness_centre[1], c.r_nc * sin(a.mid_angle), 1e-13);
    CHECK_NEAR(centres.EI[0], c.EI_centre[0], 1e-13);
    CHECK_NEAR(centres.EI[1], c.EI_centre[1], 1e-13);
    CHECK_NEAR(centres.principal_angle, a.mid_angle, 1e-13);
}

// three rings, a slice that reaches the centre and a cut, against the mesh of the same outlines
static void closed_form_agrees_with_a_mesh(void)
{
    const material three[3] = {{.E = 1, .nu = 0.3}, {.E = 5, .nu = 0.1}, {.E = 20, .nu = 0.4}};
    outline items[4] = {
        {.kind = KIND_ANNULUS, .outer = 1, .inner = 0.2},
        {.kind = KIND_ANNULUS, .outer = 0.7, .inner = 0.5, .material = 1},
        {.kind = KIND_SECTOR,
         .outer = 0.9,
         .inner = 0.6,
         .mid_angle = -0.1,
         .width = 1.1,
         .material = 2},
        {.kind = KIND_SECTOR,
         .outer = 1,
         .inner = 0.2,
         .mid_angle = 2,
         .width = 0.5,
         .material = -1},
    };
    const section_outline o = {.count = 4, .items = items, .size = 1};
    const beam_law exact = closed(4, items, three);
    mesh m = {0};
    beam_law law = {0};
    const mesh_options options = {.kind = MESH_MAPPED, .order = 4, .size = 0.1};
    CHECK_OK(section_mesh_make(&o, &options, &m));
    CHECK_OK(section_classical_mesh(&m, three, &law));
    mesh_free(&m);
    // arcs of 0.1 rad at order 8
    CHECK(mat6_relative_error(law.K, exact.K) < 1e-11);
    CHECK_NEAR(law.area, exact.area, 1e-11);
}

static void other_outlines_are_left_to_meshes(void)
{
    outline items[2] = {{.kind = KIND_DISC, .outer = 1},
                        {.kind = KIND_RECTANGLE, .size = {0.1, 0.1}, .material = -1}};
    section_outline o = {.count = 2, .items = items, .size = 1};
    beam_law law = {0};
    bool done = true;
    CHECK_OK(section_classical_closed(&o, &soft, &law, &done));
    CHECK(!done);
    items[1] = (outline){.kind = KIND_DISC, .outer = 0.1, .centre = {0.5, 0}, .material = -1};
    CHECK_OK(section_classical_closed(&o, &soft, &law, &done));
    CHECK(!done);
    items[1] = (outline){.kind = KIND_DISC, .outer = 2, .material = -1};
    CHECK(section_classical_closed(&o, &soft, &law, &done) == ERR_INPUT);
    status_clear();
}

int main(void)
{
    rectangle_by_parallel_axes();
    disc_with_a_hole_off_the_origin();
    layers_cover_one_another();
    closed_form_agrees_with_the_papers();
    closed_form_agrees_with_a_mesh();
    other_outlines_are_left_to_meshes();
    return test_failures != 0;
}
