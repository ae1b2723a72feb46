// tests/unit/reports/test_scene.c
// Scenes of what no drawing is made for: nothing is read or written out of place, what is no number
// is not drawn as one, and what is drawn is bounded.
#include "reports/page_kit.h"
#include "reports/rod_outline.h"
#include "reports/scene.h"
#include "tests/test.h"
#include "tests/unit/reports/files.h"
#include "tests/unit/reports/synthetic.h"

#include <time.h>

enum { MANY = 100000, TENDONS = 200, POINTS = 3 };

static const double hostile[] = {NAN, INFINITY, -INFINITY};
enum { HOSTILE = sizeof hostile / sizeof *hostile };

static double cpu_seconds(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

// --- things, one by one

static scene_spec spec_of(double size)
{
    static const char *const layer[] = {"all"};
    static const bool on[] = {true};
    return (scene_spec){.name = "a scene",
                        .size = size,
                        .nlayer = 1,
                        .layer = layer,
                        .on = on,
                        .value_name = "strain",
                        .value_most = 1};
}

static scene *opened(void)
{
    scene *s = NULL;
    const scene_spec spec = spec_of(1);
    CHECK(scene_is_possible(&spec));
    CHECK_OK(scene_open(&spec, &s));
    return s;
}

// the page's element, without what no JSON document has; the caller's to free
static bytes closed(scene *s)
{
    bytes page = {0};
    CHECK_OK(scene_close(s, "a caption", &page));
    scene_free(s);
    CHECK(page.data && count_of(page.data, "nan") == 0 && count_of(page.data, ": inf") == 0);
    CHECK(page.data && count_of(page.data, "</script>") == 1);
    return page;
}

typedef struct rod_numbers {
    pose shape[POINTS];
    double strain[POINTS][3];
} rod_numbers;

static rod_numbers straight(void)
{
    rod_numbers r = {0};
    for (int i = 0; i < POINTS; i++) {
        r.shape[i] = (pose){mat3_identity(), {{0, 0, 0.1 * i}}};
        r.strain[i][1] = 0.1;
    }
    return r;
}

static void put_skin(scene *s)
{
    static const double square[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, turn[POINTS] = {0};
    CHECK_OK(scene_skin(
        s, &(scene_outline){1, &(int){4}, square, (const unsigned char[4]){0}, 1, &INK_SOFT},
        POINTS, turn));
}

static void put_rod(scene *s, const rod_numbers *r)
{
    CHECK_OK(scene_rod(s, scene_in(0), POINTS, r->shape, r->strain, "rod"));
}

static void a_rod_at_no_place_is_left_out(void)
{
    scene *s = opened();
    put_skin(s);
    rod_numbers r = straight();
    put_rod(s, &r);
    for (int i = 0; i < HOSTILE; i++) {
        r = straight();
        r.shape[1].p.a[i] = hostile[i];
        put_rod(s, &r);
        r = straight();
        r.shape[POINTS - 1].R.a[2][i] = hostile[i];
        put_rod(s, &r);
    }
    CHECK_OK(scene_rod(s, scene_in(0), 0, NULL, NULL, "of no point"));
    bytes page = closed(s);
    CHECK(count_of(page.data, "\"kind\": \"rod\"") == 1);
    bytes_free(&page);
}

// no number in JSON is null, which the view paints grey
static void a_strain_that_is_no_number_is_told(void)
{
    for (int i = 0; i < HOSTILE; i++) {
        scene *s = opened();
        put_skin(s);
        rod_numbers r = straight();
        put_rod(s, &r);
        r.strain[1][i] = hostile[i];
        put_rod(s, &r);
        bytes page = closed(s);
        CHECK(count_of(page.data, "\"kind\": \"rod\"") == 2);
        CHECK(count_of(page.data, "\"strained\": null") == 1);
        bytes_free(&page);
    }
}

static void lines_and_moves_of_no_numbers_are_left_out(void)
{
    const colour ink[1] = {INK_SOFT};
    const unsigned char kind[POINTS] = {0};
    const int triangle[1][3] = {{0, 1, 2}};
    const double value[POINTS] = {NAN, -INFINITY, INFINITY};
    scene *s = opened();
    for (int i = -1; i < HOSTILE; i++) {
        double place[POINTS][3] = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}};
        const double(*p)[3] = (const double(*)[3])place;
        CHECK_OK(i < 0 ? scene_solid(s, scene_in(0), POINTS, p, 1, triangle, kind, 1, ink) : OK);
        place[POINTS - 1][2] = i < 0 ? 0 : hostile[i];
        CHECK_OK(scene_moved(s, scene_in(0), POINTS, p, value, "moved"));
        CHECK_OK(scene_line(s, scene_in(0), POINTS, p, *ink));
        CHECK_OK(scene_tube(s, scene_in(0), POINTS, p, value, 0.01, *ink));
        CHECK_OK(scene_motion(s, scene_in(0), 1, POINTS, p, 0.01, *ink, "way"));
        CHECK_OK(scene_points(s, scene_in(0), POINTS, p, 0.01, kind, 1, ink, NULL));
    }
    bytes page = closed(s);
    CHECK(count_of(page.data, "\"kind\": \"moved\"") == 1);
    CHECK(count_of(page.data, "\"kind\": \"line\"") == 1);
    CHECK(count_of(page.data, "\"kind\": \"tube\"") == 2);
    CHECK(count_of(page.data, "\"kind\": \"points\"") == 1);
    // no number, less than 0, and the end of the ramp
    CHECK(count_of(page.data, "\"values\": \"/wD+\"") == 2);
    bytes_free(&page);
}

static void nothing_at_all_is_a_scene(void)
{
    scene *s = opened();
    CHECK_OK(scene_skin(s, &(scene_outline){0}, 0, NULL));
    CHECK_OK(scene_wall(s, scene_in(0), 0, NULL, 0, NULL, INK_SOFT));
    CHECK_OK(scene_solid(s, scene_in(0), 0, NULL, 0, NULL, NULL, 0, NULL));
    CHECK_OK(scene_moved(s, scene_in(0), 0, NULL, NULL, "nothing"));
    CHECK_OK(scene_line(s, scene_in(0), 0, NULL, INK_SOFT));
    CHECK_OK(scene_points(s, scene_in(0), 0, NULL, 0, NULL, 0, NULL, NULL));
    CHECK_OK(scene_words(s, scene_in(0), "\xff</script><!--\xc3"));
    bytes page = closed(s);
    CHECK(count_of(page.data, "\"most\": 0") == 2);
    CHECK(count_of(page.data, "\xff") == 0 && count_of(page.data, "<!--") == 0);
    bytes_free(&page);
}

// what lies outside of the box is drawn at its side, at no other place
static void far_places_stay_at_the_side(void)
{
    scene *s = opened();
    const double point[2][3] = {{-1e30, 0, 1e308}, {1, 1e30, 0}};
    CHECK_OK(scene_line(s, scene_in(0), 2, point, INK_SOFT));
    bytes page = closed(s);
    // 0, 0, 65535, 65535, 65535, 0
    CHECK(count_of(page.data, "\"points\": \"AAAAAP///////wAA\"") == 1);
    bytes_free(&page);
}

static void impossible_scenes_are_known(void)
{
    static const double sizes[] = {0, -1, 1e-30, 1e30, 1e308, NAN, INFINITY};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        scene_spec spec = spec_of(sizes[i]);
        CHECK(!scene_is_possible(&spec));
        spec = spec_of(1);
        spec.low[1] = sizes[i] + 1e30;
        CHECK(!scene_is_possible(&spec));
        spec = spec_of(1);
        spec.factor = (scene_factor){"times", sizes[i] > 0 ? INFINITY : sizes[i], 1};
        CHECK(!scene_is_possible(&spec));
        spec = spec_of(1);
        spec.value_most = sizes[i] > 0 ? NAN : sizes[i];
        CHECK(!scene_is_possible(&spec));
    }
}

static void a_box_holds_its_places(void)
{
    const double point[3][3] = {{0, 0, 0}, {1, -2, 0.5}, {NAN, 0, 0}};
    scene_box box = scene_box_empty();
    scene_spec spec = spec_of(0);
    scene_box_put(&box, 1, 0, &spec);
    CHECK(!scene_is_possible(&spec)); // around nothing
    scene_box_add(&box, point[0]);
    scene_box_add(&box, point[1]);
    scene_box_put(&box, 1.5, 1, &spec);
    CHECK(spec.size == 4 && spec.low[0] == -1.5 && spec.low[1] == -3 && spec.low[2] == -1.75);
    scene_box_add(&box, point[2]);
    scene_box_add(&box, point[0]);
    scene_box_put(&box, 1.5, 1, &spec);
    CHECK(!scene_is_possible(&spec)); // and stays so, whatever comes behind
}

// --- rods on a page

static bytes view_of(const run_result *r)
{
    bytes page = {0};
    CHECK_OK(page_rod_view(&page, r));
    CHECK_OK(bytes_text(&page, "")); // a page of nothing is a text too
    CHECK(count_of(page.data, "nan") == 0);
    return page;
}

static int shown(const bytes *page, const char *kind)
{
    char text[40];
    (void)snprintf(text, sizeof text, "\"kind\": \"%s\"", kind);
    return count_of(page->data, text);
}

static void rods_at_no_place_have_no_view(void)
{
    static const double place[] = {NAN, INFINITY, -INFINITY, 1e30, -1e306, 1.7e308};
    for (size_t i = 0; i < sizeof place / sizeof *place; i++) {
        run_result r = {0};
        CHECK_OK(synthetic_make(6, 1, -0.5, &r));
        r.rod.run[2].shape[SHAPE_POINTS - 1].p.a[1] = place[i];
        bytes page = view_of(&r);
        CHECK(page.length == 0);
        bytes_free(&page);
        synthetic_free(&r);
    }
}

static void rods_of_hostile_numbers_are_drawn_as_they_can(void)
{
    for (int i = 0; i < HOSTILE; i++) {
        run_result r = {0};
        CHECK_OK(synthetic_make(6, 1, -0.5, &r));
        r.rod.run[1].wrench[0].a[MY] = hostile[i];
        r.rod.run[2].largest_strain = r.rod.run[2].total_bend_rad = hostile[i];
        r.rod.tendon_path[5][0] = hostile[i]; // of the left one
        bytes page = view_of(&r);
        CHECK(shown(&page, "rod") == 6 && count_of(page.data, "\"strained\": null") == 1);
        CHECK(count_of(page.data, "bend not finite deg, largest strain not finite %") == 1);
        CHECK(shown(&page, "line") == 6 + 1); // the right tendons, and the shape at rest
        bytes_free(&page);
        r.section.along.turn[3] = hostile[i];
        r.section_mesh.xyz[0] = hostile[i];
        page = view_of(&r);
        CHECK(shown(&page, "rod") == 6 && shown(&page, "key") == 2); // no material's colours
        CHECK(count_of(page.data, "drawn as a full circle of its area") == 1);
        bytes_free(&page);
        synthetic_free(&r);
    }
}

static void few_of_anything_is_enough(void)
{
    run_result r = {0};
    CHECK_OK(synthetic_make(1, 1, -0.5, &r));
    rod_result *rod = &r.rod;
    const rod_result all = *rod;
    rod->ntendon = 0;
    bytes page = view_of(&r);
    CHECK(shown(&page, "rod") == 1 && shown(&page, "line") == 1); // at rest
    bytes_free(&page);
    rod->npoint = 2;
    page = view_of(&r);
    CHECK(shown(&page, "rod") == 1);
    bytes_free(&page);
    rod->npoint = 1;
    page = view_of(&r);
    CHECK(page.length == 0);
    bytes_free(&page);
    *rod = all;
    rod->nsolution = 0;
    rod->run = NULL;
    page = view_of(&r);
    CHECK(page.length == 0);
    bytes_free(&page);
    *rod = all;
    synthetic_free(&r);
}

static void a_rod_without_extent_has_no_view(void)
{
    run_result r = {0};
    CHECK_OK(synthetic_make(2, 0, -0.5, &r));
    mesh_free(&r.section_mesh);
    r.section.station[0].law.area = r.rod_length = 0;
    for (int k = 0; k < SHAPE_POINTS; k++) {
        r.rod.rest[k].p = r.rod.run[0].shape[k].p = r.rod.run[1].shape[k].p = (vec3){{0}};
    }
    bytes page = view_of(&r);
    CHECK(page.length == 0);
    bytes_free(&page);
    synthetic_free(&r);
}

// --- very many

static status make_tendons(rod_result *rod, int count)
{
    status st = OK;
    free(rod->tendon_name);
    free(rod->tendon_end);
    free(rod->tendon_path);
    rod->tendon_name = NULL;
    rod->tendon_end = NULL;
    rod->tendon_path = NULL;
    rod->ntendon = count;
    TRY(TAKE(rod->tendon_name, (size_t)count));
    TRY(TAKE(rod->tendon_end, (size_t)count));
    TRY(TAKE(rod->tendon_path, (size_t)count * (size_t)rod->npoint));
    for (int i = 0; i < count; i++) {
        (void)snprintf(rod->tendon_name[i], RESULT_NAME, "tendon é%d", i + 1);
        rod->tendon_end[i] = 1;
    }

done:
    return st;
}

// solutions that share one shape and its tensions
static bytes view_of_many(int nsolution, int ntendon)
{
    static double tension[TENDONS], pull[TENDONS];
    run_result r = {0};
    CHECK_OK(synthetic_make(1, 1, -0.5, &r));
    struct rod_run *own = r.rod.run, *all = calloc((size_t)nsolution, sizeof *all);
    CHECK_OK(make_tendons(&r.rod, ntendon));
    for (int i = 0; i < ntendon; i++) {
        tension[i] = 0.123;
        pull[i] = NAN;
    }
    for (int i = 0; all && i < nsolution; i++) {
        all[i] = *own;
        all[i].tension = tension;
        all[i].pull = pull;
    }
    r.rod.run = all;
    r.rod.nsolution = nsolution;
    const bytes page = view_of(&r);
    r.rod.run = own;
    r.rod.nsolution = 1;
    free(all);
    synthetic_free(&r);
    return page;
}

static void very_many_are_bounded(void)
{
    const double start = cpu_seconds();
    bytes page = view_of_many(MANY, 2);
    CHECK(cpu_seconds() - start < 1);
    CHECK(shown(&page, "rod") == 60 && shown(&page, "line") == 60 * 2 + 1);
    bytes_free(&page);
    page = view_of_many(500, TENDONS);
    CHECK(shown(&page, "rod") == 60 && shown(&page, "line") == 60 * 8 + 1);
    CHECK(page.length < 700000);
    // a name ends with a whole tension, and says that there are more
    CHECK(count_of(page.data, "0.123 N …") == 60 * 3); // in the list, of the rod, in its words
    CHECK(count_of(page.data, "\xEF\xBF\xBD") == 0);
    bytes_free(&page);
}

int main(void)
{
    a_rod_at_no_place_is_left_out();
    a_strain_that_is_no_number_is_told();
    lines_and_moves_of_no_numbers_are_left_out();
    nothing_at_all_is_a_scene();
    far_places_stay_at_the_side();
    impossible_scenes_are_known();
    a_box_holds_its_places();
    rods_at_no_place_have_no_view();
    rods_of_hostile_numbers_are_drawn_as_they_can();
    few_of_anything_is_enough();
    a_rod_without_extent_has_no_view();
    very_many_are_bounded();
    return test_failures != 0;
}
