// app/case_rod.c
#include "app/case_rod.h"

#include "app/case_segment.h"

static status read_paths(rod_case *rod, const char *directory)
{
    status st = OK;
    tendon_case *t = rod->tendons.items;
    for (int i = 0; i < rod->tendons.count; i++) {
        if (t[i].path_csv.text) {
            TRY(tendon_path_read(directory, &t[i].path_csv, &t[i].nread, &t[i].read));
        }
    }

done:
    return st;
}

status case_rod_bind(case_data *c, const char *directory)
{
    status st = OK;
    rod_case *rod = &c->file.rod;
    mark where = rod->at;
    rod->unpulled = mark_given(c->file.reach.at); // its scopes' joints are the tensions
    TRY(case_place(c, read_paths(rod, directory), where));
    st = rod_case_bind(rod, &where);
    TRY(case_place(c, st, where));
    TRY(rod_case_has_gravity(rod) ? case_check_densities(c, "the rod bends under gravity") : OK);

done:
    return st;
}
