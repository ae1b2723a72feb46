// measure/material_test.c
#include "measure/material_test.h"

#include "base/memory.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// Softer than a jelly or stiffer than diamond: units are wrong [Pa]
static const double softest = 100, stiffest = 2e12;

// Strains that hardly any test has: rubbers break below 20, and none follows the line of its first
// slope to 1. Below 1 % nobody tests what is softer than 100 MPa. Polymers take 0.25 % for a
// modulus, and do not bend before 0.5 %; metals and ceramics may.
static const double longest = 20, longest_line = 1, short_test = 0.01, shortest = 0.0025;
static const double short_line = 0.005, soft = 1e8, metal = 1e10;

static const material_settings settings_initial = {.departure = 0.05, .nu = NAN};

#define LENGTH(field, words)                                                                       \
    {                                                                                              \
        .name = #field, .kind = KEY_REAL, .dimension = DIM_LENGTH, .min = 1e-6, .max = 100,        \
        .offset = offsetof(material_settings, field), .about = words                               \
    }

static const key settings_keys[] = {
    {.name = "name",
     .kind = KEY_TEXT,
     .offset = offsetof(material_settings, name),
     .about = "of the material"},
    {.name = "source",
     .kind = KEY_TEXT,
     .offset = offsetof(material_settings, source),
     .about = "where the data comes from, one line for the figure"},
    LENGTH(gauge_length, "by which an extension is divided"),
    {.name = "area",
     .kind = KEY_REAL,
     .dimension = DIM_AREA,
     .min = 1e-12,
     .max = 10,
     .offset = offsetof(material_settings, area),
     .about = "by which a force is divided"},
    LENGTH(width, "of the cross section, with the thickness instead of the area"),
    LENGTH(thickness, "of the cross section"),
    LENGTH(diameter, "of a round cross section, instead of the area"),
    {.name = "departure",
     .kind = KEY_REAL,
     .min = 0.001,
     .max = 0.5,
     .offset = offsetof(material_settings, departure),
     .initial = "0.05",
     .about = "share of the line's stress by which the curve leaves it at the linear range's end"},
    // near 0.5 the bulk stiffness is endless
    {.name = "nu",
     .kind = KEY_REAL,
     .min = -0.999,
     .max = 0.4999,
     .offset = offsetof(material_settings, nu),
     .about = "Poisson's ratio for the block to paste, at most 0.4999; tension does not tell it"},
    {.name = "outliers",
     .kind = KEY_CHOICE,
     .choices = "keep|leave_out",
     .offset = offsetof(material_settings, outliers),
     .initial = "keep",
     .about = "whether curves that stand out count in the pooled number"},
};

const key_table material_settings_keys = {
    .name = "material_settings",
    .size = sizeof(material_settings),
    .nkey = (int)(sizeof settings_keys / sizeof *settings_keys),
    .keys = settings_keys,
    .initial = &settings_initial,
    .about = "a tensile test",
};

void material_result_free(material_result *r)
{
    for (int i = 0; i < r->n; i++) {
        tensile_curve_free(&r->specimen[i].curve);
    }
    free(r->specimen);
    *r = (material_result){0};
}

static void look_at_strains(const material_specimen *m, material_result *r)
{
    const tensile_answer *a = &m->answer;
    double most = 0;
    for (int i = 0; i < m->curve.n; i++) {
        most = fmax(most, fabs(m->curve.strain[i] - m->curve.strain[0]));
    }
    const bool early = !a->linear_to_end && a->linear_strain < short_line;
    const bool small =
        most < short_test && (a->E < soft || (a->E < metal && (early || most < shortest)));
    if (small || most > longest || a->linear_strain > longest_line) {
        material_warn(r, "%s: strains up to %.3g %%, linear up to %.3g %%: is %s right?", m->label,
                      100 * most, 100 * a->linear_strain, m->strain_of);
    }
}

static status measure_one(const char *path, material_specimen *m, const tensile_rule *rule)
{
    char words[400];
    const status st = tensile_measure(&m->curve, rule, &m->answer);
    if (st == ERR_FILE) {
        (void)snprintf(words, sizeof words, "%s", status_message());
        status_clear();
        return strchr(m->label, ':')
                   ? status_fail(st, "%.300s: %s: %s", path, strchr(m->label, ':') + 2, words)
                   : status_fail(st, "%.300s: %s", path, words);
    }
    if (st == OK && !(m->answer.E > softest && m->answer.E < stiffest)) {
        return status_fail(ERR_FILE, "%.300s: a modulus of %.3g Pa: are the units right?", path,
                           m->answer.E);
    }
    return st;
}

static status pool(const material_settings *s, material_result *r)
{
    status st = OK;
    tensile_answer *a = NULL;
    const tensile_curve **curve = NULL;
    bool *outlier = NULL, *used = NULL;
    const size_t n = (size_t)r->n;
    TRY(TAKE(a, n));
    TRY(TAKE(curve, n));
    TRY(TAKE(outlier, n));
    TRY(TAKE(used, n));
    for (int i = 0; i < r->n; i++) {
        a[i] = r->specimen[i].answer;
        curve[i] = &r->specimen[i].curve;
    }
    TRY(tensile_outliers(r->n, a, outlier));
    for (int i = 0; i < r->n; i++) {
        r->specimen[i].outlier = outlier[i];
        r->specimen[i].used = used[i] = !outlier[i] || s->outliers == OUTLIERS_KEEP;
        r->noutlier += outlier[i];
    }
    TRY(tensile_pool_of(r->n, a, used, &r->rule, &r->pool));
    TRY(tensile_pool_linear(r->n, curve, a, used, &r->rule, &r->pool));
    for (int i = 0; i < r->n; i++) {
        used[i] = !outlier[i] || s->outliers != OUTLIERS_KEEP;
    }
    TRY(tensile_pool_of(r->n, a, used, &r->rule, &r->other));
    TRY(tensile_pool_linear(r->n, curve, a, used, &r->rule, &r->other));

done:
    free(a);
    free(curve);
    free(outlier);
    free(used);
    return st;
}

// a name that a case can have as a key: from the file's
static void set_name(const char *path, const material_settings *s, material_result *r)
{
    const char *slash = strrchr(path, '/'), *from = slash ? slash + 1 : path;
    (void)snprintf(r->name, sizeof r->name, "%s", s->name ? s->name : from);
    if (!s->name) {
        r->name[strcspn(r->name, ".")] = '\0';
    }
    for (char *p = r->name; *p; p++) {
        const char c = *p;
        const bool plain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
        *p = plain ? c : '_';
    }
    if (r->name[0] == '\0') {
        (void)snprintf(r->name, sizeof r->name, "material");
    }
}

status material_measure(int nfile, const char *const *paths, const material_settings *s,
                        material_result *out)
{
    status st = OK;
    material_result r = {.rule = tensile_rule_default(), .nu = s->nu};
    r.rule.departure = s->departure;
    TRY(TAKE(r.specimen, MATERIAL_MOST));
    set_name(paths[0], s, &r);
    (void)snprintf(r.source, sizeof r.source, "%s", s->source ? s->source : "");
    for (int i = 0; i < nfile; i++) {
        const int first = r.n;
        TRY(material_curves(paths[i], s, &r));
        for (int k = first; k < r.n; k++) {
            TRY(measure_one(paths[i], &r.specimen[k], &r.rule));
            look_at_strains(&r.specimen[k], &r);
        }
    }
    TRY(pool(s, &r));
    *out = r;
    r = (material_result){0};

done:
    material_result_free(&r);
    return st;
}
