// fem/doubling_tree.c
#include "fem/doubling_tree.h"

#include "base/memory.h"
#include "fem/blas.h"

#include <string.h>

static void joint_free(slab_joint *j)
{
    free(j->even);
    free(j->odd);
    free(j->to_even);
    free(j->to_odd);
    *j = (slab_joint){0};
}

static void stiffness_free(slab_stiffness *k)
{
    free(k->P);
    free(k->N);
    *k = (slab_stiffness){0};
}

void doubling_tree_free(doubling_tree *t)
{
    for (int k = 0; t->joint && k < t->doublings; k++) {
        joint_free(&t->joint[k]);
    }
    free(t->joint);
    stiffness_free(&t->whole);
    stiffness_free(&t->cell);
    *t = (doubling_tree){0};
}

// A = (P + N) / 2 in P's place and S = (P - N) / 2 in N's
static void sum_and_difference(int n, slab_stiffness *k)
{
    for (int j = 0; j < n; j++) {
        for (size_t i = (size_t)j * (size_t)n + (size_t)j; i < (size_t)(j + 1) * (size_t)n; i++) {
            const double p = k->P[i], q = k->N[i];
            k->P[i] = (p + q) / 2;
            k->N[i] = (p - q) / 2;
        }
    }
}

// columns first .. first + count - 1 of a symmetric matrix
static void columns_of(const double *S, int n, int first, int count, double *out)
{
    for (int j = 0; j < count; j++) {
        for (int i = 0; i < first + j; i++) {
            out[(size_t)j * (size_t)n + (size_t)i] = S[(size_t)i * (size_t)n + (size_t)(first + j)];
        }
        memcpy(out + (size_t)j * (size_t)n + first + j,
               S + (size_t)(first + j) * (size_t)n + first + j,
               (size_t)(n - first - j) * sizeof *out);
    }
}

// half a joint: factors the unknowns first .. first + count - 1 of A, Y = S L^-T
static status half_joint(const double *A, const double *S, int n, int first, int count,
                         double **factor, double **to)
{
    status st = OK;
    const double one = 1;
    int info = 0;
    TRY(TAKE(*factor, (size_t)count * (size_t)count));
    TRY(TAKE(*to, (size_t)n * (size_t)count));
    if (count == 0) {
        goto done;
    }
    for (int j = 0; j < count; j++) {
        memcpy(*factor + (size_t)j * (size_t)count + j,
               A + (size_t)(first + j) * (size_t)n + first + j, (size_t)(count - j) * sizeof **to);
    }
    columns_of(S, n, first, count, *to);
    dpotrf_("L", &count, *factor, &count, &info);
    if (info) {
        TRY(status_fail(ERR_NUMERIC, "segment: two slabs have no stiffness between them"));
    }
    dtrsm_("R", "L", "T", "N", &n, &count, &one, *factor, &count, *to, &n);

done:
    return st;
}

// Two slabs joined: what is even about the cut between them moves only its even unknowns, and the
// other way round: P' = A - S_e A_ee^-1 S_e^T, N' = A - S_o A_oo^-1 S_o^T. docs/theory.md (5.12)
static status join(const cut_part *p, slab_stiffness *k, slab_joint *joint)
{
    status st = OK;
    const int n = p->n, even = p->neven, odd = n - even;
    const double one = 1, minus = -1;
    sum_and_difference(n, k);
    TRY(half_joint(k->P, k->N, n, 0, even, &joint->even, &joint->to_even));
    TRY(half_joint(k->P, k->N, n, even, odd, &joint->odd, &joint->to_odd));
    memcpy(k->N, k->P, (size_t)n * (size_t)n * sizeof *k->N);
    if (even > 0) {
        dsyrk_("L", "N", &n, &even, &minus, joint->to_even, &n, &one, k->P, &n);
    }
    if (odd > 0) {
        dsyrk_("L", "N", &n, &odd, &minus, joint->to_odd, &n, &one, k->N, &n);
    }

done:
    return st;
}

static status copy_stiffness(int n, const slab_stiffness *k, slab_stiffness *out)
{
    status st = OK;
    const size_t size = (size_t)n * (size_t)n;
    TRY(TAKE(out->P, size));
    TRY(TAKE(out->N, size));
    memcpy(out->P, k->P, size * sizeof *k->P);
    memcpy(out->N, k->N, size * sizeof *k->N);

done:
    return st;
}

status doubling_tree_make(const cut *c, int part, const slab *s, slab_stiffness *thin,
                          int doublings, int grid, bool keep, bool (*cancelled)(void),
                          doubling_tree *out)
{
    status st = OK;
    doubling_tree t = {.cut = c,
                       .part = part,
                       .doublings = doublings,
                       .grid = grid,
                       .height = s->height,
                       .turn = s->turn,
                       .whole = *thin};
    const cut_part *p = &c->part[part];
    double height = s->height, turn = s->turn;
    *thin = (slab_stiffness){0};
    TRY(TAKE(t.joint, (size_t)doublings));
    for (int k = 0; k < doublings; k++) {
        if (cancelled && cancelled()) {
            TRY(status_fail(ERR_INTERRUPTED, "segment: interrupted"));
        }
        if (k == doublings - grid) {
            TRY(copy_stiffness(p->n, &t.whole, &t.cell));
        }
        TRY(join(p, &t.whole, &t.joint[k]));
        height *= 2;
        turn *= 2;
        TRY(slab_forget_rigid(c, part, height, turn, &t.whole));
        if (!keep && k < doublings - grid) {
            joint_free(&t.joint[k]);
        }
    }
    *out = t;
    t = (doubling_tree){0};

done:
    doubling_tree_free(&t);
    return st;
}
