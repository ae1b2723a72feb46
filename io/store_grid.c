// io/store_grid.c
#include "io/store_grid.h"

#include "base/memory.h"

#include <stdio.h>
#include <string.h>

enum { VTK_TRIANGLE = 5, VTK_QUAD = 9, VTK_HEXAHEDRON = 12, VTK_WEDGE = 13 };
enum { MAX_CELLS = ELEMENT_MAX_ORDER * ELEMENT_MAX_ORDER * ELEMENT_MAX_ORDER, MAX_CORNERS = 8 };

// how an element is cut: linear cells on its lattice nodes, in VTK's order of corners
typedef struct cut {
    int type, ncell, ncorner;
    int corner[MAX_CELLS][MAX_CORNERS];
} cut;

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
            int corner[MAX_CORNERS];
            for (int i = 0; i < n; i++) {
                const int from = n == 3 ? (3 - i) % 3 : i;
                corner[i] = plane->corner[e][from] + nplane * k;
                corner[n + i] = corner[i] + nplane;
            }
            add_cell(c, corner);
        }
    }
}

static status cut_element(shape shape, int p, cut *out)
{
    cut plane = {0};
    *out = (cut){0};
    switch (shape) {
    case SHAPE_TRIANGLE:
        out->type = VTK_TRIANGLE;
        cut_triangle(p, out);
        return OK;
    case SHAPE_QUAD:
        out->type = VTK_QUAD;
        cut_quad(p, out);
        return OK;
    case SHAPE_PRISM:
        out->type = VTK_WEDGE;
        cut_triangle(p, &plane);
        cut_layers(&plane, element_node_count(SHAPE_TRIANGLE, p), p, out);
        return OK;
    case SHAPE_HEX:
        out->type = VTK_HEXAHEDRON;
        cut_quad(p, &plane);
        cut_layers(&plane, element_node_count(SHAPE_QUAD, p), p, out);
        return OK;
    default:
        return status_fail(ERR_BUG, "a grid cannot hold %s elements", shape_name(shape));
    }
}

// everything under /VTKHDF; the pieces one after the other
typedef struct grid {
    size_t npiece, npoint, ncell, nindex;
    int64_t *points, *cells, *indices; // [npiece]
    int64_t *offset;                   // [ncell + npiece], each piece from 0
    int64_t *conn;                     // [nindex], within the piece
    uint8_t *type;                     // [ncell]
    int *material, *part;              // [ncell]
    double *xyz;                       // [npoint][3]
    double *field;                     // [npoint][6] at most, one after the other
} grid;

static void grid_free(grid *g)
{
    free(g->points);
    free(g->cells);
    free(g->indices);
    free(g->offset);
    free(g->conn);
    free(g->type);
    free(g->material);
    free(g->part);
    free(g->xyz);
    free(g->field);
    *g = (grid){0};
}

static status grid_count(int npiece, const store_grid_piece *pieces, grid *g)
{
    status st = OK;
    g->npiece = (size_t)npiece;
    TRY(TAKE(g->points, g->npiece));
    TRY(TAKE(g->cells, g->npiece));
    TRY(TAKE(g->indices, g->npiece));
    for (int i = 0; i < npiece; i++) {
        const mesh *m = pieces[i].mesh;
        g->points[i] = m->nnode;
        for (int b = 0; b < m->nblock; b++) {
            cut c;
            TRY(cut_element(m->block[b].shape, m->order, &c));
            const int64_t ncell = (int64_t)m->block[b].nelem * c.ncell;
            g->cells[i] += ncell;
            g->indices[i] += ncell * c.ncorner;
        }
        g->npoint += (size_t)g->points[i];
        g->ncell += (size_t)g->cells[i];
        g->nindex += (size_t)g->indices[i];
    }
    TRY(TAKE(g->offset, g->ncell + g->npiece));
    TRY(TAKE(g->conn, g->nindex));
    TRY(TAKE(g->type, g->ncell));
    TRY(TAKE(g->material, g->ncell));
    TRY(TAKE(g->part, g->ncell));
    TRY(TAKE(g->xyz, 3 * g->npoint));
    TRY(TAKE(g->field, 6 * g->npoint));

done:
    return st;
}

// where the next cell goes
typedef struct place {
    size_t cell, offset, index;
} place;

static status fill_block(const mesh *m, int b, int part, grid *g, place *at)
{
    status st = OK;
    cut c;
    const mesh_block *block = &m->block[b];
    TRY(cut_element(block->shape, m->order, &c));
    for (int e = 0; e < block->nelem; e++) {
        const int *conn = &block->conn[(size_t)e * (size_t)block->per_elem];
        for (int k = 0; k < c.ncell; k++) {
            for (int i = 0; i < c.ncorner; i++) {
                g->conn[at->index++] = conn[c.corner[k][i]];
            }
            g->type[at->cell] = (uint8_t)c.type;
            g->material[at->cell] = block->material[e];
            g->part[at->cell++] = part;
            g->offset[at->offset + 1] = g->offset[at->offset] + c.ncorner;
            at->offset++;
        }
    }

done:
    return st;
}

static status grid_fill(const store_grid_piece *pieces, grid *g)
{
    status st = OK;
    place at = {0};
    double *xyz = g->xyz;
    for (size_t i = 0; i < g->npiece; i++) {
        const mesh *m = pieces[i].mesh;
        const double *u = pieces[i].displacement;
        for (int b = 0; b < m->nblock; b++) {
            TRY(fill_block(m, b, (int)i, g, &at));
        }
        at.offset++; // each piece's offsets begin with a 0
        const size_t n = 3 * (size_t)m->nnode;
        for (size_t k = 0; k < n; k++) {
            xyz[k] = m->xyz[k] + (u ? u[k] : 0);
        }
        xyz += n;
    }

done:
    return st;
}

// a field's unit stands behind the last _ of its name
static const char *unit_of(const char *name)
{
    const char *last = strrchr(name, '_');
    return last && last[1] ? last + 1 : "-";
}

static status write_field(const hdf5_door *door, hdf5_file *file, const store_grid_piece *pieces,
                          int k, grid *g)
{
    status st = OK;
    char name[128];
    const store_field *first = &pieces[0].field[k];
    const int nc = first->ncomponent;
    size_t at = 0;
    for (size_t i = 0; i < g->npiece; i++) {
        const store_field *f = k < pieces[i].nfield ? &pieces[i].field[k] : NULL;
        if (!f || strcmp(f->name, first->name) != 0 || f->ncomponent != nc ||
            (nc != 1 && nc != 3 && nc != 6)) {
            return status_fail(ERR_BUG, "the grid's pieces differ in field %d", k);
        }
        const size_t n = (size_t)nc * (size_t)pieces[i].mesh->nnode;
        memcpy(&g->field[at], f->data, n * sizeof *f->data);
        at += n;
    }
    const hdf5_array array = {HDF5_REAL, nc == 1 ? 1 : 2, {g->npoint, (size_t)nc}};
    (void)snprintf(name, sizeof name, "VTKHDF/PointData/%s", first->name);
    TRY(door->write(file, name, &array, g->field, unit_of(first->name)));

done:
    return st;
}

static status write_topology(const hdf5_door *door, hdf5_file *file, const grid *g)
{
    const struct {
        const char *name;
        const void *data;
        size_t n;
        int kind;
    } arrays[] = {
        {"VTKHDF/NumberOfPoints", g->points, g->npiece, HDF5_LONG},
        {"VTKHDF/NumberOfCells", g->cells, g->npiece, HDF5_LONG},
        {"VTKHDF/NumberOfConnectivityIds", g->indices, g->npiece, HDF5_LONG},
        {"VTKHDF/Offsets", g->offset, g->ncell + g->npiece, HDF5_LONG},
        {"VTKHDF/Connectivity", g->conn, g->nindex, HDF5_LONG},
        {"VTKHDF/Types", g->type, g->ncell, HDF5_BYTE},
        {"VTKHDF/CellData/material", g->material, g->ncell, HDF5_INTEGER},
        {"VTKHDF/CellData/part", g->part, g->ncell, HDF5_INTEGER},
    };
    status st = OK;
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
        const hdf5_array array = {arrays[i].kind, 1, {arrays[i].n}};
        TRY(door->write(file, arrays[i].name, &array, arrays[i].data, "-"));
    }

done:
    return st;
}

status store_grid_write(const hdf5_door *door, hdf5_file *file, int npiece,
                        const store_grid_piece *pieces)
{
    static const char type[] = "UnstructuredGrid";
    static const int64_t version[2] = {1, 0};
    const hdf5_array pair = {HDF5_LONG, 1, {2}}, word = hdf5_text_of(sizeof type - 1);
    status st = OK;
    grid g = {0};
    if (npiece < 1) {
        return status_fail(ERR_BUG, "a grid needs a piece");
    }
    TRY(grid_count(npiece, pieces, &g));
    TRY(grid_fill(pieces, &g));
    TRY(door->put(file, "VTKHDF", "Version", &pair, version));
    TRY(door->put(file, "VTKHDF", "Type", &word, type));
    TRY(write_topology(door, file, &g));
    const hdf5_array points = {HDF5_REAL, 2, {g.npoint, 3}};
    TRY(door->write(file, "VTKHDF/Points", &points, g.xyz, "m"));
    for (int k = 0; k < pieces[0].nfield; k++) {
        TRY(write_field(door, file, pieces, k, &g));
    }

done:
    grid_free(&g);
    return st;
}
