// reports/figure_reach.c
// The tissue from three sides as an X-ray shows it, with every scope's bodies in it.
#include "reports/figure_reach.h"
#include "reports/figures.h"

#include <math.h>
#include <stdio.h>

enum { RASTER = 420 };

static const double side = 28, head = 100, foot = 80, sheet_width = 1000, row_head = 40, gap = 22,
                    highest = 430, least_height = 200;

typedef struct reach_sheet {
    const run_result *r;
    reach_side side[REACH_VIEWS];
    double scale; // [points per m]
    int across;   // scopes side by side
    double width; // of a scope's three views with the gap after them [points]
    double row;   // height of a scope's row [points]
} reach_sheet;

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
        reach_panel_draw(&(reach_panel){c, r, s, v, at, w->scale, w->across > 1 ? 2.5 : 3.5});
        reach_axes(c, &v->view.camera, x + 10, y + w->row - gap - 16);
        x += width + gap;
    }
}

// returns where the next entry of the legend stands
static double told(canvas *c, double x, double y, const char *words)
{
    say(c, x, y, LOOK_SMALL, "%s", words);
    return x + canvas_text_width(c, &LOOK_SMALL, words) + 16;
}

// a piece of line and what it means
static double told_line(canvas *c, double x, double y, colour ink, double width, const char *words)
{
    canvas_segment(c, x, y - 4, x + 26, y - 4);
    canvas_stroke(c, ink, width);
    canvas_dash(c, 0, 0);
    return told(c, x + 32, y, words);
}

static void legend(canvas *c, double y)
{
    double x = side;
    canvas_circle(c, x + 5, y - 4, 3.4);
    canvas_fill(c, REACH_YES);
    x = told(c, x + 14, y, "target reached");
    reach_cross_path(c, (const double[2]){x + 4, y - 4}, 3.6);
    canvas_stroke(c, INK_ACCENT, 2);
    x = told(c, x + 14, y, "not reached");
    x = told_line(c, x, y, REACH_YES, 1.6, "body there");
    canvas_dash(c, 5, 3);
    x = told_line(c, x, y, REACH_NO, 1.3, "the best found where it is not reached");
    canvas_dash(c, 7, 3);
    (void)told_line(c, x, y, INK_SOFT, 0.9, "entry line; circle: entry; diamond: deepest");
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
    legend(c, end - 58);
    char words[512];
    (void)snprintf(words, sizeof words,
                   "Shading: the thickness of what the wall encloses, as an X-ray shows it. Left: "
                   "%s; middle: %s; right: %s. Numbers where there is room.%s",
                   reach_camera_name(0), reach_camera_name(1), reach_camera_name(2),
                   r->ntarget > REACH_BODIES ? " Not every body is drawn." : "");
    (void)say_paragraph(c, side, end - 36, sheet_width - 2 * side - 130, LOOK_SMALL, words);
    scale_bar(c, sheet_width - side, end - 12, 90, w->scale / 1e3);
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
