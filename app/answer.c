// app/answer.c
#include "app/answer.h"

#include "reports/markup.h"

#include <errno.h>
#include <string.h>

status answer_open(command *cmd, json **out)
{
    cmd->answered = true;
    return json_open(stdout, out);
}

void answer_error_line(const char *message, char *line, unsigned long size)
{
    const char *words = message[0] ? message : "failed without a message: please report this";
    const bool placed = strstr(words, ": error: ") != NULL;
    (void)snprintf(line, size, "%s%s", placed ? "" : "error: ", words);
    // a case file's text may stand in the message: no escape sequence reaches the terminal
    (void)utf8_clean(line, line, size);
}

// a script that asked for JSON gets a document, whatever happened
static void answer_error_document(command *cmd, status st, const char *line)
{
    json *j = NULL;
    if (answer_open(cmd, &j) != OK) {
        return;
    }
    json_object(j, NULL);
    json_text(j, "schema", "stiffaxis/error/1");
    json_integer(j, "exit_code", (long)st);
    json_text(j, "message", line);
    json_object_end(j);
    (void)json_close(j);
}

status answer_end(command *cmd, status st)
{
    char line[1200];
    command_progress(cmd, NULL);
    // the JSON writer sees the closed pipe itself
    if (st == ERR_RESOURCE && command_reader_left()) {
        return OK;
    }
    if (st != OK && (cmd->first_rank || st == ERR_RESOURCE || st == ERR_BUG)) {
        answer_error_line(status_message(), line, sizeof line);
        fprintf(stderr, "%s\n", line);
        if (cmd->json && !cmd->answered && cmd->first_rank) {
            answer_error_document(cmd, st, line);
        }
    }
    if (st == OK || st == ERR_TOLERANCE) {
        status_clear();
        const status flushed = command_flush();
        if (flushed != OK) {
            fprintf(stderr, "error: %s\n", status_message());
            return flushed;
        }
    }
    return st;
}
