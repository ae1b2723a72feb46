// reach/surface_orient.c
// Triangles that share an edge run along it in opposite senses; then each piece's volume tells
// which sense is outward.
#include "reach/surface_inside.h"

#include "base/memory.h"
#include "reach/triangle.h"

#include <math.h>

// volume over area^1.5: 0.09 for a sphere, 0.35 t / L for a slab; rounding leaves some 1e-16
static const double NOTHING = 1e-9;

double surface_part_volume(const surface_work *w, int part)
{
    double volume = 0, area = 0;
    int first = -1;
    for (int t = 0; t < w->s.ntriangle; t++) {
        vec3 corner[3];
        if (w->part[t] != part) {
            continue;
        }
        first = first < 0 ? t : first;
        surface_corners(&w->s, t, corner);
        const vec3 n = triangle_normal(corner);
        const vec3 o = surface_vertex(&w->s, w->s.triangle[first][0]);
        volume += vec3_dot(vec3_sub(corner[0], o), n) / 6;
        area += 0.5 * vec3_norm(n);
    }
    return fabs(volume) > NOTHING * area * sqrt(area) ? volume : 0;
}

// whether t and the triangle across its edge k run along it in one sense
static bool runs_alike(const surface *s, int t, int k)
{
    const int other = s->across[t][k];
    return s->triangle[t][k] == s->triangle[other / 3][other % 3];
}

// the piece of triangle `first`; stack [ntriangle]
static status walk_part(surface_work *w, int first, int part, int *stack, bool *turned)
{
    surface *s = &w->s;
    int n = 0;
    stack[n++] = first;
    w->part[first] = part;
    while (n > 0) {
        const int t = stack[--n];
        for (int k = 0; k < 3; k++) {
            const int u = s->across[t][k] / 3;
            if (w->part[u] < 0) {
                if (runs_alike(s, t, k)) {
                    surface_turn(s, u);
                    turned[u] = true;
                }
                w->part[u] = part;
                stack[n++] = u;
            } else if (runs_alike(s, t, k)) {
                return surface_fail(w, s->vertex[s->triangle[t][k]],
                                    "it has no inside: its triangles cannot be turned alike");
            }
        }
    }
    return OK;
}

// how many triangles follow one another round a vertex, from triangle t's corner k on
static int fan_length(const surface *s, int t, int k)
{
    int n = 0, at = t, corner = k;
    do {
        const int next = s->across[at][corner];
        at = next / 3;
        corner = (next % 3 + 1) % 3;
        n++;
    } while (at != t && n <= s->ntriangle);
    return n;
}

// a vertex has one fan of triangles about it
static status check_fans(const surface_work *w)
{
    status st = OK;
    const surface *s = &w->s;
    int *count = NULL, bad = 0, where = 0;
    TRY(TAKE(count, (size_t)s->nvertex));
    for (int i = 0; i < 3 * s->ntriangle; i++) {
        count[s->triangle[i / 3][i % 3]]++;
    }
    for (int i = 0; i < 3 * s->ntriangle; i++) {
        const int v = s->triangle[i / 3][i % 3];
        if (count[v] > 0 && fan_length(s, i / 3, i % 3) != count[v]) {
            bad++;
            where = v;
        }
        count[v] = 0;
    }
    if (bad > 0) {
        TRY(surface_fail(w, s->vertex[where], "sheets touch at %d vertices", bad));
    }

done:
    free(count);
    return st;
}

static status make_outward(surface_work *w, bool *turned)
{
    surface *s = &w->s;
    bool inward[SURFACE_MOST_PARTS];
    for (int p = 0; p < w->report->parts; p++) {
        const double volume = surface_part_volume(w, p);
        inward[p] = volume < 0;
        for (int t = 0; volume == 0; t++) {
            if (w->part[t] == p) {
                return surface_fail(w, s->vertex[s->triangle[t][0]], "a piece encloses nothing");
            }
        }
    }
    for (int t = 0; t < s->ntriangle; t++) {
        if (inward[w->part[t]]) {
            surface_turn(s, t);
            turned[t] = !turned[t];
        }
        w->report->turned += turned[t];
    }
    return OK;
}

status surface_orient(surface_work *w)
{
    status st = OK;
    const surface *s = &w->s;
    int *stack = NULL;
    bool *turned = NULL;
    TRY(TAKE(stack, (size_t)s->ntriangle));
    TRY(TAKE(turned, (size_t)s->ntriangle));
    TRY(TAKE(w->part, (size_t)s->ntriangle));
    for (int t = 0; t < s->ntriangle; t++) {
        w->part[t] = -1;
    }
    for (int t = 0; t < s->ntriangle; t++) {
        if (w->part[t] < 0 && w->report->parts == SURFACE_MOST_PARTS) {
            TRY(surface_fail(w, s->vertex[s->triangle[t][0]],
                             "more than %d pieces: are there specks", SURFACE_MOST_PARTS));
        }
        if (w->part[t] < 0) {
            TRY(walk_part(w, t, w->report->parts++, stack, turned));
        }
    }
    TRY(check_fans(w));
    TRY(make_outward(w, turned));

done:
    free(stack);
    free(turned);
    return st;
}
