// meshes/outline_move.c
#include "meshes/outline_move.h"

#include "base/memory.h"
#include "meshes/loops.h"
#include "meshes/outline.h"

#include <math.h>
#include <string.h>

static void move_point(const outline_motion *m, double *x)
{
    const double c = m->scale * cos(m->angle), s = m->scale * sin(m->angle);
    const double a = x[0], b = m->mirror ? -x[1] : x[1];
    x[0] = c * a - s * b;
    x[1] = s * a + c * b;
}

static double move_angle(const outline_motion *m, double angle)
{
    return (m->mirror ? -angle : angle) + m->angle;
}

// a mirror turns the sense of a loop around
static void reverse_loop(double (*point)[2], int n)
{
    for (int i = 0, j = n - 1; i < j; i++, j--) {
        const double x = point[i][0], y = point[i][1];
        memcpy(point[i], point[j], sizeof point[i]);
        point[j][0] = x;
        point[j][1] = y;
    }
}

static void move_curves(const outline_motion *m, curve_loop a)
{
    const double nowhere[2] = {0, 0};
    for (int i = 0; i < a.n; i++) {
        const carrier scaled = carrier_scaled(&a.piece[i], m->scale);
        a.piece[i] = carrier_moved(&scaled, m->angle, nowhere, m->mirror ? -1 : 1);
    }
    if (m->mirror) {
        curves_reverse(a);
    }
}

// axes of the section turn with it; a mirror has no meaning for them
static void move_frame(const outline_motion *m, outline *o)
{
    if ((m->angle != 0 || m->turning) && !o->has_frame) {
        o->frame = material_frame_make(0, 0);
        o->has_frame = true;
    }
    material_frame_move(&o->frame, m->scale, m->angle);
}

static void move_item(const outline_motion *m, outline *o)
{
    move_frame(m, o);
    move_point(m, o->centre);
    o->outer *= m->scale;
    o->inner *= m->scale;
    o->size[0] *= m->scale;
    o->size[1] *= m->scale;
    o->thickness *= m->scale;
    o->mid_angle = move_angle(m, o->mid_angle);
    o->angle = move_angle(m, o->angle);
    for (int k = 0; k < o->nloop && o->kind == KIND_LOOPS; k++) {
        move_curves(m, outline_curves(o, k));
    }
    for (int k = 0; k < o->nloop && o->kind == KIND_POLYGON; k++) {
        double(*point)[2] = (double(*)[2])(o->point + 2 * o->loop_start[k]);
        const int n = o->loop_start[k + 1] - o->loop_start[k];
        for (int i = 0; i < n; i++) {
            move_point(m, point[i]);
        }
        if (m->mirror) {
            reverse_loop(point, n);
        }
    }
}

void section_outline_move(section_outline *o, const outline_motion *motion)
{
    for (int k = 0; k < o->count; k++) {
        move_item(motion, &o->items[k]);
    }
    o->turn = move_angle(motion, o->turn);
    o->size *= motion->scale;
}

static status copy_loops(const outline *in, outline *out)
{
    status st = OK;
    const size_t npoint = in->nloop > 0 ? (size_t)in->loop_start[in->nloop] : 0;
    out->loop_start = NULL;
    out->point = NULL;
    out->piece = NULL;
    if (in->nloop > 0) {
        TRY(TAKE(out->loop_start, (size_t)in->nloop + 1));
        memcpy(out->loop_start, in->loop_start, ((size_t)in->nloop + 1) * sizeof *in->loop_start);
    }
    if (in->kind == KIND_POLYGON) {
        TRY(TAKE(out->point, 2 * npoint));
        memcpy(out->point, in->point, 2 * npoint * sizeof *in->point);
    }
    if (in->kind == KIND_LOOPS) {
        TRY(TAKE(out->piece, npoint));
        memcpy(out->piece, in->piece, npoint * sizeof *in->piece);
    }

done:
    return st;
}

status section_outline_copy(const section_outline *in, section_outline *out)
{
    status st = OK;
    section_outline o = *in;
    o.items = NULL;
    o.count = 0;
    TRY(TAKE(o.items, (size_t)in->count));
    for (int k = 0; k < in->count; k++) {
        o.items[k] = in->items[k];
        o.count++;
        TRY(copy_loops(&in->items[k], &o.items[k]));
    }
    *out = o;
    o = (section_outline){0};

done:
    section_outline_free(&o);
    return st;
}

// --- turning

// an angle seen so far must agree with the next one
typedef struct spin {
    double angle, tolerance;
    bool any, agree;
} spin;

static void see(spin *s, double angle)
{
    const double a = angle_fold(angle);
    s->agree = s->agree && (!s->any || fabs(angle_fold(a - s->angle)) <= s->tolerance);
    s->angle = s->any ? s->angle : a;
    s->any = true;
}

// the turn that carries points best from a to b, both about the origin
static double turn_of_points(int n, const double *a, const double *b)
{
    double cross = 0, dot = 0;
    for (int i = 0; i < n; i++) {
        cross += a[2 * i] * b[2 * i + 1] - a[2 * i + 1] * b[2 * i];
        dot += a[2 * i] * b[2 * i] + a[2 * i + 1] * b[2 * i + 1];
    }
    return atan2(cross, dot);
}

// the same of where curves begin
static double turn_of_pieces(int n, const carrier *a, const carrier *b)
{
    double cross = 0, dot = 0;
    for (int i = 0; i < n; i++) {
        double x[2], y[2];
        carrier_start(&a[i], x);
        carrier_start(&b[i], y);
        cross += x[0] * y[1] - x[1] * y[0];
        dot += x[0] * y[0] + x[1] * y[1];
    }
    return atan2(cross, dot);
}

// x and y of the three axes, as points
static double turn_of_axes(const material_frame *a, const material_frame *b)
{
    double from[6], to[6];
    for (int i = 0; i < 3; i++) {
        memcpy(from + 2 * i, a->axes.a[i], 2 * sizeof *from);
        memcpy(to + 2 * i, b->axes.a[i], 2 * sizeof *to);
    }
    return turn_of_points(3, from, to);
}

static void see_item(spin *s, const outline *a, const outline *b, double size)
{
    if (a->has_frame && b->has_frame && !a->frame.polar) {
        see(s, turn_of_axes(&a->frame, &b->frame));
    }
    const int n = a->nloop > 0 ? a->loop_start[a->nloop] : 0;
    if (n > 0) {
        see(s, a->kind == KIND_LOOPS ? turn_of_pieces(n, a->piece, b->piece)
                                     : turn_of_points(n, a->point, b->point));
        return;
    }
    if (hypot(a->centre[0], a->centre[1]) > OUTLINE_MERGE * size) {
        see(s, turn_of_points(1, a->centre, b->centre));
    }
    if (a->kind == KIND_SECTOR) {
        see(s, b->mid_angle - a->mid_angle);
    } else if (a->kind != KIND_ANNULUS && a->kind != KIND_DISC) {
        see(s, b->angle - a->angle);
    }
}

bool section_outline_spin(const section_outline *a, const section_outline *b, double tolerance,
                          double *angle)
{
    spin s = {.tolerance = tolerance, .agree = a->count == b->count};
    for (int k = 0; k < a->count && s.agree; k++) {
        const outline *p = &a->items[k], *q = &b->items[k];
        s.agree = p->kind == q->kind && p->nloop == q->nloop &&
                  (p->nloop == 0 || p->loop_start[p->nloop] == q->loop_start[q->nloop]);
        if (s.agree) {
            see_item(&s, p, q, a->size);
        }
    }
    *angle = s.any && s.agree ? s.angle : 0;
    return s.agree;
}
