#include "meshes/morph_kinds.h"

#include "base/memory.h"
#include "meshes/outline.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

// a node this part of a cell away from its edge lies on it: rounding of the mesher's own arithmetic
static const double ON_EDGE = 1e-9;

void grid_morph_free(grid_morph *m)
{
    grid_free(&m->g);
    free(m->place);
    *m = (grid_morph){0};
}

// the inverse of grid_point
static void grid_coordinates(const grid *g, const double *xy, double *ab)
{
    if (g->polar) {
        const double x = xy[0] - g->centre[0], y = xy[1] - g->centre[1];
        const double angle = fmod(atan2(y, x) - g->angle, 2 * PI);
        ab[0] = hypot(x, y);
        ab[1] = angle < 0 ? angle + 2 * PI : angle;
        return;
    }
    const double c = cos(g->angle), s = sin(g->angle);
    ab[0] = c * xy[0] + s * xy[1];
    ab[1] = c * xy[1] - s * xy[0];
}

static void locate(int n, const double *at, double x, int *cell, double *part)
{
    int i = 0;
    while (i + 1 < n && x >= at[i + 1]) {
        i++;
    }
    const double t = (x - at[i]) / (at[i + 1] - at[i]);
    *cell = i;
    *part = fabs(t) < ON_EDGE ? 0 : fabs(t - 1) < ON_EDGE ? 1 : t;
}

status grid_morph_make(const section_outline *base, const mesh *plane, grid_morph *out, bool *found)
{
    status st = OK;
    grid_morph m = {0};
    TRY(grid_make(base, &m.g, found));
    if (!*found) {
        goto done;
    }
    TRY(TAKE(m.place, (size_t)plane->nnode));
    for (int i = 0; i < plane->nnode; i++) {
        double ab[2];
        grid_coordinates(&m.g, plane->xyz + 3 * (size_t)i, ab);
        for (int d = 0; d < 2; d++) {
            locate(m.g.n[d], m.g.at[d], ab[d], &m.place[i].cell[d], &m.place[i].part[d]);
        }
    }
    *out = m;
    m = (grid_morph){0};

done:
    grid_morph_free(&m);
    return st;
}

static bool same_cells(const grid *a, const grid *b)
{
    return a->polar == b->polar && a->n[0] == b->n[0] && a->n[1] == b->n[1] &&
           memcmp(a->owner, b->owner, (size_t)a->n[0] * (size_t)a->n[1] * sizeof *a->owner) == 0;
}

status outlines_share_grid(const section_outline *a, const section_outline *b, bool *share)
{
    status st = OK;
    grid p = {0}, q = {0};
    TRY(grid_make(a, &p, share));
    if (*share) {
        TRY(grid_make(b, &q, share));
    }
    *share = *share && same_cells(&p, &q);

done:
    grid_free(&p);
    grid_free(&q);
    return st;
}

status grid_morph_nodes(const grid_morph *m, int nnode, const section_outline *o, double *xyz,
                        bool *same)
{
    status st = OK;
    grid g = {0};
    TRY(grid_make(o, &g, same));
    *same = *same && same_cells(&m->g, &g);
    for (int i = 0; i < nnode && *same; i++) {
        const grid_place *p = &m->place[i];
        double ab[2];
        for (int d = 0; d < 2; d++) {
            const double *at = g.at[d] + p->cell[d];
            ab[d] = p->part[d] == 1 ? at[1] : at[0] + p->part[d] * (at[1] - at[0]);
        }
        grid_point(&g, ab[0], ab[1], xyz + 3 * (size_t)i);
        xyz[3 * (size_t)i + 2] = 0;
    }

done:
    grid_free(&g);
    return st;
}
