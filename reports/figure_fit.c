// reports/figure_fit.c
// Distances across the measured lines before and after a fit, and for pairs of fitted numbers the
// region that the shapes allow.
#include "reports/figures.h"
#include "reports/page_kit.h"

#include <math.h>
#include <stdio.h>

enum { COLUMNS = 3, MOST_SHAPES = 12, MOST_PAIRS = 6, ELLIPSE_STEPS = 96 };

static const double side = 28, head = 92, sheet_width = 1000, panel_height = 170;
static const double axis_left = 62, axis_below = 48, gap = 8, caption = 34, foot = 40;

typedef struct fit_sheet {
    const run_result *r;
    const fit_result *f;
    int nshape, npair; // drawn
    int pair[MOST_PAIRS][2];
} fit_sheet;

static box panel_box(int panel, double top)
{
    const double width =
        (sheet_width - 2 * side - COLUMNS * axis_left - (COLUMNS - 1) * gap) / COLUMNS;
    return (box){side + axis_left + (panel % COLUMNS) * (width + gap + axis_left),
                 top + caption + (panel / COLUMNS) * (panel_height + axis_below + caption), width,
                 panel_height};
}

static double panels_height(int n)
{
    return (n + COLUMNS - 1) / COLUMNS * (panel_height + axis_below + caption);
}

// --- distances along the line

static void distance_line(canvas *c, const plot *p, int n, const double *s, const double *d,
                          colour ink)
{
    for (int i = 0; i < n; i++) {
        const double x = plot_x(p, 1e3 * s[i]), y = plot_y(p, 1e3 * d[i]);
        if (i == 0) {
            canvas_move(c, x, y);
        } else {
            canvas_line(c, x, y);
        }
    }
    canvas_stroke(c, ink, 1.7);
}

static void shape_panel(canvas *c, const fit_sheet *w, int k)
{
    const fit_match *m = &w->f->answer.match[k];
    const box at = panel_box(k, head);
    plot p = {at, 0, 1e3 * m->s[m->nstation - 1], 0, 1e-6};
    for (int i = 0; i < m->nstation; i++) {
        p.y1 = fmax(p.y1, 1e3 * fmax(m->before[i], m->after[i]));
    }
    p.y1 *= 1.06;
    plot_frame(c, &p, "arclength s of the measured line, mm", "distance, mm");
    canvas_clip(c, at.x, at.y, at.w, at.h);
    distance_line(c, &p, m->nstation, m->s, m->before, INK_FAINT);
    distance_line(c, &p, m->nstation, m->s, m->after, INK_ACCENT);
    canvas_unclip(c);
    char words[120];
    (void)snprintf(words, sizeof words, "rms %s → %s mm", number_digits(1e3 * m->rms[0], 3).text,
                   number_digits(1e3 * m->rms[1], 3).text);
    say_within(c, at.x, at.y - 20, at.w, LOOK_HEADING, w->f->shape[k].name);
    say_within(c, at.x, at.y - 6, at.w, LOOK_SMALL, words); // above: no curve runs there
}

// --- pairs of numbers

// joint region of two: |L^-1 (x - value)| <= sqrt(2 F) with Student's quantile for one made the
// joint one: 2 F(2, n) lies within 2 % of chi2(2) = -2 log(1 - share) from 100 degrees on, and is
// larger below, as Student's t is against the normal quantile
static double joint_radius(const fit_result *f)
{
    const double n = f->answer.freedom;
    // F(2, n) has a closed form: 1 - share = (1 + 2 F / n)^(-n/2)
    return sqrt(n * (pow(1 - f->share, -2 / n) - 1));
}

static void ellipse(canvas *c, const plot *p, const double *value, const double *error, double rho,
                    double radius)
{
    const double two_pi = 2 * acos(-1.0), across = sqrt(fmax(0, 1 - rho * rho));
    for (int i = 0; i < ELLIPSE_STEPS; i++) {
        const double t = two_pi * i / ELLIPSE_STEPS;
        const double u = radius * cos(t), v = radius * (rho * cos(t) + across * sin(t));
        const double x = plot_x(p, value[0] + error[0] * u), y = plot_y(p, value[1] + error[1] * v);
        if (i == 0) {
            canvas_move(c, x, y);
        } else {
            canvas_line(c, x, y);
        }
    }
    canvas_close(c);
}

static void axis_words(const fit_parameter_told *p, char *words, size_t room)
{
    (void)snprintf(words, room, "%.40s%s%s", p->name, p->unit[0] ? ", " : "", p->unit);
}

static void pair_panel(canvas *c, const fit_sheet *w, int k)
{
    const fit_answer *a = &w->f->answer;
    const int i = w->pair[k][0], j = w->pair[k][1];
    const box at = panel_box(k, head + panels_height(w->nshape));
    const double value[2] = {a->value[i], a->value[j]}, error[2] = {a->error[i], a->error[j]};
    const double rho = a->correlation[i * a->nunknown + j], radius = joint_radius(w->f);
    const double wide = 1.25 * radius;
    const plot p = {at, value[0] - wide * error[0], value[0] + wide * error[0],
                    value[1] - wide * error[1], value[1] + wide * error[1]};
    char x[80], y[80];
    axis_words(&w->f->parameter[i], x, sizeof x);
    axis_words(&w->f->parameter[j], y, sizeof y);
    say(c, at.x, at.y - 8, LOOK_HEADING, "correlation %s", number_fixed(rho, 3).text);
    plot_frame(c, &p, x, y);
    canvas_clip(c, at.x, at.y, at.w, at.h);
    ellipse(c, &p, value, error, rho, radius);
    canvas_fill_stroke(c, colour_mix(PAPER, INK_SECOND, 0.25), INK_SECOND, 1.5);
    // each on its own
    for (int d = 0; d < 2; d++) {
        const double half = a->quantile * error[d];
        const double x0 = d ? value[0] : value[0] - half, x1 = d ? value[0] : value[0] + half;
        const double y0 = d ? value[1] - half : value[1], y1 = d ? value[1] + half : value[1];
        canvas_segment(c, plot_x(&p, x0), plot_y(&p, y0), plot_x(&p, x1), plot_y(&p, y1));
        canvas_stroke(c, INK, 1.2);
    }
    canvas_circle(c, plot_x(&p, value[0]), plot_y(&p, value[1]), 3);
    canvas_fill(c, INK_ACCENT);
    canvas_unclip(c);
}

// --- the sheet

static double sheet_height(const fit_sheet *w)
{
    return head + panels_height(w->nshape) + panels_height(w->npair) + foot;
}

static status draw(canvas *c, const void *data)
{
    const fit_sheet *w = data;
    char words[400];
    say(c, side, 36, LOOK_TITLE, "Fitted to %s shapes", w->f->synthetic ? "synthetic" : "measured");
    say_within(c, side, 56, sheet_width - 2 * side, LOOK_SMALL, w->r->title);
    say_within(c, side, 76, sheet_width - 2 * side, LOOK_TEXT,
               fit_result_words(w->f, words, sizeof words));
    for (int k = 0; k < w->nshape; k++) {
        shape_panel(c, w, k);
    }
    for (int k = 0; k < w->npair; k++) {
        pair_panel(c, w, k);
    }
    say(c, side, sheet_height(w) - 14, LOOK_SMALL,
        "Grey: before, at the start. Red: after. Region: %s %% for both numbers together; bars: "
        "for "
        "each alone.%s",
        number_short(100 * w->f->share, 4).text,
        w->f->answer.nshape > w->nshape ? " More shapes in fit_residuals.csv." : "");
    return OK;
}

static void choose_pairs(fit_sheet *w)
{
    const fit_answer *a = &w->f->answer;
    for (int i = 0; i < a->nunknown; i++) {
        for (int j = i + 1; j < a->nunknown && w->npair < MOST_PAIRS; j++) {
            if (a->error[i] > 0 && a->error[j] > 0) {
                w->pair[w->npair][0] = i;
                w->pair[w->npair][1] = j;
                w->npair++;
            }
        }
    }
}

status figure_fit(const run_result *r, const char *dir)
{
    fit_sheet w = {.r = r, .f = &r->fit};
    if (!r->fit.there) {
        return OK;
    }
    w.nshape = r->fit.answer.nshape < MOST_SHAPES ? r->fit.answer.nshape : MOST_SHAPES;
    choose_pairs(&w);
    const picture p = {
        .name = "fit",
        .title = "Distances from the measured lines before and after the fit, and the region of "
                 "each pair of fitted numbers",
        .width = sheet_width,
        .height = sheet_height(&w),
        .draw = draw,
        .data = &w,
    };
    return picture_write(&p, dir);
}
