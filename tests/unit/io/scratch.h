// tests/unit/io/scratch.h
// A directory of its own for a test's files, removed at the end.
#pragma once

#include "io/disk.h"
#include "tests/test.h"

#include <dirent.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct scratch {
    char path[256];
} scratch;

static inline scratch scratch_make(void)
{
    scratch s;
    const char *base = getenv("TMPDIR");
    (void)snprintf(s.path, sizeof s.path, "%s/stiffaxis-test-XXXXXX", base ? base : "/tmp");
    CHECK(mkdtemp(s.path) != NULL);
    return s;
}

static inline void scratch_remove(const scratch *s)
{
    CHECK_OK(disk_remove_tree(s->path));
}

typedef struct scratch_path {
    char text[512];
} scratch_path;

static inline scratch_path scratch_file(const scratch *s, const char *name)
{
    scratch_path p;
    (void)snprintf(p.text, sizeof p.text, "%s/%s", s->path, name);
    return p;
}

static inline int exists(const char *path)
{
    struct stat info;
    return lstat(path, &info) == 0;
}

// the whole file, a NUL added; the caller frees it. NULL where there is none
static inline char *read_whole(const char *path, size_t *size)
{
    FILE *f = fopen(path, "rb");
    if (!f) {
        return NULL;
    }
    (void)fseek(f, 0, SEEK_END);
    *size = (size_t)ftell(f);
    rewind(f);
    char *text = calloc(*size + 1, 1);
    if (text && fread(text, 1, *size, f) != *size) {
        free(text);
        text = NULL;
    }
    (void)fclose(f);
    return text;
}

static inline void write_whole(const char *path, const char *data, size_t size)
{
    FILE *f = fopen(path, "wb");
    CHECK(f && fwrite(data, 1, size, f) == size && fclose(f) == 0);
}

// how many entries of a directory begin with `start`
static inline int count_entries(const char *path, const char *start)
{
    int n = 0;
    DIR *directory = opendir(path);
    CHECK(directory != NULL);
    for (const struct dirent *e; directory && (e = readdir(directory)) != NULL;) {
        n += strncmp(e->d_name, start, strlen(start)) == 0;
    }
    if (directory) {
        (void)closedir(directory);
    }
    return n;
}
