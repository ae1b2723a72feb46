// reach/surface_flat.c
// A triangle with three corners on one line has no normal, and hides from one another the two
// triangles that truly meet there. Turning its longest edge joins its middle corner to the triangle
// beyond; edges get shorter each time, so this ends.
#include "reach/surface_inside.h"

#include "base/memory.h"
#include "reach/triangle.h"

enum { MOST_PASSES = 100 };

// the edge that its third corner lies on within `near`, or -1
static int flat_edge(const surface *s, int t, double near)
{
    vec3 corner[3];
    double longest = 0;
    int edge = 0;
    surface_corners(s, t, corner);
    for (int k = 0; k < 3; k++) {
        const double length = vec3_norm(vec3_sub(corner[(k + 1) % 3], corner[k]));
        edge = length > longest ? k : edge;
        longest = length > longest ? length : longest;
    }
    return vec3_norm(triangle_normal(corner)) <= near * longest ? edge : -1;
}

// whether an edge joins the vertex at corner k of t to vertex v
static bool is_joined(const surface *s, int t, int k, int v)
{
    int at = t, corner = k;
    do {
        if (s->triangle[at][(corner + 1) % 3] == v) {
            return true;
        }
        const int next = s->across[at][corner];
        at = next / 3;
        corner = (next % 3 + 1) % 3;
    } while (at != t);
    return false;
}

static void meet(surface *s, int side, int other)
{
    s->across[side / 3][side % 3] = other;
    s->across[other / 3][other % 3] = side;
}

// (a b c) and (b a d), which share a b, become (a d c) and (b c d)
static void flip(surface *s, int t, int k)
{
    const int u = s->across[t][k] / 3, j = s->across[t][k] % 3;
    const int a = s->triangle[t][k], b = s->triangle[u][j];
    const int c = s->triangle[t][(k + 2) % 3], d = s->triangle[u][(j + 2) % 3];
    int beyond[4] = {s->across[u][(j + 1) % 3], s->across[t][(k + 2) % 3],
                     s->across[t][(k + 1) % 3], s->across[u][(j + 2) % 3]};
    const int now[4] = {3 * t, 3 * t + 2, 3 * u, 3 * u + 2};
    const int was[4] = {3 * u + (j + 1) % 3, 3 * t + (k + 2) % 3, 3 * t + (k + 1) % 3,
                        3 * u + (j + 2) % 3};
    // a side of the four may lie across another of them
    for (int i = 0; i < 4; i++) {
        for (int m = 0; m < 4; m++) {
            if (beyond[i] == was[m]) {
                beyond[i] = now[m];
                break;
            }
        }
    }
    const int first[3] = {a, d, c}, second[3] = {b, c, d};
    for (int i = 0; i < 3; i++) {
        s->triangle[t][i] = first[i];
        s->triangle[u][i] = second[i];
    }
    meet(s, 3 * t + 1, 3 * u + 1);
    for (int i = 0; i < 4; i++) {
        meet(s, now[i], beyond[i]);
    }
}

status surface_flip_flat(surface_work *w)
{
    surface *s = &w->s;
    int before = -1;
    for (int pass = 0; pass < MOST_PASSES && before != w->report->flipped; pass++) {
        before = w->report->flipped;
        for (int t = 0; t < s->ntriangle; t++) {
            const int k = flat_edge(s, t, w->report->merge);
            const int other = k < 0 ? -1 : s->across[t][k];
            // an edge that is there already would have four triangles
            if (k >= 0 &&
                !is_joined(s, t, (k + 2) % 3, s->triangle[other / 3][(other % 3 + 2) % 3])) {
                flip(s, t, k);
                w->report->flipped++;
            }
        }
    }
    return OK;
}
