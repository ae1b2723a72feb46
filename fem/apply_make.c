// fem/apply_make.c
// What the products of apply.h need of each element.
#include "fem/apply_parts.h"

#include "base/memory.h"

#include <string.h>

void apply_free(apply *a)
{
    if (!a) {
        return;
    }
    for (int i = 0; a->element && i < a->nelem; i++) {
        free(a->element[i].slopes);
        free(a->element[i].area);
        free(a->element[i].grade);
        free(a->element[i].Q);
        free(a->element[i].point);
    }
    free(a->element);
    free(a->nodal);
    free(a->flat);
    free(a->flat_to);
    free(a->solid);
    free(a);
}

static size_t layer_points(const apply *a, const apply_element *e)
{
    return (size_t)a->nl * (size_t)e->np;
}

// slopes along the section's coordinates, and the area of each point
static status take_slopes(const apply *a, const basis_table *t, apply_element *e)
{
    status st = OK;
    const size_t n2 = (size_t)e->n2, np = (size_t)e->np;
    TRY(TAKE(e->slopes, 3 * np * n2));
    TRY(TAKE(e->area, np));
    for (size_t q = 0; q < np; q++) {
        const double *dN = t->dN + 2 * q * n2;
        double J[2][2] = {{0}};
        for (size_t k = 0; k < n2; k++) {
            const double *x = a->body->plane->xyz + 3 * (size_t)e->conn[k];
            for (int i = 0; i < 2; i++) {
                J[i][0] += x[i] * dN[2 * k];
                J[i][1] += x[i] * dN[2 * k + 1];
            }
        }
        const double det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
        e->area[q] = det * t->weight[q];
        if (!(det > 0)) {
            TRY(status_fail(ERR_NUMERIC, "segment: a plane element is inverted, det J = %.3g",
                            det));
        }
        for (size_t k = 0; k < n2; k++) {
            const double u = dN[2 * k], v = dN[2 * k + 1];
            e->slopes[q * n2 + k] = (J[1][1] * u - J[1][0] * v) / det;
            e->slopes[(np + q) * n2 + k] = (J[0][0] * v - J[0][1] * u) / det;
            e->slopes[(2 * np + q) * n2 + k] = t->N[q * n2 + k];
        }
    }

done:
    return st;
}

// One height of a layer, and the section's pose there.
typedef struct height {
    int layer, t;
    double s;
    mat3 axes;
    double origin[3];
} height;

static height height_at(const apply *a, int layer, int t)
{
    const body *b = a->body;
    height h = {.layer = layer, .t = t};
    const double at = b->line_table.point[t], begin = b->level[layer * b->order];
    h.s = begin + (b->level[(layer + 1) * b->order] - begin) * (at + 1) / 2;
    body_pose_at(b, layer, at, &h.axes, h.origin);
    return h;
}

// x, y in the section of a plane point at this height
static vec3 section_place(const apply *a, const apply_element *e, const height *h, int q)
{
    const body *b = a->body;
    const double *N = e->slopes + (size_t)(2 * e->np + q) * (size_t)e->n2;
    vec3 r = {{-h->origin[0], -h->origin[1], -h->origin[2]}};
    for (int k = 0; k <= b->order; k++) {
        for (int i = 0; i < e->n2; i++) {
            double x[3];
            body_node(b, e->conn[i], h->layer * b->order + k, x);
            for (int d = 0; d < 3; d++) {
                r.a[d] += a->L[h->t][k] * N[i] * x[d];
            }
        }
    }
    return mat3_tmul_vec(h->axes, r);
}

// grades and laws of one height, where the element has any
static status take_height(const apply *a, int block, int number, const height *h, double *grade,
                          mat6 *Q, apply_element *e)
{
    status st = OK;
    const mesh_block *k = &a->body->plane->block[block];
    const mat6 turn = material_frame_strain_map(mat3_transpose(h->axes));
    TRY(brick_law_at(a->body, block, number, k->material[number], h->s, &e->law));
    for (int q = 0; q < e->np; q++) {
        const vec3 x = section_place(a, e, h, q);
        if (grade) {
            TRY(brick_grade(&e->law, x.a[0], x.a[1], h->s, &grade[q]));
        }
        if (Q && q > 0 && !brick_law_is_polar(&e->law)) {
            Q[q] = Q[0];
        } else if (Q) {
            Q[q] = brick_section_stiffness(&e->law, x.a[0], x.a[1]);
            Q[q] = a->body->prism ? Q[q] : mat6_symmetric(mat6_congruence(turn, Q[q]));
        }
    }

done:
    return st;
}

static status take_law(const apply *a, int block, int number, apply_element *e)
{
    status st = OK;
    const mesh_block *k = &a->body->plane->block[block];
    const material *m = &a->body->spec.materials[k->material[number]];
    const bool graded = m->modulus.at, isotropic = m->kind == MATERIAL_ISOTROPIC;
    e->along = (graded || !isotropic) && (!a->body->prism || material_varies(m));
    const int layers = e->along ? a->last_layer - a->first_layer : 1;
    const size_t heights = e->along ? (size_t)layers * (size_t)a->nl : 1, np = (size_t)e->np;
    if (graded) {
        TRY(TAKE(e->grade, heights * np));
    }
    if (!isotropic) {
        TRY(TAKE(e->Q, heights * np));
    }
    for (size_t i = 0; i < heights; i++) {
        const height h = height_at(a, a->first_layer + (int)i / a->nl, (int)i % a->nl);
        TRY(take_height(a, block, number, &h, graded ? e->grade + i * np : NULL,
                        isotropic ? NULL : e->Q + i * np, e));
    }

done:
    return st;
}

// J[i][j] = dx_i / d(X, Y, s)_j of all points of a layer
static void add_jacobians(const apply *a, const apply_element *e, int layer, double (*J)[3][3])
{
    const body *b = a->body;
    const int p = b->order;
    const double half = (b->level[(layer + 1) * p] - b->level[layer * p]) / 2;
    const size_t n2 = (size_t)e->n2, np = (size_t)e->np;
    memset(J, 0, layer_points(a, e) * sizeof *J);
    for (int k = 0; k <= p; k++) {
        for (size_t i = 0; i < n2; i++) {
            double x[3];
            body_node(b, e->conn[i], layer * p + k, x);
            for (size_t at = 0; at < layer_points(a, e); at++) {
                const size_t q = at % np, t = at / np;
                const double slope[3] = {a->L[t][k] * e->slopes[q * n2 + i],
                                         a->L[t][k] * e->slopes[(np + q) * n2 + i],
                                         a->dL[t][k] / half * e->slopes[(2 * np + q) * n2 + i]};
                for (int r = 0; r < 3; r++) {
                    for (int c = 0; c < 3; c++) {
                        J[at][r][c] += x[r] * slope[c];
                    }
                }
            }
        }
    }
}

// rows of the inverse are the cross products of the columns over the determinant
static double invert(const double J[3][3], double inverse[3][3])
{
    vec3 column[3], cross[3];
    for (int c = 0; c < 3; c++) {
        column[c] = (vec3){{J[0][c], J[1][c], J[2][c]}};
    }
    for (int c = 0; c < 3; c++) {
        cross[c] = vec3_cross(column[(c + 1) % 3], column[(c + 2) % 3]);
    }
    const double det = vec3_dot(column[0], cross[0]);
    for (int c = 0; c < 3; c++) {
        for (int i = 0; i < 3; i++) {
            inverse[c][i] = cross[c].a[i] / det;
        }
    }
    return det;
}

static status take_points(const apply *a, apply_element *e)
{
    status st = OK;
    const body *b = a->body;
    const size_t count = layer_points(a, e);
    double(*J)[3][3] = NULL;
    TRY(TAKE(J, count));
    TRY(TAKE(e->point, count * (size_t)(a->last_layer - a->first_layer)));
    for (int layer = a->first_layer; layer < a->last_layer; layer++) {
        const int p = b->order;
        const double half = (b->level[(layer + 1) * p] - b->level[layer * p]) / 2;
        add_jacobians(a, e, layer, J);
        for (size_t at = 0; at < count; at++) {
            apply_point *to = e->point + (size_t)(layer - a->first_layer) * count + at;
            const double det = invert((const double(*)[3])J[at], to->back);
            to->dV =
                det * half * b->line_table.weight[at / (size_t)e->np] * e->area[at % (size_t)e->np];
            if (!(det > 0)) {
                TRY(status_fail(ERR_NUMERIC,
                                "segment: an element of layer %d is inverted, det J = %.3g", layer,
                                det));
            }
        }
    }

done:
    free(J);
    return st;
}

static status take_element(apply *a, int block, int number, apply_element *e)
{
    status st = OK;
    const mesh_block *k = &a->body->plane->block[block];
    const basis_table *table = &a->body->plane_table[block];
    e->conn = k->conn + (size_t)number * (size_t)k->per_elem;
    e->n2 = k->per_elem;
    e->np = table->npoint;
    a->most_nodes = e->n2 > a->most_nodes ? e->n2 : a->most_nodes;
    a->most_points = e->np > a->most_points ? e->np : a->most_points;
    TRY(take_slopes(a, table, e));
    TRY(take_law(a, block, number, e));
    if (!a->body->prism) {
        TRY(take_points(a, e));
    }

done:
    return st;
}

static status take_elements(apply *a)
{
    status st = OK;
    const mesh *plane = a->body->plane;
    int next = 0;
    a->nelem = mesh_element_count(plane);
    TRY(TAKE(a->element, (size_t)a->nelem));
    for (int k = 0; k < plane->nblock; k++) {
        for (int e = 0; e < plane->block[k].nelem; e++) {
            TRY(take_element(a, k, e, &a->element[next++]));
        }
    }

done:
    return st;
}

status apply_make(const body *b, int first_layer, int last_layer, apply **out)
{
    status st = OK;
    apply *a = NULL;
    TRY(TAKE(a, 1));
    *a = (apply){.body = b,
                 .first_layer = first_layer,
                 .last_layer = last_layer,
                 .nl = b->line_table.npoint};
    if (b->spec.matter || b->spec.mixed || a->nl > APPLY_MAX_LINE_POINTS) {
        TRY(status_fail(ERR_BUG, "segment: no product without a matrix for such a body"));
    }
    for (int t = 0; t < a->nl; t++) {
        for (int k = 0; k <= b->order; k++) {
            a->L[t][k] = b->line_table.N[t * (b->order + 1) + k];
            a->dL[t][k] = b->line_table.dN[t * (b->order + 1) + k];
        }
    }
    if (first_layer < last_layer) {
        TRY(take_elements(a));
    }
    *out = a;
    a = NULL;

done:
    apply_free(a);
    return st;
}
