// app/cmd_example.c
// stiffaxis example [NAME]: a runnable case, or the list of them.
#include "app/case.h"
#include "app/document.h"
#include "app/examples.h"
#include "app/save.h"
#include "base/nearest.h"
#include "io/annotate.h"
#include "io/json.h"
#include "measure/scan.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

// the example's title line, without its quotes
static void example_title(const example *e, char *title, size_t size)
{
    const char *line = strstr(e->text, "\ntitle: ");
    line = line ? line + strlen("\ntitle: ") : "";
    const bool quoted = *line == '"';
    (void)snprintf(title, size, "%.*s", (int)strcspn(line + quoted, quoted ? "\"\n" : "\n"),
                   line + quoted);
}

static int count_files(const example *e)
{
    int n = 0;
    while (e->files && e->files[n].name) {
        n++;
    }
    return n;
}

static void write_row(const example *e, const char *title, FILE *stream)
{
    const int n = count_files(e);
    fprintf(stream, "%-24s %s", e->name, title);
    if (n > 0) {
        fprintf(stream, " (reads %d file%s: --out DIR)", n, n == 1 ? "" : "s");
    }
    (void)fputc('\n', stream);
}

static status list_examples(const command *cmd, FILE *stream)
{
    status st = OK;
    json *j = NULL;
    char title[160];
    if (cmd->json) {
        TRY(json_open(stream, &j));
        json_object(j, NULL);
        json_text(j, "schema", "stiffaxis/examples/1");
        json_array(j, "examples");
    }
    for (const example *e = examples; e->name; e++) {
        example_title(e, title, sizeof title);
        if (cmd->json) {
            json_object(j, NULL);
            json_text(j, "name", e->name);
            json_text(j, "title", title);
            json_integer(j, "files", count_files(e));
            json_object_end(j);
        } else {
            write_row(e, title, stream);
        }
    }
    if (cmd->json) {
        json_array_end(j);
        json_object_end(j);
        st = json_close(j);
    }

done:
    return st;
}

static status find_example(const char *name, const example **out)
{
    char words[NEAREST_WORDS];
    nearest near = nearest_to(name);
    for (const example *e = examples; e->name; e++) {
        if (strcmp(e->name, name) == 0) {
            *out = e;
            return OK;
        }
        nearest_offer(&near, e->name, e->name);
    }
    // the beginning of a name was hardly misspelled
    for (const example *e = examples; e->name && name[0] && !near.best[0]; e++) {
        if (strncmp(e->name, name, strlen(name)) == 0) {
            (void)snprintf(near.best, sizeof near.best, "%s", e->name);
        }
    }
    return status_fail(ERR_INPUT, "no example '%s'%s: stiffaxis example lists them", name,
                       nearest_words(&near, words));
}

// keys of a case, and of a scan's settings
enum { ROOT_KEYS = 24 };
typedef struct example_keys {
    key_table root;
    case_file initial;
    key keys[ROOT_KEYS];
} example_keys;

static void gather_keys(example_keys *out)
{
    case_keys(&out->root, &out->initial);
    const int n = out->root.nkey < ROOT_KEYS ? out->root.nkey : ROOT_KEYS - 1;
    memcpy(out->keys, out->root.keys, (size_t)n * sizeof *out->keys);
    out->keys[n] = (key){.name = "scan",
                         .kind = KEY_TABLE,
                         .table = &scan_keys,
                         .about = "a cloud of points and what is known of it"};
    out->root.keys = out->keys;
    out->root.nkey = n + 1;
}

// the last lines of the comment that the case begins with: where to read on, and what it reads
static void write_hints(const example *e, FILE *stream)
{
    const int n = count_files(e);
    fputs("#\n", stream);
    if (!strstr(e->text, "\nscan:")) {
        fprintf(stream,
                "# How this is understood: stiffaxis check %s.yaml. Every key there is: "
                "stiffaxis man case | man -l -\n",
                e->name);
    }
    if (n == 1) {
        fprintf(stream, "# It needs %s beside it:\n", e->files[0].name);
    } else if (n > 1) {
        fprintf(stream, "# It reads %d files beside it, %s %s %s:\n", n, e->files[0].name,
                n == 2 ? "and" : "to", e->files[n - 1].name);
    }
    if (n > 0) {
        fprintf(stream, "#   stiffaxis example %s --out DIR   # writes all of it\n", e->name);
    }
}

// with a comment for every key
static status write_commented(const example *e, FILE *stream)
{
    status st = OK;
    char *text = NULL;
    example_keys keys;
    gather_keys(&keys);
    TRY(config_annotate(e->name, e->text, &keys.root, &text));
    const char *body = text;
    while (*body == '#') {
        const size_t n = strcspn(body, "\n");
        body += n + (body[n] == '\n');
    }
    (void)fwrite(text, 1, (size_t)(body - text), stream);
    write_hints(e, stream);
    (void)fputs(body, stream);

done:
    free(text);
    return st;
}

static status write_json(const example *e, const char *text, FILE *stream)
{
    status st = OK;
    json *j = NULL;
    TRY(json_open(stream, &j));
    json_object(j, NULL);
    json_text(j, "schema", "stiffaxis/example/1");
    json_text(j, "name", e->name);
    json_text(j, "case", text);
    json_array(j, "files");
    for (int i = 0; i < count_files(e); i++) {
        json_text(j, NULL, e->files[i].name);
    }
    json_array_end(j);
    json_object_end(j);
    st = json_close(j);

done:
    return st;
}

// What `example NAME` gives: the case, and the document that is shown.
typedef struct example_words {
    const example *example;
    document text, shown;
} example_words;

static status make_words(const command *cmd, example_words *w)
{
    status st = OK;
    const example *e = w->example;
    TRY(document_begin(&w->text));
    if (cmd->bare) {
        (void)fwrite(e->text, 1, e->length, w->text.stream);
    } else {
        TRY(write_commented(e, w->text.stream));
    }
    TRY(document_close(&w->text));
    if (cmd->json) {
        TRY(document_begin(&w->shown));
        TRY(write_json(e, w->text.text, w->shown.stream));
        TRY(document_close(&w->shown));
    }

done:
    return st;
}

static status write_file(const char *directory, const char *name, const char *bytes, size_t length)
{
    char path[4096];
    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    FILE *file = fopen(path, "wbx");
    const bool good = file && fwrite(bytes, 1, length, file) == length;
    if (!file || fclose(file) != 0 || !good) {
        return status_fail(ERR_RESOURCE, "cannot write %s: %s", path, strerror(errno));
    }
    return OK;
}

// the case, what it reads, and the JSON document
static status write_directory(const char *directory, const void *data)
{
    status st = OK;
    char name[128];
    const example_words *w = data;
    (void)snprintf(name, sizeof name, "%.100s.yaml", w->example->name);
    TRY(write_file(directory, name, w->text.text, w->text.length));
    if (w->shown.text) {
        (void)snprintf(name, sizeof name, "%.100s.json", w->example->name);
        TRY(write_file(directory, name, w->shown.text, w->shown.length));
    }
    for (int i = 0; i < count_files(w->example); i++) {
        const example_file *f = &w->example->files[i];
        TRY(write_file(directory, f->name, f->bytes, f->length));
    }

done:
    return st;
}

static status one_example(command *cmd)
{
    status st = OK;
    example_words w = {0};
    TRY(find_example(cmd->argument, &w.example));
    TRY(make_words(cmd, &w));
    TRY(save_files(cmd, write_directory, &w));
    const document *d = cmd->json ? &w.shown : &w.text;
    cmd->answered = true;
    (void)fwrite(d->text, 1, d->length, stdout);
    if (!cmd->out && w.example->files) {
        command_hint(cmd,
                     "it reads files beside it: stiffaxis example %s --out DIR writes all of it",
                     w.example->name);
    }
    if (cmd->out) {
        char more[40] = "";
        const int n = count_files(w.example);
        if (n > 0) {
            (void)snprintf(more, sizeof more, " and %d file%s", n, n == 1 ? "" : "s");
        }
        command_hint(cmd, "written: %s/%s.yaml%s", cmd->out, w.example->name, more);
    }

done:
    document_free(&w.text);
    document_free(&w.shown);
    return st;
}

status cmd_example(command *cmd)
{
    status st = OK;
    document d = {0};
    if (cmd->argument) {
        return one_example(cmd);
    }
    TRY(document_begin(&d));
    TRY(list_examples(cmd, d.stream));
    TRY(document_end(&d, cmd, cmd->json ? "examples.json" : "examples.txt"));

done:
    document_free(&d);
    return st;
}
