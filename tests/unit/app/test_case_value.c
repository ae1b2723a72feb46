// What a case holds under a key, as --set names it.
#include "app/case_value.h"

#include "tests/test.h"

#include <string.h>
#include <unistd.h>

static const char text[] =
    "format: 1\n"
    "materials:\n"
    "  soft: {E_MPa: 0.66, nu: 0.3}\n"
    "  stiff: {E_GPa: 0.01593, nu: 0.3}\n"
    "section:\n"
    "  model: classical\n"
    "  shapes:\n"
    "    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3.2}, material: soft}\n"
    "    - {sector: {outer_radius_mm: 4, inner_radius_mm: 3.2, mid_angle_rad: pi*s/L, width_rad: "
    "pi/8}, material: stiff}\n"
    "rod:\n"
    "  length_mm: 120\n"
    "  tendons:\n"
    "    - {name: t1, radius_mm: 3.6}\n"
    "    - {name: 2, radius_mm: 3.4, friction: 0.25}\n"
    "  tensions_N: [[0.49, 0]]\n";

static double number(const case_data *c, const char *path)
{
    case_value v = {.number = NAN};
    CHECK_OK(case_value_find(c, path, (mark){1, 1}, &v));
    return v.number;
}

static bool is_word(const case_data *c, const char *path, const char *word)
{
    case_value v = {0};
    CHECK_OK(case_value_find(c, path, (mark){1, 1}, &v));
    return v.text && (int)strlen(word) == v.length && strncmp(v.text, word, strlen(word)) == 0;
}

static void values_come_in_the_unit_of_the_spelling(const case_data *c)
{
    CHECK_NEAR(number(c, "rod.tendons.t1.radius_mm"), 3.6, 1e-15);
    CHECK_NEAR(number(c, "rod.tendons.t1.radius_m"), 3.6e-3, 1e-15);
    CHECK_NEAR(number(c, "rod.tendons.0.radius_mm"), 3.6, 1e-15);
    CHECK_NEAR(number(c, "rod.tendons.2.radius_mm"), 3.4, 1e-15); // its name, not its number
    CHECK_NEAR(number(c, "materials.stiff.E_MPa"), 15.93, 1e-14);
    CHECK_NEAR(number(c, "section.shapes.1.sector.width_deg"), 22.5, 1e-14);
    CHECK_NEAR(number(c, "rod.length_cm"), 12, 1e-15);
}

static void what_is_not_given_has_its_default(const case_data *c)
{
    CHECK(number(c, "rod.tendons.t1.friction") == 0);
    CHECK(number(c, "rod.tendons.1.friction") == 0.25);
    CHECK(number(c, "rod.rest.curvature_x_per_m") == 0);
    CHECK(is_word(c, "section.model", "classical"));
    CHECK(is_word(c, "rod.start", "rest"));
}

static void what_varies_is_no_number(const case_data *c)
{
    CHECK(isnan(number(c, "section.shapes.1.sector.mid_angle_rad")));
    CHECK(isnan(number(c, "rod.tensions_N")));
}

static void other_keys_are_told(const case_data *c)
{
    static const char *const none[] = {"",
                                       ".",
                                       "rod",
                                       "rod.",
                                       "rod.tendons",
                                       "rod.tend",
                                       "rod.length",
                                       "rod.length_N",
                                       "rod.tendons.t3.radius_mm",
                                       "rod.tendons.-1.radius_mm",
                                       "rod.tendons.99999999999999999999.radius_mm",
                                       "materials.soft",
                                       "materials.hard.nu",
                                       "section.shapes.t1.sector.width_rad",
                                       "rod.tendons.t1",
                                       "format.x",
                                       "rod.tensions_N.0.1"};
    for (size_t i = 0; i < sizeof none / sizeof *none; i++) {
        case_value v;
        const status st = case_value_find(c, none[i], (mark){3, 4}, &v);
        CHECK(st == ERR_INPUT);
        status_clear();
    }
}

int main(void)
{
    char path[] = "/tmp/case_value.XXXXXX";
    case_data c = {0};
    const int file = mkstemp(path);
    CHECK(file >= 0 && write(file, text, sizeof text - 1) == (ssize_t)sizeof text - 1);
    (void)close(file);
    CHECK_OK(case_open(&(case_request){.path = path}, &c));
    values_come_in_the_unit_of_the_spelling(&c);
    what_is_not_given_has_its_default(&c);
    what_varies_is_no_number(&c);
    other_keys_are_told(&c);
    case_free(&c);
    (void)unlink(path);
    return test_failures != 0;
}
