// reach/bend_roots.c
// Where the tip is a given distance away from the line: x^2 + y^2 - rho^2 of a cell's cubics is a
// polynomial of degree 6 whose roots are isolated by the signs of its Bernstein coefficients: none
// is missed.                                                              docs/theory.md (10.3)
#include "reach/bend_sweep.h"

enum { DEGREE = 6, DEEPEST = 40 };

// A stretch on which the tip is that far away all along, to this, has one root [m]: a tip that
// never leaves its line has them everywhere.
static const double SAME = 1e-12;

typedef struct root_search {
    double from, width; // of the cell
    double flat;        // a distance's square that is off by less is off by less than SAME
    int most, count;
    double *u;
} root_search;

static void cubic_coefficients(const bend_node *a, const bend_node *b, int i, double c[4])
{
    const double h = (b->u - a->u) / 3;
    c[0] = a->tip.a[i];
    c[1] = a->tip.a[i] + h * a->slope.a[i];
    c[2] = b->tip.a[i] - h * b->slope.a[i];
    c[3] = b->tip.a[i];
}

// Bernstein coefficients of x^2 + y^2 - rho^2
static void squared_distance(const bend_node *a, const bend_node *b, double rho,
                             double c[DEGREE + 1])
{
    static const double choose3[4] = {1, 3, 3, 1}, choose6[7] = {1, 6, 15, 20, 15, 6, 1};
    for (int k = 0; k <= DEGREE; k++) {
        c[k] = -rho * rho;
    }
    for (int axis = 0; axis < 2; axis++) {
        double p[4];
        cubic_coefficients(a, b, axis, p);
        for (int i = 0; i < 4; i++) {
            for (int j = 0; j < 4; j++) {
                c[i + j] += choose3[i] * choose3[j] / choose6[i + j] * p[i] * p[j];
            }
        }
    }
}

static void halves(const double c[DEGREE + 1], double left[DEGREE + 1], double right[DEGREE + 1])
{
    double w[DEGREE + 1];
    for (int i = 0; i <= DEGREE; i++) {
        w[i] = c[i];
    }
    for (int k = 0; k <= DEGREE; k++) {
        left[k] = w[0];
        right[DEGREE - k] = w[DEGREE - k];
        for (int i = 0; i < DEGREE - k; i++) {
            w[i] = (w[i] + w[i + 1]) / 2;
        }
    }
}

static int sign_changes(const double c[DEGREE + 1])
{
    int n = 0;
    double last = 0;
    for (int i = 0; i <= DEGREE; i++) {
        if (c[i] != 0) {
            n += last != 0 && (c[i] < 0) != (last < 0);
            last = c[i];
        }
    }
    // a root at an end changes no sign
    return n + (c[0] == 0 || c[DEGREE] == 0);
}

static bool is_flat(const root_search *r, const double c[DEGREE + 1])
{
    bool flat = true;
    for (int i = 0; i <= DEGREE; i++) {
        flat = flat && c[i] <= r->flat && -c[i] <= r->flat;
    }
    return flat;
}

static void isolate(root_search *r, const double c[DEGREE + 1], double t, double width, int depth)
{
    const int n = sign_changes(c);
    if (n == 0 || r->count == r->most) {
        return;
    }
    // down to the last bits: a double root never parts
    if (depth == DEEPEST || is_flat(r, c)) {
        const double u = r->from + r->width * (t + width / 2);
        // one root on the border of two parts
        if (r->count == 0 || u - r->u[r->count - 1] > 2 * width * r->width) {
            r->u[r->count++] = u;
        }
        return;
    }
    double left[DEGREE + 1], right[DEGREE + 1];
    halves(c, left, right);
    isolate(r, left, t, width / 2, depth + 1);
    isolate(r, right, t + width / 2, width / 2, depth + 1);
}

int bend_sweep_roots(const bend_sweep *w, double rho, int most, double *u)
{
    root_search r = {.most = most, .u = u, .flat = SAME * (2 * rho + SAME)};
    for (int k = 0; k + 1 < w->nnode; k++) {
        double c[DEGREE + 1];
        r.from = w->node[k].u;
        r.width = w->node[k + 1].u - r.from;
        squared_distance(&w->node[k], &w->node[k + 1], rho, c);
        isolate(&r, c, 0, 1, 0);
    }
    return r.count;
}
