// fem/direct_matrix.c
#include "fem/direct_matrix.h"

#include "base/memory.h"
#include "fem/brick.h"
#include "fem/face.h"

#include <string.h>

typedef struct builder {
    const petsc_door *door;
    const segment_problem *p;
    const unknowns *u;
    petsc_matrix *matrix;
    brick *brick;
    double *K;    // of one element
    double *tied; // the same with the tip's nodes tied to the cap
} builder;

// Nodes of one element; those of the tip are the last.
typedef struct element_nodes {
    int n;
    int node[BRICK_MAX_NODES], level[BRICK_MAX_NODES]; // of the plane mesh
} element_nodes;

static void builder_free(builder *a)
{
    brick_free(a->brick);
    free(a->K);
    free(a->tied);
}

// --- held directions

// held unknowns keep their diagonal only, so that the matrix stays positive definite and its blocks
// whole
static void hold(const unknowns *u, const element_nodes *e, double *K)
{
    const int n = 3 * e->n;
    for (int r = 0; u->held && r < n; r++) {
        if (!unknowns_is_held(u, e->node[r / 3], e->level[r / 3], r % 3)) {
            continue;
        }
        const double keep = K[r * n + r];
        for (int c = 0; c < n; c++) {
            K[r * n + c] = K[c * n + r] = 0;
        }
        K[r * n + r] = keep;
    }
}

// --- the cap

// row [3 n] times the cap's motion of the n tip nodes
static void tie_row(const double *row, int n, const double (*T)[3][6], double *out)
{
    memset(out, 0, 6 * sizeof *out);
    for (int a = 0; a < n; a++) {
        for (int c = 0; c < 6; c++) {
            out[c] +=
                row[3 * a] * T[a][0][c] + row[3 * a + 1] * T[a][1][c] + row[3 * a + 2] * T[a][2][c];
        }
    }
}

// T^T K T: the last n nodes become the two blocks of the cap. (5.7)
static void tie_to_cap(builder *a, const element_nodes *e, int n)
{
    const int all = 3 * e->n, kept = all - 3 * n, size = kept + 6;
    double T[ELEMENT_MAX_PLANE_NODES][3][6], part[6];
    for (int i = 0; i < n; i++) {
        unknowns_cap_motion(a->u, e->node[e->n - n + i], T[i]);
    }
    memset(a->tied, 0, (size_t)size * (size_t)size * sizeof *a->tied);
    for (int r = 0; r < all; r++) {
        const double *row = a->K + (size_t)r * (size_t)all;
        tie_row(row + kept, n, (const double(*)[3][6])T, part);
        if (r < kept) {
            memcpy(a->tied + r * size, row, (size_t)kept * sizeof *row);
            for (int c = 0; c < 6; c++) {
                a->tied[r * size + kept + c] = a->tied[(kept + c) * size + r] = part[c];
            }
            continue;
        }
        const int i = (r - kept) / 3, d = (r - kept) % 3;
        for (int b = 0; b < 6; b++) {
            for (int c = 0; c < 6; c++) {
                a->tied[(kept + b) * size + kept + c] += T[i][d][b] * part[c];
            }
        }
    }
}

// --- elements

static status add(builder *a, const element_nodes *e)
{
    int block[BRICK_MAX_NODES + 2], capped = 0;
    hold(a->u, e, a->K);
    for (int i = 0; i < e->n; i++) {
        block[i] = unknowns_block(a->u, e->node[i], e->level[i]);
        capped += unknowns_follow_cap(a->u, e->level[i]);
    }
    if (!capped) {
        return a->door->matrix_add(a->matrix, e->n, block, a->K);
    }
    tie_to_cap(a, e, capped);
    const int kept = e->n - capped;
    block[kept] = a->u->cap_block;
    block[kept + 1] = a->u->cap_block + 1;
    return a->door->matrix_add(a->matrix, kept + 2, block, a->tied);
}

static status add_brick(builder *a, int block, int e, int layer)
{
    status st = OK;
    const body *b = a->u->body;
    const mesh_block *k = &b->plane->block[block];
    element_nodes nodes = {.n = k->per_elem * (b->order + 1)};
    for (int i = 0; i < nodes.n; i++) {
        nodes.node[i] = k->conn[e * k->per_elem + i % k->per_elem];
        nodes.level[i] = layer * b->order + i / k->per_elem;
    }
    TRY(brick_stiffness(a->brick, layer, a->K));
    TRY(add(a, &nodes));

done:
    return st;
}

// the layer below this rank's first adds to its rows too
static status add_bricks(builder *a)
{
    status st = OK;
    const body *b = a->u->body;
    const int first = a->u->share.from / b->order, last = a->u->share.last_layer;
    for (int block = 0; block < b->plane->nblock; block++) {
        for (int e = 0; e < b->plane->block[block].nelem; e++) {
            TRY(brick_stand_on(a->brick, block, e));
            for (int layer = first; layer < last; layer++) {
                if (body_material(b, block, e, layer) >= 0) {
                    TRY(add_brick(a, block, e, layer));
                }
            }
        }
    }

done:
    return st;
}

// --- springs

typedef struct spring_adder {
    builder *a;
    const face_spring *spring;
} spring_adder;

static status add_patch(void *self, const face_patch *p)
{
    const spring_adder *s = (const spring_adder *)self;
    element_nodes nodes = {.n = p->nnode};
    for (int i = 0; i < p->nnode; i++) {
        nodes.node[i] = p->plane_node[i];
        nodes.level[i] = p->level[i];
    }
    face_spring_matrix(p, s->spring, s->a->K);
    return add(s->a, &nodes);
}

static status add_springs(builder *a)
{
    status st = OK;
    const body *b = a->u->body;
    const int first = a->u->share.from / b->order, last = a->u->share.last_layer;
    for (int i = 0; i < a->p->nspring; i++) {
        spring_adder s = {a, &a->p->spring[i]};
        TRY(face_check(b, &s.spring->on));
        TRY(face_walk(b, &s.spring->on, first, last, add_patch, &s));
    }

done:
    return st;
}

static status add_all(builder *a)
{
    status st = OK;
    TRY(add_bricks(a));
    TRY(add_springs(a));

done:
    return st;
}

// --- the whole

static status pattern(const unknowns *u, int **own, int **beyond)
{
    status st = OK;
    const size_t nrow = (size_t)(u->last - u->first);
    TRY(TAKE(*own, nrow));
    TRY(TAKE(*beyond, nrow));
    TRY(unknowns_pattern(u, *own, *beyond));

done:
    return st;
}

static status make_matrix(builder *a)
{
    status st = OK;
    int *own = NULL, *beyond = NULL;
    const unknowns *u = a->u;
    TRY(a->door->agree(pattern(u, &own, &beyond)));
    const petsc_pattern wanted = {
        .nblock = u->nblock, .first = u->first, .last = u->last, .diagonal = own, .beyond = beyond};
    TRY(a->door->matrix_make(&wanted, &a->matrix));

done:
    free(own);
    free(beyond);
    return st;
}

static status take_room(builder *a)
{
    status st = OK;
    const size_t dofs = BRICK_MAX_DOFS;
    TRY(brick_make(a->u->body, &a->brick));
    TRY(TAKE(a->K, dofs * dofs));
    TRY(TAKE(a->tied, dofs * dofs)); // the cap has six unknowns, a plane element nine or more

done:
    return st;
}

status direct_matrix_make(const petsc_door *door, const segment_problem *p, const unknowns *u,
                          petsc_matrix **out)
{
    status st = OK;
    builder a = {.door = door, .p = p, .u = u};
    TRY(door->agree(take_room(&a)));
    TRY(make_matrix(&a));
    TRY(door->agree(add_all(&a)));
    *out = a.matrix;
    a.matrix = NULL;

done:
    if (a.matrix) {
        door->matrix_free(a.matrix);
    }
    builder_free(&a);
    return st;
}
