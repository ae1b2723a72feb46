// app/cmd_check.c
// stiffaxis check CASE: reads the case and the files that it names, draws and meshes its section at
// both ends and in the middle, and says what it has understood.
#include "app/case.h"
#include "app/design_case.h"
#include "app/document.h"
#include "app/explain.h"
#include "app/reach_case.h"
#include "app/reach_scopes.h"
#include "app/warnings.h"
#include "io/json.h"
#include "io/number.h"

#include <string.h>

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

static status explain_all(explanation *e, const case_data *c, const mesh *first)
{
    status st = OK;
    TRY(case_has_section(c) ? explain_section(e, c, first) : OK);
    if (case_has_rod(c)) {
        explain_rod(e, c);
    }
    TRY(case_has_segment(c) ? explain_segment(e, c) : OK);
    explain_plan(e, c);

done:
    return st;
}

// what checking found, beside the case
typedef struct found {
    const case_data *c;
    reach_counts reach;
    mesh first;        // of the section at s = 0
    document warnings; // a line each
} found;

static void write_first_line(const found *f, FILE *stream)
{
    const case_data *c = f->c;
    const int ntendon = c->file.rod.tendons.count, nload = c->file.fem.loads.count;
    const int nrow = rod_case_solutions(&c->file.rod);
    fprintf(stream, "%s: good: ", config_path(c->config));
    if (case_has_section(c)) {
        write_section(c, stream);
    }
    if (case_has_rod(c)) {
        fprintf(stream, ", rod of %g mm with %d tendon%s, %d solution%s", 1e3 * c->file.rod.length,
                ntendon, plural(ntendon), nrow, plural(nrow));
    }
    if (case_has_segment(c)) {
        fprintf(stream, ", segment of %g mm with %d load%s", 1e3 * c->file.fem.length, nload,
                plural(nload));
    }
    if (case_has_reach(c)) {
        write_reach(c, &f->reach, stream);
    }
    (void)fputc('\n', stream);
}

static void write_file(void *self, const char *name)
{
    json_text(self, NULL, name);
}

static void write_warnings(json *j, char *lines)
{
    json_array(j, "warnings");
    for (char *line = lines; line && *line;) {
        char *end = strchr(line, '\n');
        *end = '\0';
        json_text(j, NULL, line);
        line = end + 1;
    }
    json_array_end(j);
}

static status write_json(const found *f, FILE *stream)
{
    status st = OK;
    json *j = NULL;
    const case_data *c = f->c;
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
    json_integer(j, "solutions", case_has_rod(c) ? rod_case_solutions(&c->file.rod) : 0);
    json_array(j, "files");
    case_files(c, write_file, j);
    json_array_end(j);
    write_warnings(j, f->warnings.text);
    json_array(j, "understood");
    st = explain_all(&(explanation){.j = j}, c, &f->first);
    json_array_end(j);
    json_object_end(j);
    const status closed = json_close(j);
    st = st == OK ? closed : st;

done:
    return st;
}

static status write_text(const found *f, FILE *stream)
{
    write_first_line(f, stream);
    (void)fputc('\n', stream);
    return explain_all(&(explanation){.stream = stream}, f->c, &f->first);
}

// what the case alone cannot tell: its section drawn, its files read
static status look(command *cmd, found *f)
{
    status st = OK;
    const case_data *c = f->c;
    TRY(document_begin(&f->warnings));
    cmd->warnings = f->warnings.stream;
    // free meshes take a library's start: one is enough
    for (int i = 0; i <= 2 && case_has_section(c); i++) {
        st = section_check(&c->file.section, c->materials, 0.5 * i * c->length, i == 0,
                           i == 0 ? &f->first : NULL);
        TRY(case_place(c, st, c->file.section.at));
    }
    TRY(warn_materials(cmd, c));
    TRY(case_has_rod(c) ? warn_tendons(cmd, c) : OK);
    TRY(case_has_segment(c) ? warn_segment(cmd, c) : OK);
    TRY(case_has_design(c) ? case_design_check(c) : OK);
    TRY(case_has_reach(c) ? check_reach(c, &f->reach) : OK);

done:
    cmd->warnings = NULL;
    return st == OK ? document_close(&f->warnings) : st;
}

status cmd_check(command *cmd)
{
    status st = OK;
    case_data c = {0};
    document d = {0};
    found f = {.c = &c};
    TRY(command_case(cmd, &c));
    TRY(look(cmd, &f));
    TRY(document_begin(&d));
    TRY(cmd->json ? write_json(&f, d.stream) : write_text(&f, d.stream));
    TRY(document_end(&d, cmd, cmd->json ? "check.json" : "check.txt"));

done:
    mesh_free(&f.first);
    document_free(&f.warnings);
    document_free(&d);
    case_free(&c);
    return st;
}
