// fem/body_place.c
#include "fem/body_place.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

static status place_level(body *b, int level)
{
    const body_shape *shape = &b->spec.shape;
    const double s = b->level[level];
    const size_t k = (size_t)(level - b->first), n = (size_t)b->plane->nnode;
    double *xyz = b->node + 3 * k * n;
    if (shape->place) {
        return shape->place(shape->self, s, xyz, &b->axes[k], b->origin[k]);
    }
    const mat3 turn = mat3_rot_z(b->spec.turn_rate * s);
    for (size_t i = 0; i < n; i++) {
        const double *from = b->plane->xyz + 3 * i;
        const vec3 x = mat3_mul_vec(turn, (vec3){{from[0], from[1], 0}});
        memcpy(xyz + 3 * i, x.a, sizeof x.a);
        xyz[3 * i + 2] = s;
    }
    b->axes[k] = turn;
    memcpy(b->origin[k], (const double[3]){0, 0, s}, sizeof b->origin[k]);
    return OK;
}

status body_place(body *b)
{
    status st = OK;
    const size_t held = (size_t)(b->last - b->first);
    TRY(TAKE(b->node, 3 * held * (size_t)b->plane->nnode));
    TRY(TAKE(b->axes, held));
    TRY(TAKE(b->origin, held));
    for (int level = b->first; level < b->last; level++) {
        TRY(place_level(b, level));
    }

done:
    return st;
}

// --- det J > 0 at the nodes

typedef struct node_slopes {
    double plane[ELEMENT_MAX_PLANE_NODES][2 * ELEMENT_MAX_PLANE_NODES];
    double line[ELEMENT_MAX_ORDER + 1][ELEMENT_MAX_ORDER + 1];
} node_slopes;

static double det_at(const body *b, const int *conn, int n, int level, int a, int k,
                     const node_slopes *d)
{
    double x[3], J[3][3] = {{0}};
    for (int i = 0; i < n; i++) {
        body_node(b, conn[i], level + k, x);
        for (int r = 0; r < 3; r++) {
            J[0][r] += d->plane[a][2 * i] * x[r];
            J[1][r] += d->plane[a][2 * i + 1] * x[r];
        }
    }
    for (int i = 0; i <= b->order; i++) {
        body_node(b, conn[a], level + i, x);
        for (int r = 0; r < 3; r++) {
            J[2][r] += d->line[k][i] * x[r];
        }
    }
    const vec3 u = {{J[0][0], J[0][1], J[0][2]}}, v = {{J[1][0], J[1][1], J[1][2]}},
               w = {{J[2][0], J[2][1], J[2][2]}};
    return vec3_dot(vec3_cross(u, v), w);
}

static status check_element(const body *b, const int *conn, int n, int layer, const node_slopes *d)
{
    const int level = layer * b->order;
    for (int k = 0; k <= b->order; k++) {
        for (int a = 0; a < n; a++) {
            if (!(det_at(b, conn, n, level, a, k, d) > 0)) {
                double x[3];
                body_node(b, conn[a], level + k, x);
                return status_fail(ERR_INPUT,
                                   "segment: the body folds over itself at s = %.6g mm, near x = "
                                   "%.6g mm, y = %.6g mm, z = %.6g mm",
                                   1e3 * b->level[level + k], 1e3 * x[0], 1e3 * x[1], 1e3 * x[2]);
            }
        }
    }
    return OK;
}

static status check_block(const body *b, const mesh_block *block, node_slopes *d)
{
    status st = OK;
    element e = {0};
    double N[ELEMENT_MAX_PLANE_NODES];
    TRY(element_make(block->shape, b->plane->order, &e));
    for (int i = 0; i < e.nnode; i++) {
        element_basis(&e, e.node[i], N, d->plane[i]);
    }
    for (int k = 0; k <= b->order; k++) {
        element_basis(&b->line, b->line.node[k], N, d->line[k]);
    }
    for (int layer = 0; layer < b->nlayer; layer++) {
        if (layer * b->order < b->first || (layer + 1) * b->order >= b->last) {
            continue;
        }
        for (int k = 0; k < block->nelem; k++) {
            const int *conn = block->conn + (size_t)k * (size_t)block->per_elem;
            if (body_material(b, (int)(block - b->plane->block), k, layer) >= 0) {
                TRY(check_element(b, conn, block->per_elem, layer, d));
            }
        }
    }

done:
    return st;
}

status body_check(const body *b)
{
    status st = OK;
    node_slopes *d = NULL;
    TRY(TAKE(d, 1));
    for (int k = 0; k < b->plane->nblock; k++) {
        TRY(check_block(b, &b->plane->block[k], d));
    }

done:
    free(d);
    return st;
}

// --- the pose within a layer

// nearest rotation to a matrix close to one: Newton's iteration for the polar factor
static mat3 orthonormal(mat3 A)
{
    for (int step = 0; step < 4; step++) {
        const mat3 AtA = mat3_mul(mat3_transpose(A), A);
        mat3 C = {0};
        for (int i = 0; i < 9; i++) {
            C.a[i / 3][i % 3] = ((i % 4 == 0 ? 3 : 0) - AtA.a[i / 3][i % 3]) / 2;
        }
        A = mat3_mul(A, C);
    }
    return A;
}

void body_pose_at(const body *b, int layer, double at, mat3 *axes, double origin[3])
{
    double N[ELEMENT_MAX_ORDER + 1], dN[ELEMENT_MAX_ORDER + 1];
    element_basis(&b->line, &at, N, dN);
    mat3 A = {0};
    memset(origin, 0, 3 * sizeof *origin);
    for (int k = 0; k <= b->order; k++) {
        const mat3 R = body_axes(b, layer * b->order + k);
        double o[3];
        body_origin(b, layer * b->order + k, o);
        for (int i = 0; i < 3; i++) {
            origin[i] += N[k] * o[i];
            for (int j = 0; j < 3; j++) {
                A.a[i][j] += N[k] * R.a[i][j];
            }
        }
    }
    *axes = b->prism ? mat3_identity() : orthonormal(A);
}
