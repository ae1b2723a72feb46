// app/segment_points.c
#include "app/segment_points.h"

#include "app/case_segment.h"

#include <string.h>

// one material is enough to tell: `differs` of it and the first one
static const material *first_that(const material *materials, const mesh *m,
                                  bool (*differs)(const material *, const material *))
{
    const material *first = NULL;
    for (int b = 0; b < m->nblock; b++) {
        for (int e = 0; e < m->block[b].nelem; e++) {
            const material *one = &materials[m->block[b].material[e]];
            first = first ? first : one;
            if (differs(one, first)) {
                return one;
            }
        }
    }
    return NULL;
}

static bool is_special(const material *one, const material *first)
{
    (void)first;
    return one->kind != MATERIAL_ISOTROPIC || one->modulus.at;
}

static bool has_other_poisson(const material *one, const material *first)
{
    return one->nu != first->nu;
}

static bool has_no_density(const material *one, const material *first)
{
    (void)first;
    return !(one->density > 0);
}

bool segment_is_isotropic(const material *materials, const mesh *m)
{
    return !first_that(materials, m, is_special);
}

bool segment_has_one_poisson(const material *materials, const mesh *m)
{
    return !first_that(materials, m, has_other_poisson);
}

status segment_check_densities(const case_data *c, const mesh *m)
{
    const material *light =
        case_segment_accelerates(c) ? first_that(c->materials, m, has_no_density) : NULL;
    return light ? case_density_missing(c, light, CASE_SEGMENT_ACCELERATES) : OK;
}

// --- the stiffness centre

static bool one_poisson_outlines(const case_data *c, const section_outline *o)
{
    const material *first = NULL;
    for (int i = 0; i < o->count; i++) {
        const int k = o->items[i].material;
        const material *one = k >= 0 ? &c->materials[k] : NULL;
        first = first ? first : one;
        if (one && has_other_poisson(one, first)) {
            return false;
        }
    }
    return true;
}

// exact integrals over arcs, which give the centre of the full law where one Poisson's ratio rules
static status closed_law(const case_data *c, beam_law *law, bool *done)
{
    status st = OK;
    section_outline o = {0};
    bool found = false;
    const section_case *section = &c->file.section;
    *done = false;
    TRY(section_outline_at(section, c->file.fem.section_at, &o, &found));
    if (found && one_poisson_outlines(c, &o)) {
        TRY(section_classical_closed(&o, c->materials, law, done));
    }

done:
    section_outline_free(&o);
    return st;
}

// on the section's own mesh: integrals, and warping only where it counts
static status meshed_law(const case_data *c, beam_law *law)
{
    status st = OK;
    mesh m = {0};
    TRY(section_mesh_at(&c->file.section, c->file.fem.section_at, &m));
    if (segment_is_isotropic(c->materials, &m) && segment_has_one_poisson(c->materials, &m)) {
        TRY(section_classical_mesh(&m, c->materials, law));
    } else {
        TRY(section_full_mesh(&m, c->materials, law, NULL));
    }

done:
    mesh_free(&m);
    return st;
}

static status stiffness_centre(const case_data *c, double centre[2])
{
    status st = OK;
    beam_law law = {0};
    beam_centres centres = {0};
    bool done = false;
    TRY(closed_law(c, &law, &done));
    TRY(done ? OK : meshed_law(c, &law));
    TRY(beam_law_centres(&law, &centres));
    memcpy(centre, centres.stiffness_centre, 2 * sizeof *centre);

done:
    return case_place(c, st, c->file.section.at);
}

status segment_points(const case_data *c, double (*point)[2])
{
    status st = OK;
    const segment_load *loads = c->file.fem.loads.items;
    double centre[2];
    bool known = false;
    for (int i = 0; i < c->file.fem.loads.count; i++) {
        memset(point[i], 0, sizeof point[i]);
        if (loads[i].at_kind == 1) {
            TRY(known ? OK : stiffness_centre(c, centre));
            known = true;
            memcpy(point[i], centre, sizeof centre);
        } else if (loads[i].point.nrow > 0) {
            memcpy(point[i], loads[i].point.a, sizeof point[i]);
        }
    }

done:
    return st;
}
