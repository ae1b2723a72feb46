// app/options.h
// The options of the command line, once: for reading it, --help, the manual page and completion.
#pragma once

#include "app/command.h"

typedef enum option_id {
    OPTION_JSON,
    OPTION_OUT,
    OPTION_FORCE,
    OPTION_SET,
    OPTION_QUIET,
    OPTION_LINES,
    OPTION_MARKDOWN,
    OPTION_BARE,
    OPTION_ALLOW_SCRIPTS,
    OPTION_HELP,
    OPTION_VERSION,
    OPTION_COUNT
} option_id;

typedef struct option {
    const char *name, *value; // value: what it is followed by, NULL for nothing
    const char *about;
    const char *only; // the commands that know it, "run, report"; NULL: all
} option;

extern const option options[OPTION_COUNT];

// Whether a subcommand takes the option; --set is for those that read a case or data.
bool option_known_to(const option *o, const subcommand *sub);

// "--out DIR"
enum { OPTION_WORDS = 32 };
void option_words(const option *o, char words[OPTION_WORDS]);

// The exit codes and what they mean, ended by one without a meaning.
typedef struct exit_code {
    int code;
    const char *about;
} exit_code;
extern const exit_code exit_codes[];
