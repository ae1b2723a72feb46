// app/chain.c
#include "app/chain.h"

#include "app/compare.h"
#include "app/measured_case.h"
#include "app/reach_case.h"
#include "app/sensitivity.h"
#include "app/versions.h"
#include "app/warnings.h"

chain_parts chain_all_parts(const case_data *c)
{
    return (chain_parts){
        .section = case_has_section(c),
        .rod = case_has_rod(c),
        .fit = case_has_fit(c),
        .segment = case_has_segment(c),
        .compare = case_has_section(c),
        .reach = case_has_reach(c),
        .sensitivity = case_has_sensitivity(c),
        .measured = case_has_measured(c),
        .pictures = true,
    };
}

status chain_section(const case_data *c, bool mesh, run_result *out)
{
    status st = OK;
    section_outline outline = {0};
    bool found = false;
    const section_case *section = &c->file.section;
    st = section_along(section, c->materials, c->length, &out->section);
    TRY(case_place(c, st, section->at));
    out->has_section = true;
    out->section_model = section->model;
    if (mesh) {
        const section_station *first = &out->section.station[0];
        const double s = first->s;
        TRY(case_place(c, section_outline_at(section, s, &outline, &found), section->at));
        out->symmetry_turn = outline.has_symmetry ? outline.turn : 0;
        TRY(case_place(c, section_mesh_with(section, s, &first->mesh, &out->section_mesh),
                       section->at));
    }

done:
    section_outline_free(&outline);
    return st;
}

status chain_run(const command *cmd, const case_data *c, chain_parts parts, run_result *out)
{
    status st = OK;
    run_result r = {0};
    TRY(chain_about(cmd, c, &r));
    if (parts.section || parts.rod || parts.compare) {
        TRY(warn_materials(cmd, c));
        command_progress(cmd, "section");
        TRY(chain_section(c, parts.pictures, &r));
        TRY(chain_points(c, &r));
        TRY(parts.answers ? chain_answers(c, parts.pictures, &r) : OK);
    }
    if (parts.rod) {
        TRY(warn_tendons(cmd, c));
        TRY(chain_rods(cmd, c, &r));
        TRY(parts.measured ? chain_measured(cmd, c, &r) : OK);
    }
    TRY(parts.sensitivity ? chain_sensitivity(cmd, c, &r) : OK);
    if (parts.fit) {
        TRY(chain_fit(cmd, c, &r));
    }
    if (parts.segment) {
        TRY(warn_segment(cmd, c));
        command_progress(cmd, "3D segment");
        TRY(chain_segment(c, parts.pictures, &r));
    }
    if (parts.compare) { // on every rank: the section's law by 3D FEM is solved by all of them
        TRY(compare_all(cmd, c, &r));
    }
    TRY(parts.reach ? chain_reach(cmd, c, &r) : OK);
    TRY(parts.design ? chain_design(cmd, c, &r) : OK);
    versions_loaded(r.versions, sizeof r.versions);
    *out = r;
    r = (run_result){0};

done:
    command_progress(cmd, NULL);
    run_result_free(&r);
    return st;
}
