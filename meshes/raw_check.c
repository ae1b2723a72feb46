// meshes/raw_check.c
#include "meshes/raw_check.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

// of the section's size: out of the plane
static const double PLANE_TOLERANCE = 1e-6;

typedef long long number; // for printf

status raw_check_plane(const raw_mesh *r)
{
    const int first = r->conn[0];
    const double z = r->xyz[3 * (size_t)first + 2], allowed = PLANE_TOLERANCE * raw_extent(r);
    for (int i = 0; i < r->nconn; i++) {
        const double *x = r->xyz + 3 * (size_t)r->conn[i];
        if (!(fabs(x[2] - z) <= allowed)) {
            return input_file_fail(r->file, 0,
                                   "node %lld lies at z = %g, node %lld at z = %g: a section's "
                                   "mesh lies in a plane z = constant",
                                   (number)r->node_id[r->conn[i]], x[2], (number)r->node_id[first],
                                   z);
        }
    }
    return OK;
}

static int side_count(const raw_element *e)
{
    return e->shape == SHAPE_QUAD ? 4 : 3;
}

status raw_check_turns(const raw_mesh *r, bool *turned)
{
    for (int k = 0; k < r->nelem; k++) {
        const raw_element *e = &r->elem[k];
        const int n = side_count(e), *c = r->conn + e->first;
        const double *a = r->xyz + 3 * (size_t)c[0];
        double area = 0;
        for (int i = 1; i + 1 < n; i++) {
            const double *p = r->xyz + 3 * (size_t)c[i], *q = r->xyz + 3 * (size_t)c[i + 1];
            area += (p[0] - a[0]) * (q[1] - a[1]) - (p[1] - a[1]) * (q[0] - a[0]);
        }
        turned[k] = area < 0;
        for (int i = 0; i < n; i++) {
            if (c[i] == c[(i + 1) % n] || area == 0) {
                return input_file_fail(r->file, 0, "element %lld has no area", (number)e->id);
            }
        }
    }
    return OK;
}

// --- edges

typedef struct side {
    int low, high; // corners
    int elem, at;  // which side of the element, as the file has it
    bool forward;  // from low to high, once the element is turned
} side;

static int side_order(const void *a, const void *b)
{
    const side *p = a, *q = b;
    const int order[] = {p->low - q->low, p->high - q->high, p->elem - q->elem, p->at - q->at};
    for (int i = 0; i < 4; i++) {
        if (order[i] != 0) {
            return order[i];
        }
    }
    return 0;
}

static void list_sides(const raw_mesh *r, const bool *turned, side *out)
{
    for (int k = 0; k < r->nelem; k++) {
        const raw_element *e = &r->elem[k];
        const int n = side_count(e), *c = r->conn + e->first;
        for (int i = 0; i < n; i++) {
            const int a = c[i], b = c[(i + 1) % n];
            *out++ = (side){.low = a < b ? a : b,
                            .high = a < b ? b : a,
                            .elem = k,
                            .at = i,
                            .forward = (a < b) != turned[k]};
        }
    }
}

// the t-th of the nodes between the corners, counted from the lower corner
static int between(const raw_mesh *r, const side *s, int t)
{
    const raw_element *e = &r->elem[s->elem];
    const int p = r->order, *c = r->conn + e->first;
    const int from_low = c[s->at] == s->low ? t : p - 2 - t;
    return c[side_count(e) + s->at * (p - 1) + from_low];
}

static status sides_fit(const raw_mesh *r, const side *a, const side *b)
{
    const number one = r->elem[a->elem].id, two = r->elem[b->elem].id;
    if (a->forward == b->forward) {
        return input_file_fail(r->file, 0,
                               "elements %lld and %lld lie on the same side of their common edge, "
                               "between nodes %lld and %lld: the mesh is folded",
                               one, two, (number)r->node_id[a->low], (number)r->node_id[a->high]);
    }
    for (int t = 0; t < r->order - 1; t++) {
        if (between(r, a, t) != between(r, b, t)) {
            return input_file_fail(r->file, 0,
                                   "elements %lld and %lld share two corners but not the nodes "
                                   "between them",
                                   one, two);
        }
    }
    return OK;
}

static int root_of(int *parent, int i)
{
    while (parent[i] != i) {
        parent[i] = parent[parent[i]];
        i = parent[i];
    }
    return i;
}

typedef struct edges {
    const raw_mesh *r;
    int nside;
    side *all;   // [nside] sorted
    int *parent; // [nelem] what hangs together
    int *role;   // [nnode] 0 unused, 1 a corner, 2 + edge, -1 inside an element
    int nborder;
    int *border; // [nborder] the ends of edges with one element, two by two
} edges;

static status take_role(edges *w, int node, int role, const raw_element *e)
{
    if (w->role[node] != 0 && (w->role[node] != role || role == -1)) {
        return input_file_fail(w->r->file, 0, "node %lld has another place in element %lld",
                               (number)w->r->node_id[node], (number)e->id);
    }
    w->role[node] = role;
    return OK;
}

// sides first to last - 1 are of one edge
static status take_edge(edges *w, int first, int last)
{
    status st = OK;
    const side *s = &w->all[first];
    const raw_mesh *r = w->r;
    if (last - first > 2) {
        TRY(input_file_fail(r->file, 0,
                            "%d elements share the edge between nodes %lld and %lld, %lld, %lld "
                            "and %lld among them: the mesh overlaps itself",
                            last - first, (number)r->node_id[s->low], (number)r->node_id[s->high],
                            (number)r->elem[s[0].elem].id, (number)r->elem[s[1].elem].id,
                            (number)r->elem[s[2].elem].id));
    }
    if (last - first == 2) {
        TRY(sides_fit(r, s, s + 1));
        const int a = root_of(w->parent, s->elem), b = root_of(w->parent, s[1].elem);
        w->parent[a > b ? a : b] = a > b ? b : a;
    } else {
        w->border[w->nborder++] = s->low;
        w->border[w->nborder++] = s->high;
    }
    TRY(take_role(w, s->low, 1, &r->elem[s->elem]));
    TRY(take_role(w, s->high, 1, &r->elem[s->elem]));
    for (int t = 0; t < r->order - 1; t++) {
        TRY(take_role(w, between(r, s, t), 2 + first, &r->elem[s->elem]));
    }

done:
    return st;
}

static status take_insides(edges *w)
{
    status st = OK;
    for (int k = 0; k < w->r->nelem; k++) {
        const raw_element *e = &w->r->elem[k];
        const int n = element_node_count(e->shape, w->r->order);
        for (int i = side_count(e) * w->r->order; i < n; i++) {
            TRY(take_role(w, w->r->conn[e->first + i], -1, e));
        }
    }

done:
    return st;
}

static status check_connected(edges *w)
{
    for (int k = 0; k < w->r->nelem; k++) {
        if (root_of(w->parent, k) != 0) {
            return input_file_fail(w->r->file, 0,
                                   "elements %lld and %lld do not hang together through edges: a "
                                   "section is one piece",
                                   (number)w->r->elem[0].id, (number)w->r->elem[k].id);
        }
    }
    return OK;
}

status raw_check_edges(const raw_mesh *r, const bool *turned)
{
    status st = OK;
    edges w = {.r = r};
    for (int k = 0; k < r->nelem; k++) {
        w.nside += side_count(&r->elem[k]);
    }
    TRY(TAKE(w.all, (size_t)w.nside));
    TRY(TAKE(w.parent, (size_t)r->nelem));
    TRY(TAKE(w.role, (size_t)r->nnode));
    TRY(TAKE(w.border, 2 * (size_t)w.nside));
    for (int k = 0; k < r->nelem; k++) {
        w.parent[k] = k;
    }
    list_sides(r, turned, w.all);
    qsort(w.all, (size_t)w.nside, sizeof *w.all, side_order);
    for (int i = 0, last = 0; i < w.nside; i = last) {
        for (last = i + 1;
             last < w.nside && w.all[last].low == w.all[i].low && w.all[last].high == w.all[i].high;
             last++) {
        }
        TRY(take_edge(&w, i, last));
    }
    TRY(take_insides(&w));
    TRY(raw_check_border(r, w.nborder / 2, w.border));
    TRY(check_connected(&w));

done:
    free(w.all);
    free(w.parent);
    free(w.role);
    free(w.border);
    return st;
}
