// measure/fit_residuals.c
// What the search makes small: distances across the measured lines in standard deviations, made
// independent of their neighbours, and the base's motions.
#include "base/memory.h"
#include "measure/fit_inside.h"

#include <math.h>
#include <string.h>

// Differences over this part of an unknown's range: shapes bend little over it, and the model's
// own rounding and tolerance stay far below.
static const double difference_part = 1e-3;

// --- the model and its derivatives

status fit_solve(fit *f, const double *x)
{
    status st = OK;
    const size_t bytes = (size_t)f->problem->nunknown * sizeof *x;
    if (f->solved && memcmp(f->at, x, bytes) == 0) {
        return OK;
    }
    f->solved = f->derived = false;
    TRY(fit_places(f, x, f->q));
    memcpy(f->at, x, bytes);
    f->solved = true;

done:
    return st;
}

// central; where a bound is near, one-sided and of the same order
status fit_difference(fit *f, const double *x, int unknown, double part, vec3 *dq)
{
    status st = OK;
    const fit_unknown *u = &f->problem->unknown[unknown];
    double y[FIT_MOST_UNKNOWNS];
    vec3 *other = NULL;
    double h = part * f->scale[unknown];
    const bool low = x[unknown] - h<u->lower, high = x[unknown] + h> u->upper;
    h = high && !low ? -h : h;
    memcpy(y, x, (size_t)f->problem->nunknown * sizeof *y);
    TRY(TAKE(other, (size_t)f->nall));
    y[unknown] = x[unknown] + h;
    TRY(fit_places(f, y, dq));
    y[unknown] = low || high ? x[unknown] + 2 * h : x[unknown] - h;
    TRY(fit_places(f, y, other));
    for (int i = 0; i < f->nall; i++) {
        const vec3 d =
            low || high ? vec3_sub(vec3_sub(vec3_scale(4, dq[i]), other[i]), vec3_scale(3, f->q[i]))
                        : vec3_sub(dq[i], other[i]);
        dq[i] = vec3_scale(1 / (2 * h), d);
    }

done:
    free(other);
    return st;
}

status fit_derive(fit *f, const double *x)
{
    status st = OK;
    TRY(fit_solve(f, x));
    for (int k = 0; k < f->nfree && !f->derived; k++) {
        const int u = f->free[k];
        TRY(fit_difference(f, x, u, difference_part, f->dq + (size_t)u * (size_t)f->nall));
    }
    f->derived = true;

done:
    return st;
}

// --- coordinates

int fit_nz(const fit *f)
{
    return f->nfree + 6 * f->nbase;
}

int fit_nr(const fit *f)
{
    return 2 * f->nuse + 6 * f->nbase;
}

// the first of the six coordinates of a shape's base
static int base_of(const fit *f, int shape)
{
    return f->nfree + 6 * (f->nbase > 1 ? shape : 0);
}

// How far off the base may be turned about one axis, one standard deviation. Where a scan had no
// mark its turn about z may be any: that of angles spread evenly over the circle.
static double turn_sigma(const fit *f, int shape, int axis)
{
    static const double any = 1.8137993642342178; // pi / sqrt(3)
    const bool is_free = axis == 2 && f->nbase > 1 && f->problem->shape[shape].line->turn_free;
    return is_free ? any : f->problem->base_turn;
}

pose fit_base_pose(const fit *f, const double *z, int shape)
{
    pose g = pose_identity();
    if (f->nbase > 0) {
        const double *b = z + base_of(f, shape);
        const double shift = f->problem->base_shift;
        g.p = (vec3){{shift * b[0], shift * b[1], shift * b[2]}};
        vec3 turn;
        for (int k = 0; k < 3; k++) {
            turn.a[k] = turn_sigma(f, shape, k) * b[3 + k];
        }
        g.R = so3_exp(turn);
    }
    return g;
}

double fit_sigma(const fit *f, const fit_station *t)
{
    return t->sigma > 0 ? t->sigma : f->sigma;
}

// --- rows

// the model's place for a coordinate's change, in the measured frame
static void station_row(const fit *f, int station, const pose *g, const double *beyond, double *r,
                        double *jacobian)
{
    const fit_station *t = &f->all[station];
    const size_t n = (size_t)f->nall, nz = (size_t)fit_nz(f);
    const double weight = 1 / fit_sigma(f, t);
    vec3 q = f->q[station];
    for (int k = 0; k < f->nfree; k++) { // straight on beyond a bound
        if (beyond[k] != 0) {
            q = vec3_add_scaled(q, beyond[k], f->dq[(size_t)f->free[k] * n + (size_t)station]);
        }
    }
    const vec3 turned = mat3_mul_vec(g->R, q);
    const vec3 off = vec3_sub(vec3_add(turned, g->p), t->at);
    for (int c = 0; c < 2; c++) {
        r[c] = weight * vec3_dot(t->across[c], off);
    }
    for (int c = 0; c < 2 && jacobian; c++) {
        double *row = jacobian + (size_t)c * nz;
        const vec3 back = mat3_tmul_vec(g->R, t->across[c]);
        const vec3 lever = vec3_cross(turned, t->across[c]);
        for (int k = 0; k < f->nfree; k++) {
            const int u = f->free[k];
            row[k] = weight * f->scale[u] * vec3_dot(back, f->dq[(size_t)u * n + (size_t)station]);
        }
        for (int k = 0; k < 3 && f->nbase > 0; k++) {
            double *base = row + base_of(f, t->shape);
            base[k] = weight * f->problem->base_shift * t->across[c].a[k];
            base[3 + k] = weight * turn_sigma(f, t->shape, k) * lever.a[k];
        }
    }
}

// r_i becomes (r_i - rho r_{i-1}) / sqrt(1 - rho^2), rho = exp(-ds / length)     (9.62)
static void whiten(const fit *f, double *r, double *jacobian)
{
    const size_t nz = (size_t)fit_nz(f);
    for (int i = f->nuse - 1; i > 0 && f->length > 0; i--) {
        const fit_station *t = &f->all[f->use[i]], *before = &f->all[f->use[i - 1]];
        if (t->first) {
            continue;
        }
        const double rho = exp(-fabs(t->s - before->s) / f->length);
        const double weight = 1 / sqrt(1 - rho * rho);
        for (size_t c = 0; c < 2; c++) {
            const size_t row = 2 * (size_t)i + c;
            r[row] = weight * (r[row] - rho * r[row - 2]);
            for (size_t k = 0; k < nz && jacobian; k++) {
                jacobian[row * nz + k] =
                    weight * (jacobian[row * nz + k] - rho * jacobian[(row - 2) * nz + k]);
            }
        }
    }
}

// far off: a search that has begun turns back from there
static status no_shape_there(fit *f, status st, double *r)
{
    static const double far = 1e8; // standard deviations
    if (st != ERR_NUMERIC || !f->begun || !r) {
        return st;
    }
    status_clear();
    for (int i = 0; i < fit_nr(f); i++) {
        r[i] = far;
    }
    return OK;
}

static void tell_progress(const fit *f, const double *r)
{
    double chi2 = 0;
    for (int i = 0; i < fit_nr(f); i++) {
        chi2 += r[i] * r[i];
    }
    if (f->problem->progress) {
        f->problem->progress(f->problem->context, f->start, chi2);
    }
}

status fit_residuals(void *context, const double *z, double *r, double *jacobian)
{
    fit *f = context;
    double x[FIT_MOST_UNKNOWNS], beyond[FIT_MOST_UNKNOWNS] = {0};
    bool outside = false;
    memcpy(x, f->x, (size_t)f->problem->nunknown * sizeof *x);
    for (int k = 0; k < f->nfree; k++) {
        const int u = f->free[k];
        const fit_unknown *own = &f->problem->unknown[u];
        const double wanted = own->start + f->scale[u] * z[k];
        x[u] = fmin(fmax(wanted, own->lower), own->upper);
        beyond[k] = wanted - x[u];
        outside = outside || beyond[k] != 0;
    }
    const status st = jacobian || outside ? fit_derive(f, x) : fit_solve(f, x);
    if (st != OK) {
        return no_shape_there(f, st, jacobian ? NULL : r);
    }
    const size_t nz = (size_t)fit_nz(f);
    if (jacobian) {
        memset(jacobian, 0, (size_t)fit_nr(f) * nz * sizeof *jacobian);
    }
    for (int i = 0; i < f->nuse; i++) {
        const pose g = fit_base_pose(f, z, f->all[f->use[i]].shape);
        const size_t row = 2 * (size_t)i;
        station_row(f, f->use[i], &g, beyond, r + row, jacobian ? jacobian + row * nz : NULL);
    }
    whiten(f, r, jacobian);
    for (int k = 0; k < 6 * f->nbase; k++) { // what is known of the base beforehand
        const size_t row = 2 * (size_t)f->nuse + (size_t)k, at = (size_t)(f->nfree + k);
        r[row] = z[at];
        if (jacobian) {
            jacobian[row * nz + at] = 1;
        }
    }
    f->begun = true;
    tell_progress(f, r);
    return OK;
}
