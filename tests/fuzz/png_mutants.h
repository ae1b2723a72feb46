// Spoiled images: opened, and what is sound is meshed. Half of them with their check sums set
// right again, since libpng looks no further than a wrong one.
#pragma once

#include "meshes/drawing.h"
#include "tests/fuzz/mutate.h"
#include "tests/png_files.h"

enum { PNG_SEEDS = 5 };

typedef struct png_mutants {
    png_bytes seed[PNG_SEEDS];
    mutant_seed list[PNG_SEEDS];
    int turn;
} png_mutants;

static inline int png_mutant_rule(double x, double y, const void *unused)
{
    (void)unused;
    const double r = x * x + y * y;
    return r > 90 || r < 20 ? 0 : x > 0 && y > 0 ? 2 : 1;
}

static inline void png_mutant_seeds(png_mutants *m)
{
    static const unsigned char opacity[1] = {0}, grey[] = {0, 10, 0, 20, 0, 30, 40};
    unsigned char deep[4 * (1 + 4 * 8)], bits[9] = {0, 0x1b, 0xe4, 0, 0xff, 0x55, 0, 0xaa, 0};
    for (size_t i = 0; i < sizeof deep; i++) {
        deep[i] = (unsigned char)(i % 33 == 0 ? (i / 33) % 5 : i * 7); // every filter
    }
    m->seed[0] = png_draw(20, 20, png_mutant_rule, NULL);
    m->seed[1] = png_draw(64, 48, png_mutant_rule, NULL);
    m->seed[2] = png_encode(&(png_layout){.width = 4, .height = 4, .depth = 16, .kind = 6}, deep,
                            sizeof deep);
    m->seed[3] =
        png_encode(&(png_layout){.width = 2, .height = 2, .depth = 8, .kind = 0, .interlaced = 1},
                   grey, sizeof grey);
    m->seed[4] = png_encode(&(png_layout){.width = 8,
                                          .height = 3,
                                          .depth = 2,
                                          .kind = 3,
                                          .palette = png_palette,
                                          .npalette = 12,
                                          .opacity = opacity,
                                          .nopacity = 1},
                            bits, sizeof bits);
    for (int i = 0; i < PNG_SEEDS; i++) {
        m->list[i] = (mutant_seed){.bytes = m->seed[i].at, .count = m->seed[i].count};
    }
}

static inline uint32_t png_get_number(const unsigned char *at)
{
    return (uint32_t)at[0] << 24 | (uint32_t)at[1] << 16 | (uint32_t)at[2] << 8 | at[3];
}

// the check sums of all whole chunks
static inline void png_mend(png_bytes b)
{
    for (size_t at = 8; at + 12 <= b.count;) {
        const size_t n = png_get_number(b.at + at);
        if (n > b.count - at - 12) {
            break;
        }
        png_bytes sum = {b.at + at + 8 + n, 0};
        png_put_number(&sum, png_crc(b.at + at + 4, n + 4));
        at += 12 + n;
    }
}

static inline void png_mend_file(const char *directory, const char *name)
{
    char path[512];
    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    FILE *f = fopen(path, "rb");
    png_bytes b = {malloc(1 << 20), 0};
    b.count = f ? fread(b.at, 1, 1 << 20, f) : 0;
    if (f) {
        (void)fclose(f);
    }
    png_mend(b);
    (void)png_write(path, b);
    free(b.at);
}

static inline status png_mutant_read(const char *directory, const char *name, void *context)
{
    static const material materials[2] = {{.name = "a", .E = 1, .nu = 0.3},
                                          {.name = "b", .E = 2, .nu = 0.3}};
    static part_spec parts[] = {
        {.colour = {.text = "#ff0000"}, .material = {.text = "a"}},
        {.colour = {.text = "#00ff00"}, .material = {.text = "b"}},
        {.colour = {.text = "#0a0a0a"}, .material = {.text = "a"}},
        {.colour = {.text = "#141414"}, .material = {.text = "none"}},
    };
    png_mutants *m = context;
    const int turn = m->turn++;
    if (turn % 2) {
        png_mend_file(directory, name);
    }
    const drawing_files files = {.png = {.at = {1, 1},
                                         .file = {.text = name},
                                         .parts = {.count = 4, .items = parts},
                                         .pitch = {1e-3, 1e-3},
                                         .boundaries = turn / 2 % 2}};
    const drawing_request request = {
        .directory = directory, .nmaterial = 2, .materials = materials};
    const mesh_options options = {.order = 1 + turn % 3};
    drawing *d = NULL;
    mesh fine = {0}, coarse = {0};
    bool found = false;
    status st = drawing_open(&files, &request, &d);
    if (st == OK) {
        st = drawing_mesh(d, 0, &options, &fine);
    }
    if (st == OK) {
        st = drawing_mesh_coarser(d, 0, &options, &coarse, &found);
    }
    mesh_free(&fine);
    mesh_free(&coarse);
    drawing_free(d);
    return st;
}

static inline mutant_plan png_mutant_plan(png_mutants *m)
{
    png_mutant_seeds(m);
    return (mutant_plan){.nseed = PNG_SEEDS,
                         .seeds = m->list,
                         .suffix = ".png",
                         .read = png_mutant_read,
                         .context = m,
                         .state = 1};
}

static inline void png_mutants_free(png_mutants *m)
{
    for (int i = 0; i < PNG_SEEDS; i++) {
        free(m->seed[i].at);
    }
}
