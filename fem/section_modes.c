// fem/section_modes.c
#include "fem/section_modes.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

// Measured on rings, sectors and bars of several materials: 14 iterations; half as many modes take
// 18, twice as many 10
enum { CHAIN = 3, SOFT_PLANE = 24, SOFT_ALONG = 12, SOFT_STEPS = 3, RIGID = 6, KINDS = 2 };

// a direction of which less is left is not new
static const double NEW = 1e-6;

// E is singular for the rigid motions; this much of M, relative to their diagonals, holds them
static const double HOLD = 1e-8;

typedef struct maker {
    const petsc_plane_door *door;
    const plane_forms *forms;
    size_t n3;
    int ndof[KINDS];
    petsc_plane *factor[KINDS]; // E + hold M, in the plane and along s
    int count;
    double **mode; // [count][3 n] one after the other, orthonormal; rigid ones first
    int *sort;     // [count] kind
    int room;
} maker;

static void maker_free(maker *w)
{
    for (int k = 0; k < KINDS; k++) {
        w->door->free(w->factor[k]);
    }
    for (int i = 0; w->mode && i < w->count; i++) {
        free(w->mode[i]);
    }
    free(w->mode);
    free(w->sort);
}

void section_modes_free(section_modes *m)
{
    free(m->value);
    free(m->along);
    *m = (section_modes){0};
}

void section_rigid(const body *b, int level, double *value)
{
    const size_t n = (size_t)b->plane->nnode;
    double origin[3], x[3];
    body_origin(b, level, origin);
    for (size_t i = 0; i < n; i++) {
        body_node(b, (int)i, level, x);
        for (int d = 0; d < 3; d++) {
            x[d] = (x[d] - origin[d]) / b->radius;
        }
        const double rows[3][RIGID] = {
            {1, 0, 0, 0, x[2], -x[1]}, {0, 1, 0, -x[2], 0, x[0]}, {0, 0, 1, x[1], -x[0], 0}};
        for (size_t d = 0; d < 3; d++) {
            memcpy(value + (d * n + i) * RIGID, rows[d], sizeof rows[d]);
        }
    }
}

static double dot(size_t n, const double *a, const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < n; i++) {
        sum += a[i] * b[i];
    }
    return sum;
}

// keeps what is new of v, whose other directions are zero
static status add_mode(maker *w, int sort, const double *v)
{
    status st = OK;
    double *own = NULL;
    if (w->count == w->room) {
        return OK;
    }
    TRY(TAKE(own, w->n3));
    memcpy(own, v, w->n3 * sizeof *own);
    const double before = sqrt(dot(w->n3, own, own));
    // twice is enough
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < w->count; i++) {
            const double part = dot(w->n3, w->mode[i], own);
            for (size_t k = 0; k < w->n3; k++) {
                own[k] -= part * w->mode[i][k];
            }
        }
    }
    const double after = sqrt(dot(w->n3, own, own));
    if (after > NEW * before) {
        for (size_t k = 0; k < w->n3; k++) {
            own[k] /= after;
        }
        w->sort[w->count] = sort;
        w->mode[w->count++] = own;
        own = NULL;
    }

done:
    free(own);
    return st;
}

// columns of V [3n][m], each in its plane part and its part along s
static status add_modes(maker *w, int m, const double *V)
{
    status st = OK;
    double *one = NULL;
    const size_t part[KINDS + 1] = {0, (size_t)w->ndof[0], w->n3};
    TRY(TAKE(one, w->n3));
    for (int k = 0; k < KINDS; k++) {
        for (int c = 0; c < m; c++) {
            memset(one, 0, w->n3 * sizeof *one);
            for (size_t i = part[k]; i < part[k + 1]; i++) {
                one[i] = V[i * (size_t)m + (size_t)c];
            }
            TRY(add_mode(w, k, one));
        }
    }

done:
    free(one);
    return st;
}

static status take_factor(maker *w, int which, int from, int to)
{
    status st = OK;
    plane_pattern p = {0};
    double *E = NULL, *M = NULL, trace[2] = {0};
    TRY(plane_pattern_make(w->forms, from, to, &p));
    TRY(TAKE(E, (size_t)p.start[p.ndof]));
    TRY(TAKE(M, (size_t)p.start[p.ndof]));
    plane_pattern_values(&p, w->forms, FORM_E, E);
    plane_pattern_values(&p, w->forms, FORM_M, M);
    for (int i = 0; i < p.ndof; i++) { // the diagonal comes first in each row
        trace[0] += E[p.start[i]];
        trace[1] += M[p.start[i]];
    }
    for (int i = 0; i < p.start[p.ndof]; i++) {
        E[i] += HOLD * trace[0] / trace[1] * M[i];
    }
    w->ndof[which] = p.ndof;
    TRY(w->door->factor(p.ndof, p.start, p.column, E, &w->factor[which]));

done:
    free(E);
    free(M);
    plane_pattern_free(&p);
    return st;
}

// X [3n][m] = (E + hold M)^-1 B by kinds
static status solve(const maker *w, int m, const double *B, double *X)
{
    status st = OK;
    double *right = NULL, *left = NULL;
    const size_t cols = (size_t)m;
    TRY(TAKE(right, w->n3 * cols));
    TRY(TAKE(left, w->n3 * cols));
    for (size_t k = 0, at = 0; k < KINDS; at += (size_t)w->ndof[k], k++) {
        const size_t n = (size_t)w->ndof[k];
        for (size_t i = 0; i < n * cols; i++) {
            right[i] = B[(at + i % n) * cols + i / n];
        }
        TRY(w->door->solve(w->factor[k], m, right, left));
        for (size_t i = 0; i < n * cols; i++) {
            X[(at + i % n) * cols + i / n] = left[i];
        }
    }

done:
    free(right);
    free(left);
    return st;
}

// columns without what the modes from `first` on have, of norm one
static void clean(const maker *w, int first, int m, double *V)
{
    for (int c = 0; c < m; c++) {
        for (int i = first; i < w->count; i++) {
            double part = 0;
            for (size_t k = 0; k < w->n3; k++) {
                part += w->mode[i][k] * V[k * (size_t)m + (size_t)c];
            }
            for (size_t k = 0; k < w->n3; k++) {
                V[k * (size_t)m + (size_t)c] -= part * w->mode[i][k];
            }
        }
        double norm = 0;
        for (size_t k = 0; k < w->n3; k++) {
            norm += pow(V[k * (size_t)m + (size_t)c], 2);
        }
        for (size_t k = 0; norm > 0 && k < w->n3; k++) {
            V[k * (size_t)m + (size_t)c] /= sqrt(norm);
        }
    }
}

// E w_next = (C^T - C) w + M w_before: the warping of a motion that grows along s. (5.14d)
static status add_chain(maker *w, const double *rigid)
{
    status st = OK;
    const size_t all = RIGID * w->n3;
    double *now = NULL, *before = NULL, *right = NULL, *more = NULL;
    TRY(TAKE(now, all));
    TRY(TAKE(before, all));
    TRY(TAKE(right, all));
    TRY(TAKE(more, all));
    memcpy(now, rigid, all * sizeof *now);
    for (int step = 0; step < CHAIN; step++) {
        TRY(plane_forms_multiply(w->forms, FORM_M, false, RIGID, before, right));
        TRY(plane_forms_multiply(w->forms, FORM_C, true, RIGID, now, more));
        for (size_t i = 0; i < all; i++) {
            right[i] += more[i];
        }
        TRY(plane_forms_multiply(w->forms, FORM_C, false, RIGID, now, more));
        for (size_t i = 0; i < all; i++) {
            right[i] -= more[i];
        }
        memcpy(before, now, all * sizeof *now);
        TRY(solve(w, RIGID, right, now));
        clean(w, 0, RIGID, now);
        TRY(add_modes(w, RIGID, now));
    }

done:
    free(now);
    free(before);
    free(right);
    free(more);
    return st;
}

// inverse iteration from something without a pattern
static status add_soft(maker *w)
{
    status st = OK;
    enum { WIDTH = SOFT_PLANE };
    double *X = NULL, *MX = NULL;
    unsigned seed = 1;
    TRY(TAKE(X, w->n3 * WIDTH));
    TRY(TAKE(MX, w->n3 * WIDTH));
    for (size_t i = 0; i < w->n3 * WIDTH; i++) {
        seed = seed * 1664525U + 1013904223U;
        // fewer along s than in the plane
        const bool none = i / WIDTH >= (size_t)w->ndof[0] && i % WIDTH >= SOFT_ALONG;
        X[i] = none ? 0 : (double)(seed >> 8) / (1 << 24) - 0.5;
    }
    for (int step = 0; step < SOFT_STEPS; step++) {
        clean(w, 0, WIDTH, X);
        TRY(plane_forms_multiply(w->forms, FORM_M, false, WIDTH, X, MX));
        TRY(solve(w, WIDTH, MX, X));
    }
    clean(w, 0, WIDTH, X);
    TRY(add_modes(w, WIDTH, X));

done:
    free(X);
    free(MX);
    return st;
}

// rigid motions of the plane mesh itself, in the section's axes
static void plane_rigid(const body *b, double *value)
{
    const size_t n = (size_t)b->plane->nnode;
    for (size_t i = 0; i < n; i++) {
        const double x = b->plane->xyz[3 * i] / b->radius, y = b->plane->xyz[3 * i + 1] / b->radius;
        const double rows[3][RIGID] = {
            {1, 0, 0, 0, 0, -y}, {0, 1, 0, 0, 0, x}, {0, 0, 1, y, -x, 0}};
        for (size_t d = 0; d < 3; d++) {
            memcpy(value + (d * n + i) * RIGID, rows[d], sizeof rows[d]);
        }
    }
}

static status hand_over(const maker *w, int rigid, section_modes *out)
{
    status st = OK;
    section_modes m = {.count = w->count - rigid};
    const double scale = sqrt((double)w->n3 / 3);
    TRY(TAKE(m.value, w->n3 * (size_t)m.count));
    TRY(TAKE(m.along, (size_t)m.count));
    for (int c = 0; c < m.count; c++) {
        m.along[c] = w->sort[rigid + c] == 1;
        for (size_t i = 0; i < w->n3; i++) {
            m.value[i * (size_t)m.count + (size_t)c] = scale * w->mode[rigid + c][i];
        }
    }
    *out = m;
    m = (section_modes){0};

done:
    section_modes_free(&m);
    return st;
}

status section_modes_make(const petsc_plane_door *door, const body *b, const plane_forms *forms,
                          section_modes *out)
{
    status st = OK;
    maker w = {.door = door, .forms = forms, .n3 = 3 * (size_t)b->plane->nnode};
    double *rigid = NULL;
    // room for all of them, and never more than the section has motions
    w.room = KINDS * RIGID * (1 + CHAIN) + SOFT_PLANE + SOFT_ALONG;
    TRY(TAKE(w.mode, (size_t)w.room));
    TRY(TAKE(w.sort, (size_t)w.room));
    TRY(TAKE(rigid, RIGID * w.n3));
    TRY(take_factor(&w, 0, 0, 2));
    TRY(take_factor(&w, 1, 2, 3));
    plane_rigid(b, rigid);
    TRY(add_modes(&w, RIGID, rigid));
    const int known = w.count;
    TRY(add_chain(&w, rigid));
    TRY(add_soft(&w));
    TRY(hand_over(&w, known, out));

done:
    free(rigid);
    maker_free(&w);
    return st;
}
