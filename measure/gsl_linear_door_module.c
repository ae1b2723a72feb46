// measure/gsl_linear_door_module.c
#include "measure/gsl_door.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit.h>
#include <gsl/gsl_sort_double.h>
#include <gsl/gsl_statistics_double.h>

static status linear_least_squares(int n, int p, const double *A, const double *b, double *x,
                                   double *cost)
{
    (void)gsl_set_error_handler_off();
    const size_t rows = (size_t)n, columns = (size_t)p;
    gsl_multifit_linear_workspace *w = gsl_multifit_linear_alloc(rows, columns);
    gsl_matrix *covariance = gsl_matrix_alloc(columns, columns);
    int failed = GSL_ENOMEM;
    if (w && covariance) {
        const gsl_matrix_const_view a = gsl_matrix_const_view_array(A, rows, columns);
        const gsl_vector_const_view y = gsl_vector_const_view_array(b, rows);
        gsl_vector_view c = gsl_vector_view_array(x, columns);
        failed = gsl_multifit_linear(&a.matrix, &y.vector, &c.vector, covariance, cost, w);
    }
    if (covariance) {
        gsl_matrix_free(covariance);
    }
    if (w) {
        gsl_multifit_linear_free(w);
    }
    if (failed == GSL_ENOMEM) {
        return status_fail(ERR_RESOURCE, "out of memory: least squares of %d by %d", n, p);
    }
    return failed ? status_fail(ERR_NUMERIC, "least squares of %d by %d: %s", n, p,
                                gsl_strerror(failed))
                  : OK;
}

static void sort(int n, double *y)
{
    gsl_sort(y, 1, (size_t)n);
}

static double quantile(int n, const double *sorted, double share)
{
    return gsl_stats_quantile_from_sorted_data(sorted, 1, (size_t)n, share);
}

const gsl_linear_door *stiffaxis_gsl_linear_door(void)
{
    static const gsl_linear_door door = {
        .least_squares = linear_least_squares,
        .sort = sort,
        .quantile = quantile,
    };
    return &door;
}
