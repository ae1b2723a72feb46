// reports/segment_skin.c
#include "reports/segment_skin.h"

#include "base/memory.h"
#include "reports/segment_surface_parts.h"

#include <math.h>
#include <stdlib.h>

enum { SKIN_AROUND = 44, SKIN_ALONG = 24 };

// corners that lie this much of the radius apart are one
static const double together = 1e-5;

// a facet's corner, with what tells whether two are the same
typedef struct skin_corner {
    long key[5]; // part, material, place in steps
    surface_point point;
    int index; // of the corner as it was added
} skin_corner;

typedef struct skin_maker {
    int ncorner, corner_room, nfacet, facet_room;
    skin_corner *corner;
    int (*facet)[4]; // corners; the last one -1 in a triangle
    double step;
} skin_maker;

static status more_room(skin_maker *k)
{
    status st = OK;
    if (k->ncorner + 4 > k->corner_room) {
        const int room = k->corner_room > 0 ? 2 * k->corner_room : 8192;
        skin_corner *more = realloc(k->corner, (size_t)room * sizeof *more);
        if (!more) {
            TRY(status_fail(ERR_RESOURCE, "out of memory for the view of the segment"));
        }
        k->corner = more;
        k->corner_room = room;
    }
    if (k->nfacet == k->facet_room) {
        const int room = k->facet_room > 0 ? 2 * k->facet_room : 2048;
        int(*more)[4] = realloc(k->facet, (size_t)room * sizeof *more);
        if (!more) {
            TRY(status_fail(ERR_RESOURCE, "out of memory for the view of the segment"));
        }
        k->facet = more;
        k->facet_room = room;
    }

done:
    return st;
}

static status take_facet(surface_maker *m, int n, const surface_point *const *corner)
{
    status st = OK;
    skin_maker *k = m->taker;
    TRY(more_room(k));
    int *facet = k->facet[k->nfacet++];
    facet[3] = -1;
    for (int i = 0; i < n; i++) {
        skin_corner *c = &k->corner[k->ncorner];
        *c = (skin_corner){.key = {m->part, m->material}, .point = *corner[i], .index = k->ncorner};
        for (int d = 0; d < 3; d++) {
            c->key[2 + d] = lround(corner[i]->rest.a[d] / k->step);
        }
        facet[i] = k->ncorner++;
    }

done:
    return st;
}

static int by_key(const void *a, const void *b)
{
    const skin_corner *p = a, *q = b;
    for (int i = 0; i < 5; i++) {
        if (p->key[i] != q->key[i]) {
            return p->key[i] < q->key[i] ? -1 : 1;
        }
    }
    return (p->index > q->index) - (p->index < q->index);
}

static bool same(const skin_corner *a, const skin_corner *b)
{
    for (int i = 0; i < 5; i++) {
        if (a->key[i] != b->key[i]) {
            return false;
        }
    }
    return true;
}

static void put_vertex(segment_skin *s, const skin_corner *c)
{
    for (int d = 0; d < 3; d++) {
        s->at[s->nvertex][d] = c->point.rest.a[d];
        s->move[s->nvertex][d] = c->point.move.a[d];
    }
    s->value[s->nvertex] = c->point.value;
    s->material[s->nvertex] = (unsigned char)(c->key[1] & 255);
    s->nvertex++;
}

// a triangle without area says nothing, as a wedge's side has
static void put_triangle(segment_skin *s, int a, int b, int c)
{
    if (a != b && b != c && c != a) {
        int *t = s->triangle[s->ntriangle++];
        t[0] = a;
        t[1] = b;
        t[2] = c;
    }
}

static status weld(skin_maker *k, segment_skin *out)
{
    status st = OK;
    int *vertex = NULL;
    segment_skin s = {0};
    const size_t n = (size_t)k->ncorner;
    TRY(TAKE(vertex, n));
    TRY(TAKE(s.at, n));
    TRY(TAKE(s.move, n));
    TRY(TAKE(s.value, n));
    TRY(TAKE(s.material, n));
    TRY(TAKE(s.triangle, 2 * (size_t)k->nfacet));
    qsort(k->corner, n, sizeof *k->corner, by_key);
    for (int i = 0; i < k->ncorner; i++) {
        if (i == 0 || !same(&k->corner[i - 1], &k->corner[i])) {
            put_vertex(&s, &k->corner[i]);
        }
        vertex[k->corner[i].index] = s.nvertex - 1;
    }
    for (int i = 0; i < k->nfacet; i++) {
        const int *f = k->facet[i];
        put_triangle(&s, vertex[f[0]], vertex[f[1]], vertex[f[2]]);
        if (f[3] >= 0) {
            put_triangle(&s, vertex[f[0]], vertex[f[2]], vertex[f[3]]);
        }
    }
    *out = s;
    s = (segment_skin){0};

done:
    free(vertex);
    segment_skin_free(&s);
    return st;
}

status segment_skin_make(const segment_body *body, const segment_load_result *load,
                         segment_skin *out)
{
    status st = OK;
    skin_maker k = {0};
    surface_maker m = {
        .body = body,
        .load = load,
        .value = SURFACE_DISPLACEMENT,
        .radius = surface_radius(body),
        .wanted_around = SKIN_AROUND,
        .wanted_along = SKIN_ALONG,
        .below = true,
        .take = take_facet,
        .taker = &k,
    };
    if (body->nlevel < 2 || body->first != 0 || body->last != body->nlevel || !load->displacement) {
        TRY(status_fail(ERR_BUG, "segment_skin: the segment is not all here"));
    }
    k.step = fmax(together * m.radius, 1e-300);
    TRY(surface_add_all(&m));
    TRY(weld(&k, out));

done:
    free(k.corner);
    free(k.facet);
    return st;
}

void segment_skin_free(segment_skin *s)
{
    free(s->at);
    free(s->move);
    free(s->value);
    free(s->material);
    free(s->triangle);
    *s = (segment_skin){0};
}
