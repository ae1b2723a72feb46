// measure/gsl_spline_door_module.c
#include "measure/gsl_spline_door.h"

#include <gsl/gsl_bspline.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>

// the splines' derivatives in a piece's middle are its Taylor coefficients, times factorials
static status piece_taylor(gsl_bspline_workspace *w, gsl_matrix *derivative, double u, int order,
                           double *taylor)
{
    size_t first = 0, last = 0;
    const size_t n = (size_t)order;
    if (gsl_bspline_deriv_eval_nonzero(u, n - 1, derivative, &first, &last, w)) {
        return status_fail(ERR_BUG, "GSL: no B-splines at %g", u);
    }
    double factorial = 1;
    for (size_t power = 0; power < n; power++) {
        factorial *= power ? (double)power : 1;
        for (size_t k = 0; k < n; k++) {
            taylor[k * n + power] = gsl_matrix_get(derivative, k, power) / factorial;
        }
    }
    return OK;
}

static status pieces(int order, int npiece, double length, double *taylor)
{
    status st = OK;
    const size_t n = (size_t)order;
    (void)gsl_set_error_handler_off();
    gsl_bspline_workspace *w = gsl_bspline_alloc(n, (size_t)npiece + 1);
    gsl_matrix *derivative = gsl_matrix_alloc(n, n);
    if (!w || !derivative || gsl_bspline_knots_uniform(0, length, w)) {
        TRY(status_fail(ERR_RESOURCE, "out of memory for splines"));
    }
    for (int i = 0; i < npiece; i++) {
        TRY(piece_taylor(w, derivative, (i + 0.5) * length / npiece, order,
                         taylor + (size_t)i * n * n));
    }

done:
    gsl_matrix_free(derivative);
    if (w) {
        gsl_bspline_free(w);
    }
    return st;
}

static status solve(int n, double *a, double *b, bool invert)
{
    (void)gsl_set_error_handler_off();
    gsl_matrix_view matrix = gsl_matrix_view_array(a, (size_t)n, (size_t)n);
    gsl_vector_view side = gsl_vector_view_array(b, (size_t)n);
    if (gsl_linalg_cholesky_decomp1(&matrix.matrix) ||
        gsl_linalg_cholesky_svx(&matrix.matrix, &side.vector) ||
        (invert && gsl_linalg_cholesky_invert(&matrix.matrix))) {
        return status_fail(ERR_NUMERIC, "least squares: the points do not decide all unknowns");
    }
    return OK;
}

const gsl_spline_door *stiffaxis_gsl_spline_door(void)
{
    static const gsl_spline_door door = {.pieces = pieces, .solve = solve};
    return &door;
}
