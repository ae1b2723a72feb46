// measure/cloud_lzf.c
// LZF, as PCD packs its columns: runs of bytes as they are, and copies of what came at most 8 kB
// before. A ring of that length is all that has to be kept.
#include "measure/cloud_parts.h"

#include "base/memory.h"

#include <string.h>

enum {
    REACH = 8192,     // of a copy
    ROOM = 8 * REACH, // of the ring: a power of two, handed on whenever it is full
};

typedef struct lzf {
    cloud_stream *s;
    uint64_t left;        // packed bytes
    uint64_t made, whole; // unpacked so far, and in the end
    lzf_take *take;
    void *context;
    unsigned char *ring; // [ROOM]
} lzf;

static void put(lzf *z, unsigned char byte)
{
    z->ring[z->made % ROOM] = byte;
    z->made++;
    if (z->made % ROOM == 0) {
        z->take(z->context, z->ring, ROOM);
    }
}

static status next_bytes(lzf *z, size_t count, const unsigned char **bytes)
{
    if (count > z->left) {
        return stream_fail(z->s, "packed data ends early");
    }
    z->left -= count;
    return stream_bytes(z->s, count, bytes);
}

static status copy(lzf *z, unsigned char control)
{
    status st = OK;
    const unsigned char *bytes = NULL;
    size_t length = control >> 5;
    if (length == 7) {
        TRY(next_bytes(z, 1, &bytes));
        length += bytes[0];
    }
    TRY(next_bytes(z, 1, &bytes));
    length += 2;
    const uint64_t back = ((uint64_t)(control & 31) << 8) + bytes[0] + 1;
    if (back > z->made || length > z->whole - z->made) {
        TRY(stream_fail(z->s, "packed data points outside itself"));
    }
    for (size_t i = 0; i < length; i++) {
        put(z, z->ring[(z->made - back) % ROOM]);
    }

done:
    return st;
}

static status run(lzf *z, size_t length)
{
    status st = OK;
    const unsigned char *bytes = NULL;
    if (length > z->whole - z->made) {
        TRY(stream_fail(z->s, "packed data holds more than it says"));
    }
    TRY(next_bytes(z, length, &bytes));
    for (size_t i = 0; i < length; i++) {
        put(z, bytes[i]);
    }

done:
    return st;
}

status cloud_lzf(cloud_stream *s, uint64_t packed, uint64_t count, lzf_take *take, void *context)
{
    status st = OK;
    lzf z = {.s = s, .left = packed, .whole = count, .take = take, .context = context};
    TRY(TAKE(z.ring, ROOM));
    while (z.left > 0) {
        const unsigned char *bytes = NULL;
        TRY(next_bytes(&z, 1, &bytes));
        const unsigned char control = bytes[0];
        TRY(control < 32 ? run(&z, (size_t)control + 1) : copy(&z, control));
    }
    if (z.made != z.whole) {
        TRY(stream_fail(s, "packed data holds less than it says"));
    }
    take(context, z.ring, (size_t)(z.made % ROOM));

done:
    free(z.ring);
    return st;
}
