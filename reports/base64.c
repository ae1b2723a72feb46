// reports/base64.c
#include "reports/base64.h"

#include "base/memory.h"

status base64_append(bytes *out, const void *data, size_t count)
{
    static const char letters[] =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    status st = OK;
    const unsigned char *p = data;
    for (size_t i = 0; i < count; i += 3) {
        const unsigned a = p[i], b = i + 1 < count ? p[i + 1] : 0, c = i + 2 < count ? p[i + 2] : 0;
        const char four[4] = {letters[a >> 2], letters[(a & 3) << 4 | b >> 4],
                              i + 1 < count ? letters[(b & 15) << 2 | c >> 6] : '=',
                              i + 2 < count ? letters[c & 63] : '='};
        TRY(bytes_append(out, four, 4));
    }

done:
    return st;
}

status base64_append_words(bytes *out, const uint16_t *word, size_t count)
{
    status st = OK;
    unsigned char *pair = NULL;
    TRY(TAKE(pair, 2 * count));
    for (size_t i = 0; i < count; i++) {
        pair[2 * i] = (unsigned char)(word[i] & 255);
        pair[2 * i + 1] = (unsigned char)(word[i] >> 8);
    }
    TRY(base64_append(out, pair, 2 * count));

done:
    free(pair);
    return st;
}
