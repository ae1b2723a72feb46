// fem/apply_stresses.c
// Slopes to stresses at the points of one layer, many columns at once.
#include "fem/apply_parts.h"

// slopes of one column at a point: h[j][i] = u_i,j
typedef struct slopes {
    double h[3][3];
} slopes;

// s[j][i]: stress on planes across j along i, times the volume
static inline slopes isotropic(double lambda, double mu, slopes u)
{
    slopes s;
    const double change = lambda * (u.h[0][0] + u.h[1][1] + u.h[2][2]);
    for (int j = 0; j < 3; j++) {
        s.h[j][j] = change + 2 * mu * u.h[j][j];
    }
    s.h[0][1] = s.h[1][0] = mu * (u.h[0][1] + u.h[1][0]);
    s.h[0][2] = s.h[2][0] = mu * (u.h[0][2] + u.h[2][0]);
    s.h[1][2] = s.h[2][1] = mu * (u.h[1][2] + u.h[2][1]);
    return s;
}

static slopes general(const mat6 *Q, double volume, slopes u)
{
    const vec6 e = {{u.h[0][0], u.h[1][1], u.h[2][2], u.h[1][2] + u.h[2][1], u.h[0][2] + u.h[2][0],
                     u.h[0][1] + u.h[1][0]}};
    const vec6 s = vec6_scale(volume, mat6_mul_vec(*Q, e));
    return (slopes){{{s.a[0], s.a[5], s.a[4]}, {s.a[5], s.a[1], s.a[3]}, {s.a[4], s.a[3], s.a[2]}}};
}

// u_i,x = sum_k u_i,X_k dX_k/dx
static inline slopes to_base(const apply_point *p, slopes u)
{
    slopes v;
    for (int j = 0; j < 3; j++) {
        for (int i = 0; i < 3; i++) {
            v.h[j][i] =
                p->back[0][j] * u.h[0][i] + p->back[1][j] * u.h[1][i] + p->back[2][j] * u.h[2][i];
        }
    }
    return v;
}

static inline slopes from_base(const apply_point *p, slopes s)
{
    slopes v;
    for (int k = 0; k < 3; k++) {
        for (int i = 0; i < 3; i++) {
            v.h[k][i] =
                p->back[k][0] * s.h[0][i] + p->back[k][1] * s.h[1][i] + p->back[k][2] * s.h[2][i];
        }
    }
    return v;
}

static inline slopes load(const double *x, size_t part, size_t n)
{
    slopes u;
    for (int j = 0; j < 3; j++) {
        for (int i = 0; i < 3; i++) {
            u.h[j][i] = x[(size_t)j * part + (size_t)i * n];
        }
    }
    return u;
}

static inline void store(slopes u, size_t part, size_t n, double *x)
{
    for (int j = 0; j < 3; j++) {
        for (int i = 0; i < 3; i++) {
            x[(size_t)j * part + (size_t)i * n] = u.h[j][i];
        }
    }
}

// What a point's law is, its grade and volume in it.
typedef struct point_law {
    double lambda, mu, volume;
    const mat6 *Q;
    const apply_point *point;
} point_law;

static point_law law_of(const apply *a, const apply_element *e, int layer, int t, int q)
{
    const body *b = a->body;
    const int p = b->order, height = (layer - a->first_layer) * a->nl + t;
    const size_t at = (size_t)height * (size_t)e->np + (size_t)q;
    const double half = (b->level[(layer + 1) * p] - b->level[layer * p]) / 2;
    point_law law = {.point = e->point ? e->point + at : NULL};
    law.volume = e->point ? law.point->dV : half * b->line_table.weight[t] * e->area[q];
    law.volume *= !e->grade ? 1 : e->grade[e->along ? at : (size_t)q];
    law.lambda = law.volume * e->law.lambda;
    law.mu = law.volume * e->law.mu;
    law.Q = e->Q ? e->Q + (e->along ? at : (size_t)q) : NULL;
    return law;
}

// all columns of one point; `n` is a constant where this is called with one
static inline void columns(const point_law *law, size_t part, size_t n, double *x)
{
    if (law->Q) {
        for (size_t c = 0; c < n; c++) {
            slopes u = load(x + c, part, n);
            u = law->point ? to_base(law->point, u) : u;
            u = general(law->Q, law->volume, u);
            store(law->point ? from_base(law->point, u) : u, part, n, x + c);
        }
    } else if (law->point) {
        for (size_t c = 0; c < n; c++) {
            const slopes u = to_base(law->point, load(x + c, part, n));
            store(from_base(law->point, isotropic(law->lambda, law->mu, u)), part, n, x + c);
        }
    } else {
        for (size_t c = 0; c < n; c++) {
            store(isotropic(law->lambda, law->mu, load(x + c, part, n)), part, n, x + c);
        }
    }
}

void apply_stresses(const apply *a, const apply_element *e, int layer, int ncol, double *solid)
{
    const size_t n = (size_t)ncol, part = 3 * (size_t)e->np * n;
    for (int t = 0; t < a->nl; t++) {
        for (int q = 0; q < e->np; q++) {
            const point_law law = law_of(a, e, layer, t, q);
            double *x = solid + (size_t)t * 3 * part + 3 * (size_t)q * n;
            if (n == 6) {
                columns(&law, part, 6, x);
            } else {
                columns(&law, part, n, x);
            }
        }
    }
}
