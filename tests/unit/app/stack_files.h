// tests/unit/app/stack_files.h
// Stacks of small images in a directory of their own.
#pragma once

#include "tests/png_files.h"
#include "tests/test.h"

#include <unistd.h>

enum { SIDE = 12, SLICES = 4 };

// A square of 12 x 12 pixels with a stiff column in its corner that steps by a column per slice; in
// CUT only the left three columns are there, in FAR only the right three; in PLAIN the stiff column
// does not step.
typedef enum slice_kind { WHOLE, CUT, FAR, PLAIN } slice_kind;
typedef struct slice_rule {
    int index;
    slice_kind kind;
} slice_rule;

static inline int draw_slice(double x, double y, const void *context)
{
    const slice_rule *r = context;
    if ((r->kind == CUT && x > -3) || (r->kind == FAR && x < 3)) {
        return 0;
    }
    const int column = (int)(x + SIDE / 2.0), row = (int)(y + SIDE / 2.0);
    const int first = r->kind == PLAIN ? 0 : r->index;
    return row < 2 && column >= first && column < first + 2 ? 2 : 1;
}

typedef struct stack {
    char path[64], text[600];
} stack;

static inline stack write_stack(const slice_kind *kind)
{
    stack s = {.path = "/tmp/stiffaxis-stack-XXXXXX"};
    CHECK(mkdtemp(s.path) != NULL);
    for (int i = 0; i < SLICES; i++) {
        char name[128];
        const slice_rule rule = {i, kind[i]};
        const png_bytes b = png_draw(SIDE, SIDE, draw_slice, &rule);
        (void)snprintf(name, sizeof name, "%s/s%02d.png", s.path, i);
        CHECK(png_write(name, b));
        free(b.at);
    }
    (void)snprintf(s.text, sizeof s.text,
                   "  png:\n    file: %s/s%%02d.png\n    pitch_mm: [0.5, 0.5]\n    layer_mm: 2\n"
                   "    parts: [{colour: '#ff0000', material: soft}, {colour: '#00ff00', material: "
                   "stiff}]\n",
                   s.path);
    return s;
}

static inline void remove_stack(const stack *s)
{
    for (int i = 0; i < SLICES; i++) {
        char name[128];
        (void)snprintf(name, sizeof name, "%s/s%02d.png", s->path, i);
        (void)unlink(name);
    }
    (void)rmdir(s->path);
}
