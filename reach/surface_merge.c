// reach/surface_merge.c
// Corners at one place become one vertex: they are looked for in the cells of a grid, wider than
// what counts as one place, so that a corner's neighbours lie mostly in one cell.
#include "reach/surface_inside.h"

#include "base/input_file.h"
#include "base/memory.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

// of the box's diagonal: what single precision in a file leaves of equal places
static const double ONE_PLACE = 1e-7;
// no bench is larger [m]; squares of what lies within stay far from overflow
static const double FARTHEST = 1e4;
enum { WIDTH = 8 }; // of a cell, in what counts as one place

typedef struct grid {
    surface *s;
    double near;
    size_t mask;
    int *head; // [mask + 1] the first vertex of those in cells of this hash, -1
    int *next; // [vertices] the next one
} grid;

static size_t cell_hash(const grid *g, const int64_t cell[3])
{
    uint64_t h = 0;
    for (int d = 0; d < 3; d++) {
        h = (h ^ (uint64_t)cell[d]) * 0x9e3779b97f4a7c15u;
        h ^= h >> 32;
    }
    return (size_t)h & g->mask;
}

static void cell_of(const grid *g, const double p[3], int64_t cell[3])
{
    for (int d = 0; d < 3; d++) {
        cell[d] = (int64_t)floor((p[d] - g->s->low[d]) / (WIDTH * g->near));
    }
}

static int find_in_cell(const grid *g, const int64_t cell[3], const double p[3])
{
    for (int i = g->head[cell_hash(g, cell)]; i >= 0; i = g->next[i]) {
        const double *q = g->s->vertex[i];
        const double d[3] = {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
        if (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] <= g->near * g->near) {
            return i;
        }
    }
    return -1;
}

// the vertex within g->near of p, -1 where there is none
static int find_vertex(const grid *g, const double p[3])
{
    int64_t first[3], last[3], c[3];
    const double low[3] = {p[0] - g->near, p[1] - g->near, p[2] - g->near};
    const double high[3] = {p[0] + g->near, p[1] + g->near, p[2] + g->near};
    int found = -1;
    cell_of(g, low, first);
    cell_of(g, high, last);
    for (c[0] = first[0]; c[0] <= last[0]; c[0]++) {
        for (c[1] = first[1]; c[1] <= last[1]; c[1]++) {
            for (c[2] = first[2]; c[2] <= last[2] && found < 0; c[2]++) {
                found = find_in_cell(g, c, p);
            }
        }
    }
    return found;
}

static int take_vertex(grid *g, const double p[3])
{
    int64_t cell[3];
    const int i = g->s->nvertex++;
    memcpy(g->s->vertex[i], p, sizeof g->s->vertex[i]);
    cell_of(g, p, cell);
    int *head = &g->head[cell_hash(g, cell)];
    g->next[i] = *head;
    *head = i;
    return i;
}

static status find_box(surface_work *w, int n, const double (*corner)[3][3])
{
    const input_file file = {.path = (char *)w->options->path};
    surface *s = &w->s;
    double square = 0;
    for (int d = 0; d < 3; d++) {
        s->low[d] = INFINITY;
        s->high[d] = -INFINITY;
        for (int i = 0; i < 3 * n; i++) {
            const double x = corner[i / 3][i % 3][d];
            if (!(fabs(x) <= FARTHEST)) {
                return input_file_fail(&file, 0, "triangle %d has no finite place within 10 km",
                                       i / 3 + 1);
            }
            s->low[d] = fmin(s->low[d], x);
            s->high[d] = fmax(s->high[d], x);
        }
        square += (s->high[d] - s->low[d]) * (s->high[d] - s->low[d]);
    }
    w->diagonal = sqrt(square);
    return w->diagonal > 0 ? OK : input_file_fail(&file, 0, "all its triangles are at one place");
}

static status grid_make(surface_work *w, int n, grid *g)
{
    status st = OK;
    size_t size = 1024;
    while (size < 2 * (size_t)n) {
        size *= 2;
    }
    *g = (grid){.s = &w->s, .near = w->report->merge, .mask = size - 1};
    TRY(TAKE(g->head, size));
    TRY(TAKE(g->next, 3 * (size_t)n));
    memset(g->head, -1, size * sizeof *g->head);

done:
    return st;
}

status surface_merge(surface_work *w, int n, const double (*corner)[3][3])
{
    status st = OK;
    const input_file file = {.path = (char *)w->options->path};
    grid g = {0};
    surface *s = &w->s;
    if (n < 4 || n > SURFACE_MOST_TRIANGLES) {
        TRY(input_file_fail(&file, 0, "%d triangles: a closed surface has from 4 to %d", n,
                            SURFACE_MOST_TRIANGLES));
    }
    TRY(find_box(w, n, corner));
    w->report->merge = fmax(ONE_PLACE * w->diagonal, w->options->merge);
    TRY(grid_make(w, n, &g));
    TRY(TAKE(s->vertex, 3 * (size_t)n));
    TRY(TAKE(s->triangle, (size_t)n));
    for (int i = 0; i < n; i++) {
        int *c = s->triangle[s->ntriangle];
        for (int k = 0; k < 3; k++) {
            const int found = find_vertex(&g, corner[i][k]);
            c[k] = found >= 0 ? found : take_vertex(&g, corner[i][k]);
        }
        s->ntriangle += c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
    }
    w->report->merged = 3 * n - s->nvertex;
    w->report->degenerate = n - s->ntriangle;
    if (s->ntriangle < 4) {
        TRY(input_file_fail(&file, 0, "%d of its %d triangles have three corners: none is closed",
                            s->ntriangle, n));
    }

done:
    free(g.head);
    free(g.next);
    return st;
}
