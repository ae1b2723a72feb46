// app/command.h
// The command line: which subcommand, its options, and how a subcommand answers.
#pragma once

#include "base/status.h"

#include <stdbool.h>
#include <stdio.h>

enum { COMMAND_MAX_OVERRIDES = 64, COMMAND_SUMMARY_LINES = 24, COMMAND_MAX_ARGUMENTS = 100 };

typedef struct command command;

// What a subcommand is, for dispatch and for its help.
typedef struct subcommand {
    const char *name;
    const char *argument; // "CASE", "RESULT", "[NAME]", "DATA..." for several; NULL: takes none
    status (*run)(command *cmd);
    const char *about;   // one line
    const char *details; // more lines, ends with a newline
    const char *example; // a whole command line
} subcommand;

struct command {
    const subcommand *sub; // NULL: only --help or --version was asked for
    const char *argument;  // the first; NULL where none was given
    int nargument;
    const char *arguments[COMMAND_MAX_ARGUMENTS];
    bool json, force, quiet, markdown, bare, help, version, allow_scripts;
    const char *out; // --out DIR; NULL: nothing is written
    int noverride;
    const char *overrides[COMMAND_MAX_OVERRIDES]; // KEY=VALUE, as given
    FILE *warnings;                               // warnings go there too; NULL: to stderr alone
    int summary_lines;
    bool first_rank; // false on the other processes of an mpirun: they compute, and stay silent
    bool answered;   // the JSON document was printed
    unsigned given;  // bit n: option n of the list in command.c was given
};

// The subcommands, ended by one without a name.
const subcommand *subcommands(void);

// ERR_INPUT with the nearest name where a subcommand or an option is not known.
status command_parse(int argc, const char *const *argv, command *out);

// Help of the program, or of cmd->sub.
void command_help(const command *cmd, FILE *stream);

// Runs the subcommand, --help or --version.
status command_run(command *cmd);

// One progress line on stderr, replaced by the next; only on a terminal. NULL removes it.
void command_progress(const command *cmd, const char *words);
// A line on stderr for a person, unless --quiet.
void command_hint(const command *cmd, const char *format, ...)
    __attribute__((format(printf, 2, 3)));
// Whether stdout may be coloured.
bool command_colour(void);

// Whether what reads stdout has gone (`| head`), which is no error.
bool command_reader_left(void);

// Flushes stdout; ERR_RESOURCE where it is full or closed. OK where its reader has gone.
status command_flush(void);

status cmd_run(command *cmd);
status cmd_section(command *cmd);
status cmd_rod(command *cmd);
status cmd_fem(command *cmd);
status cmd_compare(command *cmd);
status cmd_sensitivity(command *cmd);
status cmd_fit(command *cmd);
status cmd_reach(command *cmd);
status cmd_design(command *cmd);
status cmd_report(command *cmd);
status cmd_check(command *cmd);
status cmd_material(command *cmd);
status cmd_scan(command *cmd);
status cmd_schema(command *cmd);
status cmd_example(command *cmd);
status cmd_doctor(command *cmd);
status cmd_man(command *cmd);
status cmd_completion(command *cmd);
