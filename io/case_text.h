// io/case_text.h
// The bytes of a case: read with a limit, and looked through before libyaml sees them.
#pragma once

#include "io/case_tree.h"

// Fills cfg->text and length from cfg->path ("-" is stdin), reading no more than CONFIG_MAX_BYTES.
// ERR_INPUT where there is no such file, a directory, or more than that.
status case_text_load(config *cfg);

// ERR_INPUT that names what it is for a PNG image, an HDF5 file and a binary STL surface.
status case_text_kind(const config *cfg);

// ERR_INPUT for what no case holds: bytes that are not UTF-8, control characters, a tab in the
// indentation of a line, a YAML directive. override: which --set the text is the value of, -1 for
// the file.
status case_text_check(const config *cfg, const char *text, size_t length, int override);

// Bytes of a byte order mark at the start: 0 or 3.
size_t case_text_bom(const char *text, size_t length);

// The code point at a place of `text`, lines and columns from 1 as libyaml counts them; 0 outside.
unsigned case_text_at(const char *text, size_t length, int line, int column);
