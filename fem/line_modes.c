// fem/line_modes.c
#include "fem/line_modes.h"

#include "base/memory.h"
#include "fem/blas.h"

#include <string.h>

void line_modes_free(line_modes *m)
{
    free(m->V);
    free(m->theta);
    *m = (line_modes){0};
}

// the two forms over levels from..to-1
static void line_forms(const body *b, int from, int to, double *M, double *K)
{
    const int p = b->order, n = to - from;
    const basis_table *t = &b->line_table;
    for (int layer = 0; layer < b->nlayer; layer++) {
        const double half = (b->level[(layer + 1) * p] - b->level[layer * p]) / 2;
        for (int q = 0; q < t->npoint; q++) {
            const double *N = t->N + q * (p + 1), *dN = t->dN + q * (p + 1);
            for (int i = 0; i <= p; i++) {
                for (int j = 0; j <= p; j++) {
                    const int r = layer * p + i - from, c = layer * p + j - from;
                    if (r >= 0 && c >= 0 && r < n && c < n) {
                        M[(size_t)r * (size_t)n + (size_t)c] += half * t->weight[q] * N[i] * N[j];
                        K[(size_t)r * (size_t)n + (size_t)c] += t->weight[q] / half * dN[i] * dN[j];
                    }
                }
            }
        }
    }
}

status line_modes_make(const body *b, bool base, bool tip, line_modes *out)
{
    status st = OK;
    const int from = base ? 0 : 1, to = b->nlevel - (tip ? 0 : 1), n = to - from, type = 1;
    double *M = NULL, *K = NULL, *work = NULL;
    const int nwork = 34 * n + 1;
    int info = 0;
    const size_t all = (size_t)n * (size_t)n;
    out->count = n;
    TRY(TAKE(M, all));
    TRY(TAKE(K, all));
    TRY(TAKE(work, (size_t)nwork));
    TRY(TAKE(out->theta, (size_t)n));
    TRY(TAKE(out->V, (size_t)n * (size_t)b->nlevel));
    line_forms(b, from, to, M, K);
    if (n > 0) {
        dsygv_(&type, "V", "U", &n, K, &n, M, &n, out->theta, work, &nwork, &info);
    }
    if (info != 0) {
        TRY(status_fail(ERR_NUMERIC, "segment: no modes along the body, LAPACK says %d", info));
    }
    for (int j = 0; j < n; j++) {
        memcpy(out->V + (size_t)j * (size_t)b->nlevel + from, K + (size_t)j * (size_t)n,
               (size_t)n * sizeof *K);
    }

done:
    free(M);
    free(K);
    free(work);
    return st;
}
