// reports/page_figure.c
// Drawn pictures within the page: as they are where they are small, as points where they have very
// many pieces.
#include "reports/page_kit.h"

#include "reports/base64.h"
#include "reports/svg_tidy.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST_SVG = 300000 }; // bytes; from there on the same as PNG may be smaller

// The whole file; *out stays empty where there is none.
static status read_file(const char *dir, const char *name, const char *kind, bytes *out)
{
    status st = OK;
    char path[4096], piece[8192];
    const int n = snprintf(path, sizeof path, "%s/%s.%s", dir, name, kind);
    FILE *f = n > 0 && n < (int)sizeof path ? fopen(path, "rb") : NULL;
    if (!f) {
        return OK;
    }
    for (size_t got = fread(piece, 1, sizeof piece, f); got > 0;
         got = fread(piece, 1, sizeof piece, f)) {
        TRY(bytes_append(out, piece, got));
    }
    if (ferror(f)) {
        TRY(status_fail(ERR_RESOURCE, "cannot read the picture %s", path));
    }

done:
    (void)fclose(f);
    return st;
}

// what a screen reader says is the SVG's own title, which is escaped already
static status put_points(bytes *page, const bytes *png, const char *svg)
{
    status st = OK;
    const char *title = strstr(svg, "<title>"), *end = title ? strstr(title, "</title>") : NULL;
    PAGE("<img alt=\"");
    TRY(end ? bytes_append(page, title + 7, (size_t)(end - title - 7)) : OK);
    PAGE("\" src=\"data:image/png;base64,");
    TRY(base64_append(page, png->data, png->length));
    PAGE("\"/>\n");

done:
    return st;
}

static status put_picture(bytes *page, const char *dir, const char *name, const char *svg,
                          const char *over)
{
    status st = OK;
    bytes png = {0};
    const char *end = strstr(svg, "</svg>");
    if (strlen(svg) > MOST_SVG) {
        TRY(read_file(dir, name, "png", &png));
    }
    // in base64; a picture of few colours and many pieces
    if (png.length > 0 && png.length / 3 * 4 < strlen(svg)) {
        TRY(put_points(page, &png, svg));
    } else if (over && end) {
        TRY(bytes_append(page, svg, (size_t)(end - svg)));
        TRY(bytes_text(page, over));
        TRY(bytes_text(page, end));
    } else {
        TRY(bytes_text(page, svg));
    }

done:
    bytes_free(&png);
    return st;
}

// of the widest sheet: letters are alike from figure to figure
static double part_of_column(const char *svg)
{
    double mm = 0;
    const char *width = strstr(svg, " width=\"");
    const bool told = width && sscanf(width, " width=\"%lfmm\"", &mm) == 1 && mm > 0;
    return told ? fmin(mm / (1000 * SHEET_MM), 1) : 1;
}

status page_figure_under(bytes *page, const char *dir, const char *name, const char *over,
                         const char *caption)
{
    status st = OK;
    bytes svg = {0};

    TRY(read_file(dir, name, "svg", &svg));
    // without the XML declaration, which HTML does not know
    const char *element = svg.data ? svg_element(svg.data) : NULL;
    if (element) {
        PAGE("<figure style=\"--part:%.4g\">\n", part_of_column(element));
        TRY(put_picture(page, dir, name, element, over));
        PAGE("<figcaption>%s</figcaption>\n</figure>\n", caption);
    }

done:
    bytes_free(&svg);
    return st;
}

status page_figure(bytes *page, const char *dir, const char *name, const char *caption)
{
    return page_figure_under(page, dir, name, NULL, caption);
}
