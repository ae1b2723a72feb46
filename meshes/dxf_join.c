// meshes/dxf_join.c
#include "base/memory.h"
#include "meshes/dxf.h"
#include "meshes/loops.h"
#include "meshes/outline.h"

#include <math.h>
#include <string.h>

// ends nearer than this part of the drawing are one: files have six digits or more
static const double JOINED = 1e-6;
// OpenCASCADE takes an end this near to its arc; what is further off bends the arc
static const double ARC_SLACK = 2e-8;

void dxf_loops_free(dxf_loops *l)
{
    for (int i = 0; l->loop && i < l->count; i++) {
        free(l->loop[i].piece);
        free(l->loop[i].line);
    }
    free(l->loop);
    *l = (dxf_loops){0};
}

static double distance(const double *a, const double *b)
{
    return hypot(a[0] - b[0], a[1] - b[1]);
}

// --- ends

// end 2 i is where chain i starts, 2 i + 1 where it ends
typedef struct ends {
    const input_file *f;
    const dxf_plan *p;
    double gap;
    double (*at)[2]; // [2 chains]
    int *partner;    // [2 chains]
} ends;

static void chain_middle(const dxf_plan *p, const dxf_chain *c, double x[2])
{
    const carrier *piece = &p->piece[c->first + c->count / 2];
    carrier_point(piece, piece->from + 0.37 * (piece->to - piece->from), x);
}

// 0.37 of the way is another place backwards: a chain of one piece is looked at from both sides
static bool is_same(const ends *w, int i, int j)
{
    const dxf_chain *a = &w->p->chain[i], *b = &w->p->chain[j];
    const bool same = distance(w->at[2 * i], w->at[2 * j]) <= w->gap &&
                      distance(w->at[2 * i + 1], w->at[2 * j + 1]) <= w->gap;
    const bool back = distance(w->at[2 * i], w->at[2 * j + 1]) <= w->gap &&
                      distance(w->at[2 * i + 1], w->at[2 * j]) <= w->gap;
    if (a->layer != b->layer || a->count != b->count || !(same || back)) {
        return false;
    }
    double x[2], t;
    chain_middle(w->p, a, x);
    for (int k = 0; k < b->count; k++) {
        const carrier *c = &w->p->piece[b->first + k];
        double y[2];
        if (carrier_distance(c, x, &t) <= w->gap) {
            // an ellipse is met outside of the arc too
            const double part = remainder(t - (c->from + c->to) / 2, 2 * 3.14159265358979323846);
            carrier_point(c, t, y);
            if (c->kind != CARRIER_ELLIPSE || fabs(part) <= fabs(c->to - c->from) / 2) {
                return true;
            }
        }
    }
    return false;
}

static status check_twice(const ends *w)
{
    for (int i = 0; i < w->p->nchain; i++) {
        for (int j = i + 1; j < w->p->nchain; j++) {
            if (is_same(w, i, j)) {
                return input_file_fail(w->f, w->p->chain[j].line,
                                       "the curve of line %ld is drawn again in layer '%s'",
                                       w->p->chain[i].line, w->p->layer[w->p->chain[i].layer]);
            }
        }
    }
    return OK;
}

static status find_partner(const ends *w, int end)
{
    const dxf_chain *own = &w->p->chain[end / 2];
    const char *layer = w->p->layer[own->layer];
    const double *x = w->at[end];
    double nearest = INFINITY;
    int count = 0;
    for (int k = 0; k < 2 * w->p->nchain; k++) {
        if (k == end || w->p->chain[k / 2].layer != own->layer) {
            continue;
        }
        const double d = distance(x, w->at[k]);
        nearest = fmin(nearest, d);
        if (d <= w->gap) {
            w->partner[end] = k;
            count++;
        }
    }
    if (count == 1) {
        return OK;
    }
    if (count > 1) {
        return input_file_fail(w->f, own->line,
                               "in layer '%s' more than two curves meet at (%.9g, %.9g)", layer,
                               x[0], x[1]);
    }
    return input_file_fail(w->f, own->line,
                           "in layer '%s' the outline is open at (%.9g, %.9g): the nearest other "
                           "end is %.3g away",
                           layer, x[0], x[1], nearest);
}

static status ends_make(const input_file *f, const dxf_plan *p, ends *w)
{
    status st = OK;
    const size_t n = 2 * (size_t)p->nchain;
    *w = (ends){.f = f, .p = p, .gap = JOINED * p->size};
    TRY(TAKE(w->at, n));
    TRY(TAKE(w->partner, n));
    for (int i = 0; i < p->nchain; i++) {
        const dxf_chain *c = &p->chain[i];
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
        for (int k = 0; k < c->count; k++) {
            double x[2];
            carrier_point(&p->piece[c->first + k],
                          (p->piece[c->first + k].from + p->piece[c->first + k].to) / 2, x);
            for (int d = 0; d < 2; d++) {
                low[d] = fmin(low[d], x[d]);
                high[d] = fmax(high[d], x[d]);
            }
        }
        carrier_start(&p->piece[c->first], w->at[2 * i]);
        carrier_end(&p->piece[c->first + c->count - 1], w->at[2 * i + 1]);
        const double extent = fmax(distance(low, high), distance(w->at[2 * i], w->at[2 * i + 1]));
        if (!(extent > 4 * w->gap)) {
            TRY(input_file_fail(f, c->line, "a curve at (%.9g, %.9g) has all but no length",
                                w->at[2 * i][0], w->at[2 * i][1]));
        }
    }
    TRY(check_twice(w));
    for (int end = 0; end < 2 * p->nchain; end++) {
        TRY(find_partner(w, end));
    }

done:
    return st;
}

// --- loops

// the loop through a chain, from its start; chains that it takes are marked
static status walk(const ends *w, int start, bool *taken, dxf_loop *out)
{
    status st = OK;
    dxf_loop l = {.layer = w->p->chain[start].layer};
    int count = 0, end = 2 * start;
    do {
        count += w->p->chain[end / 2].count;
        end = w->partner[end ^ 1];
    } while (end != 2 * start);
    TRY(TAKE(l.piece, (size_t)count));
    TRY(TAKE(l.line, (size_t)count));
    do {
        const dxf_chain *c = &w->p->chain[end / 2];
        taken[end / 2] = true;
        for (int k = 0; k < c->count; k++) {
            const bool back = end % 2;
            const carrier *piece = &w->p->piece[c->first + (back ? c->count - 1 - k : k)];
            l.line[l.n] = c->line;
            l.piece[l.n++] = back ? carrier_reversed(piece) : *piece;
        }
        end = w->partner[end ^ 1];
    } while (end != 2 * start);
    *out = l;
    l = (dxf_loop){0};

done:
    free(l.piece);
    free(l.line);
    return st;
}

// by how much the end of piece a and the start of b move to meet
static void meet(const carrier *a, const carrier *b, double slack, double by_end[2],
                 double by_start[2])
{
    double x[2], y[2];
    carrier_end(a, x);
    carrier_start(b, y);
    const bool arc[2] = {a->kind == CARRIER_ELLIPSE, b->kind == CARRIER_ELLIPSE};
    double part = arc[0] == arc[1] ? 0.5 : arc[0] ? 0 : 1; // of the way that a goes
    const bool leave = arc[0] && arc[1] && distance(x, y) <= slack;
    for (int k = 0; k < 2; k++) {
        by_end[k] = leave ? 0 : part * (y[k] - x[k]);
        by_start[k] = leave ? 0 : (1 - part) * (x[k] - y[k]);
    }
}

static void close_gaps(dxf_loop *l, double slack)
{
    double first[2] = {0, 0}, by_start[2] = {0, 0};
    // the first joint is that of the last piece with the first, whose start moves now and whose end
    // moves below
    double by_end[2], none[2] = {0, 0};
    meet(&l->piece[l->n - 1], &l->piece[0], slack, first, by_start);
    for (int i = 0; i < l->n; i++) {
        double next[2] = {0, 0};
        if (i + 1 < l->n) {
            meet(&l->piece[i], &l->piece[i + 1], slack, by_end, next);
        } else {
            memcpy(by_end, first, sizeof by_end);
        }
        const bool still =
            memcmp(by_start, none, sizeof none) == 0 && memcmp(by_end, none, sizeof none) == 0;
        l->piece[i] = still ? l->piece[i] : carrier_bent(&l->piece[i], by_start, by_end);
        memcpy(by_start, next, sizeof by_start);
    }
}

static void turn_round(dxf_loop *l)
{
    const curve_loop a = {.n = l->n, .piece = l->piece};
    l->area = curves_area(a);
    if (l->area < 0) {
        curves_reverse(a);
        for (int i = 0, j = l->n - 1; i < j; i++, j--) {
            const long line = l->line[i];
            l->line[i] = l->line[j];
            l->line[j] = line;
        }
        l->area = -l->area;
    }
}

static status check_alone(const ends *w, const dxf_loop *l, double gap, flat_loop *flat)
{
    status st = OK;
    int other = 0;
    TRY(curves_flatten((curve_loop){.n = l->n, .piece = l->piece}, gap, flat));
    const int edge = loop_self_contact(flat->corners, gap, &other);
    if (edge >= 0) {
        const double *x = flat->corners.p + 2 * (size_t)edge;
        TRY(input_file_fail(w->f, l->line[flat->piece[edge]],
                            "in layer '%s' the outline crosses or all but touches itself near "
                            "(%.9g, %.9g), at the curve of line %ld",
                            w->p->layer[l->layer], x[0], x[1], l->line[flat->piece[other]]));
    }

done:
    return st;
}

static status check_together(const ends *w, const dxf_loops *l, const flat_loop *flat)
{
    for (int i = 0; i < l->count; i++) {
        for (int j = 0; j < i; j++) {
            const dxf_loop *a = &l->loop[i], *b = &l->loop[j];
            const double gap = OUTLINE_SLIVER * sqrt(fmin(a->area, b->area));
            if (a->layer == b->layer && loops_touch(flat[i].corners, flat[j].corners, gap)) {
                return input_file_fail(w->f, a->line[0],
                                       "in layer '%s' this outline crosses or touches the one of "
                                       "line %ld",
                                       w->p->layer[a->layer], b->line[0]);
            }
        }
    }
    return OK;
}

static status check_loops(const ends *w, const dxf_loops *l)
{
    status st = OK;
    flat_loop *flat = NULL;
    TRY(TAKE(flat, (size_t)l->count));
    for (int i = 0; i < l->count; i++) {
        TRY(check_alone(w, &l->loop[i], OUTLINE_SLIVER * sqrt(l->loop[i].area), &flat[i]));
    }
    TRY(check_together(w, l, flat));

done:
    for (int i = 0; flat && i < l->count; i++) {
        flat_loop_free(&flat[i]);
    }
    free(flat);
    return st;
}

status dxf_join(const input_file *f, const dxf_plan *p, dxf_loops *out)
{
    status st = OK;
    ends w = {0};
    dxf_loops l = {0};
    bool *taken = NULL;
    TRY(ends_make(f, p, &w));
    TRY(TAKE(taken, (size_t)p->nchain));
    TRY(TAKE(l.loop, (size_t)p->nchain));
    for (int i = 0; i < p->nchain; i++) {
        if (!taken[i]) {
            TRY(walk(&w, i, taken, &l.loop[l.count]));
            close_gaps(&l.loop[l.count], ARC_SLACK * p->size);
            turn_round(&l.loop[l.count++]);
        }
    }
    TRY(check_loops(&w, &l));
    *out = l;
    l = (dxf_loops){0};

done:
    free(w.at);
    free(w.partner);
    free(taken);
    dxf_loops_free(&l);
    return st;
}
