// reports/figure_time_error.c
// What accuracy took: the error of the segment's tip compliance, mesh by mesh, against unknowns and
// against processor time.
#include "reports/figure_kit.h"
#include "reports/figures.h"

#include <float.h>
#include <math.h>
#include <stdio.h>

enum { PANELS = 2, LEAST_STEPS = 2 };

static const double side = 28, head = 74, axis_left = 62, gap = 30, plot_width = 385,
                    plot_height = 260, foot = 112;

static double sheet_width(void)
{
    return 2 * side + PANELS * (axis_left + plot_width) + gap;
}

// unknowns, or seconds; rounding and the clock's step are no zeros of a logarithm
static double effort_of(const segment_result *s, int panel, int step)
{
    return log10(fmax(panel ? s->step[step].seconds : s->step[step].dofs, 1e-6));
}

static double error_of(const segment_result *s, int step)
{
    return log10(fmax(segment_step_error(s, step), DBL_EPSILON));
}

static bool known(const segment_result *s)
{
    bool all = s->rungs >= LEAST_STEPS && s->rungs <= SEGMENT_MOST_STEPS;
    for (int i = 0; all && i < s->rungs; i++) {
        all = s->step[i].dofs > 0 && isfinite(error_of(s, i)) && isfinite(effort_of(s, 1, i));
    }
    return all;
}

// whole decades around all points
static plot decades(const segment_result *s, int panel)
{
    plot p = {
        {side + axis_left + panel * (axis_left + plot_width + gap), head, plot_width, plot_height},
        INFINITY,
        -INFINITY,
        INFINITY,
        -INFINITY};
    for (int i = 0; i < s->rungs; i++) {
        p.x0 = fmin(p.x0, floor(effort_of(s, panel, i)));
        p.x1 = fmax(p.x1, floor(effort_of(s, panel, i)) + 1);
        p.y0 = fmin(p.y0, floor(error_of(s, i)));
        p.y1 = fmax(p.y1, floor(error_of(s, i)) + 1);
    }
    return p;
}

static void panel_draw(canvas *c, const segment_result *s, int panel)
{
    const plot p = decades(s, panel);
    plot_decades(c, &p, panel ? "processor time of the mesh, s" : "unknowns", "relative error");
    for (int i = 0; i < s->rungs; i++) {
        (i ? canvas_line : canvas_move)(c, plot_x(&p, effort_of(s, panel, i)),
                                        plot_y(&p, error_of(s, i)));
    }
    canvas_stroke(c, INK_SECOND, 1.6);
    for (int i = 0; i < s->rungs; i++) {
        const bool last = i == s->rungs - 1;
        canvas_circle(c, plot_x(&p, effort_of(s, panel, i)), plot_y(&p, error_of(s, i)), 4);
        canvas_fill_stroke(c, last ? PAPER : INK_SECOND, INK_SECOND, 1.6);
    }
}

static status draw(canvas *c, const void *data)
{
    const run_result *r = data;
    say(c, side, 36, LOOK_TITLE, "What accuracy took, mesh by mesh");
    say_within(c, side, 56, sheet_width() - 2 * side, LOOK_SMALL, r->title);
    for (int i = 0; i < PANELS; i++) {
        panel_draw(c, &r->segment, i);
    }
    (void)say_paragraph(
        c, side, head + plot_height + 66, sheet_width() - 2 * side, LOOK_SMALL,
        "Error of the segment's tip compliance, largest entry over the geometric mean of its two "
        "diagonal ones: the difference from the last mesh (ring) and that one's own estimate. "
        "The time is of this run on this machine.");
    return OK;
}

status figure_time_error(const run_result *r, const char *dir)
{
    if (!r->has_segment || !known(&r->segment)) {
        return OK;
    }
    const picture p = {
        .name = "time_error",
        .title = "Error of the segment against unknowns and against processor time",
        .width = sheet_width(),
        .height = head + plot_height + foot,
        .draw = draw,
        .data = r,
    };
    return picture_write(&p, dir);
}
