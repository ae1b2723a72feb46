// app/answer.h
// How the program answers: one JSON document, or text; and one line on stderr where it failed.
#pragma once

#include "app/command.h"
#include "io/json.h"

// Opens the one JSON document of this run on stdout.
status answer_open(command *cmd, json **out);

// The last words: the error on one line of stderr, as a JSON document too where --json has not been
// answered, stdout flushed. Returns the exit code.
status answer_end(command *cmd, status st);

// `message` on one line with its control characters made harmless, "error: " in front where it has
// no place of its own.
void answer_error_line(const char *message, char *line, unsigned long size);
