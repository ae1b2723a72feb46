#include "io/annotate.h"

#include "tests/test.h"
#include "tests/unit/io/small_case.h"

#include <string.h>

// Whether the text with its comments is exactly that.
static bool becomes(const char *text, const char *wanted)
{
    char *out = NULL;
    CHECK_OK(config_annotate("a.yaml", text, &small_case_keys, &out));
    const bool same = out && strcmp(out, wanted) == 0;
    if (!same) {
        printf("--- wanted\n%s--- is\n%s", wanted, out ? out : "(nothing)\n");
    }
    free(out);
    return same;
}

static void a_key_with_a_line_to_itself_is_told_behind_it(void)
{
    CHECK(becomes("title: a\n", "title: a                          # for the report\n"));
}

static void what_the_writer_said_stands_alone(void)
{
    CHECK(becomes("title: a # mine\n", "title: a # mine\n"));
    CHECK(becomes("title: 'a # b'\n", "title: 'a # b'                    # for the report\n"));
}

static void keys_in_braces_are_told_above(void)
{
    CHECK(becomes("materials:  # two\n"
                  "  soft: {E_kPa: 1, nu: 0.3}\n"
                  "  stiff: {E_MPa: 1,\n"
                  "     nu: 0.3} # mine\n",
                  "materials:  # two\n"
                  "  # E_kPa  Young's modulus\n"
                  "  # nu     Poisson's ratio; -0.999 to 0.4999\n"
                  "  soft: {E_kPa: 1, nu: 0.3}\n"
                  "  stiff: {E_MPa: 1,\n"
                  "     nu: 0.3} # mine\n"));
}

static void keys_of_one_name_and_two_meanings_are_told_twice(void)
{
    CHECK(becomes("section:  # its\n"
                  "  points_mm: [[0, 0]]\n"
                  "rod:  # its\n"
                  "  points: 3\n",
                  "section:  # its\n"
                  "  points_mm: [[0, 0]]             # marked points\n"
                  "rod:  # its\n"
                  "  points: 3                       # of the shape; 2 to 100000; default 101\n"));
}

static void keys_of_one_meaning_are_told_once(void)
{
    CHECK(becomes("section:  # its\n"
                  "  shapes:  # own\n"
                  "    - {annulus: {outer_radius_mm: 1}, material: none}\n"
                  "    - sector: {outer_radius_mm: 1}\n"
                  "loads:  # their\n"
                  "  - name: a\n"
                  "    at: origin\n",
                  "section:  # its\n"
                  "  shapes:  # own\n"
                  "    # annulus          a full ring\n"
                  "    # outer_radius_mm  of the ring; 0.001 to 1000 mm\n"
                  "    # material         a name under materials\n"
                  "    - {annulus: {outer_radius_mm: 1}, material: none}\n"
                  "    - sector: {outer_radius_mm: 1}  # a part of a ring\n"
                  "loads:  # their\n"
                  "  - name: a                       # for tables\n"
                  "    at: origin                    # geometric_centre or stiffness_centre: where "
                  "it acts\n"));
}

static void what_is_no_yaml_is_refused(void)
{
    char *out = NULL;
    CHECK(config_annotate("a.yaml", "a: [1\n", &small_case_keys, &out) == ERR_INPUT);
    CHECK(!out);
    status_clear();
}

int main(void)
{
    a_key_with_a_line_to_itself_is_told_behind_it();
    what_the_writer_said_stands_alone();
    keys_in_braces_are_told_above();
    keys_of_one_name_and_two_meanings_are_told_twice();
    keys_of_one_meaning_are_told_once();
    what_is_no_yaml_is_refused();
    return test_failures != 0;
}
