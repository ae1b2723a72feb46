// app/beam_models.c
#include "app/beam_models.h"

#include "rodsolver/rod.h"

#include <string.h>

// points per panel: of a panel of Chebyshev order 32 and the arms' squares they leave rounding
enum { COMPLIANCE_POINTS = 32 };

const char *beam_model_name(int model)
{
    static const char *const names[BEAM_MODELS] = {"classical", "full, as if prismatic",
                                                   "full, knows its turning"};
    return names[model];
}

void beam_models_free(beam_models *m)
{
    for (int i = 0; i < BEAM_MODELS; i++) {
        law_along_free(&m->law[i]);
    }
}

// the law of one place, all along
static status constant_law(const section_case *section, const material *materials, double s,
                           double length, law_along *out)
{
    status st = OK;
    law_along along = {0};
    TRY(law_along_make(length, 1, 1, &along));
    TRY(section_solve(section, materials, s, 0, &along.law[0]));
    *out = along;
    along = (law_along){0};

done:
    law_along_free(&along);
    return st;
}

static status law_of(const section_case *section, const material *materials, double length,
                     law_along *out)
{
    status st = OK;
    section_result r = {0};
    TRY(section_along(section, materials, length, &r));
    *out = r.along;
    r.along = (law_along){0};

done:
    section_result_free(&r);
    return st;
}

// at the nodes of the law that knows its turning, each section as if nothing turned
static status prismatic_law(const section_case *section, const material *materials,
                            const law_along *turning, law_along *out)
{
    status st = OK;
    law_along along = {0};
    TRY(law_along_make(turning->length, turning->npanel, turning->nnode, &along));
    memcpy(along.edge, turning->edge, (size_t)(turning->npanel + 1) * sizeof *along.edge);
    along.symmetric = turning->symmetric;
    for (int k = 0; k < turning->npanel; k++) {
        for (int i = 0; i < turning->nnode; i++) {
            const int at = k * turning->nnode + i;
            beam_law law = {0};
            TRY(section_solve(section, materials, law_along_node(turning, k, i), 0, &law));
            along.turn[at] = turning->turn[at];
            along.law[at] = beam_law_turn(law, turning->turn[at]);
        }
    }
    *out = along;
    along = (law_along){0};

done:
    law_along_free(&along);
    return st;
}

static status make_one(const case_data *c, double reach, int model, beam_models *m)
{
    section_case section = c->file.section;
    section.model = model == BEAM_CLASSICAL ? MODEL_CLASSICAL : MODEL_FULL;
    if (c->file.fem.course == COURSE_PRISM) {
        return constant_law(&section, c->materials, m->from, reach, &m->law[model]);
    }
    return model == BEAM_PRISMATIC
               ? prismatic_law(&section, c->materials, &m->law[BEAM_TURNING], &m->law[model])
               : law_of(&section, c->materials, reach, &m->law[model]);
}

status beam_models_make(const case_data *c, double length, beam_models *out)
{
    status st = OK;
    beam_models m = {.from = c->file.fem.section_at};
    const double reach = fmax(c->length, m.from + length);
    TRY(case_place(c, make_one(c, reach, BEAM_TURNING, &m), c->file.section.at));
    TRY(case_place(c, make_one(c, reach, BEAM_PRISMATIC, &m), c->file.section.at));
    // the paper's model does not take every material
    if (make_one(c, reach, BEAM_CLASSICAL, &m) != OK) {
        (void)snprintf(m.why[BEAM_CLASSICAL], sizeof m.why[BEAM_CLASSICAL], "%s", status_message());
        status_clear();
    }
    *out = m;
    m = (beam_models){0};

done:
    beam_models_free(&m);
    return st;
}

status beam_models_compliance(const beam_models *m, int model, double length, mat6 *out)
{
    return rod_linear_compliance_between(&m->law[model], m->from, m->from + length,
                                         COMPLIANCE_POINTS, out);
}
