// fem/segment_plan.c
#include "fem/segment_plan.h"

#include "base/memory.h"
#include "fem/rungs.h"

#include <math.h>
#include <string.h>

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

// --- the ladder

// the estimates that rungs usually end with, on Fig. 4's segment: where a climb begins
static const double USUAL_ESTIMATE[RUNG_COUNT] = {1, 2e-4, 4e-5, 1.5e-5, 4e-6, 1e-6};

static int likely_rung(double tolerance)
{
    int rung = 1;
    while (rung < RUNG_COUNT - 1 && USUAL_ESTIMATE[rung] > tolerance) {
        rung++;
    }
    return rung;
}

segment_climb segment_climb_of(const segment_case *c)
{
    if (is_given(c)) {
        return (segment_climb){c->order == 1 ? GIVEN : LOWER, GIVEN};
    }
    return c->tolerance > 0 ? (segment_climb){likely_rung(c->tolerance) - 1, RUNG_COUNT - 1}
                            : (segment_climb){0, 1};
}

static status plan_rung(const segment_case *c, const segment_source *source, int rung,
                        segment_plan *out)
{
    const segment_rung r = segment_rung_of(rung);
    const rung_body b = {.length = c->length,
                         .radius = source->radius,
                         .base = c->base,
                         .tip = c->tip,
                         .sections_along = source->sections_along};
    *out = (segment_plan){.mesh = {.order = r.plane_order,
                                   .size = r.size * source->radius,
                                   .edge_layers = 1,
                                   .edge_first = r.edge_first},
                          .order = r.order};
    return segment_rung_layers(&r, &b, &out->nlayer, &out->layer);
}

// a stack's layers are its slices' own
static status take_layers(const segment_source *source, segment_plan *out)
{
    status st = OK;
    free(out->layer);
    out->layer = NULL;
    out->nlayer = source->nlayer;
    TRY(TAKE(out->layer, (size_t)source->nlayer + 1));
    memcpy(out->layer, source->layer, ((size_t)source->nlayer + 1) * sizeof *out->layer);

done:
    return st;
}

status segment_plan_make(const segment_case *c, const segment_source *source, int rung,
                         segment_plan *out)
{
    status st = OK;
    TRY(is_given(c) ? plan_given(c, source->radius, rung, out) : plan_rung(c, source, rung, out));
    TRY(source->fixed_layers ? take_layers(source, out) : OK);

done:
    return st;
}

// of a mesh of the case's own nothing is known but that it converges
double segment_plan_factor(const segment_case *c, const segment_source *source, int rung,
                           bool grows)
{
    const double slowest = segment_rung_slowest();
    const double factor = segment_rung_factor(rung, source->nu, c->tip);
    return is_given(c) ? slowest : grows ? factor : fmax(factor, slowest);
}

double segment_plan_law_factor(const segment_case *c, int rung)
{
    return is_given(c) ? segment_rung_slowest() : segment_rung_law_factor(rung);
}
