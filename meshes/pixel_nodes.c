#include "meshes/pixel_nodes.h"

#include "base/memory.h"

#include <stdint.h>
#include <string.h>

void straight_cells_free(straight_cells *c)
{
    free(c->xy);
    for (int k = 0; k < 2; k++) {
        free(c->corner[k]);
        free(c->material[k]);
    }
    *c = (straight_cells){0};
}

// --- sides, each once

typedef struct side_table {
    size_t room;   // a power of two
    uint64_t *key; // [room] both ends; 0: free
    int *number;   // [room]
    int count;
} side_table;

static void side_table_free(side_table *t)
{
    free(t->key);
    free(t->number);
    *t = (side_table){0};
}

static status side_table_make(size_t most, side_table *t)
{
    status st = OK;
    t->room = 16;
    while (t->room < 2 * most) {
        t->room *= 2;
    }
    TRY(TAKE(t->key, t->room));
    TRY(TAKE(t->number, t->room));

done:
    return st;
}

// the number of the side between two points
static int side_number(side_table *t, int a, int b)
{
    const uint64_t low = (uint64_t)(a < b ? a : b), high = (uint64_t)(a < b ? b : a);
    const uint64_t key = (high << 32) + low; // high >= 1: no key is 0
    size_t at = (size_t)((key * 0x9E3779B97F4A7C15u) >> 20) & (t->room - 1);
    while (t->key[at] != 0 && t->key[at] != key) {
        at = (at + 1) & (t->room - 1);
    }
    if (t->key[at] == 0) {
        t->key[at] = key;
        t->number[at] = t->count++;
    }
    return t->number[at];
}

// --- the nodes of one element

// Where a node of the lattice lies: at a corner, on side `k` from corner k at `step` 1..p-1, or
// inside.
typedef enum node_place { AT_CORNER, ON_SIDE, INSIDE } node_place;
typedef struct lattice_node {
    node_place place;
    int k, step;
} lattice_node;

static lattice_node quad_node(int p, int i, int j)
{
    const bool ends_i = i == 0 || i == p, ends_j = j == 0 || j == p;
    if (ends_i && ends_j) {
        return (lattice_node){AT_CORNER, j == 0 ? (i == p) : 2 + (i == 0), 0};
    }
    if (ends_j) {
        return (lattice_node){ON_SIDE, j == 0 ? 0 : 2, j == 0 ? i : p - i};
    }
    if (ends_i) {
        return (lattice_node){ON_SIDE, i == p ? 1 : 3, i == p ? j : p - j};
    }
    return (lattice_node){INSIDE, 0, 0};
}

static lattice_node triangle_node(int p, int i, int j)
{
    const int l = p - i - j;
    if (i == p || j == p || l == p) {
        return (lattice_node){AT_CORNER, i == p ? 1 : j == p ? 2 : 0, 0};
    }
    if (j == 0) {
        return (lattice_node){ON_SIDE, 0, i};
    }
    if (l == 0) {
        return (lattice_node){ON_SIDE, 1, j};
    }
    if (i == 0) {
        return (lattice_node){ON_SIDE, 2, l};
    }
    return (lattice_node){INSIDE, 0, 0};
}

static void lattice_of(shape s, int p, lattice_node *node)
{
    for (int j = 0; j <= p; j++) {
        for (int i = 0; i <= (s == SHAPE_QUAD ? p : p - j); i++) {
            *node++ = s == SHAPE_QUAD ? quad_node(p, i, j) : triangle_node(p, i, j);
        }
    }
}

// the point of a straight cell at reference coordinates, by its corners' bilinear or linear basis
static void place_node(const straight_cells *c, const int *corner, bool quad, const double *x,
                       double *xyz)
{
    const double u = (1 + x[0]) / 2, v = (1 + x[1]) / 2;
    const double four[4] = {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
    const double three[3] = {1 - x[0] - x[1], x[0], x[1]};
    xyz[0] = xyz[1] = xyz[2] = 0;
    for (int k = 0; k < (quad ? 4 : 3); k++) {
        const double w = quad ? four[k] : three[k];
        xyz[0] += w * c->xy[2 * corner[k]];
        xyz[1] += w * c->xy[2 * corner[k] + 1];
    }
}

// --- all of them

typedef struct numbering {
    const straight_cells *c;
    int order, first_side, next; // nodes of sides begin at first_side; inner ones come next
    side_table sides;
} numbering;

static int node_number(numbering *w, const int *corner, int nside, lattice_node n)
{
    const int a = corner[n.k], b = corner[(n.k + 1) % nside];
    if (n.place == AT_CORNER) {
        return a;
    }
    if (n.place == INSIDE) {
        return w->next++;
    }
    const int step = a < b ? n.step - 1 : w->order - 1 - n.step;
    return w->first_side + side_number(&w->sides, a, b) * (w->order - 1) + step;
}

static void count_sides(numbering *w)
{
    for (int kind = 0; kind < 2; kind++) {
        const int nside = 3 + kind;
        for (int e = 0; e < w->c->ncell[kind]; e++) {
            const int *corner = w->c->corner[kind] + (size_t)e * (size_t)nside;
            for (int k = 0; k < nside; k++) {
                (void)side_number(&w->sides, corner[k], corner[(k + 1) % nside]);
            }
        }
    }
}

static status fill_block(numbering *w, int kind, mesh *m, mesh_block *b)
{
    status st = OK;
    element e = {0};
    lattice_node lattice[ELEMENT_MAX_PLANE_NODES];
    const int nside = 3 + kind;

    TRY(element_make(b->shape, w->order, &e));
    lattice_of(b->shape, w->order, lattice);
    for (int i = 0; i < b->nelem; i++) {
        const int *corner = w->c->corner[kind] + (size_t)i * (size_t)nside;
        int *conn = b->conn + (size_t)i * (size_t)b->per_elem;
        for (int k = 0; k < e.nnode; k++) {
            conn[k] = node_number(w, corner, nside, lattice[k]);
            place_node(w->c, corner, kind == 1, e.node[k], m->xyz + 3 * (size_t)conn[k]);
        }
    }
    memcpy(b->material, w->c->material[kind], (size_t)b->nelem * sizeof *b->material);

done:
    return st;
}

status straight_cells_mesh(const straight_cells *c, int order, mesh *out)
{
    status st = OK;
    static const shape shapes[2] = {SHAPE_TRIANGLE, SHAPE_QUAD};
    numbering w = {.c = c, .order = order, .first_side = c->npoint};
    mesh m = {0};
    shape used[2];
    int nelem[2], kind[2], nblock = 0, inner = 0;

    TRY(side_table_make(3 * (size_t)c->ncell[0] + 4 * (size_t)c->ncell[1], &w.sides));
    count_sides(&w);
    for (int k = 1; k >= 0; k--) {
        const int on_boundary = (3 + k) * order;
        if (c->ncell[k] > 0) {
            inner += c->ncell[k] * (element_node_count(shapes[k], order) - on_boundary);
            used[nblock] = shapes[k];
            nelem[nblock] = c->ncell[k];
            kind[nblock++] = k;
        }
    }
    w.next = c->npoint + w.sides.count * (order - 1);
    TRY(mesh_make(order, w.next + inner, nblock, used, nelem, &m));
    for (int b = 0; b < nblock; b++) {
        TRY(fill_block(&w, kind[b], &m, &m.block[b]));
    }
    *out = m;
    m = (mesh){0};

done:
    side_table_free(&w.sides);
    mesh_free(&m);
    return st;
}
