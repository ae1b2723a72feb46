// reports/cairo_door.c
#include "reports/cairo_door.h"

#include "base/memory.h"
#include "reports/markup.h"
#include "reports/svg_tidy.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

struct canvas {
    cairo_t *cr;
};

#ifdef __SANITIZE_ADDRESS__
// fontconfig keeps its patterns to the end of the process; the leak checker looks this function up
// by name
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void)
{
    return "leak:libfontconfig\n";
}
#endif

static const double far_off = 1e5; // from any picture [units]

static const double png_density = 2;                  // pixels per unit: 282 to the inch
static const double pdf_scale = SHEET_MM * 72 / 25.4; // points per unit

// in every Debian with fontconfig. Nine tenths as wide as drawn by its makers, which is how they
// make their condensed cut: 7 pt letters and their numbers find room in a column
static const char family[] = "DejaVu Sans";
static const double narrowing = 0.9;

// cairo's own numbers end at 8 million: what is not a number, or far off the sheet, goes to its far
// side
static double on_sheet(double x)
{
    return fmin(fmax(x, -far_off), far_off);
}

void canvas_move(canvas *c, double x, double y)
{
    cairo_move_to(c->cr, on_sheet(x), on_sheet(y));
}

void canvas_line(canvas *c, double x, double y)
{
    cairo_line_to(c->cr, on_sheet(x), on_sheet(y));
}

void canvas_close(canvas *c)
{
    cairo_close_path(c->cr);
}

void canvas_segment(canvas *c, double x0, double y0, double x1, double y1)
{
    canvas_move(c, x0, y0);
    canvas_line(c, x1, y1);
}

void canvas_rectangle(canvas *c, double x, double y, double w, double h)
{
    cairo_rectangle(c->cr, on_sheet(x), on_sheet(y), on_sheet(w), on_sheet(h));
}

void canvas_circle(canvas *c, double x, double y, double radius)
{
    cairo_new_sub_path(c->cr);
    cairo_arc(c->cr, on_sheet(x), on_sheet(y), fmax(on_sheet(radius), 0), 0, 2 * acos(-1.0));
    cairo_close_path(c->cr);
}

static void take_ink(canvas *c, colour ink)
{
    cairo_set_source_rgba(c->cr, ink.r, ink.g, ink.b, ink.a);
}

void canvas_fill(canvas *c, colour ink)
{
    take_ink(c, ink);
    cairo_fill(c->cr);
}

void canvas_stroke(canvas *c, colour ink, double width)
{
    take_ink(c, ink);
    cairo_set_line_width(c->cr, width);
    cairo_stroke(c->cr);
}

void canvas_fill_stroke(canvas *c, colour ink, colour border, double width)
{
    take_ink(c, ink);
    cairo_fill_preserve(c->cr);
    canvas_stroke(c, border, width);
}

void canvas_dash(canvas *c, double on, double off)
{
    const double dashes[2] = {on, off};
    cairo_set_dash(c->cr, dashes, on > 0 ? 2 : 0, 0);
}

static void take_font(canvas *c, const text_look *look)
{
    cairo_select_font_face(
        c->cr, family,
        look->style == TEXT_ITALIC ? CAIRO_FONT_SLANT_ITALIC : CAIRO_FONT_SLANT_NORMAL,
        look->style == TEXT_BOLD ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_matrix_t shape;
    cairo_matrix_init_scale(&shape, narrowing * look->size, look->size);
    cairo_set_font_matrix(c->cr, &shape);
}

double canvas_text_width(canvas *c, const text_look *look, const char *text)
{
    char clean[512];
    cairo_text_extents_t extents = {0};
    utf8_clean(text, clean, sizeof clean);
    take_font(c, look);
    cairo_text_extents(c->cr, clean, &extents);
    return extents.x_advance;
}

void canvas_text(canvas *c, double x, double y, const text_look *look, const char *text)
{
    char clean[512];
    if (!(fabs(x) < far_off && fabs(y) < far_off && isfinite(look->turn))) {
        return;
    }
    utf8_clean(text, clean, sizeof clean);
    const double width = canvas_text_width(c, look, clean);
    const double start =
        look->align == TEXT_LEFT ? 0 : (look->align == TEXT_RIGHT ? -width : -width / 2);

    cairo_save(c->cr);
    cairo_translate(c->cr, x, y);
    cairo_rotate(c->cr, look->turn);
    if (look->halo > 0) {
        cairo_set_dash(c->cr, NULL, 0, 0);
        cairo_move_to(c->cr, start, 0);
        cairo_text_path(c->cr, clean);
        canvas_stroke(c, (colour){1, 1, 1, 1}, 2 * look->halo);
    }
    take_ink(c, look->ink);
    cairo_move_to(c->cr, start, 0);
    cairo_show_text(c->cr, clean);
    cairo_restore(c->cr);
    cairo_new_path(c->cr);
}

void canvas_clip(canvas *c, double x, double y, double w, double h)
{
    cairo_save(c->cr);
    cairo_new_path(c->cr);
    cairo_rectangle(c->cr, x, y, w, h);
    cairo_clip(c->cr);
}

void canvas_unclip(canvas *c)
{
    cairo_restore(c->cr);
}

// --- a surface -> bytes -> a file ---

static cairo_status_t append(void *closure, const unsigned char *data, unsigned int length)
{
    bytes *b = closure;
    return bytes_append(b, (const char *)data, length) == OK ? CAIRO_STATUS_SUCCESS
                                                             : CAIRO_STATUS_NO_MEMORY;
}

static status cairo_check(cairo_status_t code, const picture *p)
{
    return code ? status_fail(ERR_RESOURCE, "cairo: %s, in the picture %s",
                              cairo_status_to_string(code), p->name)
                : OK;
}

// outlines of letters must not depend on the surface: the SVG and the PNG share one layout
static void fix_font_rendering(cairo_t *cr)
{
    cairo_font_options_t *options = cairo_font_options_create();
    cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
    cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
    cairo_set_font_options(cr, options);
    cairo_font_options_destroy(options);
}

static status draw_on(const picture *p, cairo_surface_t *surface, double scale)
{
    status st = OK;
    canvas c = {.cr = cairo_create(surface)};

    cairo_scale(c.cr, scale, scale);
    fix_font_rendering(c.cr);
    cairo_set_line_join(c.cr, CAIRO_LINE_JOIN_ROUND);
    take_ink(&c, (colour){1, 1, 1, 1});
    cairo_paint(c.cr);
    TRY(p->draw(&c, p->data));
    TRY(cairo_check(cairo_status(c.cr), p));

done:
    cairo_destroy(c.cr);
    return st;
}

static status make_svg(const picture *p, bytes *out)
{
    status st = OK;
    cairo_surface_t *surface =
        cairo_svg_surface_create_for_stream(append, out, p->width, p->height);

    TRY(cairo_check(cairo_surface_status(surface), p));
    cairo_svg_surface_set_document_unit(surface, CAIRO_SVG_UNIT_PX);
    TRY(draw_on(p, surface, 1));
    cairo_surface_finish(surface);
    TRY(cairo_check(cairo_surface_status(surface), p));

done:
    cairo_surface_destroy(surface);
    return st;
}

// No two writings differ: cairo's time of writing gives way to spaces, which leave all offsets as
// they are.
static void blank_date(bytes *pdf)
{
    static const char word[] = "/CreationDate (";
    const size_t n = sizeof word - 1;
    for (size_t i = pdf->length; i-- > 0;) {
        if (pdf->length - i > n && memcmp(pdf->data + i, word, n) == 0) {
            const char *end = memchr(pdf->data + i, ')', pdf->length - i);
            memset(pdf->data + i, ' ', end ? (size_t)(end + 1 - (pdf->data + i)) : 0);
            return;
        }
    }
}

static status make_pdf(const picture *p, bytes *out)
{
    status st = OK;
    cairo_surface_t *surface = cairo_pdf_surface_create_for_stream(
        append, out, p->width * pdf_scale, p->height * pdf_scale);

    TRY(cairo_check(cairo_surface_status(surface), p));
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_TITLE, p->title);
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATOR, "stiffaxis");
    // a date of its own length, should it stand where it cannot be found
    cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, "1970-01-01T00:00:00Z");
    TRY(draw_on(p, surface, pdf_scale));
    cairo_surface_finish(surface);
    TRY(cairo_check(cairo_surface_status(surface), p));
    blank_date(out);

done:
    cairo_surface_destroy(surface);
    return st;
}

static status make_png(const picture *p, bytes *out)
{
    status st = OK;
    cairo_surface_t *surface = cairo_image_surface_create(
        CAIRO_FORMAT_RGB24, (int)ceil(p->width * png_density), (int)ceil(p->height * png_density));

    TRY(cairo_check(cairo_surface_status(surface), p));
    TRY(draw_on(p, surface, png_density));
    TRY(cairo_check(cairo_surface_write_to_png_stream(surface, append, out), p));

done:
    cairo_surface_destroy(surface);
    return st;
}

static status write_file(const bytes *b, const char *dir, const char *name, const char *ending)
{
    char path[4096];
    const int n = snprintf(path, sizeof path, "%s/%s.%s", dir, name, ending);
    FILE *f = n > 0 && n < (int)sizeof path ? fopen(path, "wb") : NULL;
    if (!f) {
        return status_fail(ERR_RESOURCE, "cannot write the picture %s/%s.%s", dir, name, ending);
    }
    const size_t written = fwrite(b->data, 1, b->length, f);
    if (fclose(f) != 0 || written != b->length) {
        return status_fail(ERR_RESOURCE, "writing the picture %s failed: disk full?", path);
    }
    return OK;
}

status picture_write(const picture *p, const char *dir)
{
    status st = OK;
    bytes raw = {0}, svg = {0}, pdf = {0}, png = {0};

    TRY(make_svg(p, &raw));
    TRY(svg_tidy(&raw, p->name, p->title, SHEET_MM, &svg));
    TRY(write_file(&svg, dir, p->name, "svg"));
    TRY(make_pdf(p, &pdf));
    TRY(write_file(&pdf, dir, p->name, "pdf"));
    TRY(make_png(p, &png));
    TRY(write_file(&png, dir, p->name, "png"));

done:
    bytes_free(&raw);
    bytes_free(&svg);
    bytes_free(&pdf);
    bytes_free(&png);
    return st;
}
