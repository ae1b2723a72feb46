// io/marker.h
// The file .stiffaxis in a directory of results: its first line says what it is, then comes one
// name per line of the files that this program wrote there. Nothing else may be replaced.
#pragma once

#include "base/status.h"

#include <stdbool.h>

#define MARKER_NAME ".stiffaxis"

// Whether the directory holds a marker of ours, whatever else is in it.
bool marker_is_there(const char *directory);

// Lists the files that are there now. ERR_RESOURCE
status marker_write(const char *directory);

// OK where the directory is empty, or holds a marker and nothing that the marker does not list;
// else ERR_INPUT, naming the first of what is foreign. Our own names are those of regular files.
status marker_check(const char *directory);
