// meshes/mapped.c
#include "meshes/mapped.h"

#include "base/memory.h"
#include "meshes/grid_ladders.h"

#include <math.h>
#include <stdlib.h>

// The lattice of all nodes: (elements * order + 1) in each direction, the last column of a closed
// circle being the first.
typedef struct lattice {
    const grid *g;
    const ladder *l;
    int order, n[2];
    double t[ELEMENT_MAX_ORDER + 1]; // Lobatto points on [0, 1]
    int *number;                     // [n[1]][n[0]] node, -1 where unused
} lattice;

static int *lattice_number(const lattice *w, int i, int j)
{
    return &w->number[(size_t)(j % w->n[1]) * (size_t)w->n[0] + (size_t)i];
}

static double lattice_coordinate(const lattice *w, int direction, int i)
{
    const ladder *l = &w->l[direction];
    const int e = i / w->order, k = i % w->order;
    return k == 0 ? l->edge[e] : l->edge[e] + (l->edge[e + 1] - l->edge[e]) * w->t[k];
}

static int element_owner(const lattice *w, int i, int j)
{
    return w->g->owner[w->l[1].cell[j] * w->g->n[0] + w->l[0].cell[i]];
}

// numbers the nodes of the elements that stay; returns how many nodes, and how many elements in
// *nelem
static int number_nodes(const lattice *w, int *nelem)
{
    int count = 0;
    *nelem = 0;
    for (int i = 0; i < w->n[0] * w->n[1]; i++) {
        w->number[i] = -1;
    }
    for (int j = 0; j < w->l[1].n; j++) {
        for (int i = 0; i < w->l[0].n; i++) {
            if (element_owner(w, i, j) < 0) {
                continue;
            }
            ++*nelem;
            for (int b = 0; b <= w->order; b++) {
                for (int a = 0; a <= w->order; a++) {
                    int *node = lattice_number(w, i * w->order + a, j * w->order + b);
                    *node = *node < 0 ? count++ : *node;
                }
            }
        }
    }
    return count;
}

static void place_nodes(const lattice *w, mesh *m)
{
    for (int j = 0; j < w->n[1]; j++) {
        for (int i = 0; i < w->n[0]; i++) {
            const int node = *lattice_number(w, i, j);
            if (node >= 0) {
                grid_point(w->g, lattice_coordinate(w, 0, i), lattice_coordinate(w, 1, j),
                           m->xyz + 3 * (size_t)node);
            }
        }
    }
}

static void place_elements(const lattice *w, const section_outline *o, mesh *m, int *owner)
{
    mesh_block *block = &m->block[0];
    int e = 0;
    for (int j = 0; j < w->l[1].n; j++) {
        for (int i = 0; i < w->l[0].n; i++) {
            const int shape = element_owner(w, i, j);
            if (shape < 0) {
                continue;
            }
            int *conn = block->conn + (size_t)e * (size_t)block->per_elem;
            for (int b = 0; b <= w->order; b++) {
                for (int a = 0; a <= w->order; a++) {
                    *conn++ = *lattice_number(w, i * w->order + a, j * w->order + b);
                }
            }
            block->material[e] = o->items[shape].material;
            owner[e++] = shape;
        }
    }
}

status mapped_mesh_make(const section_outline *o, const grid *g, const mesh_options *options,
                        mesh *out, int **owner)
{
    status st = OK;
    ladder l[2] = {{0}, {0}};
    lattice w = {.g = g, .l = l, .order = options->order};
    element line = {0};
    mesh m = {0};
    const shape quad = SHAPE_QUAD;
    int nelem = 0, *shapes = NULL;

    TRY(grid_ladders_make(o, g, options, l));
    TRY(element_make(SHAPE_LINE, w.order, &line));
    for (int k = 0; k <= w.order; k++) {
        w.t[k] = (line.line_node[k] + 1) / 2;
    }
    w.n[0] = l[0].n * w.order + 1;
    w.n[1] = l[1].n * w.order + (g->polar ? 0 : 1);
    TRY(TAKE(w.number, (size_t)w.n[0] * (size_t)w.n[1]));
    const int nnode = number_nodes(&w, &nelem);
    if (nelem == 0) {
        TRY(status_fail(ERR_INPUT, "the section is empty: what is drawn is cut away again"));
    }
    TRY(mesh_make(w.order, nnode, 1, &quad, &nelem, &m));
    TRY(TAKE(shapes, (size_t)nelem));
    place_nodes(&w, &m);
    place_elements(&w, o, &m, shapes);
    *out = m;
    *owner = shapes;
    m = (mesh){0};
    shapes = NULL;

done:
    free(w.number);
    free(shapes);
    mesh_free(&m);
    ladder_free(&l[0]);
    ladder_free(&l[1]);
    return st;
}
