// base/hash.c
#include "base/hash.h"

#include <string.h>

// Two FNV-1a of 64 bits with different beginnings, the second one stirred by a rotation: together
// 128 bits.
static const uint64_t prime = 1099511628211u;

hash hash_begin(void)
{
    return (hash){14695981039346656037u, 7809847782465536322u};
}

void hash_bytes(hash *h, const void *data, size_t count)
{
    const unsigned char *byte = data;
    for (size_t i = 0; i < count; i++) {
        h->a = (h->a ^ byte[i]) * prime;
        h->b = ((h->b << 23 | h->b >> 41) ^ byte[i]) * prime;
    }
}

void hash_text(hash *h, const char *text)
{
    hash_int(h, text ? (int)strlen(text) : -1);
    hash_bytes(h, text ? text : "", text ? strlen(text) : 0);
}

void hash_real(hash *h, double x)
{
    const double positive = x == 0 ? 0 : x;
    hash_bytes(h, &positive, sizeof positive);
}

void hash_reals(hash *h, int n, const double *x)
{
    hash_int(h, n);
    for (int i = 0; i < n; i++) {
        hash_real(h, x[i]);
    }
}

void hash_int(hash *h, int x)
{
    hash_bytes(h, &x, sizeof x);
}
