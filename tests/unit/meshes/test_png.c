// Images of every layout, refused ones, stacks; tests/verify holds the sections they make.
#include "meshes/drawing.h"
#include "meshes/png_door.h"
#include "tests/fuzz/png_mutants.h"
#include "tests/test.h"

#include <sys/stat.h>
#include <unistd.h>

typedef struct folder {
    char name[64];
} folder;

static folder make_folder(void)
{
    folder f = {"/tmp/stiffaxis-png-XXXXXX"};
    CHECK(mkdtemp(f.name) != NULL);
    return f;
}

static void put_file(const folder *f, const char *name, png_bytes b)
{
    char path[128];
    (void)snprintf(path, sizeof path, "%s/%s", f->name, name);
    CHECK(png_write(path, b));
    free(b.at);
}

static void drop_file(const folder *f, const char *name)
{
    char path[128];
    (void)snprintf(path, sizeof path, "%s/%s", f->name, name);
    CHECK(remove(path) == 0);
}

// what the next opening is to fail with, and words of its message
static bool refused(status st, status wanted, const char *words)
{
    const bool good = st == wanted && strstr(status_message(), words) != NULL &&
                      strchr(status_message(), '\n') == NULL;
    if (!good) {
        printf("status %d, \"%s\" instead of %d, \"...%s...\"\n", (int)st, status_message(),
               (int)wanted, words);
    }
    status_clear();
    return good;
}

static const material two[2] = {{.name = "soft", .E = 1, .nu = 0.3},
                                {.name = "stiff", .E = 5, .nu = 0.3}};

static part_spec red_and_green[2] = {
    {.at = {1, 1}, .colour = {.text = "#ff0000"}, .material = {.text = "soft"}},
    {.at = {1, 1}, .colour = {.text = "#00ff00"}, .material = {.text = "stiff"}},
};

static drawing_files file_named(const char *name)
{
    return (drawing_files){.png = {.at = {1, 1},
                                   .file = {.text = name, .at = {3, 5}},
                                   .parts = {.count = 2, .items = red_and_green},
                                   .pitch = {1e-3, 2e-3}}};
}

static status open_in(const folder *f, const drawing_files *files, drawing **out)
{
    const drawing_request request = {.directory = f->name, .nmaterial = 2, .materials = two};
    return drawing_open(files, &request, out);
}

static status open_bytes(const folder *f, png_bytes b)
{
    const drawing_files files = file_named("x.png");
    drawing *d = NULL;
    put_file(f, "x.png", b);
    const status st = open_in(f, &files, &d);
    drawing_free(d);
    drop_file(f, "x.png");
    return st;
}

// --- layouts

// the colour of a pixel
static unsigned colour(const colour_image *p, int x, int y)
{
    const unsigned char *c = p->rgba + 4 * (y * p->width + x);
    return (unsigned)c[0] << 24 | (unsigned)c[1] << 16 | (unsigned)c[2] << 8 | c[3];
}

static colour_image decode(png_layout l, const unsigned char *rows, size_t count)
{
    colour_image image = {0};
    png_bytes b = png_encode(&l, rows, count);
    char path[] = "memory";
    const input_file f = {.path = path, .bytes = b.at, .count = b.count};
    CHECK_OK(png_door_read(&f, &image));
    CHECK(image.width == l.width && image.height == l.height);
    free(b.at);
    return image;
}

static void every_layout_becomes_eight_bit_colours(void)
{
    const unsigned char rgb[] = {0, 255, 0, 0, 1, 2, 3, 0, 9, 8, 7, 0, 0, 255};
    colour_image p =
        decode((png_layout){.width = 2, .height = 2, .depth = 8, .kind = 2}, rgb, sizeof rgb);
    CHECK(colour(&p, 0, 0) == 0xff0000ffu && colour(&p, 1, 0) == 0x010203ffu);
    CHECK(colour(&p, 0, 1) == 0x090807ffu && colour(&p, 1, 1) == 0x0000ffffu);
    colour_image_free(&p);

    const unsigned char bits[] = {0, 0x50}; // 0101
    p = decode((png_layout){.width = 4, .height = 1, .depth = 1, .kind = 0}, bits, sizeof bits);
    CHECK(colour(&p, 0, 0) == 0x000000ffu && colour(&p, 3, 0) == 0xffffffffu);
    colour_image_free(&p);

    const unsigned char palette[] = {1, 2, 3, 4, 5, 6}, opacity[] = {7}, index[] = {0, 0x40};
    p = decode((png_layout){.width = 2,
                            .height = 1,
                            .depth = 1,
                            .kind = 3,
                            .palette = palette,
                            .opacity = opacity,
                            .npalette = 6,
                            .nopacity = 1},
               index, sizeof index);
    CHECK(colour(&p, 0, 0) == 0x01020307u && colour(&p, 1, 0) == 0x040506ffu);
    colour_image_free(&p);

    const unsigned char deep[] = {0, 0xff, 0xff, 0x80, 0x80, 0, 0, 0xff, 0xff};
    p = decode((png_layout){.width = 1, .height = 1, .depth = 16, .kind = 6}, deep, sizeof deep);
    CHECK(colour(&p, 0, 0) == 0xff8000ffu);
    colour_image_free(&p);

    const unsigned char grey[] = {0, 0x42, 0x10};
    p = decode((png_layout){.width = 1, .height = 1, .depth = 8, .kind = 4}, grey, sizeof grey);
    CHECK(colour(&p, 0, 0) == 0x42424210u);
    colour_image_free(&p);

    // Adam7 of 2 x 2: passes 1 (one pixel), 6 (one) and 7 (a row)
    const unsigned char laced[] = {0, 10, 0, 20, 0, 30, 40};
    p = decode((png_layout){.width = 2, .height = 2, .depth = 8, .kind = 0, .interlaced = 1}, laced,
               sizeof laced);
    CHECK(colour(&p, 0, 0) == 0x0a0a0affu && colour(&p, 1, 0) == 0x141414ffu);
    CHECK(colour(&p, 0, 1) == 0x1e1e1effu && colour(&p, 1, 1) == 0x282828ffu);
    colour_image_free(&p);
}

// --- refusals

static int all_red(double x, double y, const void *unused)
{
    (void)x;
    (void)y;
    (void)unused;
    return 1;
}

static int nothing(double x, double y, const void *unused)
{
    (void)x;
    (void)y;
    (void)unused;
    return 0;
}

static int one_blue(double x, double y, const void *unused)
{
    (void)unused;
    return x > 1 && y > 0 ? 3 : 1;
}

static int two_by_a_corner(double x, double y, const void *unused)
{
    (void)unused;
    return x * y > 0 ? 1 : 0;
}

static int two_apart(double x, double y, const void *unused)
{
    (void)y;
    (void)unused;
    return fabs(x) > 1 ? 2 : 0;
}

static png_bytes text_file(const char *words)
{
    png_bytes b = {malloc(strlen(words) + 1), 0};
    png_put(&b, words, strlen(words));
    return b;
}

static void what_is_no_image_is_refused_with_one_line(void)
{
    const folder f = make_folder();
    CHECK(refused(open_bytes(&f, text_file("#!/bin/sh\nid\n")), ERR_FILE, "not a PNG image"));
    CHECK(refused(open_bytes(&f, text_file("")), ERR_FILE, "not a PNG image"));
    png_bytes b = png_draw(4, 4, all_red, NULL);
    b.count -= 20;
    CHECK(refused(open_bytes(&f, b), ERR_FILE, "ends early"));
    b = png_draw(4, 4, all_red, NULL);
    b.at[50] ^= 1;
    CHECK(refused(open_bytes(&f, b), ERR_FILE, "byte"));
    const png_layout huge = {.width = 1 << 13, .height = 1 << 12, .depth = 8, .kind = 0};
    CHECK(refused(open_bytes(&f, png_encode(&huge, (const unsigned char *)"", 1)), ERR_FILE,
                  "too many"));
    const png_layout wide = {.width = 1 << 30, .height = 1, .depth = 1, .kind = 0};
    CHECK(
        refused(open_bytes(&f, png_encode(&wide, (const unsigned char *)"", 1)), ERR_FILE, "IHDR"));
    const drawing_files missing = file_named("y.png");
    drawing *d = NULL;
    CHECK(refused(open_in(&f, &missing, &d), ERR_FILE, "y.png"));
    CHECK(rmdir(f.name) == 0);
}

static void images_that_make_no_section_are_refused(void)
{
    const folder f = make_folder();
    CHECK(open_bytes(&f, png_draw(4, 4, all_red, NULL)) == OK);
    CHECK(refused(open_bytes(&f, png_draw(4, 4, one_blue, NULL)), ERR_INPUT,
                  "#0000ff, of the pixel in column 4 of row 1"));
    CHECK(refused(open_bytes(&f, png_draw(4, 4, one_blue, NULL)), ERR_INPUT, "2 pixels are"));
    CHECK(refused(open_bytes(&f, png_draw(4, 4, nothing, NULL)), ERR_INPUT, "no pixel"));
    CHECK(refused(open_bytes(&f, png_draw(4, 4, two_apart, NULL)), ERR_INPUT, "do not touch"));
    CHECK(refused(open_bytes(&f, png_draw(4, 4, two_by_a_corner, NULL)), ERR_INPUT,
                  "corners of pixels only"));
    CHECK(rmdir(f.name) == 0);
}

static void pixels_must_not_be_needles(void)
{
    const folder f = make_folder();
    drawing_files files = file_named("x.png");
    drawing *d = NULL;
    files.png.pitch[1] = 1e-6;
    CHECK(refused(open_in(&f, &files, &d), ERR_INPUT, "more than 100 times"));
    CHECK(rmdir(f.name) == 0);
}

static void parts_are_checked(void)
{
    const folder f = make_folder();
    part_spec bad[2] = {red_and_green[0], red_and_green[1]};
    drawing_files files = file_named("x.png");
    drawing *d = NULL;
    files.png.parts.items = bad;
    bad[1].colour.text = "#00ff0";
    CHECK(refused(open_in(&f, &files, &d), ERR_INPUT, "'#00ff0'"));
    bad[1].colour.text = "#FF0000";
    CHECK(refused(open_in(&f, &files, &d), ERR_INPUT, "twice"));
    bad[1].colour.text = NULL;
    bad[1].name.text = "stiff";
    CHECK(refused(open_in(&f, &files, &d), ERR_INPUT, "colours, no names"));
    bad[1] = red_and_green[1];
    bad[1].material.text = "stif";
    CHECK(refused(open_in(&f, &files, &d), ERR_INPUT, "did you mean 'stiff'"));
    files.png.parts.count = 0;
    CHECK(refused(open_in(&f, &files, &d), ERR_INPUT, "no `parts`"));
    CHECK(rmdir(f.name) == 0);
}

// --- stacks

static int half_of_it(double x, double y, const void *context)
{
    (void)y;
    return x < *(const double *)context ? 1 : 2;
}

static void put_slice(const folder *f, const char *name, double where)
{
    put_file(f, name, png_draw(6, 4, half_of_it, &where));
}

static void equal_slices_of_a_stack_are_named_by_the_first(void)
{
    const folder f = make_folder();
    const char *names[] = {"a_01.png", "a_02.png", "a_03.png", "a_04.png", "a_05.png"};
    const double where[] = {0, 1, 0, 1, 2};
    const int first[] = {0, 1, 0, 1, 4};
    for (int i = 0; i < 5; i++) {
        put_slice(&f, names[i], where[i]);
    }
    drawing_files files = file_named("a_%02d.png");
    drawing *d = NULL;
    files.png.layer = 1e-3;
    CHECK_OK(open_in(&f, &files, &d));
    CHECK(drawing_slice_count(d) == 5);
    CHECK_NEAR(drawing_length(d), 5e-3, 1e-15);
    for (int i = 0; i < 5; i++) {
        CHECK(drawing_slice_at(d, (i + 0.5) * 1e-3) == first[i]);
    }
    drawing_free(d);
    files.png.first = 2;
    files.png.last = 3;
    CHECK_OK(open_in(&f, &files, &d));
    CHECK(drawing_slice_count(d) == 2);
    drawing_free(d);
    files.png.last = 6;
    CHECK(refused(open_in(&f, &files, &d), ERR_FILE, "a_06.png"));
    files.png.first = files.png.last = 0;
    drop_file(&f, names[3]);
    CHECK(refused(open_in(&f, &files, &d), ERR_INPUT, "no slice 4, although there is a slice 5"));
    put_file(&f, names[3], png_draw(4, 4, all_red, NULL));
    CHECK(refused(open_in(&f, &files, &d), ERR_INPUT, "4 x 4 pixels"));
    files.png.layer = 0;
    CHECK(refused(open_in(&f, &files, &d), ERR_INPUT, "layer"));
    for (int i = 0; i < 5; i++) {
        drop_file(&f, names[i]);
    }
    files.png.layer = 1e-3;
    CHECK(refused(open_in(&f, &files, &d), ERR_INPUT, "neither a slice 0 nor a slice 1"));
    CHECK(rmdir(f.name) == 0);
}

static void names_of_stacks_hold_one_number_and_nothing_else(void)
{
    const folder f = make_folder();
    const char *bad[] = {"%s.png",    "%d%d.png", "%n.png",   "%.png",
                         "%5.2d.png", "%ld.png",  "%-d.png",  "%99999999999d.png",
                         "%d%%.png",  "%*d.png",  "%+3d.png", "%"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        drawing_files files = file_named(bad[i]);
        drawing *d = NULL;
        files.png.layer = 1e-3;
        CHECK(refused(open_in(&f, &files, &d), ERR_INPUT, "is no name of a stack"));
    }
    drawing_files files = file_named("one.png");
    drawing *d = NULL;
    files.png.layer = 1e-3;
    CHECK(refused(open_in(&f, &files, &d), ERR_INPUT, "is one image"));
    CHECK(rmdir(f.name) == 0);
}

static void spoiled_images_are_meshed_or_refused_with_one_line(void)
{
    png_mutants m = {0};
    mutant_plan plan = png_mutant_plan(&m);
    CHECK(mutants_run(&plan, 300, 0) == 0);
    png_mutants_free(&m);
}

int main(void)
{
    every_layout_becomes_eight_bit_colours();
    what_is_no_image_is_refused_with_one_line();
    images_that_make_no_section_are_refused();
    pixels_must_not_be_needles();
    parts_are_checked();
    equal_slices_of_a_stack_are_named_by_the_first();
    names_of_stacks_hold_one_number_and_nothing_else();
    spoiled_images_are_meshed_or_refused_with_one_line();
    return test_failures != 0;
}
