// fem/section_fit.c
#include "fem/section_fit.h"

#include "base/beam_law.h"
#include "base/memory.h"

#include <string.h>

void section_fit_free(section_fit *fit)
{
    free(fit->force);
    *fit = (section_fit){0};
}

// component `direction` at (x, y) of the rigid motion number j: v + w x r
static double rigid(int j, int direction, double x, double y)
{
    const double motion[6][3] = {{1, 0, 0}, {0, 1, 0},  {0, 0, 1},
                                 {0, 0, y}, {0, 0, -x}, {-y, x, 0}};
    return motion[j][direction];
}

// force[j] += w int N N^T (nodal values of rigid motion j) over one element
static void add_element(const mesh *plane, const int *conn, const plane_matrices *p, double weight,
                        double *force)
{
    const size_t all = 3 * (size_t)plane->nnode;
    for (int a = 0; a < p->nnode; a++) {
        for (int b = 0; b < p->nnode; b++) {
            const double *x = plane->xyz + 3 * (size_t)conn[b];
            const double mass = weight * p->mass[a * p->nnode + b];
            for (int j = 0; j < 6; j++) {
                double *to = force + (size_t)j * all + 3 * (size_t)conn[a];
                for (int i = 0; i < 3; i++) {
                    to[i] += mass * rigid(j, i, x[0], x[1]);
                }
            }
        }
    }
}

static status add_elements(const column *c, fit_weight weight, double *force)
{
    status st = OK;
    plane_matrices *p = NULL;
    TRY(TAKE(p, 1));
    for (int b = 0; b < c->plane->nblock; b++) {
        const mesh_block *k = &c->plane->block[b];
        for (int e = 0; e < k->nelem; e++) {
            TRY(plane_matrices_make(c, b, e, p));
            add_element(c->plane, k->conn + (size_t)e * (size_t)k->per_elem, p,
                        weight == WEIGHT_E ? c->materials[k->material[e]].E : 1, force);
        }
    }

done:
    free(p);
    return st;
}

// Gram matrix of the rigid motions under the weight: virtual work of force[i] on motion j
static mat6 gram_matrix(const mesh *plane, const double *force)
{
    mat6 A = {0};
    const size_t n = (size_t)plane->nnode;
    for (int i = 0; i < 6; i++) {
        for (size_t a = 0; a < n; a++) {
            const double *f = force + 3 * ((size_t)i * n + a), *x = plane->xyz + 3 * a;
            for (int j = 0; j < 6; j++) {
                for (int d = 0; d < 3; d++) {
                    A.a[i][j] += f[d] * rigid(j, d, x[0], x[1]);
                }
            }
        }
    }
    return mat6_symmetric(A);
}

status section_fit_make(const column *c, fit_weight weight, section_fit *out)
{
    status st = OK;
    section_fit fit = {.nplane = c->plane->nnode};
    double *raw = NULL;
    mat6 inverse;
    const size_t all = 3 * (size_t)fit.nplane;

    TRY(TAKE(raw, 6 * all));
    TRY(TAKE(fit.force, 6 * all));
    TRY(add_elements(c, weight, raw));
    const mat6 A = gram_matrix(c->plane, raw);
    if (!mat6_inverse_spd(A, &inverse)) {
        TRY(status_fail(ERR_NUMERIC, "segment: the section has no extent"));
    }
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            for (size_t a = 0; inverse.a[i][j] != 0 && a < all; a++) {
                fit.force[(size_t)i * all + a] += inverse.a[i][j] * raw[(size_t)j * all + a];
            }
        }
    }
    fit.weight = A.a[NZ][NZ];
    fit.centroid[0] = -A.a[NZ][MY] / fit.weight;
    fit.centroid[1] = A.a[NZ][MX] / fit.weight;
    *out = fit;
    fit = (section_fit){0};

done:
    free(raw);
    section_fit_free(&fit);
    return st;
}

vec6 section_fit_motion(const section_fit *fit, const double *u)
{
    vec6 q = {0};
    const size_t all = 3 * (size_t)fit->nplane;
    for (int i = 0; i < 6; i++) {
        const double *f = fit->force + (size_t)i * all;
        for (size_t a = 0; a < all; a++) {
            q.a[i] += f[a] * u[a];
        }
    }
    return q;
}
