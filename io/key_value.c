// io/key_value.c
#include "io/key_value.h"

#include "base/nearest.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

enum {

    FIELD_SAMPLES =
        17, // places along the rod where the range of a varying number is checked, ends included
};

// What the conversion of units may add to a number that stands exactly at an end of its range, over
// that end: two roundings. Nothing is added to 0, so that a range from 0 holds nothing below it.
static const double RANGE_ROUNDING = 4 * DBL_EPSILON;

static bool within(double value, double least, double most)
{
    // an infinite end is compared as it is: its room would be infinite too
    const double below = isfinite(least) ? RANGE_ROUNDING * fabs(least) : 0;
    const double above = isfinite(most) ? RANGE_ROUNDING * fabs(most) : 0;
    return value >= least - below && value <= most + above;
}

status value_mismatch(const value_key *v, const node *n, const char *wanted)
{
    char found[96];
    if (n->kind != NODE_SCALAR) {
        (void)snprintf(found, sizeof found, "a %s", n->kind == NODE_LIST ? "list" : "map");
    } else if (n->plain && n->text[0] == '\0') {
        (void)snprintf(found, sizeof found, "nothing");
    } else {
        (void)snprintf(found, sizeof found, "'%s'", shortened(n->text).a);
    }
    return config_fail(v->cfg, n->at, "'%s': expected %s, found %s", shortened(v->written).a,
                       wanted, found);
}

status value_count(const value_key *v, const node *n, int count)
{
    const int most = v->k->max_count > 0 ? v->k->max_count : KEY_MAX_COUNT;
    if (count > most) {
        return config_fail(v->cfg, n->at, "'%s': %d entries, at most %d are allowed",
                           shortened(v->written).a, count, most);
    }
    return OK;
}

static bool is_text(const node *n)
{
    return n->kind == NODE_SCALAR && (n->text[0] != '\0' || !n->plain);
}

static bool is_word(const char *text)
{
    for (const char *p = text; *p; p++) {
        const bool letter = (*p >= 'a' && *p <= 'z') || (*p >= 'A' && *p <= 'Z') || *p == '_';
        if (!letter && (p == text || *p < '0' || *p > '9')) {
            return false;
        }
    }
    return text[0] != '\0';
}

static status arithmetic_fails(const value_key *v, const node *n, const expression_error *error)
{
    mark at = n->at;
    if (n->text_column > 0) {
        at.column = n->text_column + error->position;
    }
    // a single word was hardly meant as arithmetic
    if (is_word(n->text) && strncmp(error->words, "unknown", 7) == 0) {
        char words[NEAREST_WORDS];
        nearest near = nearest_to(n->text);
        nearest_offer(&near, "pi", "pi");
        return config_fail(v->cfg, at, "'%s': expected a number, found '%s'%s",
                           shortened(v->written).a, shortened(n->text).a,
                           nearest_words(&near, words));
    }
    return config_fail(v->cfg, at, "'%s': %s", shortened(v->written).a, error->words);
}

// L and s stand in the unit of a length's key, else in metres, so that s/L is the same ratio
// everywhere
static const unit *arc_unit(const value_key *v)
{
    static const unit metre = {"m", 1};
    return v->k->dimension == DIM_LENGTH ? v->u : &metre;
}

static expression_scope scope_of(const value_key *v)
{
    return (expression_scope){
        .has_L = v->cfg->has_length,
        .has_s = v->k->kind == KEY_FIELD || v->k->kind == KEY_FIELDS || v->k->kind == KEY_PLACE,
        .has_place = v->k->kind == KEY_PLACE,
        .L = unit_from_si(arc_unit(v), v->cfg->length_m),
        .no_L = "the length of the rod comes first",
        .no_s = "this number does not vary along the rod",
    };
}

static void limit_text(const value_key *v, double si, char *text, size_t size)
{
    (void)snprintf(text, size, "%.6g%s%s", unit_from_si(v->u, si), v->u->name[0] ? " " : "",
                   v->u->name);
}

// at_s: where along the rod, for the message; "" where that does not matter
static status check_range(const value_key *v, const node *n, double *si, const char *at_s)
{
    const double least = v->k->min, most = v->k->max;
    const short_text name = shortened(v->written);
    char value[48], from[48], to[48];
    if (!isfinite(*si)) {
        return config_fail(v->cfg, n->at, "'%s': this is not a finite number%s", name.a, at_s);
    }
    if (least == 0 && most == 0) {
        return OK;
    }
    if (within(*si, least, most)) {
        *si = fmin(fmax(*si, least), most);
        return OK;
    }
    limit_text(v, *si, value, sizeof value);
    limit_text(v, least, from, sizeof from);
    limit_text(v, most, to, sizeof to);
    if (least == most) {
        return config_fail(v->cfg, n->at, "'%s': %s%s is out of range, only %s is known", name.a,
                           value, at_s, from);
    }
    if (!isfinite(most)) {
        return config_fail(v->cfg, n->at, "'%s': %s%s is out of range, %s at least", name.a, value,
                           at_s, from);
    }
    return config_fail(v->cfg, n->at, "'%s': %s%s is out of range, %s to %s", name.a, value, at_s,
                       from, to);
}

status value_real(const value_key *v, const node *n, double *out)
{
    expression_error error = {0};
    double value = 0;
    if (!is_text(n)) {
        return value_mismatch(v, n, "a number");
    }
    const expression_scope scope = scope_of(v);
    const status st = expression_value(v->cfg->arithmetic, n->text, &scope, &value, &error);
    if (st == ERR_INPUT) {
        return arithmetic_fails(v, n, &error);
    }
    if (st != OK) {
        return st;
    }
    *out = unit_to_si(v->u, value);
    return check_range(v, n, out, "");
}

status value_integer(const value_key *v, const node *n, int *out)
{
    double value = 0;
    const status st = value_real(v, n, &value);
    if (st != OK) {
        return st;
    }
    if (value != rint(value) || fabs(value) > INT_MAX) {
        return value_mismatch(v, n, "a whole number");
    }
    *out = (int)value;
    return OK;
}

status value_flag(const value_key *v, const node *n, bool *out)
{
    const bool text = is_text(n);
    *out = text && strcmp(n->text, "true") == 0;
    if (!*out && !(text && strcmp(n->text, "false") == 0)) {
        return value_mismatch(v, n, "true or false");
    }
    return OK;
}

status value_text(const value_key *v, const node *n, const char **out)
{
    if (!is_text(n)) {
        return value_mismatch(v, n, "a text");
    }
    *out = n->text;
    return OK;
}

status value_choice(const value_key *v, const node *n, int *out)
{
    char wanted[400], words[NEAREST_WORDS];
    nearest near = nearest_to(is_text(n) ? n->text : "");
    size_t used = (size_t)snprintf(wanted, sizeof wanted, "one of");
    const char *p = v->k->choices;
    for (int i = 0; p; i++) {
        char choice[NEAREST_NAME];
        const size_t length = strcspn(p, "|");
        (void)snprintf(choice, sizeof choice, "%.*s", (int)length, p);
        if (is_text(n) && strcmp(n->text, choice) == 0) {
            *out = i;
            return OK;
        }
        nearest_offer(&near, choice, choice);
        if (used < sizeof wanted) {
            used += (size_t)snprintf(wanted + used, sizeof wanted - used, "%s %s", i ? "," : "",
                                     choice);
        }
        p = p[length] ? p + length + 1 : NULL;
    }
    if (!is_text(n) || !near.best[0]) {
        return value_mismatch(v, n, wanted);
    }
    return config_fail(v->cfg, n->at, "'%s': expected %s, found '%s'%s", shortened(v->written).a,
                       wanted, shortened(n->text).a, nearest_words(&near, words));
}

typedef struct varying {
    const expression *compiled;
    const unit *arc, *value;
} varying;

static double varying_at(const void *expression, double s)
{
    const varying *f = expression;
    return unit_to_si(f->value, expression_at(f->compiled, unit_from_si(f->arc, s)));
}

static double varying_over(const void *expression, double x, double y, double s)
{
    const varying *f = expression;
    const unit *u = f->arc; // x, y and s alike
    return unit_to_si(f->value, expression_at_place(f->compiled, unit_from_si(u, x),
                                                    unit_from_si(u, y), unit_from_si(u, s)));
}

static status check_along(const value_key *v, const node *n, const field *f)
{
    status st = OK;
    for (int i = 0; v->cfg->has_length && st == OK && i < FIELD_SAMPLES; i++) {
        char where[48];
        const double s = v->cfg->length_m * i / (FIELD_SAMPLES - 1);
        double value = field_at(f, s);
        (void)snprintf(where, sizeof where, " at s = %.6g mm", 1e3 * s);
        st = check_range(v, n, &value, where);
    }
    return st;
}

static status compile(const value_key *v, const node *n, varying **out)
{
    expression_error error = {0};
    varying *f = NULL;
    const expression_scope scope = scope_of(v);
    status st = ARENA_TAKE(v->cfg->memory, f, 1);
    if (st != OK) {
        return st;
    }
    f->arc = arc_unit(v);
    f->value = v->u;
    st = expression_compile(v->cfg->arithmetic, n->text, &scope, &f->compiled, &error);
    *out = f;
    return st == ERR_INPUT ? arithmetic_fails(v, n, &error) : st;
}

status value_field(const value_key *v, const node *n, field *out)
{
    varying *f = NULL;
    if (!is_text(n) || !expression_uses(n->text, 's')) {
        *out = (field){0};
        return value_real(v, n, &out->value);
    }
    const status st = compile(v, n, &f);
    *out = (field){.at = varying_at, .expression = f};
    return st == OK ? check_along(v, n, out) : st;
}

status value_place(const value_key *v, const node *n, place_field *out)
{
    varying *f = NULL;
    const bool along = is_text(n) && expression_uses(n->text, 's');
    const bool across =
        is_text(n) && (expression_uses(n->text, 'x') || expression_uses(n->text, 'y'));
    if (!along && !across) {
        *out = (place_field){0};
        return value_real(v, n, &out->value);
    }
    const status st = compile(v, n, &f);
    const field at_origin = {.at = varying_at, .expression = f};
    *out = (place_field){.at = varying_over, .expression = f, .across = across, .along = along};
    return st == OK && !across ? check_along(v, n, &at_origin) : st;
}
