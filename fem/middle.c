// fem/middle.c
// The middle of the segment, away from both ends: its curvature, and the stiffness centre that
// follows.
#include "fem/segment_run.h"

#include "base/memory.h"

#include <math.h>

// Half width of the window over the length. The fit of a slope weighs its middle most, so it may be
// wide.
static const double CURVATURE_WINDOW = 0.25;

// weight[k]: the least-squares slope over the window of a function given at the levels.
// docs/theory.md (5.3)
static void slope_weights(const column *c, double *weight)
{
    const double centre = c->level[0] + c->length / 2, half = CURVATURE_WINDOW * c->length;
    double x[ELEMENT_MAX_ORDER + 1], g[ELEMENT_MAX_ORDER + 1], N[ELEMENT_MAX_ORDER + 1];
    const int p = c->order;
    gauss_legendre(p + 1, x, g);
    for (int layer = 0; layer < c->nlayer; layer++) {
        const double begin = c->level[layer * p], end = c->level[(layer + 1) * p];
        const double from = fmax(begin, centre - half), to = fmin(end, centre + half);
        for (int q = 0; to > from && q <= p; q++) {
            const double z = (from + to) / 2 + (to - from) / 2 * x[q];
            const double t = 2 * (z - begin) / (end - begin) - 1;
            const double moment = g[q] * (to - from) / 2 * (z - centre);
            element_basis(&c->line, &t, N, NULL);
            for (int k = 0; k <= p; k++) {
                weight[layer * p + k] += moment * N[k] / (2 * pow(half, 3) / 3);
            }
        }
    }
}

static status curvatures(const column *c, const segment_run *run, double (*curvature)[2])
{
    status st = OK;
    double *weight = NULL;
    TRY(TAKE(weight, (size_t)c->nlevel));
    slope_weights(c, weight);
    for (int j = 0; j < run->nsolution; j++) {
        for (int i = 0; i < 2; i++) {
            curvature[j][i] = 0;
            for (int k = 0; k < c->nlevel; k++) {
                curvature[j][i] += weight[k] * run->motion[j * c->nlevel + k].a[MX + i];
            }
        }
    }

done:
    free(weight);
    return st;
}

// an axial force at (x, y) is the wrench n_z + y m_x - x m_y: where its curvature vanishes.
// docs/theory.md (5.4)
static status find_centre(const double (*kappa)[2], double *centre)
{
    const double a = -kappa[MY][0], b = kappa[MX][0], d = -kappa[MY][1], e = kappa[MX][1];
    const double det = a * e - b * d, scale = fabs(a * e) + fabs(b * d);
    if (!(fabs(det) > 1e-12 * scale)) {
        return status_fail(ERR_NUMERIC, "segment: end moments do not bend the middle");
    }
    centre[0] = (b * kappa[NZ][1] - e * kappa[NZ][0]) / det;
    centre[1] = (d * kappa[NZ][0] - a * kappa[NZ][1]) / det;
    return OK;
}

status middle_make(const column *c, const segment_run *run, middle *out)
{
    status st = OK;
    TRY(curvatures(c, run, out->curvature));
    TRY(find_centre((const double(*)[2])out->curvature, out->stiffness_centre));

done:
    return st;
}
