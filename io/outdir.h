// io/outdir.h
// A directory of results is written whole or not at all: files go to DIR.tmp-PID, which is renamed
// to DIR at the end.
#pragma once

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct outdir outdir;

// An existing DIR is ERR_INPUT unless force; force replaces only an empty directory or one in which
// this program wrote everything (its marker file .stiffaxis lists the names). Parents are made.
status outdir_open(const char *path, bool force, outdir **out);
// Path of a file inside the temporary directory; false in truncation (a name of ours is short).
status outdir_path(const outdir *d, const char *name, char *buffer, size_t size);
status outdir_commit(outdir *d); // fsync, rename, frees
void outdir_abandon(outdir *d);  // removes what was written; NULL is fine
