// reports/coarse_surface.c
#include "reports/coarse_surface.h"

#include "base/memory.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { FINEST = 2048 }; // cells along the longest side

typedef struct clusters {
    int nvertex, ntriangle;
    const double (*vertex)[3];
    const int (*triangle)[3];
    double low[3], size;
    size_t room;   // of the table, a power of two
    uint32_t *key; // [room] cell
    int *head;     // [room] its cluster; -1: free
    int *of;       // [nvertex] cluster of each; -1: no number
    int ncluster;
} clusters;

void coarse_surface_free(coarse_surface *c)
{
    free(c->vertex);
    free(c->triangle);
    *c = (coarse_surface){0};
}

static bool is_place(const double *p)
{
    return isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2]);
}

static void find_box(clusters *g)
{
    double high[3] = {-INFINITY, -INFINITY, -INFINITY};
    for (int d = 0; d < 3; d++) {
        g->low[d] = INFINITY;
    }
    for (int i = 0; i < g->nvertex; i++) {
        for (int d = 0; d < 3 && is_place(g->vertex[i]); d++) {
            g->low[d] = fmin(g->low[d], g->vertex[i][d]);
            high[d] = fmax(high[d], g->vertex[i][d]);
        }
    }
    for (int d = 0; d < 3; d++) {
        g->size = fmax(g->size, high[d] - g->low[d]);
    }
}

static int cluster_of(clusters *g, uint32_t cell)
{
    size_t at = (size_t)(cell * UINT32_C(2654435761)) & (g->room - 1);
    while (g->head[at] >= 0 && g->key[at] != cell) {
        at = (at + 1) & (g->room - 1);
    }
    if (g->head[at] < 0) {
        g->head[at] = g->ncluster++;
        g->key[at] = cell;
    }
    return g->head[at];
}

static uint32_t step_of(const clusters *g, double x, int d, int n)
{
    const double step = g->size > 0 ? (x - g->low[d]) / g->size * n : 0;
    return step < n ? (uint32_t)step : (uint32_t)n - 1;
}

static bool stays(const clusters *g, int t)
{
    const int *v = g->triangle[t];
    const int a = g->of[v[0]], b = g->of[v[1]], c = g->of[v[2]];
    return a >= 0 && b >= 0 && c >= 0 && a != b && b != c && c != a;
}

// n cells along the longest side; returns how many triangles stay
static int cluster(clusters *g, int n)
{
    int count = 0;
    g->ncluster = 0;
    memset(g->head, -1, g->room * sizeof *g->head);
    for (int i = 0; i < g->nvertex; i++) {
        uint32_t cell = 0;
        for (int d = 0; d < 3 && is_place(g->vertex[i]); d++) {
            cell = cell * (uint32_t)FINEST + step_of(g, g->vertex[i][d], d, n);
        }
        g->of[i] = is_place(g->vertex[i]) ? cluster_of(g, cell) : -1;
    }
    for (int t = 0; t < g->ntriangle; t++) {
        count += stays(g, t);
    }
    return count;
}

// every vertex its own
static int cluster_each(clusters *g)
{
    int count = 0;
    g->ncluster = g->nvertex;
    for (int i = 0; i < g->nvertex; i++) {
        g->of[i] = is_place(g->vertex[i]) ? i : -1;
    }
    for (int t = 0; t < g->ntriangle; t++) {
        count += stays(g, t);
    }
    return count;
}

static int cluster_enough(clusters *g, int most)
{
    int low = 1, high = FINEST, count = cluster_each(g);
    if (count <= most) {
        return count;
    }
    while (low < high) {
        const int middle = (low + high + 1) / 2;
        if (cluster(g, middle) <= most) {
            low = middle;
        } else {
            high = middle - 1;
        }
    }
    return cluster(g, low);
}

// vertices in the order in which triangles first name them
static status collect(const clusters *g, int count, coarse_surface *out)
{
    status st = OK;
    coarse_surface c = {0};
    int *number = NULL, *members = NULL;
    TRY(TAKE(c.vertex, (size_t)g->ncluster));
    TRY(TAKE(c.triangle, (size_t)count));
    TRY(TAKE(number, (size_t)g->ncluster));
    TRY(TAKE(members, (size_t)g->ncluster));
    memset(number, -1, (size_t)g->ncluster * sizeof *number);
    for (int t = 0; t < g->ntriangle; t++) {
        for (int k = 0; k < 3 && stays(g, t); k++) {
            int *at = &number[g->of[g->triangle[t][k]]];
            *at = *at < 0 ? c.nvertex++ : *at;
            c.triangle[c.ntriangle][k] = *at;
        }
        c.ntriangle += stays(g, t);
    }
    for (int i = 0; i < g->nvertex; i++) {
        const int at = g->of[i] >= 0 ? number[g->of[i]] : -1;
        for (int d = 0; d < 3 && at >= 0; d++) {
            c.vertex[at][d] += (g->vertex[i][d] - c.vertex[at][d]) / (members[at] + 1);
        }
        if (at >= 0) {
            members[at]++;
        }
    }
    *out = c;
    c = (coarse_surface){0};

done:
    coarse_surface_free(&c);
    free(number);
    free(members);
    return st;
}

status coarse_surface_make(int nvertex, const double (*vertex)[3], int ntriangle,
                           const int (*triangle)[3], int most, coarse_surface *out)
{
    status st = OK;
    clusters g = {nvertex, ntriangle, vertex, triangle, .room = 16};
    while (g.room < 2 * (size_t)nvertex) {
        g.room *= 2;
    }
    TRY(TAKE(g.key, g.room));
    TRY(TAKE(g.head, g.room));
    TRY(TAKE(g.of, (size_t)nvertex));
    find_box(&g);
    const int count = cluster_enough(&g, most);
    TRY(collect(&g, count, out));

done:
    free(g.key);
    free(g.head);
    free(g.of);
    return st;
}
