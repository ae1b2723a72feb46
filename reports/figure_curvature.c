// reports/figure_curvature.c
// Curvature and twist along the rod for all tensions, in the body frame.
#include "reports/figure_rod_style.h"
#include "reports/figures.h"

#include <math.h>

enum { PANELS = 4 };

static const double side = 28, head = 74, sheet_width = 1000, panel_height = 210;
static const double axis_left = 58, axis_below = 58, gap = 22, caption = 20;

typedef struct quantity {
    const char *name, *label;
} quantity;

static const quantity quantities[PANELS] = {
    {"Curvature about x", "κx, 1/m"},
    {"Curvature about y", "κy, 1/m"},
    {"Size of the curvature", "|κ|, 1/m"},
    {"Twist about z", "τ, 1/m"},
};

static double value_of(const struct rod_run *run, int panel, int point)
{
    const double *k = run->curvature[point];
    return panel == 2 ? hypot(k[0], k[1]) : k[panel == 3 ? 2 : panel];
}

static plot panel_plot(const run_result *r, int panel, box at)
{
    const rod_result *rod = &r->rod;
    plot p = {at, 0, r->rod_length * 1e3, 0, 0};
    double largest = 0;
    for (int i = 0; i < rod->nsolution; i++) {
        for (int k = 0; k < rod->npoint; k++) {
            const double v = value_of(&rod->run[i], panel, k);
            p.y0 = fmin(p.y0, v);
            p.y1 = fmax(p.y1, v);
            largest = fmax(largest, value_of(&rod->run[i], 2, k));
        }
    }
    // what is rounding beside the curvature itself is drawn as the nothing that it is
    range_pad(&p.y0, &p.y1, 0.06, fmax(0.02 * largest, 1e-9));
    return p;
}

static void panel(canvas *c, const run_result *r, int number, box at)
{
    const rod_result *rod = &r->rod;
    const plot p = panel_plot(r, number, at);
    say(c, at.x, at.y - 7, LOOK_HEADING, "%s", quantities[number].name);
    plot_frame(c, &p, "arclength s, mm", quantities[number].label);
    canvas_clip(c, at.x, at.y, at.w, at.h);
    for (int i = 0; i < rod->nsolution; i++) {
        for (int k = 0; k < rod->npoint; k++) {
            const double x = plot_x(&p, rod->run[i].s[k] * 1e3),
                         y = plot_y(&p, value_of(&rod->run[i], number, k));
            if (k == 0) {
                canvas_move(c, x, y);
            } else {
                canvas_line(c, x, y);
            }
        }
        canvas_stroke(c, rod_ink(rod, i), 2.2);
    }
    canvas_unclip(c);
}

static double sheet_height(const run_result *r)
{
    return head + 2 * (panel_height + axis_below + caption) + rod_legend_height(&r->rod) + 24;
}

static status draw(canvas *c, const void *data)
{
    const run_result *r = data;
    const double width = (sheet_width - 2 * side - 2 * axis_left - gap) / 2;

    say(c, side, 36, LOOK_TITLE, "Curvature and twist along the rod");
    say_within(c, side, 56, sheet_width - 2 * side, LOOK_SMALL, r->title);
    for (int i = 0; i < PANELS; i++) {
        const double x = side + axis_left + (i % 2) * (width + gap + axis_left);
        const double y = head + caption + (i / 2) * (panel_height + axis_below + caption);
        panel(c, r, i, (box){x, y, width, panel_height});
    }
    const double y = head + 2 * (panel_height + axis_below + caption);
    rod_legend(c, &r->rod, (box){side, y, sheet_width - 2 * side + 28, 0}, ROD_NOTE_CURVATURE);
    return OK;
}

status figure_curvature(const run_result *r, const char *dir)
{
    if (!r->has_rod || r->rod.nsolution == 0 || r->rod.npoint < 2) {
        return OK;
    }
    const picture p = {
        .name = "curvature",
        .title = "Components and size of the curvature along the rod for all tensions",
        .width = sheet_width,
        .height = sheet_height(r),
        .draw = draw,
        .data = r,
    };
    return picture_write(&p, dir);
}
