// measure/shares.c
#include "measure/shares.h"

#include "base/memory.h"
#include "measure/gsl_door.h"

#include <math.h>
#include <string.h>

// samples to one coefficient: each takes 1/n of the variance by chance
enum { SAMPLES_PER_TERM = 20 };
static const double quantile_low = 0.05, quantile_high = 0.95;

int shares_degree(int nsample, int nparameter)
{
    for (int degree = SHARES_MOST_DEGREE; degree > 0; degree -= 2) {
        if (nsample >= SAMPLES_PER_TERM * degree * nparameter) {
            return degree;
        }
    }
    return 0;
}

// Legendre's polynomials: of uniform x in [-1, 1] they do not mix
static void basis(double x, int degree, double *row)
{
    const double all[SHARES_MOST_DEGREE] = {x, (3 * x * x - 1) / 2, (5 * x * x * x - 3 * x) / 2};
    memcpy(row, all, (size_t)degree * sizeof *row);
}

static double mean_of(int n, const double *y)
{
    double sum = 0;
    for (int i = 0; i < n; i++) {
        sum += y[i];
    }
    return sum / n;
}

// about the mean, over n
static double variance_of(int n, const double *y)
{
    const double mean = mean_of(n, y);
    double sum = 0;
    for (int i = 0; i < n; i++) {
        sum += (y[i] - mean) * (y[i] - mean);
    }
    return sum / n;
}

// one parameter's own polynomial at all samples
static void part_of(int n, int terms, const double *A, int first, int degree,
                    const double *coefficient, double *out)
{
    for (int i = 0; i < n; i++) {
        out[i] = 0;
        for (int d = 0; d < degree; d++) {
            out[i] += coefficient[first + d] * A[(size_t)i * (size_t)terms + (size_t)(first + d)];
        }
    }
}

static status share_out(int n, int p, const double *x, const double *y, int degree, double *share,
                        double *rest)
{
    status st = OK;
    const gsl_linear_door *door = NULL;
    double *A = NULL, *coefficient = NULL, *part = NULL, left = 0;
    const int terms = 1 + p * degree;
    const double total = variance_of(n, y);
    TRY(gsl_linear_door_open(&door));
    TRY(TAKE(A, (size_t)n * (size_t)terms));
    TRY(TAKE(coefficient, (size_t)terms));
    TRY(TAKE(part, (size_t)n));
    for (int i = 0; i < n; i++) {
        double *row = &A[(size_t)i * (size_t)terms];
        row[0] = 1;
        for (int j = 0; j < p; j++) {
            basis(x[(size_t)i * (size_t)p + (size_t)j], degree, &row[1 + j * degree]);
        }
    }
    TRY(door->least_squares(n, terms, A, y, coefficient, &left));
    for (int j = 0; j < p; j++) {
        part_of(n, terms, A, 1 + j * degree, degree, coefficient, part);
        share[j] = total > 0 ? variance_of(n, part) / total : 0;
    }
    *rest = total > 0 ? left / (n * total) : 0;

done:
    free(A);
    free(coefficient);
    free(part);
    return st;
}

static status quantiles(int n, double *y, sample_spread *out)
{
    status st = OK;
    const gsl_linear_door *door = NULL;
    TRY(gsl_linear_door_open(&door));
    door->sort(n, y);
    out->low = door->quantile(n, y, quantile_low);
    out->median = door->quantile(n, y, 0.5);
    out->high = door->quantile(n, y, quantile_high);

done:
    return st;
}

status shares_of(int n, int p, const double *x, double *y, int degree, double *share,
                 sample_spread *out)
{
    status st = OK;
    *out = (sample_spread){NAN, NAN, NAN, NAN, NAN, NAN};
    for (int j = 0; j < p; j++) {
        share[j] = NAN;
    }
    if (n == 0) {
        return OK;
    }
    if (degree > 0 && n >= 2 * (1 + p * degree)) {
        TRY(share_out(n, p, x, y, degree, share, &out->rest));
    }
    out->mean = mean_of(n, y);
    out->deviation = n > 1 ? sqrt(variance_of(n, y) * n / (n - 1)) : NAN;
    TRY(quantiles(n, y, out));

done:
    return st;
}
