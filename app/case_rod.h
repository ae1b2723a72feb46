// app/case_rod.h
// What a rod takes from outside its own keys: the files of its tendons' paths, and the densities
// that gravity pulls at.
#pragma once

#include "app/case.h"

// Reads, binds and checks the case's rod; the case's section is bound already. Mistakes come with
// their place: ERR_INPUT, or ERR_FILE for a path's file.
status case_rod_bind(case_data *c, const char *directory);

// Rows (s, x, y) [m] of a table in a text: blanks, commas or semicolons between the columns; `#`
// begins a comment. The first line names the columns with their units (s_mm, x_mm, y_mm), in any
// order; columns of other names are passed over. *rows is the caller's to free.
status tendon_path_read(const char *directory, const key_text *name, int *nrow, double **rows);
