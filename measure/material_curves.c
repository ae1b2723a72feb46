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
    for (const char *p = names; n > 0 && (p = strstr(p, name)) != NULL; p += n) {
        if ((p == names || p[-1] == '|') && (p[n] == '|' || p[n] == '\0')) {
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

static const char *file_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

// the rows whose specimen is `word`; all where `column` is -1
static status add_curve(const table *t, const double *x, const double *y, int column, int word,
                        const material_specimen *like, material_result *r)
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
    *m = *like;
    m->curve = c;
    c = (tensile_curve){0};

done:
    tensile_curve_free(&c);
    return st;
}

// the columns of pair k in SI, divided by length and area; what that rests on in `m`
static status stress_over_strain(const table *t, const columns *x, const columns *y, int k,
                                 const material_settings *s, material_result *r,
                                 material_specimen *m, double **strain, double **stress)
{
    status st = OK;
    const int at = x->at[x->n == 1 ? 0 : k];
    const table_column *c = &t->column[at];
    if (x->whole) {
        (void)snprintf(m->strain_of, sizeof m->strain_of, "the unit '%s' of '%s'", c->unit,
                       c->name);
    } else {
        TRY(material_gauge_length(t, s, r, &m->length));
        (void)snprintf(m->strain_of, sizeof m->strain_of, "the gauge length of %.4g mm (%s)",
                       1e3 * m->length.value, m->length.from);
    }
    TRY(y->whole ? OK : material_area(t, s, r, &m->area));
    TRY(table_take(t, at, x->whole ? DIM_NONE : DIM_LENGTH, strain));
    TRY(table_take(t, y->at[k], y->whole ? DIM_STRESS : DIM_FORCE, stress));
    for (int i = 0; i < t->nrow; i++) {
        (*strain)[i] /= x->whole ? 1 : m->length.value;
        (*stress)[i] /= y->whole ? 1 : m->area.value;
    }

done:
    return st;
}

static status add_pair(const table *t, const columns *x, const columns *y, int k,
                       const material_settings *s, material_result *r)
{
    status st = OK;
    material_specimen m = {0};
    double *a = NULL, *b = NULL;
    const int group = table_find(t, "specimen|sample|probe|replicate");
    TRY(stress_over_strain(t, x, y, k, s, r, &m, &a, &b));
    const char *file = file_name(t->path);
    for (int w = 0; group >= 0 && w < t->nword; w++) {
        (void)snprintf(m.label, sizeof m.label, "%.40s: %s", file, t->word[w]);
        TRY(add_curve(t, a, b, group, w, &m, r));
    }
    if (group < 0) {
        (void)snprintf(m.label, sizeof m.label, y->n > 1 ? "%.60s: %s" : "%.60s", file,
                       t->column[y->at[k]].name);
        TRY(add_curve(t, a, b, -1, 0, &m, r));
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
