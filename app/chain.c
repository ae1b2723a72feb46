// app/chain.c
#include "app/chain.h"

#include "app/compare.h"
#include "app/measured_case.h"
#include "app/reach_case.h"
#include "app/sensitivity.h"
#include "app/versions.h"
#include "app/warnings.h"
#include "base/memory.h"
#include "reports/markup.h"

#include <string.h>

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

// the case's text, and below it what --set changed
static status copy_text(const command *cmd, const case_data *c, run_result *out)
{
    status st = OK;
    size_t length = 0;
    const char *text = config_text(c->config, &length);
    size_t room = length + 1;
    for (int i = 0; i < cmd->noverride; i++) {
        room += strlen(cmd->overrides[i]) + sizeof "# --set \n";
    }
    TRY(TAKE(out->case_text, room));
    memcpy(out->case_text, text, length);
    for (int i = 0; i < cmd->noverride; i++) {
        length += (size_t)snprintf(out->case_text + length, room - length, "# --set %s\n",
                                   cmd->overrides[i]);
    }
    out->case_length = length;

done:
    return st;
}

static status copy_materials(const case_data *c, run_result *out)
{
    status st = OK;
    TRY(TAKE(out->materials, (size_t)c->nmaterial));
    out->nmaterial = c->nmaterial;
    for (int i = 0; i < c->nmaterial; i++) {
        const char *name = c->materials[i].name;
        char *copy = NULL;
        out->materials[i] = c->materials[i];
        out->materials[i].name = NULL;
        TRY(TAKE(copy, strlen(name) + 1));
        memcpy(copy, name, strlen(name));
        out->materials[i].name = copy;
    }

done:
    return st;
}

static void copy_title(const case_data *c, run_result *out)
{
    const char *title = c->file.title;
    if (!title) {
        const char *path = config_path(c->config), *slash = strrchr(path, '/');
        title = slash ? slash + 1 : path;
    }
    char words[2 * sizeof out->title];
    const char *fitted = c->file.fitted;
    (void)snprintf(words, sizeof words, "%s%s%s%s", title, fitted ? " [fitted: " : "",
                   fitted ? fitted : "", fitted ? "]" : "");
    utf8_shorten(words, sizeof out->title - 16, out->title, sizeof out->title);
}

status chain_about(const command *cmd, const case_data *c, run_result *out)
{
    status st = OK;
    copy_title(c, out);
    TRY(copy_text(cmd, c, out));
    TRY(copy_materials(c, out));

done:
    return st;
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
