// fem/assembly.c
#include "fem/assembly.h"

#include "base/memory.h"

#include <string.h>

typedef struct assembler {
    const petsc_door *door;
    const column *column;
    const supports *supports;
    supports_share share;
    petsc_matrix *matrix;
    plane_matrices *plane;
    double *K;      // of one element
    double *capped; // the same with the tip nodes tied to the cap
} assembler;

static void assembler_free(assembler *a)
{
    free(a->plane);
    free(a->K);
    free(a->capped);
    *a = (assembler){0};
}

// held unknowns keep their diagonal only, so that the matrix stays positive definite and its blocks
// whole
static void hold(const supports *s, const int *conn, int n, int stride, double *K)
{
    for (int a = 0; a < n; a++) {
        for (int d = 0; d < 3; d++) {
            if (!supports_is_held(s, conn[a], 0, d)) {
                continue;
            }
            const int r = 3 * a + d;
            const double keep = K[r * stride + r];
            for (int i = 0; i < stride; i++) {
                K[r * stride + i] = K[i * stride + r] = 0;
            }
            K[r * stride + r] = keep;
        }
    }
}

// motion of a tip node at (x, y) by the cap's six unknowns, rows by direction. docs/theory.md (5.7)
static void cap_motion(const supports *s, const double *x, double (*T)[6])
{
    const double px = x[0] / s->radius, py = x[1] / s->radius;
    const double motion[3][6] = {{1, 0, 0, 0, 0, -py}, {0, 1, 0, 0, 0, px}, {0, 0, 1, py, -px, 0}};
    memcpy(T, motion, sizeof motion);
}

// T^T K T: the last n nodes become the two blocks of the cap
static void tie_to_cap(const supports *s, const mesh *plane, const int *conn, int n, int stride,
                       double *K, double *out)
{
    const int kept = stride - 3 * n, size = kept + 6;
    memset(out, 0, (size_t)size * (size_t)size * sizeof *out);
    for (int r = 0; r < kept; r++) {
        memcpy(out + r * size, K + r * stride, (size_t)kept * sizeof *out);
    }
    for (int a = 0; a < n; a++) {
        double T[3][6];
        cap_motion(s, plane->xyz + 3 * (size_t)conn[a], T);
        // columns: K T into the first six of this element's tip columns, summed over its nodes
        for (int r = 0; r < stride; r++) {
            const double *from = K + r * stride + kept + 3 * a;
            const int node = (r - kept) / 3;
            double row[6] = {0};
            for (int c = 0; c < 6; c++) {
                row[c] = from[0] * T[0][c] + from[1] * T[1][c] + from[2] * T[2][c];
            }
            if (r < kept) {
                for (int c = 0; c < 6; c++) {
                    out[r * size + kept + c] += row[c];
                    out[(kept + c) * size + r] += row[c];
                }
                continue;
            }
            double S[3][6];
            cap_motion(s, plane->xyz + 3 * (size_t)conn[node], S);
            for (int b = 0; b < 6; b++) {
                for (int c = 0; c < 6; c++) {
                    out[(kept + b) * size + kept + c] += S[(r - kept) % 3][b] * row[c];
                }
            }
        }
    }
}

// whether any row of the layer is this rank's
static bool layer_is_mine(const assembler *a, int layer)
{
    const int p = a->column->order, top = a->supports->nlevel - 1;
    const bool cap_here = a->supports->cap && (layer + 1) * p == top;
    return ((layer + 1) * p >= a->share.first_level && layer * p < a->share.last_level) ||
           (cap_here && a->share.last == a->supports->nblock);
}

static status add_element(assembler *a, const int *conn, int layer)
{
    status st = OK;
    const column *c = a->column;
    const int n = a->plane->nnode, p = c->order, stride = 3 * n * (p + 1);
    const line_matrices line =
        line_matrices_make(c, layer, c->level[layer * p], c->level[(layer + 1) * p]);
    int block[ELEMENT_MAX_NODES];
    for (int k = 0; k <= p; k++) {
        for (int i = 0; i < n; i++) {
            block[k * n + i] = supports_block(a->supports, conn[i], layer * p + k);
        }
    }
    element_stiffness(a->plane, &line, p, a->K);
    if (layer == 0 && a->supports->held) {
        hold(a->supports, conn, n, stride, a->K);
    }
    if (a->supports->cap && layer == c->nlayer - 1) {
        tie_to_cap(a->supports, c->plane, conn, n, stride, a->K, a->capped);
        block[n * p] = a->supports->cap_block;
        block[n * p + 1] = a->supports->cap_block + 1;
        TRY(a->door->matrix_add(a->matrix, n * p + 2, block, a->capped));
    } else {
        TRY(a->door->matrix_add(a->matrix, n * (p + 1), block, a->K));
    }

done:
    return st;
}

static status add_elements(assembler *a)
{
    status st = OK;
    const column *c = a->column;
    for (int b = 0; b < c->plane->nblock; b++) {
        const mesh_block *k = &c->plane->block[b];
        for (int e = 0; e < k->nelem; e++) {
            TRY(plane_matrices_make(c, b, e, a->plane));
            for (int layer = 0; layer < c->nlayer; layer++) {
                if (layer_is_mine(a, layer)) {
                    TRY(add_element(a, k->conn + (size_t)e * (size_t)k->per_elem, layer));
                }
            }
        }
    }

done:
    return st;
}

// rows of the levels from the share's last that its layers reach
static int rows_above(const assembler *a)
{
    const supports *s = a->supports;
    const int p = a->column->order, last = a->share.last_level, top = s->nlevel - 1;
    if (a->share.last == s->nblock || last == a->share.first_level) {
        return 0;
    }
    const int reach = ((last - 1) / p + 1) * p; // the highest level that the last one couples to
    if (reach == top) {
        return s->nblock - a->share.last;
    }
    return s->nplane * (reach + 1 - last);
}

static status make_matrix(assembler *a)
{
    status st = OK;
    int *own = NULL, *beyond = NULL;
    const size_t nrow = (size_t)(a->share.last - a->share.first);
    TRY(TAKE(own, nrow));
    TRY(TAKE(beyond, nrow));
    TRY(supports_pattern(a->supports, a->column, a->share, own, beyond));
    const petsc_pattern pattern = {.nblock = a->supports->nblock,
                                   .first = a->share.first,
                                   .last = a->share.last,
                                   .nabove = rows_above(a),
                                   .diagonal = own,
                                   .beyond = beyond};
    TRY(a->door->matrix_make(&pattern, &a->matrix));

done:
    free(own);
    free(beyond);
    return st;
}

status assembly_make(const petsc_door *door, const column *c, const supports *s, int rank, int size,
                     petsc_matrix **out)
{
    status st = OK;
    assembler a = {
        .door = door, .column = c, .supports = s, .share = supports_share_of(s, rank, size)};
    const size_t dofs = PLANE_DOFS * (size_t)(c->order + 1);

    TRY(TAKE(a.plane, 1));
    TRY(TAKE(a.K, dofs * dofs));
    TRY(TAKE(a.capped, dofs * dofs)); // the cap has six unknowns, a plane element nine or more
    TRY(make_matrix(&a));
    TRY(add_elements(&a));
    *out = a.matrix;
    a.matrix = NULL;

done:
    if (a.matrix) {
        door->matrix_free(a.matrix);
    }
    assembler_free(&a);
    return st;
}
