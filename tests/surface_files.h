// tests/surface_files.h
// Made surfaces written as files of every format, in mm.
#pragma once

#include "tests/surfaces.h"

#include <stdint.h>
#include <stdio.h>

typedef enum surface_form {
    FORM_STL_TEXT,
    FORM_STL_BYTES, // beginning with "solid", as some programs write it
    FORM_OBJ,
    FORM_PLY_TEXT,
    FORM_PLY_LITTLE,
    FORM_PLY_BIG,
    FORMS,
} surface_form;

static inline void put_bytes(FILE *f, const void *value, size_t size, bool big)
{
    const unsigned char *bytes = value; // of this machine: little endian
    for (size_t i = 0; i < size; i++) {
        (void)fputc(bytes[big ? size - 1 - i : i], f);
    }
}

static inline void put_stl_text(FILE *f, const made_surface *m)
{
    fprintf(f, "solid made here\n");
    for (int i = 0; i < m->n; i++) {
        fprintf(f, " facet normal 0 0 0\n  outer loop\n");
        for (int k = 0; k < 3; k++) {
            const double *p = m->corner[i][k];
            fprintf(f, "   vertex %.9e %.9e %.9e\n", 1e3 * p[0], 1e3 * p[1], 1e3 * p[2]);
        }
        fprintf(f, "  endloop\n endfacet\n");
    }
    fprintf(f, "endsolid made here\n");
}

static inline void put_stl_bytes(FILE *f, const made_surface *m)
{
    char head[80] = "solid, yet binary";
    const uint32_t n = (uint32_t)m->n;
    (void)fwrite(head, 1, sizeof head, f);
    put_bytes(f, &n, 4, false);
    for (int i = 0; i < m->n; i++) {
        for (int k = 0; k < 12; k++) {
            const float x = k < 3 ? 0 : (float)(1e3 * m->corner[i][k / 3 - 1][k % 3]);
            put_bytes(f, &x, 4, false);
        }
        put_bytes(f, "\0\0", 2, false);
    }
}

// faces in three manners, by turns
static inline void put_obj(FILE *f, const made_surface *m)
{
    fprintf(f, "# made\nmtllib none.mtl\no wall\nvt 0 0\nvn 0 0 1\n");
    for (int i = 0; i < m->n; i++) {
        for (int k = 0; k < 3; k++) {
            const double *p = m->corner[i][k];
            fprintf(f, "v %.9g %.9g %.9g\n", 1e3 * p[0], 1e3 * p[1], 1e3 * p[2]);
        }
        const int a = 3 * i + 1;
        if (i % 3 == 0) {
            fprintf(f, "f %d %d %d\n", a, a + 1, a + 2);
        } else if (i % 3 == 1) {
            fprintf(f, "f -3/1/1 -2//1 -1/1\n");
        } else {
            fprintf(f, "f %d/1/1 %d/1/1 %d/1/1\r\n", a, a + 1, a + 2);
        }
    }
}

static inline void put_ply(FILE *f, const made_surface *m, surface_form form)
{
    static const char *const names[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    const bool big = form == FORM_PLY_BIG, text = form == FORM_PLY_TEXT;
    fprintf(
        f,
        "ply\nformat %s 1.0\ncomment made\nelement note 1\nproperty uchar n\nelement vertex %d\n"
        "property float x\nproperty float y\nproperty float z\nproperty uchar red\n"
        "element face %d\nproperty list uchar int vertex_indices\nend_header\n",
        names[form - FORM_PLY_TEXT], 3 * m->n, m->n);
    text ? (void)fprintf(f, "7\n") : put_bytes(f, "\7", 1, big);
    for (int i = 0; i < 3 * m->n; i++) {
        for (int d = 0; d < 3; d++) {
            const float x = (float)(1e3 * m->corner[i / 3][i % 3][d]);
            text ? (void)fprintf(f, "%.9g ", (double)x) : put_bytes(f, &x, 4, big);
        }
        text ? (void)fprintf(f, "255\n") : put_bytes(f, "\377", 1, big);
    }
    for (int i = 0; i < m->n; i++) {
        text ? (void)fprintf(f, "3 %d %d %d\n", 3 * i, 3 * i + 1, 3 * i + 2)
             : put_bytes(f, "\3", 1, big);
        for (int k = 0; k < 3 && !text; k++) {
            const int32_t v = 3 * i + k;
            put_bytes(f, &v, 4, big);
        }
    }
}

static inline void put_surface(FILE *f, const made_surface *m, surface_form form)
{
    switch (form) {
    case FORM_STL_TEXT:
        put_stl_text(f, m);
        break;
    case FORM_STL_BYTES:
        put_stl_bytes(f, m);
        break;
    case FORM_OBJ:
        put_obj(f, m);
        break;
    default:
        put_ply(f, m, form);
    }
}
