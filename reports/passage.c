// reports/passage.c
#include "reports/passage.h"

#include "base/memory.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct name {
    char text[PASSAGE_MAX_NAME];
} name;

static name join(const char *group, const char *tail)
{
    name n;
    (void)snprintf(n.text, sizeof n.text, "%s/%s", group, tail);
    return n;
}

status passage_damaged(const passage *p, const char *name, const char *words)
{
    return status_fail(ERR_FILE, "%s: damaged: '%s' %s", p->path, name, words);
}

status passage_room(const passage *p, void **array, size_t n, size_t size)
{
    return p->reading ? memory_take(array, n, size) : OK;
}

// --- arrays of structs ---------------------------------------------------------------------------

// the array's shape: [n] in front of the item's own
static int full_shape(const column *c, const column_rows *rows, size_t shape[4], size_t *width)
{
    int rank = 0;
    *width = 1;
    if (!rows->single) {
        shape[rank++] = rows->n;
    }
    for (int i = 0; i < c->rank; i++) {
        shape[rank++] = c->shape[i];
        *width *= c->shape[i];
    }
    return rank;
}

static char *member(const column *c, const column_rows *rows, size_t i)
{
    return (char *)rows->base + i * rows->stride + c->offset;
}

static bool shape_is(int rank, const size_t *shape, int found_rank, const size_t *found)
{
    return rank == found_rank &&
           (rank == 0 || memcmp(shape, found, (size_t)rank * sizeof *shape) == 0);
}

static status write_reals(const passage *p, const char *full, const column *c,
                          const column_rows *rows)
{
    status st = OK;
    double *data = NULL;
    size_t shape[4] = {0}, width = 0;
    const int rank = full_shape(c, rows, shape, &width);
    TRY(TAKE(data, rows->n * width));
    for (size_t i = 0; i < rows->n; i++) {
        memcpy(&data[i * width], member(c, rows, i), width * sizeof *data);
    }
    TRY(store_real(p->store, full, rank, shape, data, c->unit));

done:
    free(data);
    return st;
}

// What a number in this unit cannot be larger than, in any structure that a run of ours describes.
// Far beyond physics, and far from where a square or a product of a few leaves the doubles.
static double largest_in(const char *unit)
{
    static const struct {
        const char *unit;
        double largest;
    } limits[] = {{"m", 1e9}, {"1/m", 1e9}, {"m^2", 1e18}, {"rad", 1e9}, {"Pa", 1e20}};
    for (size_t i = 0; i < sizeof limits / sizeof *limits; i++) {
        if (strcmp(unit, limits[i].unit) == 0) {
            return limits[i].largest;
        }
    }
    return 1e60;
}

static status check_reals(const passage *p, const char *full, const column *c, const double *data,
                          size_t n)
{
    const double largest = largest_in(c->unit);
    for (size_t i = 0; c->kind != COLUMN_ANY && i < n; i++) {
        if (!isfinite(data[i])) {
            return passage_damaged(p, full, "holds what is not a number");
        }
        if (fabs(data[i]) > largest) {
            return passage_damaged(p, full, "holds a number beyond all reason");
        }
        if (c->kind == COLUMN_POSITIVE && data[i] <= 0) {
            return passage_damaged(p, full, "is not positive");
        }
    }
    return OK;
}

static status read_reals(const passage *p, const char *full, const column *c,
                         const column_rows *rows)
{
    status st = OK;
    double *data = NULL;
    size_t shape[4] = {0}, found[4], width = 0;
    int found_rank = 0;
    const int rank = full_shape(c, rows, shape, &width);
    TRY(store_read_real(p->store, full, &found_rank, found, &data));
    if (!shape_is(rank, shape, found_rank, found)) {
        TRY(passage_damaged(p, full, "has another shape than the counts say"));
    }
    TRY(check_reals(p, full, c, data, rows->n * width));
    for (size_t i = 0; i < rows->n; i++) {
        memcpy(member(c, rows, i), &data[i * width], width * sizeof *data);
    }

done:
    free(data);
    return st;
}

static status write_integers(const passage *p, const char *full, const column *c,
                             const column_rows *rows)
{
    status st = OK;
    int *data = NULL;
    size_t shape[4] = {0}, width = 0;
    const int rank = full_shape(c, rows, shape, &width);
    TRY(TAKE(data, rows->n * width));
    for (size_t i = 0; i < rows->n * width; i++) {
        const char *from = member(c, rows, i / width);
        data[i] = c->kind == COLUMN_FLAG ? *(const bool *)(const void *)from
                                         : ((const int *)(const void *)from)[i % width];
    }
    TRY(store_integer(p->store, full, rank, shape, data));

done:
    free(data);
    return st;
}

static status read_integers(const passage *p, const char *full, const column *c,
                            const column_rows *rows)
{
    status st = OK;
    int *data = NULL;
    size_t shape[4] = {0}, found[4], width = 0;
    int found_rank = 0;
    const int rank = full_shape(c, rows, shape, &width);
    const int max = c->kind == COLUMN_FLAG ? 1 : c->max;
    TRY(store_read_integer(p->store, full, &found_rank, found, &data));
    if (!shape_is(rank, shape, found_rank, found)) {
        TRY(passage_damaged(p, full, "has another shape than the counts say"));
    }
    for (size_t i = 0; i < rows->n * width; i++) {
        char *to = member(c, rows, i / width);
        if (data[i] < 0 || data[i] > max) {
            TRY(passage_damaged(p, full, "is out of range"));
        }
        if (c->kind == COLUMN_FLAG) {
            *(bool *)(void *)to = data[i] != 0;
        } else {
            ((int *)(void *)to)[i % width] = data[i];
        }
    }

done:
    free(data);
    return st;
}

static status pass_texts(const passage *p, const char *group, const column *c,
                         const column_rows *rows)
{
    status st = OK;
    for (size_t i = 0; i < rows->n; i++) {
        name full;
        (void)snprintf(full.text, sizeof full.text, "%s/%zu/%s", group, i, c->name);
        TRY(passage_words(p, full.text, member(c, rows, i), c->shape[0]));
    }

done:
    return st;
}

static status pass_column(const passage *p, const char *group, const column *c,
                          const column_rows *rows)
{
    const name full = join(group, c->name);
    switch (c->kind) {
    case COLUMN_REAL:
    case COLUMN_POSITIVE:
    case COLUMN_ANY:
        return p->reading ? read_reals(p, full.text, c, rows) : write_reals(p, full.text, c, rows);
    case COLUMN_TEXT:
        return pass_texts(p, group, c, rows);
    default:
        return p->reading ? read_integers(p, full.text, c, rows)
                          : write_integers(p, full.text, c, rows);
    }
}

status passage_columns(const passage *p, const char *group, int ncolumn, const column *columns,
                       column_rows rows)
{
    status st = OK;
    for (int i = 0; i < ncolumn; i++) {
        TRY(pass_column(p, group, &columns[i], &rows));
    }

done:
    return st;
}

status passage_count(const passage *p, const char *name, int least, int most, int *n)
{
    status st = OK;
    int rank = 0, *data = NULL;
    size_t shape[4];
    if (!p->reading) {
        return store_integer(p->store, name, 0, NULL, n);
    }
    TRY(store_read_integer(p->store, name, &rank, shape, &data));
    if (rank != 0 || *data < least || *data > most) {
        TRY(passage_damaged(p, name, "is out of range"));
    }
    *n = *data;

done:
    free(data);
    return st;
}

// --- texts ---------------------------------------------------------------------------------------

status passage_text(const passage *p, const char *name, char **text, size_t *length)
{
    return p->reading ? store_read_text(p->store, name, text, length)
                      : store_text(p->store, name, *text, *length);
}

status passage_words(const passage *p, const char *name, char *text, size_t size)
{
    status st = OK;
    char *found = NULL;
    size_t length = 0;
    if (!p->reading) {
        return store_text(p->store, name, text, strnlen(text, size));
    }
    TRY(store_read_text(p->store, name, &found, &length));
    if (length >= size) {
        TRY(passage_damaged(p, name, "is too long"));
    }
    (void)snprintf(text, size, "%s", found);

done:
    free(found);
    return st;
}

// --- meshes --------------------------------------------------------------------------------------

typedef struct mesh_counts {
    int order, nnode, nblock, shape[MESH_MAX_BLOCKS], nelem[MESH_MAX_BLOCKS];
} mesh_counts;

// far below an atom
static const double least_extent = 1e-15; // [m]

enum { MESH_MAX_NODES = 10000000, MESH_MAX_ELEMENTS = 2000000 };

static status pass_mesh_counts(const passage *p, const char *group, int dim, mesh_counts *n)
{
    status st = OK;
    TRY(passage_count(p, join(group, "node_count").text, 0, MESH_MAX_NODES, &n->nnode));
    if (n->nnode == 0) {
        return OK;
    }
    TRY(passage_count(p, join(group, "order").text, 1, ELEMENT_MAX_ORDER, &n->order));
    TRY(passage_count(p, join(group, "block_count").text, 1, MESH_MAX_BLOCKS, &n->nblock));
    for (int b = 0; b < n->nblock; b++) {
        char tail[64];
        (void)snprintf(tail, sizeof tail, "block/%d/shape", b);
        TRY(passage_count(p, join(group, tail).text, dim == 2 ? SHAPE_TRIANGLE : SHAPE_PRISM,
                          dim == 2 ? SHAPE_QUAD : SHAPE_HEX, &n->shape[b]));
        (void)snprintf(tail, sizeof tail, "block/%d/element_count", b);
        TRY(passage_count(p, join(group, tail).text, 0, MESH_MAX_ELEMENTS, &n->nelem[b]));
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
    TRY(passage_columns(p, group, 1, &node,
                        (column_rows){m->xyz, (size_t)n.nnode, 3 * sizeof(double), false}));
    TRY(p->reading ? check_extent(p, join(group, "node_m").text, dim, m) : OK);
    for (int b = 0; b < n.nblock; b++) {
        const mesh_block *block = &m->block[b];
        const size_t width = (size_t)block->per_elem, nelem = (size_t)block->nelem;
        const column conn = {"connectivity", COLUMN_INT, "-", 0, 1, {width}, n.nnode - 1};
        const column material = {"material", COLUMN_INT, "-", 0, 0, {0}, nmaterial - 1};
        char tail[64];
        (void)snprintf(tail, sizeof tail, "block/%d", b);
        const name inner = join(group, tail);
        TRY(passage_columns(p, inner.text, 1, &conn,
                            (column_rows){block->conn, nelem, width * sizeof(int), false}));
        TRY(passage_columns(p, inner.text, 1, &material,
                            (column_rows){block->material, nelem, sizeof(int), false}));
    }

done:
    return st;
}
