// fem/iterative_cg.c
// Conjugate gradients, all columns side by side; the coarse space is taken out of every direction
// (a deflated method, (5.14b)).
#include "fem/iterative.h"

#include "base/memory.h"
#include "fem/mesh_axes.h"

#include <math.h>
#include <string.h>

// of the energy norm of the error over that of the solution; compliances are as good as its square,
// and what is linear in the displacements as good as this
static const double ENERGY_TOLERANCE = 1e-9;

// the error of an iterate is estimated by what this many further steps add to the energy
enum { WINDOW = 3, MOST_ITERATIONS = 600 };

// backward error at which a solution is one: far above rounding, far below what meshes miss
static const double RESIDUAL_LIMIT = 1e-8;

typedef struct column {
    double energy;        // of the iterate: b . x
    double added[WINDOW]; // by the latest steps
    double rz;
    bool done;
} column;

// --- sums over columns

// (all) sum_i a_i c_i of each column: [ncol]
static void dots(const iterative *w, const double *a, const double *c, double *sum)
{
    const size_t n = (size_t)w->ncol;
    memset(sum, 0, n * sizeof *sum);
    for (size_t i = 0; i < w->own; i += n) {
        for (size_t k = 0; k < n; k++) {
            sum[k] += a[i + k] * c[i + k];
        }
    }
    w->door->sum(w->ncol, sum);
}

// to += factor of its column times from
static void add_columns(const iterative *w, const double *factor, const double *from, double *to)
{
    const size_t n = (size_t)w->ncol;
    for (size_t i = 0; i < w->own; i += n) {
        for (size_t k = 0; k < n; k++) {
            to[i + k] += factor[k] * from[i + k];
        }
    }
}

// --- corrections

// fields into the sections' axes, or back
static void turn(const iterative *w, bool back, double *u)
{
    const size_t run = w->block / 3;
    for (int level = w->share.first; level < w->share.last; level++) {
        const mat3 axes = mesh_axes(w->p->body, level);
        const mat3 R = back ? axes : mat3_transpose(axes);
        double *at = u + (size_t)(level - w->share.first) * w->block;
        for (size_t i = 0; i < run; i++) {
            const vec3 v = mat3_mul_vec(R, (vec3){{at[i], at[run + i], at[2 * run + i]}});
            at[i] = v.a[0];
            at[run + i] = v.a[1];
            at[2 * run + i] = v.a[2];
        }
    }
}

// z = S r and then what the coarse space still sees of r - K z; q is working storage
static status correct(iterative *w)
{
    status st = OK;
    const double *r = w->r;
    memset(w->z, 0, (w->own + w->block) * sizeof *w->z);
    if (!w->p->body->prism) {
        memcpy(w->turned, w->r, w->own * sizeof *w->r);
        turn(w, false, w->turned);
        r = w->turned;
    }
    TRY(w->door->agree(separable_solve(w->separable, w->ncol, r, w->z)));
    if (!w->p->body->prism) {
        turn(w, true, w->z);
    }
    TRY(iterative_product(w, w->z, w->q));
    for (size_t i = 0; i < w->own; i++) {
        w->q[i] = w->r[i] - w->q[i];
    }
    coarse_solve(w->coarse, w->ncol, w->q, w->y);
    coarse_add(w->coarse, w->ncol, w->y, w->z);

done:
    return st;
}

// --- steps

static void note_norm(iterative *w, const double *most_q, const double *most_d)
{
    for (int k = 0; k < w->ncol; k++) {
        w->norm = most_d[k] > 0 ? fmax(w->norm, most_q[k] / most_d[k]) : w->norm;
    }
}

// one step along the directions; factor is working storage [3 ncol]
static status step(iterative *w, column *columns, double *factor)
{
    status st = OK;
    double *curve = factor + w->ncol, *most = factor + 2 * w->ncol;
    TRY(iterative_product(w, w->d, w->q));
    dots(w, w->d, w->q, curve);
    for (int k = 0; k < w->ncol; k++) {
        column *c = &columns[k];
        if (!c->done && !(curve[k] > 0)) {
            TRY(status_fail(ERR_NUMERIC,
                            "segment: the stiffness is not positive definite after %d iterations",
                            w->iterations));
        }
        factor[k] = c->done ? 0 : c->rz / curve[k];
        memmove(c->added, c->added + 1, (WINDOW - 1) * sizeof *c->added);
        c->added[WINDOW - 1] = factor[k] * c->rz;
        c->energy += c->added[WINDOW - 1];
    }
    add_columns(w, factor, w->d, w->x);
    if (w->iterations < WINDOW) { // early directions have all of the spectrum in them
        TRY(iterative_largest(w, w->q, true, curve));
        TRY(iterative_largest(w, w->d, false, most));
        note_norm(w, curve, most);
    }
    for (int k = 0; k < w->ncol; k++) {
        factor[k] = -factor[k];
    }
    add_columns(w, factor, w->q, w->r);

done:
    return st;
}

static bool all_done(iterative *w, column *columns)
{
    bool all = true;
    for (int k = 0; k < w->ncol; k++) {
        double left = 0;
        for (int i = 0; i < WINDOW; i++) {
            left += columns[k].added[i];
        }
        const double limit = ENERGY_TOLERANCE * ENERGY_TOLERANCE * columns[k].energy;
        columns[k].done |= w->iterations >= WINDOW && left <= limit;
        all &= columns[k].done;
    }
    return all;
}

static void new_directions(iterative *w, column *columns, double *rz, double *factor)
{
    const size_t n = (size_t)w->ncol;
    for (size_t k = 0; k < n; k++) {
        column *c = &columns[k];
        factor[k] = w->iterations > 0 && c->rz > 0 ? rz[k] / c->rz : 0;
        c->rz = rz[k];
        c->done |= !(rz[k] > 0); // nothing left
    }
    for (size_t i = 0; i < w->own; i += n) {
        for (size_t k = 0; k < n; k++) {
            w->d[i + k] = w->z[i + k] + factor[k] * w->d[i + k];
        }
    }
}

static status check_cancelled(const iterative *w, const way_wants *wants)
{
    double stop = wants->cancelled && wants->cancelled() ? 1 : 0;
    w->door->largest(1, &stop);
    return stop > 0 ? status_fail(ERR_INTERRUPTED, "interrupted") : OK;
}

// r = b - K x, and its backward error
static status true_residual(iterative *w, double *most)
{
    status st = OK;
    double *of_x = most + w->ncol, *of_b = most + 2 * w->ncol;
    TRY(iterative_product(w, w->x, w->q));
    for (size_t i = 0; i < w->own; i++) {
        w->r[i] = w->b[i] - w->q[i];
    }
    TRY(iterative_largest(w, w->r, true, most));
    TRY(iterative_largest(w, w->x, false, of_x));
    TRY(iterative_largest(w, w->b, true, of_b));
    w->residual = 0;
    for (int k = 0; k < w->ncol; k++) {
        const double scale = w->norm * of_x[k] + of_b[k];
        w->residual = scale > 0 ? fmax(w->residual, most[k] / scale) : w->residual;
    }

done:
    return st;
}

// x = Q b: from there on the coarse space sees nothing of the residual
static status begin(iterative *w, column *columns, double *sums)
{
    status st = OK;
    memset(w->x, 0, (w->own + w->block) * sizeof *w->x);
    coarse_solve(w->coarse, w->ncol, w->b, w->y);
    coarse_add(w->coarse, w->ncol, w->y, w->x);
    dots(w, w->b, w->x, sums);
    for (int k = 0; k < w->ncol; k++) {
        columns[k].energy = sums[k];
    }
    TRY(iterative_product(w, w->x, w->q));
    for (size_t i = 0; i < w->own; i++) {
        w->r[i] = w->b[i] - w->q[i];
    }

done:
    return st;
}

status iterative_solve(iterative *w, const way_wants *wants)
{
    status st = OK;
    column *columns = NULL;
    double *sums = NULL, *factor = NULL;
    TRY(TAKE(columns, (size_t)w->ncol));
    TRY(TAKE(sums, (size_t)w->ncol));
    TRY(TAKE(factor, 3 * (size_t)w->ncol));
    TRY(begin(w, columns, sums));
    for (w->iterations = 0; w->iterations < MOST_ITERATIONS; w->iterations++) {
        TRY(check_cancelled(w, wants));
        TRY(correct(w));
        dots(w, w->r, w->z, sums);
        new_directions(w, columns, sums, factor);
        if (all_done(w, columns)) {
            break;
        }
        TRY(step(w, columns, factor));
    }
    TRY(true_residual(w, factor));
    if (w->iterations == MOST_ITERATIONS || !(w->residual <= RESIDUAL_LIMIT)) {
        TRY(status_fail(ERR_NUMERIC,
                        "segment: conjugate gradients stagnate: residual %.2g after %d iterations",
                        w->residual, w->iterations));
    }

done:
    free(columns);
    free(sums);
    free(factor);
    return st;
}
