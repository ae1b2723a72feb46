#include "meshes/pixel_smooth.h"

#include "base/memory.h"
#include "meshes/pixel_chain.h"

#include <math.h>
#include <string.h>

// The true boundary passes between the centres of the pixels on its two sides.
static const double most_shift = 0.5;
// Stiffness against bending that is tried, from the first down by this factor: waves shorter than
// 2 pi stiffness^(1/4) pixels are smoothed away, so from 200 to 4 pixels
static const double first_stiffness = 1 << 20, next_stiffness = 0.25, last_stiffness = 0.1;
// holds the ends of a chain
static const double end_weight = 1e6;
// Twice the area of the triangle at a corner of a pixel, 1 at first: with less than the former it
// is cut in two, with less than the latter it is bent back.
static const double least_corner = 0.4, least_triangle = 0.15;
// A closed chain is solved as an open one that runs on around for as many points: what its ends do
// does not reach so far.
enum { MOST_OVERLAP = 400, BAND = 3 };

typedef struct curve {
    int count, first; // points, of which those from `first` on are the chain's
    bool closed;
    double (*pixel)[2];  // [count] corners of pixels
    double (*at)[2];     // [count] where they go
    double (*row)[BAND]; // [count] diagonal and two below it, scratch
} curve;

static void curve_free(curve *c)
{
    free(c->pixel);
    free(c->at);
    free(c->row);
}

static status curve_make(const pixel_chain *chain, int width, curve *c)
{
    status st = OK;
    const int n = chain->count, overlap = n < MOST_OVERLAP ? n : MOST_OVERLAP;
    *c = (curve){.closed = chain->closed};
    c->first = chain->closed ? overlap : 0;
    c->count = n + 2 * c->first;
    TRY(TAKE(c->pixel, (size_t)c->count));
    TRY(TAKE(c->at, (size_t)c->count));
    TRY(TAKE(c->row, (size_t)c->count));
    for (int i = 0; i < c->count; i++) {
        const int point = chain->point[(i + n - c->first) % n];
        c->pixel[i][0] = point % width;
        c->pixel[i][1] = point / width;
    }

done:
    return st;
}

// adds weight |sum_k part_k x_(i+k) - what is wanted|^2 to what is minimised
static void add_term(curve *c, int i, int n, const double *part, double weight,
                     const double wanted[2])
{
    for (int a = 0; a < n; a++) {
        for (int b = 0; b <= a; b++) {
            c->row[i + a][a - b] += weight * part[a] * part[b];
        }
        for (int d = 0; d < 2; d++) {
            c->at[i + a][d] += weight * part[a] * wanted[d];
        }
    }
}

// row <- its Cholesky factor L, at <- L^-T L^-1 at
static void solve_band(curve *c)
{
    const int n = c->count;
    for (int i = 0; i < n; i++) {
        double *r = c->row[i];
        for (int k = i < BAND ? i : BAND - 1; k >= 0; k--) {
            for (int l = k + 1; l < BAND && l <= i; l++) {
                r[k] -= r[l] * c->row[i - k][l - k];
            }
            r[k] = k > 0 ? r[k] / c->row[i - k][0] : sqrt(r[0]);
        }
        for (int d = 0; d < 2; d++) {
            for (int k = 1; k < BAND && k <= i; k++) {
                c->at[i][d] -= r[k] * c->at[i - k][d];
            }
            c->at[i][d] /= r[0];
        }
    }
    for (int i = n - 1; i >= 0; i--) {
        for (int d = 0; d < 2; d++) {
            for (int k = 1; k < BAND && i + k < n; k++) {
                c->at[i][d] -= c->row[i + k][k] * c->at[i + k][d];
            }
            c->at[i][d] /= c->row[i][0];
        }
    }
}

// The smoothest curve near the middles of the pixels' sides: its points x minimise
// sum |(x_i + x_i+1) / 2 - middle_i|^2 + stiffness sum |x_i-1 - 2 x_i + x_i+1|^2.
static void smooth(curve *c, double stiffness)
{
    static const double mean[2] = {0.5, 0.5}, bend[3] = {1, -2, 1}, one[1] = {1}, zero[2] = {0, 0};
    const int n = c->count;
    memset(c->row, 0, (size_t)n * sizeof *c->row);
    memset(c->at, 0, (size_t)n * sizeof *c->at);
    for (int i = 0; i + 1 < n; i++) {
        const double *p = c->pixel[i], *q = c->pixel[i + 1];
        add_term(c, i, 2, mean, 1, (const double[2]){(p[0] + q[0]) / 2, (p[1] + q[1]) / 2});
    }
    for (int i = 0; i + 2 < n; i++) {
        add_term(c, i, 3, bend, stiffness, zero);
    }
    add_term(c, 0, 1, one, end_weight * stiffness, c->pixel[0]);
    add_term(c, n - 1, 1, one, end_weight * stiffness, c->pixel[n - 1]);
    solve_band(c);
}

// how far the curve leaves the middles of the pixels' sides, across them
static double farthest(const curve *c)
{
    double most = 0;
    for (int i = c->first; i + 1 < c->count - c->first + c->closed; i++) {
        const int across = c->pixel[i][0] == c->pixel[i + 1][0] ? 0 : 1;
        most = fmax(most, fabs(c->at[i][across] + c->at[i + 1][across] - c->pixel[i][across] -
                               c->pixel[i + 1][across]) /
                              2);
    }
    return most;
}

// moves all points across the curve by as much as keeps the area on its two sides
static void keep_area(curve *c)
{
    double area = 0, length = 0;
    for (int i = c->first; i + 1 < c->count - c->first + c->closed; i++) {
        const double *x = c->at[i], *y = c->at[i + 1], *p = c->pixel[i], *q = c->pixel[i + 1];
        area += (x[0] * y[1] - x[1] * y[0] - p[0] * q[1] + p[1] * q[0]) / 2;
        length += hypot(y[0] - x[0], y[1] - x[1]);
    }
    const double out = -area / length;
    double before[2] = {c->at[0][0], c->at[0][1]};
    for (int i = 1; i + 1 < c->count; i++) {
        const double t[2] = {c->at[i + 1][0] - before[0], c->at[i + 1][1] - before[1]};
        const double size = hypot(t[0], t[1]);
        before[0] = c->at[i][0];
        before[1] = c->at[i][1];
        if (size > 0) {
            c->at[i][0] += out * t[1] / size;
            c->at[i][1] -= out * t[0] / size;
        }
    }
}

static status smooth_chain(const pixel_chain *chain, int width, double *shift)
{
    status st = OK;
    curve c = {0};
    TRY(curve_make(chain, width, &c));
    for (double stiffness = first_stiffness; stiffness > last_stiffness;
         stiffness *= next_stiffness) {
        smooth(&c, stiffness);
        if (farthest(&c) <= most_shift) {
            break;
        }
    }
    keep_area(&c);
    for (int i = 0; i < chain->count; i++) {
        for (int d = 0; d < 2 && (chain->closed || (i > 0 && i + 1 < chain->count)); d++) {
            const double moved = c.at[i + c.first][d] - c.pixel[i + c.first][d];
            shift[2 * (long)chain->point[i] + d] = fmin(fmax(moved, -most_shift), most_shift);
        }
    }

done:
    curve_free(&c);
    return st;
}

// --- no pixel turns over

// twice the area of a triangle
static double area_of(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

cell_cut cell_cut_of(const double xy[4][2])
{
    double corner[4];
    for (int k = 0; k < 4; k++) {
        corner[k] = area_of(xy[k], xy[(k + 1) % 4], xy[(k + 3) % 4]);
    }
    // a cut between corners 0 and 2 leaves the corners 1 and 3 as triangles
    const double first = fmin(corner[1], corner[3]), second = fmin(corner[0], corner[2]);
    if (fmin(first, second) >= least_corner) {
        return CUT_NOT;
    }
    if (fmax(first, second) < least_triangle) {
        return CUT_FAILS;
    }
    return first >= second ? CUT_FIRST : CUT_SECOND;
}

// halves the shifts around pixels that are bent too far; false where there was none
static bool bend_back(const pixel_image *p, double *shift)
{
    bool any = false;
    for (int j = 0; j < p->n[1]; j++) {
        for (int i = 0; i < p->n[0]; i++) {
            double *low = shift + 2 * ((long)j * (p->n[0] + 1) + i);
            double *high = low + 2 * (p->n[0] + 1);
            double *const around[4] = {low, low + 2, high + 2, high};
            double xy[4][2];
            for (int k = 0; k < 4; k++) {
                xy[k][0] = (k == 1 || k == 2) + around[k][0];
                xy[k][1] = (k >= 2) + around[k][1];
            }
            if (pixel_at(p, i, j) == PIXEL_NONE ||
                cell_cut_of((const double(*)[2])xy) != CUT_FAILS) {
                continue;
            }
            any = true;
            for (int k = 0; k < 4; k++) {
                around[k][0] /= 2;
                around[k][1] /= 2;
            }
        }
    }
    return any;
}

status pixel_smooth(const pixel_image *p, double **shift)
{
    status st = OK;
    pixel_chains chains = {0};
    double *s = NULL;

    TRY(TAKE(s, 2 * ((size_t)p->n[0] + 1) * ((size_t)p->n[1] + 1)));
    TRY(pixel_chains_make(p, &chains));
    for (int i = 0; i < chains.count; i++) {
        TRY(smooth_chain(&chains.chain[i], p->n[0] + 1, s));
    }
    while (bend_back(p, s)) {
    }
    *shift = s;
    s = NULL;

done:
    pixel_chains_free(&chains);
    free(s);
    return st;
}
