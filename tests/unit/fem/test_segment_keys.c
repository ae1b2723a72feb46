// tests/unit/fem/test_segment_keys.c
#include "fem/segment.h"
#include "tests/test.h"

#include <stdlib.h>
#include <string.h>

static segment_case case_with(segment_load *loads, int count)
{
    segment_case c = segment_case_default();
    c.at = (mark){3, 1};
    c.length = 20e-3;
    c.loads = (key_list){.count = count, .items = loads};
    return c;
}

static segment_load compression(const char *name, int line)
{
    return (segment_load){.at = {line, 5}, .name = name, .force = {0, 0, -0.5}, .at_kind = -1};
}

static void fails_at(const segment_case *c, int line, const char *words)
{
    mark where = {0};
    CHECK(segment_case_check(c, &where) == ERR_INPUT);
    CHECK(where.line == line);
    CHECK(strstr(status_message(), words) != NULL);
    status_clear();
}

static void a_plain_case_is_right(void)
{
    segment_load loads[2] = {compression("one", 10), compression("two", 11)};
    const segment_case c = case_with(loads, 2);
    mark where = {0};
    CHECK_OK(segment_case_check(&c, &where));
}

static void contradictions_have_a_place(void)
{
    segment_load loads[2] = {compression("one", 10), compression("one", 11)};
    segment_case c = case_with(loads, 2);
    fails_at(&c, 11, "two loads 'one'");

    loads[1] = compression("two", 11);
    loads[1].force[2] = 0;
    fails_at(&c, 11, "neither force nor moment");

    loads[1].moment[0] = 1e-3;
    c.tip = TIP_UNIFORM;
    fails_at(&c, 11, "no moment");

    loads[1] = compression("two", 11);
    loads[1].at_kind = 1;
    fails_at(&c, 11, "centroid");
    loads[1].at_kind = -1;
    loads[1].point.at = (mark){12, 9};
    fails_at(&c, 11, "centroid");

    c.tip = TIP_RIGID;
    c.layers = 1;
    fails_at(&c, 3, "layers");
    c.layers = 0;
    c.grading = 0.5;
    fails_at(&c, 3, "grading");
}

// the heights of the layers that an extrusion makes of the choice: geometric to the middle,
// mirrored
static double end_layer(const segment_case *c)
{
    double total = 0;
    for (int k = 0; k < c->layers; k++) {
        const int step = k < c->layers - 1 - k ? k : c->layers - 1 - k;
        total += pow(c->grading, (double)step / ((c->layers - 1) / 2));
    }
    return c->length / total;
}

static void what_is_not_said_is_chosen(void)
{
    segment_case c = segment_case_default();
    const double radius = 4e-3;
    const double lengths[] = {8e-3, 20e-3, 120e-3, 1};
    for (int i = 0; i < 4; i++) {
        c.length = lengths[i];
        const segment_case made = segment_choose(&c, radius);
        CHECK(made.order == 3 && made.size > 0 && made.grading >= 1);
        CHECK(made.layers % 2 == 0 && made.layers >= 2);
        // the end layer is what was aimed at, but for rounding to a whole number of doublings
        CHECK(end_layer(&made) <= 0.1001 * radius && end_layer(&made) > 0.04 * radius);
    }
}

static void what_is_said_stays(void)
{
    segment_case c = segment_case_default();
    c.length = 20e-3;
    c.order = 2;
    c.layers = 7;
    c.grading = 3;
    c.size = 1e-3;
    const segment_case made = segment_choose(&c, 4e-3);
    CHECK(made.order == 2 && made.layers == 7 && made.grading == 3 && made.size == 1e-3);
    c.layers = 2;
    c.grading = 0;
    CHECK(segment_choose(&c, 4e-3).grading == 1); // two layers are both end layers
}

static void the_rank_comes_from_the_environment(void)
{
    (void)unsetenv("OMPI_COMM_WORLD_RANK");
    CHECK(segment_rank() == 0);
    (void)setenv("OMPI_COMM_WORLD_RANK", "3", 1);
    CHECK(segment_rank() == 3);
    (void)unsetenv("OMPI_COMM_WORLD_RANK");
}

int main(void)
{
    a_plain_case_is_right();
    contradictions_have_a_place();
    what_is_not_said_is_chosen();
    what_is_said_stays();
    the_rank_comes_from_the_environment();
    return test_failures != 0;
}
