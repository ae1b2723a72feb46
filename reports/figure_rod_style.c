// reports/figure_rod_style.c
#include "reports/figure_rod_style.h"

#include <math.h>
#include <stdio.h>

enum { COLUMNS = 3, MAX_ROWS = 8 };

static const double row = 19;

// the first tendons tell the families apart
enum { MOST_TOLD = 32 };

static unsigned pulled(const rod_result *rod, int solution)
{
    unsigned set = 0;
    for (int i = 0; i < rod->ntendon && i < MOST_TOLD; i++) {
        set |= rod->run[solution].tension[i] > 0 ? 1u << i : 0;
    }
    return set;
}

static double total_tension(const rod_result *rod, int solution)
{
    double sum = 0;
    for (int i = 0; i < rod->ntendon; i++) {
        sum += rod->run[solution].tension[i];
    }
    return sum;
}

// place of a solution's family among the families, in order of appearance, and of the solution
// within it by tension
typedef struct family {
    int number, count; // of the family, of families
    int rank, size;    // within it
} family;

static family family_of(const rod_result *rod, int solution)
{
    family f = {0};
    const unsigned own = pulled(rod, solution);
    for (int i = 0; i < rod->nsolution; i++) {
        const unsigned set = pulled(rod, i);
        int first = 1;
        for (int k = 0; k < i; k++) {
            first = first && pulled(rod, k) != set;
        }
        if (set == own) {
            f.number = first ? f.count : f.number;
            f.size++;
            const double mine = total_tension(rod, solution), other = total_tension(rod, i);
            f.rank += other < mine || (other == mine && i < solution);
        }
        f.count += first;
    }
    return f;
}

colour rod_ink(const rod_result *rod, int solution)
{
    const family f = family_of(rod, solution);
    const double part = f.size > 1 ? (double)f.rank / (f.size - 1) : 1;
    if (pulled(rod, solution) == 0) {
        return INK_FAINT;
    }
    if (f.count == 1 && f.size > 1) {
        return colour_ramp(0.8 - 0.8 * part);
    }
    const colour white = {1, 1, 1, 1}, hue = colour_series(f.number);
    return colour_mix(white, hue, 0.45 + 0.55 * part);
}

void rod_label(const rod_result *rod, int solution, char *text, size_t size)
{
    size_t used = 0;
    text[0] = 0;
    for (int i = 0; i < rod->ntendon; i++) {
        const double tension = rod->run[solution].tension[i];
        if (tension > 0 && used < size) {
            const int n = snprintf(text + used, size - used, "%s%s %s N", used ? ", " : "",
                                   rod->tendon_name[i], number_short(tension, 3).text);
            used += n > 0 ? (size_t)n : 0;
        }
    }
    if (used == 0) {
        (void)snprintf(text, size, "no tension");
    }
}

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

// families that stand side by side, one in each column, are read best
static int legend_rows(const rod_result *rod)
{
    int rows = (rod->nsolution + COLUMNS - 1) / COLUMNS, largest = 0;
    for (int i = 0; i < rod->nsolution; i++) {
        const family f = family_of(rod, i);
        largest = f.size > largest ? f.size : largest;
        if (f.count == 1) {
            return rows < MAX_ROWS ? rows : MAX_ROWS;
        }
    }
    rows = largest * COLUMNS >= rod->nsolution ? largest : rows;
    return rows < MAX_ROWS ? rows : MAX_ROWS;
}

double rod_legend_height(const rod_result *rod)
{
    return row * (legend_rows(rod) + (rod->nsolution > COLUMNS * MAX_ROWS));
}

static void note_text(const rod_result *rod, int solution, rod_note note, char *text, size_t size)
{
    if (note == ROD_NOTE_BEND) {
        const double bend = rod->run[solution].total_bend_rad * 180 / acos(-1.0);
        (void)snprintf(text, size, "bend %s°", number_fixed(bend, 1).text);
        return;
    }
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

static double widest_label(canvas *c, const rod_result *rod, int shown, double most)
{
    double widest = 0;
    for (int i = 0; i < rod->nsolution && i < shown; i++) {
        char label[256];
        rod_label(rod, i, label, sizeof label);
        widest = fmax(widest, canvas_text_width(c, &LOOK_SMALL, label));
    }
    return fmin(widest + 1, most);
}

void rod_legend(canvas *c, const rod_result *rod, box at, rod_note note)
{
    const int rows = legend_rows(rod), shown = rows * COLUMNS;
    const double width = at.w / COLUMNS, label_width = widest_label(c, rod, shown, 0.48 * width);
    for (int i = 0; i < rod->nsolution && i < shown; i++) {
        const double x = at.x + width * (i / rows), y = at.y + 12 + row * (i % rows);
        char label[256], number[160];
        rod_label(rod, i, label, sizeof label);
        note_text(rod, i, note, number, sizeof number);
        canvas_segment(c, x, y - 4, x + 24, y - 4);
        canvas_stroke(c, rod_ink(rod, i), 3);
        say_within(c, x + 32, y, label_width, look_inked(LOOK_SMALL, INK), label);
        canvas_text(c, x + 32 + label_width + 14, y, &LOOK_SMALL, number);
    }
    if (rod->nsolution > shown) {
        say(c, at.x, at.y + 12 + row * rows, LOOK_SMALL, "and %d more, drawn but not named",
            rod->nsolution - shown);
    }
}
