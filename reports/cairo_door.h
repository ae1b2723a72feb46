// reports/cairo_door.h
// A sheet to draw on. cairo stands behind it: its types stay in cairo_door.c.
//
// Lengths are units of SHEET_MM from the upper left corner, y downwards; angles [rad] from x
// towards y. A failure is kept until the picture is written; drawing on after one does nothing.
#pragma once

#include "base/status.h"

// A unit of a drawing on paper [mm]: 1000 units, the widest sheet, fill both columns of a journal's
// page (174 mm to 190 mm with the large publishers). The same for all, so letters are of one size.
#define SHEET_MM 0.18

// The smallest letters [units]: 7 points of 1/72 inch on paper, the least that publishers print
#define SMALLEST_LETTERS (7 * 25.4 / 72 / SHEET_MM)

typedef struct canvas canvas;

typedef struct colour {
    double r, g, b, a; // 0..1; a = 1 is opaque
} colour;

typedef enum text_align { TEXT_LEFT, TEXT_CENTRE, TEXT_RIGHT } text_align;
typedef enum text_style { TEXT_PLAIN, TEXT_BOLD, TEXT_ITALIC } text_style;

typedef struct text_look {
    double size; // height of the letters' box [units], at least SMALLEST_LETTERS
    text_align align;
    text_style style;
    colour ink;
    double turn; // of the base line [rad]
    double halo; // width of a white border around the letters [units]
} text_look;

// A path is begun by canvas_move or one of the shapes and is used up by fill, stroke or both.
void canvas_move(canvas *c, double x, double y);
void canvas_line(canvas *c, double x, double y);
void canvas_close(canvas *c);
void canvas_segment(canvas *c, double x0, double y0, double x1, double y1);
void canvas_rectangle(canvas *c, double x, double y, double w, double h);
void canvas_circle(canvas *c, double x, double y, double radius);

void canvas_fill(canvas *c, colour ink); // a loop that turns the other way inside another is a hole
void canvas_stroke(canvas *c, colour ink, double width);
void canvas_fill_stroke(canvas *c, colour ink, colour border, double width);
void canvas_dash(canvas *c, double on, double off); // of later strokes; 0, 0 is solid

// x, y: where the base line starts, is centred or ends. Bytes that are not UTF-8 are shown as '?'.
void canvas_text(canvas *c, double x, double y, const text_look *look, const char *text);
double canvas_text_width(canvas *c, const text_look *look, const char *text);

// Until canvas_unclip only this rectangle is painted; the two also keep and restore the dash.
void canvas_clip(canvas *c, double x, double y, double w, double h);
void canvas_unclip(canvas *c);

typedef struct picture {
    const char *name;     // of its files, and in front of every id in the SVG: letters and digits
    const char *title;    // what a screen reader says
    double width, height; // [units]
    status (*draw)(canvas *c, const void *data);
    const void *data;
} picture;

// DIR/name.svg, DIR/name.pdf (its letters within) and DIR/name.png (two pixels to the unit) by the
// same routine; the same bytes every time. ERR_RESOURCE when a file cannot be written.
status picture_write(const picture *p, const char *dir);
