// measure/centreline.c
#include "measure/centreline.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>

status centreline_make(int count, centreline *out)
{
    status st = OK;
    centreline c = {.count = count, .radius = NAN, .radius_sigma = NAN, .correlation_length = NAN};
    TRY(TAKE(c.s, (size_t)count));
    TRY(TAKE(c.p, (size_t)count));
    TRY(TAKE(c.sigma, (size_t)count));
    TRY(TAKE(c.own, (size_t)count));
    for (int i = 0; i < count; i++) {
        c.own[i] = NAN;
    }
    *out = c;
    c = (centreline){0};

done:
    centreline_free(&c);
    return st;
}

void centreline_free(centreline *c)
{
    free(c->s);
    free(c->p);
    free(c->sigma);
    free(c->own);
    *c = (centreline){0};
}

double centreline_own_sigma(const centreline *c, int i)
{
    return c->own && !isnan(c->own[i]) ? c->own[i] : c->sigma[i];
}

// where the four points for s begin
static int first_of_four(const centreline *c, double s)
{
    int low = 0, high = c->count - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (c->s[middle] <= s) {
            low = middle;
        } else {
            high = middle;
        }
    }
    const int last = c->count > 4 ? c->count - 4 : 0;
    return low - 1 < 0 ? 0 : low - 1 > last ? last : low - 1;
}

vec3 centreline_at(const centreline *c, double s)
{
    vec3 p = {{0, 0, 0}};
    const int first = first_of_four(c, s), n = c->count < 4 ? c->count : 4;
    for (int i = first; i < first + n; i++) {
        double weight = 1; // Lagrange's
        for (int k = first; k < first + n; k++) {
            weight *= k == i ? 1 : (s - c->s[k]) / (c->s[i] - c->s[k]);
        }
        for (int d = 0; d < 3; d++) {
            p.a[d] += weight * c->p[i].a[d];
        }
    }
    return p;
}
