// fem/unknowns_rigid.c
// Whether springs and holds leave a body free to move as a whole. docs/theory.md (5.13)
#include "fem/unknowns.h"

#include "base/memory.h"
#include "fem/face.h"

#include <math.h>
#include <string.h>

// What resists a rigid motion, over what resists the others, and still is taken for nothing:
// springs and holds on one element of a thousand along a body hold it by 1e-6 of its length,
// squared.
static const double NO_RESISTANCE = 1e-13;

typedef struct resistance {
    const segment_problem *p;
    const unknowns *u;
    const face_spring *spring;
    double scale; // of the body: a rotation counts by what it moves there [m]
    double size;  // of all summed up for one spring or hold: each counts alike
    mat6 sum;     // energy of rigid motions
} resistance;

// displacement of a node in the six rigid motions, rows by direction
static void rigid_rows(const resistance *r, int node, int level, double rows[3][6])
{
    double x[3];
    body_node(r->u->body, node, level, x);
    for (int d = 0; d < 3; d++) {
        x[d] /= r->scale;
    }
    const double motion[3][6] = {
        {1, 0, 0, 0, x[2], -x[1]}, {0, 1, 0, -x[2], 0, x[0]}, {0, 0, 1, x[1], -x[0], 0}};
    memcpy(rows, motion, sizeof motion);
}

static void add(resistance *r, double k, const double *a, const double *b)
{
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            r->sum.a[i][j] += k * a[i] * b[j];
        }
    }
}

static void add_holds(resistance *r)
{
    const unknowns *u = r->u;
    double rows[3][6];
    for (int level = u->share.first; u->held && level < u->share.last; level++) {
        for (int i = 0; i < u->nplane; i++) {
            rigid_rows(r, i, level, rows);
            for (int d = 0; d < 3; d++) {
                if (unknowns_is_held(u, i, level, d)) {
                    add(r, 1, rows[d], rows[d]);
                }
            }
        }
    }
}

static status add_patch(void *self, const face_patch *p)
{
    resistance *r = (resistance *)self;
    double K[9 * FACE_MAX_NODES * FACE_MAX_NODES], a[3][6], b[3][6];
    const int n = p->nnode;
    face_spring_matrix(p, r->spring, K);
    for (int i = 0; i < n; i++) {
        rigid_rows(r, p->plane_node[i], p->level[i], a);
        for (int j = 0; j < n; j++) {
            rigid_rows(r, p->plane_node[j], p->level[j], b);
            for (int c = 0; c < 9; c++) {
                const double k = K[(3 * i + c / 3) * 3 * n + 3 * j + c % 3] / r->size;
                add(r, k, a[c / 3], b[c % 3]);
            }
        }
    }
    return OK;
}

static status add_all(resistance *r)
{
    status st = OK;
    const level_share *s = &r->u->share;
    add_holds(r);
    for (int i = 0; i < r->p->nspring; i++) {
        r->spring = &r->p->spring[i];
        const double *k = r->spring->stiffness;
        r->size = (k[0] + k[1] + k[2]) * r->scale * r->scale;
        TRY(face_walk(r->u->body, &r->spring->on, s->first_layer, s->last_layer, add_patch, r));
    }

done:
    return st;
}

// Cholesky with the largest pivot first; returns the rank, of the motions left the first in order
static int rank_of(mat6 m, int *order)
{
    double largest = 0;
    for (int i = 0; i < 6; i++) {
        order[i] = i;
        largest = fmax(largest, m.a[i][i]);
    }
    for (int k = 0; k < 6; k++) {
        int best = k;
        for (int i = k + 1; i < 6; i++) {
            best = m.a[order[i]][order[i]] > m.a[order[best]][order[best]] ? i : best;
        }
        const int pivot = order[best];
        order[best] = order[k];
        order[k] = pivot;
        if (!(m.a[pivot][pivot] > NO_RESISTANCE * largest)) {
            return k;
        }
        for (int i = k + 1; i < 6; i++) {
            const int row = order[i];
            const double by = m.a[row][pivot] / m.a[pivot][pivot];
            for (int j = k + 1; j < 6; j++) {
                m.a[row][order[j]] -= by * m.a[pivot][order[j]];
            }
        }
    }
    return 6;
}

static status refuse(const int *order, int rank)
{
    static const char *const words[6] = {"move along x", "move along y", "move along z",
                                         "turn about x", "turn about y", "turn about z"};
    int free_one = order[rank];
    for (int i = rank; i < 6; i++) {
        free_one = order[i] < free_one ? order[i] : free_one;
    }
    return status_fail(ERR_NUMERIC,
                       "segment: its supports are singular: springs and holds leave it free to %s",
                       words[free_one]);
}

status unknowns_check_supports(const petsc_door *door, const segment_problem *p, const unknowns *u)
{
    status st = OK;
    resistance r = {.p = p, .u = u, .scale = fmax(u->body->length, u->body->radius)};
    int order[6];
    if (p->base != BASE_FREE) {
        return OK;
    }
    TRY(door->agree(add_all(&r)));
    door->sum(36, r.sum.a[0]);
    const int rank = rank_of(r.sum, order);
    if (rank < 6) {
        TRY(refuse(order, rank));
    }

done:
    return st;
}
