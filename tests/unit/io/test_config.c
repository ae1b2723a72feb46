// tests/unit/io/test_config.c
#include "io/config.h"
#include "tests/test.h"
#include "tests/unit/io/case_file.h"

static const double PI = 3.14159265358979323846;

static bool is_at(mark m, int line, int column)
{
    return m.line == line && m.column == column;
}

static void numbers_arrive_in_si(void)
{
    config *cfg = NULL;
    small_case c;
    CHECK_OK(case_text_read(small_text, 0, NULL, &c, &cfg));
    const small_material *m = c.materials.items;
    CHECK(c.format == 1 && strcmp(c.title, "constant-offset prototype") == 0);
    CHECK(c.materials.count == 2 && strcmp(m[1].name, "stiff") == 0);
    CHECK(m[0].E == 0.66 * 1e6 && m[1].nu == 0.3);
    CHECK(c.rod.length == 0.12); // 120 / 1000, and not 120 * 0.001
    CHECK(c.section.model == 1);
    CHECK(c.rod.tensions.nrow == 3 && c.rod.tensions.ncol == 2);
    CHECK(c.rod.tensions.a[0] == 0.49 && c.rod.tensions.a[2] == 0.67 &&
          c.rod.tensions.a[5] == 0.98);
    config_free(cfg);
}

static void fields_know_whether_they_vary(void)
{
    config *cfg = NULL;
    small_case c;
    CHECK_OK(case_text_read(small_text, 0, NULL, &c, &cfg));
    const small_shape *shape = c.section.shapes.items;
    const small_tendon *tendon = c.rod.tendons.items;
    CHECK(!field_varies(&shape[0].annulus.outer) &&
          field_at(&shape[0].annulus.inner, 0.05) == 0.0032);
    CHECK(field_varies(&shape[1].sector.mid_angle));
    CHECK_NEAR(field_at(&shape[1].sector.mid_angle, 0.03), PI / 4, 1e-15);
    CHECK_NEAR(field_at(&shape[1].sector.width, 0.12), PI / 8, 1e-15);
    // 3 + s/200 under a key in mm: s in mm
    CHECK_NEAR(field_at(&tendon[1].radius, 0.12), (3 + 120.0 / 200) / 1000, 1e-15);
    CHECK_NEAR(tendon[1].angle.value, PI, 1e-15);
    CHECK_NEAR(tendon[1].end, 0.06, 1e-15); // L/2 under a key in mm
    config_free(cfg);
}

static void every_struct_knows_its_place(void)
{
    config *cfg = NULL;
    small_case c;
    CHECK_OK(case_text_read(small_text, 0, NULL, &c, &cfg));
    const small_shape *shape = c.section.shapes.items;
    const small_material *m = c.materials.items;
    CHECK(is_at(c.at, 1, 1) && is_at(c.section.at, 6, 1) && is_at(c.rod.at, 16, 1));
    CHECK(is_at(m[0].at, 4, 3) && is_at(m[1].at, 5, 3));
    CHECK(is_at(c.section.shapes.at, 9, 5) && is_at(shape[0].at, 9, 7) &&
          is_at(shape[1].at, 10, 7));
    CHECK(is_at(shape[0].annulus.at, 9, 8) && !mark_given(shape[0].sector.at));
    CHECK(is_at(shape[1].material.at, 15, 17) && strcmp(shape[1].material.text, "stiff") == 0);
    CHECK(is_at(c.rod.tensions.at, 21, 15));
    config_free(cfg);
}

static void what_is_not_given_has_its_default(void)
{
    config *cfg = NULL;
    small_case c;
    CHECK_OK(case_text_read("format: 1\nmaterials: {}\n", 0, NULL, &c, &cfg));
    CHECK(c.rod.points == 101 && c.rod.pictures && c.rod.tolerance == 1e-6);
    CHECK(c.title == NULL && !mark_given(c.section.at) && c.loads.count == 0 &&
          !mark_given(c.rod.tensions.at));
    config_free(cfg);
    CHECK_OK(case_text_read("format: 1\nmaterials: {}\nrod: {length_m: 1, pictures: false}", 0,
                            NULL, &c, &cfg));
    CHECK(c.rod.points == 101 && !c.rod.pictures);
    config_free(cfg);
}

static void rows_may_be_one_flat_row(void)
{
    config *cfg = NULL;
    small_case c;
    CHECK_OK(case_text_read(small_text, 0, NULL, &c, &cfg));
    const small_load *load = c.loads.items;
    CHECK(load[0].point.nrow == 1 && load[0].point.ncol == 2 && load[0].point.a[1] == 0.001);
    CHECK(load[0].force[2] == -0.5 && load[1].force[2] == -0.5);
    CHECK(load[1].at_kind == 1 && !mark_given(load[1].point.at));
    config_free(cfg);
}

static void every_unit_has_its_factor(void)
{
    static const struct {
        dimension kind;
        int count;
        const char *text[4];
        double factor[4];
    } known[] = {
        {DIM_NONE, 1, {"x"}, {1}},
        {DIM_LENGTH, 4, {"x_mm", "x_m", "x_cm", "x_um"}, {1e-3, 1, 1e-2, 1e-6}},
        {DIM_ANGLE, 2, {"x_rad", "x_deg"}, {1, 3.14159265358979323846 / 180}},
        {DIM_FORCE, 2, {"x_N", "x_mN"}, {1, 1e-3}},
        {DIM_MOMENT, 2, {"x_Nm", "x_Nmm"}, {1, 1e-3}},
        {DIM_STRESS, 4, {"x_MPa", "x_kPa", "x_Pa", "x_GPa"}, {1e6, 1e3, 1, 1e9}},
        {DIM_DENSITY, 2, {"x_kg_per_m3", "x_g_per_cm3"}, {1, 1e3}},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const key k = {.name = "x", .dimension = known[i].kind};
        char names[8][64];
        double factor[8];
        const int n = key_spellings(&k, 8, names, factor);
        CHECK(n == known[i].count);
        for (int j = 0; j < n; j++) {
            CHECK(strcmp(names[j], known[i].text[j]) == 0);
            CHECK_NEAR(factor[j], known[i].factor[j], 1e-16);
        }
    }
}

static void a_length_means_the_same_in_every_unit(void)
{
    static const char *const texts[] = {"length_m: 0.12",    "length_mm: 120",   "length_cm: 12",
                                        "length_um: 120000", "length_mm: 12*10", "length_mm: '120'",
                                        "length_mm: 1.2e2"};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        char text[128];
        config *cfg = NULL;
        small_case c;
        (void)snprintf(text, sizeof text, "format: 1\nmaterials: {}\nrod: {%s}\n", texts[i]);
        CHECK_OK(case_text_read(text, 0, NULL, &c, &cfg));
        CHECK(c.rod.length == 0.12);
        config_free(cfg);
    }
}

// reads the small case under one --set and gives it to `look`
static void with_override(const char *override, void (*look)(const small_case *))
{
    config *cfg = NULL;
    small_case c;
    CHECK_OK(case_text_read(small_text, 1, &override, &c, &cfg));
    look(&c);
    config_free(cfg);
}

static void length_is_300(const small_case *c)
{
    CHECK(c->rod.length == 0.3);
}

static void one_tension_row(const small_case *c)
{
    CHECK(c->rod.tensions.nrow == 1 && c->rod.tensions.a[0] == 0.5 && c->rod.tensions.a[1] == 0);
}

static void width_is_a_sixteenth(const small_case *c)
{
    const small_shape *shape = c->section.shapes.items;
    CHECK(!field_varies(&shape[1].sector.width));
    CHECK_NEAR(shape[1].sector.width.value, PI / 16, 1e-15);
}

static void soft_is_softer(const small_case *c)
{
    CHECK_NEAR(((const small_material *)c->materials.items)[0].E, 0.5e6, 1e-15);
    CHECK(c->materials.count == 2);
}

static void third_material(const small_case *c)
{
    const small_material *m = c->materials.items;
    CHECK(c->materials.count == 3 && strcmp(m[2].name, "gel") == 0 && m[2].E == 2e3);
}

static void second_tendon_is_out(const small_case *c)
{
    CHECK(field_at(&((const small_tendon *)c->rod.tendons.items)[1].radius, 0) == 0.0039);
}

static void title_is_other(const small_case *c)
{
    CHECK(strcmp(c->title, "another = one") == 0);
}

static void overrides_replace_and_add(void)
{
    with_override("rod.length_mm=300", length_is_300);
    with_override("rod.length_m=0.3", length_is_300); // in place of length_mm, not beside it
    with_override("rod.length_cm=3*10", length_is_300);
    with_override("rod.tensions_N=[[0.5,0]]", one_tension_row);
    with_override("rod.tensions_mN=[500, 0]", one_tension_row);
    with_override("section.shapes.1.sector.width_rad=pi/16", width_is_a_sixteenth);
    with_override("section.shapes.1.sector.width_deg=11.25", width_is_a_sixteenth);
    with_override("materials.soft.E_kPa=500", soft_is_softer);
    with_override("materials.gel={E_kPa: 2, nu: 0.4}", third_material);
    with_override("rod.tendons.1.radius_mm=3.9", second_tendon_is_out);
    with_override("rod.tendons.t2.radius_mm=3.9", second_tendon_is_out); // by its name
    with_override("title=another = one", title_is_other);
}

static void overrides_make_maps_that_are_missing(void)
{
    const char *const overrides[] = {"rod.length_mm=100", "rod.points=5"};
    config *cfg = NULL;
    small_case c;
    CHECK_OK(case_text_read("format: 1\nmaterials: {}\n", 2, overrides, &c, &cfg));
    CHECK(c.rod.length == 0.1 && c.rod.points == 5);
    CHECK(mark_given(c.rod.at));
    config_free(cfg);
}

static void a_contradiction_found_later_has_its_place(void)
{
    const char *const overrides[] = {"rod.tensions_N=[[1, 2, 3]]"};
    config *cfg = NULL;
    small_case c;
    CHECK_OK(case_text_read(small_text, 1, overrides, &c, &cfg));
    CHECK(config_fail(cfg, c.rod.tensions.at, "%d tensions", 3) == ERR_INPUT);
    CHECK(strcmp(status_message(), "--set 'rod.tensions_N=[[1, 2, 3]]': error: 3 tensions") == 0);
    status_clear();
    char wanted[128];
    CHECK(config_fail(cfg, c.rod.tendons.at, "no tendon '%s'", "a\nb\x1b[2J") == ERR_INPUT);
    (void)snprintf(wanted, sizeof wanted, "%s:19:5: error: no tendon 'a?b?[2J'", case_file_path);
    CHECK(strcmp(status_message(), wanted) == 0);
    status_clear();
    config_free(cfg);
}

static void the_text_is_kept_as_it_was(void)
{
    config *cfg = NULL;
    size_t length = 0;
    case_file_write(small_text, sizeof small_text - 1);
    CHECK_OK(config_open(case_file_path, 0, NULL, &cfg));
    (void)remove(case_file_path);
    CHECK(strcmp(config_path(cfg), case_file_path) == 0);
    const char *text = config_text(cfg, &length);
    CHECK(length == sizeof small_text - 1 && memcmp(text, small_text, length) == 0);
    config_free(cfg);
    config_free(NULL);
}

// a file from an editor on another system: byte order mark and CR LF
static void line_ends_and_byte_order_mark_do_not_matter(void)
{
    config *cfg = NULL;
    small_case c;
    CHECK_OK(case_text_read("\xEF\xBB\xBF"
                            "format: 1\r\nmaterials: {}\r\nrod:\r\n  length_mm: 5\r\n",
                            0, NULL, &c, &cfg));
    CHECK(c.rod.length == 0.005 && is_at(c.rod.at, 3, 1));
    config_free(cfg);
}

static void peeking_finds_a_number_and_nothing_else(void)
{
    config *cfg = NULL;
    double value = 0;
    bool found = true;
    case_file_write(small_text, sizeof small_text - 1);
    CHECK_OK(config_open(case_file_path, 0, NULL, &cfg));
    (void)remove(case_file_path);
    CHECK_OK(config_peek_real(cfg, "rod.length", &small_rod_list[0], &value, &found));
    CHECK(found && value == 0.12);
    CHECK_OK(config_peek_real(cfg, "fem.length", &small_rod_list[0], &value, &found));
    CHECK(!found);
    CHECK_OK(config_peek_real(cfg, "title.length", &small_rod_list[0], &value, &found));
    CHECK(!found);
    config_free(cfg);
}

int main(void)
{
    numbers_arrive_in_si();
    fields_know_whether_they_vary();
    every_struct_knows_its_place();
    what_is_not_given_has_its_default();
    rows_may_be_one_flat_row();
    every_unit_has_its_factor();
    a_length_means_the_same_in_every_unit();
    overrides_replace_and_add();
    overrides_make_maps_that_are_missing();
    a_contradiction_found_later_has_its_place();
    the_text_is_kept_as_it_was();
    line_ends_and_byte_order_mark_do_not_matter();
    peeking_finds_a_number_and_nothing_else();
    return test_failures != 0;
}
