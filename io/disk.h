// io/disk.h
// What outdir and store need to put results on disk for good: syncing, and a removal that follows
// no link.
#pragma once

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

enum { DISK_MAX_PATH = 4096, DISK_MAX_DEPTH = 16 };

// ERR_RESOURCE with the system's reason, as "PATH: cannot WHAT: REASON".
status disk_fail(const char *path, const char *what);

// buffer = format(...); ERR_INPUT where it does not fit.
status disk_join(char *buffer, size_t size, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

// The directory that holds `path`, "." where it names none.
status disk_parent(const char *path, char *buffer, size_t size);

// A new file of these bytes, fsynced; nothing is left of it where that fails. ERR_RESOURCE, which
// names the path `told`: what it is going to be renamed to.
status disk_write(const char *path, const char *told, const void *data, size_t size);

// fsync of a file or a directory. A file system that cannot sync a directory is no failure.
status disk_sync(const char *path);

// fsync of a directory's regular files, then of itself; links are not followed.
status disk_sync_tree(const char *path);

// Removes a file or a directory with what is in it: by openat and unlinkat, no link followed, no
// other file system entered, at most DISK_MAX_DEPTH levels.
status disk_remove_tree(const char *path);

// Makes a directory's missing parents.
status disk_make_parents(const char *path);
