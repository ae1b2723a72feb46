// fem/plane_forms.c
#include "fem/plane_forms.h"

#include "base/memory.h"
#include "fem/blas.h"
#include "fem/brick_law.h"
#include "fem/mesh_axes.h"

#include <math.h>
#include <string.h>

void plane_forms_free(plane_forms *f)
{
    free(f->value);
    free(f->at);
    *f = (plane_forms){0};
}

static const mesh_block *element_of(const mesh *plane, size_t number, int *e)
{
    const size_t first = (size_t)plane->block[0].nelem;
    *e = (int)(number < first ? number : number - first);
    return &plane->block[number < first ? 0 : 1];
}

// --- what turning adds

// axes that turn with the mesh at s
static status axes_at(const body *b, double s, double *xyz, mat3 *axes)
{
    status st = OK;
    double origin[3];
    TRY(b->spec.shape.place(b->spec.shape.self, s, xyz, axes, origin));
    *axes = mat3_mul(*axes, mat3_rot_z(mesh_angle(b->plane, xyz, *axes, origin)));

done:
    return st;
}

// turns per length of the mesh about the sections' normal, in the middle of the body
static status turn_rate(const body *b, double *rate)
{
    status st = OK;
    double *xyz = NULL;
    mat3 below, above;
    const double step = 1e-3 * b->length, middle = b->level[0] + b->length / 2;
    *rate = b->spec.turn_rate;
    if (!b->spec.shape.place) {
        return OK;
    }
    TRY(TAKE(xyz, 3 * (size_t)b->plane->nnode));
    TRY(axes_at(b, middle, xyz, &below));
    TRY(axes_at(b, middle + step, xyz, &above));
    const mat3 R = mat3_mul(mat3_transpose(below), above);
    *rate = atan2(R.a[1][0] - R.a[0][1], R.a[0][0] + R.a[1][1]) / step;

done:
    free(xyz);
    return st;
}

// --- one element

// One point: slopes of the basis, place, law times area.
typedef struct plane_point {
    int n2;
    double N[ELEMENT_MAX_PLANE_NODES], X[ELEMENT_MAX_PLANE_NODES], Y[ELEMENT_MAX_PLANE_NODES];
    double x[2], rate;
    mat6 Q;
} plane_point;

static double find_slopes(const body *b, const int *conn, const basis_table *t, int q,
                          plane_point *p)
{
    const double *N = t->N + q * p->n2, *dN = t->dN + 2 * q * p->n2;
    double J[2][2] = {{0}};
    p->x[0] = p->x[1] = 0;
    for (int k = 0; k < p->n2; k++) {
        const double *x = b->plane->xyz + 3 * (size_t)conn[k];
        for (int i = 0; i < 2; i++) {
            p->x[i] += N[k] * x[i];
            J[i][0] += x[i] * dN[2 * k];
            J[i][1] += x[i] * dN[2 * k + 1];
        }
    }
    const double det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
    for (int k = 0; k < p->n2; k++) {
        p->N[k] = N[k];
        p->X[k] = (J[1][1] * dN[2 * k] - J[1][0] * dN[2 * k + 1]) / det;
        p->Y[k] = (J[0][0] * dN[2 * k + 1] - J[0][1] * dN[2 * k]) / det;
    }
    return det * t->weight[q];
}

static status find_law(const body *b, int block, int e, double area, plane_point *p)
{
    status st = OK;
    const double s = b->level[0] + b->length / 2;
    brick_law law;
    double grade = 1;
    TRY(brick_law_at(b, block, e, b->plane->block[block].material[e], s, &law));
    TRY(brick_grade(&law, p->x[0], p->x[1], s, &grade));
    p->Q = mat6_scale(area * grade, brick_section_stiffness(&law, p->x[0], p->x[1]));

done:
    return st;
}

// strains B [6][3 n2] and S N [6][3 n2], order xx yy zz yz xz xy
static void strains(const plane_point *p, double *B, double *SN)
{
    const int n = p->n2, n3 = 3 * n;
    memset(B, 0, 6 * (size_t)n3 * sizeof *B);
    memset(SN, 0, 6 * (size_t)n3 * sizeof *SN);
    for (int k = 0; k < n; k++) {
        const int x = k, y = n + k, z = 2 * n + k;
        const double about = p->rate * (p->x[1] * p->X[k] - p->x[0] * p->Y[k]);
        B[x] = B[5 * n3 + y] = B[4 * n3 + z] = p->X[k];
        B[n3 + y] = B[5 * n3 + x] = B[3 * n3 + z] = p->Y[k];
        SN[2 * n3 + z] = SN[3 * n3 + y] = SN[4 * n3 + x] = p->N[k];
        B[2 * n3 + z] = B[3 * n3 + y] = B[4 * n3 + x] = about;
        B[3 * n3 + x] = p->rate * p->N[k];
        B[4 * n3 + y] = -p->rate * p->N[k];
    }
}

// QB = Q B
static void times_law(const mat6 *Q, int n3, const double *B, double *QB)
{
    for (int i = 0; i < 6; i++) {
        for (int r = 0; r < n3; r++) {
            double sum = 0;
            for (int j = 0; j < 6; j++) {
                sum += Q->a[i][j] * B[j * n3 + r];
            }
            QB[i * n3 + r] = sum;
        }
    }
}

typedef struct workshop {
    double *B, *SN, *QB, *QSN; // [points][6][3 n2]
} workshop;

static status fill_element(const body *b, int block, int e, double rate, const workshop *w,
                           double *value)
{
    status st = OK;
    const mesh_block *k = &b->plane->block[block];
    const basis_table *t = &b->plane_table[block];
    const int n3 = 3 * k->per_elem, rows = 6 * t->npoint;
    const size_t all = (size_t)n3 * (size_t)n3;
    for (int q = 0; q < t->npoint; q++) {
        plane_point p = {.n2 = k->per_elem, .rate = rate};
        const size_t at = 6 * (size_t)q * (size_t)n3;
        const double area = find_slopes(b, k->conn + (size_t)e * (size_t)k->per_elem, t, q, &p);
        TRY(find_law(b, block, e, area, &p));
        strains(&p, w->B + at, w->SN + at);
        times_law(&p.Q, n3, w->B + at, w->QB + at);
        times_law(&p.Q, n3, w->SN + at, w->QSN + at);
    }
    blas_product(n3, n3, rows, w->B, w->QB, 0, value + FORM_E * all);
    blas_product(n3, n3, rows, w->B, w->QSN, 0, value + FORM_C * all);
    blas_product(n3, n3, rows, w->SN, w->QSN, 0, value + FORM_M * all);

done:
    return st;
}

status plane_forms_make(const body *b, plane_forms *out)
{
    status st = OK;
    plane_forms f = {.plane = b->plane, .elements = (size_t)mesh_element_count(b->plane)};
    workshop w = {0};
    size_t total = 0, most = 0;
    double rate = 0;

    TRY(turn_rate(b, &rate));
    TRY(TAKE(f.at, f.elements));
    for (size_t i = 0; i < f.elements; i++) {
        int e;
        const mesh_block *k = element_of(b->plane, i, &e);
        const size_t n3 = 3 * (size_t)k->per_elem;
        const size_t points = (size_t)b->plane_table[k - b->plane->block].npoint;
        f.at[i] = total;
        total += FORMS * n3 * n3;
        most = 6 * points * n3 > most ? 6 * points * n3 : most;
    }
    TRY(TAKE(f.value, total));
    double **const parts[] = {&w.B, &w.SN, &w.QB, &w.QSN};
    for (int i = 0; i < 4; i++) {
        TRY(TAKE(*parts[i], most));
    }
    for (size_t i = 0; i < f.elements; i++) {
        int e;
        const mesh_block *k = element_of(b->plane, i, &e);
        TRY(fill_element(b, (int)(k - b->plane->block), e, rate, &w, f.value + f.at[i]));
    }
    *out = f;
    f = (plane_forms){0};

done:
    for (int i = 0; i < 4; i++) {
        free(i == 0 ? w.B : i == 1 ? w.SN : i == 2 ? w.QB : w.QSN);
    }
    plane_forms_free(&f);
    return st;
}

// --- products

status plane_forms_multiply(const plane_forms *f, plane_form which, bool transposed, int m,
                            const double *X, double *Y)
{
    status st = OK;
    const size_t n = (size_t)f->plane->nnode, width = (size_t)m;
    double *x = NULL, *y = NULL;
    TRY(TAKE(x, 3 * ELEMENT_MAX_PLANE_NODES * width));
    TRY(TAKE(y, 3 * ELEMENT_MAX_PLANE_NODES * width));
    memset(Y, 0, 3 * n * width * sizeof *Y);
    for (size_t i = 0; i < f->elements; i++) {
        int e;
        const mesh_block *k = element_of(f->plane, i, &e);
        const int n2 = k->per_elem, n3 = 3 * n2, *conn = k->conn + (size_t)e * (size_t)n2;
        const double *A = f->value + f->at[i] + (size_t)which * (size_t)n3 * (size_t)n3;
        const double one = 1, none = 0;
        for (int r = 0; r < n3; r++) {
            const size_t from = (size_t)(r / n2) * n + (size_t)conn[r % n2];
            memcpy(x + (size_t)r * width, X + from * width, width * sizeof *x);
        }
        // column by column: y^T = x^T A^T
        dgemm_("N", transposed ? "T" : "N", &m, &n3, &n3, &one, x, &m, A, &n3, &none, y, &m);
        for (int r = 0; r < n3; r++) {
            double *to = Y + ((size_t)(r / n2) * n + (size_t)conn[r % n2]) * width;
            for (size_t c = 0; c < width; c++) {
                to[c] += y[(size_t)r * width + c];
            }
        }
    }

done:
    free(x);
    free(y);
    return st;
}
