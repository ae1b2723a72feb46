// reports/figure_reach_panel.c
// One scope's bodies in the tissue, seen from one side.
#include "reports/figure_reach.h"
#include "reports/rod_show.h"

#include <math.h>

enum { MOST_BODIES = REACH_BODIES, MOST_MARKS = 240, MOST_LABELS = 48, BODY_POINTS = 72 };

// what is far off, or no number, goes to somewhere off the panel: long dashed lines take long
static double near_by(double x, double from, double size)
{
    return fmin(fmax(x, from - 30 * size), from + 30 * size);
}

static void place(const reach_panel *p, const double m[3], double at[2])
{
    const vec3 seen = camera_see(&p->side->view.camera, reach_vec(m));
    const double x = p->scale * (seen.a[0] - p->side->low[0]),
                 y = p->scale * (seen.a[1] - p->side->low[1]);
    at[0] = near_by(p->at.x + x, p->at.x, p->at.w);
    at[1] = near_by(p->at.y + p->at.h - y, p->at.y, p->at.h);
}

// --- bodies: all of one look are one path, which keeps the file small

static void body_path(const reach_panel *p, const reach_answer *a)
{
    int point[BODY_POINTS];
    double at[BODY_POINTS][2];
    const int n = rod_spread(a->npoint, BODY_POINTS, point);
    for (int i = 0; i < n; i++) {
        place(p, a->point[point[i]], at[i]);
    }
    const int left = line_simplify(n, at, 0.15);
    for (int i = 0; i < left && left > 1; i++) {
        if (i == 0) {
            canvas_move(p->c, at[0][0], at[0][1]);
        } else {
            canvas_line(p->c, at[i][0], at[i][1]);
        }
    }
}

static void body_paths(const reach_panel *p, bool reached)
{
    int shown[MOST_BODIES];
    const int n = rod_spread(p->r->ntarget, MOST_BODIES, shown);
    for (int i = 0; i < n; i++) {
        const reach_answer *a = &p->scope->answer[shown[i]];
        if ((a->verdict == REACH_REACHED) == reached) {
            body_path(p, a);
        }
    }
}

// where a body that touches lies deepest
static void collision_path(const reach_panel *p, const reach_answer *a)
{
    const double r = p->mark;
    int k = 0;
    double at[2];
    if (a->verdict != REACH_COLLISION || a->npoint < 1) {
        return;
    }
    for (int i = 1; i < a->npoint; i++) {
        k = fabs(a->along[i] - a->s) < fabs(a->along[k] - a->s) ? i : k;
    }
    place(p, a->point[k], at);
    canvas_move(p->c, at[0] - r, at[1]);
    canvas_line(p->c, at[0], at[1] - r);
    canvas_line(p->c, at[0] + r, at[1]);
    canvas_line(p->c, at[0], at[1] + r);
    canvas_close(p->c);
}

static void draw_bodies(const reach_panel *p)
{
    int shown[MOST_BODIES];
    const int n = rod_spread(p->r->ntarget, MOST_BODIES, shown);
    body_paths(p, true);
    canvas_stroke(p->c, (colour){REACH_YES.r, REACH_YES.g, REACH_YES.b, 0.22},
                  fmin(2 * p->scale * p->scope->radius, p->at.w));
    body_paths(p, false);
    canvas_dash(p->c, 5, 3);
    canvas_stroke(p->c, REACH_NO, 1.1);
    canvas_dash(p->c, 0, 0);
    body_paths(p, true);
    canvas_stroke(p->c, REACH_YES, 1.3);
    for (int i = 0; i < n; i++) {
        collision_path(p, &p->scope->answer[shown[i]]);
    }
    canvas_fill_stroke(p->c, PAPER, INK_ACCENT, 1.3);
}

// --- targets

void reach_cross_path(canvas *c, const double at[2], double r)
{
    canvas_segment(c, at[0] - r, at[1] - r, at[0] + r, at[1] + r);
    canvas_segment(c, at[0] - r, at[1] + r, at[0] + r, at[1] - r);
}

static void mark_paths(const reach_panel *p, bool reached)
{
    int shown[MOST_MARKS];
    const int n = rod_spread(p->r->ntarget, MOST_MARKS, shown);
    for (int i = 0; i < n; i++) {
        double at[2];
        place(p, p->r->target[shown[i]], at);
        if ((p->scope->answer[shown[i]].verdict == REACH_REACHED) != reached) {
            continue;
        }
        if (reached) {
            canvas_circle(p->c, at[0], at[1], p->mark);
        } else {
            reach_cross_path(p->c, at, p->mark);
        }
    }
}

static void draw_marks(const reach_panel *p)
{
    mark_paths(p, false);
    canvas_stroke(p->c, PAPER, 1.2 * p->mark);
    mark_paths(p, false);
    canvas_stroke(p->c, INK_ACCENT, 0.6 * p->mark);
    mark_paths(p, true);
    canvas_fill_stroke(p->c, REACH_YES, PAPER, 1);
}

typedef struct labels {
    int n;
    double at[MOST_LABELS][2]; // middles
} labels;

// how much a label there would lie on targets and on the labels before it
static double crowd(const reach_panel *p, const labels *l, const double at[2])
{
    double sum = 0;
    for (int k = 0; k < p->r->ntarget; k++) {
        double mark_at[2];
        place(p, p->r->target[k], mark_at);
        sum += fmax(0, 9 - hypot(mark_at[0] - at[0], mark_at[1] - at[1]));
    }
    for (int k = 0; k < l->n; k++) {
        sum += 2 * fmax(0, 15 - hypot(l->at[k][0] - at[0], l->at[k][1] - at[1]));
    }
    return sum;
}

// two numbers there could not be read
static bool taken(const labels *l, const double at[2])
{
    for (int k = 0; k < l->n; k++) {
        if (fabs(l->at[k][0] - at[0]) < 15 && fabs(l->at[k][1] - at[1]) < 9) {
            return true;
        }
    }
    return false;
}

static void label(const reach_panel *p, int target, labels *l)
{
    const bool reached = p->scope->answer[target].verdict == REACH_REACHED;
    double mark_at[2], best[2] = {0, 0}, least = INFINITY;
    place(p, p->r->target[target], mark_at);
    for (int k = 0; k < 16; k++) {
        const double angle = acos(-1.0) * (k % 8) / 4, away = k < 8 ? 11 : 19;
        const double at[2] = {mark_at[0] + away * cos(angle), mark_at[1] - away * sin(angle)};
        const double sum = crowd(p, l, at) + (k < 8 ? 0 : 4);
        if (sum < least) {
            least = sum;
            best[0] = at[0];
            best[1] = at[1];
        }
    }
    if (taken(l, best)) {
        return;
    }
    if (hypot(best[0] - mark_at[0], best[1] - mark_at[1]) > 12) {
        canvas_segment(p->c, mark_at[0], mark_at[1], best[0], best[1]);
        canvas_stroke(p->c, INK_FAINT, 0.5);
    }
    text_look look =
        look_aligned(look_inked(LOOK_TICK, reached ? REACH_YES : INK_ACCENT), TEXT_CENTRE);
    say(p->c, best[0], best[1] + 4.5, look, "%d", target + 1);
    l->at[l->n][0] = best[0];
    l->at[l->n++][1] = best[1];
}

static void targets(const reach_panel *p)
{
    labels l = {0};
    draw_marks(p);
    for (int i = 0; i < p->r->ntarget && p->r->ntarget <= MOST_LABELS; i++) {
        label(p, i, &l);
    }
}

// --- a panel

static void entry_line(const reach_panel *p)
{
    const pose e = p->r->entry;
    const double reach = hypot(p->at.w, p->at.h) / p->scale;
    double from[2], to[2], at[2], back[3], ahead[3];
    for (int k = 0; k < 3; k++) {
        back[k] = e.p.a[k] - reach * e.R.a[k][2];
        ahead[k] = e.p.a[k] + reach * e.R.a[k][2];
    }
    place(p, back, from);
    place(p, ahead, to);
    place(p, e.p.a, at);
    if (hypot(to[0] - from[0], to[1] - from[1]) > 1) {
        canvas_segment(p->c, from[0], from[1], to[0], to[1]);
        canvas_dash(p->c, 7, 3);
        canvas_stroke(p->c, INK_SOFT, 0.9);
        canvas_dash(p->c, 0, 0);
    }
    canvas_circle(p->c, at[0], at[1], 3.4);
    canvas_fill_stroke(p->c, PAPER, INK, 1.3);
}

void reach_panel_draw(const reach_panel *p)
{
    const reach_side *s = p->side;
    canvas_clip(p->c, p->at.x, p->at.y, p->at.w, p->at.h);
    wall_shade_draw(p->c, &s->shade, p->at.x + p->scale * (s->view.low[0] - s->low[0]),
                    p->at.y + p->at.h - p->scale * (s->view.low[1] - s->low[1]),
                    p->scale * s->view.step);
    entry_line(p);
    draw_bodies(p);
    targets(p);
    canvas_unclip(p->c);
}
