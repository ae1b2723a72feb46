// section/stack.h
// K(s) of a stack of slices: constant through each run of equal slices.
#pragma once

#include "section/reuse.h"

// ERR_INPUT where the rod is longer than the stack, or where the section turns or scales beside it.
status stack_laws(section_store *store, double length, law_along *out);
