// Sections drawn as images: one, or a stack of slices.
#include "meshes/drawing.h"

#include "base/input_file.h"
#include "base/memory.h"
#include "meshes/pixel_mesh.h"
#include "meshes/png_door.h"
#include "meshes/png_names.h"
#include "meshes/png_parts.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

// A file holds at most as much as its pixels uncompressed; a stack's different slices together
// need this much memory at most.
enum { MOST_FILE_BYTES = 1 << 27 };
// Stiffness matrices of longer elements lose their digits.
static const double longest_pixel = 100;
static const double same_ratio = 1 + 1e-12;
static const size_t most_run_bytes = (size_t)1 << 30;

// as many pixels of one material, row by row
typedef struct pixel_run {
    int count, material;
} pixel_run;

// a slice unlike all before it
typedef struct slice {
    int index; // of its file
    int nrun;
    pixel_run *run;
    uint64_t hash;
} slice;

typedef struct png_state {
    png_spec spec;
    png_names names;
    int n[2]; // pixels
    int *of;  // [names.count] which of `slices`
    int nslice, room;
    slice *slices;
    size_t bytes; // of all runs
} png_state;

static void png_close(void *state)
{
    png_state *s = state;
    if (s) {
        for (int i = 0; i < s->nslice; i++) {
            free(s->slices[i].run);
        }
        free(s->slices);
        free(s->of);
        free(s);
    }
}

// --- slices as runs

static status runs_make(const pixel_image *p, slice *out)
{
    status st = OK;
    const int n = p->n[0] * p->n[1];
    int nrun = 0;
    for (int i = 0; i < n; i++) {
        nrun += i == 0 || p->at[i] != p->at[i - 1];
    }
    TRY(TAKE(out->run, (size_t)nrun));
    out->hash = 0xcbf29ce484222325u; // FNV-1a
    for (int i = 0; i < n; i++) {
        if (i == 0 || p->at[i] != p->at[i - 1]) {
            out->run[out->nrun++].material = p->at[i];
        }
        out->run[out->nrun - 1].count++;
    }
    for (int i = 0; i < nrun; i++) {
        out->hash = (out->hash ^ (uint64_t)out->run[i].count) * 0x100000001b3u;
        out->hash = (out->hash ^ (uint64_t)out->run[i].material) * 0x100000001b3u;
    }

done:
    return st;
}

static bool runs_equal(const slice *a, const slice *b)
{
    return a->hash == b->hash && a->nrun == b->nrun &&
           memcmp(a->run, b->run, (size_t)a->nrun * sizeof *a->run) == 0;
}

static status runs_image(const png_state *s, const slice *from, pixel_image *out)
{
    status st = OK;
    TRY(pixel_image_make(s->n[0], s->n[1], s->spec.pitch, out));
    int at = 0;
    for (int i = 0; i < from->nrun; i++) {
        for (int k = 0; k < from->run[i].count; k++) {
            out->at[at++] = (short)from->run[i].material;
        }
    }

done:
    return st;
}

// --- reading

static status check_image(const png_state *s, const input_file *f, const pixel_image *p)
{
    status st = OK;
    int solid = 0;
    pixel_part apart = {0};
    const mark at = s->spec.file.at;
    if (p->n[0] != s->n[0] || p->n[1] != s->n[1]) {
        TRY(status_fail_at(ERR_INPUT, at.line, at.column,
                           "%s: it has %d x %d pixels, the slices before it %d x %d", f->path,
                           p->n[0], p->n[1], s->n[0], s->n[1]));
    }
    TRY(pixel_image_parts(p, &solid, &apart));
    if (solid == 0) {
        TRY(status_fail_at(ERR_INPUT, at.line, at.column, "%s: no pixel of it is of a material",
                           f->path));
    }
    if (apart.count > 0) {
        TRY(status_fail_at(ERR_INPUT, at.line, at.column,
                           "%s: %d pixel%s at column %d of row %d from the top %s the rest%s",
                           f->path, apart.count, apart.count > 1 ? "s" : "", apart.at[0] + 1,
                           p->n[1] - apart.at[1],
                           apart.touches ? (apart.count > 1 ? "touch" : "touches")
                                         : (apart.count > 1 ? "do not touch" : "does not touch"),
                           apart.touches ? " at corners of pixels only, which joins nothing" : ""));
    }

done:
    return st;
}

static status keep_slice(png_state *s, const input_file *f, const pixel_image *p, int index)
{
    status st = OK;
    slice new = {.index = index};
    TRY(runs_make(p, &new));
    for (int i = 0; i < s->nslice; i++) {
        if (runs_equal(&s->slices[i], &new)) {
            s->of[index] = i;
            goto done;
        }
    }
    TRY(check_image(s, f, p));
    s->bytes += (size_t) new.nrun * sizeof *new.run;
    if (s->bytes > most_run_bytes) {
        TRY(status_fail(ERR_RESOURCE, "%s: the stack's different slices need more than %zu MB",
                        f->path, most_run_bytes >> 20));
    }
    if (s->nslice == s->room) {
        slice *more = NULL;
        TRY(TAKE(more, 2 * (size_t)s->room + 8));
        if (s->nslice > 0) {
            memcpy(more, s->slices, (size_t)s->nslice * sizeof *more);
        }
        free(s->slices);
        s->slices = more;
        s->room = 2 * s->room + 8;
    }
    s->of[index] = s->nslice;
    s->slices[s->nslice++] = new;
    new = (slice){0};

done:
    free(new.run);
    return st;
}

static status read_slice(png_state *s, const char *directory, const png_parts *parts, int index)
{
    status st = OK;
    input_file f = {0};
    colour_image image = {0};
    pixel_image p = {0};
    char *name = NULL;

    TRY(png_names_at(&s->names, index, &name));
    const key_text file = {.text = name, .at = s->spec.file.at};
    TRY(input_file_read(directory, &file, MOST_FILE_BYTES, &f));
    TRY(png_door_read(&f, &image));
    TRY(png_parts_image(parts, &f, &image, s->spec.pitch, &p));
    if (index == 0) {
        s->n[0] = p.n[0];
        s->n[1] = p.n[1];
    }
    TRY(keep_slice(s, &f, &p, index));

done:
    free(name);
    input_file_free(&f);
    colour_image_free(&image);
    pixel_image_free(&p);
    return st;
}

static status check_pitch(const png_spec *spec)
{
    const double ratio = spec->pitch[0] / spec->pitch[1];
    if (!(fmax(ratio, 1 / ratio) <= longest_pixel * same_ratio)) {
        return status_fail_at(ERR_INPUT, spec->at.line, spec->at.column,
                              "png: pixels of %g x %g m make no elements: one side is more than "
                              "%g times the other",
                              spec->pitch[0], spec->pitch[1], longest_pixel);
    }
    return OK;
}

static status png_open(const drawing_files *files, const drawing_request *request, void **state)
{
    status st = OK;
    png_state *s = NULL;
    png_parts parts = {0};

    TRY(TAKE(s, 1));
    s->spec = files->png;
    TRY(check_pitch(&s->spec));
    TRY(png_names_find(&s->spec, request->directory, &s->names));
    TRY(png_parts_make(&s->spec, request, &parts));
    TRY(TAKE(s->of, (size_t)s->names.count));
    for (int i = 0; i < s->names.count; i++) {
        TRY(read_slice(s, request->directory, &parts, i));
    }
    *state = s;
    s = NULL;

done:
    png_parts_free(&parts);
    png_close(s);
    return st;
}

// --- what a drawing is asked

static int png_slice_count(const void *state)
{
    return ((const png_state *)state)->names.count;
}

static int png_same_as(const void *state, int slice)
{
    const png_state *s = state;
    return s->slices[s->of[slice]].index;
}

static double png_layer(const void *state)
{
    const png_state *s = state;
    return s->names.stack ? s->spec.layer : 0;
}

static status mesh_image(const png_state *s, const pixel_image *p, const mesh_options *options,
                         mesh *out)
{
    status st = OK;
    mesh m = {0};
    TRY(pixel_mesh_make(p, options, s->spec.boundaries == 1, &m));
    TRY(mesh_check(&m));
    *out = m;
    m = (mesh){0};

done:
    mesh_free(&m);
    return st;
}

static status png_mesh(const void *state, int slice, const mesh_options *options, mesh *out)
{
    status st = OK;
    const png_state *s = state;
    pixel_image p = {0};
    TRY(runs_image(s, &s->slices[s->of[slice]], &p));
    TRY(mesh_image(s, &p, options, out));

done:
    pixel_image_free(&p);
    return st;
}

static status png_pixels(const void *state, int slice, pixel_image *out)
{
    const png_state *s = state;
    return runs_image(s, &s->slices[s->of[slice]], out);
}

static status png_coarser(const void *state, int slice, const mesh_options *options, mesh *out,
                          bool *found)
{
    status st = OK;
    const png_state *s = state;
    pixel_image p = {0}, wide = {0};
    pixel_part apart = {0};
    int solid = 0;
    TRY(runs_image(s, &s->slices[s->of[slice]], &p));
    TRY(pixel_image_coarser(&p, &wide));
    TRY(pixel_image_parts(&wide, &solid, &apart));
    *found = solid > 0 && apart.count == 0;
    TRY(*found ? mesh_image(s, &wide, options, out) : OK);

done:
    pixel_image_free(&p);
    pixel_image_free(&wide);
    return st;
}

extern const drawing_kind png_drawing;
const drawing_kind png_drawing = {
    .open = png_open,
    .close = png_close,
    .slice_count = png_slice_count,
    .same_as = png_same_as,
    .layer = png_layer,
    .mesh = png_mesh,
    .coarser = png_coarser,
    .pixels = png_pixels,
    // stairs and the count of pixels leave ten times the error of elements of order 2: they cost a
    // sixth of order 4
    .best_order = 2,
};
