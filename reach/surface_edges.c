// reach/surface_edges.c
// Which two triangles meet at an edge: edges are sorted by their vertices.
#include "reach/surface_inside.h"

#include "base/memory.h"

typedef struct edge {
    int low, high; // vertices, low < high
    int side;      // 3 t + k
} edge;

static int compare(const void *x, const void *y)
{
    const edge *a = x, *b = y;
    if (a->low != b->low) {
        return a->low < b->low ? -1 : 1;
    }
    if (a->high != b->high) {
        return a->high < b->high ? -1 : 1;
    }
    return (a->side > b->side) - (a->side < b->side);
}

static void list_edges(const surface *s, edge *list)
{
    for (int i = 0; i < 3 * s->ntriangle; i++) {
        const int a = s->triangle[i / 3][i % 3], c = s->triangle[i / 3][(i % 3 + 1) % 3];
        list[i] = (edge){a < c ? a : c, a < c ? c : a, i};
    }
}

static void middle(const surface *s, const edge *e, double place[3])
{
    for (int d = 0; d < 3; d++) {
        place[d] = 0.5 * (s->vertex[e->low][d] + s->vertex[e->high][d]);
    }
}

status surface_pair_edges(surface_work *w)
{
    status st = OK;
    surface *s = &w->s;
    const int n = 3 * s->ntriangle;
    edge *list = NULL;
    int open = -1, many = -1, nopen = 0, nmany = 0, end = 0;
    double place[3];
    TRY(TAKE(list, (size_t)n));
    TRY(TAKE(s->across, (size_t)s->ntriangle));
    list_edges(s, list);
    qsort(list, (size_t)n, sizeof *list, compare);
    for (int i = 0; i < n; i = end) {
        for (end = i + 1;
             end < n && list[end].low == list[i].low && list[end].high == list[i].high;) {
            end++;
        }
        if (end - i == 2) {
            s->across[list[i].side / 3][list[i].side % 3] = list[i + 1].side;
            s->across[list[i + 1].side / 3][list[i + 1].side % 3] = list[i].side;
        }
        open = end - i == 1 ? i : open;
        nopen += end - i == 1;
        many = end - i > 2 ? i : many;
        nmany += end - i > 2;
    }
    if (nmany > 0) {
        middle(s, &list[many], place);
        TRY(surface_fail(w, place, "%d edges have more than two triangles", nmany));
    }
    if (nopen > 0) {
        middle(s, &list[open], place);
        TRY(surface_fail(w, place, "it is not closed: %d edges have only one triangle", nopen));
    }

done:
    free(list);
    return st;
}
