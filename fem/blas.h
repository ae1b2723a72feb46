// fem/blas.h
// The few routines of BLAS and LAPACK that the elements and the dense ways use. Column by column: a
// matrix stored by rows is its transpose there.
#pragma once

#include "base/status.h"

// Before anything else of here in a long run. ERR_RESOURCE where there is no memory for it: it
// would wait for ever.
status blas_take(void);

// Whether there would be; libraries that begin with less crash.
status blas_room(void);

// C = alpha op(A) op(B) + beta C, C [m][n]
void dgemm_(const char *op_a, const char *op_b, const int *m, const int *n, const int *k,
            const double *alpha, const double *a, const int *lda, const double *b, const int *ldb,
            const double *beta, double *c, const int *ldc);

// one triangle of C = alpha op(A) op(A)^T + beta C, C [n][n]
void dsyrk_(const char *triangle, const char *op, const int *n, const int *k, const double *alpha,
            const double *a, const int *lda, const double *beta, double *c, const int *ldc);

// C = alpha A B + beta C or alpha B A + beta C, A symmetric by one triangle
void dsymm_(const char *side, const char *triangle, const int *m, const int *n, const double *alpha,
            const double *a, const int *lda, const double *b, const int *ldb, const double *beta,
            double *c, const int *ldc);

// B [m][n] becomes alpha op(A)^-1 B or alpha B op(A)^-1, A triangular
void dtrsm_(const char *side, const char *triangle, const char *op, const char *diagonal,
            const int *m, const int *n, const double *alpha, const double *a, const int *lda,
            double *b, const int *ldb);

// LAPACK: Cholesky's factor in place; info > 0: not positive definite
void dpotrf_(const char *triangle, const int *n, double *a, const int *lda, int *info);

// the same of a matrix in a band of kd diagonals above or below its own, and solutions by it
void dpbtrf_(const char *triangle, const int *n, const int *kd, double *ab, const int *ldab,
             int *info);
void dpbtrs_(const char *triangle, const int *n, const int *kd, const int *nrhs, const double *ab,
             const int *ldab, double *b, const int *ldb, int *info);

// A x = w B x, B positive definite: eigenvalues ascending, vectors with x^T B x = 1 into A
void dsygv_(const int *type, const char *job, const char *triangle, const int *n, double *a,
            const int *lda, double *b, const int *ldb, double *w, double *work, const int *lwork,
            int *info);

// by rows: C [m][n] = A^T B, or C + A^T B; A [k][m], B [k][n]
static inline void blas_product(int m, int n, int k, const double *A, const double *B, int add,
                                double *C)
{
    const double one = 1, before = add ? 1 : 0;
    dgemm_("N", "T", &n, &m, &k, &one, B, &n, A, &m, &before, C, &n);
}
