// measure/gsl_line_door_module.c
#include "measure/gsl_line_door.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit.h>

// (X^T X)^-1 comes from the fit with weights, all of them 1: it does not scale it by the residual
static status solve(gsl_multifit_linear_workspace *work, const line_problem *l, gsl_vector *ones,
                    double *beta, double *covariance)
{
    const size_t n = (size_t)l->n, p = (size_t)l->p;
    const gsl_matrix_const_view X = gsl_matrix_const_view_array(l->design, n, p);
    const gsl_vector_const_view y = gsl_vector_const_view_array(l->y, n);
    gsl_vector_view b = gsl_vector_view_array(beta, p);
    gsl_matrix_view c = gsl_matrix_view_array(covariance, p, p);
    double chisq = 0;
    gsl_vector_set_all(ones, 1);
    const int code =
        gsl_multifit_wlinear(&X.matrix, ones, &y.vector, &b.vector, &c.matrix, &chisq, work);
    if (code != GSL_SUCCESS) {
        return status_fail(ERR_NUMERIC, "GSL: %s, in a linear fit", gsl_strerror(code));
    }
    for (size_t i = 0; i < p * p; i++) {
        if (!gsl_finite(covariance[i]) || !gsl_finite(beta[i % p])) {
            return status_fail(ERR_NUMERIC, "a linear fit whose columns cannot be told apart");
        }
    }
    return OK;
}

static status fit(const line_problem *l, double *beta, double *covariance)
{
    if (l->p < 1 || l->n < l->p) {
        return status_fail(ERR_NUMERIC, "%d points for %d coefficients", l->n, l->p);
    }
    (void)gsl_set_error_handler_off();
    gsl_multifit_linear_workspace *work = gsl_multifit_linear_alloc((size_t)l->n, (size_t)l->p);
    gsl_vector *ones = gsl_vector_alloc((size_t)l->n);
    const status st = work && ones ? solve(work, l, ones, beta, covariance)
                                   : status_fail(ERR_RESOURCE, "out of memory for a linear fit");
    if (ones) {
        gsl_vector_free(ones);
    }
    if (work) {
        gsl_multifit_linear_free(work);
    }
    return st;
}

const gsl_line_door *stiffaxis_gsl_line_door(void)
{
    static const gsl_line_door door = {.fit = fit};
    return &door;
}
