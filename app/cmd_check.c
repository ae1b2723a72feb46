// app/cmd_check.c
// stiffaxis check CASE: reads the case and the files that it names, and draws and meshes its
// section at both ends and in the middle.
#include "app/case.h"
#include "app/document.h"
#include "app/reach_case.h"
#include "app/reach_scopes.h"
#include "app/warnings.h"
#include "io/json.h"

static const char *plural(int count)
{
    return count == 1 ? "" : "s";
}

// what of the reach study the case alone does not show
typedef struct reach_counts {
    int ntarget, ntriangle;
} reach_counts;

static status check_reach(const case_data *c, reach_counts *out)
{
    status st = OK;
    reach_scene scene = {0};
    TRY(reach_scene_open(c, &scene));
    for (int i = 0; i < c->file.reach.scopes.count; i++) {
        TRY(reach_scope_check(c, i));
    }
    *out = (reach_counts){scene.ntarget, scene.tissue.ntriangle};

done:
    reach_scene_free(&scene);
    return st;
}

static void write_reach(const case_data *c, const reach_counts *reach, FILE *stream)
{
    const int nscope = c->file.reach.scopes.count;
    fprintf(stream, "%s%d scope%s for %d target%s in a surface of %d triangles",
            case_has_section(c) ? ", " : "", nscope, plural(nscope), reach->ntarget,
            plural(reach->ntarget), reach->ntriangle);
}

static void write_section(const case_data *c, FILE *stream)
{
    const int nshape = c->file.section.shapes.count;
    fprintf(stream, "%d material%s, ", c->nmaterial, plural(c->nmaterial));
    if (c->file.section.drawing) {
        fprintf(stream, "a section from a file");
    } else {
        fprintf(stream, "%d shape%s", nshape, plural(nshape));
    }
}

static status write_check(const command *cmd, const case_data *c, const reach_counts *reach,
                          FILE *stream)
{
    status st = OK;
    json *j = NULL;
    const int ntendon = c->file.rod.tendons.count, nload = c->file.fem.loads.count;
    if (!cmd->json) {
        const int nrow = rod_case_solutions(&c->file.rod);
        fprintf(stream, "%s: good: ", config_path(c->config));
        if (case_has_section(c)) {
            write_section(c, stream);
        }
        if (case_has_rod(c)) {
            fprintf(stream, ", rod of %g mm with %d tendon%s, %d solution%s",
                    1e3 * c->file.rod.length, ntendon, plural(ntendon), nrow, plural(nrow));
        }
        if (case_has_segment(c)) {
            fprintf(stream, ", segment of %g mm with %d load%s", 1e3 * c->file.fem.length, nload,
                    plural(nload));
        }
        if (case_has_reach(c)) {
            write_reach(c, reach, stream);
        }
        fputc('\n', stream);
        return OK;
    }
    TRY(json_open(stream, &j));
    json_object(j, NULL);
    json_text(j, "schema", "stiffaxis/check/1");
    json_flag(j, "valid", true);
    json_text(j, "case", config_path(c->config));
    json_text(j, "title", c->file.title ? c->file.title : "");
    json_integer(j, "materials", c->nmaterial);
    json_integer(j, "shapes", c->file.section.shapes.count);
    json_flag(j, "has_rod", case_has_rod(c));
    json_flag(j, "has_fem", case_has_segment(c));
    json_flag(j, "has_reach", case_has_reach(c));
    json_object_end(j);
    st = json_close(j);

done:
    return st;
}

status cmd_check(command *cmd)
{
    status st = OK;
    case_data c = {0};
    document d = {0};
    reach_counts reach = {0};
    TRY(command_case(cmd, &c));
    // free meshes take a library's start: one is enough
    for (int i = 0; i <= 2 && case_has_section(&c); i++) {
        st = section_check(&c.file.section, c.materials, 0.5 * i * c.length, i == 0);
        TRY(case_place(&c, st, c.file.section.at));
    }
    TRY(warn_materials(cmd, &c));
    TRY(case_has_rod(&c) ? warn_tendons(cmd, &c) : OK);
    TRY(case_has_segment(&c) ? warn_segment(cmd, &c) : OK);
    TRY(case_has_reach(&c) ? check_reach(&c, &reach) : OK);
    TRY(document_begin(&d));
    TRY(write_check(cmd, &c, &reach, d.stream));
    TRY(document_end(&d, cmd, cmd->json ? "check.json" : "check.txt"));

done:
    document_free(&d);
    case_free(&c);
    return st;
}
