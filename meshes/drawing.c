// meshes/drawing.c
#include "meshes/drawing.h"

#include "base/memory.h"

#include <math.h>

struct drawing {
    const drawing_kind *kind;
    void *state;
    double reach; // once it was asked for
};

extern const drawing_kind png_drawing, msh_drawing, step_drawing, dxf_drawing, geo_drawing;

double drawing_unit_size(int unit)
{
    static const double sizes[] = {1e-3, 1, 1e-2, 1e-6, 25.4e-3};
    return sizes[unit];
}

static const drawing_kind *kind_of(const drawing_files *f)
{
    if (mark_given(f->png.at)) {
        return &png_drawing;
    }
    if (mark_given(f->msh.at)) {
        return &msh_drawing;
    }
    if (mark_given(f->step.at)) {
        return &step_drawing;
    }
    if (mark_given(f->dxf.at)) {
        return &dxf_drawing;
    }
    if (mark_given(f->geo.at)) {
        return &geo_drawing;
    }
    return NULL;
}

status drawing_open(const drawing_files *files, const drawing_request *request, drawing **out)
{
    status st = OK;
    drawing *d = NULL;
    *out = NULL;
    const drawing_kind *kind = kind_of(files);
    if (!kind) {
        return OK;
    }
    TRY(TAKE(d, 1));
    d->kind = kind;
    TRY(kind->open(files, request, &d->state));
    *out = d;
    d = NULL;

done:
    free(d);
    return st;
}

void drawing_free(drawing *d)
{
    if (d) {
        d->kind->close(d->state);
        free(d);
    }
}

double drawing_length(const drawing *d)
{
    return d->kind->layer ? d->kind->layer(d->state) * drawing_slice_count(d) : 0;
}

int drawing_slice_count(const drawing *d)
{
    return d->kind->slice_count ? d->kind->slice_count(d->state) : 1;
}

int drawing_slice_at(const drawing *d, double s)
{
    const int count = drawing_slice_count(d);
    const double layer = d->kind->layer ? d->kind->layer(d->state) : 0;
    if (count == 1 || !(layer > 0)) {
        return 0;
    }
    const int slice = (int)fmin(fmax(floor(s / layer), 0), count - 1);
    return d->kind->same_as ? d->kind->same_as(d->state, slice) : slice;
}

status drawing_outline(const drawing *d, section_outline *out, bool *found)
{
    *found = d->kind->outline != NULL;
    return *found ? d->kind->outline(d->state, out) : OK;
}

status drawing_reach(drawing *d, double *reach)
{
    status st = OK;
    mesh m = {0};
    section_outline o = {0};
    const mesh_options coarse = {.kind = MESH_AUTO, .order = 1};
    if (!(d->reach > 0) && d->kind->outline) {
        TRY(d->kind->outline(d->state, &o));
        d->reach = o.size;
    } else if (!(d->reach > 0)) {
        TRY(d->kind->mesh(d->state, 0, &coarse, &m));
        for (int i = 0; i < m.nnode; i++) {
            d->reach = fmax(d->reach, hypot(m.xyz[3 * i], m.xyz[3 * i + 1]));
        }
    }
    *reach = d->reach;

done:
    mesh_free(&m);
    section_outline_free(&o);
    return st;
}

int drawing_best_order(const drawing *d)
{
    return d->kind->best_order;
}

status drawing_mesh(const drawing *d, int slice, const mesh_options *options, mesh *out)
{
    return d->kind->mesh(d->state, slice, options, out);
}

status drawing_mesh_coarser(const drawing *d, int slice, const mesh_options *options, mesh *out,
                            bool *found)
{
    *found = false;
    return d->kind->coarser ? d->kind->coarser(d->state, slice, options, out, found) : OK;
}

status drawing_pixels(const drawing *d, int slice, pixel_image *out, bool *found)
{
    *found = d->kind->pixels != NULL;
    return *found ? d->kind->pixels(d->state, slice, out) : OK;
}
