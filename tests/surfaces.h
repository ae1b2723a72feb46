// tests/surfaces.h
// Closed surfaces of triangles, made from formulas.
#pragma once

#include "reach/surface.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct made_surface {
    int n, room;
    double (*corner)[3][3];
} made_surface;

static inline void made_free(made_surface *m)
{
    free(m->corner);
    *m = (made_surface){0};
}

static inline void made_triangle(made_surface *m, vec3 a, vec3 b, vec3 c)
{
    if (m->n == m->room) {
        m->room = m->room ? 2 * m->room : 256;
        m->corner = realloc(m->corner, (size_t)m->room * sizeof *m->corner);
        if (!m->corner) {
            abort();
        }
    }
    memcpy(m->corner[m->n][0], a.a, sizeof a.a);
    memcpy(m->corner[m->n][1], b.a, sizeof b.a);
    memcpy(m->corner[m->n][2], c.a, sizeof c.a);
    m->n++;
}

// A point for each direction: a surface about the origin.
typedef vec3 made_shape(vec3 direction);

static inline vec3 made_direction(const vec3 face[3], int m, int i, int j)
{
    vec3 v = vec3_scale((double)(m - i - j) / m, face[0]);
    v = vec3_add_scaled(v, (double)i / m, face[1]);
    v = vec3_add_scaled(v, (double)j / m, face[2]);
    return vec3_scale(1 / vec3_norm(v), v);
}

// 8 m^2 triangles: an octahedron whose faces are cut into m^2 each.
static inline void made_ball(made_surface *out, int m, made_shape *shape)
{
    for (int f = 0; f < 8; f++) {
        const double x = f & 1 ? -1 : 1, y = f & 2 ? -1 : 1, z = f & 4 ? -1 : 1;
        vec3 face[3] = {{{x, 0, 0}}, {{0, y, 0}}, {{0, 0, z}}};
        if (x * y * z < 0) {
            const vec3 swap = face[1];
            face[1] = face[2];
            face[2] = swap;
        }
        for (int i = 0; i < m; i++) {
            for (int j = 0; j < m - i; j++) {
                const vec3 a = shape(made_direction(face, m, i, j));
                const vec3 b = shape(made_direction(face, m, i + 1, j));
                const vec3 c = shape(made_direction(face, m, i, j + 1));
                made_triangle(out, a, b, c);
                if (i + j < m - 1) {
                    made_triangle(out, b, shape(made_direction(face, m, i + 1, j + 1)), c);
                }
            }
        }
    }
}

// Two triangles a side, outward.
static inline void made_box(made_surface *out, vec3 low, vec3 high)
{
    for (int d = 0; d < 3; d++) {
        for (int end = 0; end < 2; end++) {
            vec3 p[4];
            for (int k = 0; k < 4; k++) {
                p[k] = low;
                p[k].a[d] = end ? high.a[d] : low.a[d];
                const int u = (d + 1) % 3, v = (d + 2) % 3;
                p[k].a[u] = k == 1 || k == 2 ? high.a[u] : low.a[u];
                p[k].a[v] = k >= 2 ? high.a[v] : low.a[v];
            }
            made_triangle(out, p[0], p[end ? 1 : 2], p[end ? 2 : 1]);
            made_triangle(out, p[0], p[end ? 2 : 3], p[end ? 3 : 2]);
        }
    }
}

// one triangle less
static inline void made_take_out(made_surface *m, int i)
{
    m->n--;
    memmove(m->corner[i], m->corner[i + 1], (size_t)(m->n - i) * sizeof *m->corner);
}

// the other sense
static inline void made_turn(made_surface *m, int i)
{
    double swap[3];
    memcpy(swap, m->corner[i][1], sizeof swap);
    memcpy(m->corner[i][1], m->corner[i][2], sizeof swap);
    memcpy(m->corner[i][2], swap, sizeof swap);
}

static inline status made_closed(const made_surface *m, surface *out, surface_report *report)
{
    const surface_options options = {.path = "wall.stl"};
    return surface_make(m->n, (const double(*)[3][3])m->corner, &options, out, report);
}

// a radius of 50 mm
static inline vec3 made_round(vec3 u)
{
    return vec3_scale(50e-3, u);
}

// hills and hollows
static inline vec3 made_bumpy(vec3 u)
{
    const double x = u.a[0], y = u.a[1], z = u.a[2];
    return vec3_scale(40e-3 * (1 + 0.35 * sin(5 * x) * cos(7 * y) + 0.2 * sin(9 * z + 3 * x)), u);
}
