// io/store_grid_cells.c
// Counts and cells of the pieces.
#include "io/store_grid_parts.h"

#include "base/memory.h"

static int material_of(const store_grid_piece *p, int layer, int element, int own)
{
    const store_layers *l = p->layers;
    return l && l->matter
               ? l->matter[(size_t)layer * (size_t)mesh_element_count(p->mesh) + (size_t)element]
               : own;
}

share share_of(const store_grid_piece *p, bool first_rank)
{
    const store_layers *l = p->layers;
    if (!l) {
        return (share){0, first_rank ? 1 : 0, 0, first_rank ? 1 : 0};
    }
    const int whole = l->nlayer * l->order + 1;
    const int last = l->last == whole ? l->nlayer : l->last / l->order;
    return (share){l->first / l->order, last, l->first, l->last};
}

static status count_cells(const store_grid_piece *p, int to_layer, amount *out)
{
    status st = OK;
    *out = (amount){0};
    for (int b = 0, element = 0; b < p->mesh->nblock; b++) {
        cut c;
        const mesh_block *k = &p->mesh->block[b];
        TRY(cut_element(k->shape, p->mesh->order, p->layers ? p->layers->order : 0, &c));
        for (int e = 0; e < k->nelem; e++, element++) {
            for (int layer = 0; layer < to_layer; layer++) {
                const bool there = material_of(p, layer, element, k->material[e]) >= 0;
                out->cell += there ? (size_t)c.ncell : 0;
                out->index += there ? (size_t)c.ncell * (size_t)c.ncorner : 0;
            }
        }
    }

done:
    return st;
}

static size_t levels_of(const store_grid_piece *p)
{
    return p->layers ? (size_t)p->layers->nlayer * (size_t)p->layers->order + 1 : 1;
}

static status count_piece(const store_grid_piece *p, amount *out)
{
    const status st = count_cells(p, p->layers ? p->layers->nlayer : 1, out);
    out->point = levels_of(p) * (size_t)p->mesh->nnode;
    return st;
}

status grid_count(grid *g)
{
    status st = OK;
    TRY(TAKE(g->count, (size_t)g->npiece));
    TRY(TAKE(g->from, (size_t)g->npiece + 1));
    for (int i = 0; i < g->npiece; i++) {
        TRY(count_piece(&g->piece[i], &g->count[i]));
        g->from[i + 1] = (amount){.point = g->from[i].point + g->count[i].point,
                                  .cell = g->from[i].cell + g->count[i].cell,
                                  .index = g->from[i].index + g->count[i].index};
    }

done:
    return st;
}

// --- counts

static status write_counts(const grid *g)
{
    static const char *const names[3] = {"NumberOfPoints", "NumberOfCells",
                                         "NumberOfConnectivityIds"};
    status st = OK;
    for (int k = 0; k < 3; k++) {
        TRY(grid_make_room(g, names[k], (size_t)g->npiece, HDF5_LONG, 1, "-"));
        for (int i = 0; g->first_rank && i < g->npiece; i++) {
            const amount *n = &g->count[i];
            const int64_t number = (int64_t)(k == 0 ? n->point : k == 1 ? n->cell : n->index);
            TRY(grid_write_rows(g, names[k], (size_t)i, 1, HDF5_LONG, 1, &number));
        }
    }

done:
    return st;
}

// --- cells

typedef struct cells {
    size_t n, nindex;
    int64_t *offset; // [n] where each ends, within the piece
    int64_t *conn;   // [nindex] nodes of the piece
    uint8_t *type;
    int *material, *part;
} cells;

static void cells_free(cells *c)
{
    free(c->offset);
    free(c->conn);
    free(c->type);
    free(c->material);
    free(c->part);
}

static status cells_make(size_t n, size_t nindex, cells *c)
{
    status st = OK;
    TRY(TAKE(c->offset, n));
    TRY(TAKE(c->conn, nindex));
    TRY(TAKE(c->type, n));
    TRY(TAKE(c->material, n));
    TRY(TAKE(c->part, n));

done:
    return st;
}

static void add_cells(const store_grid_piece *p, const cut *c, const int *conn, int per_elem,
                      int layer, cells *out)
{
    const int base = p->layers ? layer * p->layers->order : 0;
    for (int k = 0; k < c->ncell; k++) {
        for (int i = 0; i < c->ncorner; i++) {
            const int at = c->corner[k][i];
            out->conn[out->nindex++] =
                conn[at % per_elem] + (int64_t)p->mesh->nnode * (int64_t)(base + at / per_elem);
        }
        out->type[out->n++] = (uint8_t)c->type;
    }
}

static status fill_layer(const store_grid_piece *p, int layer, int part, size_t before, cells *out)
{
    status st = OK;
    for (int b = 0, element = 0; b < p->mesh->nblock; b++) {
        cut c;
        const mesh_block *k = &p->mesh->block[b];
        TRY(cut_element(k->shape, p->mesh->order, p->layers ? p->layers->order : 0, &c));
        for (int e = 0; e < k->nelem; e++, element++) {
            const int material = material_of(p, layer, element, k->material[e]);
            const size_t first = out->n;
            if (material < 0) {
                continue;
            }
            add_cells(p, &c, k->conn + (size_t)e * (size_t)k->per_elem, k->per_elem, layer, out);
            for (size_t i = first; i < out->n; i++) {
                out->material[i] = material;
                out->part[i] = part;
                before += (size_t)c.ncorner;
                out->offset[i] = (int64_t)before;
            }
        }
    }

done:
    return st;
}

static status write_cells(const grid *g, int i)
{
    status st = OK;
    const store_grid_piece *p = &g->piece[i];
    const share s = share_of(p, g->first_rank);
    amount from, to;
    cells c = {0};
    TRY(count_cells(p, s.layer, &from));
    TRY(count_cells(p, s.last_layer, &to));
    const size_t n = to.cell - from.cell, nindex = to.index - from.index;
    TRY(cells_make(n, nindex, &c));
    for (int layer = s.layer; layer < s.last_layer; layer++) {
        TRY(fill_layer(p, layer, i, from.index + c.nindex, &c));
    }
    const size_t cell = g->from[i].cell + from.cell;
    // each piece's offsets begin with a 0 of their own
    const size_t offset = cell + (size_t)i + 1;
    if (g->first_rank) {
        TRY(grid_write_rows(g, "Offsets", g->from[i].cell + (size_t)i, 1, HDF5_LONG, 1,
                            &(int64_t){0}));
    }
    TRY(grid_write_rows(g, "Offsets", offset, n, HDF5_LONG, 1, c.offset));
    TRY(grid_write_rows(g, "Connectivity", g->from[i].index + from.index, nindex, HDF5_LONG, 1,
                        c.conn));
    TRY(grid_write_rows(g, "Types", cell, n, HDF5_BYTE, 1, c.type));
    TRY(grid_write_rows(g, "CellData/material", cell, n, HDF5_INTEGER, 1, c.material));
    TRY(grid_write_rows(g, "CellData/part", cell, n, HDF5_INTEGER, 1, c.part));

done:
    cells_free(&c);
    return st;
}

status grid_write_topology(const grid *g)
{
    status st = OK;
    const amount all = g->from[g->npiece];
    TRY(write_counts(g));
    TRY(grid_make_room(g, "Offsets", all.cell + (size_t)g->npiece, HDF5_LONG, 1, "-"));
    TRY(grid_make_room(g, "Connectivity", all.index, HDF5_LONG, 1, "-"));
    TRY(grid_make_room(g, "Types", all.cell, HDF5_BYTE, 1, "-"));
    TRY(grid_make_room(g, "CellData/material", all.cell, HDF5_INTEGER, 1, "-"));
    TRY(grid_make_room(g, "CellData/part", all.cell, HDF5_INTEGER, 1, "-"));
    for (int i = 0; i < g->npiece; i++) {
        TRY(write_cells(g, i));
    }

done:
    return st;
}
