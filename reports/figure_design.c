// reports/figure_design.c
// How the search for a design went: the score against the evaluations of each island, and where the
// best design lies between its bounds.
#include "reach/reach_case.h"
#include "reports/figure_kit.h"
#include "reports/figures.h"

#include <math.h>
#include <stdio.h>

static const double side = 28, head = 84, sheet_width = 1000, plot_width = 520, plot_height = 300,
                    axis_left = 62, bar_pitch = 44;

static const double bars_left = 640, bars_width = 330;

static double shown(const reach_design_result *d, double value)
{
    return d->goal == DESIGN_AREA ? 100 * value : value;
}

static plot score_plot(const reach_design_result *d)
{
    plot p = {
        {side + axis_left, head, plot_width - axis_left, plot_height}, 0, 1, INFINITY, -INFINITY};
    if (isfinite(d->start_score)) {
        p.y0 = p.y1 = shown(d, d->start_score);
    }
    for (int i = 0; i < d->nrow; i++) {
        const double y = shown(d, d->row[i].score);
        p.x1 = fmax(p.x1, d->row[i].evaluation);
        if (isfinite(y)) {
            p.y0 = fmin(p.y0, y);
            p.y1 = fmax(p.y1, y);
        }
    }
    if (d->islands > 0) {
        p.x1 = fmax(p.x1, (double)d->evaluations / d->islands);
    }
    if (!(p.y1 >= p.y0)) {
        p.y0 = p.y1 = 0;
    }
    range_pad(&p.y0, &p.y1, 0.08, 1e-3);
    return p;
}

// what an island had found by then stands until it finds better
static void island_line(canvas *c, const reach_design_result *d, const plot *p, int island)
{
    double y = NAN;
    bool begun = false;
    for (int i = 0; i < d->nrow; i++) {
        const reach_design_row *row = &d->row[i];
        if (row->island != island || !isfinite(row->score)) {
            continue;
        }
        const double x = plot_x(p, row->evaluation), next = plot_y(p, shown(d, row->score));
        if (begun) {
            canvas_line(c, x, y);
            canvas_line(c, x, next);
        } else {
            canvas_move(c, x, next);
        }
        begun = true;
        y = next;
    }
    if (begun) {
        canvas_line(c, p->at.x + p->at.w, y);
        canvas_stroke(c, colour_series(island), 1.6);
    }
}

static void scores(canvas *c, const reach_design_result *d)
{
    const plot p = score_plot(d);
    plot_frame(c, &p, "evaluations of the island",
               d->goal == DESIGN_AREA ? "score, % of the wall" : "score, targets");
    canvas_clip(c, p.at.x, p.at.y - 4, p.at.w, p.at.h + 8);
    if (isfinite(d->start_score)) {
        const double y = plot_y(&p, shown(d, d->start_score));
        canvas_dash(c, 5, 3);
        canvas_segment(c, p.at.x, y, p.at.x + p.at.w, y);
        canvas_stroke(c, INK_SOFT, 1);
        canvas_dash(c, 0, 0);
    }
    for (int i = 0; i < d->islands; i++) {
        island_line(c, d, &p, i);
    }
    if (d->best >= 0 && d->best < d->nrow) {
        const reach_design_row *best = &d->row[d->best];
        canvas_circle(c, plot_x(&p, best->evaluation), plot_y(&p, shown(d, best->score)), 4.5);
        canvas_fill_stroke(c, INK_ACCENT, PAPER, 1.2);
    }
    canvas_unclip(c);
}

// a parameter between its bounds: a stroke at the start, a dot at the best
static void bar(canvas *c, const reach_design_result *d, int k)
{
    const double y = head + 32 + bar_pitch * k, span = d->upper[k] - d->lower[k];
    const reach_design_row *best = d->best >= 0 && d->best < d->nrow ? &d->row[d->best] : NULL;
    const double start = bars_left + bars_width * (d->start[k] - d->lower[k]) / span;
    char words[2 * REACH_NAME + 64];
    (void)snprintf(words, sizeof words, "%s%s%s%s%s", d->name[k], best ? " = " : "",
                   best ? number_short(best->value[k], 5).text : "", d->unit[k][0] ? " " : "",
                   d->unit[k]);
    say_within(c, bars_left, y - 8, bars_width, LOOK_TEXT, words);
    canvas_rectangle(c, bars_left, y - 2, bars_width, 4);
    canvas_fill(c, INK_GRID);
    canvas_segment(c, start, y - 6, start, y + 6);
    canvas_stroke(c, INK_SOFT, 1.6);
    if (best) {
        canvas_circle(c, bars_left + bars_width * (best->value[k] - d->lower[k]) / span, y, 4.5);
        canvas_fill_stroke(c, INK_ACCENT, PAPER, 1.2);
    }
    say(c, bars_left, y + 16, LOOK_TICK, "%s", number_short(d->lower[k], 4).text);
    say(c, bars_left + bars_width, y + 16, look_aligned(LOOK_TICK, TEXT_RIGHT), "%s",
        number_short(d->upper[k], 4).text);
}

static double sheet_height(const reach_design_result *d)
{
    return head + fmax(plot_height, bar_pitch * d->nparameter + 20) + 74;
}

static void goal_words(const reach_design_result *d, double goal, char *words, size_t room)
{
    if (d->goal == DESIGN_AREA) {
        (void)snprintf(words, room, "%s %% of the wall", number_fixed(100 * goal, 2).text);
    } else {
        (void)snprintf(words, room, "%s targets", number_short(goal, 4).text);
    }
}

static status draw(canvas *c, const void *data)
{
    const run_result *r = data;
    const reach_design_result *d = &r->reach.design;
    char start[64], found[64] = "nothing", words[400];
    goal_words(d, d->start_goal, start, sizeof start);
    if (d->best >= 0 && d->best < d->nrow) {
        goal_words(d, d->row[d->best].goal, found, sizeof found);
    }
    say(c, side, 36, LOOK_TITLE, "Search for a design%s",
        r->reach.synthetic ? ", in synthetic anatomy" : "");
    (void)snprintf(words, sizeof words, "%s: %s at the start, %s found; %d evaluations, %d failed",
                   d->scope, start, found, d->evaluations, d->failed);
    say_within(c, side, 58, sheet_width - 2 * side, LOOK_TEXT, words);
    scores(c, d);
    say(c, bars_left, head + 2, LOOK_HEADING, "The best, within its bounds");
    for (int k = 0; k < d->nparameter; k++) {
        bar(c, d, k);
    }
    say(c, side, sheet_height(d) - 14, LOOK_SMALL,
        "A line per island: the best that it had found. Dashed, and strokes across: the case as it "
        "stands. Dots: the best design. Seed %d.",
        d->seed);
    return OK;
}

status figure_design(const run_result *r, const char *dir)
{
    if (!r->reach.there || !r->reach.design.there) {
        return OK;
    }
    const picture p = {
        .name = "design",
        .title = "The score of each island against its evaluations, and the best design",
        .width = sheet_width,
        .height = sheet_height(&r->reach.design),
        .draw = draw,
        .data = r,
    };
    return picture_write(&p, dir);
}
