// measure/gsl_fit_door_module.c
#include "measure/gsl_door.h"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>

#include <math.h>
#include <string.h>

// Where no step makes the cost smaller the search has arrived, if the residual is at right angles
// to every column of the Jacobian to this much: rounding and differenced columns leave no more.
static const double right_angle = 1e-3;
// ... or nothing is left of it but rounding, in standard deviations.
static const double no_residual = 1e-8;
// A column of the Jacobian that the others make to this share of it: not told apart.
static const double same_column = 1e-9;

typedef struct search {
    const least_squares *problem;
    status st; // of the residuals
} search;

static int eval(search *s, const gsl_vector *x, double *r, double *jacobian)
{
    s->st = s->problem->residuals(s->problem->context, x->data, r, jacobian);
    return s->st == OK ? GSL_SUCCESS : GSL_EBADFUNC;
}

// GSL's own vectors of the search have stride 1
static int eval_f(const gsl_vector *x, void *context, gsl_vector *f)
{
    return eval(context, x, f->data, NULL);
}

static int eval_df(const gsl_vector *x, void *context, gsl_matrix *J)
{
    search *s = context;
    // the residuals come with it, and are not wanted again
    gsl_vector *f = gsl_vector_alloc(J->size1);
    if (!f) {
        s->st = status_fail(ERR_RESOURCE, "out of memory for a fit");
        return GSL_ENOMEM;
    }
    const int result = eval(s, x, f->data, J->data);
    gsl_vector_free(f);
    return result;
}

// whether the residual is at right angles to the Jacobian's columns
static bool arrived(const gsl_multifit_nlinear_workspace *w)
{
    const gsl_vector *f = gsl_multifit_nlinear_residual(w);
    const gsl_matrix *J = gsl_multifit_nlinear_jac(w);
    double rr = 0;
    for (size_t i = 0; i < f->size; i++) {
        rr += gsl_vector_get(f, i) * gsl_vector_get(f, i);
    }
    for (size_t k = 0; k < J->size2; k++) {
        double gr = 0, gg = 0;
        for (size_t i = 0; i < f->size; i++) {
            const double g = gsl_matrix_get(J, i, k);
            gr += g * gsl_vector_get(f, i);
            gg += g * g;
        }
        if (!(gr * gr <= right_angle * right_angle * gg * rr)) {
            return false;
        }
    }
    return true;
}

static status covariance(const gsl_multifit_nlinear_workspace *w, double *out)
{
    const gsl_matrix *J = gsl_multifit_nlinear_jac(w);
    const size_t n = J->size2;
    gsl_matrix_view c = gsl_matrix_view_array(out, n, n);
    if (gsl_multifit_nlinear_covar(J, same_column, &c.matrix) != GSL_SUCCESS) {
        return status_fail(ERR_NUMERIC, "fit: no covariance");
    }
    for (size_t i = 0; i < n; i++) {
        if (!(out[i * n + i] > 0) || !isfinite(out[i * n + i])) {
            return status_fail(ERR_NUMERIC,
                               "fit: parameter %d of %d cannot be told from the others", (int)i + 1,
                               (int)n);
        }
    }
    return OK;
}

static status drive(const least_squares *problem, search *s, gsl_multifit_nlinear_workspace *w,
                    least_squares_answer *answer)
{
    int info = 0;
    // by the steps alone: the cost may end far from zero
    const int result = gsl_multifit_nlinear_driver(
        (size_t)problem->most_steps, problem->step_tolerance, 0, 0, NULL, NULL, &info, w);
    answer->steps = (int)gsl_multifit_nlinear_niter(w);
    if (s->st != OK) {
        return s->st;
    }
    const gsl_vector *f = gsl_multifit_nlinear_residual(w);
    answer->cost = 0;
    double largest = 0;
    for (size_t i = 0; i < f->size; i++) {
        const double r = gsl_vector_get(f, i);
        answer->cost += r * r;
        largest = fmax(largest, fabs(r));
    }
    if (result != GSL_SUCCESS && !(largest <= no_residual) &&
        (result == GSL_EMAXITER || !arrived(w))) {
        answer->short_of_it = true;
        return status_fail(ERR_NUMERIC, "fit: no convergence in %d steps (%s)", answer->steps,
                           gsl_strerror(result));
    }
    return answer->covariance ? covariance(w, answer->covariance) : OK;
}

static status fit_least_squares(const least_squares *problem, double *x,
                                least_squares_answer *answer)
{
    status st = OK;
    search s = {.problem = problem};
    (void)gsl_set_error_handler_off();
    const size_t n = (size_t)problem->nresidual, p = (size_t)problem->nparameter;
    if (p == 0 || n < p) {
        return status_fail(ERR_NUMERIC, "fit: %d parameters of %d residuals", (int)p, (int)n);
    }
    gsl_multifit_nlinear_fdf fdf = {.f = eval_f, .df = eval_df, .n = n, .p = p, .params = &s};
    gsl_multifit_nlinear_parameters parameters = gsl_multifit_nlinear_default_parameters();
    parameters.trs = gsl_multifit_nlinear_trs_lm;
    gsl_multifit_nlinear_workspace *w =
        gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &parameters, n, p);
    if (!w) {
        return status_fail(ERR_RESOURCE, "out of memory for a fit");
    }
    const gsl_vector_const_view start = gsl_vector_const_view_array(x, p);
    if (gsl_multifit_nlinear_init(&start.vector, &fdf, w) != GSL_SUCCESS) {
        st = s.st != OK ? s.st : status_fail(ERR_NUMERIC, "fit: nothing to start from");
    } else {
        st = drive(problem, &s, w, answer);
        for (size_t i = 0; i < p; i++) {
            x[i] = gsl_vector_get(gsl_multifit_nlinear_position(w), i);
        }
    }
    gsl_multifit_nlinear_free(w);
    return st;
}

static status eigen(int n, const double *a, double *value, double *vector)
{
    const size_t m = (size_t)n;
    (void)gsl_set_error_handler_off();
    gsl_matrix *copy = gsl_matrix_alloc(m, m);
    gsl_eigen_symmv_workspace *w = gsl_eigen_symmv_alloc(m);
    if (!copy || !w) {
        gsl_matrix_free(copy);
        gsl_eigen_symmv_free(w);
        return status_fail(ERR_RESOURCE, "out of memory for eigenvalues");
    }
    memcpy(copy->data, a, m * m * sizeof *a);
    gsl_vector_view values = gsl_vector_view_array(value, m);
    gsl_matrix_view vectors = gsl_matrix_view_array(vector, m, m);
    (void)gsl_eigen_symmv(copy, &values.vector, &vectors.matrix, w);
    (void)gsl_eigen_symmv_sort(&values.vector, &vectors.matrix, GSL_EIGEN_SORT_VAL_ASC);
    gsl_matrix_free(copy);
    gsl_eigen_symmv_free(w);
    return OK;
}

const gsl_fit_door *stiffaxis_gsl_fit_door(void)
{
    static const gsl_fit_door door = {.least_squares = fit_least_squares, .eigen = eigen};
    return &door;
}
