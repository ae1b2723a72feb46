// reports/scene_box.c
// The cube that a scene shows, and whether it can be shown.
#include "reports/scene.h"

#include <math.h>

// browsers draw in single precision, which must hold the squares of lengths
static const double least_size = 1e-15, most_size = 1e15; // [m]

scene_box scene_box_empty(void)
{
    return (scene_box){.low = {INFINITY, INFINITY, INFINITY},
                       .high = {-INFINITY, -INFINITY, -INFINITY}};
}

void scene_box_add(scene_box *b, const double place[3])
{
    for (int d = 0; d < 3; d++) {
        b->unknown = b->unknown || !isfinite(place[d]);
        b->low[d] = fmin(b->low[d], place[d]);
        b->high[d] = fmax(b->high[d], place[d]);
    }
}

void scene_box_put(const scene_box *b, double times, double more, scene_spec *spec)
{
    double side = b->unknown ? NAN : 0;
    for (int d = 0; d < 3 && !b->unknown; d++) {
        side = fmax(side, b->high[d] - b->low[d]);
    }
    spec->size = times * side + more;
    for (int d = 0; d < 3; d++) {
        spec->low[d] = (b->low[d] + b->high[d] - spec->size) / 2;
    }
}

static bool is_between(double x, double least, double most)
{
    return x >= least && x <= most; // not where it is no number
}

bool scene_is_possible(const scene_spec *spec)
{
    bool all = is_between(spec->size, least_size, most_size);
    for (int d = 0; d < 3; d++) {
        all = all && is_between(fabs(spec->low[d]), 0, most_size);
    }
    if (spec->value_name) {
        all = all && spec->value_most > 0 && isfinite(spec->value_most);
    }
    if (spec->factor.name) {
        all = all && spec->factor.most > 0 && isfinite(spec->factor.most) &&
              isfinite(spec->factor.first);
    }
    return all;
}
