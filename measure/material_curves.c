// measure/material_curves.c
// From the columns of a test's file to stress over strain.
#include "measure/material_test.h"
#include "measure/table.h"

#include "base/memory.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct columns {
    int n, at[TABLE_COLUMNS];
    bool whole; // strain, stress; else extension, force: to be divided
} columns;

static const char strain_names[] = "strain|tensile_strain|engineering_strain|nominal_strain|"
                                   "extensometer_strain|epsilon|eps|dehnung";
static const char extension_names[] =
    "extension|displacement|elongation|tensile_extension|tensile_displacement|crosshead|"
    "crosshead_displacement|crosshead_position|stroke|travel|standard_travel|position|standardweg|"
    "weg|delta_l|dl";
static const char stress_names[] =
    "stress|tensile_stress|engineering_stress|nominal_stress|sigma|spannung";
static const char force_names[] =
    "force|load|tensile_force|tensile_load|standard_force|standardkraft|kraft|f";

// "strain_2", "strain2", "strain_b" are columns of strain
static void base_name(const char *name, char base[TABLE_NAME])
{
    (void)snprintf(base, TABLE_NAME, "%s", name);
    size_t n = strlen(base);
    if (n > 2 && base[n - 2] == '_' && isalpha((unsigned char)base[n - 1])) {
        n--;
    }
    while (n > 1 && isdigit((unsigned char)base[n - 1])) {
        n--;
    }
    while (n > 1 && base[n - 1] == '_') {
        n--;
    }
    base[n] = '\0';
}

static bool is_one_of(const char *name, const char *names)
{
    const size_t n = strlen(name);
    for (const char *p = names; (p = strstr(p, name)) != NULL; p += n) {
        if ((p == names || p[-1] == '|') && (p[n] == '|' || p[n] == '\0') && n > 0) {
            return true;
        }
    }
    return false;
}

static columns find_columns(const table *t, const char *names)
{
    columns c = {.n = 0};
    for (int i = 0; i < t->ncolumn; i++) {
        char base[TABLE_NAME];
        base_name(t->column[i].name, base);
        if (!t->column[i].words &&
            (is_one_of(t->column[i].name, names) || is_one_of(base, names))) {
            c.at[c.n++] = i;
        }
    }
    return c;
}

static status find_pairs(const table *t, columns *x, columns *y)
{
    *x = find_columns(t, strain_names);
    *y = find_columns(t, stress_names);
    x->whole = x->n > 0;
    y->whole = y->n > 0;
    if (!x->whole) {
        *x = find_columns(t, extension_names);
    }
    if (!y->whole) {
        *y = find_columns(t, force_names);
    }
    if (x->n == 0) {
        return table_fail_names(t,
                                "no column of strain or extension among the %d: name it "
                                "'strain [%%]' or 'extension [mm]'",
                                t->ncolumn);
    }
    if (y->n == 0) {
        return table_fail_names(t,
                                "no column of stress or force among the %d: name it "
                                "'stress [MPa]' or 'force [N]'",
                                t->ncolumn);
    }
    if (x->n != y->n && x->n != 1) {
        return table_fail_names(t, "%d columns of strain or extension, but %d of stress or force",
                                x->n, y->n);
    }
    for (int i = 0; x->whole && i < x->n; i++) {
        const table_column *c = &t->column[x->at[i]];
        if (c->unit[0] == '\0') {
            return table_fail_names(t, "column '%s' has no unit: write '%s [%%]' or '%s [-]'",
                                    c->name, c->name, c->name);
        }
    }
    return OK;
}

static status note_or(const table *t, const char *names, dimension d, double given, double *out)
{
    status st = OK;
    bool found = false;
    *out = given;
    if (given <= 0) {
        TRY(table_note(t, names, d, out, &found));
        if (found && !(*out > 0)) {
            TRY(table_fail(t, -1, "'%.*s' is not above 0", (int)strcspn(names, "|"), names));
        }
        *out = found ? *out : 0;
    }

done:
    return st;
}

static status area_of(const table *t, const material_settings *s, double *area)
{
    status st = OK;
    double width = 0, thickness = 0, diameter = 0;
    TRY(note_or(t, "area|cross_section|cross_sectional_area|a0|s0", DIM_AREA, s->area, area));
    TRY(note_or(t, "width|specimen_width|b0|breite", DIM_LENGTH, s->width, &width));
    TRY(note_or(t, "thickness|specimen_thickness|a0|dicke", DIM_LENGTH, s->thickness, &thickness));
    TRY(note_or(t, "diameter|specimen_diameter|d0|durchmesser", DIM_LENGTH, s->diameter,
                &diameter));
    if (*area <= 0 && width > 0 && thickness > 0) {
        *area = width * thickness;
    } else if (*area <= 0 && diameter > 0) {
        *area = 0.25 * acos(-1.0) * diameter * diameter;
    }
    if (*area <= 0) {
        TRY(status_fail(ERR_INPUT,
                        "%.300s: a force needs the cross section: --set area_mm2=..., or "
                        "a line 'area_mm2: ...' above the names",
                        t->path));
    }

done:
    return st;
}

// what a column's numbers are divided by: 1 for strain and stress
static status divisors(const table *t, const material_settings *s, bool strain, bool stress,
                       double *length, double *area)
{
    status st = OK;
    *length = *area = 1;
    if (!strain) {
        TRY(note_or(t, "gauge_length|gage_length|initial_length|grip_separation|length|l0",
                    DIM_LENGTH, s->gauge_length, length));
        if (*length <= 0) {
            TRY(status_fail(ERR_INPUT,
                            "%.300s: an extension needs the gauge length: --set "
                            "gauge_length_mm=..., or a line 'gauge_length_mm: ...' above the names",
                            t->path));
        }
    }
    if (!stress) {
        TRY(area_of(t, s, area));
    }

done:
    return st;
}

static const char *file_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

// the rows whose specimen is `word`; all where `column` is -1
static status add_curve(const table *t, const double *x, const double *y, int column, int word,
                        const char *label, material_result *r)
{
    status st = OK;
    tensile_curve c = {0};
    if (r->n == MATERIAL_MOST) {
        return table_fail(t, -1, "more than %d curves", MATERIAL_MOST);
    }
    TRY(tensile_curve_make(t->nrow, &c));
    c.n = 0;
    for (int i = 0; i < t->nrow; i++) {
        const double group =
            column < 0 ? word : t->a[(size_t)i * (size_t)t->ncolumn + (size_t)column];
        if (group == word && isfinite(x[i]) && isfinite(y[i])) {
            c.strain[c.n] = x[i];
            c.stress[c.n++] = y[i];
        }
    }
    material_specimen *m = &r->specimen[r->n++];
    *m = (material_specimen){.curve = c};
    c = (tensile_curve){0};
    (void)snprintf(m->label, sizeof m->label, "%s", label);

done:
    tensile_curve_free(&c);
    return st;
}

static status add_pair(const table *t, const columns *x, const columns *y, int k,
                       const material_settings *s, material_result *r)
{
    status st = OK;
    char label[MATERIAL_LABEL];
    double *a = NULL, *b = NULL, length = 1, area = 1;
    const int group = table_find(t, "specimen|sample|probe|replicate");
    TRY(divisors(t, s, x->whole, y->whole, &length, &area));
    TRY(table_take(t, x->at[x->n == 1 ? 0 : k], x->whole ? DIM_NONE : DIM_LENGTH, &a));
    TRY(table_take(t, y->at[k], y->whole ? DIM_STRESS : DIM_FORCE, &b));
    for (int i = 0; i < t->nrow; i++) {
        a[i] /= length;
        b[i] /= area;
    }
    const char *file = file_name(t->path);
    for (int w = 0; group >= 0 && w < t->nword; w++) {
        (void)snprintf(label, sizeof label, "%.40s: %s", file, t->word[w]);
        TRY(add_curve(t, a, b, group, w, label, r));
    }
    if (group < 0) {
        (void)snprintf(label, sizeof label, y->n > 1 ? "%.60s: %s" : "%.60s", file,
                       t->column[y->at[k]].name);
        TRY(add_curve(t, a, b, -1, 0, label, r));
    }

done:
    free(a);
    free(b);
    return st;
}

status material_curves(const char *path, const material_settings *s, material_result *r)
{
    static const table_limits limits = {.word_columns = "specimen|sample|probe|replicate"};
    status st = OK;
    table t = {0};
    columns x, y;
    TRY(table_read(NULL, &(key_text){.text = path}, &limits, &t));
    TRY(find_pairs(&t, &x, &y));
    for (int k = 0; k < y.n; k++) {
        TRY(add_pair(&t, &x, &y, k, s, r));
    }
    r->synthetic = r->synthetic || table_says(&t, "synthetic");

done:
    table_free(&t);
    return st;
}
