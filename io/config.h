// io/config.h
// A case file: YAML by libyaml's events into a plain tree with line and column, typed by key tables (base/key.h).
//
// Every mistake is ERR_INPUT with one message "FILE:LINE:COL: error: ...". libyaml and muParser stay behind io's doors.
#pragma once

#include "base/key.h"
#include "base/status.h"

#include <stddef.h>

typedef struct config config;

enum {
    CONFIG_MAX_BYTES = 8 << 20, // a case file larger than this is a mistake
    CONFIG_MAX_DEPTH = 32,
    CONFIG_MAX_NODES = 1000000,
    CONFIG_MAX_EXPRESSION = 1000, // characters
};

// path "-" reads stdin. overrides: "section.shapes.1.sector.width_rad=pi/16" each, from --set; their place in messages is
// "--set 'TEXT'". A missing or unreadable file is ERR_INPUT too.
status config_open(const char *path, int noverride, const char *const *overrides, config **out);
void config_free(config *cfg);

const char *config_path(const config *cfg);
// The case's bytes as read, for the result store (overrides not applied).
const char *config_text(const config *cfg, size_t *length);

// Binds a constant (pi is there already) for expressions; call before config_read.
void config_set_length(config *cfg, double L_m); // the name L, in the unit of the key that the expression stands in:
                                                 // `station_mm: L/2` reads L in mm, and so s in `mid_angle_rad: pi*s/L` is
                                                 // in m as L is (a ratio)

// Reads one number ahead of the others (the rod's length), SI; *found false when the path is not there.
status config_peek_real(const config *cfg, const char *dotted_path, const key *k, double *value, bool *found);

// Fills `out` (a struct of root->size bytes, defaults taken from root->initial) from the whole file. Unknown keys are errors with
// the nearest known one. Texts, rows and lists belong to the config.
status config_read(config *cfg, const key_table *root, void *out);

// "FILE:LINE:COL: error: " + words, for contradictions found after reading. Always ERR_INPUT.
status config_fail(const config *cfg, mark at, const char *format, ...) __attribute__((format(printf, 3, 4)));

// The table as JSON Schema (draft 2020-12) on `stream`, and as Markdown for docs/.
struct json;
status schema_write(const key_table *root, struct json *out);
status schema_markdown(const key_table *root, void *stdio_stream);

// All names under which a key may be written ("length_mm", ...) with the factor to SI; count of them.
int key_spellings(const key *k, int max, char (*names)[64], double *factor);
