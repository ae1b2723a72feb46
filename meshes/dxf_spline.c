// meshes/dxf_spline.c
#include "base/memory.h"
#include "meshes/dxf_entity.h"

#include <math.h>
#include <string.h>

enum { MOST_DEGREE = 3, RATIONAL = 4 };

// weights closer than this are all one
static const double SAME_WEIGHT = 1e-12;

typedef struct spline {
    int degree, npoint, nknot;
    double *knot;  // [nknot]
    double *point; // [npoint][2]
} spline;

static void spline_free(spline *s)
{
    free(s->knot);
    free(s->point);
    *s = (spline){0};
}

static status check_kind(const dxf_text *t, const dxf_entity *e, int degree)
{
    double low = INFINITY, high = -INFINITY;
    for (int i = 0; i < e->npair; i++) {
        if (e->pair[i].code == 41) {
            low = fmin(low, e->pair[i].value);
            high = fmax(high, e->pair[i].value);
        }
    }
    if (degree < 1 || degree > MOST_DEGREE) {
        return input_file_fail(t->file, e->line,
                               "SPLINE of degree %d; 1 to 3 are read, others must be converted to "
                               "degree 3",
                               degree);
    }
    if (low <= high && !(high - low <= SAME_WEIGHT * fabs(high))) {
        return input_file_fail(t->file, e->line,
                               "SPLINE with unequal weights; draw its arcs as arcs or convert it "
                               "to one without weights");
    }
    return OK;
}

static status check_knots(const dxf_text *t, const dxf_entity *e, const spline *s)
{
    const int p = s->degree;
    if (s->npoint < p + 1) {
        return input_file_fail(t->file, e->line,
                               "SPLINE of degree %d has %d control points; fit points alone do "
                               "not define it",
                               p, s->npoint);
    }
    if (s->nknot != s->npoint + p + 1) {
        return input_file_fail(t->file, e->line, "SPLINE has %d knots, %d are needed", s->nknot,
                               s->npoint + p + 1);
    }
    for (int i = 1; i < s->nknot; i++) {
        if (!(s->knot[i] >= s->knot[i - 1])) {
            return input_file_fail(t->file, e->line, "the knots of SPLINE do not ascend");
        }
    }
    for (int i = 1; i + p < s->nknot; i++) {
        const bool within = s->knot[i] > s->knot[p] && s->knot[i] < s->knot[s->npoint];
        if (within && s->knot[i + p] == s->knot[i]) {
            return input_file_fail(t->file, e->line, "SPLINE falls apart at a knot");
        }
    }
    return OK;
}

static status read_spline(const dxf_text *t, const dxf_entity *e, spline *s)
{
    status st = OK;
    int n = 0;
    s->degree = dxf_get_int(e, 71, 3);
    TRY(check_kind(t, e, s->degree));
    TRY(TAKE(s->knot, (size_t)dxf_count(e, 40)));
    TRY(TAKE(s->point, 2 * (size_t)dxf_count(e, 10)));
    for (int i = 0; i < e->npair; i++) {
        const dxf_pair *q = &e->pair[i];
        if (q->code == 40) {
            s->knot[s->nknot++] = q->value;
        } else if (q->code == 10) {
            s->point[2 * s->npoint++] = q->value;
        } else if (q->code == 20 && n < s->npoint) {
            s->point[2 * n++ + 1] = q->value;
        }
    }
    if (n != s->npoint) {
        TRY(input_file_fail(t->file, e->line, "a control point of SPLINE has no y"));
    }
    TRY(check_knots(t, e, s));

done:
    return st;
}

// The polar form on the interval of knots i, i + 1 at `degree` arguments (de Boor): the control
// points of the part as a Bezier curve are its values at the interval's ends, repeated.
static void polar_form(const spline *s, int i, const double *argument, double out[2])
{
    const int p = s->degree;
    double d[MOST_DEGREE + 1][2];
    for (int k = 0; k <= p; k++) {
        memcpy(d[k], s->point + 2 * (i - p + k), sizeof d[k]);
    }
    for (int r = 1; r <= p; r++) {
        for (int k = p; k >= r; k--) {
            const double left = s->knot[i - p + k], right = s->knot[i + 1 + k - r];
            const double a = (argument[r - 1] - left) / (right - left);
            d[k][0] = (1 - a) * d[k - 1][0] + a * d[k][0];
            d[k][1] = (1 - a) * d[k - 1][1] + a * d[k][1];
        }
    }
    memcpy(out, d[p], sizeof d[p]);
}

static carrier part_of(const spline *s, int i)
{
    const int p = s->degree;
    double b[MOST_DEGREE + 1][2], cubic[4][2];
    for (int k = 0; k <= p; k++) {
        double argument[MOST_DEGREE];
        for (int j = 0; j < p; j++) {
            argument[j] = s->knot[j < p - k ? i : i + 1];
        }
        polar_form(s, i, argument, b[k]);
    }
    if (p == 1) {
        return carrier_line(b[0], b[1]);
    }
    memcpy(cubic, b, sizeof cubic);
    for (int d = 0; d < 2 && p == 2; d++) { // raised to degree 3
        cubic[1][d] = (b[0][d] + 2 * b[1][d]) / 3;
        cubic[2][d] = (2 * b[1][d] + b[2][d]) / 3;
        cubic[3][d] = b[2][d];
    }
    return carrier_cubic(cubic[0]);
}

status dxf_spline_draw(const dxf_text *t, const dxf_entity *e, dxf_plan *p)
{
    status st = OK;
    spline s = {0};
    TRY(read_spline(t, e, &s));
    for (int i = s.degree; i < s.npoint; i++) {
        if (s.knot[i + 1] > s.knot[i]) {
            TRY(dxf_add_piece(t->file, p, part_of(&s, i)));
        }
    }
    if (p->chain[p->nchain - 1].count == 0) {
        TRY(input_file_fail(t->file, e->line, "all knots of SPLINE are one"));
    }

done:
    spline_free(&s);
    return st;
}
