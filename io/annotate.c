#include "io/annotate.h"

#include "base/memory.h"
#include "io/case_text.h"
#include "io/case_tree.h"
#include "io/key_words.h"
#include "io/yaml_door.h"

#include <stdio.h>
#include <string.h>

// where comments behind a value begin, counted from 0, unless the line is longer
enum { BEHIND = 34 };

// The first use of a key.
typedef struct note {
    const key *k;
    const unit *u;
    const char *written;
    int line; // that the comment belongs to
    bool own; // the key begins its line, in no braces
} note;

typedef struct annotation {
    config tree; // the text alone
    int nnote;
    note *note; // in the text's order
    FILE *out;
} annotation;

static bool known(const annotation *a, const key *k)
{
    for (int i = 0; i < a->nnote; i++) {
        // rings and discs have a centre each, which need not be told twice
        if (a->note[i].k == k || (strcmp(a->note[i].k->name, k->name) == 0 &&
                                  strcmp(a->note[i].k->about, k->about) == 0)) {
            return true;
        }
    }
    return false;
}

static bool in_braces(const annotation *a, const node *n)
{
    const unsigned first = case_text_at(a->tree.text, a->tree.length, n->at.line, n->at.column);
    return first == '{' || first == '[';
}

// anchor: the line on which the braces around begin; 0: none
static void note_map(annotation *a, const node *map, const key_table *table, int anchor);

static void note_entries(annotation *a, const node *n, const key_table *table, int anchor)
{
    for (const node *item = n->first; item; item = item->next) {
        const int line = item->key ? item->key_at.line : item->at.line;
        note_map(a, item, table, anchor > 0 || !in_braces(a, item) ? anchor : line);
    }
}

static void note_map(annotation *a, const node *map, const key_table *table, int anchor)
{
    if (map->kind != NODE_MAP) {
        return;
    }
    for (const node *entry = map->first; entry; entry = entry->next) {
        const unit *u = NULL;
        const key *k = key_find(table, entry->key, &u);
        if (!k) {
            continue;
        }
        const int line = anchor > 0 ? anchor : entry->key_at.line;
        if (!known(a, k)) {
            a->note[a->nnote++] = (note){k, u, entry->key, line, anchor == 0};
        }
        const int inner = anchor > 0 || (k->table && in_braces(a, entry)) ? line : 0;
        if (k->kind == KEY_TABLE || (k->kind == KEY_LIST && entry->kind == NODE_MAP)) {
            note_map(a, entry, k->table, inner);
        } else if (k->table && entry->kind != NODE_SCALAR) {
            note_entries(a, entry, k->table, inner);
        }
    }
}

// --- writing

// bytes of a line before its comment; its length where there is none
static size_t before_comment(const char *line, size_t length)
{
    char quote = 0;
    for (size_t i = 0; i < length; i++) {
        if (quote) {
            quote = line[i] == quote ? 0 : quote;
        } else if ((line[i] == '\'' || line[i] == '"') && (i == 0 || strchr(" [{,", line[i - 1]))) {
            quote = line[i];
        } else if (line[i] == '#' && (i == 0 || line[i - 1] == ' ')) {
            return i;
        }
    }
    return length;
}

// "name   words", broken into lines
static void write_above(FILE *out, int indent, int width, const char *name, const char *words)
{
    int column = fprintf(out, "%*s# %-*s", indent, "", width, name);
    for (const char *word = words; *word;) {
        const int n = (int)strcspn(word, " ");
        const bool first = word == words;
        if (!first && column + 1 + n > ANNOTATE_WIDTH) {
            column = fprintf(out, "\n%*s# %*s  ", indent, "", width, "") - 1;
        } else {
            column += fprintf(out, first ? "  " : " ");
        }
        column += fprintf(out, "%.*s", n, word);
        word += n;
        word += *word == ' ';
    }
    (void)fputc('\n', out);
}

static void write_line(const annotation *a, const char *line, size_t length, const note *n,
                       int nnote)
{
    char words[KEY_WORDS];
    const size_t code = before_comment(line, length);
    const int indent = (int)strspn(line, " ");
    const bool own = nnote > 0 && n->own;
    if (own && code < length) {
        n++, nnote--; // its writer said it
    } else if (own && nnote == 1) {
        key_help(n->k, n->u, words);
        const size_t pad = length < BEHIND - 1 ? BEHIND - length : 2;
        if (length + pad + 2 + strlen(words) <= ANNOTATE_WIDTH) {
            fprintf(a->out, "%.*s%*s# %s\n", (int)length, line, (int)pad, "", words);
            return;
        }
    }
    int width = 0;
    for (int i = 0; i < nnote; i++) {
        const int wide = (int)strlen(n[i].written);
        width = wide > width ? wide : width;
    }
    for (int i = 0; i < nnote; i++) {
        key_help(n[i].k, n[i].u, words);
        write_above(a->out, indent, width, n[i].written, words);
    }
    fprintf(a->out, "%.*s\n", (int)length, line);
}

static void write_all(const annotation *a)
{
    const char *line = a->tree.text;
    int i = 0;
    for (int number = 1; *line; number++) {
        const size_t length = strcspn(line, "\n");
        int n = 0;
        while (i + n < a->nnote && a->note[i + n].line == number) {
            n++;
        }
        write_line(a, line, length, a->note + i, n);
        i += n;
        line += length + (line[length] == '\n');
    }
}

static status write_text(annotation *a, char **out)
{
    size_t size = 0;
    a->out = open_memstream(out, &size);
    if (a->out) {
        write_all(a);
    }
    if (a->out && fclose(a->out) == 0) {
        return OK;
    }
    free(*out);
    *out = NULL;
    return status_fail(ERR_RESOURCE, "out of memory: a case with its comments");
}

status config_annotate(const char *path, const char *text, const key_table *root, char **out)
{
    status st = OK;
    annotation a = {.tree = {.path = (char *)(size_t)path, .text = (char *)(size_t)text}};
    a.tree.length = strlen(text);
    TRY(arena_make(&a.tree.memory));
    TRY(yaml_read(&a.tree, text, a.tree.length, -1, &a.tree.root));
    TRY(TAKE(a.note, (size_t)a.tree.nnode + 1));
    if (a.tree.root) {
        note_map(&a, a.tree.root, root, 0);
    }
    TRY(write_text(&a, out));

done:
    arena_free(a.tree.memory);
    free(a.note);
    return st;
}
