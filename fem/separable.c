// fem/separable.c
#include "fem/separable.h"

#include "base/memory.h"
#include "fem/blas.h"
#include "fem/line_modes.h"

#include <math.h>
#include <string.h>

enum { KINDS = 2 }; // of directions: in the plane, along s

static const int directions[KINDS + 1] = {0, 2, 3};

typedef struct kind {
    line_modes modes;
    int *first; // [size + 1] modes of every rank
    int ndof;
    petsc_plane **factor; // [own modes]
} kind;

struct separable {
    const petsc_plane_door *door;
    int nplane, nlevel, rank, size;
    int *level, *node; // [size + 1] levels and plane nodes of every rank
    kind kind[KINDS];
    int *nsend, *nget;              // [size]
    double *pack, *levels, *planes; // working storage
    double *right, *left;           // one plane, columns apart
};

void separable_free(separable *s)
{
    if (!s) {
        return;
    }
    for (int k = 0; k < KINDS; k++) {
        kind *q = &s->kind[k];
        for (int i = 0; q->factor && i < q->first[s->rank + 1] - q->first[s->rank]; i++) {
            s->door->free(q->factor[i]);
        }
        free(q->factor);
        free(q->first);
        line_modes_free(&q->modes);
    }
    free(s->level);
    free(s->node);
    free(s->nsend);
    free(s->nget);
    free(s->pack);
    free(s->levels);
    free(s->planes);
    free(s->right);
    free(s->left);
    free(s);
}

// --- one factor per mode

static status take_factors(separable *s, const body *b, const plane_forms *forms, int which)
{
    status st = OK;
    kind *q = &s->kind[which];
    plane_pattern pattern = {0};
    double *E = NULL, *M = NULL;
    TRY(plane_pattern_make(forms, directions[which], directions[which + 1], &pattern));
    const size_t entries = (size_t)pattern.start[pattern.ndof];
    q->ndof = pattern.ndof;
    TRY(TAKE(E, entries));
    TRY(TAKE(M, entries));
    plane_pattern_values(&pattern, forms, FORM_E, E);
    plane_pattern_values(&pattern, forms, FORM_M, M);
    const int first = q->first[s->rank], last = q->first[s->rank + 1];
    TRY(TAKE(q->factor, (size_t)(last - first)));
    // a motion that neither end holds has the length of the body, not an infinite one
    const double least = 1 / (b->length * b->length);
    double before = 0;
    for (int i = first; i < last; i++) {
        const double theta = fmax(q->modes.theta[i], least);
        for (size_t k = 0; k < entries; k++) {
            E[k] += (theta - before) * M[k];
        }
        before = theta;
        TRY(s->door->factor(q->ndof, pattern.start, pattern.column, E, &q->factor[i - first]));
    }

done:
    free(E);
    free(M);
    plane_pattern_free(&pattern);
    return st;
}

static void share_out(int count, int size, int *first)
{
    for (int r = 0; r <= size; r++) {
        first[r] = (int)((long long)count * r / size);
    }
}

static size_t most_of(const int *first, int rank)
{
    return (size_t)(first[rank + 1] - first[rank]);
}

static status take_room(separable *s, int ncol)
{
    status st = OK;
    size_t width = 2 * (size_t)ncol, most = 0;
    const size_t own = most_of(s->level, s->rank) * width * (size_t)s->nplane;
    const size_t strip = (size_t)s->nlevel * width * most_of(s->node, s->rank);
    for (int k = 0; k < KINDS; k++) {
        const size_t modes = most_of(s->kind[k].first, s->rank) * width * (size_t)s->nplane;
        most = modes > most ? modes : most;
    }
    most = own > most ? own : most;
    TRY(TAKE(s->pack, most));
    TRY(TAKE(s->planes, most));
    TRY(TAKE(s->levels, 2 * strip));
    TRY(TAKE(s->right, width * (size_t)s->nplane));
    TRY(TAKE(s->left, width * (size_t)s->nplane));

done:
    return st;
}

status separable_make(const petsc_plane_door *door, const body *b, const plane_forms *forms,
                      const separable_layout *layout, int ncol, separable **out)
{
    status st = OK;
    separable *s = NULL;
    TRY(TAKE(s, 1));
    *s = (separable){.door = door,
                     .nplane = b->plane->nnode,
                     .nlevel = b->nlevel,
                     .rank = layout->rank,
                     .size = layout->size};
    const size_t ends = (size_t)s->size + 1;
    TRY(TAKE(s->level, ends));
    TRY(TAKE(s->node, ends));
    TRY(TAKE(s->nsend, ends));
    TRY(TAKE(s->nget, ends));
    memcpy(s->level, layout->first, ends * sizeof *s->level);
    share_out(s->nplane, s->size, s->node);
    for (int k = 0; k < KINDS; k++) {
        kind *q = &s->kind[k];
        TRY(line_modes_make(b, layout->base[k], layout->tip, &q->modes));
        TRY(TAKE(q->first, ends));
        share_out(q->modes.count, s->size, q->first);
        TRY(take_factors(s, b, forms, k));
    }
    TRY(take_room(s, ncol));
    *out = s;
    s = NULL;

done:
    separable_free(s);
    return st;
}

double separable_bytes(const separable *s)
{
    double bytes = 0;
    for (int k = 0; k < KINDS; k++) {
        for (size_t i = 0; i < most_of(s->kind[k].first, s->rank); i++) {
            bytes += s->door->bytes(s->kind[k].factor[i]);
        }
    }
    return bytes;
}

// --- from levels to planes of modes and back

// One passage of one kind of directions.
typedef struct passage {
    separable *s;
    const kind *kind;
    int from, ndir, ncol;
    size_t strip; // values of one level in this rank's nodes
} passage;

// Where one rank's part of a plane lies: directions apart.
static size_t plane_at(const passage *p, int direction, int node)
{
    return ((size_t)direction * (size_t)p->s->nplane + (size_t)node) * (size_t)p->ncol;
}

// whole planes <-> [rank][plane][direction][nodes of that rank][column]
static void to_strips(const passage *p, int planes, size_t stride, const double *from, double *to)
{
    const int *node = p->s->node;
    for (int r = 0; r < p->s->size; r++) {
        const size_t run = most_of(node, r) * (size_t)p->ncol;
        for (int i = 0; i < planes; i++) {
            for (int d = 0; d < p->ndir; d++, to += run) {
                memcpy(to, from + (size_t)i * stride + plane_at(p, d, node[r]), run * sizeof *to);
            }
        }
    }
}

static void from_strips(const passage *p, int planes, size_t stride, const double *from, double *to)
{
    const int *node = p->s->node;
    for (int r = 0; r < p->s->size; r++) {
        const size_t run = most_of(node, r) * (size_t)p->ncol;
        for (int i = 0; i < planes; i++) {
            for (int d = 0; d < p->ndir; d++, from += run) {
                memcpy(to + (size_t)i * stride + plane_at(p, d, node[r]), from, run * sizeof *to);
            }
        }
    }
}

// whole planes of this rank become strips of all planes, or the other way
static status turn_over(const passage *p, const int *first, bool forth, const double *from,
                        double *to)
{
    separable *s = p->s;
    const size_t own = most_of(first, s->rank);
    for (int r = 0; r < s->size; r++) {
        const size_t there = (size_t)p->ndir * most_of(s->node, r) * (size_t)p->ncol;
        const int whole = (int)(own * there), strip = (int)(most_of(first, r) * p->strip);
        s->nsend[r] = forth ? whole : strip;
        s->nget[r] = forth ? strip : whole;
    }
    return s->door->exchange(s->nsend, from, s->nget, to);
}

// Y [modes] = V X [levels], or X = V^T Y
static void change(const passage *p, bool to_modes, const double *from, double *to)
{
    const line_modes *m = &p->kind->modes;
    const int n = (int)p->strip, nlevel = p->s->nlevel;
    const double one = 1, none = 0;
    if (n > 0 && to_modes) {
        dgemm_("N", "N", &n, &m->count, &nlevel, &one, from, &n, m->V, &nlevel, &none, to, &n);
    } else if (n > 0) {
        dgemm_("N", "T", &n, &nlevel, &m->count, &one, from, &n, m->V, &nlevel, &none, to, &n);
    }
}

static status solve_plane(const passage *p, petsc_plane *factor, double *plane)
{
    status st = OK;
    separable *s = p->s;
    const size_t n = (size_t)p->kind->ndof, ncol = (size_t)p->ncol;
    for (size_t i = 0; i < n; i++) {
        for (size_t c = 0; c < ncol; c++) {
            s->right[c * n + i] = plane[i * ncol + c];
        }
    }
    TRY(s->door->solve(factor, p->ncol, s->right, s->left));
    for (size_t i = 0; i < n; i++) {
        for (size_t c = 0; c < ncol; c++) {
            plane[i * ncol + c] = s->left[c * n + i];
        }
    }

done:
    return st;
}

static status solve_kind(separable *s, int which, int ncol, const double *r, double *z)
{
    status st = OK;
    const kind *q = &s->kind[which];
    passage p = {.s = s,
                 .kind = q,
                 .from = directions[which],
                 .ndir = directions[which + 1] - directions[which],
                 .ncol = ncol};
    p.strip = (size_t)p.ndir * most_of(s->node, s->rank) * (size_t)ncol;
    const size_t level = plane_at(&p, 3, 0), plane = plane_at(&p, p.ndir, 0);
    const size_t begin = plane_at(&p, p.from, 0);
    const int own = (int)most_of(s->level, s->rank), modes = (int)most_of(q->first, s->rank);
    double *strips = s->levels, *changed = s->levels + (size_t)s->nlevel * p.strip;
    status mine = OK; // a rank that fails goes on with what all have to do

    to_strips(&p, own, level, r + begin, s->pack);
    TRY(turn_over(&p, s->level, true, s->pack, strips));
    change(&p, true, strips, changed);
    TRY(turn_over(&p, q->first, false, changed, s->pack));
    from_strips(&p, modes, plane, s->pack, s->planes);
    for (int i = 0; mine == OK && i < modes; i++) {
        mine = solve_plane(&p, q->factor[i], s->planes + (size_t)i * plane);
    }
    to_strips(&p, modes, plane, s->planes, s->pack);
    TRY(turn_over(&p, q->first, true, s->pack, changed));
    change(&p, false, changed, strips);
    TRY(turn_over(&p, s->level, false, strips, s->pack));
    from_strips(&p, own, level, s->pack, z + begin);
    TRY(mine);

done:
    return st;
}

status separable_solve(separable *s, int ncol, const double *r, double *z)
{
    status st = OK;
    for (int k = 0; k < KINDS; k++) {
        const status here = solve_kind(s, k, ncol, r, z);
        st = st ? st : here;
    }
    return st;
}
