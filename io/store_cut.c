// io/store_cut.c
#include "io/store_cut.h"

#include <string.h>

enum { VTK_LINE = 3, VTK_TRIANGLE = 5, VTK_QUAD = 9, VTK_HEXAHEDRON = 12, VTK_WEDGE = 13 };

static void add_cell(cut *c, const int *corner)
{
    memcpy(c->corner[c->ncell], corner, (size_t)c->ncorner * sizeof *corner);
    c->ncell++;
}

// quad i + (p+1) j
static void cut_quad(int p, cut *c)
{
    c->ncorner = 4;
    for (int j = 0; j < p; j++) {
        for (int i = 0; i < p; i++) {
            const int a = i + (p + 1) * j;
            add_cell(c, (const int[]){a, a + 1, a + p + 2, a + p + 1});
        }
    }
}

static void cut_line(int p, cut *c)
{
    c->ncorner = 2;
    for (int i = 0; i < p; i++) {
        add_cell(c, (const int[]){i, i + 1});
    }
}

// row j of a triangle holds p + 1 - j nodes: p^2 cells, upright and upside down
static void cut_triangle(int p, cut *c)
{
    c->ncorner = 3;
    for (int j = 0, row = 0; j < p; row += p + 1 - j, j++) {
        const int above = row + p + 1 - j;
        for (int i = 0; i < p - j; i++) {
            add_cell(c, (const int[]){row + i, row + i + 1, above + i});
            if (i + 1 < p - j) {
                add_cell(c, (const int[]){row + i + 1, above + i + 1, above + i});
            }
        }
    }
}

// The plane cells of each of p layers. A wedge's first triangle looks outward, so both are turned
// round; a hexahedron's first face looks inward.
static void cut_layers(const cut *plane, int nplane, int p, cut *c)
{
    const int n = plane->ncorner;
    c->ncorner = 2 * n;
    for (int k = 0; k < p; k++) {
        for (int e = 0; e < plane->ncell; e++) {
            int corner[CUT_MAX_CORNERS];
            for (int i = 0; i < n; i++) {
                const int from = n == 3 ? (3 - i) % 3 : i;
                corner[i] = plane->corner[e][from] + nplane * k;
                corner[n + i] = corner[i] + nplane;
            }
            add_cell(c, corner);
        }
    }
}

status cut_element(shape shape, int order, int layers, cut *out)
{
    cut plane = {.type = shape == SHAPE_TRIANGLE ? VTK_TRIANGLE : VTK_QUAD};
    if (shape == SHAPE_LINE && layers == 0) {
        *out = (cut){.type = VTK_LINE};
        cut_line(order, out);
        return OK;
    }
    if (shape != SHAPE_TRIANGLE && shape != SHAPE_QUAD) {
        return status_fail(ERR_BUG, "a grid cannot hold %s elements", shape_name(shape));
    }
    if (shape == SHAPE_TRIANGLE) {
        cut_triangle(order, &plane);
    } else {
        cut_quad(order, &plane);
    }
    *out = plane;
    if (layers > 0) {
        *out = (cut){.type = shape == SHAPE_TRIANGLE ? VTK_WEDGE : VTK_HEXAHEDRON};
        cut_layers(&plane, element_node_count(shape, order), layers, out);
    }
    return OK;
}
