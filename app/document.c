// app/document.c
#include "app/document.h"

#include "app/save.h"
#include "io/json.h"

#include <stdlib.h>

status document_begin(document *d)
{
    d->stream = open_memstream(&d->text, &d->length);
    return d->stream ? OK : status_fail(ERR_RESOURCE, "out of memory: a document");
}

status document_close(document *d)
{
    FILE *stream = d->stream;
    d->stream = NULL;
    return fclose(stream) == 0 ? OK : status_fail(ERR_RESOURCE, "out of memory: a document");
}

status document_end(document *d, command *cmd, const char *name)
{
    status st = OK;
    TRY(document_close(d));
    TRY(save_text(cmd, name, d->text, d->length));
    cmd->answered = true;
    (void)fwrite(d->text, 1, d->length, stdout);

done:
    return st;
}

status document_end_text(document *d, command *cmd, const char *schema, const char *name)
{
    status st = OK;
    document wrapped = {0};
    json *j = NULL;
    char file[64];
    if (!cmd->json) {
        return document_end(d, cmd, name);
    }
    (void)snprintf(file, sizeof file, "%s.json", name);
    TRY(document_close(d));
    TRY(document_begin(&wrapped));
    TRY(json_open(wrapped.stream, &j));
    json_object(j, NULL);
    json_text(j, "schema", schema);
    json_text(j, "text", d->text);
    json_object_end(j);
    TRY(json_close(j));
    TRY(document_end(&wrapped, cmd, file));

done:
    document_free(&wrapped);
    return st;
}

void document_free(document *d)
{
    if (d->stream) {
        (void)fclose(d->stream);
    }
    free(d->text);
}
