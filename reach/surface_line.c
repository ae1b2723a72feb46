// reach/surface_line.c
// Seen along the line, vertices are points of a plane and the line is its origin, which lies within
// a triangle where a half-line from it crosses one of the triangle's edges. What decides that is
// reckoned for an edge in one manner for both its triangles, so that none slips through between.
#include "reach/surface_line.h"

#include "base/memory.h"

#include <math.h>

// a vertex as seen along the line
typedef struct seen {
    double x, y, z;
} seen;

static vec3 across_of(vec3 d)
{
    int least = 0;
    for (int k = 1; k < 3; k++) {
        least = fabs(d.a[k]) < fabs(d.a[least]) ? k : least;
    }
    vec3 axis = {{0}};
    axis.a[least] = 1;
    const vec3 u = vec3_cross(d, axis);
    return vec3_scale(1 / vec3_norm(u), u);
}

static void see(const surface *s, vec3 p, vec3 d, seen *out)
{
    const vec3 u = across_of(d), v = vec3_cross(d, u);
    for (int i = 0; i < s->nvertex; i++) {
        const vec3 to = vec3_sub(surface_vertex(s, i), p);
        out[i] = (seen){vec3_dot(to, u), vec3_dot(to, v), vec3_dot(to, d)};
    }
}

// whether the half-line x > 0 crosses the edge between two vertices
static bool edge_counts(const seen *seen_by, int i, int j)
{
    const seen *a = &seen_by[i < j ? i : j], *b = &seen_by[i < j ? j : i];
    if ((a->y > 0) == (b->y > 0)) {
        return false;
    }
    return a->x - a->y * (b->x - a->x) / (b->y - a->y) > 0;
}

// how far along the line meets a triangle that it passes: by the shares of the corners
static double place_along(const seen *a, const seen *b, const seen *c)
{
    const double wa = b->x * c->y - b->y * c->x, wb = c->x * a->y - c->y * a->x,
                 wc = a->x * b->y - a->y * b->x;
    const double sum = wa + wb + wc, z = (wa * a->z + wb * b->z + wc * c->z) / sum;
    const double low = fmin(a->z, fmin(b->z, c->z)), high = fmax(a->z, fmax(b->z, c->z));
    // edge on, nothing but its ends is sure
    return sum != 0 ? fmin(high, fmax(low, z)) : low;
}

static int compare(const void *x, const void *y)
{
    const surface_passage *a = x, *b = y;
    return (a->along > b->along) - (a->along < b->along);
}

status surface_line(const surface *s, vec3 p, vec3 direction, surface_passage **out, int *n)
{
    status st = OK;
    seen *v = NULL;
    surface_passage *list = NULL;
    int count = 0;
    *n = 0;
    TRY(TAKE(v, (size_t)s->nvertex));
    TRY(TAKE(list, (size_t)s->ntriangle));
    see(s, p, vec3_scale(1 / vec3_norm(direction), direction), v);
    for (int t = 0; t < s->ntriangle; t++) {
        const int *c = s->triangle[t];
        if (edge_counts(v, c[0], c[1]) ^ edge_counts(v, c[1], c[2]) ^ edge_counts(v, c[2], c[0])) {
            list[count++] = (surface_passage){.along = place_along(&v[c[0]], &v[c[1]], &v[c[2]]),
                                              .triangle = t};
        }
    }
    qsort(list, (size_t)count, sizeof *list, compare);
    for (int i = 0; i < count; i++) {
        list[i].inward = i % 2 == 0;
    }
    *out = list;
    *n = count;
    list = NULL;

done:
    free(v);
    free(list);
    return st;
}
