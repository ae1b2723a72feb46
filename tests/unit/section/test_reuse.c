// tests/unit/section/test_reuse.c
// Sections that only turn, scale or mirror are solved once, and what is carried over is what a
// solve would give.
#include "section/known.h"
#include "section/reuse.h"
#include "tests/test.h"

#include <math.h>

static const double pi = 3.14159265358979323846, length = 0.12;
static const material two[] = {{.E = 0.66e6, .nu = 0.3, .density = 1100},
                               {.E = 15.93e6, .nu = 0.3, .density = 1250}};

static double growing(const void *unused, double s)
{
    (void)unused;
    return 1 + s / length;
}

static double outer(const void *unused, double s)
{
    (void)unused;
    return 4e-3 * (1 + s / length);
}

static double inner(const void *unused, double s)
{
    (void)unused;
    return 3e-3 * (1 + s / length);
}

static double half_turn(const void *unused, double s)
{
    (void)unused;
    return pi * s / length;
}

// a stiff sector beside a stiff disc, without any symmetry
static section_case lopsided(shape_spec shapes[3], double sign)
{
    const ring_spec ring = {.outer_radius = field_constant(4e-3),
                            .inner_radius = field_constant(3e-3)};
    shapes[0] = (shape_spec){.annulus = ring, .material_index = 0};
    shapes[0].annulus.at = (mark){1, 1};
    for (int i = 1; i < 3; i++) {
        shapes[i] = (shape_spec){.sector = ring, .material_index = 1};
        shapes[i].sector.at = (mark){1, 1};
        shapes[i].sector.mid_angle = field_constant(sign * (i == 1 ? 1.9 : 0.3));
        shapes[i].sector.width = field_constant(i == 1 ? 0.3 : 0.8);
    }
    section_case c = section_case_default();
    c.nmaterial = 2;
    c.shapes = (key_list){.count = 3, .items = shapes};
    c.mesh.order = 2;
    return c;
}

static beam_law law_at(section_store *store, double s)
{
    solved_section one = {0};
    CHECK_OK(section_store_law(store, s, &one));
    section_place_free(&one.place);
    return one.body;
}

static bool same_mass(const beam_law *a, const beam_law *b)
{
    const double x = a->mass_centre[0] - b->mass_centre[0];
    const double y = a->mass_centre[1] - b->mass_centre[1];
    return b->mass > 0 && fabs(a->mass - b->mass) < 1e-12 * b->mass &&
           hypot(x, y) < 1e-12 * hypot(b->mass_centre[0], b->mass_centre[1]);
}

// the whole section scaled by its key
static void scaled_copies(void)
{
    shape_spec shapes[3];
    section_case c = lopsided(shapes, 1);
    section_store store = {0};
    beam_law direct = {0};
    c.scale = (field){.at = growing};
    CHECK_OK(section_store_make(&c, two, length, &store));
    (void)law_at(&store, 0);
    const beam_law carried = law_at(&store, 0.06);
    CHECK(store.effort.nsolved == 1 && store.effort.nscaled == 1);
    CHECK_OK(section_solve(&c, two, 0.06, length, &direct));
    CHECK(mat6_relative_error(carried.K, direct.K) < 1e-10);
    CHECK_NEAR(carried.area, direct.area, 1e-12);
    CHECK(same_mass(&carried, &direct));
    section_store_free(&store);
}

// radii that grow together are one section, too
static void drawn_larger(void)
{
    shape_spec shapes[3];
    section_case c = lopsided(shapes, 1);
    section_store store = {0};
    for (int i = 0; i < 3; i++) {
        ring_spec *ring = i == 0 ? &shapes[i].annulus : &shapes[i].sector;
        ring->outer_radius = (field){.at = outer};
        ring->inner_radius = (field){.at = inner};
    }
    CHECK_OK(section_store_make(&c, two, length, &store));
    (void)law_at(&store, 0);
    (void)law_at(&store, 0.1);
    CHECK(store.effort.nsolved == 1 && store.effort.nscaled == 1);
    section_store_free(&store);
}

static double flipped(const void *sign, double s)
{
    return (s < length / 2 ? 1 : -1) * *(const double *)sign;
}

static void mirrored_copies(void)
{
    shape_spec shapes[3];
    const double angle[2] = {1.9, 0.3};
    section_case c = lopsided(shapes, 1);
    section_store store = {0};
    beam_law direct = {0};
    for (int i = 1; i < 3; i++) {
        shapes[i].sector.mid_angle = (field){.at = flipped, .expression = &angle[i - 1]};
    }
    CHECK_OK(section_store_make(&c, two, length, &store));
    (void)law_at(&store, 0);
    const beam_law carried = law_at(&store, 0.1);
    CHECK(store.effort.nsolved == 1 && store.effort.nmirrored == 1);
    section_case other = lopsided(shapes, -1);
    CHECK_OK(section_solve(&other, two, 0, length, &direct));
    CHECK(mat6_relative_error(carried.K, direct.K) < 1e-10);
    CHECK(same_mass(&carried, &direct));
    // and it is not the section itself
    other = lopsided(shapes, 1);
    CHECK_OK(section_solve(&other, two, 0, length, &direct));
    CHECK(mat6_relative_error(carried.K, direct.K) > 0.05);
    section_store_free(&store);
}

// the rate of the turn, at both ends and inside; none where shapes turn differently
static void rates(void)
{
    shape_spec shapes[3];
    section_case c = lopsided(shapes, 1);
    section_place p = {0};
    c.turn = (field){.at = half_turn};
    for (int i = 0; i <= 4; i++) {
        CHECK_OK(section_place_at(&c, length * i / 4, length, &p));
        CHECK_NEAR(p.turn_rate, pi / length, 1e-10);
        CHECK(!p.uneven);
        section_place_free(&p);
    }
    shapes[1].sector.mid_angle = (field){.at = half_turn};
    CHECK_OK(section_place_at(&c, 0.05, length, &p));
    CHECK(p.uneven && p.turn_rate == 0);
    section_place_free(&p);
}

// a mirrored helix turns the other way: its law is not that of the first one
static void rates_tell_sections_apart(void)
{
    shape_spec shapes[3];
    section_case c = lopsided(shapes, 1);
    hash a = {0}, b = {0};
    bool known = false;
    section_place p = {0};
    CHECK_OK(section_place_at(&c, 0, length, &p));
    CHECK_OK(section_fingerprint(&c, two, &p, &a, &known));
    CHECK(known);
    p.turn_rate = 26.0;
    CHECK_OK(section_fingerprint(&c, two, &p, &b, &known));
    CHECK(!hash_is(a, b));
    section_place_free(&p);
}

// an earlier run's law stands in for a solve only where nothing has changed
static void recalled(void)
{
    shape_spec shapes[3];
    section_case c = lopsided(shapes, 1);
    section_result first = {0}, second = {0};
    const section_known nothing = {0};
    c.known = &nothing;
    CHECK_OK(section_along(&c, two, length, &first));
    CHECK(first.effort.nsolved == 1 && first.solved.count == 1);
    c.known = &first.solved;
    CHECK_OK(section_along(&c, two, length, &second));
    CHECK(second.effort.nsolved == 0 && second.effort.nstored == 1 && second.solved.count == 1);
    CHECK(mat6_relative_error(first.along.law[0].K, second.along.law[0].K) == 0);
    section_result_free(&second);
    shapes[2].sector.width = field_constant(0.8000001);
    CHECK_OK(section_along(&c, two, length, &second));
    CHECK(second.effort.nsolved == 1 && second.effort.nstored == 0);
    section_result_free(&first);
    section_result_free(&second);
}

// Materials along the section's own axes turn with the whole section, also at the place where its
// turn is 0: one pattern, one rate, one solve.
static void section_axes_turn_with_the_section(void)
{
    shape_spec shape = {
        .rectangle = {.at = {1, 1}, .width = field_constant(4e-3), .height = field_constant(1e-3)}};
    section_case c = section_case_default();
    section_store store = {0};
    material ply = {.E1 = 100e6,
                    .E2 = 20e6,
                    .E3 = 10e6,
                    .G12 = 8e6,
                    .G13 = 6e6,
                    .G23 = 4e6,
                    .nu12 = 0.25,
                    .nu13 = 0.3,
                    .nu23 = 0.35,
                    .fibre_angle = 0.5};
    CHECK_OK(material_bind(&ply));
    c.nmaterial = 1;
    c.shapes = (key_list){.count = 1, .items = &shape};
    c.mesh.order = 2;
    c.turn = (field){.at = half_turn};
    CHECK_OK(section_store_make(&c, &ply, length, &store));
    const double at[] = {0, 0.05, 0.12};
    const mat6 first = law_at(&store, at[0]).K;
    for (int i = 0; i < 3; i++) {
        section_place p = {0};
        CHECK_OK(section_store_place(&store, at[i], &p));
        CHECK_NEAR(p.turn_rate, pi / length, 1e-9);
        CHECK(!p.uneven);
        const mat6 back = beam_law_move(law_at(&store, at[i]).K, 0, 0, p.turn);
        CHECK(mat6_relative_error(back, first) < 1e-12);
        section_place_free(&p);
    }
    CHECK(store.effort.nsolved == 1);
    section_store_free(&store);
}

int main(void)
{
    scaled_copies();
    drawn_larger();
    mirrored_copies();
    rates();
    rates_tell_sections_apart();
    recalled();
    section_axes_turn_with_the_section();
    return test_failures != 0;
}
