// reports/base64.h
#pragma once

#include "reports/markup.h"

#include <stdint.h>

// RFC 4648, with padding.
status base64_append(bytes *out, const void *data, size_t count);
// Low byte first, whatever this machine does.
status base64_append_words(bytes *out, const uint16_t *word, size_t count);
