// reach/surface_obj.c
// OBJ: vertices and the polygons between them; all else that such files have is passed over.
#include "reach/surface_parts.h"

#include <stdlib.h>
#include <string.h>

enum { WORD = 64 };

static const char *const passed_over[] = {
    "vt",     "vn",       "vp",       "g",          "o",         "s",     "usemtl",
    "mtllib", "l",        "p",        "mg",         "lod",       "bevel", "usemap",
    "maplib", "d_interp", "c_interp", "shadow_obj", "trace_obj", NULL};

static status read_vertex(const cloud_stream *s, const char *c, vertex_list *v)
{
    double p[3];
    for (int d = 0; d < 3; d++) {
        c += strspn(c, " \t");
        if (!cloud_number(&c, false, &p[d]) || (*c && *c != ' ' && *c != '\t')) {
            return stream_fail(s, "a vertex needs three numbers");
        }
    }
    return vertices_put(v, s, p);
}

// "7", "7/1", "7/1/3", "7//3"; negative: from the last vertex back. From 0; -1: none
static int64_t index_of(const char *word, int nvertex)
{
    const bool back = *word == '-';
    const char *c = word + back;
    int64_t i = 0;
    if (*c < '0' || *c > '9') {
        return -1;
    }
    for (; *c >= '0' && *c <= '9'; c++) {
        i = i < INT32_MAX ? 10 * i + (*c - '0') : i;
    }
    if (c[strspn(c, "-/0123456789")] != 0 || (*c && *c != '/') || i == 0) {
        return -1;
    }
    return back ? nvertex - i : i - 1;
}

static status read_face(const cloud_stream *s, const char *rest, const vertex_list *v,
                        triangle_list *l)
{
    status st = OK;
    char word[WORD];
    int64_t face[FACE_CORNERS];
    int n = 0;
    while (cloud_word(&rest, word, sizeof word)) {
        if (n == FACE_CORNERS) {
            TRY(stream_fail(s, "a face with more than %d corners", FACE_CORNERS));
        }
        face[n] = index_of(word, v->n);
        if (face[n] < 0 || face[n] >= v->n) {
            TRY(stream_fail(s, "'%.20s' is no vertex: %d are in front of it", word, v->n));
        }
        n++;
    }
    TRY(triangles_put_face(l, v, s, n, face));

done:
    return st;
}

static bool is_passed_over(const char *word)
{
    for (int i = 0; passed_over[i]; i++) {
        if (strcmp(word, passed_over[i]) == 0) {
            return true;
        }
    }
    return word[0] == '#';
}

status surface_obj(cloud_stream *s, triangle_list *l)
{
    status st = OK;
    vertex_list v = {0};
    char *line = NULL, word[WORD];
    for (;;) {
        TRY(stream_line(s, &line));
        if (!line) {
            break;
        }
        const char *rest = line;
        if (!cloud_word(&rest, word, sizeof word) || is_passed_over(word)) {
            continue;
        }
        if (strcmp(word, "v") == 0) {
            TRY(read_vertex(s, rest, &v));
        } else if (strcmp(word, "f") == 0) {
            TRY(read_face(s, rest, &v, l));
        } else {
            TRY(stream_fail(s, "'%.40s' is no word of an OBJ file, nor is it an STL or PLY", word));
        }
    }

done:
    free(v.p);
    return st;
}
