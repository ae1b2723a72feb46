// tests/unit/app/test_whole_case.c
// What no single room can see in a case: lengths, stations and parts that contradict one another.
#include "app/case.h"

#include "tests/test.h"

#include <string.h>
#include <unistd.h>

static const char start[] = "format: 1\n"
                            "materials: {soft: {E_MPa: 1, nu: 0.3}}\n"
                            "section:\n"
                            "  shapes:\n";
static const char ring[] =
    "    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3}, material: soft}\n";
static const char tapered[] =
    "    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3 - 0.01*s/1}, material: soft}\n";

// reads a case made of these parts
static status read_case(const char *shapes, const char *rest, case_data *c)
{
    char path[] = "/tmp/stiffaxis-test-XXXXXX";
    const int number = mkstemp(path);
    FILE *file = number < 0 ? NULL : fdopen(number, "w");
    CHECK(file != NULL);
    fprintf(file, "%s%s%s", start, shapes, rest);
    CHECK(fclose(file) == 0);
    status_clear();
    const status st = case_open(&(case_request){.path = path}, c);
    (void)unlink(path);
    return st;
}

static void fails_at(const char *shapes, const char *rest, const char *place, const char *said)
{
    case_data c = {0};
    CHECK(read_case(shapes, rest, &c) == ERR_INPUT);
    if (!strstr(status_message(), place) || !strstr(status_message(), said)) {
        printf("'%s' does not say '%s' at '%s'\n", status_message(), said, place);
        test_failures++;
    }
    case_free(&c);
}

static void the_length_comes_from_rod_then_segment_then_stations(void)
{
    case_data c = {0};
    CHECK_OK(read_case(ring, "rod: {length_mm: 120}\nfem: {length_mm: 20, loads: []}\n", &c));
    CHECK_NEAR(c.length, 0.12, 1e-15);
    CHECK(case_has_rod(&c) && case_has_segment(&c));
    case_free(&c);
    CHECK_OK(read_case(ring, "fem: {length_mm: 20, loads: []}\n", &c));
    CHECK_NEAR(c.length, 0.02, 1e-15);
    CHECK(!case_has_rod(&c) && case_has_segment(&c));
    CHECK(case_need_rod(&c) == ERR_INPUT && case_need_segment(&c) == OK);
    case_free(&c);
    CHECK_OK(read_case(tapered, "  stations_mm: [0, 30, 50]\n", &c));
    CHECK_NEAR(c.length, 0.05, 1e-15);
    case_free(&c);
    CHECK_OK(read_case(ring, "", &c));
    CHECK(c.length > 0);
    case_free(&c);
}

static void contradictions_have_their_place(void)
{
    fails_at(tapered, "", ":3:", "how far");
    fails_at(ring, "  stations_mm: [0, 130]\nrod: {length_mm: 120}\n", ":6:", "outside");
    fails_at(ring, "  stations_mm: [-1, 1]\nrod: {length_mm: 120}\n", ":6:", "");
    fails_at(ring, "rod: {length_mm: 120}\nfem: {length_mm: 20, section_at_mm: 121, loads: []}\n",
             ":7:", "beyond");
    fails_at("    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3}, material: soff}\n", "",
             ":5:", "soff");
}

int main(void)
{
    the_length_comes_from_rod_then_segment_then_stations();
    contradictions_have_their_place();
    return test_failures != 0;
}
