// io/csv.h
// CSV tables (RFC 4180): one header line with a unit in every name, then rows of numbers and texts.
#pragma once

#include "base/status.h"

#include <stdio.h>

typedef struct csv csv;

status csv_open(const char *path, int ncolumn, const char *const *names, csv **out);
// A line "# words" before the first row, which readers of tables pass over.
void csv_remark(csv *c, const char *words);
void csv_real(csv *c, double value);
void csv_text(
    csv *c,
    const char *value);   // quoted where needed; a leading = + - @ is defused for spreadsheets
status csv_close(csv *c); // ERR_RESOURCE when a write failed; a row left unfinished is ERR_BUG
