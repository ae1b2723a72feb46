// fem/way_resultant.c
// The resultants of the stresses on every level, by the work of nodal forces on rigid motions.
// docs/theory.md (5.13)
#include "fem/way_fill.h"

#include "base/memory.h"
#include "fem/brick.h"

#include <string.h>

// Inner forces of layers: the sums of their nodes' forces, level by level.
typedef struct inner_forces {
    const way_field *f;
    brick *brick;
    double *K, *u;
    vec6 *sum; // [ncolumn][layers][order + 1] about the base's origin
} inner_forces;

static vec6 *sum_of(const inner_forces *s, int column, int layer)
{
    const int own = s->f->share.last_layer - s->f->share.first_layer, p = s->f->p->body->order;
    return s->sum + ((size_t)column * (size_t)own + (size_t)(layer - s->f->share.first_layer)) *
                        (size_t)(p + 1);
}

// f = K u of one element, summed as wrenches
static void add_element(inner_forces *s, const int *conn, int n2, int layer)
{
    const body *b = s->f->p->body;
    const int p = b->order, n = 3 * n2 * (p + 1);
    for (int j = 0; j < problem_columns(s->f->p); j++) {
        vec6 *sum = sum_of(s, j, layer);
        way_field_gather(s->f, j, conn, n2, layer, s->u);
        for (int i = 0; i < n / 3; i++) {
            vec3 x, force = {0};
            for (int d = 0; d < 3; d++) {
                const double *row = s->K + (size_t)(3 * i + d) * (size_t)n;
                for (int c = 0; c < n; c++) {
                    force.a[d] += row[c] * s->u[c];
                }
            }
            body_node(b, conn[i % n2], layer * p + i / n2, x.a);
            const vec3 m = vec3_cross(x, force);
            for (int d = 0; d < 3; d++) {
                sum[i / n2].a[d] += force.a[d];
                sum[i / n2].a[3 + d] += m.a[d];
            }
        }
    }
}

static status add_elements(inner_forces *s)
{
    status st = OK;
    const body *b = s->f->p->body;
    for (int block = 0; block < b->plane->nblock; block++) {
        const mesh_block *k = &b->plane->block[block];
        for (int e = 0; e < k->nelem; e++) {
            TRY(brick_stand_on(s->brick, block, e));
            for (int layer = s->f->share.first_layer; layer < s->f->share.last_layer; layer++) {
                if (body_material(b, block, e, layer) >= 0) {
                    TRY(brick_stiffness(s->brick, layer, s->K));
                    add_element(s, k->conn + (size_t)e * (size_t)k->per_elem, k->per_elem, layer);
                }
            }
        }
    }

done:
    return st;
}

// --- from forces of nodes to resultants inside a layer

typedef struct line_weights {
    int p;
    // resultant at level k = 0..p of a layer: sum of a[k][l] x (force on level l), l = 1..p
    double a[ELEMENT_MAX_ORDER + 1][ELEMENT_MAX_ORDER + 1];
} line_weights;

// Gaussian elimination of the p x p matrix with p + 1 right-hand sides, pivoted by columns' largest
static void solve_small(int p, double (*m)[2 * ELEMENT_MAX_ORDER + 1])
{
    for (int i = 0; i < p; i++) {
        int best = i;
        for (int r = i + 1; r < p; r++) {
            best = fabs(m[r][i]) > fabs(m[best][i]) ? r : best;
        }
        for (int c = 0; c < 2 * p + 1; c++) {
            const double t = m[i][c];
            m[i][c] = m[best][c];
            m[best][c] = t;
        }
        for (int r = 0; r < p; r++) {
            const double by = r == i ? 0 : m[r][i] / m[i][i];
            for (int c = i; by != 0 && c < 2 * p + 1; c++) {
                m[r][c] -= by * m[i][c];
            }
        }
    }
    for (int i = 0; i < p; i++) {
        for (int c = p; c < 2 * p + 1; c++) {
            m[i][c] /= m[i][i];
        }
    }
}

// The polynomial W of degree p - 1 with int N_l' W ds = force on level l. Unknown: its values at
// the p Gauss points.
static line_weights line_weights_of(const element *line)
{
    const int p = line->order;
    line_weights w = {.p = p};
    double x[ELEMENT_MAX_ORDER], g[ELEMENT_MAX_ORDER], N[ELEMENT_MAX_ORDER + 1],
        dN[ELEMENT_MAX_ORDER + 1];
    double m[ELEMENT_MAX_ORDER][2 * ELEMENT_MAX_ORDER + 1] = {{0}}; // transposed system
    gauss_legendre(p, x, g);
    for (int q = 0; q < p; q++) {
        element_basis(line, &x[q], N, dN);
        for (int l = 1; l <= p; l++) {
            m[q][l - 1] = g[q] * dN[l];
        }
        for (int k = 0; k <= p; k++) { // W at level k by its values at the points
            m[q][p + k] = 1;
            for (int r = 0; r < p; r++) {
                m[q][p + k] *= r == q ? 1 : (line->line_node[k] - x[r]) / (x[q] - x[r]);
            }
        }
    }
    solve_small(p, m);
    for (int k = 0; k <= p; k++) {
        for (int l = 1; l <= p; l++) {
            w.a[k][l] = m[l - 1][p + k];
        }
    }
    return w;
}

static vec6 about_section(const body *b, vec6 w, int level)
{
    const double zero[3] = {0};
    double origin[3];
    body_origin(b, level, origin);
    return wrench_moved(w, zero, origin);
}

// Upper ends of layers by the nodes' forces there, without what the layer's own loads put on them;
// levels inside by the polynomial; the base as the upper ends.
static void fill_layer(const inner_forces *s, const line_weights *w, int column, int layer,
                       vec6 *resultant)
{
    const level_share *share = &s->f->share;
    const body *b = s->f->p->body;
    const int p = b->order, own = share->last_layer - share->first_layer;
    const vec6 *sum = sum_of(s, column, layer);
    const level_loads *loads = s->f->loads;
    for (int k = 1; k < p; k++) {
        vec6 here = {0};
        for (int l = 1; l <= p; l++) {
            here = vec6_add(here, vec6_scale(w->a[k][l], sum[l]));
        }
        resultant[layer * p + k] = about_section(b, here, layer * p + k);
    }
    const vec6 end = vec6_sub(sum[p], loads->on_top[column * own + layer - share->first_layer]);
    resultant[(layer + 1) * p] = about_section(b, end, (layer + 1) * p);
    if (layer == 0) {
        const vec6 base = vec6_sub(loads->on_base[column], sum[0]);
        resultant[0] = about_section(b, base, 0);
    }
}

status way_resultants(const way_field *f, vec6 *resultant)
{
    status st = OK;
    inner_forces s = {.f = f};
    const body *b = f->p->body;
    const int ncolumn = problem_columns(f->p);
    const size_t layers = (size_t)(f->share.last_layer - f->share.first_layer);
    const line_weights w = line_weights_of(&b->line);
    TRY(TAKE(s.sum, (size_t)ncolumn * layers * (size_t)(b->order + 1)));
    TRY(TAKE(s.K, (size_t)BRICK_MAX_DOFS * BRICK_MAX_DOFS));
    TRY(TAKE(s.u, BRICK_MAX_DOFS));
    TRY(brick_make(b, &s.brick));
    TRY(add_elements(&s));
    for (int j = 0; j < ncolumn; j++) {
        for (int layer = f->share.first_layer; layer < f->share.last_layer; layer++) {
            fill_layer(&s, &w, j, layer, resultant + (size_t)j * (size_t)b->nlevel);
        }
    }

done:
    free(s.sum);
    free(s.K);
    free(s.u);
    brick_free(s.brick);
    return st;
}
