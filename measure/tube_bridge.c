// What is not known of a line where there are no points: it may bend there as it does elsewhere.
#include "measure/tube_inside.h"

#include "base/memory.h"

#include <stdlib.h>

enum { PLACES = 400 };

static const double empty = 0.1; // of the usual number of points: fewer are strays

typedef struct bridge {
    double h; // between places
    int count[PLACES];
    bool seen[PLACES];
    vec3 bend[PLACES];     // second derivative, [1/m]
    double change[PLACES]; // of it over k places, per direction, root mean square  [1/m]
} bridge;

static int by_number(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

static void look(const tube_fit *f, bridge *b)
{
    int sorted[PLACES];
    b->h = f->curve.length / PLACES;
    for (size_t i = 0; i < f->count; i++) {
        const double at = f->u[i] / b->h;
        if (f->weight[i] > 0 && at >= 0 && at < PLACES) {
            b->count[(int)at]++;
        }
    }
    for (int i = 0; i < PLACES; i++) {
        sorted[i] = b->count[i];
        (void)tube_curve_at(&f->curve, (i + 0.5) * b->h, NULL, &b->bend[i]);
    }
    qsort(sorted, PLACES, sizeof *sorted, by_number);
    for (int i = 0; i < PLACES; i++) {
        b->seen[i] = b->count[i] > empty * sorted[PLACES / 2];
    }
}

// D(d) of (9.11)
static void changes(bridge *b)
{
    for (int k = 1; k < PLACES; k++) {
        double sum = 0, n = 0;
        for (int i = 0; i + k < PLACES; i++) {
            if (b->seen[i] && b->seen[i + k]) {
                const vec3 d = vec3_sub(b->bend[i + k], b->bend[i]);
                sum += vec3_dot(d, d) / 2;
                n++;
            }
        }
        b->change[k] = n > 0 ? fmax(b->change[k - 1], sqrt(sum / n)) : b->change[k - 1];
    }
}

// how far the line may lie off at place i, in the stretch [from, to) without points   (9.11)
static double off(const bridge *b, int i, int from, int to)
{
    if (from == 0) {
        const double x = (to - i) * b->h;
        return b->change[to - i] * x * x / 2;
    }
    const double x = (i + 0.5 - from) * b->h, y = (to - i - 0.5) * b->h;
    return b->change[(to - from + 1) / 2] * pow(x * y / (x + y), 2) / 2;
}

static void widen(centreline *line, double at, double length, double sigma)
{
    for (int i = 0; i < line->count; i++) {
        if (fabs(line->s[i] - at) <= length / 2) {
            line->sigma[i] = hypot(line->sigma[i], sigma);
        }
    }
}

status tube_bridge(const tube_fit *f, centreline *line, double *base)
{
    status st = OK;
    bridge *b = NULL;
    *base = 0;
    TRY(TAKE(b, 1));
    look(f, b);
    changes(b);
    for (int from = 0; from < PLACES; from++) {
        int to = from;
        while (to < PLACES && !b->seen[to]) {
            to++;
        }
        for (int i = from; i < to && to < PLACES; i++) {
            widen(line, (i + 0.5) * b->h, b->h * (1 + 1e-9), off(b, i, from, to));
        }
        *base = from == 0 && to < PLACES ? to * b->h : *base;
        from = to;
    }

done:
    free(b);
    return st;
}
