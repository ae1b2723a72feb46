// fem/doubling_condense.c
// A slab's elements gathered on the unknowns of one part of the cut, once for motions that its
// reversal keeps and once for those that it changes the sign of, and their inner levels eliminated.
#include "fem/doubling_slab.h"

#include "base/memory.h"
#include "fem/blas.h"

#include <math.h>
#include <string.h>

// Unknowns of half a slab: its inner levels, half of the one in the middle, then its end.
typedef struct half_slab {
    const cut_part *p;
    int order, inner, all; // counts
    bool odd;
} half_slab;

static half_slab half_slab_of(const slab *s, const cut_part *p, bool odd)
{
    half_slab h = {.p = p, .order = s->order, .odd = odd};
    h.inner = (s->order - 1) / 2 * p->n;
    if (s->order % 2 == 0) {
        h.inner += odd ? p->n - p->neven : p->neven;
    }
    h.all = h.inner + p->n;
    return h;
}

// the row of unknown i of the cut at a level, and the sign with which it stands there; -1: none
static int half_slab_row(const half_slab *h, int level, int i, double *sign)
{
    const bool changes = i >= h->p->neven, upper = 2 * level > h->order;
    const int from_end = upper ? h->order - level : level;
    *sign = upper && changes != h->odd ? -1 : 1;
    if (from_end == 0) {
        return h->inner + i;
    }
    if (2 * level == h->order) {
        const int first = h->odd ? h->p->neven : 0;
        return changes == h->odd ? (from_end - 1) * h->p->n + i - first : -1;
    }
    return (from_end - 1) * h->p->n + i;
}

typedef struct entry {
    int row, dof; // of the half slab, of the element
    double share;
} entry;

static int list_entries(const half_slab *h, const int *conn, int count, entry *list)
{
    int n = 0;
    for (int i = 0; i < 3 * count * (h->order + 1); i++) {
        const int node = conn[i / 3 % count], level = i / 3 / count;
        for (int k = 0; k < 2; k++) {
            const size_t at = 2 * (3 * (size_t)node + (size_t)(i % 3)) + (size_t)k;
            double sign = 0;
            const int unknown = h->p->index[at];
            const int row = unknown < 0 ? -1 : half_slab_row(h, level, unknown, &sign);
            if (row >= 0) {
                list[n++] = (entry){row, i, sign * h->p->share[at]};
            }
        }
    }
    return n;
}

// half the sum over the whole slab, since its other half has as much
static status gather(const slab *s, const half_slab *h, double *A)
{
    status st = OK;
    entry *list = NULL;
    int number = 0;
    TRY(TAKE(list, 2 * 3 * (size_t)(ELEMENT_MAX_PLANE_NODES * (ELEMENT_MAX_ORDER + 1))));
    for (int b = 0; b < s->plane->nblock; b++) {
        const mesh_block *m = &s->plane->block[b];
        const size_t dofs = 3 * (size_t)m->per_elem * (size_t)(s->order + 1);
        for (int e = 0; e < m->nelem; e++, number++) {
            const int *conn = m->conn + (size_t)e * (size_t)m->per_elem;
            const int n = list_entries(h, conn, m->per_elem, list);
            for (int j = 0; j < n; j++) {
                const double *K = s->K[number] + (size_t)list[j].dof * dofs;
                double *column = A + (size_t)list[j].row * (size_t)h->all;
                for (int i = 0; i < n; i++) {
                    if (list[i].row >= list[j].row) {
                        column[list[i].row] += list[i].share * list[j].share * K[list[i].dof] / 2;
                    }
                }
            }
        }
    }

done:
    free(list);
    return st;
}

// A [all][all] -> its last n unknowns' Schur complement
static status eliminate(const half_slab *h, double *A, double *out)
{
    const int n = h->p->n, m = h->inner, lda = h->all;
    const double one = 1, minus = -1;
    int info = 0;
    double *corner = A + (size_t)m * (size_t)lda + m;
    if (m > 0) {
        dpotrf_("L", &m, A, &lda, &info);
        if (info) {
            return status_fail(ERR_NUMERIC, "segment: a slab is not stiff inside");
        }
        dtrsm_("R", "L", "T", "N", &n, &m, &one, A, &lda, A + m, &lda);
        dsyrk_("L", "N", &n, &m, &minus, A + m, &lda, &one, corner, &lda);
    }
    for (int j = 0; j < n; j++) {
        memcpy(out + (size_t)j * (size_t)n + j, corner + (size_t)j * (size_t)lda + j,
               (size_t)(n - j) * sizeof *out);
    }
    return OK;
}

// rows of the rigid motions [nrigid][n] of a symmetric K whose unknowns may be pins
static void rigid_rows(const cut_part *p, const double *K, double *rows)
{
    const size_t n = (size_t)p->n;
    memset(rows, 0, (size_t)p->nrigid * n * sizeof *rows);
    for (int k = 0; k < p->nrigid; k++) {
        const double *R = p->R + (size_t)k * n;
        double *row = rows + (size_t)k * n;
        for (size_t j = 0; j < n; j++) {
            const double *column = K + j * n;
            row[j] += column[j] * R[j];
            for (size_t i = j + 1; i < n; i++) {
                row[j] += column[i] * R[i];
                row[i] += column[i] * R[j];
            }
        }
    }
}

static double *lower_entry(double *K, int n, int i, int j)
{
    return i >= j ? K + (size_t)j * (size_t)n + i : K + (size_t)i * (size_t)n + j;
}

// the pins' unknowns give their places to the rigid motions
static status unpin(const cut_part *p, double *K)
{
    status st = OK;
    double *rows = NULL;
    TRY(TAKE(rows, 6 * (size_t)p->n));
    rigid_rows(p, K, rows);
    for (int k = 0; k < p->nrigid; k++) {
        for (int i = 0; i < p->n; i++) {
            *lower_entry(K, p->n, i, p->at[k]) = rows[(size_t)k * (size_t)p->n + (size_t)i];
        }
    }
    for (int k = 0; k < p->nrigid; k++) {
        for (int l = 0; l <= k; l++) {
            double sum = 0;
            for (int i = 0; i < p->n; i++) {
                sum += rows[(size_t)k * (size_t)p->n + (size_t)i] *
                       p->R[(size_t)l * (size_t)p->n + (size_t)i];
            }
            *lower_entry(K, p->n, p->at[k], p->at[l]) = sum;
        }
    }

done:
    free(rows);
    return st;
}

static status condense(const slab *s, const cut_part *p, bool odd, double *out)
{
    status st = OK;
    const half_slab h = half_slab_of(s, p, odd);
    double *A = NULL;
    TRY(TAKE(A, (size_t)h.all * (size_t)h.all));
    TRY(gather(s, &h, A));
    TRY(eliminate(&h, A, out));
    TRY(unpin(p, out));

done:
    free(A);
    return st;
}

status slab_condense(const slab *s, const cut *c, int part, slab_stiffness *out)
{
    status st = OK;
    const cut_part *p = &c->part[part];
    slab_stiffness k = {0};
    TRY(TAKE(k.P, (size_t)p->n * (size_t)p->n));
    TRY(TAKE(k.N, (size_t)p->n * (size_t)p->n));
    TRY(condense(s, p, false, k.P));
    TRY(condense(s, p, true, k.N));
    TRY(slab_forget_rigid(c, part, s->height, s->turn, &k));
    *out = k;
    k = (slab_stiffness){0};

done:
    free(k.P);
    free(k.N);
    return st;
}

// --- rigid motions of the slab

// position of rigid motion j in the part, -1
static int find(const cut_part *p, int j)
{
    for (int k = 0; k < p->nrigid; k++) {
        if (p->rigid[k] == j) {
            return k;
        }
    }
    return -1;
}

// rows i and j, and in them columns i and j, turned by an angle
static void turn_pair(const cut_part *p, int i, int j, double angle, double *rows)
{
    const double c = cos(angle), s = sin(angle);
    const size_t n = (size_t)p->n;
    for (size_t m = 0; m < n; m++) {
        const double u = rows[(size_t)i * n + m], v = rows[(size_t)j * n + m];
        rows[(size_t)i * n + m] = c * u + s * v;
        rows[(size_t)j * n + m] = c * v - s * u;
    }
    for (int k = 0; k < p->nrigid; k++) {
        double *x = rows + (size_t)k * n + p->at[i], *y = rows + (size_t)k * n + p->at[j];
        const double u = *x, v = *y;
        *x = c * u + s * v;
        *y = c * v - s * u;
    }
}

// row and column `to` become factor x those of `from`
static void follow(const cut_part *p, int to, int from, double factor, double *rows)
{
    const size_t n = (size_t)p->n;
    for (size_t m = 0; m < n; m++) {
        rows[(size_t)to * n + m] = from < 0 ? 0 : factor * rows[(size_t)from * n + m];
    }
    for (int k = 0; k < p->nrigid; k++) {
        rows[(size_t)k * n + (size_t)p->at[to]] =
            from < 0 ? 0 : factor * rows[(size_t)k * n + (size_t)p->at[from]];
    }
}

// About the slab's middle its rigid motions are each either kept or reversed by J: a translation
// along a or b and the rotation that goes with it at the lower end. docs/theory.md (5.12)
static void forget(const cut *c, const cut_part *p, double height, bool odd, double *rows)
{
    const int arm[2] = {4, 3}; // the rotation that moves the middle along a, along b
    for (int d = 0; d < 2; d++) {
        const int t = find(p, d), r = find(p, arm[d]);
        if (t < 0) {
            continue;
        }
        if ((c->sign[d] < 0) == odd) {
            follow(p, t, -1, 0, rows);
        } else {
            follow(p, r, t, (d ? -1 : 1) * height / 2, rows);
        }
    }
    const int along = find(p, 2), twist = find(p, 5);
    if (along >= 0 && odd) {
        follow(p, along, -1, 0, rows);
    }
    if (twist >= 0 && (c->sign[0] * c->sign[1] < 0) == odd) {
        follow(p, twist, -1, 0, rows);
    }
}

static status forget_in(const cut *c, const cut_part *p, double height, double turn, bool odd,
                        double *K)
{
    status st = OK;
    double *rows = NULL;
    const int n = p->n;
    TRY(TAKE(rows, 6 * (size_t)n));
    for (int k = 0; k < p->nrigid; k++) {
        for (int i = 0; i < n; i++) {
            rows[(size_t)k * (size_t)n + (size_t)i] = *lower_entry(K, n, i, p->at[k]);
        }
    }
    for (int pass = 0; pass < 2; pass++) {
        for (int d = 0; turn != 0 && d < 6; d += 3) {
            if (find(p, d) >= 0) {
                turn_pair(p, find(p, d), find(p, d + 1), (pass ? -1 : 1) * turn / 2, rows);
            }
        }
        if (!pass) {
            forget(c, p, height, odd, rows);
        }
    }
    for (int k = 0; k < p->nrigid; k++) {
        for (int i = 0; i < n; i++) {
            *lower_entry(K, n, i, p->at[k]) = rows[(size_t)k * (size_t)n + (size_t)i];
        }
    }

done:
    free(rows);
    return st;
}

status slab_forget_rigid(const cut *c, int part, double height, double turn, slab_stiffness *k)
{
    status st = OK;
    TRY(forget_in(c, &c->part[part], height, turn, false, k->P));
    TRY(forget_in(c, &c->part[part], height, turn, true, k->N));

done:
    return st;
}
