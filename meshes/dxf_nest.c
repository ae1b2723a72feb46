// meshes/dxf_nest.c
#include "base/memory.h"
#include "meshes/dxf.h"
#include "meshes/loops.h"

#include <math.h>
#include <stdio.h>

// what gmsh follows within its time
enum { MOST_OUTLINES = 2000 };

typedef struct nested {
    int loop, depth; // loops of its layer around it
    int parent;      // the smallest of them, -1 where there is none
    double area;
} nested;

static curve_loop curves_of(const dxf_loop *l)
{
    return (curve_loop){.n = l->n, .piece = l->piece};
}

// Loops of one layer do not touch: one point tells.
static bool lies_in(const dxf_loop *inner, const dxf_loop *outer)
{
    double x[2];
    carrier_start(&inner->piece[0], x);
    return inner->layer == outer->layer && inner->area < outer->area &&
           curves_contain(curves_of(outer), x[0], x[1]);
}

static void find_nest(const dxf_loops *l, nested *n)
{
    for (int i = 0; i < l->count; i++) {
        n[i] = (nested){.loop = i, .parent = -1, .area = l->loop[i].area};
        for (int j = 0; j < l->count; j++) {
            if (j != i && lies_in(&l->loop[i], &l->loop[j])) {
                n[i].depth++;
                const int p = n[i].parent;
                n[i].parent = p < 0 || l->loop[j].area < l->loop[p].area ? j : p;
            }
        }
    }
}

// the larger first; of equal ones the first drawn
static int by_area(const void *a, const void *b)
{
    const nested *x = a, *y = b;
    if (x->area != y->area) {
        return x->area > y->area ? -1 : 1;
    }
    return (x->loop > y->loop) - (x->loop < y->loop);
}

static void put_loop(const dxf_loop *l, double unit, outline *o)
{
    int *end = &o->loop_start[++o->nloop];
    *end = o->loop_start[o->nloop - 1];
    for (int i = 0; i < l->n; i++) {
        o->piece[(*end)++] = carrier_scaled(&l->piece[i], unit);
    }
}

// an outer loop and the holes in it
static status put_outline(const dxf_plan *p, const dxf_loops *l, const nested *n, int outer,
                          double unit, outline *o)
{
    status st = OK;
    const dxf_loop *own = &l->loop[n[outer].loop];
    size_t nloop = 1, npiece = (size_t)own->n;
    for (int i = 0; i < l->count; i++) {
        const bool hole = n[i].parent == n[outer].loop && n[i].depth == n[outer].depth + 1;
        nloop += hole;
        npiece += hole ? (size_t)l->loop[n[i].loop].n : 0;
    }
    o->kind = KIND_LOOPS;
    o->thickness = INFINITY; // curves were compared with one another
    (void)snprintf(o->called, sizeof o->called, "layer '%.24s' (line %ld)", p->layer[own->layer],
                   own->line[0]);
    TRY(TAKE(o->loop_start, nloop + 1));
    TRY(TAKE(o->piece, npiece));
    put_loop(own, unit, o);
    for (int i = 0; i < l->count; i++) {
        if (n[i].parent == n[outer].loop && n[i].depth == n[outer].depth + 1) {
            put_loop(&l->loop[n[i].loop], unit, o);
        }
    }

done:
    return st;
}

status dxf_nest(const dxf_plan *p, const dxf_loops *l, const int *material, double unit, mark at,
                section_outline *out)
{
    status st = OK;
    section_outline o = {0};
    nested *n = NULL;
    int count = 0;
    TRY(TAKE(n, (size_t)l->count));
    find_nest(l, n);
    qsort(n, (size_t)l->count, sizeof *n, by_area);
    for (int i = 0; i < l->count; i++) {
        count += n[i].depth % 2 == 0;
    }
    if (count > MOST_OUTLINES) {
        TRY(status_fail_at(ERR_INPUT, at.line, at.column, "the drawing has more than %d outlines",
                           MOST_OUTLINES));
    }
    TRY(TAKE(o.items, (size_t)count));
    for (int i = 0; i < l->count; i++) {
        if (n[i].depth % 2 == 0) {
            outline *item = &o.items[o.count++];
            item->at = at;
            item->material = material[l->loop[n[i].loop].layer];
            TRY(put_outline(p, l, n, i, unit, item));
        }
    }
    TRY(section_outline_measure(&o));
    *out = o;
    o = (section_outline){0};

done:
    free(n);
    section_outline_free(&o);
    return st;
}
