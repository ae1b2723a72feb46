// app/case_value.c
#include "app/case_value.h"

#include "base/nearest.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_SPELLINGS = 8, MOST_WORD = 64 };

// the way down: the struct at hand, and the table that fills it
typedef struct step {
    const key_table *table;
    const char *at;
} step;

// the next word of a dotted path; NULL behind the last
static const char *next_word(const char *path, char word[MOST_WORD])
{
    const size_t n = strcspn(path, ".");
    (void)snprintf(word, MOST_WORD, "%.*s", (int)(n < MOST_WORD ? n : MOST_WORD - 1), path);
    return path[n] ? path + n + 1 : NULL;
}

static const key *find_key(const key_table *t, const char *word, double *factor)
{
    for (int i = 0; i < t->nkey; i++) {
        char names[MOST_SPELLINGS][64];
        double factors[MOST_SPELLINGS];
        const int all = key_spellings(&t->keys[i], MOST_SPELLINGS, names, factors);
        const int n = all < MOST_SPELLINGS ? all : MOST_SPELLINGS;
        for (int k = 0; k < n; k++) {
            if (strcmp(names[k], word) == 0) {
                *factor = factors[k];
                return &t->keys[i];
            }
        }
    }
    return NULL;
}

static const char *name_of(const key *list, const char *item)
{
    const char *name = NULL;
    if (list->kind == KEY_NAMED) {
        memcpy(&name, item + sizeof(mark), sizeof name);
        return name;
    }
    for (int i = 0; i < list->table->nkey; i++) {
        const key *k = &list->table->keys[i];
        if (strcmp(k->name, "name") == 0 && k->kind == KEY_TEXT) {
            memcpy(&name, item + k->offset, sizeof name);
        }
    }
    return name;
}

// the entry of a list by its number or name; NULL: none
static const char *find_entry(const key *k, const key_list *list, const char *word)
{
    char *end = NULL;
    const long number = strtol(word, &end, 10);
    for (int i = 0; i < list->count; i++) {
        const char *item = (const char *)list->items + (size_t)i * k->table->size;
        const char *name = name_of(k, item);
        const bool numbered = k->kind == KEY_LIST && *word && *end == 0 && number == i;
        if (numbered || (name && strcmp(name, word) == 0)) {
            return item;
        }
    }
    return NULL;
}

static void take_choice(const key *k, int index, case_value *out)
{
    const char *word = k->choices;
    for (int i = 0; i < index && word; i++) {
        const char *bar = strchr(word, '|');
        word = bar ? bar + 1 : NULL;
    }
    out->text = word;
    out->length = word ? (int)strcspn(word, "|") : 0;
}

static void take_value(const key *k, const char *at, double factor, case_value *out)
{
    const void *value = at + k->offset;
    *out = (case_value){.key = k, .number = NAN};
    switch (k->kind) {
    case KEY_REAL:
        out->number = *(const double *)value / factor;
        break;
    case KEY_INTEGER:
        out->number = *(const int *)value;
        break;
    case KEY_FLAG:
        out->text = *(const bool *)value ? "true" : "false";
        out->length = (int)strlen(out->text);
        break;
    case KEY_FIELD:
        out->number = field_varies(value) ? NAN : ((const field *)value)->value / factor;
        break;
    case KEY_PLACE:
        out->number =
            ((const place_field *)value)->at ? NAN : ((const place_field *)value)->value / factor;
        break;
    case KEY_CHOICE:
        take_choice(k, *(const int *)value, out);
        break;
    default:
        break;
    }
}

static void offer_spellings(const key *k, nearest *near)
{
    char names[MOST_SPELLINGS][64];
    double factors[MOST_SPELLINGS];
    const int all = key_spellings(k, MOST_SPELLINGS, names, factors);
    for (int i = 0; i < all && i < MOST_SPELLINGS; i++) {
        nearest_offer(near, names[i], names[i]);
    }
}

status case_value_find(const case_data *c, const char *path, mark at, case_value *out)
{
    key_table root;
    case_file initial;
    char word[MOST_WORD];
    case_keys(&root, &initial);
    step s = {&root, (const char *)&c->file};
    for (const char *rest = path; rest && s.at;) {
        double factor = 1;
        rest = next_word(rest, word);
        const key *k = find_key(s.table, word, &factor);
        if (!k || (!rest && (k->kind == KEY_TABLE || k->table))) {
            break;
        }
        if (!rest) {
            take_value(k, s.at, factor, out);
            return OK;
        }
        if (!k->table) {
            break; // also inside of a row of numbers
        }
        s.at += k->offset;
        if (k->kind != KEY_TABLE) {
            key_list list;
            memcpy(&list, s.at, sizeof list);
            rest = next_word(rest, word);
            s.at = find_entry(k, &list, word);
        }
        s.table = k->table;
        if (!rest) {
            break;
        }
    }
    char words[NEAREST_WORDS];
    nearest near = nearest_to(word);
    for (int i = 0; s.at && i < s.table->nkey; i++) {
        offer_spellings(&s.table->keys[i], &near);
    }
    return config_fail(c->config, at, "the case has no '%.60s' at '%.100s'%s", word, path,
                       nearest_words(&near, words));
}
