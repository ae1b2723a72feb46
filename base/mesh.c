// base/mesh.c
#include "base/mesh.h"

#include "base/memory.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

void mesh_free(mesh *m)
{
    free(m->xyz);
    for (int b = 0; b < m->nblock; b++) {
        free(m->block[b].conn);
        free(m->block[b].material);
        free(m->block[b].frame);
    }
    free(m->frame);
    *m = (mesh){0};
}

status mesh_make(int order, int nnode, int nblock, const shape *shapes, const int *nelem, mesh *out)
{
    status st = OK;
    mesh m = {.order = order, .nnode = nnode, .nblock = nblock, .dim = element_dim(shapes[0])};

    TRY(TAKE(m.xyz, 3 * (size_t)nnode));
    for (int b = 0; b < nblock; b++) {
        mesh_block *block = &m.block[b];
        block->shape = shapes[b];
        block->nelem = nelem[b];
        block->per_elem = element_node_count(shapes[b], order);
        TRY(TAKE(block->conn, (size_t)nelem[b] * (size_t)block->per_elem));
        TRY(TAKE(block->material, (size_t)nelem[b]));
    }
    *out = m;
    m = (mesh){0};

done:
    mesh_free(&m);
    return st;
}

status mesh_take_frames(mesh *m, int nframe)
{
    status st = OK;
    TRY(TAKE(m->frame, (size_t)nframe));
    m->nframe = nframe;
    for (int b = 0; b < m->nblock; b++) {
        mesh_block *block = &m->block[b];
        TRY(TAKE(block->frame, (size_t)block->nelem));
        for (int e = 0; e < block->nelem; e++) {
            block->frame[e] = -1;
        }
    }

done:
    return st;
}

// an empty mesh with the blocks of another, of any order, and its frames
static status make_like(const mesh *in, int order, int nnode, mesh *out)
{
    status st = OK;
    shape shapes[MESH_MAX_BLOCKS];
    int nelem[MESH_MAX_BLOCKS];
    for (int b = 0; b < in->nblock; b++) {
        shapes[b] = in->block[b].shape;
        nelem[b] = in->block[b].nelem;
    }
    TRY(mesh_make(order, nnode, in->nblock, shapes, nelem, out));
    if (in->nframe > 0) {
        TRY(mesh_take_frames(out, in->nframe));
        memcpy(out->frame, in->frame, (size_t)in->nframe * sizeof *in->frame);
        for (int b = 0; b < in->nblock; b++) {
            const size_t n = (size_t)in->block[b].nelem;
            memcpy(out->block[b].frame, in->block[b].frame, n * sizeof(int));
        }
    }

done:
    return st;
}

status mesh_copy(const mesh *in, mesh *out)
{
    status st = OK;
    TRY(make_like(in, in->order, in->nnode, out));
    memcpy(out->xyz, in->xyz, 3 * (size_t)in->nnode * sizeof *in->xyz);
    for (int b = 0; b < in->nblock; b++) {
        const mesh_block *from = &in->block[b];
        const size_t n = (size_t)from->nelem;
        memcpy(out->block[b].conn, from->conn, n * (size_t)from->per_elem * sizeof *from->conn);
        memcpy(out->block[b].material, from->material, n * sizeof *from->material);
    }

done:
    return st;
}

int mesh_element_count(const mesh *m)
{
    int n = 0;
    for (int b = 0; b < m->nblock; b++) {
        n += m->block[b].nelem;
    }
    return n;
}

// --- another order
// -----------------------------------------------------------------------------------------------------

// A node of the lower element lies on a vertex, an edge, a face or inside. Two elements share it
// when they share the higher element's nodes that carry it: those whose basis functions do not
// vanish there. Its key is the smallest of these and the second smallest with the place between
// them, which Lobatto nodes make symmetric; so equal places are found by comparing coordinates
// among the few candidates hung on the smallest carrier.
typedef struct node_pool {
    const mesh *in;
    double *xyz; // [capacity][3]
    int *next;   // [capacity] chain of new nodes with the same smallest carrier
    int *first;  // [in->nnode] head of the chain, -1
    int count;
    double merge; // nodes nearer than this are one [m]
} node_pool;

// far below the distance of two nodes of one element, far above rounding
static const double MERGE_RELATIVE = 1e-9;

static status pool_add(node_pool *pool, int carrier, const double *x, int *index)
{
    for (int n = pool->first[carrier]; n >= 0; n = pool->next[n]) {
        const double *y = pool->xyz + 3 * n;
        if (hypot(hypot(x[0] - y[0], x[1] - y[1]), x[2] - y[2]) <= pool->merge) {
            *index = n;
            return OK;
        }
    }
    const int n = pool->count++;
    memcpy(pool->xyz + 3 * n, x, 3 * sizeof *x);
    pool->next[n] = pool->first[carrier];
    pool->first[carrier] = n;
    *index = n;
    return OK;
}

static status block_of_order(node_pool *pool, const mesh_block *from, int from_order, int order,
                             mesh_block *to)
{
    status st = OK;
    element high = {0}, low = {0};
    double N[ELEMENT_MAX_NODES];
    TRY(element_make(from->shape, from_order, &high));
    TRY(element_make(from->shape, order, &low));
    for (int i = 0; i < low.nnode; i++) {
        element_basis(&high, low.node[i], N, NULL);
        for (int e = 0; e < from->nelem; e++) {
            const int *conn = from->conn + (size_t)e * (size_t)from->per_elem;
            double x[3] = {0};
            int carrier = pool->in->nnode;
            for (int k = 0; k < high.nnode; k++) {
                const double *y = pool->in->xyz + 3 * (size_t)conn[k];
                for (int d = 0; d < 3; d++) {
                    x[d] += N[k] * y[d];
                }
                if (fabs(N[k]) > 1e-9 && conn[k] < carrier) {
                    carrier = conn[k];
                }
            }
            TRY(pool_add(pool, carrier, x, &to->conn[(size_t)e * (size_t)low.nnode + (size_t)i]));
        }
    }
    memcpy(to->material, from->material, (size_t)from->nelem * sizeof *from->material);

done:
    return st;
}

static double mesh_extent(const mesh *m)
{
    double extent = 0;
    for (int i = 0; i < 3 * m->nnode; i++) {
        extent = fmax(extent, fabs(m->xyz[i] - m->xyz[i % 3]));
    }
    return extent;
}

status mesh_of_order(const mesh *in, int order, mesh *out)
{
    status st = OK;
    mesh m = {0};
    node_pool pool = {.in = in, .merge = MERGE_RELATIVE * mesh_extent(in)};

    if (order < 1 || order > ELEMENT_MAX_ORDER) {
        TRY(status_fail(ERR_BUG, "order %d is not 1 to %d", order, ELEMENT_MAX_ORDER));
    }
    if (order == in->order) {
        return mesh_copy(in, out);
    }
    size_t capacity = 0;
    for (int b = 0; b < in->nblock; b++) {
        capacity +=
            (size_t)in->block[b].nelem * (size_t)element_node_count(in->block[b].shape, order);
    }
    TRY(TAKE(pool.xyz, 3 * capacity));
    TRY(TAKE(pool.next, capacity));
    TRY(TAKE(pool.first, (size_t)in->nnode));
    memset(pool.first, 0xff, (size_t)in->nnode * sizeof *pool.first);
    TRY(make_like(in, order, 1, &m));
    for (int b = 0; b < in->nblock; b++) {
        TRY(block_of_order(&pool, &in->block[b], in->order, order, &m.block[b]));
    }
    free(m.xyz);
    m.xyz = pool.xyz;
    m.nnode = pool.count;
    pool.xyz = NULL;
    *out = m;
    m = (mesh){0};

done:
    free(pool.xyz);
    free(pool.next);
    free(pool.first);
    mesh_free(&m);
    return st;
}

// --- checks
// ----------------------------------------------------------------------------------------------------------

static double determinant(int dim, const double (*J)[3])
{
    if (dim == 2) {
        return J[0][0] * J[1][1] - J[0][1] * J[1][0];
    }
    return J[0][0] * (J[1][1] * J[2][2] - J[1][2] * J[2][1]) -
           J[0][1] * (J[1][0] * J[2][2] - J[1][2] * J[2][0]) +
           J[0][2] * (J[1][0] * J[2][1] - J[1][1] * J[2][0]);
}

// det J of one element at one point; dN [nnode][dim]
static double jacobian(const mesh *m, const int *conn, int nnode, const double *dN)
{
    double J[3][3] = {{0}};
    for (int k = 0; k < nnode; k++) {
        const double *x = m->xyz + 3 * (size_t)conn[k];
        for (int i = 0; i < m->dim; i++) {
            for (int j = 0; j < m->dim; j++) {
                J[i][j] += x[i] * dN[k * m->dim + j];
            }
        }
    }
    return determinant(m->dim, (const double(*)[3])J);
}

typedef struct jacobian_range {
    double min, mean;
} jacobian_range;

// over the quadrature points and the nodes: a polynomial det J that is negative between them by
// much shows at one
static jacobian_range element_jacobian(const mesh *m, const int *conn, const basis_table *table,
                                       const double *node_dN)
{
    double sum = 0, weight = 0, min = INFINITY;
    const int n = table->nnode, stride = n * table->dim;
    for (int q = 0; q < table->npoint; q++) {
        const double d = jacobian(m, conn, n, table->dN + q * stride);
        sum += table->weight[q] * d;
        weight += table->weight[q];
        min = d < min ? d : min;
    }
    for (int i = 0; i < n; i++) {
        const double d = jacobian(m, conn, n, node_dN + i * stride);
        min = d < min ? d : min;
    }
    return (jacobian_range){.min = min, .mean = sum / weight};
}

// smallest min/mean over a block and where
static status block_min_jacobian(const mesh *m, const mesh_block *block, double *ratio, int *where)
{
    status st = OK;
    element e = {0};
    basis_table table = {0};
    double *node_dN = NULL, N[ELEMENT_MAX_NODES];

    TRY(element_make(block->shape, m->order, &e));
    TRY(basis_table_make(&e, 2 * m->order, &table));
    TRY(TAKE(node_dN, (size_t)(e.nnode * e.nnode * e.dim)));
    for (int i = 0; i < e.nnode; i++) {
        element_basis(&e, e.node[i], N, node_dN + i * e.nnode * e.dim);
    }
    for (int k = 0; k < block->nelem; k++) {
        const int *conn = block->conn + (size_t)k * (size_t)block->per_elem;
        const jacobian_range r = element_jacobian(m, conn, &table, node_dN);
        // an inverted element has a negative mean too: it must not look like a good one
        const double here = r.mean > 0 ? r.min / r.mean : -1;
        if (!(here >= *ratio)) {
            *ratio = here;
            *where = k;
        }
    }

done:
    free(node_dN);
    basis_table_free(&table);
    return st;
}

status mesh_min_jacobian(const mesh *m, double *min_ratio)
{
    status st = OK;
    int where = -1;
    *min_ratio = INFINITY;
    for (int b = 0; b < m->nblock; b++) {
        TRY(block_min_jacobian(m, &m->block[b], min_ratio, &where));
    }

done:
    return st;
}

static status check_indices(const mesh *m)
{
    status st = OK;
    bool *used = NULL;
    TRY(TAKE(used, (size_t)m->nnode));
    for (int b = 0; b < m->nblock; b++) {
        const size_t n = (size_t)m->block[b].nelem * (size_t)m->block[b].per_elem;
        for (size_t i = 0; i < n; i++) {
            const int node = m->block[b].conn[i];
            if (node < 0 || node >= m->nnode) {
                TRY(status_fail(ERR_NUMERIC, "mesh: node %d is not one of %d", node, m->nnode));
            }
            used[node] = true;
        }
    }
    for (int i = 0; i < m->nnode; i++) {
        const double *x = m->xyz + 3 * (size_t)i;
        if (!used[i] || !isfinite(x[0] + x[1] + x[2])) {
            TRY(status_fail(ERR_NUMERIC, "mesh: node %d %s", i,
                            used[i] ? "has a coordinate that is not finite"
                                    : "belongs to no element"));
        }
    }

done:
    free(used);
    return st;
}

status mesh_check(const mesh *m)
{
    status st = OK;
    if (mesh_element_count(m) < 1) {
        TRY(status_fail(ERR_NUMERIC, "mesh: it has no elements"));
    }
    TRY(check_indices(m));
    for (int b = 0; b < m->nblock; b++) {
        double ratio = INFINITY;
        int where = -1;
        TRY(block_min_jacobian(m, &m->block[b], &ratio, &where));
        if (!(ratio > 0)) {
            const int *conn = m->block[b].conn + (size_t)where * (size_t)m->block[b].per_elem;
            const double *x = m->xyz + 3 * (size_t)conn[0];
            TRY(status_fail(ERR_NUMERIC,
                            "mesh: %s %d at (%g, %g, %g) m is inverted, det J %.3g of its mean",
                            shape_name(m->block[b].shape), where, x[0], x[1], x[2], ratio));
        }
    }

done:
    return st;
}
