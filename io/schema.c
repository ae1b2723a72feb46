// io/schema.c
#include "io/json.h"
#include "io/key_names.h"
#include "io/number.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

typedef struct schema {
    json *out;
    key_tables below;
} schema;

// "material", or "material_2" where another table has that name
static void definition_name(const schema *s, const key_table *table, char name[KEY_NAME_TEXT])
{
    int same = 1;
    for (int i = 0; i < s->below.count && s->below.item[i] != table; i++) {
        same += strcmp(s->below.item[i]->name, table->name) == 0;
    }
    if (same > 1) {
        (void)snprintf(name, KEY_NAME_TEXT, "%s_%d", table->name, same);
    } else {
        (void)snprintf(name, KEY_NAME_TEXT, "%s", table->name);
    }
}

static void write_reference(schema *s, const char *key_name, const key_table *table)
{
    char name[KEY_NAME_TEXT], reference[KEY_NAME_TEXT + 16];
    definition_name(s, table, name);
    (void)snprintf(reference, sizeof reference, "#/$defs/%s", name);
    if (key_name) {
        json_object(s->out, key_name);
    }
    json_text(s->out, "$ref", reference);
    if (key_name) {
        json_object_end(s->out);
    }
}

static void write_types(json *out, const char *first, const char *second, bool or_null)
{
    json_array(out, "type");
    json_text(out, NULL, first);
    json_text(out, NULL, second);
    if (or_null) {
        json_text(out, NULL, "null");
    }
    json_array_end(out);
}

// a number may be arithmetic, and then it is a text; the limits hold for numbers
static void write_number(json *out, const key *k, const unit *u)
{
    write_types(out, k->kind == KEY_INTEGER ? "integer" : "number", "string", k->open);
    if (k->min != 0 || k->max != 0) {
        if (isfinite(k->min)) {
            json_real(out, "minimum", unit_from_si(u, k->min));
        }
        if (isfinite(k->max)) {
            json_real(out, "maximum", unit_from_si(u, k->max));
        }
    }
}

static void write_numbers(json *out, const key *k, const unit *u)
{
    json_text(out, "type", "array");
    json_object(out, "items");
    write_number(out, k, u);
    json_object_end(out);
    json_integer(out, "minItems", k->count > 0 ? k->count : 1);
    if (k->count > 0) {
        json_integer(out, "maxItems", k->count);
    }
}

// rows, or one row without the outer brackets
static void write_rows(json *out, const key *k, const unit *u)
{
    json_array(out, "anyOf");
    json_object(out, NULL);
    write_numbers(out, k, u);
    json_object_end(out);
    json_object(out, NULL);
    json_text(out, "type", "array");
    json_object(out, "items");
    write_numbers(out, k, u);
    json_object_end(out);
    json_integer(out, "minItems", 1);
    json_integer(out, "maxItems", k->max_count > 0 ? k->max_count : KEY_MAX_COUNT);
    json_object_end(out);
    json_array_end(out);
}

static void write_choices(json *out, const char *choices)
{
    json_array(out, "enum");
    for (const char *p = choices; p;) {
        char choice[KEY_NAME_TEXT];
        const size_t length = strcspn(p, "|");
        (void)snprintf(choice, sizeof choice, "%.*s", (int)length, p);
        json_text(out, NULL, choice);
        p = p[length] ? p + length + 1 : NULL;
    }
    json_array_end(out);
}

// a list of texts, or one
static void write_texts(json *out, int most)
{
    json_array(out, "anyOf");
    json_object(out, NULL);
    write_types(out, "string", "number", false);
    json_object_end(out);
    json_object(out, NULL);
    json_text(out, "type", "array");
    json_object(out, "items");
    write_types(out, "string", "number", false);
    json_object_end(out);
    json_integer(out, "minItems", 1);
    json_integer(out, "maxItems", most);
    json_object_end(out);
    json_array_end(out);
}

static void write_kind(schema *s, const key *k, const unit *u)
{
    const int most = k->max_count > 0 ? k->max_count : KEY_MAX_COUNT;
    switch (k->kind) {
    case KEY_REAL:
    case KEY_INTEGER:
    case KEY_FIELD:
    case KEY_PLACE:
        write_number(s->out, k, u);
        break;
    case KEY_FLAG:
        json_text(s->out, "type", "boolean");
        break;
    case KEY_TEXT:
    case KEY_NAME:
        write_types(s->out, "string", "number", false);
        break;
    case KEY_CHOICE:
        write_choices(s->out, k->choices);
        break;
    case KEY_VECTOR:
    case KEY_FIELDS:
        write_numbers(s->out, k, u);
        break;
    case KEY_ROWS:
        write_rows(s->out, k, u);
        break;
    case KEY_TEXTS:
        write_texts(s->out, most);
        break;
    case KEY_TABLE:
        write_reference(s, NULL, k->table);
        break;
    case KEY_LIST:
        json_text(s->out, "type", "array");
        write_reference(s, "items", k->table);
        json_integer(s->out, "maxItems", most);
        break;
    case KEY_NAMED:
        json_text(s->out, "type", "object");
        write_reference(s, "additionalProperties", k->table);
        json_integer(s->out, "maxProperties", most);
        break;
    }
}

// "[0, 0, 1]"
static void write_default_list(json *out, const char *text)
{
    json_array(out, "default");
    for (const char *p = text + 1; *p && *p != ']';) {
        char item[NUMBER_TEXT];
        double value = 0;
        const size_t length = strcspn(p, ",]");
        (void)snprintf(item, sizeof item, "%.*s", (int)length, p + strspn(p, " "));
        item[strcspn(item, ",] ")] = '\0';
        if (number_read(item, &value)) {
            json_real(out, NULL, value);
        }
        p += length + (p[length] == ',');
    }
    json_array_end(out);
}

// the default is written in the key's most usual unit
static void write_default(json *out, const key *k)
{
    double value = 0;
    if (!k->initial) {
        return;
    }
    if (k->kind == KEY_FLAG) {
        json_flag(out, "default", strcmp(k->initial, "true") == 0);
    } else if (k->initial[0] == '[') {
        write_default_list(out, k->initial);
    } else if (number_read(k->initial, &value)) {
        json_real(out, "default", value);
    } else {
        json_text(out, "default", k->initial);
    }
}

static void write_key(schema *s, const key *k)
{
    const unit *units = NULL;
    const int n = unit_list(k->dimension, &units);
    for (int i = 0; i < n; i++) {
        char name[KEY_NAME_TEXT], about[512];
        key_spelling(k, &units[i], name);
        const bool along = k->kind == KEY_FIELD || k->kind == KEY_FIELDS;
        const char *varies = along                  ? " (may vary with the arclength s)"
                             : k->kind == KEY_PLACE ? " (may vary with the place x, y, s [m])"
                                                    : "";
        (void)snprintf(about, sizeof about, "%s%s", k->about ? k->about : "", varies);
        json_object(s->out, name);
        json_text(s->out, "description", about);
        write_kind(s, k, &units[i]);
        if (i == 0) {
            write_default(s->out, k);
        }
        json_object_end(s->out);
    }
}

// every way to give a key of the group: one "required" each
static void write_alternatives(json *out, const key_table *table, int only, int group)
{
    for (int i = 0; i < table->nkey; i++) {
        const unit *units = NULL;
        const int n = unit_list(table->keys[i].dimension, &units);
        for (int j = 0; j < n && (group ? table->keys[i].one_of == group : i == only); j++) {
            char name[KEY_NAME_TEXT];
            key_spelling(&table->keys[i], &units[j], name);
            json_object(out, NULL);
            json_array(out, "required");
            json_text(out, NULL, name);
            json_array_end(out);
            json_object_end(out);
        }
    }
}

// exactly one of the spellings, or none of them where nothing is required
static void write_choice_of_keys(json *out, const key_table *table, int only, int group,
                                 bool required)
{
    json_object(out, NULL);
    json_array(out, "oneOf");
    write_alternatives(out, table, only, group);
    if (!required) {
        json_object(out, NULL);
        json_object(out, "not");
        json_array(out, "anyOf");
        write_alternatives(out, table, only, group);
        json_array_end(out);
        json_object_end(out);
        json_object_end(out);
    }
    json_array_end(out);
    json_object_end(out);
}

static bool first_of_group(const key_table *table, int i)
{
    for (int j = 0; j < i; j++) {
        if (table->keys[j].one_of == table->keys[i].one_of) {
            return false;
        }
    }
    return true;
}

static void write_demands(json *out, const key_table *table)
{
    json_array(out, "allOf");
    for (int i = 0; i < table->nkey; i++) {
        const key *k = &table->keys[i];
        if (k->one_of != 0 && first_of_group(table, i)) {
            write_choice_of_keys(out, table, i, k->one_of, k->one_of > 0);
        } else if (k->one_of == 0 && (k->required || k->dimension != DIM_NONE)) {
            write_choice_of_keys(out, table, i, 0, k->required);
        }
    }
    json_array_end(out);
}

static void write_table(schema *s, const key_table *table)
{
    json_text(s->out, "type", "object");
    if (table->about) {
        json_text(s->out, "description", table->about);
    }
    json_object(s->out, "properties");
    for (int i = 0; i < table->nkey; i++) {
        write_key(s, &table->keys[i]);
    }
    json_object_end(s->out);
    json_flag(s->out, "additionalProperties", false);
    write_demands(s->out, table);
}

status schema_write(const key_table *root, struct json *out)
{
    schema s = {.out = out};
    const status st = key_tables_collect(root, &s.below);
    if (st != OK) {
        return st;
    }
    json_object(out, NULL);
    json_text(out, "$schema", "https://json-schema.org/draft/2020-12/schema");
    json_text(out, "title", "a case of stiffaxis");
    write_table(&s, root);
    json_object(out, "$defs");
    for (int i = 0; i < s.below.count; i++) {
        char name[KEY_NAME_TEXT];
        definition_name(&s, s.below.item[i], name);
        json_object(out, name);
        write_table(&s, s.below.item[i]);
        json_object_end(out);
    }
    json_object_end(out);
    json_object_end(out);
    return OK;
}
