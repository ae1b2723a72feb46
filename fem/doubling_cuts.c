// fem/doubling_cuts.c
// From the ends of a slab to the cut in its middle, again and again. Ends are seen from the slab's
// lower end, so that a long body's deflection does not drown what its slabs feel.
#include "fem/doubling_tree.h"

#include "base/memory.h"
#include "fem/blas.h"

#include <math.h>
#include <string.h>

void slab_list_free(slab_list *list)
{
    free(list->start);
    free(list->lower);
    free(list->upper);
    free(list->rigid);
    *list = (slab_list){0};
}

static status list_make(int count, int ncolumn, const cut_part *p, slab_list *out)
{
    status st = OK;
    const size_t columns = (size_t)count * (size_t)ncolumn;
    *out = (slab_list){.count = count, .ncolumn = ncolumn};
    TRY(TAKE(out->start, (size_t)count));
    TRY(TAKE(out->lower, columns * (size_t)p->n));
    TRY(TAKE(out->upper, columns * (size_t)p->n));
    TRY(TAKE(out->rigid, columns * (size_t)p->nrigid));

done:
    return st;
}

// translation t + phi x height e_z, then in axes turned with the section
void doubling_tree_carry(const doubling_tree *t, double height, double turn, const double *q,
                         double *at_top)
{
    const cut_part *p = &t->cut->part[t->part];
    double all[6] = {0}, moved[6];
    const double c = cos(turn), s = sin(turn);
    for (int k = 0; k < p->nrigid; k++) {
        all[p->rigid[k]] = q[k];
    }
    all[0] += height * all[4];
    all[1] -= height * all[3];
    for (int d = 0; d < 6; d += 3) {
        moved[d] = c * all[d] + s * all[d + 1];
        moved[d + 1] = c * all[d + 1] - s * all[d];
        moved[d + 2] = all[d + 2];
    }
    for (int k = 0; k < p->nrigid; k++) {
        at_top[k] = moved[p->rigid[k]];
    }
}

// takes the carried rigid motion of the lower end out of the unknowns x [n] of the upper
static void see_from(const doubling_tree *t, double height, double turn, const double *q, double *x)
{
    const cut_part *p = &t->cut->part[t->part];
    double carried[6];
    doubling_tree_carry(t, height, turn, q, carried);
    for (int k = 0; k < p->nrigid; k++) {
        x[p->at[k]] -= carried[k];
    }
}

static void take_rigid(const cut_part *p, double *x, double *q)
{
    for (int k = 0; k < p->nrigid; k++) {
        q[k] = x[p->at[k]];
        x[p->at[k]] = 0;
    }
}

status slab_list_whole(const doubling_tree *t, int ncolumn, const double *u0, const double *u1,
                       slab_list *out)
{
    status st = OK;
    const cut_part *p = &t->cut->part[t->part];
    const size_t n = (size_t)p->n, all = n * (size_t)ncolumn;
    slab_list list = {0};
    TRY(list_make(1, ncolumn, p, &list));
    list.doublings = t->doublings;
    memcpy(list.lower, u0, all * sizeof *u0);
    memcpy(list.upper, u1, all * sizeof *u1);
    for (int j = 0; j < ncolumn; j++) {
        double *q = list.rigid + (size_t)j * (size_t)p->nrigid;
        take_rigid(p, list.lower + (size_t)j * n, q);
        see_from(t, ldexp(t->height, t->doublings), ldexp(t->turn, t->doublings), q,
                 list.upper + (size_t)j * n);
    }
    *out = list;
    list = (slab_list){0};

done:
    slab_list_free(&list);
    return st;
}

// m = factor A^-1 S^T x of the unknowns first .. first + count - 1, for columns x [ncolumn][n]
static void middle_of(const double *factor, const double *to, int n, int count, int ncolumn,
                      double scale, const double *x, double *m)
{
    const double one = 1, none = 0;
    if (count > 0) {
        dgemm_("T", "N", &count, &ncolumn, &n, &scale, to, &n, x, &n, &none, m, &count);
        dtrsm_("L", "L", "T", "N", &count, &ncolumn, &one, factor, &count, m, &count);
    }
}

// the cuts in the middle of all slabs of the list, [ncolumn][n]:
//   m_e = -1/2 A_ee^-1 S_e (u + w),  m_o = 1/2 A_oo^-1 S_o (u - w),  w = J x the upper end
static status middles(const doubling_tree *t, const slab_list *list, double *m)
{
    status st = OK;
    const cut_part *p = &t->cut->part[t->part];
    const slab_joint *joint = &t->joint[list->doublings - 1];
    const int n = p->n, even = p->neven, odd = n - even, columns = list->count * list->ncolumn;
    const size_t all = (size_t)columns * (size_t)n;
    double *x = NULL, *part = NULL;
    TRY(TAKE(x, all));
    TRY(TAKE(part, all));
    for (int sign = 1; sign >= -1; sign -= 2) {
        for (size_t i = 0; i < all; i++) {
            const double w = (int)(i % (size_t)n) < even ? list->upper[i] : -list->upper[i];
            x[i] = list->lower[i] + sign * w;
        }
        const int first = sign > 0 ? 0 : even, count = sign > 0 ? even : odd;
        middle_of(sign > 0 ? joint->even : joint->odd, sign > 0 ? joint->to_even : joint->to_odd, n,
                  count, columns, -0.5 * sign, x, part);
        for (int j = 0; j < columns; j++) {
            memcpy(m + (size_t)j * (size_t)n + first, part + (size_t)j * (size_t)count,
                   (size_t)count * sizeof *m);
        }
    }

done:
    free(x);
    free(part);
    return st;
}

static bool has_wanted(int from, int to, int nwanted, const int *wanted)
{
    int low = 0, high = nwanted;
    while (low < high) {
        const int mid = low + (high - low) / 2;
        if (wanted[mid] <= from) {
            low = mid + 1;
        } else {
            high = mid;
        }
    }
    return !wanted || (low < nwanted && wanted[low] < to);
}

// drops slabs that have no wanted cut inside
static void keep_wanted(const cut_part *p, int nwanted, const int *wanted, slab_list *list)
{
    const size_t ends = (size_t)list->ncolumn * (size_t)p->n;
    const size_t rigid = (size_t)list->ncolumn * (size_t)p->nrigid;
    int kept = 0;
    for (int k = 0; k < list->count; k++) {
        if (!has_wanted(list->start[k], list->start[k] + (1 << list->doublings), nwanted, wanted)) {
            continue;
        }
        if (kept < k) {
            list->start[kept] = list->start[k];
            memcpy(list->lower + (size_t)kept * ends, list->lower + (size_t)k * ends,
                   ends * sizeof *list->lower);
            memcpy(list->upper + (size_t)kept * ends, list->upper + (size_t)k * ends,
                   ends * sizeof *list->upper);
            memcpy(list->rigid + (size_t)kept * rigid, list->rigid + (size_t)k * rigid,
                   rigid * sizeof *list->rigid);
        }
        kept++;
    }
    list->count = kept;
}

// one slab and the cut m in its middle -> two
static void split(const doubling_tree *t, const slab_list *from, int k, const double *m,
                  slab_list *to)
{
    const cut_part *p = &t->cut->part[t->part];
    const size_t n = (size_t)p->n, r = (size_t)p->nrigid, columns = (size_t)from->ncolumn;
    const double height = ldexp(t->height, to->doublings), turn = ldexp(t->turn, to->doublings);
    to->start[2 * k] = from->start[k];
    to->start[2 * k + 1] = from->start[k] + (1 << to->doublings);
    for (size_t j = 0; j < columns; j++) {
        const size_t old = (size_t)k * columns + j, low = (size_t)(2 * k) * columns + j;
        const size_t high = low + columns;
        double q[6];
        memcpy(to->lower + low * n, from->lower + old * n, n * sizeof *m);
        memcpy(to->upper + low * n, m + old * n, n * sizeof *m);
        memcpy(to->lower + high * n, m + old * n, n * sizeof *m);
        memcpy(to->upper + high * n, from->upper + old * n, n * sizeof *m);
        memcpy(to->rigid + low * r, from->rigid + old * r, r * sizeof *m);
        take_rigid(p, to->lower + high * n, q);
        see_from(t, height, turn, q, to->upper + high * n);
        doubling_tree_carry(t, height, turn, from->rigid + old * r, to->rigid + high * r);
        for (size_t i = 0; i < r; i++) {
            to->rigid[high * r + i] += q[i];
        }
    }
}

status slab_list_halve(const doubling_tree *t, int nwanted, const int *wanted, slab_list *list)
{
    status st = OK;
    const cut_part *p = &t->cut->part[t->part];
    slab_list next = {0};
    double *m = NULL;
    keep_wanted(p, nwanted, wanted, list);
    TRY(list_make(2 * list->count, list->ncolumn, p, &next));
    next.doublings = list->doublings - 1;
    TRY(TAKE(m, (size_t)list->count * (size_t)list->ncolumn * (size_t)p->n));
    TRY(middles(t, list, m));
    for (int k = 0; k < list->count; k++) {
        split(t, list, k, m, &next);
    }
    slab_list_free(list);
    *list = next;
    next = (slab_list){0};

done:
    free(m);
    slab_list_free(&next);
    return st;
}

// f = K u: with a = (u + w) / 2 and b = (u - w) / 2 the lower end feels P a + N b, the upper
// J (P a - N b)
status doubling_tree_forces(const doubling_tree *t, const slab_list *cells, double *lower,
                            double *upper)
{
    status st = OK;
    const cut_part *p = &t->cut->part[t->part];
    const int n = p->n, columns = cells->count * cells->ncolumn;
    const size_t all = (size_t)n * (size_t)columns;
    const double one = 1, none = 0;
    double *x = NULL;
    TRY(TAKE(x, 2 * all));
    for (size_t i = 0; i < all; i++) {
        const double u = cells->lower[i], v = cells->upper[i];
        const double w = (int)(i % (size_t)n) < p->neven ? v : -v;
        x[i] = (u + w) / 2;
        x[all + i] = (u - w) / 2;
    }
    const slab_stiffness *cell = t->grid > 0 ? &t->cell : &t->whole;
    dsymm_("L", "L", &n, &columns, &one, cell->P, &n, x, &n, &none, lower, &n);
    dsymm_("L", "L", &n, &columns, &one, cell->N, &n, x + all, &n, &none, upper, &n);
    for (size_t i = 0; i < all; i++) {
        const double a = lower[i], b = upper[i];
        lower[i] = a + b;
        upper[i] = (int)(i % (size_t)n) < p->neven ? a - b : b - a;
    }

done:
    free(x);
    return st;
}
