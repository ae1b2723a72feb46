// app/complete.c
#include "app/complete.h"

#include "app/case.h"
#include "app/examples.h"
#include "app/options.h"
#include "io/key_names.h"
#include "measure/material_test.h"
#include "measure/scan.h"

#include <string.h>

// What is being typed: `done` of it stands already, `rest` is what candidates must begin with.
typedef struct typing {
    FILE *stream;
    const char *done;
    size_t ndone;
    const char *rest;
} typing;

static void offer(const typing *t, const char *word, const char *end, const char *about)
{
    if (strncmp(word, t->rest, strlen(t->rest)) != 0) {
        return;
    }
    (void)fprintf(t->stream, "%.*s%s%s%s%s\n", (int)t->ndone, t->done, word, end, about ? "\t" : "",
                  about ? about : "");
}

// "first|second": each of them
static void offer_choices(const typing *t, const char *choices)
{
    for (const char *p = choices; p;) {
        char choice[KEY_NAME_TEXT];
        const size_t length = strcspn(p, "|");
        (void)snprintf(choice, sizeof choice, "%.*s", (int)length, p);
        offer(t, choice, "", NULL);
        p = p[length] ? p + length + 1 : NULL;
    }
}

// a key in its usual unit; in the others when its name stands already
static void offer_key(const typing *t, const key *k)
{
    const unit *units = NULL;
    const int n = unit_list(k->dimension, &units);
    for (int i = 0; i < n && (i == 0 || strlen(t->rest) > strlen(k->name)); i++) {
        char name[KEY_NAME_TEXT];
        key_spelling(k, &units[i], name);
        offer(t, name, k->table ? "." : "=", k->about);
    }
}

static void offer_values(const typing *t, const key *k)
{
    if (k->kind == KEY_CHOICE) {
        offer_choices(t, k->choices);
    } else if (k->kind == KEY_FLAG) {
        offer_choices(t, "true|false");
    }
}

// KEY=VALUE, KEY being a path of names and, in lists and named maps, of entries
static void complete_setting(const key_table *table, const char *text, FILE *stream)
{
    const char *rest = text;
    while (table) {
        char name[KEY_NAME_TEXT];
        const unit *u = NULL;
        const size_t n = strcspn(rest, ".=");
        const typing t = {stream, text, (size_t)(rest - text), rest};
        if (rest[n] == '\0') {
            for (int i = 0; i < table->nkey; i++) {
                offer_key(&t, &table->keys[i]);
            }
            return;
        }
        (void)snprintf(name, sizeof name, "%.*s", n < sizeof name ? (int)n : 0, rest);
        const key *k = key_find(table, name, &u);
        rest += n + 1;
        const typing after = {stream, text, (size_t)(rest - text), rest};
        if (!k || rest[-1] == '=') {
            if (k) {
                offer_values(&after, k);
            }
            return;
        }
        table = k->table;
        if (table && k->kind != KEY_TABLE) {
            const size_t entry = strcspn(rest, ".=");
            if (rest[entry] != '.') {
                offer(&after, "0", ".", k->kind == KEY_LIST ? "the first" : NULL);
                return;
            }
            rest += entry + 1;
        }
    }
}

// the keys that --set reaches
static void complete_set(const subcommand *sub, const char *text, FILE *stream)
{
    const char *argument = sub && sub->argument ? sub->argument : "CASE";
    if (strcmp(argument, "DATA...") == 0) {
        complete_setting(&material_settings_keys, text, stream);
    } else if (strcmp(argument, "CLOUD") == 0) {
        const key inside = {.name = "scan", .kind = KEY_TABLE, .table = &scan_keys};
        const key_table root = {.name = "scan_file", .nkey = 1, .keys = &inside};
        complete_setting(&root, text, stream);
    } else {
        key_table root;
        case_file initial;
        case_keys(&root, &initial);
        complete_setting(&root, text, stream);
    }
}

static void complete_argument(const subcommand *sub, const typing *t)
{
    static const char *const files[][2] = {{"CASE", ":files yaml yml"},
                                           {"RESULT", ":files hdf"},
                                           {"DATA...", ":files csv txt dat tsv"},
                                           {"CLOUD", ":files ply pcd xyz csv txt yaml yml"}};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        if (strcmp(sub->argument, files[i][0]) == 0) {
            (void)fprintf(t->stream, "%s\n", files[i][1]);
            return;
        }
    }
    if (strcmp(sub->argument, "[NAME]") == 0) {
        for (const example *e = examples; e->name; e++) {
            offer(t, e->name, "", NULL);
        }
    } else {
        // "[case]", "bash|zsh|fish": the words themselves
        char words[64];
        (void)snprintf(words, sizeof words, "%s", sub->argument + (sub->argument[0] == '['));
        words[strcspn(words, "]")] = '\0';
        offer_choices(t, words);
    }
}

static const option *option_of(const char *word)
{
    for (int i = 0; i < OPTION_COUNT; i++) {
        if (strcmp(options[i].name, word) == 0) {
            return &options[i];
        }
    }
    return NULL;
}

// What the finished words say: the subcommand, how many arguments, an option that waits for its
// value.
typedef struct line_so_far {
    const subcommand *sub;
    int nargument;
    const option *waiting;
} line_so_far;

static line_so_far read_line(int n, const char *const *words)
{
    line_so_far line = {0};
    for (int i = 0; i < n; i++) {
        const option *o = option_of(words[i]);
        if (line.waiting) {
            line.waiting = NULL;
        } else if (o) {
            line.waiting = o->value ? o : NULL;
        } else if (words[i][0] != '-' && line.sub) {
            line.nargument++;
        } else if (words[i][0] != '-') {
            const subcommand *sub = subcommands();
            while (sub->name && strcmp(sub->name, words[i]) != 0) {
                sub++;
            }
            line.sub = sub->name ? sub : NULL;
        }
    }
    return line;
}

void complete(int n, const char *const *words, FILE *stream)
{
    const char *word = n > 0 ? words[n - 1] : "";
    const line_so_far line = read_line(n > 0 ? n - 1 : 0, words);
    const typing t = {stream, "", 0, word};
    if (line.waiting == &options[OPTION_OUT]) {
        (void)fputs(":directories\n", stream);
    } else if (line.waiting == &options[OPTION_SET]) {
        complete_set(line.sub, word, stream);
    } else if (word[0] == '-' && !line.waiting) {
        for (int i = 0; i < OPTION_COUNT; i++) {
            if (!line.sub || option_known_to(&options[i], line.sub)) {
                offer(&t, options[i].name, "", options[i].about);
            }
        }
    } else if (!line.sub && !line.waiting) {
        for (const subcommand *sub = subcommands(); sub->name; sub++) {
            offer(&t, sub->name, "", sub->about);
        }
    } else if (!line.waiting && line.sub->argument &&
               (line.nargument == 0 || strstr(line.sub->argument, "..."))) {
        complete_argument(line.sub, &t);
    }
}
