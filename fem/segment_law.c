// fem/segment_law.c
// The law of the section by strain energy, from a column so long that nothing of its ends reaches
// the middle. docs/theory.md (5.5)
#include "fem/segment.h"

#include "base/memory.h"
#include "fem/after.h"
#include "fem/segment_way.h"

#include <math.h>

// Length over the section's radius, and the height of the first layer, from which they double.
// Along z the middle is a cubic at most, which elements of order 3 hold however long they are; the
// ends' layers need only die out.
static const double LONG = 32;
static const double FIRST_LAYER = 1;
enum { LONG_ORDER = 3 };

// half the window's height over the radius
static const double WINDOW = 0.5;

static status long_layers(double radius, int *nlayer, double **layer)
{
    status st = OK;
    const int half = (int)ceil(log2(1 + LONG / 2 / FIRST_LAYER));
    const double unit = LONG / 2 * radius / (pow(2, half) - 1);
    double z = 0;
    *nlayer = 2 * half;
    TRY(TAKE(*layer, (size_t)*nlayer + 1));
    for (int i = 0; i < *nlayer; i++) {
        z += unit * pow(2, i < half ? i : *nlayer - 1 - i);
        (*layer)[i + 1] = z;
    }

done:
    return st;
}

// K from the energy at a height
static status law_at(const segment_problem *p, const body *b, double height, beam_law *out)
{
    status st = OK;
    way_run run = {0};
    after a = {0};
    const way_wants wants = {.middle = height, .middle_half = WINDOW * b->radius};
    int way = WAY_AUTO;
    char why[SEGMENT_WHY_WORDS];
    TRY(segment_way_solve(WAY_AUTO, p, &wants, &run, &way, why));
    TRY(after_make(p, &run, &wants, &a));
    TRY(after_middle(&a, out));

done:
    after_free(&a);
    way_run_free(&run);
    return st;
}

// *end_effect: what K changes half way from the middle to an end, a bound of what the ends still do
static status long_law(const mesh *plane, const material *materials, double *end_effect,
                       beam_law *out)
{
    status st = OK;
    body b = {0};
    body_spec spec = {.plane = plane, .materials = materials, .order = LONG_ORDER};
    double radius = 0, *layer = NULL;
    beam_law aside = {0};
    for (int i = 0; i < plane->nnode; i++) {
        radius = fmax(radius, hypot(plane->xyz[3 * i], plane->xyz[3 * i + 1]));
    }
    TRY(long_layers(radius, &spec.nlayer, &layer));
    spec.layer = layer;
    TRY(body_make(&spec, &b));
    const segment_problem p = {.body = &b, .base = BASE_CLAMPED, .tip = TIP_RIGID};
    TRY(law_at(&p, &b, b.length / 2, out));
    if (end_effect) {
        TRY(law_at(&p, &b, b.length / 4, &aside));
        *end_effect = mat6_relative_error(aside.K, out->K);
    }

done:
    body_free(&b);
    free(layer);
    return st;
}

status segment_section_law(const mesh *plane, const material *materials, beam_law *out)
{
    status st = OK;
    mesh lower = {0};
    beam_law law = {0}, lower_law = {0};
    double end_effect = 0, jacobian = 0;

    TRY(long_law(plane, materials, &end_effect, &law));
    law.relative_error = 1;
    if (plane->order > 1) {
        TRY(mesh_of_order(plane, plane->order - 1, &lower));
        TRY(mesh_min_jacobian(&lower, &jacobian));
    }
    if (jacobian > 0) {
        TRY(long_law(&lower, materials, NULL, &lower_law));
        law.relative_error = fmax(end_effect, mat6_relative_error(lower_law.K, law.K));
    }
    *out = law;

done:
    mesh_free(&lower);
    return st;
}
