// io/key_markdown.c
#include "io/key_names.h"
#include "io/key_words.h"

#include <stdio.h>

// '|' would end a cell
static void put_cell(FILE *stream, const char *text)
{
    for (const char *p = text; *p; p++) {
        (void)fprintf(stream, *p == '|' ? "\\%c" : "%c", *p);
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
    char words[KEY_WORDS];
    key_value_words(k, words);
    put_cell(stream, words);
    if (k->table) {
        put_link(stream, k->table->name);
    }
    key_limit_words(k, words);
    (void)fprintf(stream, "%s%s", words[0] ? ", " : "", words);
}

static void put_key(FILE *stream, const key *k)
{
    char words[KEY_WORDS];
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
    key_demand_words(k, words);
    put_cell(stream, words);
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
    return key_reference(root, stdio_stream, put_table);
}
