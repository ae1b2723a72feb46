// fem/plane_pattern.c
// Sparse matrices of the plane forms within some directions.
#include "fem/plane_forms.h"

#include "base/memory.h"

void plane_pattern_free(plane_pattern *p)
{
    free(p->start);
    free(p->column);
    *p = (plane_pattern){0};
}

// Elements that meet at each node: list[start[i]] .. list[start[i + 1] - 1].
typedef struct meeting {
    int *start, *list;
} meeting;

static const int *nodes_of(const mesh *plane, int number, int *count)
{
    const int first = plane->block[0].nelem;
    const mesh_block *k = &plane->block[number < first ? 0 : 1];
    *count = k->per_elem;
    return k->conn + (size_t)(number < first ? number : number - first) * (size_t)k->per_elem;
}

static status meeting_make(const mesh *plane, meeting *m)
{
    status st = OK;
    const int elements = mesh_element_count(plane);
    int count = 0;
    TRY(TAKE(m->start, (size_t)plane->nnode + 2));
    for (int e = 0; e < elements; e++) {
        const int *conn = nodes_of(plane, e, &count);
        for (int i = 0; i < count; i++) {
            m->start[conn[i] + 2]++;
        }
    }
    for (int i = 0; i < plane->nnode; i++) {
        m->start[i + 2] += m->start[i + 1];
    }
    TRY(TAKE(m->list, (size_t)m->start[plane->nnode + 1]));
    for (int e = 0; e < elements; e++) {
        const int *conn = nodes_of(plane, e, &count);
        for (int i = 0; i < count; i++) {
            m->list[m->start[conn[i] + 1]++] = e;
        }
    }

done:
    return st;
}

static int ascending(const void *a, const void *b)
{
    const int x = *(const int *)a, y = *(const int *)b;
    return (x > y) - (x < y);
}

// neighbours of a node, itself among them, ascending; list NULL: counts only
static int neighbours(const mesh *plane, const meeting *m, int node, int *seen, int *list)
{
    int found = 0;
    for (int i = m->start[node]; i < m->start[node + 1]; i++) {
        int count = 0;
        const int *conn = nodes_of(plane, m->list[i], &count);
        for (int k = 0; k < count; k++) {
            if (seen[conn[k]] != node + 1) {
                seen[conn[k]] = node + 1;
                list[found++] = conn[k];
            }
        }
    }
    qsort(list, (size_t)found, sizeof *list, ascending);
    return found;
}

// columns of one row, or only their number
static int fill_row(const plane_pattern *p, int nplane, int row, int found, const int *list,
                    int *column)
{
    int next = 0;
    for (int d = row / nplane; d < p->to - p->from; d++) {
        for (int k = 0; k < found; k++) {
            const int at = d * nplane + list[k];
            if (at >= row) {
                if (column) {
                    column[next] = at;
                }
                next++;
            }
        }
    }
    return next;
}

static status fill(plane_pattern *p, const mesh *plane, const meeting *m, int *column)
{
    status st = OK;
    const int n = plane->nnode;
    int *seen = NULL, *list = NULL;
    TRY(TAKE(seen, (size_t)n));
    TRY(TAKE(list, (size_t)n));
    for (int i = 0; i < n; i++) {
        const int found = neighbours(plane, m, i, seen, list);
        for (int row = i; row < p->ndof; row += n) {
            const int count =
                fill_row(p, n, row, found, list, column ? column + p->start[row] : NULL);
            if (!column) {
                p->start[row + 1] = count;
            }
        }
    }

done:
    free(seen);
    free(list);
    return st;
}

status plane_pattern_make(const plane_forms *f, int from, int to, plane_pattern *out)
{
    status st = OK;
    plane_pattern p = {.from = from, .to = to, .ndof = (to - from) * f->plane->nnode};
    meeting m = {0};
    TRY(meeting_make(f->plane, &m));
    TRY(TAKE(p.start, (size_t)p.ndof + 1));
    TRY(fill(&p, f->plane, &m, NULL));
    for (int i = 0; i < p.ndof; i++) {
        p.start[i + 1] += p.start[i];
    }
    TRY(TAKE(p.column, (size_t)p.start[p.ndof]));
    TRY(fill(&p, f->plane, &m, p.column));
    *out = p;
    p = (plane_pattern){0};

done:
    free(m.start);
    free(m.list);
    plane_pattern_free(&p);
    return st;
}

static double *entry(const plane_pattern *p, double *value, int row, int column)
{
    int low = p->start[row], high = p->start[row + 1] - 1;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (p->column[middle] < column) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return value + low;
}

void plane_pattern_values(const plane_pattern *p, const plane_forms *f, plane_form which,
                          double *value)
{
    const int n = f->plane->nnode;
    for (int i = 0; i < p->start[p->ndof]; i++) {
        value[i] = 0;
    }
    for (int e = 0; e < (int)f->elements; e++) {
        int n2 = 0;
        const int *conn = nodes_of(f->plane, e, &n2);
        const size_t n3 = 3 * (size_t)n2;
        const double *A = f->value + f->at[e] + (size_t)which * n3 * n3;
        for (int r = p->from * n2; r < p->to * n2; r++) {
            for (int c = p->from * n2; c < p->to * n2; c++) {
                const int row = (r / n2 - p->from) * n + conn[r % n2];
                const int column = (c / n2 - p->from) * n + conn[c % n2];
                if (column >= row) {
                    *entry(p, value, row, column) += A[(size_t)r * n3 + (size_t)c];
                }
            }
        }
    }
}
