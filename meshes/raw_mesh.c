// meshes/raw_mesh.c
#include "meshes/raw_mesh.h"

#include "base/memory.h"
#include "meshes/raw_check.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void raw_mesh_free(raw_mesh *r)
{
    free(r->xyz);
    free(r->exact);
    free(r->node_id);
    free(r->elem);
    free(r->conn);
    free(r->frame);
    *r = (raw_mesh){0};
}

// --- gmsh's order of nodes

static int lattice_index(shape shape, int p, int i, int j)
{
    return shape == SHAPE_QUAD ? i + (p + 1) * j : i + j * (p + 1) - j * (j - 1) / 2;
}

// One ring: its corners, then what lies between them; (i, j) from the ring's own corner.
static int ring(shape shape, int p, int inset, int q, int *lattice)
{
    const int quad[4][2] = {{0, 0}, {q, 0}, {q, q}, {0, q}};
    const int triangle[3][2] = {{0, 0}, {q, 0}, {0, q}};
    const int(*corner)[2] = shape == SHAPE_QUAD ? quad : triangle;
    const int n = shape == SHAPE_QUAD ? 4 : 3;
    int count = 0;
    if (q == 0) {
        lattice[0] = lattice_index(shape, p, inset, inset);
        return 1;
    }
    for (int k = 0; k < n; k++) {
        lattice[count++] = lattice_index(shape, p, inset + corner[k][0], inset + corner[k][1]);
    }
    for (int k = 0; k < n; k++) {
        const int *a = corner[k], *b = corner[(k + 1) % n];
        for (int t = 1; t < q; t++) {
            lattice[count++] = lattice_index(shape, p, inset + a[0] + t * (b[0] - a[0]) / q,
                                             inset + a[1] + t * (b[1] - a[1]) / q);
        }
    }
    return count;
}

void raw_lattice(shape shape, int order, int *lattice)
{
    const int step = shape == SHAPE_QUAD ? 2 : 3;
    int count = 0;
    for (int inset = 0, q = order; q >= 0; inset++, q -= step) {
        count += ring(shape, order, inset, q, lattice + count);
    }
}

// --- places of our nodes from gmsh's

typedef struct placement {
    element e;
    int lattice[ELEMENT_MAX_PLANE_NODES];                      // of gmsh's nodes
    double edge[ELEMENT_MAX_ORDER + 1][ELEMENT_MAX_ORDER + 1]; // [node of ours][node of gmsh's]
    double inside[ELEMENT_MAX_PLANE_NODES][ELEMENT_MAX_PLANE_NODES]; // both in the lattice's order
} placement;

// Lagrange polynomials on p + 1 equally spaced nodes of [0, 1]
static void equal_basis(int p, double t, double *N)
{
    for (int i = 0; i <= p; i++) {
        N[i] = 1;
        for (int k = 0; k <= p; k++) {
            N[i] *= k == i ? 1 : (p * t - k) / (i - k);
        }
    }
}

// Silvester's factor: of degree m, zero at the first m nodes, 1 at t = m / p
static double silvester(int p, int m, double t)
{
    double R = 1;
    for (int a = 0; a < m; a++) {
        R *= (p * t - a) / (a + 1);
    }
    return R;
}

static void inner_row(const element *e, const double *x, double *row)
{
    const int p = e->order;
    double a[ELEMENT_MAX_ORDER + 1], b[ELEMENT_MAX_ORDER + 1];
    if (e->shape == SHAPE_TRIANGLE) {
        for (int j = 0, n = 0; j <= p; j++) {
            for (int i = 0; i <= p - j; i++, n++) {
                row[n] = silvester(p, i, x[0]) * silvester(p, j, x[1]) *
                         silvester(p, p - i - j, 1 - x[0] - x[1]);
            }
        }
        return;
    }
    equal_basis(p, (x[0] + 1) / 2, a);
    equal_basis(p, (x[1] + 1) / 2, b);
    for (int n = 0; n < e->nnode; n++) {
        row[n] = a[n % (p + 1)] * b[n / (p + 1)];
    }
}

static status placement_make(shape shape, int order, placement *out)
{
    status st = OK;
    TRY(element_make(shape, order, &out->e));
    raw_lattice(shape, order, out->lattice);
    for (int i = 0; i <= order; i++) {
        equal_basis(order, (out->e.line_node[i] + 1) / 2, out->edge[i]);
    }
    for (int i = 0; i < out->e.nnode; i++) {
        inner_row(&out->e, out->e.node[i], out->inside[i]);
    }

done:
    return st;
}

typedef struct finish {
    const raw_mesh *r;
    placement kind[2]; // triangle, quad
    bool *turned;      // [nelem] seen from below
    int *number;       // [nnode] of ours, -1 where unused
    bool *placed;      // [nnode] of gmsh's
    mesh m;
} finish;

static placement *kind_of(finish *f, shape shape)
{
    return &f->kind[shape == SHAPE_QUAD];
}

// an element's nodes in our lattice's order, turned over where needed
static void ordered(finish *f, int elem, int *node)
{
    const raw_element *e = &f->r->elem[elem];
    const placement *k = kind_of(f, e->shape);
    const int p = f->r->order, *conn = f->r->conn + e->first;
    int straight[ELEMENT_MAX_PLANE_NODES];
    for (int i = 0; i < k->e.nnode; i++) {
        straight[k->lattice[i]] = conn[i];
    }
    for (int j = 0, n = 0; j <= p; j++) {
        for (int i = 0; i <= (e->shape == SHAPE_QUAD ? p : p - j); i++, n++) {
            node[n] = straight[f->turned[elem] ? lattice_index(e->shape, p, j, i) : n];
        }
    }
}

static void put(finish *f, int node, int n, const int *from, const double *weight)
{
    double *to = f->m.xyz + 3 * (size_t)f->number[node];
    to[0] = to[1] = 0;
    for (int i = 0; i < n; i++) {
        const double *x = f->r->xyz + 3 * (size_t)from[i];
        to[0] += weight[i] * x[0] * f->r->unit;
        to[1] += weight[i] * x[1] * f->r->unit;
    }
    f->placed[node] = true;
}

static void put_exact(finish *f, int node)
{
    const double *x = f->r->exact ? f->r->exact + 3 * (size_t)node : NULL;
    for (int d = 0; x && isfinite(x[0] + x[1]) && d < 2; d++) {
        f->m.xyz[3 * (size_t)f->number[node] + (size_t)d] = x[d] * f->r->unit;
    }
}

// Up to order 2 the nodes are the same. Above, those of an edge follow from the edge's alone, and
// only the first element that has it places them: neighbours stay together to the last bit.
static void place_edges(finish *f, shape shape, const int *node)
{
    const int p = f->r->order;
    const int quad[4][2] = {{0, 0}, {p, 0}, {p, p}, {0, p}};
    const int triangle[3][2] = {{0, 0}, {p, 0}, {0, p}};
    const int(*corner)[2] = shape == SHAPE_QUAD ? quad : triangle;
    const int n = shape == SHAPE_QUAD ? 4 : 3;
    for (int k = 0; k < n; k++) {
        const int *a = corner[k], *b = corner[(k + 1) % n];
        int line[ELEMENT_MAX_ORDER + 1];
        for (int t = 0; t <= p; t++) {
            line[t] = node[lattice_index(shape, p, a[0] + t * (b[0] - a[0]) / p,
                                         a[1] + t * (b[1] - a[1]) / p)];
        }
        for (int t = 0; t <= p; t++) {
            if (!f->placed[line[t]]) {
                put(f, line[t], p + 1, line, kind_of(f, shape)->edge[t]);
                put_exact(f, line[t]);
            }
        }
    }
}

static void place_element(finish *f, shape shape, const int *node)
{
    const placement *k = kind_of(f, shape);
    if (f->r->order > 2) {
        place_edges(f, shape, node);
    }
    for (int i = 0; i < k->e.nnode; i++) {
        const double one = 1;
        if (!f->placed[node[i]] && f->r->order <= 2) {
            put(f, node[i], 1, &node[i], &one);
        } else if (!f->placed[node[i]]) {
            put(f, node[i], k->e.nnode, node, k->inside[i]);
        }
    }
}

// --- all of it

static status number_nodes(finish *f, int *count)
{
    status st = OK;
    const raw_mesh *r = f->r;
    TRY(TAKE(f->number, (size_t)r->nnode));
    TRY(TAKE(f->placed, (size_t)r->nnode));
    for (int i = 0; i < r->nconn; i++) {
        f->number[r->conn[i]] = 1;
    }
    *count = 0;
    for (int i = 0; i < r->nnode; i++) {
        f->number[i] = f->number[i] ? (*count)++ : -1;
    }

done:
    return st;
}

static status make_blocks(finish *f, int nnode)
{
    status st = OK;
    const raw_mesh *r = f->r;
    int count[2] = {0}, nblock = 0, block_of[2] = {0}, nelem[2];
    shape shapes[2];
    for (int e = 0; e < r->nelem; e++) {
        count[r->elem[e].shape == SHAPE_QUAD]++;
    }
    for (int k = 0; k < 2; k++) {
        const shape s = k ? SHAPE_QUAD : SHAPE_TRIANGLE;
        if (count[k] > 0) {
            TRY(placement_make(s, r->order, &f->kind[k]));
            block_of[k] = nblock;
            shapes[nblock] = s;
            nelem[nblock++] = count[k];
        }
    }
    TRY(mesh_make(r->order, nnode, nblock, shapes, nelem, &f->m));
    if (r->nframe > 0) {
        TRY(mesh_take_frames(&f->m, r->nframe));
        memcpy(f->m.frame, r->frame, (size_t)r->nframe * sizeof *r->frame);
    }
    count[0] = count[1] = 0;
    for (int e = 0; e < r->nelem; e++) {
        const raw_element *from = &r->elem[e];
        const int k = from->shape == SHAPE_QUAD, at = count[k]++;
        mesh_block *b = &f->m.block[block_of[k]];
        int *conn = b->conn + (size_t)at * (size_t)b->per_elem;
        ordered(f, e, conn);
        place_element(f, from->shape, conn);
        for (int i = 0; i < b->per_elem; i++) {
            conn[i] = f->number[conn[i]];
        }
        b->material[at] = from->material;
        if (r->nframe > 0) {
            b->frame[at] = from->frame;
        }
    }

done:
    return st;
}

status raw_mesh_make(const raw_mesh *r, mesh *out)
{
    status st = OK;
    finish f = {.r = r};
    int nnode = 0;

    if (r->nelem < 1) {
        TRY(input_file_fail(r->file, 0, "no element belongs to a material"));
    }
    TRY(raw_check_plane(r));
    TRY(TAKE(f.turned, (size_t)r->nelem));
    TRY(raw_check_turns(r, f.turned));
    TRY(raw_check_edges(r, f.turned));
    TRY(number_nodes(&f, &nnode));
    TRY(make_blocks(&f, nnode));
    *out = f.m;
    f.m = (mesh){0};

done:
    free(f.turned);
    free(f.number);
    free(f.placed);
    mesh_free(&f.m);
    return st;
}

// mesh_check speaks of our own numbers; what it found is the file's fault
static status check(const raw_mesh *r, const mesh *m)
{
    char words[300];
    const status st = mesh_check(m);
    if (st != ERR_NUMERIC) {
        return st;
    }
    (void)snprintf(words, sizeof words, "%s", status_message());
    status_clear();
    return input_file_fail(r->file, 0, "%s", words);
}

status raw_mesh_finish(const raw_mesh *r, mesh *out)
{
    status st = OK;
    mesh m = {0};
    TRY(raw_mesh_make(r, &m));
    TRY(check(r, &m));
    *out = m;
    m = (mesh){0};

done:
    mesh_free(&m);
    return st;
}
