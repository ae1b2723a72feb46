// fem/supports.c
#include "fem/supports.h"

#include "base/memory.h"

#include <limits.h>
#include <math.h>
#include <string.h>

void supports_free(supports *s)
{
    free(s->held);
    *s = (supports){0};
}

static int farthest_node(const mesh *plane, int from)
{
    int far = from;
    double most = -1;
    const double *x = plane->xyz + 3 * (size_t)from;
    for (int i = 0; i < plane->nnode; i++) {
        const double *y = plane->xyz + 3 * (size_t)i;
        const double d = hypot(y[0] - x[0], y[1] - x[1]);
        if (d > most) {
            most = d;
            far = i;
        }
    }
    return far;
}

// three pins against the rigid motions in the plane; they carry nothing, since the base's own
// traction balances the load
static status hold_base(const mesh *plane, supports *s)
{
    status st = OK;
    TRY(TAKE(s->held, (size_t)plane->nnode));
    memset(s->held, 1 << 2, (size_t)plane->nnode);
    const int a = farthest_node(plane, 0), b = farthest_node(plane, a);
    const double *x = plane->xyz + 3 * (size_t)a, *y = plane->xyz + 3 * (size_t)b;
    s->held[a] |= 1 | 1 << 1;
    s->held[b] |= fabs(y[0] - x[0]) > fabs(y[1] - x[1]) ? 1 << 1 : 1;

done:
    return st;
}

status supports_make(const column *c, bool clamped, bool cap, supports *out)
{
    status st = OK;
    supports s = {.clamped = clamped,
                  .cap = cap,
                  .nplane = c->plane->nnode,
                  .nlevel = c->nlevel,
                  .cap_block = -1,
                  .radius = c->radius};

    // element matrices and unknowns are numbered with int
    const double count = 3.0 * s.nplane * s.nlevel;
    if (count > INT_MAX / 16) {
        TRY(status_fail(ERR_RESOURCE, "segment: %.3g unknowns are too many", count));
    }
    s.nblock = s.nplane * (s.nlevel - (clamped ? 1 : 0) - (cap ? 1 : 0));
    if (cap) {
        s.cap_block = s.nblock;
        s.nblock += 2;
    }
    if (!clamped) {
        TRY(hold_base(c->plane, &s));
    }
    *out = s;
    s = (supports){0};

done:
    supports_free(&s);
    return st;
}

// --- which blocks are coupled

// plane nodes that share an element: neighbours of node i are list[start[i]] .. list[start[i + 1] -
// 1], i among them
typedef struct neighbours {
    int *start, *list;
} neighbours;

static void neighbours_free(neighbours *n)
{
    free(n->start);
    free(n->list);
    *n = (neighbours){0};
}

// elements at each plane node; number counts over the blocks
static status elements_at_nodes(const mesh *plane, neighbours *out)
{
    status st = OK;
    neighbours n = {0};
    size_t total = 0;
    TRY(TAKE(n.start, (size_t)plane->nnode + 2));
    for (int b = 0; b < plane->nblock; b++) {
        const size_t count = (size_t)plane->block[b].nelem * (size_t)plane->block[b].per_elem;
        for (size_t i = 0; i < count; i++) {
            n.start[plane->block[b].conn[i] + 2]++;
        }
        total += count;
    }
    for (int i = 0; i < plane->nnode; i++) {
        n.start[i + 2] += n.start[i + 1];
    }
    TRY(TAKE(n.list, total));
    for (int b = 0, number = 0; b < plane->nblock; b++) {
        const mesh_block *k = &plane->block[b];
        for (int e = 0; e < k->nelem; e++, number++) {
            for (int i = 0; i < k->per_elem; i++) {
                n.list[n.start[k->conn[(size_t)e * (size_t)k->per_elem + (size_t)i] + 1]++] =
                    number;
            }
        }
    }
    *out = n;
    n = (neighbours){0};

done:
    neighbours_free(&n);
    return st;
}

static const int *element_nodes(const mesh *plane, int number, int *count)
{
    const int first = plane->block[0].nelem;
    const mesh_block *k = &plane->block[number < first ? 0 : 1];
    *count = k->per_elem;
    return k->conn + (size_t)(number < first ? number : number - first) * (size_t)k->per_elem;
}

// after[i]: neighbours j >= i of plane node i; all[i]: all of them
static status count_neighbours(const mesh *plane, int *after, int *all)
{
    status st = OK;
    neighbours at = {0};
    int *seen = NULL;
    TRY(elements_at_nodes(plane, &at));
    TRY(TAKE(seen, (size_t)plane->nnode));
    for (int i = 0; i < plane->nnode; i++) {
        for (int s = at.start[i]; s < at.start[i + 1]; s++) {
            int count = 0;
            const int *conn = element_nodes(plane, at.list[s], &count);
            for (int a = 0; a < count; a++) {
                if (seen[conn[a]] != i + 1) {
                    seen[conn[a]] = i + 1;
                    all[i]++;
                    after[i] += conn[a] >= i;
                }
            }
        }
    }

done:
    neighbours_free(&at);
    free(seen);
    return st;
}

supports_share supports_share_of(const supports *s, int rank, int size)
{
    const int begin = s->clamped ? 1 : 0, end = s->nlevel - (s->cap ? 1 : 0);
    supports_share r = {.first_level = begin + (int)((long long)(end - begin) * rank / size),
                        .last_level = begin + (int)((long long)(end - begin) * (rank + 1) / size)};
    r.first = s->nplane * (r.first_level - begin);
    r.last = rank == size - 1 ? s->nblock : s->nplane * (r.last_level - begin);
    return r;
}

status supports_pattern(const supports *s, const column *c, supports_share share, int *own,
                        int *beyond)
{
    status st = OK;
    int *after = NULL, *all = NULL;
    TRY(TAKE(after, (size_t)s->nplane));
    TRY(TAKE(all, (size_t)s->nplane));
    TRY(count_neighbours(c->plane, after, all));
    const int top = s->nlevel - 1, p = c->order;
    for (int level = share.first_level; level < share.last_level; level++) {
        // the highest level that shares a layer with this one
        const int reach = level == top ? top : (level / p + 1) * p;
        const int to_cap = s->cap && reach == top ? 2 : 0;
        const int highest = to_cap ? top - 1 : reach;
        const bool last_rank = share.last == s->nblock;
        for (int i = 0; i < s->nplane; i++) {
            const int row = supports_block(s, i, level) - share.first;
            const int inside = highest < share.last_level ? highest : share.last_level - 1;
            own[row] = after[i] + all[i] * (inside - level) + (last_rank ? to_cap : 0);
            beyond[row] = all[i] * (highest - inside) + (last_rank ? 0 : to_cap);
        }
    }
    if (s->cap && share.last == s->nblock) {
        const int cap = s->cap_block - share.first;
        own[cap] = 2;
        own[cap + 1] = 1;
        beyond[cap] = beyond[cap + 1] = 0;
    }

done:
    free(after);
    free(all);
    return st;
}

// --- unknowns -> displacements

void supports_expand(const supports *s, const mesh *plane, const double *x, double *u)
{
    const double *cap = s->cap ? x + 3 * (size_t)s->cap_block : NULL;
    for (int level = 0; level < s->nlevel; level++) {
        for (int i = 0; i < s->nplane; i++, u += 3) {
            const int block = supports_block(s, i, level);
            if (block >= 0) {
                memcpy(u, x + 3 * (size_t)block, 3 * sizeof *u);
            } else if (s->cap && level == s->nlevel - 1) {
                const double px = plane->xyz[3 * (size_t)i], py = plane->xyz[3 * (size_t)i + 1];
                const double *turn = cap + 3;
                u[0] = cap[0] - turn[2] * py / s->radius;
                u[1] = cap[1] + turn[2] * px / s->radius;
                u[2] = cap[2] + (turn[0] * py - turn[1] * px) / s->radius;
            } else {
                memset(u, 0, 3 * sizeof *u);
            }
        }
    }
}
