// meshes/step_drawing.c
// `step:` and `geo:` as sources of sections.
#include "meshes/drawing.h"

#include "base/dense.h"
#include "base/memory.h"
#include "meshes/cad.h"
#include "meshes/sniff.h"

#include <math.h>

static const size_t MOST_BYTES = (size_t)256 << 20;

// of the x axis, what is left of it beside the normal
static const double NOT_PARALLEL = 1e-6;

static void cad_close(void *state)
{
    cad_source *s = state;
    if (s) {
        cad_source_free(s);
        free(s);
    }
}

static status cad_draw(const void *state, int slice, const mesh_options *options, mesh *out)
{
    (void)slice;
    return cad_mesh(state, options, out);
}

// --- step

static status check_step(const input_file *f)
{
    char words[SNIFF_WORDS];
    if (!input_file_begins(f, "ISO-10303-21;")) {
        return input_file_fail(f, 0, "it is no STEP file, which begins with ISO-10303-21; it is %s",
                               sniff_words(f, words));
    }
    if (!input_file_ends(f, "END-ISO-10303-21;")) {
        return input_file_fail(f, 0,
                               "it does not end with END-ISO-10303-21; so that it is not "
                               "complete");
    }
    return OK;
}

// rows x, y, z of the section in the file's axes
static status make_turn(const step_spec *spec, double turn[3][3])
{
    const vec3 n = {{spec->normal[0], spec->normal[1], spec->normal[2]}};
    const vec3 x = {{spec->x_axis[0], spec->x_axis[1], spec->x_axis[2]}};
    const double nn = vec3_norm(n), nx = vec3_norm(x);
    if (!(isfinite(nn) && isfinite(nx) && nn > 0 && nx > 0)) {
        return status_fail_at(ERR_INPUT, spec->at.line, spec->at.column,
                              "step: `normal` and `x_axis` need a length");
    }
    const vec3 e3 = vec3_scale(1 / nn, n);
    const vec3 across = vec3_sub(x, vec3_scale(vec3_dot(x, e3), e3));
    if (!(vec3_norm(across) > NOT_PARALLEL * nx)) {
        return status_fail_at(ERR_INPUT, spec->at.line, spec->at.column,
                              "step: `x_axis` lies along `normal`: give another one");
    }
    const vec3 e1 = vec3_scale(1 / vec3_norm(across), across), e2 = vec3_cross(e3, e1);
    for (int i = 0; i < 3; i++) {
        turn[0][i] = e1.a[i];
        turn[1][i] = e2.a[i];
        turn[2][i] = e3.a[i];
    }
    return OK;
}

static status step_open(const drawing_files *files, const drawing_request *request, void **state)
{
    status st = OK;
    const step_spec *spec = &files->step;
    part_table parts = {0};
    cad_source *s = NULL;

    TRY(TAKE(s, 1));
    s->unit = 1e-3; // gmsh is asked for mm whatever the file's unit is
    TRY(make_turn(spec, s->request.turn));
    for (int i = 0; i < 3; i++) {
        s->request.place[i] = spec->origin[i] / s->unit;
    }
    TRY(parts_make("body", &spec->parts, request, &parts));
    TRY(input_file_read(request->directory, &spec->file, MOST_BYTES, &s->file));
    TRY(check_step(&s->file));
    TRY(cad_look(s, &parts));
    *state = s;
    s = NULL;

done:
    cad_close(s);
    parts_free(&parts);
    return st;
}

const drawing_kind step_drawing = {.open = step_open, .close = cad_close, .mesh = cad_draw};

// --- geo

static status geo_open(const drawing_files *files, const drawing_request *request, void **state)
{
    status st = OK;
    const geo_spec *spec = &files->geo;
    part_table parts = {0};
    cad_source *s = NULL;

    if (!request->allow_scripts) {
        return status_fail_at(ERR_INPUT, spec->at.line, spec->at.column,
                              "geo: a gmsh script can run programs and write files; give "
                              "--allow-scripts if you trust it");
    }
    TRY(TAKE(s, 1));
    s->unit = drawing_unit_size(spec->unit);
    s->request.script = true;
    for (int i = 0; i < 3; i++) {
        s->request.turn[i][i] = 1;
    }
    TRY(parts_make("physical group", &spec->parts, request, &parts));
    TRY(input_file_read(request->directory, &spec->file, MOST_BYTES, &s->file));
    TRY(cad_look(s, &parts));
    *state = s;
    s = NULL;

done:
    cad_close(s);
    parts_free(&parts);
    return st;
}

const drawing_kind geo_drawing = {.open = geo_open, .close = cad_close, .mesh = cad_draw};
