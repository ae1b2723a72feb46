// section/wrench_keys.c
#include "section/section.h"

#include <string.h>

static const key keys[] = {
    {.name = "name",
     .kind = KEY_TEXT,
     .required = true,
     .offset = offsetof(section_wrench, name),
     .about = "what the wrench is called in tables and pictures"},
    {.name = "force",
     .kind = KEY_VECTOR,
     .dimension = DIM_FORCE,
     .count = 3,
     .initial = "[0, 0, 0]",
     .offset = offsetof(section_wrench, force),
     .about = "force of the part beyond the section on it, along x, y, z; a positive third "
              "component pulls"},
    {.name = "moment",
     .kind = KEY_VECTOR,
     .dimension = DIM_MOMENT,
     .count = 3,
     .initial = "[0, 0, 0]",
     .offset = offsetof(section_wrench, moment),
     .about = "moment about the place where the force acts"},
    {.name = "at",
     .kind = KEY_CHOICE,
     .choices = "geometric_centre|stiffness_centre",
     .one_of = -1,
     .initial = "geometric_centre",
     .offset = offsetof(section_wrench, at_kind),
     .about = "where the force acts; the stiffness centre is the section's own, at every station"},
    {.name = "at",
     .kind = KEY_ROWS,
     .dimension = DIM_LENGTH,
     .count = 2,
     .max_count = 1,
     .one_of = -1,
     .offset = offsetof(section_wrench, point),
     .about = "[x, y] where the force acts"},
};

static const section_wrench initial = {.at_kind = -1};

const key_table section_wrench_keys = {.name = "section_wrench",
                                       .size = sizeof(section_wrench),
                                       .nkey = sizeof keys / sizeof *keys,
                                       .keys = keys,
                                       .initial = &initial,
                                       .about = "one wrench on the section"};

static bool is_zero(const double *v)
{
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

status section_wrenches_check(const section_case *c, mark *where)
{
    const section_wrench *w = c->wrenches.items;
    for (int i = 0; i < c->wrenches.count; i++) {
        *where = w[i].at;
        if (is_zero(w[i].force) && is_zero(w[i].moment)) {
            return status_fail(ERR_INPUT, "wrench '%s' has neither force nor moment", w[i].name);
        }
        for (int k = 0; k < i; k++) {
            if (strcmp(w[i].name, w[k].name) == 0) {
                return status_fail(ERR_INPUT, "there are two wrenches '%s'", w[i].name);
            }
        }
    }
    return OK;
}
