// app/document.c
#include "app/document.h"

#include "app/save.h"

#include <stdlib.h>

status document_begin(document *d)
{
    d->stream = open_memstream(&d->text, &d->length);
    return d->stream ? OK : status_fail(ERR_RESOURCE, "out of memory: a document");
}

status document_end(document *d, command *cmd, const char *name)
{
    status st = OK;
    FILE *stream = d->stream;
    d->stream = NULL;
    if (fclose(stream) != 0) {
        return status_fail(ERR_RESOURCE, "out of memory: a document");
    }
    TRY(save_text(cmd, name, d->text, d->length));
    cmd->answered = true;
    (void)fwrite(d->text, 1, d->length, stdout);

done:
    return st;
}

void document_free(document *d)
{
    if (d->stream) {
        (void)fclose(d->stream);
    }
    free(d->text);
}
