// app/cmd_schema.c
// stiffaxis schema: the keys of a case, for editors as JSON Schema, for people as Markdown.
#include "app/case.h"
#include "app/document.h"
#include "io/json.h"

status cmd_schema(command *cmd)
{
    status st = OK;
    document d = {0};
    json *j = NULL;
    key_table root;
    case_file initial;
    const bool markdown = cmd->markdown && !cmd->json;
    case_keys(&root, &initial);
    TRY(document_begin(&d));
    if (markdown) {
        TRY(schema_markdown(&root, d.stream));
    } else {
        TRY(json_open(d.stream, &j));
        st = schema_write(&root, j);
        const status closed = json_close(j);
        TRY(st != OK ? st : closed);
    }
    TRY(document_end(&d, cmd, markdown ? "keys.md" : "stiffaxis.schema.json"));

done:
    document_free(&d);
    return st;
}
