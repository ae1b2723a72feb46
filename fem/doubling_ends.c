// fem/doubling_ends.c
// The whole body between its ends, of which the base is held and the tip loaded.
#include "fem/doubling_tree.h"

#include "base/memory.h"
#include "fem/blas.h"

#include <string.h>

// which unknowns are free: those of the base, then J x those of the tip
typedef struct free_ends {
    int nbase, n;
    int *list; // [n] unknowns of the cut
} free_ends;

static bool is_rigid(const cut_part *p, int i)
{
    for (int k = 0; k < p->nrigid; k++) {
        if (p->at[k] == i) {
            return true;
        }
    }
    return false;
}

// A base free to contract holds what is along z, and the section as a whole. A cap lets the tip
// move as a whole only.
static status find_free(const cut_part *p, int base, int tip, free_ends *out)
{
    status st = OK;
    TRY(TAKE(out->list, 2 * (size_t)p->n + 1));
    for (int i = 0; i < p->n && base == BASE_FREE_TO_CONTRACT; i++) {
        if (!p->axial[i] && !is_rigid(p, i)) {
            out->list[out->n++] = i;
        }
    }
    out->nbase = out->n;
    for (int i = 0; i < p->n; i++) {
        if (tip != TIP_RIGID || is_rigid(p, i)) {
            out->list[out->n++] = i;
        }
    }

done:
    return st;
}

// energy = u^T A u / 2 + u^T S w + w^T A w / 2 with w = J u of the tip
static void fill(const doubling_tree *t, const free_ends *ends, double *M)
{
    const size_t n = (size_t)t->cut->part[t->part].n;
    for (int j = 0; j < ends->n; j++) {
        for (int i = j; i < ends->n; i++) {
            const size_t a = (size_t)ends->list[i], b = (size_t)ends->list[j];
            const size_t at = a >= b ? b * n + a : a * n + b;
            const double P = t->whole.P[at], N = t->whole.N[at];
            const bool across = i >= ends->nbase && j < ends->nbase;
            M[(size_t)j * (size_t)ends->n + (size_t)i] = across ? (P - N) / 2 : (P + N) / 2;
        }
    }
}

static double reversed(const cut_part *p, int i)
{
    return i < p->neven ? 1 : -1;
}

status doubling_tree_ends(const doubling_tree *t, int base, int tip, int ncolumn,
                          const double *tip_force, const double *base_force, double *u0, double *u1)
{
    status st = OK;
    const cut_part *p = &t->cut->part[t->part];
    const double one = 1;
    free_ends ends = {0};
    double *M = NULL, *x = NULL;
    int info = 0;
    TRY(find_free(p, base, tip, &ends));
    TRY(TAKE(M, (size_t)ends.n * (size_t)ends.n));
    TRY(TAKE(x, (size_t)ends.n * (size_t)ncolumn));
    fill(t, &ends, M);
    memset(u0, 0, (size_t)ncolumn * (size_t)p->n * sizeof *u0);
    memset(u1, 0, (size_t)ncolumn * (size_t)p->n * sizeof *u1);
    if (ends.n == 0) {
        goto done;
    }
    dpotrf_("L", &ends.n, M, &ends.n, &info);
    if (info) {
        TRY(status_fail(ERR_NUMERIC, "segment: its supports do not hold it"));
    }
    for (int k = 0; k < ncolumn * ends.n; k++) {
        const int i = k % ends.n, unknown = ends.list[i];
        const size_t from = (size_t)(k / ends.n) * (size_t)p->n + (size_t)unknown;
        x[k] = i < ends.nbase ? base_force[from] : reversed(p, unknown) * tip_force[from];
    }
    dtrsm_("L", "L", "N", "N", &ends.n, &ncolumn, &one, M, &ends.n, x, &ends.n);
    dtrsm_("L", "L", "T", "N", &ends.n, &ncolumn, &one, M, &ends.n, x, &ends.n);
    for (int k = 0; k < ncolumn * ends.n; k++) {
        const int i = k % ends.n, unknown = ends.list[i];
        const size_t to = (size_t)(k / ends.n) * (size_t)p->n + (size_t)unknown;
        if (i < ends.nbase) {
            u0[to] = x[k];
        } else {
            u1[to] = reversed(p, unknown) * x[k];
        }
    }

done:
    free(ends.list);
    free(M);
    free(x);
    return st;
}
