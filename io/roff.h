// io/roff.h
// Plain text inside a manual page: what troff would read as a request or an escape is written so
// that it shows as it is.
#pragma once

#include <stdio.h>

// Words for the running text, as one or more input lines; ends without a newline.
void roff_text(FILE *stream, const char *text);
void roff_line(FILE *stream, const char *text); // one that stays one: terms, examples

// ".TH name section version"; date is left to the reader's formatter.
void roff_title(FILE *stream, const char *name, int section, const char *version);

void roff_heading(FILE *stream, const char *text); // .SH, in capitals as is the custom
void roff_item(FILE *stream, const char *term);    // .TP with a bold term: its text follows
