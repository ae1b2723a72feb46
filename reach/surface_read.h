// reach/surface_read.h
// Surfaces from files: STL (text and binary), OBJ, PLY (text and binary), told by their content.
#pragma once

#include "reach/surface.h"

// Reads, merges and checks (surface_make); `unit` is that of the file's numbers [m], 1e-3 for mm;
// options->path is the file. ERR_FILE "FILE:LINE: words", or "FILE: at byte N: words", for what is
// damaged, has more than SURFACE_MOST_TRIANGLES or is no closed surface.
status surface_read(const surface_options *options, double unit, surface *out,
                    surface_report *report);
