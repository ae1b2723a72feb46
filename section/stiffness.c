// section/stiffness.c
#include "section/stiffness.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

void stiffness_free(stiffness *s)
{
    sparse_lower_free(&s->graph);
    sparse_lower_free(&s->matrix);
    free(s->where);
    *s = (stiffness){0};
}

// --- pattern

// The elements around each node, as [nnode + 1] starts into a list of (pointer to the element's
// nodes, how many).
typedef struct element_nodes {
    const int *node;
    int count;
} element_nodes;

typedef struct neighbours {
    int *start;
    element_nodes *around;
} neighbours;

static status neighbours_make(const mesh *m, neighbours *out)
{
    status st = OK;
    int total = 0;
    TRY(TAKE(out->start, (size_t)m->nnode + 2));
    for (int b = 0; b < m->nblock; b++) {
        const int count = m->block[b].nelem * m->block[b].per_elem;
        for (int i = 0; i < count; i++) {
            out->start[m->block[b].conn[i] + 2]++;
        }
        total += count;
    }
    for (int i = 2; i < m->nnode + 2; i++) {
        out->start[i] += out->start[i - 1];
    }
    TRY(TAKE(out->around, (size_t)total));
    for (int b = 0; b < m->nblock; b++) {
        const int n = m->block[b].per_elem;
        for (int i = 0; i < n * m->block[b].nelem; i++) {
            const int at = out->start[m->block[b].conn[i] + 1]++;
            out->around[at] = (element_nodes){m->block[b].conn + i / n * n, n};
        }
    }

done:
    return st;
}

static void neighbours_free(neighbours *n)
{
    free(n->start);
    free(n->around);
}

// Visits the neighbours j <= i of each node i in order of i, so that columns fill with ascending
// rows: counts them, or writes them where `row` is given.
static void visit_lower(const neighbours *n, int nnode, int *mark, int *next, int *row)
{
    for (int i = 0; i < nnode; i++) {
        for (int k = n->start[i]; k < n->start[i + 1]; k++) {
            for (int a = 0; a < n->around[k].count; a++) {
                const int j = n->around[k].node[a];
                if (j > i || mark[j] == i + 1) {
                    continue;
                }
                mark[j] = i + 1;
                if (row) {
                    row[next[j]] = i;
                }
                next[j]++;
            }
        }
    }
}

static status make_graph(const mesh *m, sparse_lower *graph)
{
    status st = OK;
    neighbours near = {0};
    int *mark = NULL, *next = NULL;
    const int n = m->nnode;
    const size_t room = (size_t)n + 1;
    TRY(neighbours_make(m, &near));
    TRY(TAKE(mark, room));
    TRY(TAKE(next, room));
    TRY(TAKE(graph->start, room));
    graph->n = n;
    visit_lower(&near, n, mark, next, NULL);
    for (int j = 0; j < n; j++) {
        graph->start[j + 1] = graph->start[j] + next[j];
        next[j] = graph->start[j];
        mark[j] = 0;
    }
    TRY(TAKE(graph->row, (size_t)graph->start[n]));
    visit_lower(&near, n, mark, next, graph->row);

done:
    free(mark);
    free(next);
    neighbours_free(&near);
    return st;
}

// A node column of c entries (its own first) becomes the columns x of 2c, y of 2c - 1 and z of c
// entries.
static int plane_start(const sparse_lower *graph, int j)
{
    return 4 * graph->start[j] - j;
}

static status make_matrix(const sparse_lower *graph, sparse_lower *a)
{
    status st = OK;
    const int n = graph->n, plane_end = plane_start(graph, n);
    const size_t total = (size_t)plane_end + (size_t)graph->start[n];
    a->n = 3 * n;
    TRY(TAKE(a->start, (size_t)a->n + 1));
    TRY(TAKE(a->row, total));
    TRY(TAKE(a->value, total));
    for (int j = 0; j < n; j++) {
        const int c = graph->start[j + 1] - graph->start[j], *near = graph->row + graph->start[j];
        int *x = a->row + plane_start(graph, j), *y = x + 2 * c - 1;
        int *z = a->row + plane_end + graph->start[j];
        for (int k = 0; k < c; k++) {
            x[2 * k] = 2 * near[k];
            x[2 * k + 1] = 2 * near[k] + 1;
            // y[0] is the last entry of column x: both are row y of the node itself or of its last
            // neighbour
            y[2 * k + 1] = 2 * near[k] + 1;
            if (k > 0) {
                y[2 * k] = 2 * near[k];
            }
            z[k] = 2 * n + near[k];
        }
        a->start[2 * j] = plane_start(graph, j);
        a->start[2 * j + 1] = plane_start(graph, j) + 2 * c;
        a->start[2 * n + j] = plane_end + graph->start[j];
    }
    a->start[3 * n] = (int)total;

done:
    return st;
}

status stiffness_make(const mesh *m, stiffness *out)
{
    status st = OK;
    stiffness s = {.nnode = m->nnode};
    TRY(make_graph(m, &s.graph));
    TRY(make_matrix(&s.graph, &s.matrix));
    TRY(TAKE(s.where, (size_t)m->nnode));
    *out = s;
    s = (stiffness){0};

done:
    stiffness_free(&s);
    return st;
}

// --- values

enum { MOST = ELEMENT_MAX_PLANE_NODES };

// int dN_i/da dN_j/db for a, b among x, y
typedef struct gradient_products {
    double xx[MOST][MOST], xy[MOST][MOST], yy[MOST][MOST];
} gradient_products;

static void multiply_gradients(const plane_element *e, gradient_products *p)
{
    const int n = e->nnode;
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            p->xx[i][j] = p->xy[i][j] = p->yy[i][j] = 0;
        }
    }
    for (int q = 0; q < e->npoint; q++) {
        const double *Nx = e->Nx + q * n, *Ny = e->Ny + q * n;
        for (int i = 0; i < n; i++) {
            const double a = e->dA[q] * Nx[i], b = e->dA[q] * Ny[i];
            for (int j = 0; j < n; j++) {
                p->xx[i][j] += a * Nx[j];
                p->xy[i][j] += a * Ny[j];
                p->yy[i][j] += b * Ny[j];
            }
        }
    }
}

void stiffness_add(stiffness *s, const plane_element *e, double lambda, double G)
{
    gradient_products p;
    multiply_gradients(e, &p);
    const int n = e->nnode;
    double *value = s->matrix.value;
    for (int j = 0; j < n; j++) {
        const int column = e->node[j], first = s->graph.start[column];
        const int c = s->graph.start[column + 1] - first;
        for (int k = 0; k < c; k++) {
            s->where[s->graph.row[first + k]] = k;
        }
        double *x = value + plane_start(&s->graph, column), *y = x + 2 * c - 1;
        double *z = value + plane_start(&s->graph, s->nnode) + first;
        for (int i = 0; i < n; i++) {
            if (e->node[i] < column) {
                continue;
            }
            const int k = s->where[e->node[i]];
            const double xx = p.xx[i][j], yy = p.yy[i][j], xy = p.xy[i][j], yx = p.xy[j][i];
            x[2 * k] += (lambda + 2 * G) * xx + G * yy;
            x[2 * k + 1] += lambda * yx + G * xy;
            if (k > 0) {
                y[2 * k] += lambda * xy + G * yx;
            }
            y[2 * k + 1] += (lambda + 2 * G) * yy + G * xx;
            z[k] += G * (xx + yy);
        }
    }
}

// --- rigid motions

static int farthest_node(const plane *p, double x, double y)
{
    int best = 0;
    double most = -1;
    for (int i = 0; i < p->mesh->nnode; i++) {
        const double r = hypot(p->xy[2 * i] - x, p->xy[2 * i + 1] - y);
        if (r > most) {
            most = r;
            best = i;
        }
    }
    return best;
}

stiffness_pins stiffness_choose_pins(const plane *p)
{
    const int n = p->mesh->nnode;
    const int a = farthest_node(p, 0, 0);
    const int b = farthest_node(p, p->xy[2 * a], p->xy[2 * a + 1]);
    // the second node is held across the line from the first
    const double dx = fabs(p->xy[2 * b] - p->xy[2 * a]);
    const double dy = fabs(p->xy[2 * b + 1] - p->xy[2 * a + 1]);
    return (stiffness_pins){{
        warping_unknown(n, a, 0),
        warping_unknown(n, a, 1),
        warping_unknown(n, a, 2),
        warping_unknown(n, b, dx > dy ? 1 : 0),
    }};
}

static bool is_pinned(const stiffness_pins *pins, int unknown)
{
    const int *u = pins->unknown;
    return unknown == u[0] || unknown == u[1] || unknown == u[2] || unknown == u[3];
}

void stiffness_pin(stiffness *s, const stiffness_pins *pins)
{
    const sparse_lower *a = &s->matrix;
    for (int j = 0; j < a->n; j++) {
        const bool column = is_pinned(pins, j);
        for (int k = a->start[j]; k < a->start[j + 1]; k++) {
            if (a->row[k] != j && (column || is_pinned(pins, a->row[k]))) {
                a->value[k] = 0;
            }
        }
    }
}

status stiffness_order(const stiffness *s, int *permutation)
{
    status st = OK;
    int *nodes = NULL;
    const int n = s->nnode;
    TRY(TAKE(nodes, (size_t)n));
    TRY(cholesky_order(&s->graph, nodes));
    for (int i = 0; i < n; i++) {
        permutation[2 * i] = 2 * nodes[i];
        permutation[2 * i + 1] = 2 * nodes[i] + 1;
        permutation[2 * n + i] = 2 * n + nodes[i];
    }

done:
    free(nodes);
    return st;
}
