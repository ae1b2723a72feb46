// meshes/dxf_drawing.c
// The kind of drawing that `dxf:` names.
#include "base/memory.h"
#include "meshes/dxf.h"
#include "meshes/outline_move.h"

#include <string.h>

enum { MOST_BYTES = 64 << 20 };

// the file's own unit, or else millimetres, before the units that a case can name
enum { UNIT_OF_FILE };
static const double UNSAID = 1e-3;

static status find_materials(const dxf_plan *p, const input_file *f, part_table *parts, int *out)
{
    status st = OK;
    const char **names = NULL;
    TRY(TAKE(names, (size_t)p->nlayer));
    for (int i = 0; i < p->nlayer; i++) {
        long line = 0;
        for (int k = p->nchain - 1; k >= 0; k--) {
            line = p->chain[k].layer == i ? p->chain[k].line : line;
        }
        names[i] = p->layer[i];
        out[i] = part_by_name(parts, p->layer[i]);
        if (out[i] == PART_UNKNOWN && strcmp(p->layer[i], "none") == 0) {
            out[i] = PART_NONE;
        }
        if (out[i] == PART_UNKNOWN) {
            TRY(part_unknown(parts, f, line, p->layer[i]));
        }
    }
    TRY(parts_all_used(parts, p->nlayer, names));

done:
    free(names);
    return st;
}

static status read_outline(const dxf_spec *spec, const drawing_request *request,
                           section_outline *out)
{
    status st = OK;
    input_file f = {0};
    dxf_plan p = {0};
    dxf_loops l = {0};
    part_table parts = {0};
    int *material = NULL;

    TRY(parts_make("layer", &spec->parts, request, &parts));
    TRY(input_file_read(request->directory, &spec->file, MOST_BYTES, &f));
    TRY(dxf_read(&f, &p));
    TRY(TAKE(material, (size_t)p.nlayer));
    TRY(find_materials(&p, &f, &parts, material));
    TRY(dxf_join(&f, &p, &l));
    const double said = p.unit > 0 ? p.unit : UNSAID;
    const double unit =
        spec->unit == UNIT_OF_FILE ? said : drawing_unit_size(spec->unit - UNIT_OF_FILE - 1);
    TRY(dxf_nest(&p, &l, material, unit, spec->at, out));

done:
    free(material);
    parts_free(&parts);
    dxf_loops_free(&l);
    dxf_plan_free(&p);
    input_file_free(&f);
    return st;
}

static status open_drawing(const drawing_files *files, const drawing_request *request, void **state)
{
    status st = OK;
    section_outline *o = NULL;
    TRY(TAKE(o, 1));
    TRY(read_outline(&files->dxf, request, o));
    *state = o;
    o = NULL;

done:
    free(o);
    return st;
}

static void close_drawing(void *state)
{
    section_outline_free(state);
    free(state);
}

static status give_outline(const void *state, section_outline *out)
{
    return section_outline_copy(state, out);
}

static status give_mesh(const void *state, int slice, const mesh_options *options, mesh *out)
{
    (void)slice;
    return section_mesh_make(state, options, out);
}

extern const drawing_kind dxf_drawing;
const drawing_kind dxf_drawing = {
    .open = open_drawing, .close = close_drawing, .outline = give_outline, .mesh = give_mesh};
