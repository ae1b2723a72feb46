// tests/unit/io/grid_mesh.h
// A strip [0,2] x [0,1], its left half one quad and its right half two triangles; extruded to
// height 1 on demand.
#pragma once

#include "base/mesh.h"
#include "tests/test.h"

// its own nodes for every element: a grid does not ask for more
static inline void put_element(mesh *m, int b, int e, int first, const double (*corner)[2])
{
    element el;
    mesh_block *block = &m->block[b];
    CHECK_OK(element_make(block->shape, m->order, &el));
    for (int i = 0; i < el.nnode; i++) {
        const double *x = el.node[i];
        double *to = &m->xyz[3 * (size_t)(first + i)];
        if (block->shape == SHAPE_QUAD || block->shape == SHAPE_HEX) {
            to[0] = (1 + x[0]) / 2;
            to[1] = (1 + x[1]) / 2;
        } else {
            for (int k = 0; k < 2; k++) {
                to[k] = corner[0][k] + x[0] * (corner[1][k] - corner[0][k]) +
                        x[1] * (corner[2][k] - corner[0][k]);
            }
        }
        to[2] = el.dim == 3 ? (1 + x[2]) / 2 : 0;
        block->conn[(size_t)e * (size_t)block->per_elem + (size_t)i] = first + i;
    }
    block->material[e] = b;
}

static inline mesh grid_mesh(int dim, int order)
{
    static const double lower[3][2] = {{1, 0}, {2, 0}, {2, 1}},
                        upper[3][2] = {{1, 0}, {2, 1}, {1, 1}};
    const shape shapes[2] = {dim == 2 ? SHAPE_QUAD : SHAPE_HEX,
                             dim == 2 ? SHAPE_TRIANGLE : SHAPE_PRISM};
    const int nelem[2] = {1, 2};
    const int nquad = element_node_count(shapes[0], order);
    const int ntri = element_node_count(shapes[1], order);
    mesh m = {0};
    CHECK_OK(mesh_make(order, nquad + 2 * ntri, 2, shapes, nelem, &m));
    put_element(&m, 0, 0, 0, NULL);
    put_element(&m, 1, 0, nquad, lower);
    put_element(&m, 1, 1, nquad + ntri, upper);
    return m;
}
