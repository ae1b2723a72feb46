// reports/near_points.c
#include "reports/near_points.h"

#include "base/memory.h"

#include <math.h>
#include <stdlib.h>

void near_points_free(near_points *t)
{
    free(t->order);
    *t = (near_points){0};
}

static void swap(int *a, int *b)
{
    const int c = *a;
    *a = *b;
    *b = c;
}

// order[middle] becomes what sorting by the axis would put there (Hoare 1961)
static void part(const near_points *t, int first, int last, int middle, int axis)
{
    while (first < last) {
        const double pivot = t->point[t->order[(first + last) / 2]][axis];
        int i = first, j = last;
        while (i <= j) {
            while (t->point[t->order[i]][axis] < pivot) {
                i++;
            }
            while (t->point[t->order[j]][axis] > pivot) {
                j--;
            }
            if (i <= j) {
                swap(&t->order[i++], &t->order[j--]);
            }
        }
        if (middle <= j) {
            last = j;
        } else if (middle >= i) {
            first = i;
        } else {
            return;
        }
    }
}

static void build(const near_points *t, int first, int last, int axis)
{
    if (first < last) {
        const int middle = first + (last - first) / 2;
        part(t, first, last, middle, axis);
        build(t, first, middle - 1, (axis + 1) % 3);
        build(t, middle + 1, last, (axis + 1) % 3);
    }
}

status near_points_make(int n, const double (*point)[3], near_points *out)
{
    status st = OK;
    near_points t = {.point = point};
    TRY(TAKE(t.order, (size_t)n));
    for (int i = 0; i < n; i++) {
        // a place that is no number orders nothing
        if (isfinite(point[i][0]) && isfinite(point[i][1]) && isfinite(point[i][2])) {
            t.order[t.n++] = i;
        }
    }
    build(&t, 0, t.n - 1, 0);
    *out = t;
    t = (near_points){0};

done:
    near_points_free(&t);
    return st;
}

typedef struct search_near {
    const near_points *t;
    vec3 p;
    double least; // squared
    int best;
} search_near;

static void search(search_near *s, int first, int last, int axis)
{
    if (first > last) {
        return;
    }
    const int middle = first + (last - first) / 2, k = s->t->order[middle];
    const double *q = s->t->point[k];
    const double dx = s->p.a[0] - q[0], dy = s->p.a[1] - q[1], dz = s->p.a[2] - q[2];
    const double square = dx * dx + dy * dy + dz * dz, off = s->p.a[axis] - q[axis];
    if (square < s->least) {
        s->least = square;
        s->best = k;
    }
    for (int side = 0; side < 2; side++) {
        const bool before = (off < 0) == (side == 0);
        if (side == 0 || off * off < s->least) {
            search(s, before ? first : middle + 1, before ? middle - 1 : last, (axis + 1) % 3);
        }
    }
}

int near_points_find(const near_points *t, vec3 p)
{
    search_near s = {t, p, INFINITY, -1};
    search(&s, 0, t->n - 1, 0);
    return s.best;
}
