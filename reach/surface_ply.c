// reach/surface_ply.c
#include "measure/ply.h"
#include "reach/surface_parts.h"

#include "base/memory.h"

typedef struct reading {
    cloud_stream *s;
    const ply_element *e;
    triangle_list *l;
    vertex_list v;
    double xyz[3];
    int64_t face[FACE_CORNERS];
    int corners;
} reading;

static status take(void *context, int property, uint64_t k, uint64_t count, double value)
{
    reading *r = context;
    for (int d = 0; d < 3; d++) {
        if (r->e->axis[d] == property) {
            r->xyz[d] = value;
        }
    }
    if (property == r->e->corners) {
        if (count > FACE_CORNERS) {
            return stream_fail(r->s, "a face with more than %d corners", FACE_CORNERS);
        }
        r->corners = (int)count;
        r->face[k] = value >= 0 && value < r->v.n ? (int64_t)value : -1;
    }
    return OK;
}

static status read_element(reading *r, const ply *p)
{
    status st = OK;
    const ply_element *e = r->e;
    const bool vertices = e->axis[0] >= 0 && e->axis[1] >= 0 && e->axis[2] >= 0;
    // a row takes a byte at least: counts that no file bears out end here
    if (e->count > 0 && (e->nproperty == 0 || e->count > stream_left(r->s))) {
        TRY(stream_fail(r->s, "%llu elements '%s' are more than the file holds",
                        (unsigned long long)e->count, e->name));
    }
    for (uint64_t i = 0; i < e->count; i++) {
        r->corners = 0;
        TRY(ply_row(r->s, p, e, take, r));
        if (vertices) {
            TRY(vertices_put(&r->v, r->s, r->xyz));
        } else if (e->corners >= 0) {
            TRY(triangles_put_face(r->l, &r->v, r->s, r->corners, r->face));
        }
    }

done:
    return st;
}

status surface_ply(cloud_stream *s, triangle_list *l)
{
    status st = OK;
    ply *p = NULL;
    reading *r = NULL;
    bool faces = false;
    TRY(TAKE(p, 1));
    TRY(TAKE(r, 1));
    *r = (reading){.s = s, .l = l};
    TRY(ply_read_header(s, p));
    for (int i = 0; i < p->nelement; i++) {
        faces = faces || p->element[i].corners >= 0;
    }
    if (!faces) {
        TRY(stream_fail(s, "it has no faces (a list vertex_indices): it is points, no surface"));
    }
    for (int i = 0; i < p->nelement; i++) {
        r->e = &p->element[i];
        TRY(read_element(r, p));
    }

done:
    if (r) {
        free(r->v.p);
    }
    free(r);
    free(p);
    return st;
}
