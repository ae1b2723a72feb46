// app/document.h
// A text that is made whole before it is shown: on stdout, and as a file with --out.
#pragma once

#include "app/command.h"

#include <stddef.h>
#include <stdio.h>

typedef struct document {
    FILE *stream; // to write to, after document_begin
    char *text;
    size_t length;
} document;

status document_begin(document *d);

// The text is whole: no more is written to the stream.
status document_close(document *d);

// Shows the document on stdout, and keeps it as DIR/name with --out.
status document_end(document *d, command *cmd, const char *name);

// The same for a text that is no JSON: with --json as {"schema", "text"}, in DIR/name.json.
status document_end_text(document *d, command *cmd, const char *schema, const char *name);

// Accepts a zeroed one.
void document_free(document *d);
