// reach/surface_stl.c
// STL: loose triangles. The normals that files have are not looked at: the corners' sense is made
// alike anyway.
#include "reach/surface_parts.h"

#include <string.h>
#include <strings.h>

enum { HEAD = 80, TRIANGLE = 50, WORD = 64 };

status surface_stl_bytes(cloud_stream *s, triangle_list *l)
{
    status st = OK;
    const unsigned char *bytes = NULL;
    stream_in_bytes(s);
    if (s->size < HEAD + 4) {
        TRY(stream_fail(s, "it is no STL, OBJ or PLY"));
    }
    TRY(stream_bytes(s, HEAD + 4, &bytes));
    const uint64_t count = (uint64_t)scalar_read(bytes + HEAD, SCALAR_U32, false);
    if (s->size != HEAD + 4 + TRIANGLE * count) {
        TRY(stream_fail(s, "a binary STL of %llu triangles has %llu bytes, but this file %llu",
                        (unsigned long long)count,
                        (unsigned long long)(HEAD + 4 + TRIANGLE * count),
                        (unsigned long long)s->size));
    }
    TRY(triangles_expect(l, s, count));
    for (uint64_t i = 0; i < count; i++) {
        double corner[3][3];
        TRY(stream_bytes(s, TRIANGLE, &bytes));
        for (int k = 0; k < 9; k++) {
            corner[k / 3][k % 3] = scalar_read(bytes + 12 + 4 * k, SCALAR_F32, false);
        }
        TRY(triangles_put(l, s, (const double(*)[3])corner));
    }

done:
    return st;
}

static status read_numbers(const cloud_stream *s, const char *c, double p[3])
{
    for (int d = 0; d < 3; d++) {
        c += strspn(c, " \t");
        if (!cloud_number(&c, false, &p[d]) || (*c && *c != ' ' && *c != '\t')) {
            return stream_fail(s, "a vertex needs three numbers");
        }
    }
    return c[strspn(c, " \t")] == 0 ? OK : stream_fail(s, "a vertex has more than three numbers");
}

static bool is_any(const char *word, const char *const *words)
{
    for (int i = 0; words[i]; i++) {
        if (strcasecmp(word, words[i]) == 0) {
            return true;
        }
    }
    return false;
}

typedef struct facet {
    int n; // corners so far
    double corner[3][3];
    bool in_facet, in_solid;
} facet;

static status read_line(const cloud_stream *s, const char *line, triangle_list *l, facet *f)
{
    static const char *const others[] = {"outer", "endloop", NULL};
    status st = OK;
    char word[WORD];
    if (!cloud_word(&line, word, sizeof word)) {
        return OK;
    }
    if (strcasecmp(word, "vertex") == 0) {
        TRY(f->in_facet && f->n < 3 ? OK : stream_fail(s, "a vertex where none is due"));
        TRY(read_numbers(s, line, f->corner[f->n++]));
    } else if (strcasecmp(word, "facet") == 0) {
        TRY(f->in_solid && !f->in_facet ? OK : stream_fail(s, "a facet within another"));
        f->in_facet = true;
        f->n = 0;
    } else if (strcasecmp(word, "endfacet") == 0) {
        TRY(f->in_facet && f->n == 3 ? OK : stream_fail(s, "a facet with %d corners", f->n));
        f->in_facet = false;
        TRY(triangles_put(l, s, (const double(*)[3])f->corner));
    } else if (strcasecmp(word, "solid") == 0 || strcasecmp(word, "endsolid") == 0) {
        const bool begins = strcasecmp(word, "solid") == 0;
        TRY(f->in_solid != begins && !f->in_facet ? OK
                                                  : stream_fail(s, "'%s' where none is due", word));
        f->in_solid = begins;
    } else if (!is_any(word, others)) {
        TRY(stream_fail(s, "'%.40s' is no word of an STL file", word));
    }

done:
    return st;
}

status surface_stl_text(cloud_stream *s, triangle_list *l)
{
    status st = OK;
    char *line = NULL;
    facet f = {0};
    for (;;) {
        TRY(stream_line(s, &line));
        if (!line) {
            break;
        }
        TRY(read_line(s, line, l, &f));
    }
    if (f.in_solid) {
        TRY(stream_fail(s, "the file ends before 'endsolid'"));
    }

done:
    return st;
}
