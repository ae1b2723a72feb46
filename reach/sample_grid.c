// reach/sample_grid.c
#include "reach/sample_grid.h"

#include "base/memory.h"

#include <math.h>

enum { MOST_CELLS = 1 << 20 };

static int along(const sample_grid *g, int d, double x)
{
    const double i = floor((x - g->low.a[d]) / g->step);
    return i < 0 ? 0 : i < g->n[d] ? (int)i : g->n[d] - 1;
}

static int cell_of(const sample_grid *g, const double p[3])
{
    return (along(g, 2, p[2]) * g->n[1] + along(g, 1, p[1])) * g->n[0] + along(g, 0, p[0]);
}

static void choose_cells(int npoint, double size, sample_grid *g)
{
    vec3 high = {{-INFINITY, -INFINITY, -INFINITY}};
    double cells;
    g->low = (vec3){{INFINITY, INFINITY, INFINITY}};
    for (int i = 0; i < npoint; i++) {
        for (int d = 0; d < 3; d++) {
            g->low.a[d] = fmin(g->low.a[d], g->point[i][d]);
            high.a[d] = fmax(high.a[d], g->point[i][d]);
        }
    }
    g->step = size / 2;
    do {
        cells = 1;
        g->step *= 2;
        for (int d = 0; d < 3; d++) {
            cells *= floor((high.a[d] - g->low.a[d]) / g->step) + 1;
        }
    } while (cells > MOST_CELLS);
    for (int d = 0; d < 3; d++) {
        g->n[d] = (int)((high.a[d] - g->low.a[d]) / g->step) + 1;
    }
}

status sample_grid_make(int npoint, const double (*point)[3], double size, sample_grid *out)
{
    status st = OK;
    sample_grid g = {.point = point, .left = npoint};
    choose_cells(npoint, size, &g);
    const int ncell = g.n[0] * g.n[1] * g.n[2];
    TRY(TAKE(g.first, (size_t)ncell + 1));
    TRY(TAKE(g.open, (size_t)ncell));
    TRY(TAKE(g.order, (size_t)npoint));
    for (int i = 0; i < npoint; i++) {
        g.first[cell_of(&g, point[i]) + 1]++;
    }
    for (int c = 0; c < ncell; c++) {
        g.first[c + 1] += g.first[c];
    }
    for (int i = 0; i < npoint; i++) {
        const int c = cell_of(&g, point[i]);
        g.order[g.first[c] + g.open[c]++] = i;
    }
    *out = g;
    g = (sample_grid){0};

done:
    sample_grid_free(&g);
    return st;
}

void sample_grid_free(sample_grid *g)
{
    free(g->first);
    free(g->open);
    free(g->order);
    *g = (sample_grid){0};
}

static double square_to(const sample_grid *g, int point, vec3 p)
{
    double sum = 0;
    for (int d = 0; d < 3; d++) {
        sum += (g->point[point][d] - p.a[d]) * (g->point[point][d] - p.a[d]);
    }
    return sum;
}

// the first point that is not done and for which `visit` says that it is enough; NULL: any
typedef struct walk {
    sample_visit *visit;
    void *context;
} walk;

static bool look_in_cell(const sample_grid *g, int c, vec3 p, double radius)
{
    for (int k = 0; k < g->open[c]; k++) {
        if (square_to(g, g->order[g->first[c] + k], p) <= radius * radius) {
            return true;
        }
    }
    return false;
}

static void visit_cell(sample_grid *g, int c, vec3 p, double radius, const walk *w)
{
    for (int k = 0; k < g->open[c]; k++) {
        int *at = &g->order[g->first[c] + k];
        if (square_to(g, *at, p) <= radius * radius && w->visit(w->context, *at)) {
            // the last of those that are not done takes its place
            int *last = &g->order[g->first[c] + --g->open[c]];
            const int swap = *at;
            *at = *last;
            *last = swap;
            g->left--;
            k--;
        }
    }
}

// the cells that the ball may touch
static void range(const sample_grid *g, vec3 p, double radius, int low[3], int high[3])
{
    for (int d = 0; d < 3; d++) {
        low[d] = along(g, d, p.a[d] - radius);
        high[d] = along(g, d, p.a[d] + radius);
    }
}

bool sample_grid_any(const sample_grid *g, vec3 p, double radius)
{
    int low[3], high[3];
    range(g, p, radius, low, high);
    for (int z = low[2]; z <= high[2]; z++) {
        for (int y = low[1]; y <= high[1]; y++) {
            for (int x = low[0]; x <= high[0]; x++) {
                if (look_in_cell(g, (z * g->n[1] + y) * g->n[0] + x, p, radius)) {
                    return true;
                }
            }
        }
    }
    return false;
}

void sample_grid_near(sample_grid *g, vec3 p, double radius, sample_visit *visit, void *context)
{
    const walk w = {visit, context};
    int low[3], high[3];
    range(g, p, radius, low, high);
    for (int z = low[2]; z <= high[2]; z++) {
        for (int y = low[1]; y <= high[1]; y++) {
            for (int x = low[0]; x <= high[0]; x++) {
                visit_cell(g, (z * g->n[1] + y) * g->n[0] + x, p, radius, &w);
            }
        }
    }
}
