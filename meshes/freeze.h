// meshes/freeze.h
// One shape at one arclength: numbers taken from their fields and checked.
#pragma once

#include "meshes/shape.h"

// The outline to fill; its kind, place and name are known.
typedef struct freezer {
    outline *o;
    double s;
} freezer;

// Drawings outside of these sizes are mistakes of unit, and their squares would leave the range of
// the checks [m].
#define SMALLEST_DRAWING 1e-10
#define LARGEST_DRAWING 1e7

typedef struct freeze_words {
    char a[40];
} freeze_words;

// " at s = 12 mm" where a number varies along the rod, else nothing
freeze_words freeze_where(const freezer *f, const field *a, const field *b);

// ERR_INPUT where it is not finite; a length, where it is not more than 0. `name`: of the key.
status freeze_number(const freezer *f, const field *from, const char *name, double *out);
status freeze_length(const freezer *f, const field *from, const char *name, double *out);
status freeze_centre(const freezer *f, const field *from);

status freeze_ring(const freezer *f, const ring_spec *ring);
status freeze_disc(const freezer *f, const disc_spec *disc);
status freeze_rectangle(const freezer *f, const rectangle_spec *rectangle);
status freeze_polygon(const freezer *f, const polygon_spec *polygon);

// freeze_curves.c: outlines of KIND_LOOPS
status freeze_ellipse(const freezer *f, const ellipse_spec *ellipse);
status freeze_rounded(const freezer *f, const rounded_spec *rounded);
status freeze_spline(const freezer *f, const polygon_spec *spline);

// Rows without a last one that repeats the first: people close loops so.
int freeze_row_count(const key_rows *rows);
