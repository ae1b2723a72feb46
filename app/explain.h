// app/explain.h
// What the program has understood of a case, before anything is computed: lines for a person, the
// same as JSON.
#pragma once

#include "app/case.h"
#include "io/json.h"

typedef struct explanation {
    FILE *stream;      // of text
    json *j;           // or of an open array of {"about", "text"}
    const char *about; // of the line before
} explanation;

void explain(explanation *e, const char *about, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

// A list that grows in a text: words with ", " between, "..." where there is no more room.
enum { EXPLAIN_WORDS = 600 };
typedef struct word_list {
    char text[EXPLAIN_WORDS];
    size_t used;
} word_list;
void word_list_add(word_list *l, const char *format, ...) __attribute__((format(printf, 2, 3)));

// first: the mesh that was made at s = 0; without nodes where none was.
status explain_section(explanation *e, const case_data *c, const mesh *first);
void explain_rod(explanation *e, const case_data *c);
status explain_segment(explanation *e, const case_data *c);
// What `run` does with it, what it does not, files, defaults.
void explain_plan(explanation *e, const case_data *c);

// The files that the case names, as it names them: tell is called for each.
void case_files(const case_data *c, void (*tell)(void *self, const char *name), void *self);
