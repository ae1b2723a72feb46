// io/key_markdown.c
#include "io/key_names.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// '|' would end a cell
static void put_cell(FILE *stream, const char *text)
{
    for (const char *p = text; *p; p++) {
        (void)fprintf(stream, *p == '|' ? "\\%c" : "%c", *p);
    }
}

static void put_limits(FILE *stream, const key *k, const unit *u)
{
    if (k->min == 0 && k->max == 0) {
        return;
    }
    const char *space = u->name[0] ? " " : "";
    if (isfinite(k->max)) {
        (void)fprintf(stream, ", %.6g to %.6g%s%s", unit_from_si(u, k->min),
                      unit_from_si(u, k->max), space, u->name);
    } else {
        (void)fprintf(stream, ", at least %.6g%s%s", unit_from_si(u, k->min), space, u->name);
    }
}

// headings are linked to with hyphens for spaces
static void put_link(FILE *stream, const char *name)
{
    (void)fprintf(stream, " [%s](#", name);
    for (const char *p = name; *p; p++) {
        (void)fputc(*p == ' ' ? '-' : *p, stream);
    }
    (void)fputc(')', stream);
}

static void put_value(FILE *stream, const key *k)
{
    static const char *const kinds[] = {
        [KEY_REAL] = "number",
        [KEY_INTEGER] = "whole number",
        [KEY_FLAG] = "true or false",
        [KEY_TEXT] = "text",
        [KEY_NAME] = "name",
        [KEY_FIELD] = "number or expression in s",
        [KEY_PLACE] = "number or expression in x, y and s, all in metres",
        [KEY_TEXTS] = "list of texts, or one",
        [KEY_TABLE] = "map of",
        [KEY_LIST] = "list of",
        [KEY_NAMED] = "map from names to",
    };
    const unit *units = NULL;
    (void)unit_list(k->dimension, &units);
    if (k->kind == KEY_CHOICE) {
        put_cell(stream, k->choices);
    } else if (k->kind == KEY_VECTOR) {
        (void)fprintf(stream, "%d numbers", k->count);
    } else if (k->kind == KEY_FIELDS) {
        (void)fprintf(stream, "%d numbers or expressions in s", k->count);
    } else if (k->kind == KEY_ROWS && k->count > 0) {
        (void)fprintf(stream, "rows of %d numbers", k->count);
    } else if (k->kind == KEY_ROWS) {
        (void)fprintf(stream, "rows of numbers%s", k->open ? " or ~" : "");
    } else {
        (void)fputs(kinds[k->kind], stream);
    }
    if (k->table) {
        put_link(stream, k->table->name);
    }
    put_limits(stream, k, units);
}

static void put_demand(FILE *stream, const key *k)
{
    if (k->required) {
        (void)fputs("required", stream);
    } else if (k->one_of > 0) {
        (void)fprintf(stream, "one of group %d", k->one_of);
    } else if (k->one_of < 0) {
        (void)fprintf(stream, "at most one of group %d", -k->one_of);
    } else if (k->initial) {
        put_cell(stream, k->initial);
    }
}

static void put_key(FILE *stream, const key *k)
{
    const unit *units = NULL;
    const int n = unit_list(k->dimension, &units);
    (void)fputs("| ", stream);
    for (int i = 0; i < n; i++) {
        char name[KEY_NAME_TEXT];
        key_spelling(k, &units[i], name);
        (void)fprintf(stream, "%s`%s`", i ? " " : "", name);
    }
    (void)fputs(" | ", stream);
    put_value(stream, k);
    (void)fputs(" | ", stream);
    put_demand(stream, k);
    (void)fputs(" | ", stream);
    put_cell(stream, k->about ? k->about : "");
    (void)fputs(" |\n", stream);
}

static void put_table(FILE *stream, const key_table *table)
{
    (void)fprintf(stream, "\n## %s\n\n", table->name);
    if (table->about) {
        (void)fprintf(stream, "%s\n\n", table->about);
    }
    (void)fputs("| key | value | default | meaning |\n|---|---|---|---|\n", stream);
    for (int i = 0; i < table->nkey; i++) {
        put_key(stream, &table->keys[i]);
    }
}

status schema_markdown(const key_table *root, void *stdio_stream)
{
    FILE *stream = stdio_stream;
    key_tables below = {0};
    const status st = key_tables_collect(root, &below);
    if (st != OK) {
        return st;
    }
    put_table(stream, root);
    for (int i = 0; i < below.count; i++) {
        put_table(stream, below.item[i]);
    }
    return ferror(stream) ? status_fail(ERR_RESOURCE, "writing the key reference failed") : OK;
}
