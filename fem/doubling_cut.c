// fem/doubling_cut.c
#include "fem/doubling_cut.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

static void part_free(cut_part *p)
{
    free(p->R);
    free(p->index);
    free(p->share);
    free(p->axial);
    *p = (cut_part){0};
}

void cut_free(cut *c)
{
    for (int k = 0; k < CUT_MOST_PARTS; k++) {
        part_free(&c->part[k]);
    }
    *c = (cut){0};
}

// the group of up to three involutions, one bit each; J is the first
typedef struct group {
    int count; // of involutions
    const involution *of[3];
} group;

static int group_image(const group *g, int element, int node)
{
    for (int k = 0; k < g->count; k++) {
        node = element >> k & 1 && g->of[k]->image ? g->of[k]->image[node] : node;
    }
    return node;
}

// sign of an element on a direction, times its character: bit k of `odd` says that involution k is
// -1
static double group_sign(const group *g, int element, int direction, int odd)
{
    double sign = 1;
    for (int k = 0; k < g->count; k++) {
        if (element >> k & 1) {
            sign *= g->of[k]->sign[direction] * (odd >> k & 1 ? -1 : 1);
        }
    }
    return sign;
}

// One unknown: the motion of a node's orbit with the given character. False where there is none, or
// where the orbit has an earlier node.
static bool add_orbit(const group *g, int node, int direction, int odd, int unknown, cut_part *p)
{
    int to[8], count = 0;
    double sum[8] = {0}, norm = 0;
    for (int e = 0; e < 1 << g->count; e++) {
        const int image = group_image(g, e, node);
        int k = 0;
        while (k < count && to[k] != image) {
            k++;
        }
        if (image < node) {
            return false;
        }
        count = k == count ? count + 1 : count;
        to[k] = image;
        sum[k] += group_sign(g, e, direction, odd);
    }
    for (int k = 0; k < count; k++) {
        norm += sum[k] * sum[k];
    }
    for (int k = 0; k < count && norm > 0; k++) {
        const size_t at = 2 * (3 * (size_t)to[k] + (size_t)direction) + (size_t)(odd & 1);
        p->index[at] = unknown;
        p->share[at] = sum[k] / sqrt(norm);
    }
    return norm > 0;
}

static void number_unknowns(const cut *c, const group *g, int odd, cut_part *p)
{
    for (int i = 0; i < 6 * c->nplane; i++) {
        p->index[i] = -1;
    }
    for (int reversed = 0; reversed < 2; reversed++) {
        for (int i = 0; i < 3 * c->nplane; i++) {
            if (add_orbit(g, i / 3, i % 3, 2 * odd + reversed, p->n, p)) {
                p->axial[p->n++] = i % 3 == 2;
            }
        }
        p->neven = reversed ? p->neven : p->n;
    }
}

// direction d of rigid motion j at (a, b) from the centre
static double rigid(int j, int d, double a, double b)
{
    const double motion[6][3] = {{1, 0, 0}, {0, 1, 0},  {0, 0, 1},
                                 {0, 0, b}, {0, 0, -a}, {-b, a, 0}};
    return motion[j][d];
}

// R x unknowns of rigid motion j; returns the part of its norm that lies in this part of the cut
static double project(const cut *c, const mesh *plane, const cut_part *p, int j, double *row)
{
    const double cosine = cos(c->angle), sine = sin(c->angle);
    double all = 0, here = 0;
    memset(row, 0, (size_t)p->n * sizeof *row);
    for (int i = 0; i < 3 * c->nplane; i++) {
        const double *x = plane->xyz + 3 * (size_t)(i / 3);
        const double dx = x[0] - c->centre[0], dy = x[1] - c->centre[1];
        const double value = rigid(j, i % 3, cosine * dx + sine * dy, cosine * dy - sine * dx);
        for (int k = 2 * i; k < 2 * i + 2; k++) {
            if (p->index[k] >= 0) {
                row[p->index[k]] += p->share[k] * value;
            }
        }
        all += value * value;
    }
    for (int i = 0; i < p->n; i++) {
        here += row[i] * row[i];
    }
    return all > 0 ? here / all : 0;
}

// Where unknowns i and j change places.
static void exchange(const cut *c, cut_part *p, int i, int j)
{
    for (int k = 0; k < 6 * c->nplane; k++) {
        p->index[k] = p->index[k] == i ? j : p->index[k] == j ? i : p->index[k];
    }
    for (int k = 0; k < p->nrigid; k++) {
        double *row = p->R + (size_t)k * (size_t)p->n, keep = row[i];
        row[i] = row[j];
        row[j] = keep;
    }
    const bool keep = p->axial[i];
    p->axial[i] = p->axial[j];
    p->axial[j] = keep;
}

// Elimination with full pivoting of the rigid motions first <= k < last, whose pins go to the front
// of the unknowns from `begin` on. work: [last - first][n] their copies, destroyed.
static status pin(const cut *c, cut_part *p, int first, int last, int begin, double *work)
{
    const size_t n = (size_t)p->n;
    for (int k = first; k < last; k++) {
        int best = k, pivot = -1;
        double most = 0;
        for (int r = k; r < last; r++) {
            for (int i = begin + k - first; i < p->n; i++) {
                const double size = fabs(work[(size_t)r * n + (size_t)i]);
                if (size > most) {
                    most = size;
                    best = r;
                    pivot = i;
                }
            }
        }
        if (!(most > 1e-6)) {
            return status_fail(ERR_INPUT, "segment: the section has no extent");
        }
        const int to = begin + k - first;
        exchange(c, p, pivot, to);
        for (int r = first; r < last; r++) {
            double *row = work + (size_t)r * n, keep = row[pivot];
            row[pivot] = row[to];
            row[to] = keep;
        }
        for (size_t i = 0; i < n && best != k; i++) {
            const double keep = work[(size_t)k * n + i];
            work[(size_t)k * n + i] = work[(size_t)best * n + i];
            work[(size_t)best * n + i] = keep;
        }
        for (int r = k + 1; r < last; r++) {
            const double factor =
                work[(size_t)r * n + (size_t)to] / work[(size_t)k * n + (size_t)to];
            for (size_t i = 0; i < n; i++) {
                work[(size_t)r * n + i] -= factor * work[(size_t)k * n + i];
            }
        }
    }
    return OK;
}

// weights of the unknowns from those of their nodes
static void weigh(const cut *c, const cut_part *p, const double *weight, double *out)
{
    for (int i = 0; i < 6 * c->nplane; i++) {
        if (p->index[i] >= 0) {
            out[p->index[i]] = weight[i / 6];
        }
    }
}

// the rigid motions that this part has: those that J keeps first
static status find_rigid(const cut *c, const mesh *plane, const double *weight, cut_part *p)
{
    status st = OK;
    double *work = NULL, *row = NULL;
    int split = 0;
    TRY(TAKE(p->R, 6 * (size_t)p->n));
    TRY(TAKE(work, 6 * (size_t)p->n));
    TRY(TAKE(row, (size_t)p->n));
    for (int reversed = 0; reversed < 2; reversed++) {
        for (int j = 0; j < 6; j++) {
            const double along =
                j < 3 ? c->sign[j] : c->sign[0] * c->sign[1] * c->sign[2] * c->sign[j - 3];
            if ((along < 0) == (reversed == 1) && project(c, plane, p, j, row) > 0.5) {
                memcpy(p->R + (size_t)p->nrigid * (size_t)p->n, row, (size_t)p->n * sizeof *row);
                p->rigid[p->nrigid++] = j;
            }
        }
        split = reversed ? split : p->nrigid;
    }
    weigh(c, p, weight, row);
    for (int k = 0; k < p->nrigid; k++) {
        double most = 0;
        const double *R = p->R + (size_t)k * (size_t)p->n;
        for (int i = 0; i < p->n; i++) {
            most = fmax(most, fabs(R[i]) * row[i]);
        }
        for (int i = 0; i < p->n; i++) {
            work[(size_t)k * (size_t)p->n + (size_t)i] = R[i] * row[i] / most;
        }
        p->at[k] = k < split ? k : p->neven + k - split;
    }
    TRY(pin(c, p, 0, split, 0, work));
    TRY(pin(c, p, split, p->nrigid, p->neven, work));

done:
    free(work);
    free(row);
    return st;
}

status cut_make(const mesh *plane, const plane_symmetry *s, const involution *reversal, int nplain,
                const involution *plain, const double *weight, cut *out)
{
    status st = OK;
    cut c = {.nplane = plane->nnode,
             .centre = {s->centre[0], s->centre[1]},
             .angle = s->angle,
             .npart = 1 << nplain};
    group g = {.count = 1 + nplain, .of = {reversal}};
    const size_t dofs = 3 * (size_t)plane->nnode;
    memcpy(c.sign, reversal->sign, sizeof c.sign);
    for (int k = 0; k < nplain; k++) {
        g.of[1 + k] = plain + k;
    }
    for (int k = 0; k < c.npart; k++) {
        cut_part *p = &c.part[k];
        TRY(TAKE(p->index, 2 * dofs));
        TRY(TAKE(p->share, 2 * dofs));
        TRY(TAKE(p->axial, dofs + 1));
        number_unknowns(&c, &g, k, p);
        TRY(find_rigid(&c, plane, weight, p));
    }
    *out = c;
    c = (cut){0};

done:
    cut_free(&c);
    return st;
}

void cut_force(const cut *c, int part, const double *f, double *g)
{
    const cut_part *p = &c->part[part];
    double q[6] = {0};
    memset(g, 0, (size_t)p->n * sizeof *g);
    for (int i = 0; i < 6 * c->nplane; i++) {
        if (p->index[i] >= 0) {
            g[p->index[i]] += p->share[i] * f[i / 2];
        }
    }
    for (int k = 0; k < p->nrigid; k++) {
        for (int i = 0; i < p->n; i++) {
            q[k] += p->R[(size_t)k * (size_t)p->n + (size_t)i] * g[i];
        }
    }
    for (int k = 0; k < p->nrigid; k++) {
        g[p->at[k]] = q[k];
    }
}

// the motion of an unknown, pins included
static double unknown_motion(const cut_part *p, const double *x, int i)
{
    double u = x[i];
    for (int k = 0; k < p->nrigid; k++) {
        u = p->at[k] == i ? 0 : u;
    }
    for (int k = 0; k < p->nrigid; k++) {
        u += p->R[(size_t)k * (size_t)p->n + (size_t)i] * x[p->at[k]];
    }
    return u;
}

void cut_motion(const cut *c, int part, const double *x, double *u)
{
    const cut_part *p = &c->part[part];
    for (int i = 0; i < 6 * c->nplane; i++) {
        if (p->index[i] >= 0) {
            u[i / 2] += p->share[i] * unknown_motion(p, x, p->index[i]);
        }
    }
}
