// tests/unit/reports/files.h
// Scratch directories, whole files, and whether markup is well formed.
#pragma once

#include <ctype.h>
#include <dirent.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static inline void scratch_make(char dir[64])
{
    (void)snprintf(dir, 64, "/tmp/stiffaxis-test-XXXXXX");
    if (!mkdtemp(dir)) {
        perror("mkdtemp");
        exit(1);
    }
}

static inline void scratch_free(const char *dir)
{
    char path[512];
    DIR *all = opendir(dir);
    for (struct dirent *e = all ? readdir(all) : NULL; e; e = readdir(all)) {
        if (e->d_name[0] != '.') {
            (void)snprintf(path, sizeof path, "%s/%s", dir, e->d_name);
            (void)unlink(path);
        }
    }
    if (all) {
        (void)closedir(all);
    }
    if (rmdir(dir) != 0) {
        perror(dir);
    }
}

// NULL where there is none; the caller's to free, with a 0 after *length bytes
static inline char *whole_file(const char *dir, const char *name, size_t *length)
{
    char path[256];
    (void)snprintf(path, sizeof path, "%s/%s", dir, name);
    FILE *f = fopen(path, "rb");
    if (!f) {
        return NULL;
    }
    size_t room = 1 << 16, got = 0;
    char *data = malloc(room + 1);
    for (size_t n = 1; data && n > 0; got += n) {
        if (got == room) {
            room *= 2;
            char *more = realloc(data, room + 1);
            if (!more) {
                free(data);
            }
            data = more;
        }
        n = data ? fread(data + got, 1, room - got, f) : 0;
    }
    (void)fclose(f);
    if (data) {
        data[got] = 0;
        *length = got;
    }
    return data;
}

static inline bool same_file(const char *dir_a, const char *dir_b, const char *name)
{
    size_t na = 0, nb = 0;
    char *a = whole_file(dir_a, name, &na), *b = whole_file(dir_b, name, &nb);
    const bool same = a && b && na == nb && memcmp(a, b, na) == 0;
    free(a);
    free(b);
    return same;
}

// Every tag closed in turn, every & an entity; void elements and declarations need no end. Raw text
// in <style> and <script> is skipped, and comments.
static inline bool well_formed(const char *text)
{
    static char stack[64][32];
    int depth = 0;
    for (const char *p = text; *p; p++) {
        if (*p == '&' && !strchr("agl#q", p[1])) {
            return false;
        }
        if (*p == '>') {
            return false;
        }
        if (*p != '<') {
            continue;
        }
        const char *end = strchr(p, '>');
        if (!end) {
            return false;
        }
        char name[32] = "";
        const bool closing = p[1] == '/';
        for (size_t n = 0; n + 1 < sizeof name && (isalnum((unsigned char)p[1 + closing + n]) ||
                                                   p[1 + closing + n] == ':');
             n++) {
            name[n] = p[1 + closing + n];
        }
        if (closing) {
            if (depth == 0 || strcmp(stack[--depth], name) != 0) {
                printf("</%s> does not fit\n", name);
                return false;
            }
        } else if (name[0] && end[-1] != '/' && strcmp(name, "meta") != 0) {
            if (depth == 64) {
                return false;
            }
            memcpy(stack[depth++], name, sizeof name);
        } else if (!name[0] && p[1] != '!' && p[1] != '?') {
            return false;
        }
        p = closing                       ? end
            : strcmp(name, "style") == 0  ? strstr(end, "</style>") - 1
            : strcmp(name, "script") == 0 ? strstr(end, "</script>") - 1
            : strncmp(p, "<!--", 4) == 0  ? strstr(p, "-->") + 2
                                          : end;
    }
    return depth == 0;
}

// Every id="..." once
// strstr, which a sanitizer makes look at the whole text each time
static inline const char *next_of(const char *text, const char *word)
{
    const size_t n = strlen(word);
    const char *p = strchr(text, word[0]);
    while (p && strncmp(p, word, n) != 0) {
        p = strchr(p + 1, word[0]);
    }
    return p;
}

static inline bool ids_are_unique(const char *text)
{
    for (const char *p = next_of(text, " id=\""); p; p = next_of(p + 1, " id=\"")) {
        char id[80];
        const size_t n = strcspn(p + 5, "\"") + 6;
        if (n >= sizeof id) {
            return false;
        }
        memcpy(id, p, n);
        id[n] = 0;
        if (next_of(p + 1, id)) {
            printf("twice:%s\n", id);
            return false;
        }
    }
    return true;
}

static inline int count_of(const char *text, const char *word)
{
    int count = 0;
    for (const char *p = next_of(text, word); p; p = next_of(p + 1, word)) {
        count++;
    }
    return count;
}
