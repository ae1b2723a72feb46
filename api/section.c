// api/section.c
#include "api/handles.h"

#include "base/memory.h"

#include <string.h>

static status make_section(stiffaxis_case *c, stiffaxis_section **out)
{
    status st = OK;
    stiffaxis_section *section = NULL;
    *out = NULL;
    status_clear();
    TRY(case_need_section(&c->data));
    TRY(TAKE(section, 1));
    TRY(variation_open(&c->data, NULL, &section->v));
    section->users = 1;
    section->c = c;
    (void)atomic_fetch_add(&c->users, 1);
    *out = section;
    section = NULL;

done:
    free(section);
    return st;
}

int stiffaxis_section_make(stiffaxis_case *c, stiffaxis_section **out)
{
    turn_begin();
    const status st = make_section(c, out);
    turn_end();
    return (int)st;
}

void stiffaxis_section_free(stiffaxis_section *section)
{
    if (section && atomic_fetch_sub(&section->users, 1) == 1) {
        turn_begin();
        variation_free(&section->v);
        turn_end();
        stiffaxis_case_free(section->c);
        free(section);
    }
}

int stiffaxis_section_count(const stiffaxis_section *section)
{
    return section->v.section.nstation;
}

int stiffaxis_section_station(const stiffaxis_section *section, int i, stiffaxis_station *out)
{
    const section_result *r = &section->v.section;
    status_clear();
    if (i < 0 || i >= r->nstation) {
        return (int)status_fail(ERR_INPUT, "no station %d: there are %d", i, r->nstation);
    }
    const section_station *s = &r->station[i];
    const beam_centres *c = &s->centres;
    *out = (stiffaxis_station){
        .s = s->s,
        .area = s->law.area,
        .EA = c->EA,
        .stiffness_centre = {c->stiffness_centre[0], c->stiffness_centre[1]},
        .principal_angle = c->principal_angle,
        .EI = {c->EI[0], c->EI[1]},
        .EI_centre = {c->EI_centre[0], c->EI_centre[1], c->EI_centre[2]},
        .GJ = c->GJ,
        .shear_centre = {c->shear_centre[0], c->shear_centre[1]},
        .mass = s->law.mass,
        .mass_centre = {s->law.mass_centre[0], s->law.mass_centre[1]},
        .relative_error = s->law.relative_error,
        .isotropic = c->isotropic,
    };
    memcpy(out->K, s->law.K.a, sizeof out->K);
    memcpy(out->K_relative_error, s->law.entry_error.a, sizeof out->K_relative_error);
    return OK;
}

int stiffaxis_section_at(const stiffaxis_section *section, int n, const double *s, double *K,
                         double *dK)
{
    status_clear();
    for (int i = 0; i < n; i++) {
        mat6 value, slope;
        if (!isfinite(s[i])) {
            return (int)status_fail(ERR_INPUT, "arclength %d is not finite", i);
        }
        law_along_at(&section->v.section.along, s[i], &value, dK ? &slope : NULL);
        memcpy(K + 36 * (size_t)i, value.a, sizeof value.a);
        if (dK) {
            memcpy(dK + 36 * (size_t)i, slope.a, sizeof slope.a);
        }
    }
    return OK;
}

int stiffaxis_section_solved(const stiffaxis_section *section)
{
    return section->v.section.effort.nsolved;
}

double stiffaxis_section_interpolation_error(const stiffaxis_section *section)
{
    return section->v.section.along.relative_error;
}
