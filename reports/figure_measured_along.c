// reports/figure_measured_along.c
// How the model and the measured shapes turn along the rod, as the paper's Fig. 8, and how far they
// are apart.
#include "reports/figure_measured.h"

#include <math.h>
#include <stdio.h>

enum { PANELS = 4, ROW = 2, MOST_DOTS = 40 };

static const double side = 28, head = 92, sheet_width = 1000, panel_height = 200;
static const double axis_left = 62, axis_below = 50, gap = 12, caption = 20;

typedef enum panel_kind { TURN_X, TURN_Y, TURN_SIZE, DISTANCE } panel_kind;

static const char *const names[PANELS] = {"Curvature about x", "Curvature about y",
                                          "Size of the curvature", "Distance of the two lines"};
static const char *const labels[PANELS] = {"κx, 1/m", "κy, 1/m", "|κ|, 1/m", "distance, mm"};

// of the model at a station of its own; NAN where it has none
static double model_value(const run_result *r, const measured_line *line, int kind, int point)
{
    const double *u = r->rod.run[line->solution].curvature[point];
    return kind == TURN_SIZE ? hypot(u[0], u[1]) : kind == DISTANCE ? NAN : u[kind];
}

static double measured_value(const measured_line *line, int kind, int point)
{
    const double *b = line->bend[point].a;
    return kind == TURN_SIZE  ? vec3_norm(line->bend[point])
           : kind == DISTANCE ? 1e3 * vec3_norm(vec3_sub(line->p[point], line->model[point]))
                              : b[kind];
}

static double sigma_of(const measured_line *line, int kind, int point)
{
    const double sigma = kind == DISTANCE ? 1e3 * line->sigma[point] : line->bend_sigma[point];
    return sigma > 0 ? sigma : 0;
}

static void grow(plot *p, double value)
{
    if (!isnan(value)) {
        p->y0 = fmin(p->y0, value);
        p->y1 = fmax(p->y1, value);
    }
}

static plot panel_plot(const run_result *r, int kind, box at)
{
    plot p = {at, 0, 1e3 * r->rod_length, 0, 0};
    for (int i = 0; i < r->measured.nline; i++) {
        const measured_line *line = &r->measured.line[i];
        for (int k = 0; k < r->rod.npoint; k++) {
            grow(&p, model_value(r, line, kind, k));
        }
        for (int k = 0; k < line->npoint; k++) {
            grow(&p, measured_value(line, kind, k));
        }
    }
    range_pad(&p.y0, &p.y1, 0.06, 1e-3);
    return p;
}

static void draw_model(canvas *c, const run_result *r, const plot *p, int kind, int i)
{
    const measured_line *line = &r->measured.line[i];
    for (int k = 0; k < r->rod.npoint; k++) {
        const double x = plot_x(p, 1e3 * r->rod.run[line->solution].s[k]);
        const double y = plot_y(p, model_value(r, line, kind, k));
        if (k == 0) {
            canvas_move(c, x, y);
        } else {
            canvas_line(c, x, y);
        }
    }
    canvas_stroke(c, measured_ink(r, i), 1.8);
}

// two standard deviations to either side
static void draw_band(canvas *c, const run_result *r, const plot *p, int kind, int i)
{
    const measured_line *line = &r->measured.line[i];
    const colour ink = measured_ink(r, i);
    int first = -1, last = -1;
    for (int k = 0; k < line->npoint; k++) {
        if (!isnan(measured_value(line, kind, k))) {
            first = first < 0 ? k : first;
            last = k;
        }
    }
    for (int way = 0; first >= 0 && way < 2; way++) {
        for (int step = 0; step <= last - first; step++) {
            const int k = way == 0 ? first + step : last - step;
            const double off = (way == 0 ? 2 : -2) * sigma_of(line, kind, k);
            const double x = plot_x(p, 1e3 * line->s[k]);
            const double y = plot_y(p, measured_value(line, kind, k) + off);
            if (way == 0 && step == 0) {
                canvas_move(c, x, y);
            } else {
                canvas_line(c, x, y);
            }
        }
    }
    if (first >= 0) {
        canvas_close(c);
        canvas_fill(c, (colour){ink.r, ink.g, ink.b, 0.18});
    }
}

static void draw_dots(canvas *c, const run_result *r, const plot *p, int kind, int i)
{
    const measured_line *line = &r->measured.line[i];
    const int stride = line->npoint / MOST_DOTS + 1;
    for (int k = 0; k < line->npoint; k += stride) {
        const double value = measured_value(line, kind, k);
        if (!isnan(value)) {
            canvas_circle(c, plot_x(p, 1e3 * line->s[k]), plot_y(p, value), 2);
            canvas_fill_stroke(c, measured_ink(r, i), PAPER, 0.5);
        }
    }
}

static void draw_panel(canvas *c, const run_result *r, int kind, box at)
{
    const plot p = panel_plot(r, kind, at);
    say_within(c, at.x, at.y - 7, at.w, LOOK_HEADING, names[kind]);
    plot_frame(c, &p, "arclength s of the unloaded rod, mm", labels[kind]);
    canvas_clip(c, at.x, at.y, at.w, at.h);
    for (int i = 0; i < r->measured.nline; i++) {
        draw_band(c, r, &p, kind, i);
    }
    for (int i = 0; i < r->measured.nline; i++) {
        if (kind != DISTANCE) {
            draw_model(c, r, &p, kind, i);
        }
        draw_dots(c, r, &p, kind, i);
    }
    canvas_unclip(c);
}

static double sheet_height(const run_result *r)
{
    return head + (double)PANELS / ROW * (panel_height + axis_below + caption) +
           measured_legend_height(r) + 50;
}

static status draw(canvas *c, const void *data)
{
    const run_result *r = data;
    const double width = (sheet_width - 2 * side - ROW * axis_left - (ROW - 1) * gap) / ROW;
    char words[320];
    measured_heading(c, r,
                     r->measured.synthetic ? "Curvature of the model and of synthetic shapes"
                                           : "Curvature of the model and of measured shapes",
                     side, sheet_width - 2 * side);
    for (int i = 0; i < PANELS; i++) {
        const double x = side + axis_left + (i % ROW) * (width + gap + axis_left);
        const double y = head + caption + (i / ROW) * (panel_height + axis_below + caption);
        draw_panel(c, r, i, (box){x, y, width, panel_height});
    }
    const double below = head + (double)PANELS / ROW * (panel_height + axis_below + caption);
    measured_legend(c, r, (box){side, below + 14, sheet_width - 2 * side, 0});
    (void)snprintf(
        words, sizeof words,
        "Lines: the model; dots: %s, by parabolas over %s mm of arclength in the model's "
        "body frame; pale: two standard deviations, of the measurement alone.",
        r->measured.synthetic ? "synthetic" : "measured",
        number_short(1e3 * r->measured.window, 3).text);
    (void)say_paragraph(c, side, sheet_height(r) - 28, sheet_width - 2 * side, LOOK_SMALL, words);
    return OK;
}

status figure_measured_along(const run_result *r, const char *dir)
{
    const picture p = {
        .name = "measured_along",
        .title = r->measured.synthetic
                     ? "Curvature of the model and of synthetic shapes along the rod"
                     : "Curvature of the model and of measured shapes along the rod",
        .width = sheet_width,
        .height = sheet_height(r),
        .draw = draw,
        .data = r,
    };
    return picture_write(&p, dir);
}
