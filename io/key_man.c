// io/key_man.c
#include "io/key_names.h"
#include "io/key_words.h"
#include "io/roff.h"

#include <stdio.h>

// one sentence of the meaning's line; nothing where there are no words
static void put_sentence(FILE *stream, const char *before, const char *words, const char *after)
{
    if (words[0]) {
        (void)fputs(before, stream);
        roff_text(stream, words);
        (void)fputs(after, stream);
    }
}

static void put_key(FILE *stream, const key *k)
{
    char words[KEY_WORDS];
    key_all_spellings(k, words, sizeof words);
    roff_item(stream, words);
    key_value_words(k, words);
    roff_text(stream, words);
    put_sentence(stream, " \\fI", k->table ? k->table->name : "", "\\fR");
    key_limit_words(k, words);
    put_sentence(stream, ", ", words, "");
    key_demand_words(k, words);
    put_sentence(stream, k->required || k->one_of ? "; " : "; default ", words, "");
    put_sentence(stream, "\n.br\n", k->about ? k->about : "", "");
    (void)fputc('\n', stream);
}

static void put_table(FILE *stream, const key_table *table)
{
    roff_heading(stream, table->name);
    put_sentence(stream, "", table->about ? table->about : "", "\n");
    for (int i = 0; i < table->nkey; i++) {
        put_key(stream, &table->keys[i]);
    }
}

status schema_man(const key_table *root, void *stdio_stream)
{
    return key_reference(root, stdio_stream, put_table);
}
