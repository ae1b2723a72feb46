// fem/iterative_fields.c
// Products and norms of the iterative way's fields.
#include "fem/iterative.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

// --- products

// forces on the level above belong to the next rank
static status pass_up(iterative *w, double *f)
{
    status st = OK;
    const level_share *s = &w->share;
    int *nsend = NULL, *nget = NULL;
    TRY(TAKE(nsend, (size_t)s->size));
    TRY(TAKE(nget, (size_t)s->size));
    const bool busy = s->first < s->last;
    const bool up = busy && s->last < w->p->body->nlevel, down = busy && s->first > 0;
    if (up) {
        nsend[s->rank + 1] = (int)w->block;
    }
    if (down) {
        nget[s->rank - 1] = (int)w->block;
    }
    TRY(w->plane_door->exchange(nsend, f + w->own, nget, w->above));
    for (size_t i = 0; down && i < w->block; i++) {
        f[i] += w->above[i];
    }

done:
    free(nsend);
    free(nget);
    return st;
}

status iterative_product(iterative *w, double *u, double *f)
{
    status st = OK;
    const level_share *s = &w->share;
    const bool busy = s->first < s->last;
    const bool up = busy && s->last < w->p->body->nlevel, down = busy && s->first > 0;
    w->door->pass_down(down ? (int)w->block : 0, u, up ? (int)w->block : 0, u + w->own);
    memset(f, 0, (w->own + w->block) * sizeof *f);
    TRY(w->door->agree(apply_layers(w->product, s->first_layer, s->last_layer, w->ncol, u, f)));
    TRY(pass_up(w, f));

done:
    return st;
}

// --- norms

static bool is_unknown(const iterative *w, int level, int direction)
{
    const bool tip = w->cap && level == w->p->body->nlevel - 1;
    return !tip && !(level == 0 && (w->clamped || (w->guided && direction == 2)));
}

static status cap_largest(iterative *w, const double *tip, bool forces, double *most)
{
    status st = OK;
    double *rigid = NULL;
    const size_t n3 = w->block / (size_t)w->ncol;
    if (!forces) {
        return OK; // its motion is seen just below it too
    }
    TRY(TAKE(rigid, 6 * n3));
    section_rigid(w->p->body, w->p->body->nlevel - 1, rigid);
    for (size_t j = 0; j < 6; j++) {
        for (size_t c = 0; c < (size_t)w->ncol; c++) {
            double sum = 0;
            for (size_t i = 0; i < n3; i++) {
                sum += rigid[6 * i + j] * tip[i * (size_t)w->ncol + c];
            }
            most[c] = fmax(most[c], fabs(sum));
        }
    }

done:
    free(rigid);
    return st;
}

status iterative_largest(iterative *w, const double *f, bool forces, double *most)
{
    status st = OK;
    const size_t n = (size_t)w->ncol, run = w->block / 3;
    const level_share *s = &w->share;
    memset(most, 0, n * sizeof *most);
    for (int level = s->first; level < s->last; level++) {
        const double *from = f + (size_t)(level - s->first) * w->block;
        for (int d = 0; d < 3; d++, from += run) {
            for (size_t i = 0; is_unknown(w, level, d) && i < run; i++) {
                most[i % n] = fmax(most[i % n], fabs(from[i]));
            }
        }
    }
    if (w->cap && s->first < s->last && s->last == w->p->body->nlevel) {
        st = cap_largest(w, f + w->own - w->block, forces, most);
    }
    TRY(w->door->agree(st));
    w->door->largest(w->ncol, most);

done:
    return st;
}
