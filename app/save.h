// app/save.h
// Results to a directory, whole or not at all.
#pragma once

#include "app/command.h"
#include "reports/result.h"

// Fails early where cmd->out cannot be written in the end; nothing without --out.
status save_check(const command *cmd);

// result.hdf, tables, figures and page to cmd->out; nothing without --out. A signal meanwhile
// leaves nothing behind.
status save_result(const command *cmd, run_result *r);

// Figures and page only, to `directory`.
status save_report(const command *cmd, const char *directory, const run_result *r);

// Whatever `write` puts into the directory that it is given; nothing without --out.
typedef status save_write(const char *directory, const void *data);
status save_files(const command *cmd, save_write *write, const void *data);

// One text as DIR/name; nothing without --out.
status save_text(const command *cmd, const char *name, const char *text, size_t length);
