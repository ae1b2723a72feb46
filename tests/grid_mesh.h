// tests/grid_mesh.h
// Meshes for tests: a grid of cells on [0, 1]^2, some of them left out, of quads or of triangles,
// of any order, mapped by a function.
#pragma once

#include "base/memory.h"
#include "base/mesh.h"
#include "tests/test.h"

#include <string.h>

typedef struct grid {
    int nx, ny, order;
    bool triangles;
    const char *cells; // [ny][nx] ' ': left out, '0' + material; NULL: all of material 0
    void (*map)(const double *from, double *to); // of (u, v) in [0, 1]^2; NULL: stays there
} grid;

// corners of cell (i, j), as two triangles or one quad in the lattice's order
static inline int grid_cell(const grid *g, int i, int j, int corner[2][4])
{
    const int a = j * (g->nx + 1) + i, c = a + g->nx + 1;
    const int quad[4] = {a, a + 1, c, c + 1};
    const int lower[4] = {a, a + 1, c, 0}, upper[4] = {c + 1, c, a + 1, 0};
    memcpy(corner[0], g->triangles ? lower : quad, sizeof quad);
    memcpy(corner[1], upper, sizeof upper);
    return g->triangles ? 2 : 1;
}

static inline void grid_elements(const grid *g, mesh_block *b)
{
    int corner[2][4];
    b->nelem = 0;
    for (int j = 0; j < g->ny; j++) {
        for (int i = 0; i < g->nx; i++) {
            const char what = g->cells ? g->cells[j * g->nx + i] : '0';
            const int count = what == ' ' ? 0 : grid_cell(g, i, j, corner);
            for (int k = 0; k < count; k++, b->nelem++) {
                memcpy(b->conn + b->nelem * b->per_elem, corner[k],
                       (size_t)b->per_elem * sizeof(int));
                b->material[b->nelem] = what - '0';
            }
        }
    }
}

// leaves out nodes without elements
static inline void grid_renumber(const grid *g, mesh *m)
{
    int *number = NULL, count = 0;
    mesh_block *b = &m->block[0];
    CHECK_OK(TAKE(number, (size_t)m->nnode));
    for (int i = 0; i < b->nelem * b->per_elem; i++) {
        number[b->conn[i]] = 1;
    }
    for (int k = 0; k < m->nnode; k++) {
        if (number[k]) {
            number[k] = count;
            m->xyz[3 * count] = (double)(k % (g->nx + 1)) / g->nx;
            m->xyz[3 * count + 1] = (double)(k / (g->nx + 1)) / g->ny;
            count++;
        }
    }
    for (int i = 0; i < b->nelem * b->per_elem; i++) {
        b->conn[i] = number[b->conn[i]];
    }
    m->nnode = count;
    free(number);
}

static inline void grid_make(const grid *g, mesh *out)
{
    mesh coarse = {0};
    const shape kind = g->triangles ? SHAPE_TRIANGLE : SHAPE_QUAD;
    const int most = g->nx * g->ny * (g->triangles ? 2 : 1);
    CHECK_OK(mesh_make(1, (g->nx + 1) * (g->ny + 1), 1, &kind, &most, &coarse));
    grid_elements(g, &coarse.block[0]);
    grid_renumber(g, &coarse);
    CHECK_OK(mesh_of_order(&coarse, g->order, out));
    for (int i = 0; i < out->nnode && g->map; i++) {
        const double at[2] = {out->xyz[3 * i], out->xyz[3 * i + 1]};
        g->map(at, out->xyz + 3 * i);
    }
    mesh_free(&coarse);
    CHECK_OK(mesh_check(out));
}
