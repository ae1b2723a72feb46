// tests/dxf.h
// Drawings as tests write them, line by line, and the section that is read from them.
#pragma once

#include "meshes/drawing.h"
#include "tests/shapes.h"

#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

typedef struct dxf_paper {
    char text[1 << 16];
    size_t count;
} dxf_paper;

// "0 LINE 8 soft 10 1.5 ...": words in pairs, each on its own line
static inline void dxf_put(dxf_paper *p, const char *format, ...)
{
    char words[4096];
    va_list args;
    va_start(args, format);
    (void)vsnprintf(words, sizeof words, format, args);
    va_end(args);
    for (char *c = words; *c; c++) {
        *c = *c == ' ' ? '\n' : *c;
    }
    p->count += (size_t)snprintf(p->text + p->count, sizeof p->text - p->count, "%s\n", words);
}

static inline void dxf_begin(dxf_paper *p)
{
    p->count = 0;
    dxf_put(p, "999 a_test 0 SECTION 2 HEADER 9 $ACADVER 1 AC1015 9 $INSUNITS 70 4 0 ENDSEC");
    dxf_put(p, "0 SECTION 2 TABLES 0 TABLE 2 LAYER 70 1 0 LAYER 2 soft 0 ENDTAB 0 ENDSEC");
    dxf_put(p, "0 SECTION 2 ENTITIES");
}

static inline void dxf_end(dxf_paper *p)
{
    dxf_put(p, "0 ENDSEC 0 EOF");
}

// the constant-NC section: a tube of circles, and on it a sector of arcs and lines whose ends are
// written with so many digits
static inline void dxf_tube(dxf_paper *p, int digits)
{
    const double a = PI - PI / 16, b = PI + PI / 16, deg = 180 / PI;
    dxf_begin(p);
    dxf_put(p, "0 CIRCLE 5 1F 8 soft 10 0 20 0 30 0 40 4");
    dxf_put(p, "0 CIRCLE 8 soft 10 0 20 0 40 3.2");
    dxf_put(p, "0 ARC 8 stiff 10 0 20 0 40 4 50 %.*f 51 %.*f", digits, a * deg, digits, b * deg);
    dxf_put(p, "0 LINE 8 stiff 10 %.*f 20 %.*f 11 %.*f 21 %.*f", digits, 4 * cos(b), digits,
            4 * sin(b), digits, 3.2 * cos(b), digits, 3.2 * sin(b));
    dxf_put(p, "0 ARC 8 stiff 10 0 20 0 40 3.2 50 %.*f 51 %.*f", digits, a * deg, digits, b * deg);
    dxf_put(p, "0 LINE 8 stiff 10 %.*f 20 %.*f 11 %.*f 21 %.*f", digits, 4 * cos(a), digits,
            4 * sin(a), digits, 3.2 * cos(a), digits, 3.2 * sin(a));
    dxf_put(p, "0 TEXT 8 notes 10 0 20 0 40 1 1 words");
    dxf_end(p);
}

// a spline of degree p through nothing but its control points, knots at 0 and 1 only
static inline void dxf_bezier(dxf_paper *p, const char *layer, int degree, const double *xy)
{
    dxf_put(p, "0 SPLINE 8 %s 70 8 71 %d 72 %d 73 %d", layer, degree, 2 * degree + 2, degree + 1);
    for (int i = 0; i < 2 * degree + 2; i++) {
        dxf_put(p, "40 %d", i > degree);
    }
    for (int i = 0; i <= degree; i++) {
        dxf_put(p, "10 %.17g 20 %.17g 30 0", xy[2 * i], xy[2 * i + 1]);
    }
}

// one of each kind: a slot of a polyline with bulges, an old polyline, an elliptic hole, a spline
// lens, and a plate of lines
static inline void dxf_all_kinds(dxf_paper *p)
{
    dxf_begin(p);
    dxf_put(p, "0 LINE 8 soft 10 -10 20 -6 11 10 21 -6 0 LINE 8 soft 10 10 20 6 11 10 21 -6");
    dxf_put(p, "0 LINE 8 soft 10 10 20 6 11 -10 21 6 0 LINE 8 soft 10 -10 20 6 11 -10 21 -6");
    dxf_put(p, "0 LWPOLYLINE 8 none 90 4 70 1 10 -8 20 -1 42 0 10 -5 20 -1 42 1 10 -5 20 1 42 0 "
               "10 -8 20 1 42 1");
    dxf_put(p, "0 POLYLINE 8 stiff 66 1 70 1 0 VERTEX 8 stiff 10 2 20 2 42 0 0 VERTEX 8 stiff 10 6 "
               "20 2 42 0.41421356237309503 0 VERTEX 8 stiff 10 8 20 4 0 VERTEX 8 stiff 10 2 20 4 "
               "0 SEQEND 8 stiff");
    dxf_put(p, "0 ELLIPSE 8 none 10 6 20 -3 11 1.2 21 0.9 40 0.4 41 0 42 6.283185307179586");
    const double up[] = {-2, -2, -1, -4, 1, -4, 2, -2}, down[] = {-2, -2, 0, 0, 2, -2};
    dxf_bezier(p, "stiff", 3, up);
    dxf_bezier(p, "stiff", 2, down);
    dxf_end(p);
}

static const material dxf_materials[] = {{.name = "soft", .E = 0.66e6, .nu = 0.3},
                                         {.name = "stiff", .E = 15.93e6, .nu = 0.3}};

// unit: as in the case, 0 for the file's own
static inline status dxf_open_file(const char *folder, const char *name, const key_list *parts,
                                   int unit, drawing **out)
{
    const drawing_request request = {
        .directory = folder, .nmaterial = 2, .materials = dxf_materials};
    drawing_files files = {.dxf = {.at = {3, 5}, .file = {.text = name, .at = {4, 9}}}};
    files.dxf.unit = unit;
    if (parts) {
        files.dxf.parts = *parts;
    }
    return drawing_open(&files, &request, out);
}

// Through a file in a folder of its own.
static inline status dxf_open_text(const char *text, size_t count, const key_list *parts, int unit,
                                   drawing **out)
{
    char folder[] = "/tmp/stiffaxis-dxf-XXXXXX", path[64];
    *out = NULL;
    if (!mkdtemp(folder)) {
        return ERR_RESOURCE;
    }
    (void)snprintf(path, sizeof path, "%s/drawing.dxf", folder);
    FILE *f = fopen(path, "wb");
    const bool written = f && fwrite(text, 1, count, f) == count;
    const bool closed = f && fclose(f) == 0;
    const status st =
        written && closed ? dxf_open_file(folder, "drawing.dxf", parts, unit, out) : ERR_RESOURCE;
    (void)remove(path);
    (void)rmdir(folder);
    return st;
}
