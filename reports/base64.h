// reports/base64.h
#pragma once

#include "reports/markup.h"

// RFC 4648, with padding.
status base64_append(bytes *out, const void *data, size_t count);
