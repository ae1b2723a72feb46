// meshes/seal.h
// Limits on this process, for a child that works on a file which may be hostile.
#pragma once

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

// seconds: of processor time; memory: bytes beyond what it has now, 0 for any; sealed: no file is
// written, removed or renamed, no program or process started, no connection opened from here on.
status seal(int seconds, size_t memory, bool sealed);
