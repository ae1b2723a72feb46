// measure/tube_grid.c
#include "measure/tube_inside.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

enum { AXIS_BITS = 21, DIGIT_BITS = 11, DIGITS = 1 << DIGIT_BITS };

static const double half_range = 1 << (AXIS_BITS - 1);

typedef struct keyed {
    uint64_t key;
    uint32_t at;
} keyed;

static uint64_t key_of(const long cell[3])
{
    uint64_t key = 0;
    for (int d = 0; d < 3; d++) {
        key = key << AXIS_BITS | (uint64_t)(cell[d] + (1 << (AXIS_BITS - 1)));
    }
    return key;
}

// false for what is no number or too far
static bool cell_of(const double p[3], vec3 origin, double size, long cell[3])
{
    for (int d = 0; d < 3; d++) {
        const double x = floor((p[d] - origin.a[d]) / size);
        if (!(fabs(x) < half_range - 1)) {
            return false;
        }
        cell[d] = (long)x;
    }
    return true;
}

// digit by digit, the last one first; in one of the two, the other is work
static keyed *sorted(keyed *a, keyed *b, size_t n)
{
    for (int shift = 0; shift < 3 * AXIS_BITS; shift += DIGIT_BITS) {
        size_t begin[DIGITS + 1] = {0};
        for (size_t i = 0; i < n; i++) {
            begin[(a[i].key >> shift & (DIGITS - 1)) + 1]++;
        }
        for (int d = 0; d < DIGITS; d++) {
            begin[d + 1] += begin[d];
        }
        for (size_t i = 0; i < n; i++) {
            b[begin[a[i].key >> shift & (DIGITS - 1)]++] = a[i];
        }
        keyed *other = a;
        a = b;
        b = other;
    }
    return a;
}

static status fill(const point_cloud *cloud, const keyed *order, tube_grid *g)
{
    status st = OK;
    size_t ncell = 0;
    for (size_t i = 0; i < g->count; i++) {
        ncell += i == 0 || order[i].key != order[i - 1].key;
    }
    TRY(TAKE(g->p, g->count));
    TRY(TAKE(g->key, ncell));
    TRY(TAKE(g->first, ncell + 1));
    for (size_t i = 0; i < g->count; i++) {
        if (i == 0 || order[i].key != order[i - 1].key) {
            g->key[g->ncell] = order[i].key;
            g->first[g->ncell++] = (uint32_t)i;
        }
        memcpy(g->p[i], cloud->p[order[i].at], sizeof g->p[i]);
    }
    g->first[g->ncell] = (uint32_t)g->count;

done:
    return st;
}

status tube_grid_make(const point_cloud *cloud, vec3 origin, double cell, tube_grid *out)
{
    status st = OK;
    tube_grid g = {.cell = cell, .origin = origin};
    keyed *a = NULL, *b = NULL;
    TRY(TAKE(a, cloud->count));
    TRY(TAKE(b, cloud->count));
    for (size_t i = 0; i < cloud->count; i++) {
        long at[3];
        if (cell_of(cloud->p[i], origin, cell, at)) {
            a[g.count++] = (keyed){key_of(at), (uint32_t)i};
        }
    }
    TRY(fill(cloud, sorted(a, b, g.count), &g));
    *out = g;
    g = (tube_grid){0};

done:
    free(a);
    free(b);
    tube_grid_free(&g);
    return st;
}

void tube_grid_free(tube_grid *g)
{
    free(g->p);
    free(g->key);
    free(g->first);
    *g = (tube_grid){0};
}

// the first cell whose key is not below
static size_t lower_cell(const tube_grid *g, uint64_t key)
{
    size_t low = 0, high = g->ncell;
    while (low < high) {
        const size_t middle = (low + high) / 2;
        if (g->key[middle] < key) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

// cells that follow one another along z have keys that do
static size_t column_near(const tube_grid *g, const long from[3], long to_z, vec3 c, double reach,
                          uint32_t *out, size_t room)
{
    size_t n = 0;
    const uint64_t last = key_of((long[3]){from[0], from[1], to_z});
    for (size_t i = lower_cell(g, key_of(from)); i < g->ncell && g->key[i] <= last; i++) {
        for (uint32_t k = g->first[i]; k < g->first[i + 1]; k++) {
            const double x = g->p[k][0] - c.a[0], y = g->p[k][1] - c.a[1], z = g->p[k][2] - c.a[2];
            if (x * x + y * y + z * z < reach * reach && n < room) {
                out[n++] = k;
            }
        }
    }
    return n;
}

size_t tube_grid_near(const tube_grid *g, vec3 c, double reach, uint32_t *out, size_t room)
{
    long low[3] = {0}, high[3] = {0};
    size_t n = 0;
    const double corner[2][3] = {{c.a[0] - reach, c.a[1] - reach, c.a[2] - reach},
                                 {c.a[0] + reach, c.a[1] + reach, c.a[2] + reach}};
    if (!cell_of(corner[0], g->origin, g->cell, low) ||
        !cell_of(corner[1], g->origin, g->cell, high)) {
        return 0;
    }
    for (long x = low[0]; x <= high[0]; x++) {
        for (long y = low[1]; y <= high[1]; y++) {
            const long from[3] = {x, y, low[2]};
            n += column_near(g, from, high[2], c, reach, out + n, room - n);
        }
    }
    return n;
}
