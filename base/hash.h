// base/hash.h
// A 128-bit fingerprint of content: equal content is found again; not against forgery.
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct hash {
    uint64_t a, b;
} hash;

hash hash_begin(void);
void hash_bytes(hash *h, const void *data, size_t count);
void hash_text(hash *h, const char *text); // NULL is "" with another fingerprint
void hash_real(hash *h, double x);         // -0 as 0
void hash_reals(hash *h, int n, const double *x);
void hash_int(hash *h, int x);

static inline bool hash_is(hash x, hash y)
{
    return x.a == y.a && x.b == y.b;
}
