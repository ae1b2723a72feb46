// fem/unknowns_pattern.c
// Which blocks of unknowns are coupled.
#include "fem/unknowns.h"

#include "base/memory.h"

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

status unknowns_pattern(const unknowns *u, int *own, int *beyond)
{
    status st = OK;
    int *after = NULL, *all = NULL;
    const int top = u->nlevel - 1, p = u->body->order;
    const bool has_tip = unknowns_has_tip(u);
    TRY(TAKE(after, (size_t)u->nplane));
    TRY(TAKE(all, (size_t)u->nplane));
    TRY(count_neighbours(u->body->plane, after, all));
    for (int level = u->share.first; level < u->share.last; level++) {
        // the highest level that shares a layer with this one
        const int reach = level == top ? top : (level / p + 1) * p;
        const int to_cap = u->cap && reach == top ? 2 : 0;
        const int highest = to_cap ? top - 1 : reach;
        const int inside = highest < u->share.last ? highest : u->share.last - 1;
        for (int i = 0; i < u->nplane; i++) {
            const int block = unknowns_block(u, i, level);
            if (block >= 0) {
                own[block - u->first] =
                    after[i] + all[i] * (inside - level) + (has_tip ? to_cap : 0);
                beyond[block - u->first] = all[i] * (highest - inside) + (has_tip ? 0 : to_cap);
            }
        }
    }
    if (u->cap && has_tip) {
        const int cap = u->cap_block - u->first;
        own[cap] = 2;
        own[cap + 1] = 1;
        beyond[cap] = beyond[cap + 1] = 0;
    }

done:
    free(after);
    free(all);
    return st;
}
