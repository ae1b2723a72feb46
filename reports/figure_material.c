// reports/figure_material.c
// Tensile curves with the lines laid through them, as the paper's Fig. 5.
#include "reports/figure_kit.h"
#include "reports/material_report.h"

#include <math.h>
#include <stdio.h>

enum { MOST_POINTS = 1500, LEGEND_MOST = 12 };

static const double width = 760, plot_height = 400, side = 30, head = 84, axis = 66;
static const double row_height = 19, foot = 104;

static int legend_rows(const material_result *r)
{
    return r->n < LEGEND_MOST ? r->n : LEGEND_MOST;
}

static double sheet_height(const material_result *r)
{
    return head + plot_height + foot + row_height * legend_rows(r);
}

// up to two and a half times the linear range: there is the point of the figure
static double strain_shown(const material_result *r)
{
    double reach = 0, all = 0;
    for (int i = 0; i < r->n; i++) {
        const material_specimen *m = &r->specimen[i];
        reach = fmax(reach, 2.5 * (m->answer.linear_strain + m->answer.strain_offset));
        for (int k = 0; k < m->curve.n; k++) {
            all = fmax(all, fabs(m->curve.strain[k]));
        }
    }
    return fmin(reach, all);
}

static double sign_of(const material_specimen *m)
{
    return m->answer.turned ? -1 : 1;
}

static plot make_plot(const material_result *r)
{
    plot p = {{side + axis, head, width - 2 * side - axis, plot_height}, 0, 0, 0, 0};
    p.x1 = 100 * strain_shown(r);
    for (int i = 0; i < r->n; i++) {
        const material_specimen *m = &r->specimen[i];
        for (int k = 0; k < m->curve.n; k++) {
            if (100 * sign_of(m) * m->curve.strain[k] <= p.x1) {
                p.y0 = fmin(p.y0, 1e-6 * sign_of(m) * m->curve.stress[k]);
                p.y1 = fmax(p.y1, 1e-6 * sign_of(m) * m->curve.stress[k]);
            }
        }
    }
    range_pad(&p.x0, &p.x1, 0.02, 1e-9);
    range_pad(&p.y0, &p.y1, 0.04, 1e-12);
    return p;
}

static void draw_curve(canvas *c, const plot *p, const material_specimen *m, colour ink)
{
    const int each = 1 + m->curve.n / MOST_POINTS;
    for (int k = 0; k < m->curve.n; k += each) {
        const double x = plot_x(p, 100 * sign_of(m) * m->curve.strain[k]);
        const double y = plot_y(p, 1e-6 * sign_of(m) * m->curve.stress[k]);
        if (k == 0) {
            canvas_move(c, x, y);
        } else {
            canvas_line(c, x, y);
        }
    }
    canvas_stroke(c, ink, 1.1);
}

// the line through the compensated zero, dashed beyond the linear range, which ends at a dot
static void draw_line(canvas *c, const plot *p, const material_specimen *m, colour ink)
{
    const tensile_answer *a = &m->answer;
    const double zero = a->strain_offset, end = zero + a->linear_strain;
    const double stress = 1e-6 * a->E * a->linear_strain;
    canvas_segment(c, plot_x(p, 100 * zero), plot_y(p, 0), plot_x(p, 100 * end), plot_y(p, stress));
    canvas_stroke(c, ink, 2.2);
    canvas_dash(c, 5, 4);
    canvas_segment(c, plot_x(p, 100 * end), plot_y(p, stress),
                   plot_x(p, 100 * (end + 0.6 * a->linear_strain)), plot_y(p, 1.6 * stress));
    canvas_stroke(c, ink, 1.2);
    canvas_dash(c, 0, 0);
    canvas_circle(c, plot_x(p, 100 * end), plot_y(p, stress), 3.4);
    canvas_fill_stroke(c, ink, PAPER, 1);
}

static void draw_legend(canvas *c, const material_result *r, double y)
{
    for (int i = 0; i < legend_rows(r); i++, y += row_height) {
        const material_specimen *m = &r->specimen[i];
        const tensile_answer *a = &m->answer;
        char words[320];
        const double half = 0.5e-6 * (a->interval[1] - a->interval[0]);
        canvas_segment(c, side + axis, y - 4, side + axis + 22, y - 4);
        canvas_stroke(c, colour_series(i), 2.2);
        (void)snprintf(words, sizeof words, "%s: E = %s ± %s MPa, linear up to %s %%%s", m->label,
                       number_digits(1e-6 * a->E, 4).text, number_digits(half, 2).text,
                       number_digits(100 * a->linear_strain, 3).text,
                       m->outlier ? m->used ? "; stands out" : "; stands out, left out" : "");
        say_within(c, side + axis + 30, y, width - 2 * side - axis - 30, LOOK_TEXT, words);
    }
}

static status draw(canvas *c, const void *data)
{
    const material_result *r = data;
    const plot p = make_plot(r);
    const tensile_pool *pool = &r->pool;
    char words[400];
    (void)snprintf(words, sizeof words, "Young's modulus of %s: %s MPa (%s to %s, %.0f %%)",
                   r->name, number_digits(1e-6 * pool->E, 4).text,
                   number_digits(1e-6 * pool->interval[0], 4).text,
                   number_digits(1e-6 * pool->interval[1], 4).text, 100 * r->rule.share);
    say_within(c, side, 36, width - 2 * side, LOOK_TITLE, words);
    (void)snprintf(words, sizeof words, "%s%s%s%d curve%s",
                   r->synthetic ? "SYNTHETIC data, no measurement. " : "", r->source,
                   r->source[0] ? ". " : "", r->n, r->n == 1 ? "" : "s");
    say_within(c, side, 57, width - 2 * side,
               r->synthetic ? look_inked(LOOK_SMALL, INK_ACCENT) : LOOK_SMALL, words);
    plot_frame(c, &p, "strain, %", "stress, MPa");
    canvas_clip(c, p.at.x, p.at.y, p.at.w, p.at.h);
    for (int i = 0; i < r->n; i++) {
        colour faint = colour_series(i);
        faint.a = 0.55;
        draw_curve(c, &p, &r->specimen[i], faint);
    }
    for (int i = 0; i < r->n; i++) {
        draw_line(c, &p, &r->specimen[i], colour_series(i));
    }
    canvas_unclip(c);
    draw_legend(c, r, head + plot_height + 56);
    (void)snprintf(words, sizeof words,
                   "Line: slope E from the strain where it has no stress. Dot: end of the linear "
                   "range, %.3g %% off this line. Strain as recorded.",
                   100 * r->rule.departure);
    (void)say_paragraph(c, side, sheet_height(r) - 30, width - 2 * side, LOOK_SMALL, words);
    return OK;
}

status figure_material(const material_result *r, const char *directory)
{
    const picture p = {
        .name = "material",
        .title = "Tensile curves with the lines whose slopes are Young's moduli",
        .width = width,
        .height = sheet_height(r),
        .draw = draw,
        .data = r,
    };
    return picture_write(&p, directory);
}
