// app/cmd_example.c
// stiffaxis example [NAME]: a runnable case, or the list of them.
#include "app/document.h"
#include "app/examples.h"
#include "base/nearest.h"
#include "io/json.h"

#include <string.h>

// the example's title line, without its quotes
static void example_title(const example *e, char *title, size_t size)
{
    const char *line = strstr(e->text, "\ntitle: ");
    line = line ? line + strlen("\ntitle: ") : "";
    (void)snprintf(title, size, "%.*s", (int)strcspn(line, "\n"), line);
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
            json_object_end(j);
        } else {
            fprintf(stream, "%-24s %s\n", e->name, title);
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
    return status_fail(ERR_INPUT, "no example '%s'%s: stiffaxis example lists them", name,
                       nearest_words(&near, words));
}

static status write_example(const command *cmd, const example *e, FILE *stream)
{
    status st = OK;
    json *j = NULL;
    if (!cmd->json) {
        (void)fwrite(e->text, 1, e->length, stream);
        return OK;
    }
    TRY(json_open(stream, &j));
    json_object(j, NULL);
    json_text(j, "schema", "stiffaxis/example/1");
    json_text(j, "name", e->name);
    json_text(j, "case", e->text);
    json_object_end(j);
    st = json_close(j);

done:
    return st;
}

status cmd_example(command *cmd)
{
    status st = OK;
    document d = {0};
    const example *e = NULL;
    char file[128] = "examples.txt";
    if (cmd->argument) {
        TRY(find_example(cmd->argument, &e));
    }
    TRY(document_begin(&d));
    TRY(e ? write_example(cmd, e, d.stream) : list_examples(cmd, d.stream));
    if (e || cmd->json) {
        (void)snprintf(file, sizeof file, "%.100s.%s", e ? e->name : "examples",
                       cmd->json ? "json" : "yaml");
    }
    TRY(document_end(&d, cmd, file));
    if (!e) {
        command_hint(cmd, "cases with files stand in the repository: cases/scan (a scan to fitted "
                          "numbers), cases/measured, cases/tensile");
    }

done:
    document_free(&d);
    return st;
}
