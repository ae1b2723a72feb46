// fem/level_fit.c
#include "fem/level_fit.h"

#include "base/memory.h"
#include "fem/brick_law.h"

#include <math.h>
#include <string.h>

void level_fit_free(level_fit *fit)
{
    free(fit->force);
    *fit = (level_fit){0};
}

// A level and the rigid motions about its section's origin.
typedef struct fitter {
    const body *body;
    int level, layer;
    level_weight weight;
    double origin[3];
    double *raw; // [6][nplane][3] int w N (rigid motion)
    mat3 axes;   // of the section
    mat6 gram;   // int w (rigid motion i) . (rigid motion j)
} fitter;

// v + w x r of motion j
static vec3 rigid(int j, vec3 r)
{
    vec3 unit = {0};
    unit.a[j % 3] = 1;
    return j < 3 ? unit : vec3_cross(unit, r);
}

// weight times the area that quadrature point q of an element stands for, its place about the
// origin
static status weigh(const fitter *f, int block, const int *conn, const brick_law *law,
                    double modulus, int q, double *weight, vec3 *r)
{
    status st = OK;
    const basis_table *t = &f->body->plane_table[block];
    const double *N = t->N + q * t->nnode, *dN = t->dN + 2 * q * t->nnode;
    vec3 x = {0}, u = {0}, v = {0};
    double grade = 1;
    for (int a = 0; a < t->nnode; a++) {
        vec3 node;
        body_node(f->body, conn[a], f->level, node.a);
        x = vec3_add_scaled(x, N[a], node);
        u = vec3_add_scaled(u, dN[2 * a], node);
        v = vec3_add_scaled(v, dN[2 * a + 1], node);
    }
    *r = vec3_sub(x, (vec3){{f->origin[0], f->origin[1], f->origin[2]}});
    if (f->weight == LEVEL_BY_E) {
        const vec3 own = mat3_tmul_vec(f->axes, *r);
        TRY(brick_grade(law, own.a[0], own.a[1], f->body->level[f->level], &grade));
        grade *= modulus;
    }
    *weight = grade * t->weight[q] * vec3_norm(vec3_cross(u, v));

done:
    return st;
}

static status add_element(fitter *f, int block, int e)
{
    status st = OK;
    const mesh_block *k = &f->body->plane->block[block];
    const basis_table *t = &f->body->plane_table[block];
    const int *conn = k->conn + (size_t)e * (size_t)k->per_elem;
    const int material = body_material(f->body, block, e, f->layer);
    brick_law law;
    if (material < 0) {
        return OK;
    }
    TRY(brick_law_at(f->body, block, e, material, f->body->level[f->level], &law));
    const double modulus = brick_modulus_along(&law);
    for (int q = 0; q < t->npoint; q++) {
        double w;
        vec3 r, m[6];
        TRY(weigh(f, block, conn, &law, modulus, q, &w, &r));
        for (int j = 0; j < 6; j++) {
            m[j] = rigid(j, r);
            for (int i = 0; i <= j; i++) {
                f->gram.a[i][j] += w * vec3_dot(m[i], m[j]);
                f->gram.a[j][i] = f->gram.a[i][j];
            }
            double *to = f->raw + 3 * (size_t)j * (size_t)f->body->plane->nnode;
            for (int a = 0; a < t->nnode; a++) {
                const double part = w * t->N[q * t->nnode + a];
                for (int d = 0; d < 3; d++) {
                    to[3 * (size_t)conn[a] + (size_t)d] += part * m[j].a[d];
                }
            }
        }
    }

done:
    return st;
}

// combinations of the raw tractions whose work on motion j is 1 or 0
static status conjugate(const fitter *f, level_fit *fit)
{
    mat6 inverse;
    const size_t all = 3 * (size_t)fit->nplane;
    if (!mat6_inverse_spd(f->gram, &inverse)) {
        return status_fail(ERR_NUMERIC, "segment: the section at s = %g m has no extent",
                           f->body->level[f->level]);
    }
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            for (size_t a = 0; inverse.a[i][j] != 0 && a < all; a++) {
                fit->force[(size_t)i * all + a] += inverse.a[i][j] * f->raw[(size_t)j * all + a];
            }
        }
    }
    return OK;
}

// first moments from the work of translations on rotations: int w e_i . (e_j x r)
static void find_centroid(const fitter *f, level_fit *fit)
{
    const mat6 *A = &f->gram;
    fit->weight = A->a[0][0];
    const vec3 c = {{A->a[1][5] / fit->weight, A->a[2][3] / fit->weight, A->a[0][4] / fit->weight}};
    const vec3 own = mat3_tmul_vec(f->axes, c);
    fit->centroid[0] = own.a[0];
    fit->centroid[1] = own.a[1];
}

status level_fit_make(const body *b, int level, level_weight weight, level_fit *out)
{
    status st = OK;
    level_fit fit = {.nplane = b->plane->nnode};
    fitter f = {.body = b,
                .level = level,
                .layer = level > 0 ? (level - 1) / b->order : 0,
                .weight = weight};
    body_origin(b, level, f.origin);
    f.axes = body_axes(b, level);
    TRY(TAKE(f.raw, 18 * (size_t)fit.nplane));
    TRY(TAKE(fit.force, 18 * (size_t)fit.nplane));
    for (int k = 0; k < b->plane->nblock; k++) {
        for (int e = 0; e < b->plane->block[k].nelem; e++) {
            TRY(add_element(&f, k, e));
        }
    }
    TRY(conjugate(&f, &fit));
    find_centroid(&f, &fit);
    *out = fit;
    fit = (level_fit){0};

done:
    free(f.raw);
    level_fit_free(&fit);
    return st;
}

vec6 level_fit_motion(const level_fit *fit, const double *u)
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
