#include "section/stiffness.h"

#include "base/memory.h"
#include "section/node_graph.h"

#include <limits.h>
#include <math.h>
#include <string.h>

void stiffness_free(stiffness *s)
{
    for (int k = 0; k < 2; k++) {
        sparse_lower_free(&s->part[k].E);
        free(s->part[k].P.value);
    }
    sparse_lower_free(&s->graph);
    free(s->where);
    free(s->rank);
    *s = (stiffness){0};
}

// --- pattern

// A node column of c entries (its own first) becomes the `width` columns of its components, of
// width c - a entries each: entry k, component r of column a is at width k + r - a.
static int node_start(const sparse_lower *graph, int width, int j)
{
    return width * width * graph->start[j] - j * (width * (width - 1) / 2);
}

static int column_start(const sparse_lower *graph, int width, int j, int a)
{
    const int c = graph->start[j + 1] - graph->start[j];
    return node_start(graph, width, j) + a * width * c - a * (a - 1) / 2;
}

static status make_pattern(const sparse_lower *graph, int width, sparse_lower *m)
{
    status st = OK;
    const int n = graph->n, total = node_start(graph, width, n);
    m->n = width * n;
    TRY(TAKE(m->start, (size_t)m->n + 1));
    TRY(TAKE(m->row, (size_t)total));
    TRY(TAKE(m->value, (size_t)total));
    for (int j = 0; j < n; j++) {
        const int c = graph->start[j + 1] - graph->start[j], *near = graph->row + graph->start[j];
        for (int a = 0; a < width; a++) {
            const int start = column_start(graph, width, j, a);
            m->start[width * j + a] = start;
            for (int u = a; u < width * c; u++) {
                m->row[start + u - a] = width * near[u / width] + u % width;
            }
        }
    }
    m->start[m->n] = total;

done:
    return st;
}

static status make_part(const sparse_lower *graph, bool turning, stiffness_part *part)
{
    status st = OK;
    TRY(make_pattern(graph, part->width, &part->E));
    if (turning) {
        part->P = part->E;
        part->P.complex = true;
        part->P.value = NULL;
        TRY(TAKE(part->P.value, 2 * (size_t)part->E.start[part->E.n]));
    }

done:
    return st;
}

static status rank_nodes(const mesh *m, int **rank)
{
    status st = OK;
    sparse_lower graph = {0};
    int *order = NULL;
    TRY(TAKE(order, (size_t)m->nnode));
    TRY(TAKE(*rank, (size_t)m->nnode));
    TRY(node_graph_make(m, NULL, &graph));
    TRY(cholesky_order(&graph, order));
    for (int i = 0; i < m->nnode; i++) {
        (*rank)[order[i]] = i;
    }

done:
    sparse_lower_free(&graph);
    free(order);
    return st;
}

// Entries are counted in ints: ten million nodes, of which the factors would need 100 GB.
static status check_size(const mesh *m)
{
    double most = 0;
    for (int b = 0; b < m->nblock; b++) {
        const double n = m->block[b].per_elem;
        most += m->block[b].nelem * (n * (n + 1) / 2);
    }
    return 9 * most < INT_MAX
               ? OK
               : status_fail(ERR_RESOURCE, "section: a mesh of %d nodes is too large", m->nnode);
}

status stiffness_make(const mesh *m, bool split, bool turning, stiffness *out)
{
    status st = OK;
    const int n = m->nnode;
    stiffness s = {.nnode = n, .npart = split ? 2 : 1};
    s.part[0] = (stiffness_part){.first = 0, .width = split ? 2 : 3};
    s.part[1] = (stiffness_part){.first = 2, .width = 1, .begin = 2 * n};
    TRY(check_size(m));
    TRY(rank_nodes(m, &s.rank));
    TRY(node_graph_make(m, s.rank, &s.graph));
    for (int k = 0; k < s.npart; k++) {
        TRY(make_part(&s.graph, turning, &s.part[k]));
    }
    TRY(TAKE(s.where, (size_t)n));
    *out = s;
    s = (stiffness){0};

done:
    stiffness_free(&s);
    return st;
}

// --- values

static void add_wave(const element_blocks *blocks, int pair, int entry, double *to)
{
    to[0] += blocks->E[entry][pair] + blocks->wave[0][entry][pair];
    to[1] += blocks->wave[1][entry][pair];
}

// the column of local node j; number: [nnode] of the element's nodes
static void add_column(stiffness *s, const stiffness_part *part, const int *number, int n,
                       const element_blocks *blocks, int j)
{
    const int width = part->width, first = part->first;
    for (int a = 0; a < width; a++) {
        const int start = column_start(&s->graph, width, number[j], a);
        for (int i = 0; i < n; i++) {
            if (number[i] < number[j]) {
                continue;
            }
            for (int r = i == j ? a : 0; r < width; r++) {
                const int at = start + width * s->where[number[i]] + r - a;
                const int entry = 3 * (first + r) + first + a;
                part->E.value[at] += blocks->E[entry][i * n + j];
                if (part->P.value) {
                    add_wave(blocks, i * n + j, entry, part->P.value + 2 * (size_t)at);
                }
            }
        }
    }
}

void stiffness_add(stiffness *s, const plane_element *e, const element_blocks *blocks)
{
    const int n = e->nnode;
    int number[ELEMENT_MAX_PLANE_NODES];
    for (int i = 0; i < n; i++) {
        number[i] = s->rank[e->node[i]];
    }
    for (int j = 0; j < n; j++) {
        const int begin = s->graph.start[number[j]], end = s->graph.start[number[j] + 1];
        for (int k = begin; k < end; k++) {
            s->where[s->graph.row[k]] = k - begin;
        }
        for (int k = 0; k < s->npart; k++) {
            add_column(s, &s->part[k], number, n, blocks, j);
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

stiffness_pins stiffness_choose_pins(const stiffness *s, const plane *p)
{
    const int a = farthest_node(p, 0, 0);
    const int b = farthest_node(p, p->xy[2 * a], p->xy[2 * a + 1]);
    // the second node is held across the line from the first
    const double dx = fabs(p->xy[2 * b] - p->xy[2 * a]);
    const double dy = fabs(p->xy[2 * b + 1] - p->xy[2 * a + 1]);
    return (stiffness_pins){{
        stiffness_unknown(s, a, 0),
        stiffness_unknown(s, a, 1),
        stiffness_unknown(s, a, 2),
        stiffness_unknown(s, b, dx > dy ? 1 : 0),
    }};
}

static bool is_pinned(const stiffness_pins *pins, int unknown)
{
    const int *u = pins->unknown;
    return unknown == u[0] || unknown == u[1] || unknown == u[2] || unknown == u[3];
}

static void pin_part(const stiffness_part *part, const stiffness_pins *pins)
{
    const sparse_lower *m = &part->E;
    for (int j = 0; j < m->n; j++) {
        const bool column = is_pinned(pins, part->begin + j);
        if (part->P.value) { // a Hermitian diagonal is real, not real to rounding
            part->P.value[2 * (size_t)m->start[j] + 1] = 0;
        }
        for (int k = m->start[j]; k < m->start[j + 1]; k++) {
            if (m->row[k] == j || (!column && !is_pinned(pins, part->begin + m->row[k]))) {
                continue;
            }
            m->value[k] = 0;
            if (part->P.value) {
                part->P.value[2 * (size_t)k] = part->P.value[2 * (size_t)k + 1] = 0;
            }
        }
    }
}

void stiffness_pin(stiffness *s, const stiffness_pins *pins)
{
    for (int k = 0; k < s->npart; k++) {
        pin_part(&s->part[k], pins);
    }
}

// --- factors

void stiffness_factor_free(stiffness_factor *f)
{
    cholesky_free(f->part[0]);
    cholesky_free(f->part[1]);
    *f = (stiffness_factor){0};
}

status stiffness_factor_make(const stiffness *s, bool wave, stiffness_factor *out)
{
    status st = OK;
    stiffness_factor f = {.npart = s->npart, .nunknown = 3 * s->nnode, .wave = wave};
    for (int k = 0; k < s->npart; k++) {
        const stiffness_part *part = &s->part[k];
        f.begin[k] = part->begin;
        TRY(cholesky_make(wave ? &part->P : &part->E, &f.part[k]));
    }
    *out = f;
    f = (stiffness_factor){0};

done:
    stiffness_factor_free(&f);
    return st;
}

status stiffness_solve(const stiffness_factor *f, int nrhs, const double *b, double *x)
{
    status st = OK;
    for (int k = 0; k < f->npart; k++) {
        const int at = (f->wave ? 2 : 1) * f->begin[k];
        TRY(cholesky_solve(f->part[k], nrhs, f->nunknown, b + at, x + at));
    }

done:
    return st;
}
