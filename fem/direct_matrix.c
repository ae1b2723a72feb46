// fem/direct_matrix.c
#include "fem/direct_matrix.h"

#include "base/memory.h"
#include "fem/brick.h"

#include <string.h>

typedef struct builder {
    const petsc_door *door;
    const unknowns *u;
    direct_matrix out;
    brick *brick;
    double *K;    // of one element
    double *tied; // the same with the tip's nodes tied to the cap
    double *r;    // forces of its nodes where holds move
} builder;

// Nodes of one element: plane nodes `node` on `nlevel` levels from `level`, the highest last.
typedef struct element_nodes {
    const int *node;
    int nplane, level, nlevel;
} element_nodes;

static void builder_free(builder *a)
{
    brick_free(a->brick);
    free(a->K);
    free(a->tied);
    free(a->r);
    free(a->out.moved);
}

// --- held directions

static double motion_of(const unknowns *u, int node, int level, int d)
{
    return unknowns_is_held(u, node, level, d)
               ? u->motion[3 * unknowns_index(u, node, level) + (size_t)d]
               : 0;
}

// what nodes feel where held directions move
static void add_moved(builder *a, const element_nodes *e, bool own_layer)
{
    const int n = 3 * e->nplane * e->nlevel;
    memset(a->r, 0, (size_t)n * sizeof *a->r);
    for (int c = 0; c < n; c++) {
        const int i = c / 3;
        const double m = motion_of(a->u, e->node[i % e->nplane], e->level + i / e->nplane, c % 3);
        for (int r = 0; m != 0 && r < n; r++) {
            a->r[r] += a->K[(size_t)c * (size_t)n + (size_t)r] * m;
        }
    }
    for (int i = 0; i < e->nplane * e->nlevel; i++) {
        const int node = e->node[i % e->nplane], level = e->level + i / e->nplane;
        unknowns_add_force(a->u, node, level, a->r + 3 * i, a->out.moved);
        for (int d = 0; own_layer && d < 3; d++) {
            a->out.held_work += motion_of(a->u, node, level, d) * a->r[3 * i + d];
        }
    }
}

// held unknowns keep their diagonal only, so that the matrix stays positive definite and its blocks
// whole
static void hold(builder *a, const element_nodes *e)
{
    const int n = 3 * e->nplane * e->nlevel;
    for (int r = 0; r < n; r++) {
        const int i = r / 3;
        if (!unknowns_is_held(a->u, e->node[i % e->nplane], e->level + i / e->nplane, r % 3)) {
            continue;
        }
        const double keep = a->K[r * n + r];
        for (int c = 0; c < n; c++) {
            a->K[r * n + c] = a->K[c * n + r] = 0;
        }
        a->K[r * n + r] = keep;
    }
}

static bool any_held(const unknowns *u, const element_nodes *e)
{
    for (int i = 0; u->held && i < e->nplane * e->nlevel; i++) {
        if (u->held[unknowns_index(u, e->node[i % e->nplane], e->level + i / e->nplane)]) {
            return true;
        }
    }
    return false;
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

// T^T K T: the nodes of the last level become the two blocks of the cap. (5.7)
static void tie_to_cap(builder *a, const element_nodes *e)
{
    const int n = e->nplane, all = 3 * n * e->nlevel, kept = all - 3 * n, size = kept + 6;
    double T[ELEMENT_MAX_PLANE_NODES][3][6], part[6];
    for (int i = 0; i < n; i++) {
        unknowns_cap_motion(a->u, e->node[i], T[i]);
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

static status add(builder *a, const element_nodes *e, bool own_layer)
{
    int block[BRICK_MAX_NODES + 2];
    const int n = e->nplane * e->nlevel, kept = n - e->nplane;
    if (any_held(a->u, e)) {
        if (a->u->motion) {
            add_moved(a, e, own_layer);
        }
        hold(a, e);
    }
    for (int i = 0; i < n; i++) {
        block[i] = unknowns_block(a->u, e->node[i % e->nplane], e->level + i / e->nplane);
    }
    if (!unknowns_follow_cap(a->u, e->level + e->nlevel - 1)) {
        return a->door->matrix_add(a->out.matrix, n, block, a->K);
    }
    tie_to_cap(a, e);
    block[kept] = a->u->cap_block;
    block[kept + 1] = a->u->cap_block + 1;
    return a->door->matrix_add(a->out.matrix, kept + 2, block, a->tied);
}

static status add_brick(builder *a, int block, int e, int layer)
{
    status st = OK;
    const body *b = a->u->body;
    const mesh_block *k = &b->plane->block[block];
    const element_nodes nodes = {.node = k->conn + (size_t)e * (size_t)k->per_elem,
                                 .nplane = k->per_elem,
                                 .level = layer * b->order,
                                 .nlevel = b->order + 1};
    TRY(brick_stiffness(a->brick, layer, a->K));
    TRY(add(a, &nodes, layer >= a->u->share.first_layer));

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
    const petsc_pattern wanted = {.nblock = u->nblock,
                                  .first = u->first,
                                  .last = u->last,
                                  .nabove = unknowns_above(u),
                                  .diagonal = own,
                                  .beyond = beyond};
    TRY(a->door->matrix_make(&wanted, &a->out.matrix));

done:
    free(own);
    free(beyond);
    return st;
}

static status take_room(builder *a)
{
    status st = OK;
    const size_t dofs = BRICK_MAX_DOFS, rows = (size_t)(a->u->last - a->u->first);
    TRY(brick_make(a->u->body, &a->brick));
    TRY(TAKE(a->K, dofs * dofs));
    TRY(TAKE(a->tied, dofs * dofs)); // the cap has six unknowns, a plane element nine or more
    TRY(TAKE(a->r, dofs));
    if (a->u->motion) {
        TRY(TAKE(a->out.moved, 3 * rows));
    }

done:
    return st;
}

status direct_matrix_make(const petsc_door *door, const segment_problem *p, const unknowns *u,
                          direct_matrix *out)
{
    status st = OK;
    builder a = {.door = door, .u = u};
    (void)p;
    TRY(door->agree(take_room(&a)));
    TRY(make_matrix(&a));
    TRY(door->agree(add_bricks(&a)));
    *out = a.out;
    a.out = (direct_matrix){0};

done:
    if (a.out.matrix) {
        door->matrix_free(a.out.matrix);
    }
    builder_free(&a);
    return st;
}
