// reports/figure_kit.h
// What the figures share: inks, letters, axes, scale bars, arrows and the way a number is written.
#pragma once

#include "reports/cairo_door.h"
#include "reports/palette.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct box {
    double x, y, w, h; // [points]
} box;

extern const text_look LOOK_TITLE, LOOK_HEADING, LOOK_TEXT, LOOK_SMALL, LOOK_TICK;

text_look look_aligned(text_look look, text_align align);
text_look look_inked(text_look look, colour ink);
text_look look_haloed(text_look look);

// A number with that many significant digits, 1.2×10⁻⁵ where it is very large or small, a true
// minus sign; zero is 0.
typedef struct number_text {
    char text[40];
} number_text;
number_text number_digits(double value, int digits);
number_text number_short(double value,
                         int digits); // zeros at the end left off: for numbers of the case
number_text number_fixed(double value, int decimals);

void say(canvas *c, double x, double y, text_look look, const char *format, ...)
    __attribute__((format(printf, 5, 6)));
// One line, cut with an ellipsis to that width.
void say_within(canvas *c, double x, double y, double width, text_look look, const char *text);
// Words wrapped to that width; returns the y of the line after the last.
double say_paragraph(canvas *c, double x, double y, double width, text_look look, const char *text);

// 1, 2 or 5 times a power of ten, so that `span` holds about `count` steps.
double nice_step(double span, int count);

typedef struct plot {
    box at;
    double x0, x1, y0, y1; // the values at the box's edges
} plot;

double plot_x(const plot *p, double x);
double plot_y(const plot *p, double y);

// A frame with grid, ticks and labels outside of it: up to 58 points to the left and 34 below are
// taken.
void plot_frame(canvas *c, const plot *p, const char *x_label, const char *y_label);

// The same with both axes logarithmic: p's values are powers of ten, its edges whole ones.
void plot_decades(canvas *c, const plot *p, const char *x_label, const char *y_label);

// Widens [*low, *high] by that part of its size; a range of nothing becomes `least` wide.
void range_pad(double *low, double *high, double part, double least);

// A bar of a round length, `size_mm` points to the mm; its text stands above it. About `wanted`
// points long.
void scale_bar(canvas *c, double right, double y, double wanted, double points_per_mm);

void arrow(canvas *c, double x0, double y0, double x1, double y1, colour ink, double width);
// Only its outline, filled with white.
void arrow_hollow(canvas *c, double x0, double y0, double x1, double y1, colour ink, double width);
// With a white border, to stand out against what it lies on.
void arrow_bordered(canvas *c, double x0, double y0, double x1, double y1, colour ink,
                    double width);
