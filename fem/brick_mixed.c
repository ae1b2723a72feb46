// fem/brick_mixed.c
// The change of volume projected on polynomials of a lower order in each element: (5.10).
#include "fem/blas.h"
#include "fem/brick_parts.h"

#include <math.h>
#include <string.h>

// below this the mean Jacobian tells nothing of the element, and its reference coordinates serve
static const double FLAT_ENOUGH = 0.1;

// Total degree below the larger order; in the plane and along s below the order there
void brick_choose_pressures(brick *w)
{
    brick_projection *p = &w->projection;
    const int plane = w->body->plane->order, along = w->body->order;
    const int top = plane > along ? plane : along;
    p->count = 0;
    for (int k = 0; k < along; k++) {
        for (int j = 0; j < plane; j++) {
            for (int i = 0; i + j < plane && i + j + k < top; i++) {
                memcpy(p->power[p->count++], (const int[3]){i, j, k}, sizeof *p->power);
            }
        }
    }
}

static void monomials(const brick_projection *p, const double at[3], const double x[3],
                      double *value)
{
    const vec3 from = {{x[0] - p->centre[0], x[1] - p->centre[1], x[2] - p->centre[2]}};
    vec3 t = {{at[0], at[1], at[2]}};
    if (!p->by_reference) {
        t = mat3_tmul_vec(p->to_local, from);
    }
    double power[3][ELEMENT_MAX_ORDER];
    for (int d = 0; d < 3; d++) {
        power[d][0] = 1;
        for (int i = 1; i < ELEMENT_MAX_ORDER; i++) {
            power[d][i] = power[d][i - 1] * t.a[d];
        }
    }
    for (int k = 0; k < p->count; k++) {
        value[k] = power[0][p->power[k][0]] * power[1][p->power[k][1]] * power[2][p->power[k][2]];
    }
}

static bool factor_gram(const brick *w, brick_projection *p)
{
    memset(p->lower, 0, sizeof p->lower);
    for (int q = 0; q < w->nq; q++) {
        const double *v = p->value + q * p->count;
        for (int r = 0; r < p->count; r++) {
            for (int c = 0; c <= r; c++) {
                p->lower[r][c] += w->dV[q] * v[r] * v[c];
            }
        }
    }
    for (int r = 0; r < p->count; r++) {
        for (int c = 0; c <= r; c++) {
            double sum = p->lower[r][c];
            for (int k = 0; k < c; k++) {
                sum -= p->lower[r][k] * p->lower[c][k];
            }
            p->lower[r][c] = c == r ? sqrt(sum) : sum / p->lower[c][c];
        }
        if (!(p->lower[r][r] > 0)) {
            return false;
        }
    }
    return true;
}

// monomials become orthonormal
static void orthonormalise(const brick_projection *p, double *v)
{
    for (int r = 0; r < p->count; r++) {
        for (int k = 0; k < r; k++) {
            v[r] -= p->lower[r][k] * v[k];
        }
        v[r] /= p->lower[r][r];
    }
}

static void place_at(const brick *w, int q, double at[3])
{
    const basis_table *plane = &w->body->plane_table[w->block];
    memcpy(at, plane->point + 2 * (q % w->np), 2 * sizeof *at);
    at[2] = w->body->line_table.point[q / w->np];
}

status brick_project(brick *w)
{
    brick_projection *p = &w->projection;
    double ratio, volume = 0;
    if (w->projected) {
        return OK;
    }
    brick_places(w);
    p->to_local = brick_mean_jacobian_inverse(w, &ratio);
    p->by_reference = !(ratio > FLAT_ENOUGH);
    memset(p->centre, 0, sizeof p->centre);
    for (int q = 0; q < w->nq; q++) {
        volume += w->dV[q];
        for (int d = 0; d < 3; d++) {
            p->centre[d] += w->dV[q] * w->place[q][d];
        }
    }
    for (int d = 0; d < 3; d++) {
        p->centre[d] /= volume;
    }
    for (int q = 0; q < w->nq; q++) {
        double at[3];
        place_at(w, q, at);
        monomials(p, at, w->place[q], p->value + q * p->count);
    }
    if (!factor_gram(w, p)) {
        return status_fail(ERR_NUMERIC, "segment: an element at (%g, %g, %g) m is too distorted",
                           p->centre[0], p->centre[1], p->centre[2]);
    }
    double *weighted = w->more;
    for (int q = 0; q < w->nq; q++) {
        double *v = p->value + q * p->count;
        orthonormalise(p, v);
        for (int k = 0; k < p->count; k++) {
            weighted[q * p->count + k] = w->dV[q] * v[k];
        }
    }
    blas_product(p->count, 3 * w->n, w->nq, weighted, w->grad, 0, p->P);
    w->projected = true;
    return OK;
}

double brick_projected(const brick *w, const double at[3], const double x[3], const double *u)
{
    const brick_projection *p = &w->projection;
    double value[BRICK_MAX_PRESSURES], sum = 0;
    monomials(p, at, x, value);
    orthonormalise(p, value);
    for (int k = 0; k < p->count; k++) {
        const double *row = p->P + 3 * (size_t)k * (size_t)w->n;
        double moment = 0;
        for (int i = 0; i < 3 * w->n; i++) {
            moment += row[i] * u[3 * (i % w->n) + i / w->n];
        }
        sum += value[k] * moment;
    }
    return sum;
}

void brick_add_bulk(brick *w, double bulk, double scale, double *sum)
{
    const brick_projection *p = &w->projection;
    const int n3 = 3 * w->n, count = p->count;
    double M[BRICK_MAX_PRESSURES][BRICK_MAX_PRESSURES] = {{0}};
    for (int q = 0; q < w->nq; q++) {
        const double *v = p->value + q * count, weight = bulk * w->grade[q] * w->dV[q];
        for (int r = 0; r < count; r++) {
            for (int c = 0; c < count; c++) {
                M[r][c] += weight * v[r] * v[c];
            }
        }
    }
    double *MP = w->more;
    memset(MP, 0, (size_t)count * (size_t)n3 * sizeof *MP);
    for (int r = 0; r < count; r++) {
        for (int c = 0; c < count; c++) {
            for (int i = 0; i < n3; i++) {
                MP[r * n3 + i] += M[r][c] * p->P[c * n3 + i];
            }
        }
    }
    const double one = 1;
    dgemm_("N", "T", &n3, &n3, &count, &one, MP, &n3, p->P, &n3, &scale, sum, &n3);
}

// K += D^T W R + its transpose, D = projected - own change of volume, R = m^T Q B / 3 + m^T Q m D /
// 18, m = (1 1 1 0 0 0)
void brick_add_projection(brick *w, double *K)
{
    const brick_projection *p = &w->projection;
    const int n = w->n, n3 = 3 * n;
    const double one = 1, minus = -1;
    double *D = w->work, *R = w->more, *T = w->sum;
    memcpy(D, w->grad, (size_t)w->nq * (size_t)n3 * sizeof *D);
    dgemm_("N", "N", &n3, &w->nq, &p->count, &one, p->P, &n3, p->value, &p->count, &minus, D, &n3);
    for (int q = 0; q < w->nq; q++) {
        const mat6 *Q = &w->stiffness[q];
        double m[6], bulk = 0;
        for (int c = 0; c < 6; c++) {
            m[c] = w->dV[q] * (Q->a[0][c] + Q->a[1][c] + Q->a[2][c]);
            bulk += c < 3 ? m[c] : 0;
        }
        const double *g = w->grad + (size_t)q * (size_t)n3, *d = D + (size_t)q * (size_t)n3;
        double *to = R + (size_t)q * (size_t)n3;
        for (int k = 0; k < 3; k++) {
            const int *s = brick_strain[k];
            for (int b = 0; b < n; b++) {
                to[k * n + b] = (m[s[0]] * g[b] + m[s[1]] * g[n + b] + m[s[2]] * g[2 * n + b]) / 3 +
                                bulk * d[k * n + b] / 18;
            }
        }
    }
    blas_product(n3, n3, w->nq, D, R, 0, T);
    for (int r = 0; r < n3; r++) {
        double *to = K + (size_t)(3 * (r % n) + r / n) * (size_t)n3;
        for (int s = 0; s < n3; s++) {
            to[3 * (s % n) + s / n] +=
                T[(size_t)r * (size_t)n3 + (size_t)s] + T[(size_t)s * (size_t)n3 + (size_t)r];
        }
    }
}
