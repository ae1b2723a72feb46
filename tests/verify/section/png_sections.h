// Sections as images for the checks of png: drawn by a rule, opened, meshed, solved.
#pragma once

#include "section/section.h"
#include "tests/png_files.h"
#include "tests/test.h"

#include <unistd.h>

typedef struct printed {
    drawing *drawing;
    part_spec part[3];
    drawing_files files;
} printed;

// palette colours 1, 2, 3 are materials 0, 1, 2; of these as many as there are materials
static inline void open_printed(int width, int height, double pitch, bool smoothed, pixel_rule rule,
                                const void *context, int nmaterial, const material *materials,
                                printed *out)
{
    static const char *const colours[3] = {"#ff0000", "#00ff00", "#0000ff"};
    char path[64];
    (void)snprintf(path, sizeof path, "/tmp/stiffaxis-png-%d.png", (int)getpid());
    png_bytes b = png_draw(width, height, rule, context);
    CHECK(png_write(path, b));
    free(b.at);
    *out = (printed){0};
    for (int i = 0; i < nmaterial; i++) {
        out->part[i] = (part_spec){.at = {1, 1},
                                   .colour = {.text = colours[i], .at = {1, 1}},
                                   .material = {.text = materials[i].name, .at = {1, 1}}};
    }
    out->files.png = (png_spec){.at = {1, 1},
                                .file = {.text = path, .at = {1, 1}},
                                .parts = {.count = nmaterial, .items = out->part},
                                .pitch = {pitch, pitch},
                                .boundaries = smoothed};
    const drawing_request request = {.nmaterial = nmaterial, .materials = materials};
    CHECK_OK(drawing_open(&out->files, &request, &out->drawing));
    (void)remove(path);
}
