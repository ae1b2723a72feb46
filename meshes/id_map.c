// meshes/id_map.c
#include "meshes/id_map.h"

#include "base/memory.h"

#include <string.h>

void id_map_free(id_map *m)
{
    free(m->sorted);
    free(m->table);
    *m = (id_map){0};
}

static int pair_order(const void *a, const void *b)
{
    const id_pair *p = a, *q = b;
    if (p->id != q->id) {
        return p->id < q->id ? -1 : 1;
    }
    return (p->index > q->index) - (p->index < q->index);
}

static status sort_pairs(int count, const int64_t *ids, id_map *m, int *twice)
{
    status st = OK;
    bool sorted = true;
    TRY(TAKE(m->sorted, (size_t)count));
    for (int i = 0; i < count; i++) {
        m->sorted[i] = (id_pair){.id = ids[i], .index = i};
        sorted = sorted && (i == 0 || ids[i] > ids[i - 1]);
    }
    if (!sorted) {
        qsort(m->sorted, (size_t)count, sizeof *m->sorted, pair_order);
    }
    *twice = -1;
    for (int i = 1; i < count && *twice < 0; i++) {
        *twice = m->sorted[i].id == m->sorted[i - 1].id ? m->sorted[i].index : -1;
    }

done:
    return st;
}

// a table costs one look per question; it may be a few times longer than the list
static status make_table(id_map *m)
{
    status st = OK;
    if (m->count == 0) {
        return OK;
    }
    m->least = m->sorted[0].id;
    const uint64_t range = (uint64_t)m->sorted[m->count - 1].id - (uint64_t)m->least;
    if (range >= 4 * (uint64_t)m->count + 1000) {
        return OK;
    }
    m->ntable = (int)range + 1;
    TRY(TAKE(m->table, (size_t)m->ntable));
    memset(m->table, 0xff, (size_t)m->ntable * sizeof *m->table);
    for (int i = 0; i < m->count; i++) {
        m->table[m->sorted[i].id - m->least] = m->sorted[i].index;
    }

done:
    return st;
}

status id_map_make(int count, const int64_t *ids, id_map *out, int *twice)
{
    status st = OK;
    id_map m = {.count = count};
    TRY(sort_pairs(count, ids, &m, twice));
    TRY(make_table(&m));
    *out = m;
    m = (id_map){0};

done:
    id_map_free(&m);
    return st;
}

int id_map_find(const id_map *m, int64_t id)
{
    if (m->table) {
        const uint64_t at = (uint64_t)id - (uint64_t)m->least;
        return at < (uint64_t)m->ntable ? m->table[at] : -1;
    }
    int low = 0, high = m->count;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (m->sorted[middle].id < id) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low < m->count && m->sorted[low].id == id ? m->sorted[low].index : -1;
}
