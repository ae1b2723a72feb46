// fem/blas.c
#include "fem/blas.h"

#include <stddef.h>
#include <stdlib.h>

status blas_room(void)
{
    static const size_t STORAGE = (size_t)160 << 20;
    void *room = malloc(STORAGE);
    free(room);
    return room ? OK : status_fail(ERR_RESOURCE, "segment: no memory for BLAS");
}

// OpenBLAS asks for its working storage for ever where there is none left: it takes it now, or this
// ends in words
status blas_take(void)
{
    status st = OK;
    const int one = 1;
    int info = 0;
    double a = 1;
    TRY(blas_room());
    dpotrf_("U", &one, &a, &one, &info);

done:
    return st;
}
