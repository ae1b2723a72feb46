// fem/doubling_fields.c
// Displacements at the body's levels, which need not be cuts: cubic between the four nearest of the
// finest cuts.
#include "fem/doubling_answer.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

enum { STENCIL = 4 };

// the cuts about a level, and their weights; a level that is a cut has it alone
typedef struct stencil {
    int first, count;
    double weight[STENCIL];
} stencil;

static stencil stencil_at(const doubling *d, double z)
{
    const int cuts = 1 << d->doublings;
    const double at = (z - d->begin) / d->problem->body->length * cuts, near = round(at);
    if (fabs(at - near) < 1e-6) {
        return (stencil){.first = (int)near, .count = 1, .weight = {1}};
    }
    stencil s = {.first = (int)floor(at) - 1, .count = STENCIL};
    s.first = s.first < 0 ? 0 : s.first > cuts + 1 - STENCIL ? cuts + 1 - STENCIL : s.first;
    for (int k = 0; k < STENCIL; k++) {
        s.weight[k] = 1;
        for (int i = 0; i < STENCIL; i++) {
            s.weight[k] *= i == k ? 1 : (at - (s.first + i)) / (k - i);
        }
    }
    return s;
}

static int ascending(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

// the cuts that the levels held need
static status find_wanted(const doubling *d, int *count, int **out)
{
    status st = OK;
    const body *b = d->problem->body;
    int *list = NULL, n = 0, kept = 0;
    TRY(TAKE(list, STENCIL * (size_t)(b->last - b->first) + 1));
    for (int i = b->first; i < b->last; i++) {
        const stencil s = stencil_at(d, b->level[i]);
        for (int k = 0; k < s.count; k++) {
            list[n++] = s.first + k;
        }
    }
    qsort(list, (size_t)n, sizeof *list, ascending);
    for (int i = 0; i < n; i++) {
        if (kept == 0 || list[kept - 1] != list[i]) {
            list[kept++] = list[i];
        }
    }
    *count = kept;
    *out = list;

done:
    return st;
}

// unknowns of the wanted cuts, rigid motions among them
typedef struct wanted_cuts {
    int count, *number;
    double *x; // [count][ncolumn][n]
} wanted_cuts;

static double *wanted_at(const wanted_cuts *w, int number, size_t size)
{
    int low = 0, high = w->count;
    while (low < high) {
        const int mid = low + (high - low) / 2;
        if (w->number[mid] < number) {
            low = mid + 1;
        } else {
            high = mid;
        }
    }
    return low < w->count && w->number[low] == number ? w->x + (size_t)low * size : NULL;
}

static void note(const doubling_tree *t, const slab_list *list, int k, bool upper,
                 const wanted_cuts *w)
{
    const cut_part *p = &t->cut->part[t->part];
    const size_t n = (size_t)p->n, columns = (size_t)list->ncolumn;
    double *to = wanted_at(w, list->start[k] + (upper ? 1 << list->doublings : 0), n * columns);
    if (!to) {
        return;
    }
    const size_t at = (size_t)k * columns;
    memcpy(to, (upper ? list->upper : list->lower) + at * n, n * columns * sizeof *to);
    for (size_t j = 0; j < columns; j++) {
        const double *rigid = list->rigid + (at + j) * (size_t)p->nrigid;
        double q[6] = {0};
        memcpy(q, rigid, (size_t)p->nrigid * sizeof *q);
        if (upper) {
            doubling_tree_carry(t, ldexp(t->height, list->doublings),
                                ldexp(t->turn, list->doublings), rigid, q);
        }
        for (int i = 0; i < p->nrigid; i++) {
            to[j * n + (size_t)p->at[i]] += q[i];
        }
    }
}

static status descend(const doubling_tree *t, slab_list *list, const wanted_cuts *w)
{
    status st = OK;
    for (;;) {
        for (int k = 0; k < list->count; k++) {
            note(t, list, k, false, w);
            if (list->start[k] + (1 << list->doublings) == 1 << t->doublings) {
                note(t, list, k, true, w);
            }
        }
        if (list->doublings == 0 || list->count == 0) {
            break;
        }
        TRY(slab_list_halve(t, w->count, w->number, list));
    }

done:
    return st;
}

status doubling_fields_add(const doubling *d, const doubling_tree *t, const int *active,
                           slab_list *cells, way_run *run)
{
    status st = OK;
    const body *b = d->problem->body;
    const size_t n = (size_t)d->cut.part[t->part].n, columns = (size_t)cells->ncolumn;
    const size_t held = (size_t)(run->last - run->first), dofs = 3 * (size_t)d->cut.nplane;
    wanted_cuts w = {0};
    double *x = NULL;
    TRY(find_wanted(d, &w.count, &w.number));
    TRY(TAKE(w.x, (size_t)w.count * columns * n));
    TRY(TAKE(x, n));
    TRY(descend(t, cells, &w));
    for (size_t i = 0; i < held; i++) {
        const stencil s = stencil_at(d, b->level[run->first + (int)i]);
        for (size_t j = 0; j < columns; j++) {
            memset(x, 0, n * sizeof *x);
            for (int k = 0; k < s.count; k++) {
                const double *from = wanted_at(&w, s.first + k, n * columns) + j * n;
                for (size_t m = 0; m < n; m++) {
                    x[m] += s.weight[k] * from[m];
                }
            }
            cut_motion(&d->cut, t->part, x, run->u + ((size_t)active[j] * held + i) * dofs);
        }
    }

done:
    free(w.number);
    free(w.x);
    free(x);
    return st;
}

void doubling_fields_finish(const doubling *d, int column, vec6 mean, way_run *run)
{
    const body *b = d->problem->body;
    const int held = run->last - run->first, nplane = d->cut.nplane;
    for (int i = 0; i < held; i++) {
        double *u = run->u + ((size_t)column * (size_t)held + (size_t)i) * 3 * (size_t)nplane;
        const double turn = d->turn_rate * b->level[run->first + i];
        const double c = cos(turn + d->cut.angle), s = sin(turn + d->cut.angle);
        const double cx = cos(turn), sx = sin(turn);
        for (int k = 0; k < nplane; k++, u += 3) {
            const double *at = b->plane->xyz + 3 * (size_t)k;
            const double x = cx * at[0] - sx * at[1], y = sx * at[0] + cx * at[1];
            const double ua = u[0], ub = u[1];
            u[0] = c * ua - s * ub - (mean.a[NX] - mean.a[MZ] * y);
            u[1] = s * ua + c * ub - (mean.a[NY] + mean.a[MZ] * x);
        }
    }
}
