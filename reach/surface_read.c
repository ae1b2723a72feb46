// reach/surface_read.c
#include "reach/surface_read.h"

#include "reach/surface_parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

// a text of SURFACE_MOST_TRIANGLES has less
static const uint64_t MOST_BYTES = (uint64_t)2 << 30;
// no bench is larger [m]
static const double FARTHEST = 1e4;
enum { STL_HEAD = 84, STL_TRIANGLE = 50, LOOK = 512 };

static status grow(void **list, int *room, size_t size, int wanted)
{
    const int64_t twice = 2 * (int64_t)*room, more = wanted > twice ? wanted : twice;
    const int64_t most = 3 * (int64_t)SURFACE_MOST_TRIANGLES;
    const size_t next = (size_t)(more < most ? more : most);
    void *wider = realloc(*list, next * size);
    if (!wider) {
        return status_fail(ERR_RESOURCE, "out of memory for a surface of %zu places", next);
    }
    *list = wider;
    *room = (int)next;
    return OK;
}

status triangles_expect(triangle_list *l, const cloud_stream *s, uint64_t count)
{
    if (count > SURFACE_MOST_TRIANGLES) {
        return stream_fail(s, "more than %d triangles", SURFACE_MOST_TRIANGLES);
    }
    return (int)count > l->room ? grow((void **)&l->corner, &l->room, sizeof *l->corner, (int)count)
                                : OK;
}

status triangles_put(triangle_list *l, const cloud_stream *s, const double corner[3][3])
{
    status st = OK;
    TRY(triangles_expect(l, s, (uint64_t)l->n + 1));
    for (int i = 0; i < 9; i++) {
        const double x = corner[i / 3][i % 3] * l->unit;
        if (!(fabs(x) <= FARTHEST)) {
            TRY(stream_fail(s, "a corner of triangle %d has no finite place within 10 km",
                            l->n + 1));
        }
        l->corner[l->n][i / 3][i % 3] = x;
    }
    l->n++;

done:
    return st;
}

status vertices_put(vertex_list *v, const cloud_stream *s, const double p[3])
{
    status st = OK;
    if (v->n == 3 * SURFACE_MOST_TRIANGLES) {
        TRY(stream_fail(s, "more than %d vertices", 3 * SURFACE_MOST_TRIANGLES));
    }
    if (v->n == v->room) {
        TRY(grow((void **)&v->p, &v->room, sizeof *v->p, v->n + 1024));
    }
    memcpy(v->p[v->n++], p, sizeof *v->p);

done:
    return st;
}

status triangles_put_face(triangle_list *l, const vertex_list *v, const cloud_stream *s, int n,
                          const int64_t *face)
{
    status st = OK;
    if (n < 3) {
        TRY(stream_fail(s, "a face with %d corners", n));
    }
    for (int i = 0; i < n; i++) {
        if (face[i] < 0 || face[i] >= v->n) {
            TRY(stream_fail(s, "a face names a vertex that is not among the %d in front of it",
                            v->n));
        }
    }
    for (int i = 2; i < n; i++) {
        double corner[3][3];
        memcpy(corner[0], v->p[face[0]], sizeof corner[0]);
        memcpy(corner[1], v->p[face[i - 1]], sizeof corner[1]);
        memcpy(corner[2], v->p[face[i]], sizeof corner[2]);
        TRY(triangles_put(l, s, (const double(*)[3])corner));
    }

done:
    return st;
}

static bool is_text(const unsigned char *bytes, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        if (bytes[i] == 127 || (bytes[i] < 32 && !strchr("\t\r\n\f", bytes[i])) || bytes[i] == 0) {
            return false;
        }
    }
    return true;
}

// many a binary STL begins with "solid" as those of text do: its size tells
static bool is_stl_of_bytes(const cloud_stream *s, const unsigned char *bytes, size_t count)
{
    return count >= STL_HEAD &&
           s->size == STL_HEAD + STL_TRIANGLE *
                                     (uint64_t)scalar_read(bytes + STL_HEAD - 4, SCALAR_U32, false);
}

static status read_triangles(cloud_stream *s, triangle_list *l)
{
    status st = OK;
    const unsigned char *bytes = NULL;
    size_t count = 0;
    if (s->size > MOST_BYTES) {
        TRY(stream_fail(s, "it has %llu bytes; at most %llu are read", (unsigned long long)s->size,
                        (unsigned long long)MOST_BYTES));
    }
    TRY(stream_peek(s, LOOK, &bytes, &count));
    const char *text = (const char *)bytes;
    if (count >= 4 && (memcmp(text, "ply\n", 4) == 0 || memcmp(text, "ply\r", 4) == 0)) {
        TRY(surface_ply(s, l));
    } else if (is_stl_of_bytes(s, bytes, count) || !is_text(bytes, count)) {
        TRY(surface_stl_bytes(s, l));
    } else if (strncasecmp(text + strspn(text, " \t\r\n"), "solid", 5) == 0) {
        TRY(surface_stl_text(s, l));
    } else {
        TRY(surface_obj(s, l));
    }

done:
    return st;
}

status surface_read(const surface_options *options, double unit, surface *out,
                    surface_report *report)
{
    status st = OK;
    cloud_stream s = {.fd = -1};
    triangle_list l = {.unit = unit};
    TRY(stream_open(options->path, &s));
    TRY(read_triangles(&s, &l));
    stream_close(&s);
    TRY(surface_make(l.n, (const double(*)[3][3])l.corner, options, out, report));

done:
    stream_close(&s);
    free(l.corner);
    return st;
}
