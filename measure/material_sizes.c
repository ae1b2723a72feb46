// measure/material_sizes.c
// Gauge length and cross section: from --set, or from the lines above a table's names.
#include "measure/material_test.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const char length_names[] =
    "gauge_length|gage_length|initial_length|grip_separation|length|l0";
static const char area_names[] = "area|cross_section|cross_sectional_area|a0|s0";
static const char width_names[] = "width|specimen_width|b0|breite";
static const char thickness_names[] = "thickness|specimen_thickness|a0|dicke";
static const char diameter_names[] = "diameter|specimen_diameter|d0|durchmesser";

// two ways to write one size agree to this
static const double same_size = 1e-4;

void material_warn(material_result *r, const char *format, ...)
{
    char words[sizeof r->warning[0]];
    va_list args;
    va_start(args, format);
    (void)vsnprintf(words, sizeof words, format, args);
    va_end(args);
    for (int i = 0; i < r->nwarning; i++) {
        if (strcmp(r->warning[i], words) == 0) {
            return;
        }
    }
    if (r->nwarning < MATERIAL_WARNINGS) {
        (void)snprintf(r->warning[r->nwarning++], sizeof words, "%s", words);
    }
}

typedef struct reading {
    double value; // 0: nowhere
    long line;    // 0: --set
} reading;

static status read_size(const table *t, const char *names, dimension d, double given, reading *out)
{
    status st = OK;
    *out = (reading){given, 0};
    if (given > 0) {
        return OK;
    }
    TRY(table_note(t, names, d, &out->value, &out->line));
    if (out->line > 0 && !(out->value > 0)) {
        TRY(table_fail(t, -1, "'%.*s' is not above 0", (int)strcspn(names, "|"), names));
    }
    out->value = out->line > 0 ? out->value : 0;

done:
    return st;
}

static material_size size_of(reading a)
{
    material_size s = {.value = a.value};
    (void)(a.line > 0 ? snprintf(s.from, sizeof s.from, "line %ld", a.line)
                      : snprintf(s.from, sizeof s.from, "option --set"));
    return s;
}

static material_size product_of(reading a, reading b)
{
    material_size s = {.value = a.value * b.value};
    if (a.line > 0 && b.line > 0) {
        (void)snprintf(s.from, sizeof s.from, "lines %ld and %ld", a.line, b.line);
    } else if (a.line + b.line > 0) {
        (void)snprintf(s.from, sizeof s.from, "option --set and line %ld", a.line + b.line);
    } else {
        (void)snprintf(s.from, sizeof s.from, "option --set");
    }
    return s;
}

static material_size circle_of(reading d)
{
    material_size s = size_of(d);
    s.value = 0.25 * acos(-1.0) * d.value * d.value;
    return s;
}

// what was set goes before what the file says; value 0: neither
static status find_area(const table *t, const material_settings *s, material_size *out)
{
    status st = OK;
    reading area, width = {0}, thickness = {0}, diameter = {0};
    if (s->area > 0) {
        *out = size_of((reading){s->area, 0});
        return OK;
    }
    TRY(read_size(t, width_names, DIM_LENGTH, s->width, &width));
    TRY(read_size(t, thickness_names, DIM_LENGTH, s->thickness, &thickness));
    TRY(read_size(t, diameter_names, DIM_LENGTH, s->diameter, &diameter));
    const bool sides = width.value > 0 && thickness.value > 0;
    if (sides && (s->width > 0 || s->thickness > 0)) {
        *out = product_of(width, thickness);
        return OK;
    }
    if (s->diameter > 0) {
        *out = circle_of(diameter);
        return OK;
    }
    TRY(read_size(t, area_names, DIM_AREA, 0, &area));
    *out = area.value > 0 ? size_of(area)
           : sides        ? product_of(width, thickness)
                          : circle_of(diameter);

done:
    return st;
}

static status find_length(const table *t, const material_settings *s, material_size *out)
{
    status st = OK;
    reading length;
    TRY(read_size(t, length_names, DIM_LENGTH, s->gauge_length, &length));
    *out = size_of(length);

done:
    return st;
}

typedef status find_size(const table *t, const material_settings *s, material_size *out);

// a warning where the file says something else than what is used
static void compare_own(const table *t, find_size *find, const material_size *used,
                        const char *what, double unit, const char *unit_name, material_result *r)
{
    const material_settings none = {.nu = NAN};
    material_size own = {0};
    if (find(t, &none, &own) != OK) {
        status_clear(); // what is not used need not be right
        return;
    }
    if (own.value > 0 && fabs(own.value / used->value - 1) > same_size) {
        material_warn(r, "%.200s: %s %.4g %s of %s is used, but its %s %s %.4g %s", t->path, what,
                      used->value / unit, unit_name, used->from, own.from,
                      strncmp(own.from, "lines", 5) == 0 ? "say" : "says", own.value / unit,
                      unit_name);
    }
}

status material_gauge_length(const table *t, const material_settings *s, material_result *r,
                             material_size *out)
{
    status st = OK;
    TRY(find_length(t, s, out));
    if (!(out->value > 0)) {
        TRY(status_fail(ERR_INPUT,
                        "%.300s: an extension needs the gauge length: --set "
                        "gauge_length_mm=..., or a line 'gauge_length_mm: ...' above the names",
                        t->path));
    }
    compare_own(t, find_length, out, "gauge length", 1e-3, "mm", r);

done:
    return st;
}

status material_area(const table *t, const material_settings *s, material_result *r,
                     material_size *out)
{
    status st = OK;
    TRY(find_area(t, s, out));
    if (!(out->value > 0)) {
        TRY(status_fail(ERR_INPUT,
                        "%.300s: a force needs the cross section: --set area_mm2=..., or "
                        "a line 'area_mm2: ...' above the names",
                        t->path));
    }
    compare_own(t, find_area, out, "cross section", 1e-6, "mm^2", r);

done:
    return st;
}
