// fem/column.c
#include "fem/column.h"

#include "base/memory.h"
#include "fem/segment_material.h"

#include <math.h>
#include <string.h>

// levels further than this from the Gauss-Lobatto points of their layer belong to another kind of
// mesh
static const double LEVEL_TOLERANCE = 1e-9;

void column_free(column *c)
{
    free(c->level);
    for (int b = 0; b < MESH_MAX_BLOCKS; b++) {
        basis_table_free(&c->table[b]);
    }
    *c = (column){0};
}

// level k of a layer that begins and ends at the levels given
static double lobatto_level(const element *line, int k, double begin, double end)
{
    return begin + (end - begin) * (line->line_node[k] + 1) / 2;
}

static status check_levels(const column *c)
{
    for (int k = 0; k + 1 < c->nlevel; k++) {
        const int first = k / c->order * c->order;
        const double begin = c->level[first], end = c->level[first + c->order];
        const double wanted = lobatto_level(&c->line, k - first, begin, end);
        if (!(end > begin) || !(fabs(c->level[k] - wanted) <= LEVEL_TOLERANCE * (end - begin))) {
            return status_fail(ERR_BUG, "segment: level %d at %g m is not a layer's node", k,
                               c->level[k]);
        }
    }
    return OK;
}

double column_section_radius(const mesh *plane)
{
    double radius = 0;
    for (int i = 0; i < plane->nnode; i++) {
        radius = fmax(radius, hypot(plane->xyz[3 * (size_t)i], plane->xyz[3 * (size_t)i + 1]));
    }
    return radius;
}

status column_make(const mesh *plane, const material *materials, int order, int nlevel,
                   const double *level, column *out)
{
    status st = OK;
    column c = {.plane = plane, .materials = materials, .order = order, .nlevel = nlevel};

    if (plane->dim != 2 || nlevel <= c.order || (nlevel - 1) % c.order != 0) {
        TRY(status_fail(ERR_BUG, "segment: %d levels are no layers of order %d", nlevel, c.order));
    }
    TRY(segment_check_materials(plane, materials));
    c.nlayer = (nlevel - 1) / c.order;
    TRY(element_make(SHAPE_LINE, c.order, &c.line));
    TRY(TAKE(c.level, (size_t)nlevel));
    memcpy(c.level, level, (size_t)nlevel * sizeof *level);
    TRY(check_levels(&c));
    c.length = level[nlevel - 1] - level[0];
    c.radius = column_section_radius(plane);
    for (int b = 0; b < plane->nblock; b++) {
        element e = {0};
        TRY(element_make(plane->block[b].shape, plane->order, &e));
        // two degrees over the product of two basis functions, for curved elements
        TRY(basis_table_make(&e, 2 * plane->order + 2, &c.table[b]));
    }
    *out = c;
    c = (column){0};

done:
    column_free(&c);
    return st;
}

status column_lower(const column *c, int order, mesh *plane, column *out)
{
    status st = OK;
    element line = {0};
    double *level = NULL;
    const int nlevel = c->nlayer * order + 1;

    TRY(mesh_of_order(c->plane, order, plane));
    TRY(element_make(SHAPE_LINE, order, &line));
    TRY(TAKE(level, (size_t)nlevel));
    for (int i = 0; i < nlevel; i++) {
        const int layer = i < nlevel - 1 ? i / order : c->nlayer - 1;
        level[i] = lobatto_level(&line, i - layer * order, c->level[layer * c->order],
                                 c->level[(layer + 1) * c->order]);
    }
    TRY(column_make(plane, c->materials, order, nlevel, level, out));

done:
    free(level);
    return st;
}

line_matrices line_matrices_make(const column *c, int layer, double from, double to)
{
    line_matrices m = {0};
    const int p = c->order;
    const double begin = c->level[layer * p], half = (c->level[(layer + 1) * p] - begin) / 2;
    const double a = fmax(-1, (from - begin) / half - 1), b = fmin(1, (to - begin) / half - 1);
    if (!(b > a)) {
        return m;
    }
    double x[ELEMENT_MAX_ORDER + 1], w[ELEMENT_MAX_ORDER + 1];
    gauss_legendre(p + 1, x, w);
    for (int q = 0; q <= p; q++) {
        double N[ELEMENT_MAX_ORDER + 1], dN[ELEMENT_MAX_ORDER + 1];
        const double t = (a + b) / 2 + (b - a) / 2 * x[q], weight = (b - a) / 2 * w[q];
        element_basis(&c->line, &t, N, dN);
        for (int k = 0; k <= p; k++) {
            for (int l = 0; l <= p; l++) {
                m.M[k][l] += weight * half * N[k] * N[l];
                m.G[k][l] += weight * N[k] * dN[l];
                m.K[k][l] += weight / half * dN[k] * dN[l];
            }
        }
    }
    return m;
}
