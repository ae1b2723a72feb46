// measure/tensile_parabola.c
#include "measure/tensile_inside.h"

#include "base/memory.h"

#include <math.h>

// The sum of positive pairs of autocovariances (Geyer's initial sequence). Residuals of a fit with
// p smooth functions have each of them too small by p/n of the sum, which is put back.
double tensile_correlation(int n, const double *r, int fitted)
{
    enum { MOST_LAGS = 400 };
    double lag[MOST_LAGS] = {0}, tau = 1;
    const int nlag = n / 4 < MOST_LAGS ? n / 4 : MOST_LAGS;
    for (int k = 0; k < nlag; k++) {
        for (int i = 0; i + k < n; i++) {
            lag[k] += r[i] * r[i + k] / n;
        }
    }
    if (!(lag[0] > 0) || nlag < 2) {
        return 1;
    }
    // white noise shows less than this, in nineteen of twenty
    if (lag[1] + fitted * lag[0] / n < 1.645 * lag[0] / sqrt(n)) {
        return 1;
    }
    for (int round = 0; round < 4; round++) {
        const double back = fitted * tau * lag[0] / n, all = lag[0] + back;
        double sum = -all;
        for (int k = 0; k + 1 < nlag; k += 2) {
            const double pair = lag[k] + lag[k + 1] + 2 * back;
            if (pair <= 0) {
                break;
            }
            sum += 2 * pair;
        }
        tau = fmin(fmax(sum / all, 1), n / 8.0 > 1 ? n / 8.0 : 1);
    }
    return tau;
}

static double eval(const double *beta, const double *row, int p)
{
    double y = 0;
    for (int k = 0; k < p; k++) {
        y += beta[k] * row[k];
    }
    return y;
}

static double leverage(const double *row, int p, const double *C)
{
    double h = 0;
    for (int i = 0; i < p; i++) {
        for (int k = 0; k < p; k++) {
            h += row[i] * C[i * p + k] * row[k];
        }
    }
    return h;
}

// V = tau C (sum r^2/(1 - h) x x^T) C: right too where the noise grows with the stress   (9.81)
static void covariance(int n, int p, const double *X, const double *C, const double *r, double tau,
                       tensile_fit *out)
{
    double M[CUBIC][CUBIC] = {{0}};
    for (int i = 0; i < n; i++) {
        const double *x = X + (size_t)i * (size_t)p;
        const double w = r[i] * r[i] / fmax(1 - leverage(x, p, C), 0.05);
        for (int a = 0; a < p; a++) {
            for (int b = 0; b < p; b++) {
                M[a][b] += w * x[a] * x[b];
            }
        }
    }
    for (int a = 0; a < p; a++) {
        for (int b = 0; b < p; b++) {
            double v = 0;
            for (int i = 0; i < p; i++) {
                for (int k = 0; k < p; k++) {
                    v += C[a * p + i] * M[i][k] * C[k * p + b];
                }
            }
            out->V[a][b] = tau * v;
        }
    }
    for (int a = 0; a < p; a++) {
        out->se[a] = sqrt(fmax(out->V[a][a], 0));
    }
}

status tensile_polynomial(const gsl_line_door *door, const tensile_curve *c, tensile_stretch s,
                          int degree, double tau, tensile_fit *out)
{
    status st = OK;
    const int n = s.count, p = degree + 1;
    double *X = NULL, *y = NULL, *r = NULL, C[CUBIC * CUBIC], square = 0;
    *out = (tensile_fit){.scale = 0};
    TRY(TAKE(X, (size_t)n * (size_t)p));
    TRY(TAKE(y, (size_t)n));
    TRY(TAKE(r, (size_t)n));
    for (int i = 0; i < n; i++) {
        out->scale = fmax(out->scale, fabs(c->stress[s.first + i]));
    }
    out->scale = out->scale > 0 ? out->scale : 1;
    for (int i = 0; i < n; i++) {
        const double t = (c->strain[s.first + i] - s.from) / (s.to - s.from);
        double power = 1;
        for (int k = 0; k < p; k++, power *= t) {
            X[(size_t)i * (size_t)p + (size_t)k] = power;
        }
        y[i] = c->stress[s.first + i] / out->scale;
    }
    TRY(door->fit(&(line_problem){n, p, X, y}, out->p, C));
    for (int i = 0; i < n; i++) {
        r[i] = y[i] - eval(out->p, X + (size_t)i * (size_t)p, p);
        square += r[i] * r[i];
    }
    out->tau = tau > 0 ? tau : tensile_correlation(n, r, p);
    const double whole = n / out->tau; // as many as are independent
    out->freedom = fmax(whole - p, 1);
    out->noise = out->scale * sqrt(square / n * whole / out->freedom);
    // HC2 puts back p of n; with tau it is p of n/tau
    const double back = whole / out->freedom * (n - p) / n;
    covariance(n, p, X, C, r, out->tau * back, out);

done:
    free(X);
    free(y);
    free(r);
    return st;
}
