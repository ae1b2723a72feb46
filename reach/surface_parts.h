// reach/surface_parts.h
// What the readers of surfaces share.
#pragma once

#include "measure/cloud_parts.h"
#include "reach/surface.h"

// Triangles on their way in.
typedef struct triangle_list {
    int n, room;
    double (*corner)[3][3]; // [n] [m]
    double unit;            // of the file [m]
} triangle_list;

// Room for `count` triangles in all. ERR_FILE where that is more than SURFACE_MOST_TRIANGLES.
status triangles_expect(triangle_list *l, const cloud_stream *s, uint64_t count);
// The corners in the file's unit. ERR_FILE for a place that is not finite or farther than 10 km.
status triangles_put(triangle_list *l, const cloud_stream *s, const double corner[3][3]);

// Vertices that faces name.
typedef struct vertex_list {
    int n, room;
    double (*p)[3]; // [n] in the file's unit
} vertex_list;

status vertices_put(vertex_list *v, const cloud_stream *s, const double p[3]);

enum { FACE_CORNERS = 256 };

// A polygon's triangles, all from its first corner. ERR_FILE where it has fewer than 3 corners or
// names a vertex that is not there (from 0).
status triangles_put_face(triangle_list *l, const vertex_list *v, const cloud_stream *s, int n,
                          const int64_t *face);

status surface_stl_text(cloud_stream *s, triangle_list *l);
status surface_stl_bytes(cloud_stream *s, triangle_list *l);
status surface_obj(cloud_stream *s, triangle_list *l);
status surface_ply(cloud_stream *s, triangle_list *l);
