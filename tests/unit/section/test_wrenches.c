// tests/unit/section/test_wrenches.c
#include "section/answers.h"
#include "tests/test.h"

#include <string.h>

static status check(int count, section_wrench *wrenches, mark *where)
{
    section_case c = section_case_default();
    c.wrenches = (key_list){.count = count, .items = wrenches};
    return section_wrenches_check(&c, where);
}

static void wrenches_need_a_load_and_a_name_of_their_own(void)
{
    section_wrench w[2] = {{.at = {3, 5}, .name = "pull", .force = {0, 0, 1}},
                           {.at = {4, 5}, .name = "bend", .moment = {1, 0, 0}}};
    mark where = {0};
    CHECK_OK(check(2, w, &where));
    w[1].name = "pull";
    CHECK(check(2, w, &where) == ERR_INPUT && strstr(status_message(), "two wrenches 'pull'"));
    CHECK(where.line == 4);
    status_clear();
    w[0].force[2] = 0;
    CHECK(check(2, w, &where) == ERR_INPUT && strstr(status_message(), "neither force nor moment"));
    CHECK(where.line == 3);
    status_clear();
}

// m_o = m + r x n
static void a_force_beside_the_origin_brings_a_moment(void)
{
    const double at[2] = {2, 3}, force[3] = {5, 7, 11}, moment[3] = {13, 17, 19};
    const vec6 w = section_wrench_at_origin(at, force, moment);
    const vec3 r = {{2, 3, 0}}, n = {{5, 7, 11}}, turned = vec3_cross(r, n);
    for (int i = 0; i < 3; i++) {
        CHECK(w.a[i] == force[i]);
        CHECK(w.a[3 + i] == moment[i] + turned.a[i]);
    }
}

int main(void)
{
    wrenches_need_a_load_and_a_name_of_their_own();
    a_force_beside_the_origin_brings_a_moment();
    return test_failures != 0;
}
