// measure/tube_normal.c
#include "measure/tube_normal.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

enum { LOCAL = 3 * TUBE_ORDER + 2, SMOOTHINGS = 16 };

static const double least_smoothing = 0.25, smoothing_step = 1.25; // radii; between those tried
// generalized cross-validation alone now and then follows the noise; freedom counted at 1.4 of its
// value mends that (Kim and Gu, 2004)
static const double freedom_price = 1.4;
// what is best for the line's error in all leaves at its ends a bias that is no smaller than the
// scatter: a little less smoothing makes the deviations that are told true there too
static const double bias_margin = 1.25;
static const double held = 1e9;         // a radius that is given, against what the points say of it
static const double along_weight = 100; // of steps along the line, against those across it

status tube_normal_make(const tube_curve *c, tube_normal *out)
{
    status st = OK;
    tube_normal n = {.n = 3 * c->ncoef + 2};
    const size_t count = (size_t)n.n;
    TRY(TAKE(n.A, count * count));
    TRY(TAKE(n.g, count));
    TRY(TAKE(n.rough, (size_t)c->ncoef * (size_t)c->ncoef));
    TRY(TAKE(n.along, count * count));
    TRY(TAKE(n.work, count * count));
    TRY(TAKE(n.step, count));
    tube_curve_gram(c, 3, 1, n.rough);
    *out = n;
    n = (tube_normal){0};

done:
    tube_normal_free(&n);
    return st;
}

void tube_normal_free(tube_normal *n)
{
    free(n->A);
    free(n->g);
    free(n->rough);
    free(n->along);
    free(n->work);
    free(n->step);
    *n = (tube_normal){0};
}

// where the local unknowns stand among all
static int place_of(const tube_normal *n, int piece, int k)
{
    return k < LOCAL - 2 ? 3 * piece + k : n->n - (LOCAL - k);
}

static void add_row(tube_normal *n, int piece, const double row[LOCAL], double weight, double res)
{
    for (int k = 0; k < LOCAL; k++) {
        const size_t at = (size_t)place_of(n, piece, k) * (size_t)n->n;
        const double wr = weight * row[k];
        n->g[place_of(n, piece, k)] += wr * res;
        for (int l = 0; l <= k; l++) {
            n->A[at + (size_t)place_of(n, piece, l)] += wr * row[l];
        }
    }
}

// B_j B_k t t^T, by points of the pieces: only the scale matters
static void fill_along(const tube_curve *c, tube_normal *n)
{
    memset(n->along, 0, (size_t)n->n * (size_t)n->n * sizeof *n->along);
    const double h = c->length / c->npiece;
    for (int i = 0; i < 6 * c->npiece; i++) {
        double x = 0, b[TUBE_ORDER];
        vec3 t;
        const double u = (i + 0.5) * h / 6;
        const int piece = tube_curve_piece(c, u, &x);
        (void)tube_curve_at(c, u, &t, NULL);
        t = vec3_scale(1 / vec3_norm(t), t);
        tube_curve_basis(c, piece, x, 0, b);
        for (int k = 0; k < 3 * TUBE_ORDER; k++) {
            for (int l = 0; l < 3 * TUBE_ORDER; l++) {
                n->along[(3 * piece + k) * n->n + 3 * piece + l] +=
                    h / 6 * b[k / 3] * b[l / 3] * t.a[k % 3] * t.a[l % 3];
            }
        }
    }
}

// d res = - n . B_j dc_j - d radius(u): the foot's own motion is across n   (9.5)
void tube_normal_fill(const tube_fit *f, tube_normal *n)
{
    const tube_curve *c = &f->curve;
    const size_t count = (size_t)n->n;
    memset(n->A, 0, count * count * sizeof *n->A);
    memset(n->g, 0, count * sizeof *n->g);
    n->sum = 0;
    n->square = 0;
    for (size_t i = 0; i < f->count; i++) {
        if (!(f->weight[i] > 0)) {
            continue;
        }
        double x = 0, b[TUBE_ORDER], row[LOCAL];
        const int piece = tube_curve_piece(c, f->u[i], &x);
        const vec3 p = tube_curve_at(c, f->u[i], NULL, NULL);
        const double d = f->res[i] + tube_fit_radius(f, f->u[i]);
        tube_curve_basis(c, piece, x, 0, b);
        for (int k = 0; k < 3 * TUBE_ORDER; k++) {
            row[k] = -b[k / 3] * (f->p[i][k % 3] - p.a[k % 3]) / d;
        }
        row[LOCAL - 2] = -1;
        row[LOCAL - 1] = 0.5 - f->u[i] / c->length;
        add_row(n, piece, row, f->weight[i], f->res[i]);
        n->sum += f->weight[i];
        n->square += f->weight[i] * f->res[i] * f->res[i];
    }
    for (size_t k = 0; k < count; k++) {
        for (size_t l = 0; l < k; l++) {
            n->A[l * count + k] = n->A[k * count + l];
        }
    }
    fill_along(c, n);
}

// leaves the unknown as it is: its inverse is nothing
static void hold(tube_normal *n, size_t at)
{
    const size_t count = (size_t)n->n;
    for (size_t k = 0; k < count; k++) {
        n->work[k * count + at] = n->work[at * count + k] = 0;
    }
    n->work[at * count + at] = held * n->A[at * count + at];
    n->step[at] = 0;
}

// (A + lambda P + along) step = -(g + lambda P c), lambda = (weight per length) smoothing^6   (9.6)
status tube_normal_step(const tube_fit *f, tube_normal *n, bool invert)
{
    const tube_curve *c = &f->curve;
    const size_t count = (size_t)n->n;
    const double density = n->sum / c->length, lambda = density * pow(f->smoothing, 6);
    for (size_t k = 0; k < count; k++) {
        n->step[k] = -n->g[k];
        for (size_t l = 0; l < count; l++) {
            n->work[k * count + l] =
                n->A[k * count + l] + along_weight * density * n->along[k * count + l];
        }
    }
    for (int j = 0; j < c->ncoef; j++) {
        for (int k = 0; k < c->ncoef; k++) {
            const double weight = lambda * n->rough[j * c->ncoef + k];
            for (int d = 0; d < 3; d++) {
                n->work[(size_t)(3 * j + d) * count + (size_t)(3 * k + d)] += weight;
                n->step[3 * j + d] -= weight * c->coef[k][d];
            }
        }
    }
    if (!f->free_radius) {
        hold(n, count - 2);
    }
    if (!f->free_taper) {
        hold(n, count - 1);
    }
    return c->door->solve(n->n, n->work, n->step, invert);
}

// trace of (A + ...)^-1 A: how many parameters the points decide
static double freedom_of(const tube_normal *n)
{
    double trace = 0;
    for (int k = 0; k < n->n * n->n; k++) {
        trace += n->work[k] * n->A[k];
    }
    return trace;
}

static double predicted_square(const tube_normal *n)
{
    double square = n->square;
    for (int k = 0; k < n->n; k++) {
        double sum = 0;
        for (int l = 0; l < n->n; l++) {
            sum += n->A[k * n->n + l] * n->step[l];
        }
        square += n->step[k] * (2 * n->g[k] + sum);
    }
    return square;
}

status tube_normal_choose(tube_fit *f, tube_normal *n)
{
    status st = OK;
    double best = INFINITY, chosen = f->smoothing;
    for (int i = 0; i < SMOOTHINGS; i++) {
        f->smoothing = f->radius * least_smoothing * pow(smoothing_step, i);
        TRY(tube_normal_step(f, n, true));
        const double left = n->sum - freedom_price * freedom_of(n);
        const double score =
            left > 0 ? n->sum * predicted_square(n) / (left * left) : (double)INFINITY; // (9.7)
        if (score < best) {
            best = score;
            chosen = f->smoothing;
        }
    }
    f->smoothing = fmax(chosen / bias_margin, least_smoothing * f->radius);

done:
    return st;
}

// variance of one point in units of the weights: Huber's for an M-estimate   (9.8)
static double point_variance(const tube_fit *f, double reach)
{
    double psi = 0, slope = 0, weight = 0, n = 0;
    for (size_t i = 0; i < f->count; i++) {
        const double z = f->res[i] / reach;
        if (fabs(z) < 1) {
            psi += f->weight[i] * f->weight[i] * f->res[i] * f->res[i];
            slope += (1 - z * z) * (1 - 5 * z * z);
            weight += f->weight[i];
            n++;
        }
    }
    const double freedom = fmax(1, n - f->freedom);
    return slope > 0 ? psi / freedom * (weight / n) / (slope / n * slope / n) : (double)NAN;
}

status tube_normal_covariance(tube_fit *f, tube_normal *n, double reach)
{
    status st = OK;
    const size_t count = (size_t)n->n;
    TRY(tube_normal_step(f, n, true));
    f->freedom = freedom_of(n);
    const double variance = point_variance(f, reach);
    free(f->covariance);
    f->covariance = NULL;
    TRY(TAKE(f->covariance, count * count));
    for (size_t k = 0; k < count * count; k++) {
        f->covariance[k] = variance * n->work[k];
    }
    f->radius_sigma = f->free_radius ? sqrt(f->covariance[(count - 2) * (count + 1)]) : 0;
    f->taper_sigma = f->free_taper ? sqrt(f->covariance[count * count - 1]) : 0;

done:
    return st;
}
