// measure/line_file.h
// A measured centreline from a table: columns s, x, y, z and, where known, sigma and fit_sigma (the
// part of it that is not of the frame), each with its unit of length; columns of other names are
// passed over.
#pragma once

#include "base/key.h"
#include "measure/centreline.h"

// What stands above the rows of a line whose scan had no mark; read back as centreline.turn_free.
#define LINE_TURN_FREE "free in its turn about z"

// `length` of the rod [m]: an arclength that cannot be one of it has the wrong unit. ERR_FILE
// "FILE:LINE: words" for gaps, an arclength that does not ascend from the base, fewer than two
// places, places that are further apart than their arclengths, units that cannot be right.
// The file's own note "correlation_length_mm: 4.7" above the rows is read too, else NAN.
// *synthetic becomes true where the lines above the rows have this word.
status line_file_read(const char *directory, const key_text *name, double length, centreline *out,
                      bool *synthetic);
