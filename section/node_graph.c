#include "section/node_graph.h"

#include "base/memory.h"

// The elements around each node, as [nnode + 1] starts into a list of (pointer to the element's
// nodes, how many).
typedef struct element_nodes {
    const int *node;
    int count;
} element_nodes;

typedef struct neighbours {
    const int *rank;
    int *start;
    element_nodes *around;
} neighbours;

static int number(const neighbours *n, int node)
{
    return n->rank ? n->rank[node] : node;
}

static status neighbours_make(const mesh *m, neighbours *out)
{
    status st = OK;
    int total = 0;
    TRY(TAKE(out->start, (size_t)m->nnode + 2));
    for (int b = 0; b < m->nblock; b++) {
        const int count = m->block[b].nelem * m->block[b].per_elem;
        for (int i = 0; i < count; i++) {
            out->start[number(out, m->block[b].conn[i]) + 2]++;
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
            const int at = out->start[number(out, m->block[b].conn[i]) + 1]++;
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
                const int j = number(n, n->around[k].node[a]);
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

status node_graph_make(const mesh *m, const int *rank, sparse_lower *graph)
{
    status st = OK;
    neighbours near = {.rank = rank};
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
