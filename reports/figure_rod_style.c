// reports/figure_rod_style.c
#include "reports/figure_rod_style.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { COLUMNS = 3, MAX_ROWS = 8 };

static const double row = 19;

// --- names

typedef struct words {
    char *text;
    size_t size, used;
} words;

static void add(words *w, const char *format, ...) __attribute__((format(printf, 2, 3)));

// whole or not at all: half a number is another one. What is left off is told, and ends the words
static void add(words *w, const char *format, ...)
{
    static const char more[] = " …";
    va_list arguments;
    va_start(arguments, format);
    if (w->used + sizeof more < w->size) {
        const size_t room = w->size - w->used - sizeof more + 1;
        const int n = vsnprintf(w->text + w->used, room, format, arguments);
        if (n >= 0 && (size_t)n < room) {
            w->used += (size_t)n;
        } else {
            memcpy(w->text + w->used, more, sizeof more);
            w->used = w->size;
        }
    }
    va_end(arguments);
}

static void add_tendon(words *w, const rod_result *rod, const struct rod_run *run, int i)
{
    const char *comma = w->used ? ", " : "", *name = rod->tendon_name[i];
    const number_text tension = number_short(run->tension[i], 3);
    if (result_is_slack(run, i)) {
        add(w, "%s%s drawn %s mm (slack)", comma, name, number_short(1e3 * run->pull[i], 3).text);
    } else if (!isnan(run->pull[i])) {
        add(w, "%s%s drawn %s mm (%s N)", comma, name, number_short(1e3 * run->pull[i], 3).text,
            tension.text);
    } else if (run->tension[i] > 0) {
        add(w, "%s%s %s N", comma, name, tension.text);
    }
}

void rod_label(const rod_show *show, int solution, char *text, size_t size)
{
    const rod_result *rod = show->rod;
    const struct rod_run *run = &rod->run[solution];
    words w = {text, size, 0};
    text[0] = 0;
    for (int i = 0; i < rod->ntendon; i++) {
        add_tendon(&w, rod, run, i);
    }
    if (w.used == 0) {
        add(&w, rod->ntendon > 0 ? "no tension" : "loads alone");
    }
    for (int i = 0; i < rod->nload && show->factors_vary; i++) {
        add(&w, ", %s ×%s", rod->load_name[i], number_short(run->load[i], 3).text);
    }
}

// whether it differs from line to line and not along this one
static bool tells_lines_apart(const rod_show *show, const rod_line *line, rod_quantity q)
{
    const rod_result *rod = show->rod;
    const double value = rod_quantity_value(&rod->run[line->first], q);
    bool differs = false;
    for (int i = 0; i < show->nline; i++) {
        differs = differs || rod_quantity_value(&rod->run[show->line[i].first], q) != value;
    }
    return differs &&
           (line->count == 1 || rod_quantity_value(&rod->run[line->first + 1], q) == value);
}

static void line_label(const rod_show *show, const rod_line *line, char *text, size_t size)
{
    const rod_result *rod = show->rod;
    words w = {text, size, 0};
    char name[2 * RESULT_NAME];
    const struct rod_run *first = &rod->run[line->first];
    text[0] = 0;
    for (int kind = 0; kind < GIVEN_KINDS; kind++) {
        for (int i = 0; i < (kind == GIVEN_LOAD ? rod->nload : rod->ntendon); i++) {
            const rod_quantity q = {kind, i};
            if (tells_lines_apart(show, line, q)) {
                rod_quantity_name(rod, q, name, sizeof name);
                add(&w, "%s%s %s %s", w.used ? ", " : "", name,
                    number_short(rod_quantity_value(first, q), 3).text, rod_quantity_unit(q));
            }
        }
    }
    rod_quantity_name(rod, line->lead, name, sizeof name);
    if (w.used == 0) {
        add(&w, "%s %s to %s %s", name, number_short(rod_quantity_value(first, line->lead), 3).text,
            number_short(rod_quantity_value(&rod->run[line->first + line->count - 1], line->lead),
                         3)
                .text,
            rod_quantity_unit(line->lead));
    }
}

// --- notes

curvature_range rod_curvature_range(const rod_result *rod, int solution)
{
    const struct rod_run *run = &rod->run[solution];
    curvature_range c = {.least = INFINITY};
    for (int i = 0; i < rod->npoint; i++) {
        const double size = hypot(run->curvature[i][0], run->curvature[i][1]);
        if (size < c.least) {
            c.least = size;
            c.at = run->s[i];
        }
        c.largest = fmax(c.largest, size);
        c.base = i == 0 ? size : c.base;
        c.tip = size;
    }
    return c;
}

static void bend_text(const struct rod_run *run, char *text, size_t size)
{
    const number_text bend = number_fixed(run->total_bend_rad * 180 / acos(-1.0), 1);
    if (run->fraction < 1) {
        (void)snprintf(text, size, "bend %s° at %s", bend.text,
                       number_fixed(run->fraction, 3).text);
    } else {
        (void)snprintf(text, size, "bend %s°", bend.text);
    }
}

static void curvature_text(const rod_result *rod, int solution, char *text, size_t size)
{
    const curvature_range k = rod_curvature_range(rod, solution);
    const number_text least = number_fixed(k.least, 1);
    if (k.least < 0.95 * fmin(k.base, k.tip)) {
        (void)snprintf(text, size, "|κ| %s → %s → %s 1/m", number_fixed(k.base, 1).text, least.text,
                       number_fixed(k.tip, 1).text);
    } else if (k.largest - k.least < 1e-3 * k.largest) {
        (void)snprintf(text, size, "|κ| %s 1/m", least.text);
    } else {
        (void)snprintf(text, size, "|κ| %s to %s 1/m", least.text, number_fixed(k.largest, 1).text);
    }
}

static void note_text(const rod_result *rod, int solution, rod_note note, char *text, size_t size)
{
    text[0] = 0;
    if (note == ROD_NOTE_BEND) {
        bend_text(&rod->run[solution], text, size);
    } else if (note == ROD_NOTE_CURVATURE) {
        curvature_text(rod, solution, text, size);
    }
}

// --- legend

static int entries(const rod_show *show)
{
    return show->sweep ? show->nline : show->rod->nsolution;
}

// families that stand side by side, one in each column, are read best
static int legend_rows(const rod_show *show)
{
    int rows = (entries(show) + COLUMNS - 1) / COLUMNS, largest = 0;
    for (int i = 0; i < show->nline && !show->sweep; i++) {
        largest = show->line[i].count > largest ? show->line[i].count : largest;
    }
    const bool side_by_side = show->nline > 1 && largest * COLUMNS >= entries(show);
    rows = side_by_side && largest > 1 ? largest : rows;
    return rows < MAX_ROWS ? rows : MAX_ROWS;
}

static bool one_bar(const rod_show *show)
{
    return show->sweep && show->nline == 1;
}

double rod_legend_height(const rod_show *show)
{
    return one_bar(show) ? 2 * row
                         : row * (legend_rows(show) + (entries(show) > COLUMNS * MAX_ROWS));
}

static void entry_label(const rod_show *show, int i, char *text, size_t size)
{
    if (show->sweep) {
        line_label(show, &show->line[i], text, size);
    } else {
        rod_label(show, i, text, size);
    }
}

static double widest_label(canvas *c, const rod_show *show, int shown, double most)
{
    double widest = 0;
    for (int i = 0; i < entries(show) && i < shown; i++) {
        char label[256];
        entry_label(show, i, label, sizeof label);
        widest = fmax(widest, canvas_text_width(c, &LOOK_SMALL, label));
    }
    return fmin(widest + 1, most);
}

// the colours along the one line of a sweep
static void bar(canvas *c, const rod_show *show, box at)
{
    const double width = 260, thick = 10;
    const rod_result *rod = show->rod;
    const rod_line *l = &show->line[0];
    char name[2 * RESULT_NAME];
    rod_quantity_name(rod, l->lead, name, sizeof name);
    for (int i = 0; i < show->nshown; i++) {
        canvas_rectangle(c, at.x + width * i / show->nshown, at.y + 4, width / show->nshown + 0.4,
                         thick);
        canvas_fill(c, show->ink[show->shown[i]]);
    }
    const text_look look = look_inked(LOOK_SMALL, INK);
    say(c, at.x, at.y + 29, look, "%s %s",
        number_short(rod_quantity_value(&rod->run[0], l->lead), 4).text,
        rod_quantity_unit(l->lead));
    say(c, at.x + width, at.y + 29, look_aligned(look, TEXT_RIGHT), "%s %s",
        number_short(rod_quantity_value(&rod->run[l->count - 1], l->lead), 4).text,
        rod_quantity_unit(l->lead));
    say_within(c, at.x + width + 16, at.y + 13, at.w - width - 16, look, name);
    say(c, at.x + width + 16, at.y + 29, LOOK_SMALL, "%d solutions", rod->nsolution);
}

void rod_legend(canvas *c, const rod_show *show, box at, rod_note note)
{
    const int rows = legend_rows(show), shown = rows * COLUMNS;
    const int columns = (entries(show) + rows - 1) / rows;
    const double width = at.w / (columns < COLUMNS ? columns : COLUMNS);
    const bool plain = show->sweep || note == ROD_NOTE_NONE;
    const double label_width = widest_label(c, show, shown, plain ? width - 44 : 0.46 * width);
    if (one_bar(show)) {
        bar(c, show, at);
        return;
    }
    for (int i = 0; i < entries(show) && i < shown; i++) {
        const double x = at.x + width * (i / rows), y = at.y + 12 + row * (i % rows);
        char label[256], number[160];
        entry_label(show, i, label, sizeof label);
        canvas_segment(c, x, y - 4, x + 24, y - 4);
        if (!show->sweep && show->rod->run[i].stable == 0) {
            canvas_dash(c, 5, 2.5);
        }
        canvas_stroke(c, show->ink[show->sweep ? show->line[i].first : i], 3);
        canvas_dash(c, 0, 0);
        say_within(c, x + 32, y, label_width, look_inked(LOOK_SMALL, INK), label);
        if (!plain) {
            note_text(show->rod, i, note, number, sizeof number);
            say_within(c, x + 32 + label_width + 14, y, width - label_width - 50, LOOK_SMALL,
                       number);
        }
    }
    if (entries(show) > shown) {
        say(c, at.x, at.y + 12 + row * rows, LOOK_SMALL, "and %d more, not named",
            entries(show) - shown);
    }
}
