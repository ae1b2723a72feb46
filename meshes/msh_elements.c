// meshes/msh_elements.c
#include "meshes/msh_reader.h"

#include "base/memory.h"

#include <string.h>

typedef enum type_use { USE_PASS, USE_PLANE, USE_NO_MIDDLE, USE_PART, USE_SOLID } type_use;

// gmsh's element types
static const struct element_type {
    int type;
    type_use use;
    shape shape;
    int order, nnode;
} types[] = {
    {15, USE_PASS, SHAPE_LINE, 0, 1},       {1, USE_PASS, SHAPE_LINE, 1, 2},
    {8, USE_PASS, SHAPE_LINE, 2, 3},        {26, USE_PASS, SHAPE_LINE, 3, 4},
    {27, USE_PASS, SHAPE_LINE, 4, 5},       {28, USE_PASS, SHAPE_LINE, 5, 6},
    {2, USE_PLANE, SHAPE_TRIANGLE, 1, 3},   {9, USE_PLANE, SHAPE_TRIANGLE, 2, 6},
    {21, USE_PLANE, SHAPE_TRIANGLE, 3, 10}, {23, USE_PLANE, SHAPE_TRIANGLE, 4, 15},
    {3, USE_PLANE, SHAPE_QUAD, 1, 4},       {10, USE_PLANE, SHAPE_QUAD, 2, 9},
    {36, USE_PLANE, SHAPE_QUAD, 3, 16},     {37, USE_PLANE, SHAPE_QUAD, 4, 25},
    {16, USE_NO_MIDDLE, SHAPE_QUAD, 2, 8},  {20, USE_PART, SHAPE_TRIANGLE, 3, 9},
    {22, USE_PART, SHAPE_TRIANGLE, 4, 12},  {39, USE_PART, SHAPE_QUAD, 3, 12},
    {40, USE_PART, SHAPE_QUAD, 4, 16},      {4, USE_SOLID, SHAPE_HEX, 1, 4},
    {5, USE_SOLID, SHAPE_HEX, 1, 8},        {6, USE_SOLID, SHAPE_PRISM, 1, 6},
    {7, USE_SOLID, SHAPE_HEX, 1, 5},        {11, USE_SOLID, SHAPE_HEX, 2, 10},
    {12, USE_SOLID, SHAPE_HEX, 2, 27},      {13, USE_SOLID, SHAPE_PRISM, 2, 18},
    {14, USE_SOLID, SHAPE_HEX, 2, 14},      {17, USE_SOLID, SHAPE_HEX, 2, 20},
    {18, USE_SOLID, SHAPE_PRISM, 2, 15},    {19, USE_SOLID, SHAPE_HEX, 2, 13},
};

typedef struct element_type element_type;

static status find_type(const msh_reader *r, int64_t number, const element_type **out)
{
    const element_type *t = NULL;
    for (size_t i = 0; i < sizeof types / sizeof *types && !t; i++) {
        t = types[i].type == number ? &types[i] : NULL;
    }
    if (!t) {
        return msh_fail(&r->c,
                        "elements of gmsh's type %lld are not read: triangles and "
                        "quadrangles of order 1 to 4 are",
                        (long long)number);
    }
    if (t->use == USE_SOLID) {
        return msh_fail(
            &r->c, "it holds solid elements (gmsh's type %d): a section's mesh is plane", t->type);
    }
    if (t->use == USE_PART) {
        return msh_fail(&r->c,
                        "elements of gmsh's type %d have no nodes inside: save the mesh with "
                        "Mesh.SecondOrderIncomplete = 0",
                        t->type);
    }
    if (t->use != USE_PASS && r->raw.order > 0 && r->raw.order != t->order) {
        return msh_fail(&r->c,
                        "an element of order %d comes after one of order %d: all have the "
                        "same",
                        t->order, r->raw.order);
    }
    *out = t;
    return OK;
}

// serendipity's middle: half the sides' middles, less a quarter of the corners
static status add_middle(msh_reader *r, int *conn)
{
    double x[3] = {0};
    for (int i = 0; i < 8; i++) {
        const double *y = r->raw.xyz + 3 * (size_t)conn[i];
        for (int d = 0; d < 3; d++) {
            x[d] += (i < 4 ? -0.25 : 0.5) * y[d];
        }
    }
    return msh_add_node(r, x, &conn[8]);
}

static status read_conn(msh_reader *r, const element_type *t, int *conn)
{
    status st = OK;
    for (int i = 0; i < t->nnode; i++) {
        int64_t node = 0;
        TRY(r->newer ? msh_size(&r->c, "an element's node", &node)
                     : msh_int(&r->c, "an element's node", &node));
        if (t->use == USE_PASS) {
            continue;
        }
        conn[i] = id_map_find(&r->nodes, node);
        if (conn[i] < 0) {
            TRY(msh_fail(&r->c, "there is no node %lld", (long long)node));
        }
    }

done:
    return st;
}

// its number has been read, its nodes follow
static status read_element(msh_reader *r, const element_type *t, int64_t id, int material)
{
    status st = OK;
    int conn[ELEMENT_MAX_PLANE_NODES];
    raw_mesh *m = &r->raw;
    TRY(read_conn(r, t, conn));
    if (t->use == USE_PASS || material == PART_NONE) {
        goto done;
    }
    const int n = element_node_count(t->shape, t->order);
    if (t->use == USE_NO_MIDDLE) {
        TRY(add_middle(r, conn));
    }
    TRY(msh_reserve((void **)&m->elem, &r->elem_room, (int64_t)m->nelem + 1, sizeof *m->elem));
    TRY(msh_reserve((void **)&m->conn, &r->conn_room, (int64_t)m->nconn + n, sizeof *m->conn));
    m->elem[m->nelem++] = (raw_element){
        .shape = t->shape, .first = m->nconn, .material = material, .frame = -1, .id = id};
    memcpy(m->conn + m->nconn, conn, (size_t)n * sizeof *conn);
    m->nconn += n;
    m->order = t->order;

done:
    return st;
}

// --- 4.1: blocks of a surface each

static status read_element_block(msh_reader *r, int *left)
{
    status st = OK;
    int64_t dim = 0, tag = 0, type = 0, id = 0;
    int count = 0, material = PART_NONE;
    const element_type *t = NULL;
    TRY(msh_int(&r->c, "the dimension of a block of elements", &dim));
    TRY(msh_int(&r->c, "the entity of a block of elements", &tag));
    TRY(msh_int(&r->c, "the type of a block of elements", &type));
    TRY(find_type(r, type, &t));
    TRY(msh_count(&r->c, "the number of elements of a block", true, 4, 16, &count));
    if (count > *left) {
        TRY(msh_fail(&r->c, "more elements come than are announced"));
    }
    *left -= count;
    if (t->use != USE_PASS && count > 0) {
        TRY(msh_surface_material(r, tag, &material));
    }
    for (int i = 0; i < count; i++) {
        TRY(msh_size(&r->c, "an element's number", &id));
        TRY(read_element(r, t, id, material));
    }

done:
    return st;
}

static status read_newer(msh_reader *r)
{
    status st = OK;
    int nblock = 0, left = 0;
    int64_t unused;
    TRY(msh_begin_numbers(r));
    TRY(msh_count(&r->c, "the number of blocks of elements", true, 8, 20, &nblock));
    TRY(msh_count(&r->c, "the number of elements", true, 4, 16, &left));
    TRY(msh_size(&r->c, "the least number of an element", &unused));
    TRY(msh_size(&r->c, "the largest number of an element", &unused));
    for (int b = 0; b < nblock; b++) {
        TRY(read_element_block(r, &left));
    }
    if (left != 0) {
        TRY(msh_fail(&r->c, "%d elements less come than are announced", left));
    }

done:
    return st;
}

// --- 2.2: each with its physical group; in a binary file in blocks of one type

static status read_tagged(msh_reader *r, const element_type *t, int64_t id, int64_t ntag)
{
    status st = OK;
    int64_t tag = 0, group = 0;
    int material = PART_NONE;
    for (int64_t k = 0; k < ntag; k++) {
        TRY(msh_int(&r->c, "an element's tag", &tag));
        group = k == 0 ? tag : group;
    }
    if (t->use != USE_PASS) {
        TRY(msh_group_material(r, group, &material));
    }
    TRY(read_element(r, t, id, material));

done:
    return st;
}

static status read_older_block(msh_reader *r, int *left)
{
    status st = OK;
    int64_t id = 0, type = 0, count = 1, ntag = 0;
    const element_type *t = NULL;
    if (!r->bytes) {
        TRY(msh_int(&r->c, "an element's number", &id));
    }
    TRY(msh_int(&r->c, "an element's type", &type));
    TRY(find_type(r, type, &t));
    if (r->bytes) {
        TRY(msh_int(&r->c, "the number of elements of a block", &count));
    }
    TRY(msh_int(&r->c, "an element's number of tags", &ntag));
    if (count < 1 || count > *left || ntag < 0) {
        TRY(msh_fail(&r->c, "%lld elements with %lld tags make no sense here", (long long)count,
                     (long long)ntag));
    }
    *left -= (int)count;
    for (int64_t i = 0; i < count; i++) {
        if (r->bytes) {
            TRY(msh_int(&r->c, "an element's number", &id));
        }
        TRY(read_tagged(r, t, id, ntag));
    }

done:
    return st;
}

static status read_older(msh_reader *r)
{
    status st = OK;
    int left = 0;
    TRY(msh_count(&r->c, "the number of elements", false, 8, 8, &left));
    TRY(msh_begin_numbers(r));
    while (left > 0) {
        TRY(read_older_block(r, &left));
    }

done:
    return st;
}

status msh_read_elements(msh_reader *r)
{
    status st = OK;
    int64_t *ids = NULL;
    int twice = -1;
    if (r->has_elements || !r->has_nodes) {
        TRY(msh_fail(&r->c, "$Elements comes %s", r->has_nodes ? "twice" : "before $Nodes"));
    }
    r->has_elements = true;
    TRY(r->newer ? read_newer(r) : read_older(r));
    const raw_mesh *m = &r->raw;
    TRY(memory_take((void **)&ids, (size_t)m->nelem, sizeof *ids));
    for (int i = 0; i < m->nelem; i++) {
        ids[i] = m->elem[i].id;
    }
    TRY(id_map_make(m->nelem, ids, &r->elements, &twice));
    if (twice >= 0) {
        TRY(msh_fail(&r->c, "two elements have the number %lld", (long long)ids[twice]));
    }

done:
    free(ids);
    return st;
}
