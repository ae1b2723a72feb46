// meshes/shape_frame.c
#include "meshes/shape_frame.h"

#include "base/memory.h"
#include "meshes/outline.h"

#include <math.h>

bool shape_frame_varies(const shape_spec *shape)
{
    return field_varies(&shape->fibre_angle) || field_varies(&shape->plane_angle);
}

static bool is_unturned(const field *f)
{
    return !field_varies(f) && f->value == 0;
}

static bool is_round(const outline *o)
{
    return o->kind == KIND_ANNULUS || o->kind == KIND_SECTOR || o->kind == KIND_DISC;
}

status shape_frame_freeze(const shape_spec *shape, double s, outline *o)
{
    const bool tangent = shape->axes == SHAPE_AXES_TANGENT;
    const double fibre = field_at(&shape->fibre_angle, s);
    const double plane = field_at(&shape->plane_angle, s);
    if (!isfinite(fibre) || !isfinite(plane)) {
        return outline_fail(o, "its %s is not a finite number at s = %.6g mm",
                            isfinite(fibre) ? "plane_angle" : "fibre_angle", 1e3 * s);
    }
    o->has_frame =
        tangent || !is_unturned(&shape->fibre_angle) || !is_unturned(&shape->plane_angle);
    // the own x axis of a shape is turned from the section's as plane_angle turns
    const bool polar = tangent && is_round(o);
    o->frame = material_frame_make(plane + (tangent && !polar ? o->angle : 0), fibre);
    o->frame.polar = polar;
    o->frame.centre[0] = o->centre[0];
    o->frame.centre[1] = o->centre[1];
    return OK;
}

status shape_frames_to_mesh(const section_outline *o, const int *owner, mesh *m)
{
    status st = OK;
    int nframe = 0;
    int *frame = NULL; // [shapes]
    TRY(TAKE(frame, (size_t)o->count));
    for (int k = 0; k < o->count; k++) {
        frame[k] = o->items[k].has_frame && o->items[k].material >= 0 ? nframe++ : -1;
    }
    if (nframe == 0) {
        goto done;
    }
    TRY(mesh_take_frames(m, nframe));
    for (int k = 0; k < o->count; k++) {
        if (frame[k] >= 0) {
            m->frame[frame[k]] = o->items[k].frame;
        }
    }
    for (int b = 0; b < m->nblock; b++) {
        for (int e = 0; e < m->block[b].nelem; e++) {
            m->block[b].frame[e] = frame[*owner++];
        }
    }

done:
    free(frame);
    return st;
}
