// app/cmd_check.c
// stiffaxis check CASE: reads the case, and draws and meshes its section at both ends and in the
// middle.
#include "app/case.h"
#include "app/document.h"
#include "app/warnings.h"
#include "io/json.h"

static const char *plural(int count)
{
    return count == 1 ? "" : "s";
}

static status write_check(const command *cmd, const case_data *c, FILE *stream)
{
    status st = OK;
    json *j = NULL;
    const int ntendon = c->file.rod.tendons.count, nload = c->file.fem.loads.count;
    if (!cmd->json) {
        const int nrow = rod_case_solutions(&c->file.rod);
        const int nshape = c->file.section.shapes.count;
        fprintf(stream, "%s: good: %d material%s, ", config_path(c->config), c->nmaterial,
                plural(c->nmaterial));
        if (c->file.section.drawing) {
            fprintf(stream, "a section from a file");
        } else {
            fprintf(stream, "%d shape%s", nshape, plural(nshape));
        }
        if (case_has_rod(c)) {
            fprintf(stream, ", rod of %g mm with %d tendon%s, %d solution%s",
                    1e3 * c->file.rod.length, ntendon, plural(ntendon), nrow, plural(nrow));
        }
        if (case_has_segment(c)) {
            fprintf(stream, ", segment of %g mm with %d load%s", 1e3 * c->file.fem.length, nload,
                    plural(nload));
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
    TRY(command_case(cmd, &c));
    // free meshes take a library's start: one is enough
    for (int i = 0; i <= 2; i++) {
        st = section_check(&c.file.section, c.materials, 0.5 * i * c.length, i == 0);
        TRY(case_place(&c, st, c.file.section.at));
    }
    TRY(warn_materials(cmd, &c));
    TRY(case_has_rod(&c) ? warn_tendons(cmd, &c) : OK);
    TRY(case_has_segment(&c) ? warn_segment(cmd, &c) : OK);
    TRY(document_begin(&d));
    TRY(write_check(cmd, &c, d.stream));
    TRY(document_end(&d, cmd, cmd->json ? "check.json" : "check.txt"));

done:
    document_free(&d);
    case_free(&c);
    return st;
}
