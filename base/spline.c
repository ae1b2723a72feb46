// base/spline.c
#include "base/spline.h"

#include "base/memory.h"

#include <math.h>

enum { MOST_ORDER = SPLINE_MAX_DEGREE + 1 };

// a diagonal of the triangle below this part of the largest is rounding
static const double singular = 1e-13;

void spline_free(spline *c)
{
    free(c->knot);
    free(c->coef);
    *c = (spline){0};
}

// the knot at whose right the piece of s begins
static int piece_of(const spline *c, double s)
{
    int low = c->degree, high = c->ncoef;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (s < c->knot[middle]) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return low;
}

// from the `degree` B-splines of one degree less that are not zero between the knots `piece` and
// piece + 1 to the degree + 1 of this one, in place
static void raise_degree(const double *knot, int piece, int degree, double s, double *b)
{
    double carry = 0;
    for (int i = 0; i < degree; i++) {
        const double right = knot[piece + 1 + i], left = knot[piece + 1 + i - degree];
        const double part = b[i] / (right - left);
        b[i] = carry + (right - s) * part;
        carry = (s - left) * part;
    }
    b[degree] = carry;
}

void spline_at(const spline *c, double s, double *value, double *slope)
{
    const int k = c->degree, piece = piece_of(c, s);
    const double *coef = c->coef + 2 * (piece - k);
    double b[MOST_ORDER] = {1};
    value[0] = value[1] = slope[0] = slope[1] = 0;
    for (int degree = 1; degree < k; degree++) {
        raise_degree(c->knot, piece, degree, s, b);
    }
    for (int i = 0; i < k; i++) {
        const double span = c->knot[piece + 1 + i] - c->knot[piece + 1 + i - k];
        slope[0] += k / span * b[i] * (coef[2 * i + 2] - coef[2 * i]);
        slope[1] += k / span * b[i] * (coef[2 * i + 3] - coef[2 * i + 1]);
    }
    if (k > 0) {
        raise_degree(c->knot, piece, k, s, b);
    }
    for (int i = 0; i <= k; i++) {
        value[0] += b[i] * coef[2 * i];
        value[1] += b[i] * coef[2 * i + 1];
    }
}

// --- fitting

// inner knots on points where the curve goes through all of them, else where each piece gets
// as many points as the others
static void lay_knots(int n, const double *point, int npiece, spline *c)
{
    const int k = c->degree;
    for (int i = 0; i <= k; i++) {
        c->knot[i] = point[0];
        c->knot[c->ncoef + i] = point[3 * (n - 1)];
    }
    for (int i = 1; i < npiece; i++) {
        const bool through = c->ncoef == n;
        const double place = through ? (k - 1) / 2.0 + i : (double)i * (n - 1) / npiece;
        const int before = (int)place < n - 2 ? (int)place : n - 2;
        const double a = point[3 * before], b = point[3 * (before + 1)];
        c->knot[k + i] = a + (place - before) * (b - a);
    }
}

// The triangle of the least squares, row after row with its `order` entries from the diagonal on,
// and the right-hand sides.
typedef struct triangle {
    int n, order;
    double *R;   // [n][order]
    double *rhs; // [n][2]
} triangle;

// One more equation, entries from column `first` on, by plane rotations; what is left of its right
// hand side is its residual.
static void rotate_in(triangle *t, int first, double *row, double side[2])
{
    for (int i = 0; i < t->order; i++) {
        double *R = t->R + (size_t)(first + i) * (size_t)t->order, *rhs = t->rhs + 2 * (first + i);
        const double size = hypot(R[0], row[i]);
        if (row[i] == 0) {
            continue;
        }
        const double c = R[0] / size, z = row[i] / size;
        R[0] = size;
        for (int j = 1; i + j < t->order; j++) {
            const double above = R[j];
            R[j] = c * above + z * row[i + j];
            row[i + j] = c * row[i + j] - z * above;
        }
        for (int d = 0; d < 2; d++) {
            const double above = rhs[d];
            rhs[d] = c * above + z * side[d];
            side[d] = c * side[d] - z * above;
        }
    }
}

static bool solve_back(const triangle *t, double *coef)
{
    double largest = 0;
    for (int i = 0; i < t->n; i++) {
        largest = fmax(largest, t->R[(size_t)i * (size_t)t->order]);
    }
    for (int i = t->n - 1; i >= 0; i--) {
        const double *R = t->R + (size_t)i * (size_t)t->order;
        if (!(R[0] > singular * largest)) {
            return false;
        }
        for (int d = 0; d < 2; d++) {
            double sum = t->rhs[2 * i + d];
            for (int j = 1; j < t->order && i + j < t->n; j++) {
                sum -= R[j] * coef[2 * (i + j) + d];
            }
            coef[2 * i + d] = sum / R[0];
        }
    }
    return true;
}

status spline_fit(int n, const double *point, int degree, int npiece, double *rms, spline *out)
{
    status st = OK;
    spline c = {.degree = degree, .ncoef = degree + npiece};
    triangle t = {.n = c.ncoef, .order = degree + 1};
    double squares = 0;
    if (degree < 0 || degree > SPLINE_MAX_DEGREE || npiece < 1 || c.ncoef > n) {
        TRY(status_fail(ERR_BUG, "spline of degree %d with %d pieces through %d points", degree,
                        npiece, n));
    }
    TRY(TAKE(c.knot, (size_t)(c.ncoef + degree + 1)));
    TRY(TAKE(c.coef, 2 * (size_t)c.ncoef));
    TRY(TAKE(t.R, (size_t)t.n * (size_t)t.order));
    TRY(TAKE(t.rhs, 2 * (size_t)t.n));
    lay_knots(n, point, npiece, &c);
    for (int i = 0; i < n; i++) {
        const double *p = point + 3 * (size_t)i;
        const int piece = piece_of(&c, p[0]);
        double row[MOST_ORDER] = {1}, side[2] = {p[1], p[2]};
        for (int k = 1; k <= degree; k++) {
            raise_degree(c.knot, piece, k, p[0], row);
        }
        rotate_in(&t, piece - degree, row, side);
        squares += side[0] * side[0] + side[1] * side[1];
    }
    if (!solve_back(&t, c.coef)) {
        TRY(status_fail(ERR_NUMERIC, "the points are too unevenly spaced for a spline"));
    }
    *rms = sqrt(squares / n);
    *out = c;
    c = (spline){0};

done:
    free(t.R);
    free(t.rhs);
    spline_free(&c);
    return st;
}
