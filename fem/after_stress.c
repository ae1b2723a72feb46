// fem/after_stress.c
// Stresses at the nodes from the points where they are best. docs/theory.md (5.21)
#include "fem/after.h"

#include "base/memory.h"
#include "fem/brick.h"

#include <math.h>
#include <string.h>

// a function that others express this well, over its own size, adds nothing: rounding grows by the
// inverse
static const double DEPENDENT = 1e-5;

enum { MOST_BEST = BRICK_MAX_NODES };

// From the values at an element's best points to those at its nodes: node = sum to_node best.
typedef struct extrapolation {
    int nbest, nnode, ncolumn;
    double best[MOST_BEST][3];
    double q[MOST_BEST][MOST_BEST];             // [ncolumn][nbest] orthonormal over the best points
    double at_node[MOST_BEST][BRICK_MAX_NODES]; // the same functions at the nodes
    double to_node[BRICK_MAX_NODES][MOST_BEST];
} extrapolation;

typedef struct stress_maker {
    const segment_body *here;
    const body *body;
    const way_run *run;
    const double *u;
    brick *brick;
    extrapolation by;
    element plane, lower;                 // of the block, and one order below for products
    double *sum;                          // [levels here][apart][6]
    int *count;                           // [levels here][apart]
    double x[ELEMENT_MAX_PLANE_NODES][2]; // of the plane element at hand, from its middle and over
                                          // its reach
} stress_maker;

// --- the functions: polynomials in the place, which are what beams' stresses are, then products of
// reference coordinates, which the element's own shape can hold

// one more function by its values at the best points and the nodes, made orthonormal
static void add_function(extrapolation *by, double *best, double *node)
{
    double before = 0, after = 0;
    if (by->ncolumn == by->nbest) {
        return;
    }
    for (int i = 0; i < by->nbest; i++) {
        before += best[i] * best[i];
    }
    for (int k = 0; k < by->ncolumn; k++) {
        double r = 0;
        for (int i = 0; i < by->nbest; i++) {
            r += by->q[k][i] * best[i];
        }
        for (int i = 0; i < by->nbest; i++) {
            best[i] -= r * by->q[k][i];
        }
        for (int i = 0; i < by->nnode; i++) {
            node[i] -= r * by->at_node[k][i];
        }
    }
    for (int i = 0; i < by->nbest; i++) {
        after += best[i] * best[i];
    }
    if (!(sqrt(after) > DEPENDENT * sqrt(before))) {
        return;
    }
    for (int i = 0; i < by->nbest; i++) {
        by->q[by->ncolumn][i] = best[i] / sqrt(after);
    }
    for (int i = 0; i < by->nnode; i++) {
        by->at_node[by->ncolumn][i] = node[i] / sqrt(after);
    }
    by->ncolumn++;
}

static void place_of(const stress_maker *m, const double *at, double place[3])
{
    double N[ELEMENT_MAX_PLANE_NODES];
    element_basis(&m->plane, at, N, NULL);
    place[0] = place[1] = 0;
    for (int a = 0; a < m->plane.nnode; a++) {
        place[0] += N[a] * m->x[a][0];
        place[1] += N[a] * m->x[a][1];
    }
    place[2] = at[2];
}

// reference coordinates of node i of the brick
static void node_point(const stress_maker *m, int i, double at[3])
{
    const int n2 = m->plane.nnode;
    at[0] = m->plane.node[i % n2][0];
    at[1] = m->plane.node[i % n2][1];
    at[2] = m->body->line.line_node[i / n2];
}

static double power_at(const double *x, const int *power)
{
    double f = 1;
    for (int d = 0; d < 3; d++) {
        for (int k = 0; k < power[d]; k++) {
            f *= x[d];
        }
    }
    return f;
}

static void add_powers(stress_maker *m)
{
    extrapolation *by = &m->by;
    const int plane = m->plane.order - 1, line = m->body->order - 1;
    const int most = plane > line ? plane : line;
    for (int total = 0; total <= most; total++) {
        for (int c = 0; c <= total && c <= line; c++) {
            for (int b = 0; b <= total - c && total - c <= plane; b++) {
                const int power[3] = {total - c - b, b, c};
                double best[MOST_BEST], node[BRICK_MAX_NODES], at[3], place[3];
                for (int i = 0; i < by->nbest; i++) {
                    place_of(m, by->best[i], place);
                    best[i] = power_at(place, power);
                }
                for (int i = 0; i < by->nnode; i++) {
                    node_point(m, i, at);
                    place_of(m, at, place);
                    node[i] = power_at(place, power);
                }
                add_function(by, best, node);
            }
        }
    }
}

// function `j` of the plane element one order below times the power k of the line's coordinate
static double product_at(const stress_maker *m, const double *at, int j, int k)
{
    double N[ELEMENT_MAX_PLANE_NODES];
    element_basis(&m->lower, at, N, NULL);
    return N[j] * pow(at[2], k);
}

static void add_products(stress_maker *m)
{
    extrapolation *by = &m->by;
    for (int k = 0; k < m->body->order && m->plane.order > 1; k++) {
        for (int j = 0; j < m->lower.nnode; j++) {
            double best[MOST_BEST], node[BRICK_MAX_NODES], at[3];
            for (int i = 0; i < by->nbest; i++) {
                best[i] = product_at(m, by->best[i], j, k);
            }
            for (int i = 0; i < by->nnode; i++) {
                node_point(m, i, at);
                node[i] = product_at(m, at, j, k);
            }
            add_function(by, best, node);
        }
    }
}

static void take_places(stress_maker *m, const int *conn)
{
    const double *xyz = m->body->plane->xyz;
    double middle[2] = {0}, reach = 0;
    for (int a = 0; a < m->plane.nnode; a++) {
        for (int d = 0; d < 2; d++) {
            middle[d] += xyz[3 * (size_t)conn[a] + (size_t)d] / m->plane.nnode;
        }
    }
    for (int a = 0; a < m->plane.nnode; a++) {
        for (int d = 0; d < 2; d++) {
            m->x[a][d] = xyz[3 * (size_t)conn[a] + (size_t)d] - middle[d];
            reach = fmax(reach, fabs(m->x[a][d]));
        }
    }
    for (int a = 0; a < m->plane.nnode; a++) {
        m->x[a][0] /= reach;
        m->x[a][1] /= reach;
    }
}

static void make_extrapolation(stress_maker *m, const int *conn)
{
    extrapolation *by = &m->by;
    take_places(m, conn);
    by->nbest = brick_best_points(m->brick, by->best);
    by->nnode = m->plane.nnode * (m->body->order + 1);
    by->ncolumn = 0;
    add_powers(m);
    add_products(m);
    memset(by->to_node, 0, sizeof by->to_node);
    for (int i = 0; i < by->nnode; i++) {
        for (int k = 0; k < by->ncolumn; k++) {
            for (int j = 0; j < by->nbest; j++) {
                by->to_node[i][j] += by->at_node[k][i] * by->q[k][j];
            }
        }
    }
}

// --- elements

static void gather(const stress_maker *m, const int *conn, int layer, double *u)
{
    const int n2 = m->plane.nnode, nplane = m->body->plane->nnode;
    for (int i = 0; i < m->by.nnode; i++) {
        const int level = layer * m->body->order + i / n2 - m->run->first;
        const double *from = m->u + 3 * ((size_t)level * (size_t)nplane + (size_t)conn[i % n2]);
        memcpy(u + 3 * i, from, 3 * sizeof *u);
    }
}

static void add_to_nodes(stress_maker *m, const int *apart, int layer, double (*best)[6])
{
    const segment_body *here = m->here;
    for (int i = 0; i < m->by.nnode; i++) {
        const int level = layer * m->body->order + i / m->plane.nnode;
        if (level < here->first || level >= here->last) {
            continue;
        }
        const size_t to = (size_t)(level - here->first) * (size_t)here->apart.nnode +
                          (size_t)apart[i % m->plane.nnode];
        for (int j = 0; j < m->by.nbest; j++) {
            for (int k = 0; k < 6; k++) {
                m->sum[6 * to + (size_t)k] += m->by.to_node[i][j] * best[j][k];
            }
        }
        m->count[to]++;
    }
}

static status add_layer(stress_maker *m, int block, int e, int layer)
{
    status st = OK;
    const size_t n2 = (size_t)m->plane.nnode;
    const int *conn = m->body->plane->block[block].conn + (size_t)e * n2;
    double u[BRICK_MAX_DOFS], best[MOST_BEST][6], strain[6];
    gather(m, conn, layer, u);
    for (int j = 0; j < m->by.nbest; j++) {
        TRY(brick_stress_at(m->brick, layer, m->by.best[j], u, strain, best[j], NULL));
    }
    add_to_nodes(m, m->here->apart.block[block].conn + (size_t)e * n2, layer, best);

done:
    return st;
}

// layers that touch the levels here and whose own levels are all known
static bool is_near(const stress_maker *m, int layer)
{
    const int from = layer * m->body->order, to = from + m->body->order;
    return to >= m->here->first && from < m->here->last && from >= m->run->first &&
           to < m->run->last;
}

static status add_block(stress_maker *m, int block)
{
    status st = OK;
    const mesh_block *k = &m->body->plane->block[block];
    const int order = m->body->plane->order;
    TRY(element_make(k->shape, order, &m->plane));
    TRY(element_make(k->shape, order > 1 ? order - 1 : 1, &m->lower));
    for (int e = 0; e < k->nelem; e++) {
        TRY(brick_stand_on(m->brick, block, e));
        make_extrapolation(m, k->conn + (size_t)e * (size_t)k->per_elem);
        for (int layer = 0; layer < m->body->nlayer; layer++) {
            if (is_near(m, layer) && body_material(m->body, block, e, layer) >= 0) {
                TRY(add_layer(m, block, e, layer));
            }
        }
    }

done:
    return st;
}

status after_stress(const segment_body *here, const body *b, const way_run *run, const double *u,
                    double **stress)
{
    status st = OK;
    stress_maker *m = NULL;
    const size_t n = (size_t)(here->last - here->first) * (size_t)here->apart.nnode;
    TRY(TAKE(m, 1));
    m->here = here;
    m->body = b;
    m->run = run;
    m->u = u;
    TRY(TAKE(m->sum, 6 * n));
    TRY(TAKE(m->count, n));
    TRY(brick_make(b, &m->brick));
    for (int block = 0; block < b->plane->nblock; block++) {
        TRY(add_block(m, block));
    }
    for (size_t i = 0; i < 6 * n; i++) {
        // no matter there: no stress
        m->sum[i] = m->count[i / 6] > 0 ? m->sum[i] / m->count[i / 6] : 0;
    }
    *stress = m->sum;
    m->sum = NULL;

done:
    if (m) {
        brick_free(m->brick);
        free(m->sum);
        free(m->count);
    }
    free(m);
    return st;
}
