// fem/brick_full.c
// Elements of any shape: int B^T Q B by quadrature, its sums over the points as products of large
// matrices.
#include "fem/blas.h"
#include "fem/brick_parts.h"

#include <math.h>
#include <string.h>
// The law at one height, and the pose there.
typedef struct height {
    int layer, k;
    brick_law law;
    mat3 axes;
    double origin[3];
    bool by_place; // it is not the same all over the section
} height;

static status height_make(const brick *w, int layer, int material, int k, height *h)
{
    status st = OK;
    const double at = w->body->line_table.point[k], s = brick_arclength(w, layer, at);
    *h = (height){.layer = layer, .k = k};
    TRY(brick_law_at(w->body, w->block, w->e, material, s, &h->law));
    body_pose_at(w->body, layer, at, &h->axes, h->origin);
    h->by_place = h->law.m->modulus.at || brick_law_is_polar(&h->law);

done:
    return st;
}

// x, y in the section of a point at this height
static vec3 section_place(const brick *w, const height *h, int q)
{
    vec3 r;
    for (int d = 0; d < 3; d++) {
        r.a[d] = w->place[q][d] - h->origin[d];
    }
    return mat3_tmul_vec(h->axes, r);
}

// factors of the law, and of laws that are not isotropic Q in the base's axes with these factors
static status take_height(brick *w, const height *h)
{
    status st = OK;
    const double s = brick_arclength(w, h->layer, w->body->line_table.point[h->k]);
    const mat6 turn = material_frame_strain_map(mat3_transpose(h->axes));
    mat6 Q = {0};
    for (int i = 0; i < w->np; i++) {
        const int q = h->k * w->np + i;
        const vec3 x = h->by_place ? section_place(w, h, q) : (vec3){0};
        TRY(brick_grade(&h->law, x.a[0], x.a[1], s, &w->grade[q]));
        if (h->law.isotropic) {
            continue;
        }
        if (i == 0 || brick_law_is_polar(&h->law)) {
            Q = brick_section_stiffness(&h->law, x.a[0], x.a[1]);
            Q = w->body->prism ? Q : mat6_symmetric(mat6_congruence(turn, Q));
        }
        w->stiffness[q] = mat6_scale(w->grade[q], Q);
    }

done:
    return st;
}

// --- isotropic: int dN_a/dx_i dN_b/dx_k is enough

// S[(i, a)][(k, b)], all of it
static void sum_slopes(brick *w)
{
    const int n3 = 3 * w->n;
    const double one = 1, none = 0;
    for (int q = 0; q < w->nq; q++) {
        const double root = sqrt(w->dV[q] * w->grade[q]);
        const double *from = w->grad + (size_t)q * (size_t)n3;
        double *to = w->work + (size_t)q * (size_t)n3;
        for (int r = 0; r < n3; r++) {
            to[r] = root * from[r];
        }
    }
    dsyrk_("U", "N", &n3, &w->nq, &one, w->work, &n3, &none, w->sum, &n3); // by rows: the lower one
    for (int r = 0; r < n3; r++) {
        for (int s = 0; s < r; s++) {
            w->sum[(size_t)s * (size_t)n3 + (size_t)r] = w->sum[(size_t)r * (size_t)n3 + (size_t)s];
        }
    }
}

// K = bulk part U + mu (S^T within pairs of directions + delta tr S)
static void fill_isotropic(const brick *w, double lambda, double mu, const double *U, double *K)
{
    const int n = w->n;
    const size_t n3 = 3 * (size_t)n;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            for (int a = 0; a < n; a++) {
                const double *u = U + (size_t)(i * n + a) * n3 + k * n;
                const double *t = w->sum + (size_t)(k * n + a) * n3 + i * n;
                double *to = K + (size_t)(3 * a + i) * n3 + k;
                for (int b = 0; b < n; b++) {
                    to[3 * b] = lambda * u[b] + mu * t[b];
                }
            }
        }
    }
    for (int a = 0; a < n; a++) {
        for (int l = 0; l < 3; l++) {
            const double *t = w->sum + (size_t)(l * n + a) * n3 + l * n;
            for (int b = 0; b < n; b++) {
                for (int i = 0; i < 3; i++) {
                    K[(size_t)(3 * a + i) * n3 + (size_t)(3 * b + i)] += mu * t[b];
                }
            }
        }
    }
}

static void isotropic_stiffness(brick *w, const brick_law *law, double *K)
{
    const size_t all = 9 * (size_t)w->n * (size_t)w->n;
    sum_slopes(w);
    if (!w->body->spec.mixed) {
        fill_isotropic(w, law->lambda, law->mu, w->sum, K);
        return;
    }
    // the pressure's part acts on the projected change of volume, the rest on the shape alone
    double *U = w->sum + all;
    memcpy(U, w->sum, all * sizeof *U);
    brick_add_bulk(w, law->lambda + 2 * law->mu / 3, -2 * law->mu / 3, U);
    fill_isotropic(w, 1, law->mu, U, K);
}

// --- any law

// pairs of directions i <= k
static const int pair[6][2] = {{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}};

// H[(q, j)][pair][b] = dV sum_l C_ijkl dN_b/dx_l of the points of one height
static void times_law(const brick *w, int height, double *H)
{
    const int n = w->n;
    for (int p = 0; p < w->np; p++) {
        const int q = height * w->np + p;
        const double *g = w->grad + 3 * (size_t)q * (size_t)n;
        for (int j = 0; j < 3; j++) {
            for (int ik = 0; ik < 6; ik++, H += n) {
                const double *Q = w->stiffness[q].a[brick_strain[pair[ik][0]][j]];
                const int *at = brick_strain[pair[ik][1]];
                const double x = w->dV[q] * Q[at[0]], y = w->dV[q] * Q[at[1]],
                             z = w->dV[q] * Q[at[2]];
                for (int b = 0; b < n; b++) {
                    H[b] = x * g[b] + y * g[n + b] + z * g[2 * n + b];
                }
            }
        }
    }
}

static void general_stiffness(brick *w, double *K)
{
    const int n = w->n, rows = 3 * w->np;
    const size_t n3 = 3 * (size_t)n;
    for (int k = 0; k < w->nl; k++) {
        times_law(w, k, w->more);
        blas_product(n, 6 * n, rows, w->grad + (size_t)(k * rows) * (size_t)n, w->more, k > 0,
                     w->sum);
    }
    for (int a = 0; a < n; a++) {
        for (int ik = 0; ik < 6; ik++) {
            const int i = pair[ik][0], k = pair[ik][1];
            const double *from = w->sum + (size_t)(6 * a + ik) * (size_t)n;
            for (int b = 0; b < n; b++) {
                K[(size_t)(3 * a + i) * n3 + (size_t)(3 * b + k)] = from[b];
                K[(size_t)(3 * b + k) * n3 + (size_t)(3 * a + i)] = from[b];
            }
        }
    }
}

status brick_full_stiffness(brick *w, int layer, int material, double *K)
{
    status st = OK;
    height h = {0};
    TRY(brick_geometry(w, layer));
    for (int k = 0; k < w->nl; k++) {
        TRY(height_make(w, layer, material, k, &h));
        if (h.by_place) {
            brick_places(w);
        }
        TRY(take_height(w, &h));
    }
    if (w->body->spec.mixed) {
        TRY(brick_project(w));
    }
    if (h.law.isotropic) {
        isotropic_stiffness(w, &h.law, K);
        goto done;
    }
    general_stiffness(w, K);
    if (w->body->spec.mixed) {
        brick_add_projection(w, K);
    }

done:
    return st;
}
