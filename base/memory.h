// base/memory.h
// Zeroed memory with the overflow of count * size checked; a NULL pointer is freed as nothing.
#pragma once

#include "base/status.h"

#include <stddef.h>
#include <stdlib.h>

// ERR_RESOURCE when there is not enough; a count of 0 gives a valid pointer to nothing.
status memory_take(void **out, size_t count, size_t size);

// TAKE(p, n): p becomes n zeroed items, to be freed with free
#define TAKE(pointer, count) memory_take((void **)&(pointer), (count), sizeof *(pointer))
