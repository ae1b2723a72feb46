// reach/surface.c
#include "reach/surface_inside.h"

#include "base/input_file.h"
#include "reach/triangle.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

void surface_free(surface *s)
{
    free(s->vertex);
    free(s->triangle);
    free(s->across);
    *s = (surface){0};
}

status surface_fail(const surface_work *w, const double place[3], const char *format, ...)
{
    char words[400];
    const input_file file = {.path = (char *)w->options->path};
    va_list args;
    va_start(args, format);
    (void)vsnprintf(words, sizeof words, format, args);
    va_end(args);
    return input_file_fail(&file, 0, "%s, one at (%.6g, %.6g, %.6g) mm", words, 1e3 * place[0],
                           1e3 * place[1], 1e3 * place[2]);
}

void surface_turn(surface *s, int t)
{
    int *c = s->triangle[t], *a = s->across[t];
    // (c0 c1 c2) -> (c0 c2 c1): edges 0 and 2 change places
    const int corner = c[1], edge = a[0];
    c[1] = c[2];
    c[2] = corner;
    a[0] = a[2];
    a[2] = edge;
    for (int k = 0; k < 3; k++) {
        s->across[a[k] / 3][a[k] % 3] = 3 * t + k;
    }
}

static void measure(surface *s)
{
    const vec3 o = {{0.5 * (s->low[0] + s->high[0]), 0.5 * (s->low[1] + s->high[1]),
                     0.5 * (s->low[2] + s->high[2])}};
    s->area = s->volume = 0;
    for (int t = 0; t < s->ntriangle; t++) {
        vec3 corner[3];
        surface_corners(s, t, corner);
        const vec3 n = triangle_normal(corner);
        s->area += 0.5 * vec3_norm(n);
        s->volume += vec3_dot(vec3_sub(corner[0], o), n) / 6;
    }
}

status surface_make(int ntriangle, const double (*corner)[3][3], const surface_options *options,
                    surface *out, surface_report *report)
{
    status st = OK;
    surface_work w = {.options = options, .report = report};
    *report = (surface_report){0};
    TRY(surface_merge(&w, ntriangle, corner));
    TRY(surface_pair_edges(&w));
    TRY(surface_orient(&w));
    TRY(surface_flip_flat(&w));
    TRY(surface_check_crossings(&w));
    TRY(surface_nest(&w));
    measure(&w.s);
    *out = w.s;
    w.s = (surface){0};

done:
    surface_free(&w.s);
    free(w.part);
    return st;
}

double surface_diagonal(const surface *s)
{
    double square = 0;
    for (int d = 0; d < 3; d++) {
        square += (s->high[d] - s->low[d]) * (s->high[d] - s->low[d]);
    }
    return sqrt(square);
}

status surface_check_size(const surface *s, const char *path, double length)
{
    const double size = surface_diagonal(s);
    if (size <= SURFACE_SIZES * length && length <= SURFACE_SIZES * size) {
        return OK;
    }
    return status_fail(ERR_INPUT,
                       "%s: the box around it has a diagonal of %.3g mm, but the scope is %.3g mm "
                       "long: is the file's unit another one?",
                       path, 1e3 * size, 1e3 * length);
}
