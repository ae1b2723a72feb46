// app/case_segment.c
#include "app/case_segment.h"

bool case_segment_accelerates(const case_data *c)
{
    const segment_load *loads = c->file.fem.loads.items;
    for (int i = 0; i < c->file.fem.loads.count; i++) {
        const double *a = loads[i].acceleration;
        if (a[0] != 0 || a[1] != 0 || a[2] != 0) {
            return true;
        }
    }
    return false;
}

status case_density_missing(const case_data *c, const material *m, const char *why)
{
    return config_fail(c->config, m->at, "'%s' needs its `density_kg_per_m3`: %s", m->name, why);
}

status case_check_densities(const case_data *c, const char *why)
{
    const shape_spec *shapes = c->file.section.shapes.items;
    for (int i = 0; !c->file.section.drawing && i < c->file.section.shapes.count; i++) {
        const int k = shapes[i].material_index;
        if (k >= 0 && !(c->materials[k].density > 0)) {
            return case_density_missing(c, &c->materials[k], why);
        }
    }
    return OK;
}

// what the rounding of a unit may add to the segment's end, over the rod's length
static const double AT_TIP = 1e-12;

// the case's length is the rod's where there is one: past it nothing says what the section is
static status check_reach(const case_data *c)
{
    const segment_case *fem = &c->file.fem;
    const double end = fem->section_at + fem->length;
    if (fem->section_at > c->length) {
        return config_fail(c->config, fem->at,
                           "the segment's section at %g mm lies beyond the rod's %g mm",
                           1e3 * fem->section_at, 1e3 * c->length);
    }
    if (fem->course == COURSE_ALONG && case_has_rod(c) && section_varies(&c->file.section) &&
        end > c->length * (1 + AT_TIP)) {
        return config_fail(c->config, fem->at,
                           "the segment ends at %g mm, beyond the rod's %g mm, where nothing says "
                           "what its section is: take `body: prism` or a shorter `length_mm`",
                           1e3 * end, 1e3 * c->length);
    }
    return OK;
}

status case_segment_check(const case_data *c)
{
    status st = OK;
    const segment_case *fem = &c->file.fem;
    mark where = fem->at;
    st = segment_case_check(fem, &where);
    TRY(case_place(c, st, where));
    if (case_segment_accelerates(c)) {
        TRY(case_check_densities(c, CASE_SEGMENT_ACCELERATES));
    }
    TRY(check_reach(c));

done:
    return st;
}
