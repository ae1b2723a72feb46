// reports/figure_tornado.c
// How far each parameter moves the tip, the largest first: the low end of its range to the left,
// the high end to the right; what the derivative alone says as an open mark.
#include "reports/figure_rod_style.h"
#include "reports/figures.h"

#include <math.h>
#include <stdio.h>

enum { PANELS = 6, BARS = 14 };

static const double side = 28, head = 78, sheet_width = 1000, row = 34, thick = 16, names = 150,
                    gap = 26, above = 34, below = 52, label_room = 78;

typedef struct tornado {
    const run_result *r;
    const rod_show *show;
    int npanel, columns, nbar;
    int solution[PANELS]; // of sensitivity.solution
} tornado;

static const sensitivity_result *of(const tornado *t)
{
    return &t->r->sensitivity;
}

static double panel_width(const tornado *t)
{
    return (sheet_width - 2 * side - (t->columns - 1) * gap) / t->columns;
}

static double panel_height(const tornado *t)
{
    return above + row * t->nbar + below;
}

static double sheet_height(const tornado *t)
{
    const int rows = (t->npanel + t->columns - 1) / t->columns;
    return head + rows * panel_height(t) + 50;
}

// a mark far beyond the bars is left out
static bool has_mark(const mover *q, const move *m, int end)
{
    return q->end[end].asked && move_linear(q, m, end) < 1.5 * move_largest(m);
}

// the largest move of the panel, also that of the derivative alone [mm]
static double panel_reach(const tornado *t, int solution)
{
    double most = 0;
    for (int k = 0; k < of(t)->nmover; k++) {
        const move *m = sensitivity_move(of(t), k, solution);
        most = fmax(most, move_largest(m));
        for (int end = 0; end < MOVER_ENDS; end++) {
            const mover *q = &of(t)->mover[k];
            most = has_mark(q, m, end) ? fmax(most, move_linear(q, m, end)) : most;
        }
    }
    return most > 0 ? 1e3 * most : 1;
}

// "3.5 mm", an alternative as the case would have it
static void end_text(const mover *p, int end, char *text, size_t size)
{
    (void)snprintf(text, size, "%s%s%s", p->end[end].text, p->unit[0] ? " " : "",
                   p->discrete ? "" : p->unit);
}

static void bar_draw(canvas *c, const plot *p, const mover *q, const move *m, int end, double y)
{
    const double size = 1e3 * move_size(m, end), sign = end == MOVER_LOW ? -1 : 1;
    char text[MOVER_TEXT + MOVER_UNIT + 4];
    const text_look look = look_aligned(look_haloed(look_inked(LOOK_TICK, INK)),
                                        end == MOVER_LOW ? TEXT_RIGHT : TEXT_LEFT);
    if (!q->end[end].asked) {
        return;
    }
    end_text(q, end, text, sizeof text);
    if (isnan(size)) {
        say_within(c, plot_x(p, 0) + sign * 6, y + 4, p->at.w / 2, look, "no answer");
        return;
    }
    const double x = plot_x(p, sign * size);
    const colour ink = colour_series(q->discrete ? 2 : end == MOVER_LOW ? 0 : 1);
    canvas_rectangle(c, fmin(x, plot_x(p, 0)), y - thick / 2, fabs(x - plot_x(p, 0)), thick);
    canvas_fill(c, colour_mix(ink, PAPER, 0.25));
    // behind the mark of the derivative, where that goes further
    if (q->discrete) { // words may be long, and the other side is free
        say_within(c, plot_x(p, 0) - 7, y + 4, plot_x(p, 0) - p->at.x - 7,
                   look_aligned(look, TEXT_RIGHT), text);
        return;
    }
    const double linear = has_mark(q, m, end) ? 1e3 * move_linear(q, m, end) : 0;
    say_within(c, plot_x(p, sign * fmax(size, linear)) + sign * 7, y + 4, label_room - 4, look,
               text);
}

// where the derivative alone would take the tip
static void mark_draw(canvas *c, const plot *p, const mover *q, const move *m, int end, double y)
{
    const double size = 1e3 * move_linear(q, m, end), sign = end == MOVER_LOW ? -1 : 1;
    const double x = plot_x(p, sign * size);
    if (!has_mark(q, m, end)) {
        return;
    }
    canvas_circle(c, x, y, 3.2);
    canvas_fill_stroke(c, PAPER, INK, 1.1);
}

static void name_draw(canvas *c, const mover *q, double x, double y)
{
    char text[2 * MOVER_TEXT];
    say_within(c, x, y - 2, names - 8, look_inked(LOOK_SMALL, INK), q->name);
    (void)snprintf(text, sizeof text, "now %s%s%s", q->text, q->unit[0] ? " " : "",
                   isnan(q->value) ? "" : q->unit);
    say_within(c, x, y + 12, names - 8, LOOK_TICK, text);
}

static void axis_draw(canvas *c, const plot *p)
{
    const double step = nice_step(p->x1 - p->x0, 6);
    const double y = p->at.y + p->at.h;
    for (double v = step * ceil(p->x0 / step); v <= p->x1; v += step) {
        const double at = fabs(v) < 1e-9 * step ? 0 : v;
        canvas_segment(c, plot_x(p, at), p->at.y, plot_x(p, at), y);
        canvas_stroke(c, at == 0 ? INK_SOFT : INK_GRID, at == 0 ? 1.2 : 0.8);
        say(c, plot_x(p, at), y + 13, look_aligned(LOOK_TICK, TEXT_CENTRE), "%s",
            number_short(fabs(at), 3).text);
    }
    say(c, p->at.x + p->at.w / 2, y + 30, look_aligned(look_inked(LOOK_SMALL, INK), TEXT_CENTRE),
        "the tip moves by, mm");
}

static void panel_draw(canvas *c, const tornado *t, int panel, box at)
{
    const sensitivity_result *s = of(t);
    const int solution = t->solution[panel];
    int order[MOST_MOVERS];
    char label[256], words[320];
    const double reach = 1.02 * panel_reach(t, solution);
    const double scale = reach / (at.w - names - 2 * label_room) * 2 * label_room;
    const plot p = {{at.x + names, at.y + above, at.w - names, row * t->nbar},
                    -reach - scale / 2,
                    reach + scale / 2,
                    0,
                    1};
    sensitivity_sort(s, solution, order);
    rod_label(t->show, s->solution[solution], label, sizeof label);
    (void)snprintf(words, sizeof words, "%d: %s", s->solution[solution] + 1, label);
    say_within(c, at.x, at.y + above - 14, at.w, LOOK_HEADING, words);
    axis_draw(c, &p);
    for (int i = 0; i < t->nbar; i++) {
        const double y = at.y + above + row * (i + 0.5);
        const mover *q = &s->mover[order[i]];
        const move *m = sensitivity_move(s, order[i], solution);
        name_draw(c, q, at.x, y);
        for (int end = 0; end < MOVER_ENDS; end++) {
            bar_draw(c, &p, q, m, end, y);
            mark_draw(c, &p, q, m, end, y);
        }
    }
}

static status draw(canvas *c, const void *data)
{
    const tornado *t = data;
    const double width = panel_width(t), height = panel_height(t);
    say(c, side, 36, LOOK_TITLE, "What moves the tip");
    say_within(c, side, 56, sheet_width - 2 * side, LOOK_SMALL, t->r->title);
    for (int i = 0; i < t->npanel; i++) {
        const double x = side + (i % t->columns) * (width + gap);
        panel_draw(c, t, i, (box){x, head + (i / t->columns) * height, width, height});
    }
    const double y = sheet_height(t) - 30;
    char words[512];
    (void)snprintf(
        words, sizeof words,
        "Each parameter alone, solved anew: to its low end (left), to its high end "
        "(right), to the alternative (green): how far the tip is then from where it is in "
        "the case. Open mark: what the derivative alone says. %d of %d parameters, %d of "
        "%d solutions.",
        t->nbar, of(t)->nmover, t->npanel, of(t)->nsolution);
    (void)say_paragraph(c, side, y, sheet_width - 2 * side, LOOK_SMALL, words);
    return OK;
}

status figure_tornado(const run_result *r, const char *dir)
{
    status st = OK;
    rod_show show = {0};
    const sensitivity_result *s = &r->sensitivity;
    tornado t = {.r = r, .show = &show};
    if (!r->has_sensitivity) {
        return OK;
    }
    TRY(rod_show_make(&r->rod, &show));
    t.npanel = rod_spread(s->nsolution, PANELS, t.solution);
    t.columns = t.npanel > 1 ? 2 : 1;
    t.nbar = s->nmover < BARS ? s->nmover : BARS;
    const picture p = {
        .name = "tornado",
        .title = "How far each parameter moves the tip, the largest first",
        .width = sheet_width,
        .height = sheet_height(&t),
        .draw = draw,
        .data = &t,
    };
    TRY(picture_write(&p, dir));

done:
    rod_show_free(&show);
    return st;
}
