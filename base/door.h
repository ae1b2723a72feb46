// base/door.h
// Heavy foreign libraries (gmsh, PETSc, HDF5) stand behind doors: shared modules that are opened
// when a command first needs them. A program that does not need one never pays for loading it.
#pragma once

#include "base/status.h"

typedef void (*door_function)(void);

// Opens stiffaxis_<name>.so beside this library, beside the program or in ../lib/stiffaxis from
// there, once, and looks `symbol` up in it. ERR_RESOURCE with the loader's reason, where that is a
// missing library followed by:
#define DOOR_HINT "; stiffaxis doctor tells which package brings it"
status door_open(const char *name, const char *symbol, door_function *out);

// Whether the door was opened in this process: tests ask.
int door_is_open(const char *name);
