// reports/figure_reach.c
// The tissue from three sides as an X-ray shows it, with every scope's bodies in it.
#include "reports/figure_reach.h"
#include "reports/figures.h"
#include "reports/rod_show.h"

#include <math.h>
#include <stdio.h>

enum { RASTER = 420, MOST_BODIES = 40, MOST_MARKS = 240, MOST_LABELS = 48, BODY_POINTS = 72 };

static const double side = 28, head = 100, foot = 60, sheet_width = 1040, row_head = 40, gap = 22,
                    highest = 430, least_height = 260;

typedef struct reach_side {
    wall_view view;
    wall_shade shade;
    double low[2], high[2]; // what is shown [m]
} reach_side;

typedef struct reach_sheet {
    const run_result *r;
    reach_side side[REACH_VIEWS];
    double scale; // [points per m]
    int across;   // scopes side by side
    double width; // of a scope's three views with the gap after them [points]
    double row;   // height of a scope's row [points]
} reach_sheet;

// one view of one scope on paper
typedef struct reach_panel {
    canvas *c;
    const reach_result *r;
    const reach_scope_result *scope;
    const reach_side *side;
    box at;
    double scale;
} reach_panel;

static void place(const reach_panel *p, const double m[3], double at[2])
{
    const vec3 seen = camera_see(&p->side->view.camera, reach_vec(m));
    at[0] = p->at.x + p->scale * (seen.a[0] - p->side->low[0]);
    at[1] = p->at.y + p->at.h - p->scale * (seen.a[1] - p->side->low[1]);
}

// --- bodies

static void body_path(const reach_panel *p, const reach_answer *a)
{
    int point[BODY_POINTS];
    const int n = rod_spread(a->npoint, BODY_POINTS, point);
    for (int i = 0; i < n; i++) {
        double at[2];
        place(p, a->point[point[i]], at);
        if (i == 0) {
            canvas_move(p->c, at[0], at[1]);
        } else {
            canvas_line(p->c, at[0], at[1]);
        }
    }
}

static void draw_body(const reach_panel *p, const reach_answer *a)
{
    const bool reached = a->verdict == REACH_REACHED;
    const colour ink = reached ? REACH_YES : REACH_NO;
    if (a->npoint < 2) {
        return;
    }
    if (reached) {
        body_path(p, a);
        canvas_stroke(p->c, (colour){ink.r, ink.g, ink.b, 0.10}, 2 * p->scale * p->scope->radius);
    }
    body_path(p, a);
    if (!reached) {
        canvas_dash(p->c, 5, 3);
    }
    canvas_stroke(p->c, ink, reached ? 1.4 : 1.1);
    canvas_dash(p->c, 0, 0);
}

// where a body that touches lies deepest
static void collision(const reach_panel *p, const reach_answer *a)
{
    static const double r = 3.6;
    int k = 0;
    if (a->verdict != REACH_COLLISION || a->npoint < 1) {
        return;
    }
    for (int i = 1; i < a->npoint; i++) {
        k = fabs(a->along[i] - a->s) < fabs(a->along[k] - a->s) ? i : k;
    }
    double at[2];
    place(p, a->point[k], at);
    canvas_move(p->c, at[0] - r, at[1]);
    canvas_line(p->c, at[0], at[1] - r);
    canvas_line(p->c, at[0] + r, at[1]);
    canvas_line(p->c, at[0], at[1] + r);
    canvas_close(p->c);
    canvas_fill_stroke(p->c, (colour){1, 1, 1, 1}, INK_ACCENT, 1.3);
}

// --- targets

static void cross(canvas *c, const double at[2], double r, colour ink, double width)
{
    canvas_segment(c, at[0] - r, at[1] - r, at[0] + r, at[1] + r);
    canvas_segment(c, at[0] - r, at[1] + r, at[0] + r, at[1] - r);
    canvas_stroke(c, ink, width);
}

static void draw_mark(const reach_panel *p, int target)
{
    double at[2];
    place(p, p->r->target[target], at);
    if (p->scope->answer[target].verdict == REACH_REACHED) {
        canvas_circle(p->c, at[0], at[1], 3.4);
        canvas_fill_stroke(p->c, REACH_YES, (colour){1, 1, 1, 1}, 1);
    } else {
        cross(p->c, at, 3.6, (colour){1, 1, 1, 1}, 4);
        cross(p->c, at, 3.6, INK_ACCENT, 2);
    }
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
        sum += 2 * fmax(0, 12 - hypot(l->at[k][0] - at[0], l->at[k][1] - at[1]));
    }
    return sum;
}

static void label(const reach_panel *p, int target, labels *l)
{
    const bool reached = p->scope->answer[target].verdict == REACH_REACHED;
    double mark_at[2], best[2] = {0, 0}, least = INFINITY;
    place(p, p->r->target[target], mark_at);
    for (int k = 0; k < 16; k++) {
        const double angle = acos(-1.0) * (k % 8) / 4, away = k < 8 ? 10 : 17;
        const double at[2] = {mark_at[0] + away * cos(angle), mark_at[1] - away * sin(angle)};
        const double sum = crowd(p, l, at) + (k < 8 ? 0 : 4);
        if (sum < least) {
            least = sum;
            best[0] = at[0];
            best[1] = at[1];
        }
    }
    if (hypot(best[0] - mark_at[0], best[1] - mark_at[1]) > 12) {
        canvas_segment(p->c, mark_at[0], mark_at[1], best[0], best[1]);
        canvas_stroke(p->c, INK_FAINT, 0.5);
    }
    text_look look =
        look_aligned(look_inked(LOOK_TICK, reached ? REACH_YES : INK_ACCENT), TEXT_CENTRE);
    look.size = 9;
    look.style = TEXT_BOLD;
    say(p->c, best[0], best[1] + 3.2, look, "%d", target + 1);
    l->at[l->n][0] = best[0];
    l->at[l->n++][1] = best[1];
}

static void targets(const reach_panel *p)
{
    int shown[MOST_MARKS];
    labels l = {0};
    const int n = rod_spread(p->r->ntarget, MOST_MARKS, shown);
    for (int i = 0; i < n; i++) {
        draw_mark(p, shown[i]);
    }
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
    canvas_fill_stroke(p->c, (colour){1, 1, 1, 1}, INK, 1.3);
}

static void panel(const reach_panel *p)
{
    const reach_side *s = p->side;
    int shown[MOST_BODIES];
    const int n = rod_spread(p->r->ntarget, MOST_BODIES, shown);
    canvas_clip(p->c, p->at.x, p->at.y, p->at.w, p->at.h);
    wall_shade_draw(p->c, &s->shade, p->at.x + p->scale * (s->view.low[0] - s->low[0]),
                    p->at.y + p->at.h - p->scale * (s->view.low[1] - s->low[1]),
                    p->scale * s->view.step);
    entry_line(p);
    for (int reached = 0; reached < 2; reached++) {
        for (int i = 0; i < n; i++) {
            const reach_answer *a = &p->scope->answer[shown[i]];
            if ((a->verdict == REACH_REACHED) == reached) {
                draw_body(p, a);
                collision(p, a);
            }
        }
    }
    targets(p);
    canvas_unclip(p->c);
}

static void row(canvas *c, const reach_sheet *w, int scope)
{
    const reach_result *r = &w->r->reach;
    const reach_scope_result *s = &r->scope[scope];
    const double left = side + w->width * (scope % w->across),
                 y = head + w->row * (scope / w->across);
    const double room = w->across > 1 ? w->width - gap : sheet_width - 2 * side;
    char count[REACH_TEXT], words[REACH_TEXT + 2 * REACH_NAME];
    (void)snprintf(words, sizeof words, "%s: %s", s->name, reach_count_words(r, scope, count));
    say_within(c, left, y, room, LOOK_HEADING, words);
    (void)snprintf(words, sizeof words, "%s, %s mm long, %s mm thick", s->kind,
                   number_short(1e3 * s->length, 4).text, number_short(2e3 * s->radius, 4).text);
    say_within(c, left, y + 16, room, LOOK_SMALL, words);
    double x = left;
    for (int k = 0; k < REACH_VIEWS; k++) {
        const reach_side *v = &w->side[k];
        const double width = w->scale * (v->high[0] - v->low[0]),
                     height = w->scale * (v->high[1] - v->low[1]);
        const box at = {x, y + row_head - 12 + (w->row - row_head - gap - height) / 2, width,
                        height};
        panel(&(reach_panel){c, r, s, v, at, w->scale});
        reach_axes(c, &v->view.camera, x + 10, y + w->row - gap - 16);
        x += width + gap;
    }
}

static void legend(canvas *c, double y)
{
    const double at[2] = {side + 110, y - 4};
    canvas_circle(c, side + 5, y - 4, 3.4);
    canvas_fill(c, REACH_YES);
    say(c, side + 14, y, LOOK_SMALL, "target reached");
    cross(c, at, 3.6, INK_ACCENT, 2);
    say(c, side + 119, y, LOOK_SMALL, "not reached");
    canvas_segment(c, side + 196, y - 4, side + 222, y - 4);
    canvas_stroke(c, REACH_YES, 1.6);
    say(c, side + 228, y, LOOK_SMALL, "body there");
    canvas_segment(c, side + 300, y - 4, side + 326, y - 4);
    canvas_dash(c, 5, 3);
    canvas_stroke(c, REACH_NO, 1.3);
    say(c, side + 332, y, LOOK_SMALL, "the best found where it is not reached");
    canvas_segment(c, side + 550, y - 4, side + 576, y - 4);
    canvas_dash(c, 7, 3);
    canvas_stroke(c, INK_SOFT, 0.9);
    canvas_dash(c, 0, 0);
    say(c, side + 582, y, LOOK_SMALL, "entry line; circle: entry; diamond: deepest in tissue");
}

static double sheet_height(const reach_sheet *w)
{
    return head + w->row * ((w->r->reach.nscope + w->across - 1) / w->across) + foot;
}

static status draw(canvas *c, const void *data)
{
    const reach_sheet *w = data;
    const reach_result *r = &w->r->reach;
    const double end = sheet_height(w);
    say(c, side, 36, LOOK_TITLE, "Which targets each scope reaches");
    say_within(c, side, 56, sheet_width - 2 * side, LOOK_SMALL, w->r->title);
    reach_source_line(c, side, 72, sheet_width - 2 * side, w->r);
    for (int i = 0; i < r->nscope; i++) {
        row(c, w, i);
    }
    legend(c, end - 38);
    say(c, side, end - 16, LOOK_SMALL,
        "Shading: the thickness of what the wall encloses, as an "
        "X-ray shows it. Left: %s; middle: %s; right: %s.%s",
        reach_camera_name(0), reach_camera_name(1), reach_camera_name(2),
        r->ntarget > MOST_BODIES ? " Not every body is drawn." : "");
    scale_bar(c, sheet_width - side, end - 38, 90, w->scale / 1e3);
    return OK;
}

// --- what is shown

static void widen(reach_side *s, vec3 p, double most)
{
    const vec3 seen = camera_see(&s->view.camera, p);
    for (int d = 0; d < 2; d++) {
        // what lies far off does not make the tissue small
        if (seen.a[d] > s->low[d] - most && seen.a[d] < s->high[d] + most) {
            s->low[d] = fmin(s->low[d], seen.a[d]);
            s->high[d] = fmax(s->high[d], seen.a[d]);
        }
    }
}

static void frame(const reach_result *r, reach_side *s)
{
    const wall_view *v = &s->view;
    const double most = 0.25 * v->step * RASTER, rim = 12 * v->step;
    for (int d = 0; d < 2; d++) {
        s->low[d] = v->low[d];
        s->high[d] = v->low[d] + v->step * ((d ? v->ny : v->nx) - 1);
    }
    widen(s, r->entry.p, most);
    for (int k = 0; k < r->ntarget; k++) {
        widen(s, reach_vec(r->target[k]), most);
    }
    for (int d = 0; d < 2; d++) {
        s->low[d] -= rim;
        s->high[d] += rim;
    }
}

static status make_sides(reach_sheet *w)
{
    status st = OK;
    const reach_result *r = &w->r->reach;
    wall tissue = {0};
    double width = 0, height = 0;
    TRY(wall_make(r->nvertex, (const double(*)[3])r->vertex, r->ntriangle,
                  (const int(*)[3])r->triangle, &tissue));
    for (int k = 0; k < REACH_VIEWS; k++) {
        reach_side *s = &w->side[k];
        const camera c = reach_camera(k);
        TRY(wall_view_make(&tissue, &c, RASTER, &s->view));
        // with many scopes every panel tells less
        TRY(wall_shade_make(&s->view,
                            r->nscope <= 4   ? SHADES
                            : r->nscope <= 8 ? 2
                                             : 0,
                            0.35, &s->shade));
        frame(r, s);
        width += s->high[0] - s->low[0];
        height = fmax(height, s->high[1] - s->low[1]);
    }
    const double room = sheet_width - 2 * side;
    const double half = (room + gap) / 2 - REACH_VIEWS * gap;
    w->across = r->nscope > 1 && half / width * height > least_height ? 2 : 1;
    w->width = w->across > 1 ? (room + gap) / 2 : room + gap;
    w->scale = fmin((w->width - REACH_VIEWS * gap) / width, highest / height);
    w->row = row_head + gap + w->scale * height;

done:
    wall_free(&tissue);
    return st;
}

static void free_sides(reach_sheet *w)
{
    for (int k = 0; k < REACH_VIEWS; k++) {
        wall_view_free(&w->side[k].view);
        wall_shade_free(&w->side[k].shade);
    }
}

status figure_reach(const run_result *r, const char *dir)
{
    status st = OK;
    reach_sheet w = {.r = r};
    if (!r->reach.there || r->reach.nscope < 1) {
        return OK;
    }
    TRY(make_sides(&w));
    if (isfinite(w.row) && w.row > 0) {
        const picture p = {
            .name = "reach",
            .title = "The tissue from three sides with targets and every scope's bodies",
            .width = sheet_width,
            .height = sheet_height(&w),
            .draw = draw,
            .data = &w,
        };
        TRY(picture_write(&p, dir));
    }

done:
    free_sides(&w);
    return st;
}
