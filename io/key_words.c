// io/key_words.c
#include "io/key_words.h"

#include "io/key_names.h"

#include <math.h>
#include <stdio.h>

void key_limit_words(const key *k, char words[KEY_WORDS])
{
    const unit *u = NULL;
    (void)unit_list(k->dimension, &u);
    const char *space = u->name[0] ? " " : "";
    words[0] = '\0';
    if (k->min == 0 && k->max == 0) {
        return;
    }
    if (isfinite(k->max)) {
        (void)snprintf(words, KEY_WORDS, "%.6g to %.6g%s%s", unit_from_si(u, k->min),
                       unit_from_si(u, k->max), space, u->name);
    } else {
        (void)snprintf(words, KEY_WORDS, "at least %.6g%s%s", unit_from_si(u, k->min), space,
                       u->name);
    }
}

void key_value_words(const key *k, char words[KEY_WORDS])
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
    if (k->kind == KEY_CHOICE) {
        (void)snprintf(words, KEY_WORDS, "%s", k->choices);
    } else if (k->kind == KEY_VECTOR) {
        (void)snprintf(words, KEY_WORDS, "%d numbers", k->count);
    } else if (k->kind == KEY_FIELDS) {
        (void)snprintf(words, KEY_WORDS, "%d numbers or expressions in s", k->count);
    } else if (k->kind == KEY_ROWS && k->count > 0) {
        (void)snprintf(words, KEY_WORDS, "rows of %d numbers", k->count);
    } else if (k->kind == KEY_ROWS) {
        (void)snprintf(words, KEY_WORDS, "rows of numbers%s", k->open ? " or ~" : "");
    } else {
        (void)snprintf(words, KEY_WORDS, "%s", kinds[k->kind]);
    }
}

void key_demand_words(const key *k, char words[KEY_WORDS])
{
    words[0] = '\0';
    if (k->required) {
        (void)snprintf(words, KEY_WORDS, "required");
    } else if (k->one_of > 0) {
        (void)snprintf(words, KEY_WORDS, "one of group %d", k->one_of);
    } else if (k->one_of < 0) {
        (void)snprintf(words, KEY_WORDS, "at most one of group %d", -k->one_of);
    } else if (k->initial) {
        (void)snprintf(words, KEY_WORDS, "%s", k->initial);
    }
}

status key_reference(const key_table *root, FILE *stream,
                     void (*put_table)(FILE *stream, const key_table *table))
{
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
