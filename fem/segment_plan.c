// fem/segment_plan.c
#include "fem/segment_plan.h"

#include "base/memory.h"

#include <math.h>

void segment_plan_free(segment_plan *p)
{
    free(p->layer);
    *p = (segment_plan){0};
}

// --- a mesh as the case gives it: one order less below it

// the two rungs of such a case
enum { LOWER, GIVEN };

static bool is_given(const segment_case *c)
{
    return c->order > 0 || c->layers > 0 || c->grading > 0 || c->size > 0;
}

// layers grow by the same factor from both ends to the middle, where they are `grading` times the
// ends'
static void fill_graded(const segment_case *c, double *layer)
{
    const int n = c->layers, most = (n - 1) / 2;
    double total = 0;
    for (int pass = 0; pass < 2; pass++) {
        double z = 0;
        for (int i = 0; i < n; i++) {
            const int step = i < n - 1 - i ? i : n - 1 - i;
            layer[i] = pass ? z * c->length / total : 0;
            z += most ? pow(c->grading, (double)step / most) : 1;
        }
        total = z;
    }
    layer[n] = c->length;
}

static status plan_given(const segment_case *given, double radius, int rung, segment_plan *out)
{
    status st = OK;
    const segment_case c = segment_choose(given, radius);
    const int order = rung == GIVEN ? c.order : c.order - 1;
    *out = (segment_plan){.mesh = {.order = order, .size = c.size}, .order = order};
    out->nlayer = c.layers;
    TRY(TAKE(out->layer, (size_t)c.layers + 1));
    fill_graded(&c, out->layer);

done:
    return st;
}

segment_climb segment_climb_of(const segment_case *c, const segment_source *source)
{
    (void)source;
    if (is_given(c)) {
        return (segment_climb){c->order == 1 ? GIVEN : LOWER, GIVEN};
    }
    return (segment_climb){0, 1};
}

static status plan_rung(const segment_case *c, double radius, int rung, segment_plan *out)
{
    static const int order[6] = {2, 3, 3, 4, 4, 4}, edge[6] = {0, 0, 1, 2, 3, 4};
    status st = OK;
    segment_case with = *c;
    with.order = order[rung];
    with.layers = 0;
    with.size = 0.5 * radius;
    TRY(plan_given(&with, radius, GIVEN, out));
    out->mesh.edge_layers = edge[rung];

done:
    return st;
}

status segment_plan_make(const segment_case *c, const segment_source *source, int rung,
                         segment_plan *out)
{
    return is_given(c) ? plan_given(c, source->radius, rung, out)
                       : plan_rung(c, source->radius, rung, out);
}

double segment_plan_factor(const segment_case *c, const segment_source *source, int rung)
{
    (void)c;
    (void)source;
    (void)rung;
    return 1;
}
