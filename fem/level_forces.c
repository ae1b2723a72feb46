// fem/level_forces.c
#include "fem/level_forces.h"

#include "base/memory.h"
#include "fem/blas.h"
#include "fem/brick.h"
#include "fem/face.h"

#include <string.h>

void level_forces_free(level_forces *s)
{
    free(s->force);
    free(s->sum);
    free(s->sprung_top);
    free(s->sprung_base);
    free(s->sprung);
    *s = (level_forces){0};
}

static size_t own_layers(const way_field *f)
{
    return (size_t)(f->share.last_layer - f->share.first_layer);
}

static size_t force_count(const way_field *f)
{
    return (size_t)problem_columns(f->p) * (size_t)(f->share.to - f->share.from) * 3 *
           (size_t)f->p->body->plane->nnode;
}

status level_forces_take(const way_field *f, level_forces *out)
{
    status st = OK;
    const size_t ncolumn = (size_t)problem_columns(f->p), ends = ncolumn * own_layers(f);
    TRY(TAKE(out->force, force_count(f)));
    TRY(TAKE(out->sum, ends * (size_t)(f->p->body->order + 1)));
    TRY(TAKE(out->sprung_top, ends));
    TRY(TAKE(out->sprung_base, ncolumn));
    TRY(TAKE(out->sprung, ncolumn * (size_t)f->p->body->nlevel));

done:
    return st;
}

typedef struct finder {
    const way_field *f;
    level_forces *out;
    brick *brick;
    double *K;
    double *u, *force; // [dofs][ncolumn] of one element
} finder;

static double *force_of(const finder *s, int column, int level, int node)
{
    const size_t at = way_field_offset(s->f, column, level) + 3 * (size_t)node;
    return s->out->force + at;
}

// --- the mean rigid motion of an element's nodes

typedef struct cluster {
    vec3 centre;
    mat3 inverse; // of the inertia about it
    int n;
    vec3 r[BRICK_MAX_NODES]; // from the centre
} cluster;

static mat3 inverse_of(mat3 m)
{
    const vec3 a = {{m.a[0][0], m.a[0][1], m.a[0][2]}}, b = {{m.a[1][0], m.a[1][1], m.a[1][2]}},
               c = {{m.a[2][0], m.a[2][1], m.a[2][2]}};
    const vec3 bc = vec3_cross(b, c), ca = vec3_cross(c, a), ab = vec3_cross(a, b);
    const double det = vec3_dot(a, bc);
    mat3 inverse;
    for (int i = 0; i < 3; i++) {
        inverse.a[i][0] = bc.a[i] / det;
        inverse.a[i][1] = ca.a[i] / det;
        inverse.a[i][2] = ab.a[i] / det;
    }
    return inverse;
}

static void cluster_of(const body *b, const int *conn, int n2, int layer, cluster *out)
{
    mat3 inertia = {0};
    out->n = n2 * (b->order + 1);
    out->centre = (vec3){0};
    for (int i = 0; i < out->n; i++) {
        body_node(b, conn[i % n2], layer * b->order + i / n2, out->r[i].a);
        out->centre = vec3_add_scaled(out->centre, 1.0 / out->n, out->r[i]);
    }
    for (int i = 0; i < out->n; i++) {
        out->r[i] = vec3_sub(out->r[i], out->centre);
        const double *r = out->r[i].a, square = vec3_dot(out->r[i], out->r[i]);
        for (int k = 0; k < 3; k++) {
            for (int l = 0; l < 3; l++) {
                inertia.a[k][l] += (k == l ? square : 0) - r[k] * r[l];
            }
        }
    }
    out->inverse = inverse_of(inertia);
}

static void take_out_motion(const cluster *c, double *u, int stride)
{
    vec3 mean = {0}, turn = {0};
    for (int i = 0; i < c->n; i++) {
        const double *v = u + 3 * i * stride;
        const vec3 here = {{v[0], v[stride], v[2 * stride]}};
        mean = vec3_add_scaled(mean, 1.0 / c->n, here);
        turn = vec3_add(turn, vec3_cross(c->r[i], here));
    }
    turn = mat3_mul_vec(c->inverse, turn);
    for (int i = 0; i < c->n; i++) {
        const vec3 rigid = vec3_add(mean, vec3_cross(turn, c->r[i]));
        for (int d = 0; d < 3; d++) {
            u[(3 * i + d) * stride] -= rigid.a[d];
        }
    }
}

// --- elements

static void add_sum(vec6 *sum, const double *f, int stride, const double *x)
{
    const vec3 force = {{f[0], f[stride], f[2 * stride]}};
    const vec3 m = vec3_cross((vec3){{x[0], x[1], x[2]}}, force);
    for (int d = 0; d < 3; d++) {
        sum->a[d] += force.a[d];
        sum->a[3 + d] += m.a[d];
    }
}

static void spread(finder *s, const int *conn, int n2, int layer)
{
    const body *b = s->f->p->body;
    const int p = b->order, ncolumn = problem_columns(s->f->p);
    const bool own = layer >= s->f->share.first_layer;
    for (int i = 0; i < n2 * (p + 1); i++) {
        const int node = conn[i % n2], level = layer * p + i / n2;
        double x[3];
        body_node(b, node, level, x);
        for (int j = 0; j < ncolumn; j++) {
            const double *f = s->force + 3 * i * ncolumn + j;
            double *to = force_of(s, j, level, node);
            for (int d = 0; d < 3; d++) {
                to[d] += f[d * ncolumn];
            }
            if (own) {
                const size_t at =
                    (size_t)j * own_layers(s->f) + (size_t)(layer - s->f->share.first_layer);
                add_sum(s->out->sum + at * (size_t)(p + 1) + i / n2, f, ncolumn, x);
            }
        }
    }
}

static status add_brick(finder *s, const int *conn, int n2, int layer)
{
    status st = OK;
    const body *b = s->f->p->body;
    const int ncolumn = problem_columns(s->f->p), n = 3 * n2 * (b->order + 1);
    cluster c;
    cluster_of(b, conn, n2, layer, &c);
    for (int j = 0; j < ncolumn; j++) {
        for (int i = 0; i < n / 3; i++) {
            const double *from =
                way_field_level(s->f, j, layer * b->order + i / n2) + 3 * (size_t)conn[i % n2];
            for (int d = 0; d < 3; d++) {
                s->u[(3 * i + d) * ncolumn + j] = from[d];
            }
        }
        take_out_motion(&c, s->u + j, ncolumn);
    }
    TRY(brick_stiffness(s->brick, layer, s->K));
    blas_product(n, ncolumn, n, s->K, s->u, 0, s->force); // K is symmetric
    spread(s, conn, n2, layer);

done:
    return st;
}

static status add_bricks(finder *s)
{
    status st = OK;
    const body *b = s->f->p->body;
    const int first = s->f->share.from / b->order, last = s->f->share.last_layer;
    for (int block = 0; block < b->plane->nblock; block++) {
        const mesh_block *k = &b->plane->block[block];
        for (int e = 0; e < k->nelem; e++) {
            TRY(brick_stand_on(s->brick, block, e));
            for (int layer = first; layer < last; layer++) {
                if (body_material(b, block, e, layer) >= 0) {
                    TRY(add_brick(s, k->conn + (size_t)e * (size_t)k->per_elem, k->per_elem,
                                  layer));
                }
            }
        }
    }

done:
    return st;
}

// --- springs

typedef struct spring_adder {
    finder *s;
    const face_spring *spring;
} spring_adder;

// where the patch's forces on the ends of its layer are to be counted, NULL: not at all
static vec6 *end_of(const finder *s, const face_spring *spring, const face_patch *p, int i, int j)
{
    const level_share *share = &s->f->share;
    const int order = s->f->p->body->order;
    if (spring->on.face < FACE_OUTSIDE || p->layer < share->first_layer) {
        return NULL; // the end planes' own springs lie beyond the sections
    }
    if (p->level[i] == 0) {
        return &s->out->sprung_base[j];
    }
    return p->level[i] == (p->layer + 1) * order
               ? &s->out->sprung_top[(size_t)j * own_layers(s->f) +
                                     (size_t)(p->layer - share->first_layer)]
               : NULL;
}

static status add_patch(void *self, const face_patch *p)
{
    const spring_adder *a = (const spring_adder *)self;
    finder *s = a->s;
    const int ncolumn = problem_columns(s->f->p), n = 3 * p->nnode;
    face_spring_matrix(p, a->spring, s->K);
    for (int j = 0; j < ncolumn; j++) {
        for (int r = 0; r < n; r++) {
            s->u[r * ncolumn + j] =
                way_field_level(s->f, j, p->level[r / 3])[3 * p->plane_node[r / 3] + r % 3];
        }
    }
    blas_product(n, ncolumn, n, s->K, s->u, 0, s->force);
    for (int i = 0; i < p->nnode; i++) {
        double x[3];
        body_node(s->f->p->body, p->plane_node[i], p->level[i], x);
        for (int j = 0; j < ncolumn; j++) {
            const double *f = s->force + 3 * i * ncolumn + j;
            double *to = force_of(s, j, p->level[i], p->plane_node[i]);
            vec6 *end = end_of(s, a->spring, p, i, j);
            for (int d = 0; d < 3; d++) {
                to[d] += f[d * ncolumn];
            }
            if (end) {
                add_sum(end, f, ncolumn, x);
            }
            if (p->level[i] >= s->f->share.first && p->level[i] < s->f->share.last) {
                const int at = j * s->f->p->body->nlevel + p->level[i];
                add_sum(&s->out->sprung[at], f, ncolumn, x);
            }
        }
    }
    return OK;
}

static status add_springs(finder *s)
{
    status st = OK;
    const body *b = s->f->p->body;
    for (int i = 0; i < s->f->p->nspring; i++) {
        spring_adder a = {s, &s->f->p->spring[i]};
        TRY(face_walk(b, &a.spring->on, s->f->share.from / b->order, s->f->share.last_layer,
                      add_patch, &a));
    }

done:
    return st;
}

status level_forces_find(const way_field *f, level_forces *out)
{
    status st = OK;
    finder s = {.f = f, .out = out};
    const size_t ncolumn = (size_t)problem_columns(f->p), ends = ncolumn * own_layers(f);
    memset(out->force, 0, force_count(f) * sizeof *out->force);
    memset(out->sum, 0, ends * (size_t)(f->p->body->order + 1) * sizeof *out->sum);
    memset(out->sprung_top, 0, ends * sizeof *out->sprung_top);
    memset(out->sprung_base, 0, ncolumn * sizeof *out->sprung_base);
    memset(out->sprung, 0, ncolumn * (size_t)f->p->body->nlevel * sizeof *out->sprung);
    TRY(TAKE(s.K, (size_t)BRICK_MAX_DOFS * BRICK_MAX_DOFS));
    TRY(TAKE(s.u, BRICK_MAX_DOFS * ncolumn));
    TRY(TAKE(s.force, BRICK_MAX_DOFS * ncolumn));
    TRY(brick_make(f->p->body, &s.brick));
    TRY(add_bricks(&s));
    TRY(add_springs(&s));

done:
    free(s.K);
    free(s.u);
    free(s.force);
    brick_free(s.brick);
    return st;
}
