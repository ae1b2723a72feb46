// section/cholmod_door.c
#include "section/cholmod_door.h"

#include "base/memory.h"

#include <cholmod.h>
#include <omp.h>
#include <string.h>

struct cholesky {
    cholmod_common common;
    cholmod_factor *factor;
};

// Smallest over largest diagonal entry of the factor, squared: below it a pivot is the rounding of
// a zero one (two parts hinged at a node: 4e-16). Moduli 1e6 apart give 3e-9, 1e10 apart 3e-13.
static const double smallest_pivot = 1e-14;

void sparse_lower_free(sparse_lower *a)
{
    free(a->start);
    free(a->row);
    free(a->value);
    *a = (sparse_lower){0};
}

static status cholmod_fail(const cholmod_common *common, const char *call)
{
    switch (common->status) {
    case CHOLMOD_OUT_OF_MEMORY:
        return status_fail(ERR_RESOURCE, "CHOLMOD: out of memory in %s", call);
    case CHOLMOD_TOO_LARGE:
        return status_fail(ERR_RESOURCE, "CHOLMOD: the problem is too large in %s", call);
    case CHOLMOD_NOT_POSDEF:
        return status_fail(ERR_NUMERIC, "CHOLMOD: the matrix is not positive definite in %s", call);
    default:
        return status_fail(ERR_BUG, "CHOLMOD: status %d in %s", common->status, call);
    }
}

static void quiet_start(cholmod_common *common)
{
    cholmod_start(common);
    common->print = 0;
    common->error_handler = NULL;
}

// CHOLMOD cuts its small dense products among threads that then wait for one another on the clock:
// half of the time goes there. Until threads_back there are none.
static int threads_off(void)
{
    const int levels = omp_get_max_active_levels();
    omp_set_max_active_levels(0);
    return levels;
}

static void threads_back(int levels)
{
    omp_set_max_active_levels(levels);
}

static cholmod_sparse view(const sparse_lower *a)
{
    return (cholmod_sparse){
        .nrow = (size_t)a->n,
        .ncol = (size_t)a->n,
        .nzmax = (size_t)a->start[a->n],
        .p = a->start,
        .i = a->row,
        .x = a->value,
        .stype = -1,
        .itype = CHOLMOD_INT,
        .xtype = !a->value    ? CHOLMOD_PATTERN
                 : a->complex ? CHOLMOD_COMPLEX
                              : CHOLMOD_REAL,
        .dtype = CHOLMOD_DOUBLE,
        .sorted = 1,
        .packed = 1,
    };
}

status cholesky_order(const sparse_lower *pattern, int *permutation)
{
    status st = OK;
    cholmod_common common;
    quiet_start(&common);
    cholmod_sparse a = view(pattern);
    if (!cholmod_amd(&a, NULL, 0, permutation, &common)) {
        TRY(cholmod_fail(&common, "cholmod_amd"));
    }

done:
    cholmod_finish(&common);
    return st;
}

status cholesky_make(const sparse_lower *matrix, cholesky **out)
{
    status st = OK;
    cholesky *c = NULL;
    cholmod_sparse a = view(matrix);
    const int threads = threads_off();
    TRY(TAKE(c, 1));
    quiet_start(&c->common);
    c->common.final_ll = 1; // small ones too: L D L^T would pass over negative pivots
    c->common.nmethods = 1;
    c->common.method[0].ordering = CHOLMOD_NATURAL;
    c->common.postorder = false; // cholesky_order has seen to it

    c->factor = cholmod_analyze(&a, &c->common);
    if (!c->factor) {
        TRY(cholmod_fail(&c->common, "cholmod_analyze"));
    }
    if (!cholmod_factorize(&a, c->factor, &c->common) || c->common.status != CHOLMOD_OK) {
        TRY(cholmod_fail(&c->common, "cholmod_factorize"));
    }
    if (!(cholmod_rcond(c->factor, &c->common) > smallest_pivot)) {
        TRY(status_fail(ERR_NUMERIC, "CHOLMOD: the matrix is singular to rounding"));
    }
    *out = c;
    c = NULL;

done:
    threads_back(threads);
    cholesky_free(c);
    return st;
}

void cholesky_free(cholesky *c)
{
    if (c) {
        cholmod_free_factor(&c->factor, &c->common);
        cholmod_finish(&c->common);
        free(c);
    }
}

status cholesky_solve(cholesky *c, int nrhs, int stride, const double *b, double *x)
{
    status st = OK;
    const size_t n = c->factor->n, pair = c->factor->xtype == CHOLMOD_REAL ? 1 : 2;
    const int threads = threads_off();
    cholmod_dense right = {
        .nrow = n,
        .ncol = (size_t)nrhs,
        .nzmax = (size_t)stride * (size_t)nrhs,
        .d = (size_t)stride,
        .x = (double *)b, // read only
        .xtype = c->factor->xtype,
        .dtype = CHOLMOD_DOUBLE,
    };
    cholmod_dense *answer = cholmod_solve(CHOLMOD_A, c->factor, &right, &c->common);
    if (!answer) {
        TRY(cholmod_fail(&c->common, "cholmod_solve"));
    }
    for (size_t k = 0; k < (size_t)nrhs; k++) {
        memcpy(x + pair * k * (size_t)stride, (const double *)answer->x + pair * k * answer->d,
               pair * n * sizeof *x);
    }

done:
    threads_back(threads);
    cholmod_free_dense(&answer, &c->common);
    return st;
}
