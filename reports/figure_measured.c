// reports/figure_measured.c
// The model's shapes over the measured ones, from three sides, as the paper's Fig. 7.
#include "reports/figure_measured.h"

#include "reports/figures.h"
#include "reports/measured_show.h"

#include <math.h>
#include <stdio.h>

enum { VIEWS = 3, MOST_DOTS = 60, LEGEND_COLUMNS = 2 };

static const double side = 28, head = 92, sheet_width = 1000;
static const double axis_left = 56, axis_below = 40, gap = 16, legend_line = 19;

// --- what both pictures share

colour measured_ink(const run_result *r, int line)
{
    const int n = r->measured.nline;
    return n <= 8 ? colour_series(line) : colour_ramp((double)line / (n - 1));
}

void measured_heading(canvas *c, const run_result *r, const char *title, double side_, double width)
{
    char words[MEASURED_SOURCE + 80];
    measured_data_words(r, words, sizeof words);
    say(c, side_, 36, LOOK_TITLE, "%s", title);
    say_within(c, side_, 56, width, LOOK_SMALL, r->title);
    say_within(c, side_, 73, width,
               r->measured.synthetic ? look_inked(LOOK_SMALL, INK_ACCENT) : LOOK_SMALL, words);
}

double measured_legend_height(const run_result *r)
{
    return ((r->measured.nline + LEGEND_COLUMNS - 1) / LEGEND_COLUMNS) * legend_line + 8;
}

static void legend_entry(canvas *c, const run_result *r, int i, double x, double y, double width)
{
    char tip[120] = "not measured", text[MEASURED_NAME + 240];
    const measured_line *line = &r->measured.line[i];
    const shape_error *e = &line->error;
    const colour ink = measured_ink(r, i);
    if (!isnan(e->tip)) {
        (void)snprintf(tip, sizeof tip, "%s mm (%s %% of L)", number_fixed(1e3 * e->tip, 2).text,
                       number_fixed(100 * e->tip / r->rod_length, 1).text);
    }
    (void)snprintf(text, sizeof text, "%s: tip %s, shape error %s %%", line->name, tip,
                   number_fixed(100 * e->shape, 2).text);
    canvas_segment(c, x, y - 4, x + 24, y - 4);
    canvas_stroke(c, ink, 2);
    canvas_circle(c, x + 12, y - 4, 2.6);
    canvas_fill(c, ink);
    say_within(c, x + 32, y, width - 40, LOOK_TEXT, text);
}

void measured_legend(canvas *c, const run_result *r, box at)
{
    const int rows = (r->measured.nline + LEGEND_COLUMNS - 1) / LEGEND_COLUMNS;
    const double width = at.w / LEGEND_COLUMNS;
    for (int i = 0; i < r->measured.nline; i++) {
        legend_entry(c, r, i, at.x + i / rows * width, at.y + i % rows * legend_line, width);
    }
}

vec3 measured_model_mm(const run_result *r, int solution, int point)
{
    const struct rod_run *run = &r->rod.run[solution];
    return vec3_scale(
        1e3, mat3_tmul_vec(run->shape[0].R, vec3_sub(run->shape[point].p, run->shape[0].p)));
}

// --- three sides

typedef struct views_sheet {
    const run_result *r;
    double low[3], high[3]; // of x, y, z [mm]
    double scale, height;   // points per mm; of the panels [points]
} views_sheet;

static const int across[VIEWS] = {0, 1, 0}, up[VIEWS] = {2, 2, 1};
static const char *const label[3] = {"x, mm", "y, mm", "z, mm"};

static void grow(views_sheet *s, vec3 mm)
{
    for (int d = 0; d < 3; d++) {
        s->low[d] = fmin(s->low[d], mm.a[d]);
        s->high[d] = fmax(s->high[d], mm.a[d]);
    }
}

static void arrange(views_sheet *s)
{
    const double tallest = 430, least = 240;
    double size = 0;
    for (int i = 0; i < s->r->measured.nline; i++) {
        const measured_line *line = &s->r->measured.line[i];
        for (int k = 0; k < line->npoint; k++) {
            grow(s, vec3_scale(1e3, line->p[k]));
        }
        for (int k = 0; k < s->r->rod.npoint; k++) {
            grow(s, measured_model_mm(s->r, line->solution, k));
        }
    }
    for (int d = 0; d < 3; d++) {
        size = fmax(size, s->high[d] - s->low[d]);
    }
    for (int d = 0; d < 3; d++) {
        range_pad(&s->low[d], &s->high[d], 0.06, 0.3 * size);
    }
    const double wide = 2 * (s->high[0] - s->low[0]) + s->high[1] - s->low[1];
    const double room = sheet_width - 2 * side - VIEWS * axis_left - (VIEWS - 1) * gap;
    s->scale = fmin(room / wide, tallest / (s->high[2] - s->low[2]));
    // what is left over widens the views at the same scale
    const double spare = (room / s->scale - wide) / 6;
    for (int d = 0; d < 2; d++) {
        s->low[d] -= spare;
        s->high[d] += spare;
    }
    s->height = fmax(s->scale * (s->high[2] - s->low[2]), least);
}

// the range of a direction, widened to fill so many points at the sheet's scale
static void widened(const views_sheet *s, int d, double points, double range[2])
{
    const double middle = 0.5 * (s->low[d] + s->high[d]);
    range[0] = middle - 0.5 * points / s->scale;
    range[1] = middle + 0.5 * points / s->scale;
}

// two standard deviations to either side, at scale
static void draw_band(canvas *c, const plot *p, int view, const measured_line *line, double scale,
                      colour ink)
{
    double sigma = 0;
    for (int k = 0; k < line->npoint; k++) {
        const vec3 mm = vec3_scale(1e3, line->p[k]);
        const double x = plot_x(p, mm.a[across[view]]), y = plot_y(p, mm.a[up[view]]);
        sigma = line->sigma[k] > 0 ? fmax(sigma, line->sigma[k]) : sigma;
        if (k == 0) {
            canvas_move(c, x, y);
        } else {
            canvas_line(c, x, y);
        }
    }
    canvas_stroke(c, colour_mix(ink, PAPER, 0.65), fmax(4e3 * sigma * scale, 1));
}

static void draw_line(canvas *c, const views_sheet *s, const plot *p, int view, int i)
{
    const measured_line *line = &s->r->measured.line[i];
    const colour ink = measured_ink(s->r, i);
    draw_band(c, p, view, line, s->scale, ink);
    for (int k = 0; k < s->r->rod.npoint; k++) {
        const vec3 mm = measured_model_mm(s->r, line->solution, k);
        const double x = plot_x(p, mm.a[across[view]]), y = plot_y(p, mm.a[up[view]]);
        if (k == 0) {
            canvas_move(c, x, y);
        } else {
            canvas_line(c, x, y);
        }
    }
    canvas_stroke(c, ink, 1.8);
    const int stride = line->npoint / MOST_DOTS + 1;
    for (int k = line->npoint - 1; k >= 0; k -= stride) { // the last one is the tip
        const vec3 mm = vec3_scale(1e3, line->p[k]);
        canvas_circle(c, plot_x(p, mm.a[across[view]]), plot_y(p, mm.a[up[view]]), 2.1);
        canvas_fill_stroke(c, ink, PAPER, 0.5);
    }
}

static double draw_view(canvas *c, const views_sheet *s, int view, double x)
{
    const double width = s->scale * (s->high[across[view]] - s->low[across[view]]);
    double range[2];
    widened(s, up[view], s->height, range);
    const plot p = {{x, head, width, s->height},
                    s->low[across[view]],
                    s->high[across[view]],
                    range[0],
                    range[1]};
    plot_frame(c, &p, label[across[view]], label[up[view]]);
    canvas_clip(c, p.at.x, p.at.y, p.at.w, p.at.h);
    for (int i = 0; i < s->r->measured.nline; i++) {
        draw_line(c, s, &p, view, i);
    }
    canvas_unclip(c);
    return x + width + gap + axis_left;
}

static double sheet_height(const views_sheet *s)
{
    return head + s->height + axis_below + 26 + measured_legend_height(s->r) + 30;
}

static status draw(canvas *c, const void *data)
{
    const views_sheet *s = data;
    double x = side + axis_left;
    measured_heading(c, s->r,
                     s->r->measured.synthetic ? "The model against synthetic shapes"
                                              : "The model against measured shapes",
                     side, sheet_width - 2 * side);
    for (int view = 0; view < VIEWS; view++) {
        x = draw_view(c, s, view, x);
    }
    const double y = head + s->height + axis_below + 22;
    measured_legend(c, s->r, (box){side, y, sheet_width - 2 * side, 0});
    say(c, side, sheet_height(s) - 14, LOOK_SMALL,
        "Lines: the model; dots: %s, in the frame of the base; pale: two standard deviations, at "
        "scale. One scale in all views.",
        s->r->measured.synthetic ? "synthetic" : "measured");
    return OK;
}

status figure_measured(const run_result *r, const char *dir)
{
    status st = OK;
    if (!r->has_measured || r->measured.nline == 0) {
        return OK;
    }
    views_sheet s = {.r = r};
    arrange(&s);
    const picture p = {
        .name = "measured",
        .title = r->measured.synthetic ? "The model against synthetic shapes, from three sides"
                                       : "The model against measured shapes, from three sides",
        .width = sheet_width,
        .height = sheet_height(&s),
        .draw = draw,
        .data = &s,
    };
    TRY(picture_write(&p, dir));
    TRY(figure_measured_along(r, dir));

done:
    return st;
}
