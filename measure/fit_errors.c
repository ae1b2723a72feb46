// measure/fit_errors.c
// How errors go together along the lines, and what the normal equations say of the unknowns.
#include "base/memory.h"
#include "measure/fit_inside.h"

#include <math.h>
#include <string.h>

// Stations are taken so far apart that neighbours' errors go together by about a half: closer ones
// tell nothing more, and how errors behave over less than that does not matter.
static const double half = 0.5;
// a shape keeps so many stations
enum { FEWEST_STATIONS = 8 };
// more alike than this is one error for the whole line
static const double most_alike = 0.95;
// of a place, where a line fits to rounding [m]
static const double least_sigma = 1e-9;

// misfits across the lines at all stations, in units of sigma where it is told [nall][2]
static void misfits(const fit *f, const double *z, double *u, bool *told)
{
    for (int i = 0; i < f->nall; i++) {
        const fit_station *t = &f->all[i];
        const pose g = fit_base_pose(f, z, t->shape);
        const vec3 off = vec3_sub(vec3_add(mat3_mul_vec(g.R, f->q[i]), g.p), t->at);
        for (int c = 0; c < 2; c++) {
            u[2 * i + c] = vec3_dot(t->across[c], off) / fit_sigma(f, t);
        }
        told[i] = t->sigma > 0;
    }
}

// over all lines, of stations `lag` steps apart
static double alike(const fit *f, const double *u, int lag)
{
    double product = 0, square = 0;
    int nproduct = 0, nsquare = 0;
    for (int i = 0; i < f->nall; i++) {
        const bool pair = i + lag < f->nall && f->all[i + lag].shape == f->all[i].shape;
        for (int c = 0; c < 2; c++) {
            square += u[2 * i + c] * u[2 * i + c];
            product += pair ? u[2 * i + c] * u[2 * (i + lag) + c] : 0;
        }
        nproduct += pair;
        nsquare++;
    }
    return square > 0 && nproduct > 0 ? product / nproduct / (square / nsquare) : 0;
}

static int fewest_of_a_shape(const fit *f)
{
    int fewest = f->nall, run = 0;
    for (int i = 0; i < f->nall; i++) {
        run++;
        if (i + 1 == f->nall || f->all[i + 1].shape != f->all[i].shape) {
            fewest = run < fewest ? run : fewest;
            run = 0;
        }
    }
    return fewest;
}

void fit_learn(fit *f, const double *z)
{
    double *u = NULL, sum = 0;
    bool *told = NULL;
    int n = 0, lag = 1;
    if (TAKE(u, 2 * (size_t)f->nall) != OK || TAKE(told, (size_t)f->nall) != OK) {
        status_clear(); // what was taken before stays
        goto done;
    }
    // the model knows where the line runs better than its own chords, at the ends above all: an
    // error along the line is not to come in
    for (int i = 0; i < f->nall; i++) {
        const pose g = fit_base_pose(f, z, f->all[i].shape);
        fit_set_across(&f->all[i], mat3_mul_vec(g.R, f->slope[i]));
    }
    misfits(f, z, u, told);
    for (int i = 0; i < f->nall; i++) {
        sum += told[i] ? 0 : u[2 * i] * u[2 * i] + u[2 * i + 1] * u[2 * i + 1];
        n += told[i] ? 0 : 2;
    }
    f->sigma = n > 0 ? fmax(f->sigma * sqrt(sum / n), least_sigma) : f->sigma;
    const int fewest = fewest_of_a_shape(f), most = fewest / FEWEST_STATIONS;
    double rho = alike(f, u, 1);
    while (rho > half && lag < most) {
        rho = alike(f, u, ++lag);
    }
    // residuals look less alike than the errors: a correlation of few steps (Kendall's 2 rho / n),
    // and each smooth shape that the fit took out of a line (1 + rho) / n; a base's motion has five
    // of them, over two components
    const double taken = (f->nfree + 5.0 * f->nbase) / (2 * f->problem->nshape);
    rho += (2 * rho + taken * (1 + rho)) * lag / fewest;
    rho = fmin(fmax(rho, 0), most_alike);
    const double length = rho > 0 ? -lag * f->step / log(rho) : 0;
    if (f->length_from != FIT_BY_LINE || length > f->length) {
        f->length = length;
        f->length_from = FIT_BY_RESIDUALS;
    } else {
        const int wide = (int)(-log(half) * f->length / f->step);
        lag = wide > most ? most : wide;
    }
    fit_use(f, lag > 1 ? lag : 1);

done:
    free(u);
    free(told);
}

// --- normal equations

// takes the unknown `k` of n out of a symmetric matrix
static void eliminate(int n, int k, double *a)
{
    for (int i = 0; i < n; i++) {
        const double factor = a[i * n + k] / a[k * n + k];
        for (int j = 0; j < n && i != k; j++) {
            a[i * n + j] -= j == k ? 0 : factor * a[k * n + j];
        }
    }
    for (int i = 0; i < n; i++) {
        a[i * n + k] = i == k ? a[i * n + k] : 0;
    }
}

status fit_normal(fit *f, const double *z, double *S, double *held)
{
    status st = OK;
    const int nz = fit_nz(f), nr = fit_nr(f);
    double *r = NULL, *J = NULL, *a = NULL;
    TRY(TAKE(r, (size_t)nr));
    TRY(TAKE(J, (size_t)nr * (size_t)nz));
    TRY(TAKE(a, (size_t)nz * (size_t)nz));
    TRY(fit_residuals(f, z, r, J));
    for (int i = 0; i < nr; i++) {
        for (int j = 0; j < nz; j++) {
            for (int k = 0; k < nz; k++) {
                a[j * nz + k] += J[i * nz + j] * J[i * nz + k];
            }
        }
    }
    for (int k = 0; k < f->nfree; k++) {
        held[k] = a[k * nz + k];
    }
    for (int k = f->nfree; k < nz; k++) { // at least 1 on the diagonal: what is known beforehand
        eliminate(nz, k, a);
    }
    for (int i = 0; i < f->nfree; i++) {
        for (int j = 0; j < f->nfree; j++) {
            S[i * f->nfree + j] = a[i * nz + j];
        }
    }

done:
    free(r);
    free(J);
    free(a);
    return st;
}
