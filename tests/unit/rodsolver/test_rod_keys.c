// tests/unit/rodsolver/test_rod_keys.c
#include "rodsolver/rod_case.h"
#include "tests/test.h"

#include <string.h>

static const key *find(const key_table *table, const char *name)
{
    for (int i = 0; i < table->nkey; i++) {
        if (strcmp(table->keys[i].name, name) == 0) {
            return &table->keys[i];
        }
    }
    return NULL;
}

static void table_and_defaults_agree(void)
{
    const rod_case c = rod_case_default();
    const rod_case *initial = rod_keys.initial;
    CHECK(rod_keys.size == sizeof(rod_case));
    CHECK(c.frame == FRAME_GC && c.points == 121 && c.tolerance == 1e-9);
    CHECK(initial->tolerance == atof(find(&rod_keys, "tolerance")->initial));
    CHECK(initial->points == atoi(find(&rod_keys, "points")->initial));
    CHECK(find(&rod_keys, "tendons")->table->size == sizeof(tendon_spec));
    CHECK(find(&rod_keys, "length")->required);
    CHECK(strcmp(find(&rod_keys, "frame")->choices, "gc|nc") == 0);
}

static void contradictions_name_their_place(void)
{
    tendon_spec tendon[2] = {{.at = {7, 5}}, {.at = {8, 5}}};
    double tension[4] = {0.1, 0, 0, 0.2};
    rod_case c = rod_case_default();
    c.length = 0.12;
    c.tendons = (key_list){.at = {6, 3}, .count = 2, .items = tendon};
    c.tensions = (key_rows){.at = {9, 3}, .nrow = 2, .ncol = 2, .a = tension};
    mark where = {0};
    CHECK_OK(rod_case_check(&c, &where));

    tendon[1].end = 0.13;
    CHECK(rod_case_check(&c, &where) == ERR_INPUT);
    CHECK(where.line == 8);
    status_clear();
    tendon[1].end = 0.12;
    c.tensions.ncol = 1;
    CHECK(rod_case_check(&c, &where) == ERR_INPUT);
    CHECK(where.line == 9);
    status_clear();
    c.tensions.ncol = 2;
    tension[3] = -0.1;
    CHECK(rod_case_check(&c, &where) == ERR_INPUT);
    status_clear();
    c.tensions = (key_rows){0};
    CHECK(rod_case_check(&c, &where) == ERR_INPUT);
    CHECK(where.line == 6);
    status_clear();
}

int main(void)
{
    table_and_defaults_agree();
    contradictions_name_their_place();
    return test_failures != 0;
}
