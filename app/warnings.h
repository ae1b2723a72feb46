// app/warnings.h
// What a case says that can be computed but hardly was meant: lines "FILE:LINE:COL: warning: ..."
// on stderr.
#pragma once

#include "app/case.h"
#include "app/command.h"

void warn_at(const command *cmd, const case_data *c, mark at, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

// A modulus over x or y that hardly changes over the section: its x and y are metres.
status warn_materials(const command *cmd, const case_data *c);

// Tendons outside of the section. ERR_INPUT where the section cannot be drawn.
status warn_tendons(const command *cmd, const case_data *c);

// A segment so short that its middle is not free of its ends.
status warn_segment(const command *cmd, const case_data *c);
