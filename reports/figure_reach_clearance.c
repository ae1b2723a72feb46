// reports/figure_reach_clearance.c
// How much room is left along every body: a strip per target, a block per scope.
#include "reports/figure_reach.h"
#include "reports/figures.h"
#include "reports/reach_show.h"
#include "reports/rod_show.h"

#include <math.h>
#include <stdio.h>

enum { ROWS = 40, LEVELS = 7, NONE = LEVELS, ACROSS = 2 };

static const double side = 28, head = 124, foot = 22, sheet_width = 1000, gap = 26, title = 36,
                    axis = 44, strip = 11, pitch = 16, names = 34, words_width = 100;

typedef struct strips {
    const run_result *r;
    int nrow, row[ROWS]; // targets
    double most;         // end of the ramp [m]
    double block;        // height of a scope's [points]
} strips;

typedef struct block {
    canvas *c;
    const strips *w;
    const reach_scope_result *scope;
    box at;          // of its strips
    double from, to; // s [m]
} block;

static colour level_ink(int level)
{
    return level == NONE ? NOT_LOOKED_AT
           : level == 0  ? INK_ACCENT
                         : colour_ramp((level - 1.0) / (LEVELS - 2));
}

// 0: less than what is asked for, then up the ramp; last: not looked at
static int level_of(const strips *w, const reach_answer *a, int point)
{
    const double room = a->room[point];
    if (isnan(room) || reach_part_of(&w->r->reach, a, point) != REACH_LOOKED_AT) {
        return NONE;
    }
    const double least = w->r->reach.clearance;
    const double share = (room - least) / (w->most - least);
    return room < least ? 0 : share < 1 ? 1 + (int)(share * (LEVELS - 1)) : LEVELS - 1;
}

static double s_at(const block *b, double s)
{
    return b->at.x + b->at.w * (s - b->from) / (b->to - b->from);
}

// where the piece of a body about point k begins
static double begin_of(const block *b, const reach_answer *a, int k)
{
    const double s = k <= 0           ? a->along[0]
                     : k >= a->npoint ? a->along[a->npoint - 1]
                                      : (a->along[k - 1] + a->along[k]) / 2;
    return s_at(b, s);
}

static void strip_path(const block *b, int row, int level)
{
    const reach_answer *a = &b->scope->answer[b->w->row[row]];
    for (int k = 0, end; k < a->npoint; k = end) {
        for (end = k + 1; end < a->npoint && level_of(b->w, a, end) == level_of(b->w, a, k);) {
            end++;
        }
        if (level_of(b->w, a, k) == level) {
            const double x = begin_of(b, a, k);
            canvas_rectangle(b->c, x, b->at.y + pitch * row, begin_of(b, a, end) - x, strip);
        }
    }
}

static void row_words(const block *b, int row)
{
    const int target = b->w->row[row];
    const reach_answer *a = &b->scope->answer[target];
    const bool reached = a->verdict == REACH_REACHED;
    const double y = b->at.y + pitch * row + strip - 1;
    const text_look look = look_inked(LOOK_TICK, reached ? REACH_YES : INK_ACCENT);
    say(b->c, b->at.x - 8, y, look_aligned(look, TEXT_RIGHT), "%s %d", reached ? "●" : "×",
        target + 1);
    if (a->npoint > 0 && isfinite(a->clearance)) {
        say(b->c, b->at.x + b->at.w + 8, y, look, "%s at %s",
            number_fixed(1e3 * a->clearance, 2).text, number_fixed(1e3 * a->s, 1).text);
    } else {
        say(b->c, b->at.x + b->at.w + 8, y, look, "%s",
            reach_told_words(&b->w->r->reach, b->scope, a));
    }
}

static void least_mark(const block *b, int row)
{
    const reach_answer *a = &b->scope->answer[b->w->row[row]];
    const double x = s_at(b, a->s), y = b->at.y + pitch * row;
    if (a->npoint > 0 && x >= b->at.x && x <= b->at.x + b->at.w) {
        canvas_move(b->c, x - 3, y - 3);
        canvas_line(b->c, x + 3, y - 3);
        canvas_line(b->c, x, y + 2.5);
        canvas_close(b->c);
    }
}

static void s_axis(const block *b)
{
    const double bottom = b->at.y + pitch * b->w->nrow;
    const double step = nice_step(1e3 * (b->to - b->from), 6) / 1e3;
    const double first = ceil(b->from / step);
    for (int i = 0; i < 20 && (first + i) * step <= b->to; i++) {
        const double k = first + i;
        const double x = s_at(b, k * step);
        canvas_segment(b->c, x, bottom, x, bottom + 4);
        canvas_stroke(b->c, INK_FAINT, 0.8);
        say(b->c, x, bottom + 15, look_aligned(LOOK_TICK, TEXT_CENTRE), "%s",
            number_short(1e3 * k * step, 4).text);
    }
    say(b->c, b->at.x + b->at.w / 2, bottom + 29, look_aligned(LOOK_SMALL, TEXT_CENTRE),
        "arclength s (below 0: the shaft), mm");
    if (b->from < 0 && b->to > 0) {
        canvas_segment(b->c, s_at(b, 0), b->at.y - 4, s_at(b, 0), bottom + 4);
        canvas_stroke(b->c, INK, 0.9);
    }
}

static void scope_block(canvas *c, const strips *w, int scope)
{
    const reach_result *r = &w->r->reach;
    const double width = (sheet_width - 2 * side - (ACROSS - 1) * gap) / ACROSS;
    const double x = side + (width + gap) * (scope % ACROSS),
                 y = head + w->block * (scope / ACROSS);
    const box at = {x + names, y + title - 18, width - names - words_width, pitch * w->nrow};
    block b = {c, w, &r->scope[scope], at, INFINITY, -INFINITY};
    char count[REACH_TEXT], words[REACH_TEXT + REACH_NAME];
    (void)snprintf(words, sizeof words, "%s: %s", b.scope->name,
                   reach_count_words(r, scope, count));
    say_within(c, x, y, width, LOOK_HEADING, words);
    for (int i = 0; i < w->nrow; i++) {
        const reach_answer *a = &b.scope->answer[w->row[i]];
        b.from = a->npoint > 1 ? fmin(b.from, a->along[0]) : b.from;
        b.to = a->npoint > 1 ? fmax(b.to, a->along[a->npoint - 1]) : b.to;
        row_words(&b, i);
    }
    if (!(b.to > b.from && isfinite(b.to - b.from))) {
        return;
    }
    canvas_clip(c, at.x - 1, at.y - 5, at.w + 2, at.h + 5);
    for (int level = 0; level <= NONE; level++) {
        for (int i = 0; i < w->nrow; i++) {
            strip_path(&b, i, level);
        }
        canvas_fill(c, level_ink(level));
    }
    for (int i = 0; i < w->nrow; i++) {
        least_mark(&b, i);
    }
    canvas_fill_stroke(c, INK, PAPER, 0.6);
    canvas_unclip(c);
    s_axis(&b);
}

static void ramp_key(canvas *c, const strips *w, double x, double y)
{
    static const double wide = 46;
    const double least = w->r->reach.clearance;
    for (int i = 0; i < LEVELS; i++) {
        canvas_rectangle(c, x + wide * i, y - 9, wide, 10);
        canvas_fill(c, level_ink(i));
        if (i > 0) {
            say(c, x + wide * i, y + 14, look_aligned(LOOK_TICK, TEXT_CENTRE), "%s",
                number_short(1e3 * (least + (w->most - least) * (i - 1) / (LEVELS - 1)), 3).text);
        }
    }
    const double left = x + wide * LEVELS + 14;
    char words[256];
    (void)snprintf(
        words, sizeof words,
        "mm between skin and tissue; red: %s; pale: outside or channel. At the right: the "
        "least, mm, at s, mm.",
        least > 0 ? "less than asked for" : "within the tissue");
    (void)say_paragraph(c, left, y, sheet_width - side - left, LOOK_SMALL, words);
}

static double sheet_height(const strips *w)
{
    return head + w->block * ((w->r->reach.nscope + ACROSS - 1) / ACROSS) + foot;
}

static status draw(canvas *c, const void *data)
{
    const strips *w = data;
    const reach_result *r = &w->r->reach;
    say(c, side, 36, LOOK_TITLE, "Room along each body%s",
        r->ntarget > ROWS ? ", of some of the targets" : "");
    reach_source_line(c, side, 56, sheet_width - 2 * side, w->r);
    ramp_key(c, w, side, 78);
    for (int i = 0; i < r->nscope; i++) {
        scope_block(c, w, i);
    }
    return OK;
}

status figure_reach_clearance(const run_result *r, const char *dir)
{
    strips w = {.r = r};
    if (!r->reach.there || r->reach.nscope < 1 || r->reach.ntarget < 1) {
        return OK;
    }
    w.nrow = rod_spread(r->reach.ntarget, ROWS, w.row);
    w.block = title + pitch * w.nrow + axis;
    for (int i = 0; i < r->reach.nscope; i++) {
        w.most = fmax(w.most, 3 * r->reach.scope[i].radius);
    }
    w.most = fmax(w.most, 1e-9) + r->reach.clearance;
    const picture p = {
        .name = "reach_clearance",
        .title = "The room between each body and the tissue, along the body",
        .width = sheet_width,
        .height = sheet_height(&w),
        .draw = draw,
        .data = &w,
    };
    return picture_write(&p, dir);
}
