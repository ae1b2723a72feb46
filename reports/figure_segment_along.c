// reports/figure_segment_along.c
// Strains along the segment with what the section's own law makes of the same wrench, and how well
// the resultants balance the loads.
#include "reports/figure_kit.h"
#include "reports/figures.h"

#include <math.h>
#include <stdio.h>

enum { PANELS = 6, COLUMNS = 3, MOST_LOADS_DRAWN = 8 };

static const double side = 28, head = 74, sheet_width = 1000, panel_height = 168;
static const double axis_left = 62, axis_below = 50, gap = 8, caption = 20, legend_row = 20;
// what is smaller beside the largest of its group is drawn as the nothing that it is
static const double nothing_part = 1e-6;
// a miss below rounding is rounding
static const double least_miss = 1e-17;

typedef struct panel {
    const char *name, *label;
    int strain; // -1: the miss
    double scale;
    int group; // panels of a group share what counts as nothing
} panel;

static const panel panels[PANELS] = {
    {"Curvature about x", "κx, 1/m", MX, 1, 0},
    {"Curvature about y", "κy, 1/m", MY, 1, 0},
    {"Twist about z", "τ, 1/m", MZ, 1, 0},
    {"Elongation", "elongation, %", NZ, 100, 1},
    {"Shear along x", "shear, %", NX, 100, 1},
    {"Miss of the resultants", "log₁₀ of the miss", -1, 1, 2},
};

typedef struct sheet {
    const run_result *r;
    int nload;
    bool law;     // the section's own is known, and the body stands straight
    bool follows; // the section changes along the body as it does along the rod
} sheet;

// --- values

static vec6 law_strain(const sheet *s, const segment_slice *slice)
{
    mat6 K, F;
    law_along_at(&s->r->section.along, s->r->segment_section_at + (s->follows ? slice->s : 0), &K,
                 NULL);
    return mat6_inverse_spd(K, &F) ? mat6_mul_vec(F, slice->load) : (vec6){0};
}

// largest of the miss, moments over the length, relative to the load's largest anywhere
static double miss_of(const sheet *s, const segment_load_result *load, int k)
{
    double miss = 0, most = 0;
    for (int i = 0; i < load->nslice; i++) {
        for (int d = 0; d < 6; d++) {
            const double unit = d < 3 ? 1 : s->r->segment_length;
            const double of = fabs(load->slice[i].load.a[d]) / unit;
            most = fmax(most, of);
            if (i == k) {
                const double off = load->slice[i].resultant.a[d] - load->slice[i].load.a[d];
                miss = fmax(miss, fabs(off) / unit);
            }
        }
    }
    return most > 0 ? miss / most : 0;
}

static double value_of(const sheet *s, const panel *p, int load, int k, bool law)
{
    const segment_load_result *l = &s->r->segment.load[load];
    if (p->strain < 0) {
        return log10(fmax(miss_of(s, l, k), least_miss));
    }
    const vec6 e = law ? law_strain(s, &l->slice[k]) : l->slice[k].strain;
    return p->scale * e.a[p->strain];
}

static double largest_of(const sheet *s, int group)
{
    double most = 0;
    for (int i = 0; i < PANELS; i++) {
        for (int l = 0; panels[i].group == group && l < s->nload; l++) {
            for (int k = 0; k < s->r->segment.load[l].nslice; k++) {
                most = fmax(most, fabs(value_of(s, &panels[i], l, k, false)));
            }
        }
    }
    return most;
}

// --- a panel

static plot panel_plot(const sheet *s, const panel *p, box at)
{
    plot plot = {at, 0, s->r->segment_length * 1e3, p->strain < 0 ? -17 : 0, 0};
    for (int l = 0; l < s->nload; l++) {
        for (int k = 0; k < s->r->segment.load[l].nslice; k++) {
            for (int law = 0; law <= (s->law && p->strain >= 0); law++) {
                const double v = value_of(s, p, l, k, law);
                plot.y0 = fmin(plot.y0, v);
                plot.y1 = fmax(plot.y1, v);
            }
        }
    }
    const double most = largest_of(s, p->group);
    if (fmax(-plot.y0, plot.y1) <= nothing_part * most) {
        plot.y0 = most > 0 ? -0.1 * most : -1;
        plot.y1 = -plot.y0;
    }
    range_pad(&plot.y0, &plot.y1, 0.06, 1e-300);
    return plot;
}

static void curve(canvas *c, const sheet *s, const panel *p, const plot *plot, int load, bool law)
{
    const segment_load_result *l = &s->r->segment.load[load];
    for (int k = 0; k < l->nslice; k++) {
        const double x = plot_x(plot, l->slice[k].s * 1e3),
                     y = plot_y(plot, value_of(s, p, load, k, law));
        if (k == 0) {
            canvas_move(c, x, y);
        } else {
            canvas_line(c, x, y);
        }
    }
    canvas_dash(c, law ? 5 : 0, law ? 3 : 0);
    canvas_stroke(c, colour_mix(colour_series(load), INK, law ? 0.45 : 0), law ? 1.3 : 2);
    canvas_dash(c, 0, 0);
}

static void draw_panel(canvas *c, const sheet *s, const panel *p, box at)
{
    const plot plot = panel_plot(s, p, at);
    say_within(c, at.x, at.y - 7, at.w, LOOK_HEADING, p->name);
    plot_frame(c, &plot, "arclength s, mm", p->label);
    canvas_clip(c, at.x, at.y, at.w, at.h);
    for (int l = 0; l < s->nload; l++) {
        curve(c, s, p, &plot, l, false);
        if (s->law && p->strain >= 0) {
            curve(c, s, p, &plot, l, true);
        }
    }
    canvas_unclip(c);
}

// --- the sheet

static double panels_height(void)
{
    return (PANELS + COLUMNS - 1) / COLUMNS * (panel_height + axis_below + caption);
}

static double sheet_height(const sheet *s)
{
    return head + panels_height() + (s->nload + 2) / 3 * legend_row + 62;
}

static void legend(canvas *c, const sheet *s, double y)
{
    const double width = (sheet_width - 2 * side) / 3;
    for (int l = 0; l < s->nload; l++) {
        const double x = side + l % 3 * width, at = y + l / 3 * legend_row;
        const char *name = s->r->segment.load[l].name;
        canvas_segment(c, x, at - 4, x + 26, at - 4);
        canvas_stroke(c, colour_series(l), 2);
        say_within(c, x + 34, at, width - 44, LOOK_SMALL, name ? name : "load");
    }
}

static status draw(canvas *c, const void *data)
{
    const sheet *s = data;
    const double width =
        (sheet_width - 2 * side - COLUMNS * axis_left - (COLUMNS - 1) * gap) / COLUMNS;
    char text[400];
    say(c, side, 36, LOOK_TITLE, "Strains along the segment");
    say_within(c, side, 56, sheet_width - 2 * side, LOOK_SMALL, s->r->title);
    for (int i = 0; i < PANELS; i++) {
        const double x = side + axis_left + (i % COLUMNS) * (width + gap + axis_left);
        const double y = head + caption + (i / COLUMNS) * (panel_height + axis_below + caption);
        draw_panel(c, s, &panels[i], (box){x, y, width, panel_height});
    }
    const double below = head + panels_height() + 12;
    legend(c, s, below);
    (void)snprintf(
        text, sizeof text,
        "Of the sections' fitted rigid motions, E-weighted.%s Miss: what the stresses of a "
        "section carry against what acts beyond it, moments over the length, relative to "
        "the largest of the load.",
        s->law ? " Dashed: what the section's own law makes of the same wrench; at the "
                 "ends the difference is the layers that a clamp and a cap make."
               : "");
    (void)say_paragraph(c, side, below + (s->nload + 2) / 3 * legend_row + 4,
                        sheet_width - 2 * side, LOOK_SMALL, text);
    return OK;
}

// a prism's nodes stand above each other, on all levels: whole turns end where they began
static bool is_prism(const run_result *r)
{
    const segment_body *b = &r->segment.body;
    const size_t n = 3 * (size_t)b->plane.nnode;
    double away = 0;
    for (size_t i = n; i < n * (size_t)b->nlevel; i++) {
        away = i % 3 == 2 ? away : fmax(away, fabs(b->node[i] - b->node[i % n]));
    }
    return away <= 1e-9 * r->segment_length;
}

// the middle of the nodes stays above the base's
static bool is_straight(const run_result *r)
{
    const segment_body *b = &r->segment.body;
    const int n = b->plane.nnode;
    const bool all = b->nlevel > 1 && b->first == 0 && b->last == b->nlevel;
    double away = 0;
    for (int d = 0; all && d < 2; d++) {
        double base = 0, tip = 0;
        for (int i = 0; i < n; i++) {
            base += b->node[3 * (size_t)i + (size_t)d] / n;
            tip += b->node[3 * ((size_t)(b->nlevel - 1) * (size_t)n + (size_t)i) + (size_t)d] / n;
        }
        away = fmax(away, fabs(tip - base));
    }
    return all && away < 0.1 * r->segment_length;
}

status figure_segment_along(const run_result *r, const char *dir)
{
    sheet s = {.r = r, .nload = r->segment.nload};
    s.nload = s.nload < MOST_LOADS_DRAWN ? s.nload : MOST_LOADS_DRAWN;
    bool any = r->has_segment && s.nload > 0;
    for (int i = 0; any && i < s.nload; i++) {
        any = r->segment.load[i].nslice > 1;
    }
    if (!any) {
        return OK;
    }
    s.law = r->has_section && r->section.along.npanel > 0 && is_straight(r);
    s.follows = s.law && !is_prism(r);
    const picture p = {
        .name = "segment_along",
        .title =
            "Curvature, twist, elongation and shear along the 3D segment for all loads, and the "
            "balance of its sections",
        .width = sheet_width,
        .height = sheet_height(&s),
        .draw = draw,
        .data = &s,
    };
    return picture_write(&p, dir);
}
