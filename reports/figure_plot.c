// reports/figure_plot.c
// Axes, scale bars and arrows of reports/figure_kit.h
#include "reports/figure_kit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

double nice_step(double span, int count)
{
    const double raw = span / (count > 0 ? count : 1);
    if (!(raw > 0) || !isfinite(raw)) {
        return 1;
    }
    const double power = pow(10, floor(log10(raw)));
    const double lead = raw / power;
    // the nearest in ratio: the geometric means of 1, 2, 5, 10
    return power * (lead < sqrt(2) ? 1 : lead < sqrt(10) ? 2 : lead < sqrt(50) ? 5 : 10);
}

double plot_x(const plot *p, double x)
{
    return p->at.x + p->at.w * (x - p->x0) / (p->x1 - p->x0);
}

double plot_y(const plot *p, double y)
{
    return p->at.y + p->at.h * (p->y1 - y) / (p->y1 - p->y0);
}

void range_pad(double *low, double *high, double part, double least)
{
    const double size = fmax(*high - *low, least), middle = 0.5 * (*low + *high);
    *low = middle - (0.5 + part) * size;
    *high = middle + (0.5 + part) * size;
}

static int decimals_of(double step)
{
    const int places = (int)ceil(-log10(step) - 1e-9);
    return places > 0 ? places : 0;
}

typedef struct ticks {
    double first, step;
    int count, decimals;
} ticks;

static ticks ticks_between(double low, double high, double points, double spacing)
{
    const double step = nice_step(high - low, (int)fmax(points / spacing, 1));
    const double first = ceil(low / step - 1e-9) * step;
    const double count = floor((high - first) / step + 1e-9) + 1;
    // a range that is none, or not finite, has no ticks
    const bool sound = count > 0 && count <= 2 + 4 * points / spacing;
    return (ticks){first, step, sound ? (int)count : 0, decimals_of(step)};
}

// what would have many zeros after its point takes a power of ten
static number_text tick_label(double value, const ticks *t)
{
    if (fabs(value) < 1e-9 * t->step) {
        return number_fixed(0, t->decimals > 4 ? 0 : t->decimals);
    }
    // a tick is a whole number of steps of one digit: no more digits than that
    const double digits = floor(log10(fabs(value)) + 1e-9) - floor(log10(t->step) + 1e-9) + 1;
    return t->decimals > 4 || fabs(value) >= 1e6 ? number_digits(value, (int)fmax(digits, 1))
                                                 : number_fixed(value, t->decimals);
}

static void x_ticks(canvas *c, const plot *p)
{
    const ticks t = ticks_between(p->x0, p->x1, p->at.w, 52);
    for (int i = 0; i < t.count; i++) {
        const double value = t.first + i * t.step, x = plot_x(p, value);
        canvas_segment(c, x, p->at.y, x, p->at.y + p->at.h);
        canvas_stroke(c, fabs(value) < 1e-9 * t.step ? INK_FAINT : INK_GRID, 0.8);
        say(c, x, p->at.y + p->at.h + 14, look_aligned(LOOK_TICK, TEXT_CENTRE), "%s",
            tick_label(value, &t).text);
    }
}

// returns the width of the widest label
static double y_ticks(canvas *c, const plot *p)
{
    const ticks t = ticks_between(p->y0, p->y1, p->at.h, 42);
    const text_look look = look_aligned(LOOK_TICK, TEXT_RIGHT);
    double widest = 0;
    for (int i = 0; i < t.count; i++) {
        const double value = t.first + i * t.step, y = plot_y(p, value);
        const number_text label = tick_label(value, &t);
        canvas_segment(c, p->at.x, y, p->at.x + p->at.w, y);
        canvas_stroke(c, fabs(value) < 1e-9 * t.step ? INK_FAINT : INK_GRID, 0.8);
        canvas_text(c, p->at.x - 6, y + 3.7, &look, label.text);
        widest = fmax(widest, canvas_text_width(c, &look, label.text));
    }
    return widest;
}

void plot_frame(canvas *c, const plot *p, const char *x_label, const char *y_label)
{
    const text_look look = look_aligned(look_inked(LOOK_SMALL, INK), TEXT_CENTRE);
    text_look upright = look;
    upright.turn = -0.5 * acos(-1.0);

    canvas_dash(c, 0, 0);
    x_ticks(c, p);
    const double widest = y_ticks(c, p);
    canvas_rectangle(c, p->at.x, p->at.y, p->at.w, p->at.h);
    canvas_stroke(c, INK_FAINT, 0.9);
    say(c, p->at.x + p->at.w / 2, p->at.y + p->at.h + 31, look, "%s", x_label);
    say(c, p->at.x - 13 - fmax(widest, 20), p->at.y + p->at.h / 2, upright, "%s", y_label);
}

static number_text power_of_ten(int n)
{
    static const char *const digit[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    number_text out = {{0}};
    const int m = abs(n);
    (void)snprintf(out.text, sizeof out.text, "10%s%s%s", n < 0 ? "⁻" : "",
                   m > 9 ? digit[m / 10 % 10] : "", digit[m % 10]);
    return out;
}

void plot_decades(canvas *c, const plot *p, const char *x_label, const char *y_label)
{
    text_look look = look_aligned(look_inked(LOOK_SMALL, INK), TEXT_CENTRE);
    canvas_dash(c, 0, 0);
    for (int n = (int)p->x0; n <= (int)p->x1; n++) {
        const double x = plot_x(p, n);
        canvas_segment(c, x, p->at.y, x, p->at.y + p->at.h);
        canvas_stroke(c, INK_GRID, 0.8);
        say(c, x, p->at.y + p->at.h + 15, look_aligned(LOOK_TICK, TEXT_CENTRE), "%s",
            power_of_ten(n).text);
    }
    for (int n = (int)p->y0; n <= (int)p->y1; n++) {
        const double y = plot_y(p, n);
        canvas_segment(c, p->at.x, y, p->at.x + p->at.w, y);
        canvas_stroke(c, INK_GRID, 0.8);
        say(c, p->at.x - 6, y + 4.5, look_aligned(LOOK_TICK, TEXT_RIGHT), "%s",
            power_of_ten(n).text);
    }
    canvas_rectangle(c, p->at.x, p->at.y, p->at.w, p->at.h);
    canvas_stroke(c, INK_FAINT, 0.9);
    say(c, p->at.x + p->at.w / 2, p->at.y + p->at.h + 34, look, "%s", x_label);
    look.turn = -0.5 * acos(-1.0);
    say(c, p->at.x - 46, p->at.y + p->at.h / 2, look, "%s", y_label);
}

void scale_bar(canvas *c, double right, double y, double wanted, double points_per_mm)
{
    const double length = nice_step(wanted / points_per_mm, 1), points = length * points_per_mm;
    canvas_segment(c, right - points, y, right, y);
    canvas_stroke(c, INK, 2.2);
    canvas_segment(c, right - points, y - 4, right - points, y + 4);
    canvas_segment(c, right, y - 4, right, y + 4);
    canvas_stroke(c, INK, 1.2);
    say(c, right - points / 2, y - 8, look_aligned(look_inked(LOOK_SMALL, INK), TEXT_CENTRE),
        "%s mm", number_fixed(length, decimals_of(length)).text);
}

// shaft and head as one outline
static bool arrow_path(canvas *c, double x0, double y0, double x1, double y1, double width)
{
    const double length = hypot(x1 - x0, y1 - y0);
    if (!(length > 0)) {
        return false;
    }
    const double ux = (x1 - x0) / length, uy = (y1 - y0) / length;
    const double head = fmin(4 * width + 2, 0.6 * length), half = 0.42 * head, w = width / 2;
    // along the arrow and to its right
    const double outline[7][2] = {{0, -w},     {length - head, -w},   {length - head, -half},
                                  {length, 0}, {length - head, half}, {length - head, w},
                                  {0, w}};
    for (int i = 0; i < 7; i++) {
        const double a = outline[i][0], b = outline[i][1];
        const double x = x0 + a * ux - b * uy, y = y0 + a * uy + b * ux;
        if (i == 0) {
            canvas_move(c, x, y);
        } else {
            canvas_line(c, x, y);
        }
    }
    canvas_close(c);
    return true;
}

void arrow(canvas *c, double x0, double y0, double x1, double y1, colour ink, double width)
{
    if (arrow_path(c, x0, y0, x1, y1, width)) {
        canvas_fill(c, ink);
    }
}

void arrow_bordered(canvas *c, double x0, double y0, double x1, double y1, colour ink, double width)
{
    if (arrow_path(c, x0, y0, x1, y1, width)) {
        canvas_stroke(c, PAPER, 2.4);
        arrow(c, x0, y0, x1, y1, ink, width);
    }
}

void arrow_hollow(canvas *c, double x0, double y0, double x1, double y1, colour ink, double width)
{
    if (arrow_path(c, x0, y0, x1, y1, width)) {
        canvas_fill_stroke(c, PAPER, ink, 1.1);
    }
}
