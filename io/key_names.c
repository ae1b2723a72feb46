// io/key_names.c
#include "io/key_names.h"

#include "base/nearest.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double degree = 0.017453292519943295769; // pi / 180

int unit_list(dimension d, const unit **list)
{
    static const unit none[] = {{"", 1}};
    static const unit length[] = {{"mm", 1e-3}, {"m", 1}, {"cm", 1e-2}, {"um", 1e-6}};
    static const unit angle[] = {{"rad", 1}, {"deg", degree}};
    static const unit force[] = {{"N", 1}, {"mN", 1e-3}};
    static const unit moment[] = {{"Nm", 1}, {"Nmm", 1e-3}};
    static const unit stress[] = {{"MPa", 1e6}, {"kPa", 1e3}, {"Pa", 1}, {"GPa", 1e9}};
    static const unit density[] = {{"kg_per_m3", 1}, {"g_per_cm3", 1e3}};
    static const unit curvature[] = {
        {"per_m", 1}, {"rad_per_m", 1}, {"deg_per_m", degree}, {"per_mm", 1e3}};
    static const unit line_force[] = {{"N_per_m", 1}, {"N_per_mm", 1e3}, {"mN_per_mm", 1}};
    static const unit line_moment[] = {{"Nm_per_m", 1}, {"Nmm_per_mm", 1}, {"Nmm_per_m", 1e-3}};
    static const unit acceleration[] = {{"m_per_s2", 1}};
    static const unit volume_force[] = {{"N_per_mm3", 1e9}, {"N_per_m3", 1}};
    static const unit angle_moment[] = {{"Nm_per_rad", 1}, {"Nmm_per_rad", 1e-3}};
    static const unit area[] = {{"mm2", 1e-6}, {"m2", 1}, {"cm2", 1e-4}};
    static const struct {
        const unit *list;
        int count;
    } all[] = {
        [DIM_NONE] = {none, sizeof none / sizeof *none},
        [DIM_LENGTH] = {length, sizeof length / sizeof *length},
        [DIM_ANGLE] = {angle, sizeof angle / sizeof *angle},
        [DIM_FORCE] = {force, sizeof force / sizeof *force},
        [DIM_MOMENT] = {moment, sizeof moment / sizeof *moment},
        [DIM_STRESS] = {stress, sizeof stress / sizeof *stress},
        [DIM_DENSITY] = {density, sizeof density / sizeof *density},
        [DIM_CURVATURE] = {curvature, sizeof curvature / sizeof *curvature},
        [DIM_FORCE_PER_LENGTH] = {line_force, sizeof line_force / sizeof *line_force},
        [DIM_MOMENT_PER_LENGTH] = {line_moment, sizeof line_moment / sizeof *line_moment},
        [DIM_ACCELERATION] = {acceleration, sizeof acceleration / sizeof *acceleration},
        [DIM_FORCE_PER_VOLUME] = {volume_force, sizeof volume_force / sizeof *volume_force},
        [DIM_MOMENT_PER_ANGLE] = {angle_moment, sizeof angle_moment / sizeof *angle_moment},
        [DIM_AREA] = {area, sizeof area / sizeof *area},
    };
    *list = all[d].list;
    return all[d].count;
}

// the whole number that a unit goes into one SI unit; 0 where it does not
static double whole_parts(const unit *u)
{
    const double parts = rint(1 / u->factor);
    return u->factor < 1 && 1 / parts == u->factor ? parts : 0;
}

double unit_to_si(const unit *u, double value)
{
    const double parts = whole_parts(u);
    return parts > 0 ? value / parts : value * u->factor;
}

double unit_from_si(const unit *u, double value)
{
    const double parts = whole_parts(u);
    return parts > 0 ? value * parts : value / u->factor;
}

void key_spelling(const key *k, const unit *u, char name[KEY_NAME_TEXT])
{
    (void)snprintf(name, KEY_NAME_TEXT, "%s%s%s", k->name, u->name[0] ? "_" : "", u->name);
}

int key_spellings(const key *k, int max, char (*names)[64], double *factor)
{
    const unit *units = NULL;
    const int n = unit_list(k->dimension, &units);
    for (int i = 0; i < n && i < max; i++) {
        key_spelling(k, &units[i], names[i]);
        factor[i] = units[i].factor;
    }
    return n;
}

// the part of `written` behind the key's name and '_' ("" when it ends with the name); NULL when it
// begins otherwise
static const char *behind_name(const key *k, const char *written)
{
    const size_t n = strlen(k->name);
    if (strncmp(written, k->name, n) != 0 || (written[n] != '\0' && written[n] != '_')) {
        return NULL;
    }
    return written[n] ? written + n + 1 : written + n;
}

static const unit *find_unit(dimension d, const char *name)
{
    const unit *units = NULL;
    const int n = unit_list(d, &units);
    for (int i = 0; i < n; i++) {
        if (strcmp(units[i].name, name) == 0) {
            return &units[i];
        }
    }
    return NULL;
}

const key *key_find(const key_table *table, const char *written, const unit **u)
{
    for (int i = 0; i < table->nkey; i++) {
        const key *k = &table->keys[i];
        const char *suffix = behind_name(k, written);
        *u = suffix ? find_unit(k->dimension, suffix) : NULL;
        // "nu_" is not "nu"
        if (*u && (suffix[0] || strcmp(written, k->name) == 0)) {
            return k;
        }
    }
    return NULL;
}

void key_all_spellings(const key *k, char *words, size_t size)
{
    const unit *units = NULL;
    const int n = unit_list(k->dimension, &units);
    size_t used = 0;
    words[0] = '\0';
    for (int i = 0; i < n && used < size; i++) {
        char name[KEY_NAME_TEXT];
        key_spelling(k, &units[i], name);
        used += (size_t)snprintf(words + used, size - used, "%s%s", i ? ", " : "", name);
    }
}

static bool unit_of_any_kind(const char *name)
{
    for (int d = DIM_NONE + 1; d < DIM_COUNT; d++) {
        if (find_unit((dimension)d, name)) {
            return true;
        }
    }
    return false;
}

// the name is right and what follows is not: *st is set, and true returned
static bool wrong_unit(const config *cfg, const key *k, const node *entry, status *st)
{
    char all[256];
    const char *suffix = behind_name(k, entry->key);
    // with another '_' it is rather a longer name ("radius" and "radius_iner_mm")
    if (!suffix || strchr(suffix, '_')) {
        return false;
    }
    key_all_spellings(k, all, sizeof all);
    if (k->dimension == DIM_NONE) {
        if (!unit_of_any_kind(suffix)) {
            return false;
        }
        *st = config_fail(cfg, entry->key_at, "key '%s' has no unit; write '%s'",
                          shortened(entry->key).a, k->name);
    } else if (suffix[0] == '\0') {
        *st = config_fail(cfg, entry->key_at, "key '%s' needs its unit: %s", k->name, all);
    } else {
        *st = config_fail(cfg, entry->key_at, "unknown unit '%s' of key '%s'; known are %s",
                          shortened(suffix).a, k->name, all);
    }
    return true;
}

static void list_keys(const key_table *table, char *words, size_t size)
{
    size_t used = 0;
    words[0] = '\0';
    for (int i = 0; i < table->nkey && used < size; i++) {
        const unit *units = NULL;
        char name[KEY_NAME_TEXT];
        (void)unit_list(table->keys[i].dimension, &units);
        key_spelling(&table->keys[i], units, name);
        const char *comma = i ? ", " : "";
        if (used + strlen(name) + 8 > size) {
            (void)snprintf(words + used, size - used, ", ...");
            return;
        }
        used += (size_t)snprintf(words + used, size - used, "%s%s", comma, name);
    }
}

static void offer_spellings(const key *k, nearest *near)
{
    const unit *units = NULL;
    const int n = unit_list(k->dimension, &units);
    char name[KEY_NAME_TEXT];
    for (int j = 0; j < n; j++) {
        key_spelling(k, &units[j], name);
        nearest_offer(near, name, name);
    }
    key_spelling(k, units, name);
    nearest_offer(near, k->name, name);
}

status key_unknown(const config *cfg, const key_table *table, const node *entry)
{
    status st = OK;
    nearest near = nearest_to(entry->key);
    if (strpbrk(entry->key, " :")) {
        return config_fail(cfg, entry->key_at,
                           "'%s' is no key: a key ends with ': ', and then its value comes",
                           shortened(entry->key).a);
    }
    for (int i = 0; i < table->nkey; i++) {
        offer_spellings(&table->keys[i], &near);
    }
    for (int i = 0; i < table->nkey; i++) {
        if (wrong_unit(cfg, &table->keys[i], entry, &st)) {
            return st;
        }
    }
    if (near.best[0]) {
        char words[NEAREST_WORDS];
        return config_fail(cfg, entry->key_at, "unknown key '%s'%s", shortened(entry->key).a,
                           nearest_words(&near, words));
    }
    char known[400];
    list_keys(table, known, sizeof known);
    return config_fail(cfg, entry->key_at, "unknown key '%s'; known here are %s",
                       shortened(entry->key).a, known);
}

bool key_same_base(const char *a, const char *b)
{
    // units have '_' of their own (kg_per_m3): every one may be where the name ends
    for (const char *end = strchr(a, '_'); end; end = strchr(end + 1, '_')) {
        const size_t n = (size_t)(end - a) + 1;
        if (strncmp(a, b, n) != 0) {
            return false;
        }
        for (int d = DIM_NONE + 1; d < DIM_COUNT; d++) {
            if (find_unit((dimension)d, a + n) && find_unit((dimension)d, b + n)) {
                return true;
            }
        }
    }
    return false;
}

const char *key_written_unit(const char *written, double *factor)
{
    const char *dot = strrchr(written, '.'), *name = dot ? dot + 1 : written;
    // the longest one that fits: kg_per_m3 before m3
    for (const char *end = strchr(name, '_'); end; end = strchr(end + 1, '_')) {
        for (int d = DIM_NONE + 1; d < DIM_COUNT; d++) {
            const unit *u = find_unit((dimension)d, end + 1);
            if (u) {
                *factor = u->factor;
                return u->name;
            }
        }
    }
    *factor = 1;
    return "";
}

status key_tables_collect(const key_table *root, key_tables *out)
{
    for (int i = 0; i < root->nkey; i++) {
        const key_table *inner = root->keys[i].table;
        bool known = !inner;
        for (int j = 0; j < out->count; j++) {
            known = known || out->item[j] == inner;
        }
        if (known) {
            continue;
        }
        if (out->count == KEY_MAX_TABLES) {
            return status_fail(ERR_BUG, "more than %d key tables", KEY_MAX_TABLES);
        }
        out->item[out->count++] = inner;
        const status st = key_tables_collect(inner, out);
        if (st != OK) {
            return st;
        }
    }
    return OK;
}
