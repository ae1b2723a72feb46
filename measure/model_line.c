// measure/model_line.c
// A model's centreline between its stations, and a measured one brought to its arclength.
#include "base/memory.h"
#include "measure/shape_error.h"

#include <string.h>

// the panel that holds s
static int panel_of(int count, const double *s, double at)
{
    int low = 0, high = count - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (s[middle] <= at) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return low;
}

// Hermite's cubic on one panel
static vec3 hermite(const model_line *m, int i, double s)
{
    const double h = m->s[i + 1] - m->s[i], t = (s - m->s[i]) / h;
    const double from = (1 + 2 * t) * (1 - t) * (1 - t), to = t * t * (3 - 2 * t);
    const double leave = h * t * (1 - t) * (1 - t), arrive = h * t * t * (t - 1);
    vec3 p = vec3_scale(from, m->p[i]);
    p = vec3_add_scaled(p, to, m->p[i + 1]);
    p = vec3_add_scaled(p, leave, m->slope[i]);
    return vec3_add_scaled(p, arrive, m->slope[i + 1]);
}

vec3 model_line_at(const model_line *m, double s)
{
    return hermite(m, panel_of(m->count, m->s, s), s);
}

// Simpson's rule on |dp/ds|; the slope in the middle is that of Hermite's cubic
void model_line_lengths(const model_line *m, double *along)
{
    along[0] = 0;
    for (int i = 0; i + 1 < m->count; i++) {
        const double h = m->s[i + 1] - m->s[i];
        vec3 middle = vec3_scale(1.5 / h, vec3_sub(m->p[i + 1], m->p[i]));
        middle = vec3_add_scaled(middle, -0.25, vec3_add(m->slope[i], m->slope[i + 1]));
        along[i + 1] =
            along[i] +
            h / 6 * (vec3_norm(m->slope[i]) + 4 * vec3_norm(middle) + vec3_norm(m->slope[i + 1]));
    }
}

// s of the unloaded rod where the loaded one is `sigma` long: a cubic with ds/dsigma = 1 / |dp/ds|
// at the stations, and on with the last of these beyond the tip
static double unloaded_arclength(const model_line *m, double sigma)
{
    const int last = m->count - 1;
    if (sigma >= m->along[last]) {
        return m->s[last] + (sigma - m->along[last]) / vec3_norm(m->slope[last]);
    }
    const int i = panel_of(m->count, m->along, sigma);
    const double h = m->along[i + 1] - m->along[i], t = (sigma - m->along[i]) / h;
    const double leave = h / vec3_norm(m->slope[i]), arrive = h / vec3_norm(m->slope[i + 1]);
    return (1 + 2 * t) * (1 - t) * (1 - t) * m->s[i] + t * t * (3 - 2 * t) * m->s[i + 1] +
           t * (1 - t) * ((1 - t) * leave - t * arrive);
}

bool shape_ends_at_tip(const shape_way *way, double end, double length)
{
    const double share = way->arclength == ARCLENGTH_REST ? SHAPE_REST_SHARE : SHAPE_TIP_SHARE;
    const double longest =
        way->arclength == ARCLENGTH_REST ? INFINITY : length * (1 + SHAPE_TIP_LONGER);
    return way->tip == TIP_MEASURED ||
           (way->tip == TIP_BY_LENGTH && end >= length * (1 - share) && end <= longest);
}

status shape_match(const model_line *m, const centreline *measured, const shape_way *way,
                   centreline *out, bool *tip, double *longer)
{
    status st = OK;
    centreline c = {0};
    const bool rest = way->arclength == ARCLENGTH_REST;
    const double end = measured->s[measured->count - 1];
    const double length = rest ? m->s[m->count - 1] : m->along[m->count - 1];
    *tip = shape_ends_at_tip(way, end, length);
    *longer = end - length;
    const double scale = *tip ? length / end : 1; // tip to tip
    TRY(centreline_make(measured->count, &c));
    memcpy(c.p, measured->p, (size_t)c.count * sizeof *c.p);
    memcpy(c.sigma, measured->sigma, (size_t)c.count * sizeof *c.sigma);
    for (int i = 0; i < c.count; i++) {
        c.s[i] = rest ? measured->s[i] : unloaded_arclength(m, scale * measured->s[i]);
        c.own[i] = centreline_own_sigma(measured, i);
    }
    c.radius = measured->radius;
    c.radius_sigma = measured->radius_sigma;
    c.correlation_length = measured->correlation_length;
    *out = c;
    c = (centreline){0};

done:
    centreline_free(&c);
    return st;
}
