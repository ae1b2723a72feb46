// reports/passage_mesh.c
#include "reports/store_parts.h"

#include <math.h>
#include <stdio.h>

typedef struct mesh_counts {
    int order, nnode, nblock, shape[MESH_MAX_BLOCKS], nelem[MESH_MAX_BLOCKS];
} mesh_counts;

// far below an atom
static const double least_extent = 1e-15; // [m]

enum { MESH_MAX_NODES = 10000000, MESH_MAX_ELEMENTS = 2000000 };

static status pass_mesh_counts(const passage *p, const char *group, int dim, mesh_counts *n)
{
    status st = OK;
    TRY(passage_count(p, passage_join(group, "node_count").text, 0, MESH_MAX_NODES, &n->nnode));
    if (n->nnode == 0) {
        return OK;
    }
    TRY(passage_count(p, passage_join(group, "order").text, 1, ELEMENT_MAX_ORDER, &n->order));
    TRY(passage_count(p, passage_join(group, "block_count").text, 1, MESH_MAX_BLOCKS, &n->nblock));
    for (int b = 0; b < n->nblock; b++) {
        char tail[64];
        (void)snprintf(tail, sizeof tail, "block/%d/shape", b);
        TRY(passage_count(p, passage_join(group, tail).text,
                          dim == 2 ? SHAPE_TRIANGLE : SHAPE_PRISM,
                          dim == 2 ? SHAPE_QUAD : SHAPE_HEX, &n->shape[b]));
        (void)snprintf(tail, sizeof tail, "block/%d/element_count", b);
        TRY(passage_count(p, passage_join(group, tail).text, 0, MESH_MAX_ELEMENTS, &n->nelem[b]));
    }

done:
    return st;
}

static status make_counted(const mesh_counts *n, mesh *m)
{
    shape shapes[MESH_MAX_BLOCKS];
    for (int b = 0; b < n->nblock; b++) {
        shapes[b] = (shape)n->shape[b];
    }
    return mesh_make(n->order, n->nnode, n->nblock, shapes, n->nelem, m);
}

static mesh_counts count_mesh(const mesh *m)
{
    mesh_counts n = {.order = m->order, .nnode = m->nnode, .nblock = m->nblock};
    for (int b = 0; b < m->nblock; b++) {
        n.shape[b] = (int)m->block[b].shape;
        n.nelem[b] = m->block[b].nelem;
    }
    return n;
}

// pictures are scaled by a mesh's extent
static status check_extent(const passage *p, const char *full, int dim, const mesh *m)
{
    for (int k = 0; k < dim; k++) {
        double low = m->xyz[k], high = m->xyz[k];
        for (int i = 1; i < m->nnode; i++) {
            low = fmin(low, m->xyz[3 * i + k]);
            high = fmax(high, m->xyz[3 * i + k]);
        }
        if (!(high - low >= least_extent)) {
            return passage_damaged(p, full, "is of no size");
        }
    }
    return OK;
}

status passage_mesh(const passage *p, const char *group, int dim, int nmaterial, mesh *m)
{
    static const column node = {"node_m", COLUMN_REAL, "m", 0, 1, {3}, 0};
    status st = OK;
    mesh_counts n = count_mesh(m);
    TRY(pass_mesh_counts(p, group, dim, &n));
    if (n.nnode == 0) {
        return OK;
    }
    if (p->reading) {
        TRY(make_counted(&n, m));
    }
    TRY(passage_columns(p, group, 1, &node, rows_of(m->xyz, n.nnode, 3 * sizeof(double))));
    TRY(p->reading ? check_extent(p, passage_join(group, "node_m").text, dim, m) : OK);
    for (int b = 0; b < n.nblock; b++) {
        const mesh_block *block = &m->block[b];
        const size_t width = (size_t)block->per_elem;
        const column conn = {"connectivity", COLUMN_INT, "-", 0, 1, {width}, n.nnode - 1};
        const column material = {"material", COLUMN_INT, "-", 0, 0, {0}, nmaterial - 1};
        char tail[64];
        (void)snprintf(tail, sizeof tail, "block/%d", b);
        const passage_name inner = passage_join(group, tail);
        TRY(passage_columns(p, inner.text, 1, &conn,
                            rows_of(block->conn, block->nelem, width * sizeof(int))));
        TRY(passage_columns(p, inner.text, 1, &material,
                            rows_of(block->material, block->nelem, sizeof(int))));
    }

done:
    return st;
}
