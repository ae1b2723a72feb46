// reports/figure_segments.c
// The deformed segments side by side, what they did, and the paper's numbers where it is the
// paper's Fig. 4.
#include "reports/fig4_paper.h"
#include "reports/figure_segment_view.h"
#include "reports/figures.h"

#include <math.h>
#include <stdio.h>

enum { MAX_PANELS = 6, NARROW = 3, ROWS = 6, PAPER_ROWS = 4, STRESS_ROWS = 1 };

static const double side = 28, bar_width = 96, head = 74, view_height = 400, row = 19, gap = 30;

typedef struct layout {
    int npanel, across;
    double panel_width, panel_height, width, height;
} layout;

// the paper speaks of the first four only
static int row_count(const segment_scene *s)
{
    return s->value == SURFACE_MISES ? STRESS_ROWS : s->fig4 ? PAPER_ROWS : ROWS;
}

static layout arrange(const segment_scene *s)
{
    layout l = {.npanel = s->r->segment.nload < MAX_PANELS ? s->r->segment.nload : MAX_PANELS};
    l.across = l.npanel <= 2 ? l.npanel : l.npanel == 4 ? 2 : NARROW;
    l.panel_width = l.across < NARROW ? 418 : 282;
    l.panel_height = view_height + gap + (row_count(s) + 1) * row;
    l.width = 2 * side + bar_width + l.across * l.panel_width;
    const int nrow = (l.npanel + l.across - 1) / l.across;
    l.height = head + nrow * l.panel_height + (nrow - 1) * gap + (s->fig4 ? 82 : 56);
    return l;
}

static void colour_bar(canvas *c, const segment_scene *s, box at)
{
    const int cuts = 120;
    for (int i = 0; i < cuts; i++) {
        canvas_rectangle(c, at.x, at.y + at.h * (cuts - 1 - i) / cuts, at.w, at.h / cuts + 0.5);
        canvas_fill(c, segment_colour(s, s->largest * (i + 0.5) / cuts, 0.8));
    }
    canvas_rectangle(c, at.x, at.y, at.w, at.h);
    canvas_stroke(c, INK_SOFT, 0.8);

    const bool mises = s->value == SURFACE_MISES;
    const double largest = s->largest * (mises ? 1e-6 : 1e3), step = nice_step(largest, 5);
    const int decimals = (int)fmax(0, ceil(-log10(step) - 1e-9));
    for (int i = 0; largest > 0 && isfinite(largest) && i * step <= largest * (1 + 1e-9); i++) {
        const double y = at.y + at.h * (1 - i * step / largest);
        canvas_segment(c, at.x + at.w, y, at.x + at.w + 4, y);
        canvas_stroke(c, INK_SOFT, 0.8);
        say(c, at.x + at.w + 8, y + 3.7, LOOK_TICK, "%s", number_fixed(i * step, decimals).text);
    }
    say(c, at.x, at.y - 26, look_inked(LOOK_SMALL, INK), "%s",
        mises ? "von Mises" : "displacement");
    say(c, at.x, at.y - 11, look_inked(LOOK_SMALL, INK), "%s", mises ? "stress, MPa" : "size, mm");
}

static double degrees(double angle)
{
    return angle * 180 / acos(-1.0);
}

typedef struct number_row {
    const char *name, *paper;
    char text[96];
} number_row;

static void number_rows(const segment_scene *s, int load, bool narrow, number_row rows[ROWS])
{
    const segment_load_result *l = &s->r->segment.load[load];
    if (s->value == SURFACE_MISES) {
        rows[0] = (number_row){"largest off the ends", NULL, ""};
        (void)snprintf(
            rows[0].text, sizeof rows[0].text, "%s MPa",
            number_digits(1e-6 * segment_largest(&s->r->segment.body, l, s->value), 4).text);
        return;
    }
    const fig4_reported paper = fig4_paper(s->fig4 ? fig4_which(s->r, load) : FIG4_NONE);
    const double strain = l->shortening / s->r->segment_length;

    rows[0] = (number_row){"shortening, E-weighted", paper.shortening, ""};
    (void)snprintf(rows[0].text, sizeof rows[0].text, narrow ? "%s mm" : "%s mm = %s %%",
                   number_fixed(l->shortening * 1e3, s->fig4 ? 3 : 4).text,
                   number_fixed(strain * 100, 2).text);
    rows[1] = (number_row){narrow ? "shortening at geom. centre" : "shortening at geometric centre",
                           NULL, ""};
    (void)snprintf(rows[1].text, sizeof rows[1].text, "%s mm",
                   number_fixed(-l->tip_displacement[2] * 1e3, 4).text);
    rows[2] = (number_row){"tip angle", paper.tip_angle, ""};
    (void)snprintf(rows[2].text, sizeof rows[2].text, "%s°",
                   number_fixed(degrees(hypot(l->tip_rotation[0], l->tip_rotation[1])), 3).text);
    rows[3] = (number_row){"curvature at mid length", paper.mid_curvature, ""};
    (void)snprintf(rows[3].text, sizeof rows[3].text, "%s 1/m",
                   number_fixed(hypot(l->mid_curvature[0], l->mid_curvature[1]), 4).text);
    rows[4] = (number_row){"tip deflection sideways", NULL, ""};
    (void)snprintf(
        rows[4].text, sizeof rows[4].text, "%s mm",
        number_fixed(hypot(l->tip_displacement[0], l->tip_displacement[1]) * 1e3, 4).text);
    rows[5] = (number_row){"tip twist", NULL, ""};
    (void)snprintf(rows[5].text, sizeof rows[5].text, "%s°",
                   number_fixed(degrees(l->tip_rotation[2]), 3).text);
}

static void number_table(canvas *c, const segment_scene *s, int load, box at)
{
    number_row rows[ROWS];
    const double ours = at.x + at.w - (s->fig4 ? 122 : 0), paper = at.x + at.w;
    const text_look head_look = look_aligned(look_inked(LOOK_SMALL, INK_SOFT), TEXT_RIGHT);
    const text_look number_look = look_inked(head_look, INK);
    number_rows(s, load, arrange(s).across == NARROW, rows);

    say(c, ours, at.y, head_look, "this run");
    if (s->fig4) {
        say(c, paper, at.y, head_look, "paper");
    }
    canvas_segment(c, at.x, at.y + 6, at.x + at.w, at.y + 6);
    canvas_stroke(c, INK_FAINT, 0.8);
    for (int i = 0; i < row_count(s); i++) {
        const double y = at.y + 5 + (i + 1) * row;
        const double taken = canvas_text_width(c, &number_look, rows[i].text) + 8;
        say_within(c, at.x, y, ours - at.x - taken, look_inked(LOOK_SMALL, INK), rows[i].name);
        canvas_text(c, ours, y, &number_look, rows[i].text);
        if (s->fig4) {
            say(c, paper, y, head_look, "%s", rows[i].paper ? rows[i].paper : "–");
        }
    }
}

static void notes(canvas *c, const segment_scene *s, const layout *l, double y)
{
    static const char *const base[] = {"clamped", "free to contract sideways", "free"};
    static const char *const tip[] = {"rigid cap", "traction proportional to E", "uniform traction",
                                      "free"};
    const run_result *r = s->r;
    char text[768], scale[96] = "at true scale", left_off[64] = "";
    if (s->magnify != 1) {
        (void)snprintf(scale, sizeof scale, "%s times larger than they are",
                       number_digits(s->magnify, 1).text);
    }
    if (r->segment.nload > l->npanel) {
        (void)snprintf(left_off, sizeof left_off, " The first %d of %d loads.", l->npanel,
                       r->segment.nload);
    }
    (void)snprintf(
        text, sizeof text,
        "Linear elasticity, %lld unknowns; base %s; tip: %s. Displacements drawn %s. "
        "Dashed: undeformed%s.%s%s",
        r->segment.dofs, base[(unsigned)r->segment_base % 3], tip[(unsigned)r->segment_tip % 4],
        scale, s->borders ? "; white lines: borders between materials" : "", left_off,
        s->value == SURFACE_MISES
            ? " The scale ends at the largest stress between a tenth of the length from "
              "either end: where a clamped edge meets the surface there is no largest one."
            : "");
    y = say_paragraph(c, side, y, l->width - 2 * side, LOOK_SMALL, text);
    if (s->fig4) {
        fig4_note(r, text, sizeof text);
        (void)say_paragraph(c, side, y + 3, l->width - 2 * side, look_inked(LOOK_SMALL, INK), text);
    }
}

static status draw(canvas *c, const void *data)
{
    status st = OK;
    const segment_scene *s = data;
    const layout l = arrange(s);
    const double wide = fmax(s->high[0] - s->low[0], 1e-9),
                 high = fmax(s->high[1] - s->low[1], 1e-9);
    const double scale = fmin((l.panel_width - 110) / wide, (view_height - 100) / high);

    say(c, side, 36, LOOK_TITLE, "%s",
        s->value == SURFACE_MISES ? "Von Mises stress under the tip loads"
        : s->fig4                 ? "Fig. 4 regenerated: the same load at two points"
                                  : "The segment under its tip loads");
    say_within(c, side, 56, l.width - 2 * side, LOOK_SMALL, s->r->title);
    for (int i = 0; i < l.npanel; i++) {
        const segment_load_result *load = &s->r->segment.load[i];
        const box at = {side + i % l.across * l.panel_width,
                        head + (double)(i / l.across) * (l.panel_height + gap), l.panel_width,
                        view_height};
        char place[128];
        say_within(c, at.x, at.y + 14, at.w - 24, LOOK_HEADING, load->name ? load->name : "load");
        (void)snprintf(place, sizeof place, "acts at (%s, %s) mm",
                       number_fixed(load->point[0] * 1e3, 3).text,
                       number_fixed(load->point[1] * 1e3, 3).text);
        say(c, at.x, at.y + 30, LOOK_SMALL, "%s", place);
        TRY(segment_view(c, s, i, at, scale));
        scale_bar(c, at.x + at.w - 36, at.y + at.h - 6, 70, scale * 1e-3);
        number_table(c, s, i, (box){at.x, at.y + at.h + gap, at.w - (s->fig4 ? 12 : 24), 0});
    }
    colour_bar(c, s, (box){l.width - side - bar_width + 24, head + 90, 16, view_height - 160});
    notes(c, s, &l, l.height - (s->fig4 ? 82 : 56) + 18);

done:
    return st;
}

static status draw_scene(const run_result *r, surface_value value, const char *dir)
{
    status st = OK;
    segment_scene scene = {0};
    TRY(segment_scene_make(r, value, &scene));
    const layout l = arrange(&scene);
    const picture p = {
        .name = value == SURFACE_MISES ? "segment_stress" : "segment",
        .title =
            value == SURFACE_MISES
                ? "The deformed segment under each of its tip loads, coloured by von Mises stress"
                : "The deformed segment under each of its tip loads, coloured by displacement",
        .width = l.width,
        .height = l.height,
        .draw = draw,
        .data = &scene,
    };
    TRY(picture_write(&p, dir));

done:
    segment_scene_free(&scene);
    return st;
}

status figure_segments(const run_result *r, const char *dir)
{
    status st = OK;
    const segment_body *b = &r->segment.body;
    bool moved =
        r->has_segment && r->segment.nload > 0 && b->nlevel > 0 && b->last - b->first == b->nlevel;
    bool stressed = moved && b->apart.nnode > 0;
    for (int i = 0; moved && i < r->segment.nload; i++) {
        moved = r->segment.load[i].displacement != NULL;
        stressed = stressed && r->segment.load[i].stress != NULL;
    }
    TRY(moved ? draw_scene(r, SURFACE_DISPLACEMENT, dir) : OK);
    TRY(moved && stressed ? draw_scene(r, SURFACE_MISES, dir) : OK);

done:
    return st;
}
