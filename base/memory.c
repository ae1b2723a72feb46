// base/memory.c
#include "base/memory.h"

status memory_take(void **out, size_t count, size_t size)
{
    *out = calloc(count ? count : 1, size);
    if (!*out) {
        return status_fail(ERR_RESOURCE, "out of memory: %zu items of %zu bytes", count, size);
    }
    return OK;
}
