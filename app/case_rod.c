// app/case_rod.c
#include "app/case_rod.h"

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

// of the shapes' materials; of a file's they are known with its mesh
static status check_densities(const case_data *c)
{
    const shape_spec *shapes = c->file.section.shapes.items;
    for (int i = 0; !c->file.section.drawing && i < c->file.section.shapes.count; i++) {
        const int k = shapes[i].material_index;
        if (k >= 0 && !(c->materials[k].density > 0)) {
            return config_fail(c->config, c->materials[k].at,
                               "'%s' needs its `density_kg_per_m3`: the rod bends under gravity",
                               c->materials[k].name);
        }
    }
    return OK;
}

status case_rod_bind(case_data *c, const char *directory)
{
    status st = OK;
    rod_case *rod = &c->file.rod;
    mark where = rod->at;
    TRY(case_place(c, read_paths(rod, directory), where));
    st = rod_case_bind(rod, &where);
    TRY(case_place(c, st, where));
    TRY(rod_case_has_gravity(rod) ? check_densities(c) : OK);

done:
    return st;
}
