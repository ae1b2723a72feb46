// reach/surface_nest.c
// A piece that lies within an odd number of others bounds an island: outward from what is enclosed
// is into it.
#include "reach/surface_inside.h"

#include "reach/triangle.h"

#include <math.h>

static const double PI = 3.14159265358979323846;

typedef struct piece {
    double low[3], high[3];
    int vertex; // one of its
} piece;

static void find_pieces(const surface_work *w, piece *pieces)
{
    const surface *s = &w->s;
    for (int p = 0; p < w->report->parts; p++) {
        pieces[p] = (piece){.low = {INFINITY, INFINITY, INFINITY},
                            .high = {-INFINITY, -INFINITY, -INFINITY}};
    }
    for (int i = 0; i < 3 * s->ntriangle; i++) {
        piece *p = &pieces[w->part[i / 3]];
        p->vertex = s->triangle[i / 3][i % 3];
        for (int d = 0; d < 3; d++) {
            p->low[d] = fmin(p->low[d], s->vertex[p->vertex][d]);
            p->high[d] = fmax(p->high[d], s->vertex[p->vertex][d]);
        }
    }
}

// by how often a piece winds round a point that is not on it
static bool is_within(const surface_work *w, int part, const piece *box, vec3 p)
{
    double angle = 0;
    for (int d = 0; d < 3; d++) {
        if (p.a[d] <= box->low[d] || p.a[d] >= box->high[d]) {
            return false;
        }
    }
    for (int t = 0; t < w->s.ntriangle; t++) {
        vec3 corner[3];
        if (w->part[t] == part) {
            surface_corners(&w->s, t, corner);
            angle += triangle_solid_angle(corner, p);
        }
    }
    return fabs(angle) > 2 * PI;
}

status surface_nest(surface_work *w)
{
    surface *s = &w->s;
    piece pieces[SURFACE_MOST_PARTS];
    bool island[SURFACE_MOST_PARTS] = {false};
    const int n = w->report->parts;
    find_pieces(w, pieces);
    for (int p = 0; p < n; p++) {
        for (int q = 0; q < n; q++) {
            const vec3 at = surface_vertex(s, pieces[p].vertex);
            island[p] ^= p != q && is_within(w, q, &pieces[q], at);
        }
        w->report->inner += island[p];
    }
    for (int t = 0; t < s->ntriangle; t++) {
        if (island[w->part[t]]) {
            surface_turn(s, t);
        }
    }
    return OK;
}
