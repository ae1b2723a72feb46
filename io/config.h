// io/config.h
// A case file: YAML by libyaml's events into a plain tree with line and column, typed by key tables
// (base/key.h).
//
// Every mistake is ERR_INPUT with one message "FILE:LINE:COL: error: ...". libyaml and muParser
// stay behind io's doors.
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

// path "-" reads stdin. overrides: "section.shapes.1.sector.width_rad=pi/16" each, from --set: maps
// that are missing are made, a key replaces the same one in another unit, an entry of a list goes
// by its number from 0 or by its `name`. Their place in messages is "--set 'TEXT'" (their marks
// have lines of 1 << 28 and more). A missing or unreadable file is ERR_INPUT too.
status config_open(const char *path, int noverride, const char *const *overrides, config **out);
// The same text and overrides, and more of these; nothing is read from disk.
status config_open_again(const config *opened, int noverride, const char *const *overrides,
                         config **out);
// A text that no file holds, under the name of `path` in messages.
status config_open_text(const char *path, const char *text, int noverride,
                        const char *const *overrides, config **out);
void config_free(config *cfg);

const char *config_path(const config *cfg);
// The case's bytes as read, for the result store (overrides not applied).
const char *config_text(const config *cfg, size_t *length);

// The file's text with its overrides and more of them put in the place of the values that stand
// there, or into the maps that lack their keys; *nleft of them, for which there is no such place,
// follow as comment lines. *text is the caller's.
status config_rewrite(const config *cfg, int nsetting, const char *const *settings, char **text,
                      size_t *length, int *nleft);

// The length of the rod, as L in expressions; call before config_read. Wherever a number stands,
// arithmetic may stand (io/expression.h). Under a key with a unit of length L and s have that unit:
// `end_mm: L/2`, `radius_mm: 3 + s/40`. Under any other key they are in metres; there only ratios
// are of use: `mid_angle_rad: pi*s/L`. s may stand only in a KEY_FIELD, whose `at` takes s in
// metres and gives SI; its range is checked at 17 arclengths from 0 to L. A field belongs to the
// config and to one thread at a time.
void config_set_length(config *cfg, double L_m);

// Reads one number ahead of the others (the rod's length), SI; *found false when it is not there.
// dotted_path: the map it stands in ("rod"), or that and the key without its unit ("rod.length").
status config_peek_real(const config *cfg, const char *dotted_path, const key *k, double *value,
                        bool *found);

// Fills `out` (a struct of root->size bytes, defaults taken from root->initial) from the whole
// file. Unknown keys are errors with the nearest known one. Texts, rows and lists belong to the
// config. KEY_ROWS also takes one row without the outer brackets. A table in place begins with its
// own defaults only where no table around it has defaults.
status config_read(config *cfg, const key_table *root, void *out);

// "FILE:LINE:COL: error: " + words, for contradictions found after reading. Always ERR_INPUT.
status config_fail(const config *cfg, mark at, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

// "FILE:LINE:COL: " of a place, "--set 'TEXT': " for one of the overrides: what stands in front of
// "error: " and "warning: ".
enum { CONFIG_PLACE_TEXT = 800 };
void config_place_text(const config *cfg, mark at, char text[CONFIG_PLACE_TEXT]);

// The table as JSON Schema (draft 2020-12), as Markdown, and as the sections of a manual page on a
// FILE.
struct json;
status schema_write(const key_table *root, struct json *out);
status schema_markdown(const key_table *root, void *stdio_stream);
status schema_man(const key_table *root, void *stdio_stream);

// The unit that a written key ends with ("mm" of "rod.length_mm"), "" where it has none, and its
// factor to SI.
const char *key_written_unit(const char *written, double *factor);

// All names under which a key may be written ("length_mm", ...) with the factor to SI; count of
// them.
int key_spellings(const key *k, int max, char (*names)[64], double *factor);
