// tests/unit/reports/test_svg_tidy.c
#include "reports/svg_tidy.h"
#include "tests/test.h"

#include <string.h>

static const char raw_svg[] =
    "<?xml version=\"1.0\"?>\n<svg width=\"10px\" height=\"6.25px\" viewBox=\"0 0 10 10\">\n"
    "<g><symbol id=\"glyph0-1\"><path style=\"stroke:none;\" d=\"M 0.501953 1.765625 Z M 0.501953 "
    "1.765625 \"/>"
    "</symbol></g>\n<g id=\"surface17\" clip-path=\"url(#clip1)\">"
    "<use xlink:href=\"#glyph0-1\" x=\"15.893555\" y=\"-40\"/>"
    "<path style=\" stroke:none;fill-rule:nonzero;fill:rgb(100%,50.196078%,0%);fill-opacity:1;\" "
    "d=\"M 1 2 L 3.996 4\"/>"
    "<path style=\"fill:none;stroke:rgb(0%,0%,100%);stroke-opacity:0.5;\" d=\"M 1 2 Z M 5 6 L 7 "
    "8\"/>"
    // a curve's steps are from where it begins, and after Z the pen is where the loop began
    "<path d=\"M 1 2 C 1 2.5 1.5 3 -0.25 1 L -0.5 2 Z L 0 2.333\"/></g></svg>\n";

static const char wanted_svg[] =
    "<?xml version=\"1.0\"?>\n<svg role=\"img\" width=\"2mm\" height=\"1.25mm\" viewBox=\"0 0 10 "
    "10\">\n<title>a "
    "&amp; b</title>\n"
    "<g><symbol id=\"rods-glyph0-1\"><path style=\"stroke:none;\" d=\"M.5 1.77z\"/>"
    "</symbol></g>\n<g id=\"rods-surface\" clip-path=\"url(#rods-clip1)\">"
    "<use xlink:href=\"#rods-glyph0-1\" x=\"15.89\" y=\"-40\"/>"
    "<path style=\"fill:#ff8000;\" d=\"M1 2l3 2\"/>"
    "<path style=\"fill:none;stroke:#0000ff;stroke-opacity:0.5;\" d=\"M1 2zM5 6l2 2\"/>"
    "<path d=\"M1 2c0 .5.5 1-1.25-1l-.25 1zl-1 .33\"/></g></svg>\n";

static void ids_get_a_name_and_defaults_go(void)
{
    bytes raw = {0}, out = {0};
    CHECK_OK(bytes_text(&raw, raw_svg));
    CHECK_OK(svg_tidy(&raw, "rods", "a & b", 0.2, &out));
    CHECK(out.data && strcmp(out.data, wanted_svg) == 0);
    if (test_failures) {
        printf("%s\n", out.data);
    }
    CHECK(out.data && strncmp(svg_element(out.data), "<svg role", 9) == 0);
    bytes_free(&raw);
    bytes_free(&out);
}

static void something_else_is_refused(void)
{
    bytes raw = {0}, out = {0};
    CHECK(svg_tidy(&raw, "a", "b", 1, &out) == ERR_BUG);
    status_clear();
    CHECK_OK(bytes_text(&raw, "<html><svg"));
    CHECK(svg_tidy(&raw, "a", "b", 1, &out) == ERR_BUG);
    status_clear();
    bytes_free(&raw);
    bytes_free(&out);
}

// cairo writes no such thing; what comes of it stands within the sheet's numbers
static void hostile_numbers_are_kept_small(void)
{
    static const char wild[] = "<svg width=\"1e999px\" height=\"nanpx\">"
                               "<path style=\"fill:rgb(1e9%,-5%,nan%);\" d=\"M 1e30 -1e30 L -1e308 "
                               "1e308 C inf 0 0 nan 1 1 "
                               "Z\"/><use x=\"nan\" y=\"-inf\"/></svg>";
    bytes raw = {0}, out = {0};
    CHECK_OK(bytes_text(&raw, wild));
    CHECK_OK(svg_tidy(&raw, "a", "b", 1, &out));
    CHECK(out.data && strstr(out.data, "d=\"M10000000-10000000l-20000000 20000000c"));
    CHECK(out.data && strstr(out.data, "x=\"0\" y=\"-10000000\""));
    CHECK(out.data && strstr(out.data, "fill:#ff0d00;"));
    bytes_free(&raw);
    bytes_free(&out);
}

// what is cut off or has one letter changed is tidied or refused, and read no further than it goes
static void damaged_pictures_are_read_to_their_end(void)
{
    unsigned seed = 1;
    int refused = 0;
    for (size_t k = 0; k < 3 * sizeof raw_svg; k++) {
        const size_t at = k % (sizeof raw_svg - 1);
        bytes raw = {0}, out = {0};
        CHECK_OK(bytes_append(&raw, raw_svg, k < sizeof raw_svg ? at : sizeof raw_svg - 1));
        if (at < raw.length) {
            seed = seed * 1664525u + 1013904223u;
            raw.data[at] = "<>\"0Ze-%#\x80 M"[seed >> 28 < 12 ? seed >> 28 : 0];
        }
        const status st = svg_tidy(&raw, "a", "b", 1, &out);
        CHECK(st == OK || st == ERR_BUG);
        CHECK(st != OK || out.length < 4 * sizeof raw_svg);
        refused += st != OK;
        status_clear();
        bytes_free(&raw);
        bytes_free(&out);
    }
    CHECK(refused > 0 && refused < (int)sizeof raw_svg);
}

int main(void)
{
    ids_get_a_name_and_defaults_go();
    something_else_is_refused();
    hostile_numbers_are_kept_small();
    damaged_pictures_are_read_to_their_end();
    return test_failures != 0;
}
