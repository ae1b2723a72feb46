// io/marker.c
#include "io/marker.h"

#include "base/memory.h"
#include "io/disk.h"

#include <dirent.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// in front of the names, with the number of this format
static const char heading[] = "stiffaxis output directory 1\n";

enum { MARKER_MAX_BYTES = 65536 };

static status marker_path(const char *directory, char path[DISK_MAX_PATH])
{
    return disk_join(path, DISK_MAX_PATH, "%s/" MARKER_NAME, directory);
}

// *text: all of the marker, "" where there is none of ours; the caller's to free
static status read_marker(const char *directory, char **text)
{
    status st = OK;
    char path[DISK_MAX_PATH];
    struct stat info;
    int fd = -1;
    TRY(TAKE(*text, MARKER_MAX_BYTES + 1));
    TRY(marker_path(directory, path));
    fd = open(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0 || fstat(fd, &info) != 0 || !S_ISREG(info.st_mode)) {
        goto done;
    }
    size_t length = 0;
    for (ssize_t n = 1; n > 0 && length<MARKER_MAX_BYTES; length += n> 0 ? (size_t)n : 0) {
        n = read(fd, *text + length, MARKER_MAX_BYTES - length);
    }
    if (strncmp(*text, heading, strlen(heading)) != 0) {
        (*text)[0] = '\0';
    }

done:
    if (fd >= 0) {
        (void)close(fd);
    }
    return st;
}

bool marker_is_there(const char *directory)
{
    char *text = NULL;
    const bool there = read_marker(directory, &text) == OK && text[0] != '\0';
    status_clear();
    free(text);
    return there;
}

// a line of the marker, behind the first
static bool lists(const char *text, const char *name)
{
    const size_t length = strlen(name);
    for (const char *line = strchr(text, '\n'); line; line = strchr(line + 1, '\n')) {
        if (strncmp(line + 1, name, length) == 0 && line[1 + length] == '\n') {
            return true;
        }
    }
    return false;
}

// what is done with each entry but "." and "..", in the order of their names
typedef status (*visit_function)(int directory, const char *name, void *context);

static status visit_all(const char *path, visit_function visit, void *context)
{
    status st = OK;
    struct dirent **entry = NULL;
    const int n = scandir(path, &entry, NULL, alphasort);
    const int fd = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (n < 0 || fd < 0) {
        st = disk_fail(path, "list");
    }
    for (int i = 0; i < n; i++) {
        const char *name = entry[i]->d_name;
        if (st == OK && strcmp(name, ".") != 0 && strcmp(name, "..") != 0) {
            st = visit(fd, name, context);
        }
        free(entry[i]);
    }
    free(entry);
    if (fd >= 0) {
        (void)close(fd);
    }
    return st;
}

static bool is_file(int directory, const char *name)
{
    struct stat info;
    return fstatat(directory, name, &info, AT_SYMLINK_NOFOLLOW) == 0 && S_ISREG(info.st_mode);
}

// --- writing -------------------------------------------------------------------------------------

typedef struct listing {
    char text[MARKER_MAX_BYTES];
    size_t length;
} listing;

static status add_name(int directory, const char *name, void *context)
{
    listing *l = context;
    if (!is_file(directory, name) || strcmp(name, MARKER_NAME) == 0) {
        return OK;
    }
    const size_t room = sizeof l->text - l->length;
    const int n = snprintf(l->text + l->length, room, "%s\n", name);
    if (n < 0 || (size_t)n >= room) {
        return status_fail(ERR_BUG, "%s: too many files for one directory", name);
    }
    l->length += (size_t)n;
    return OK;
}

status marker_write(const char *directory)
{
    status st = OK;
    char path[DISK_MAX_PATH], fresh[DISK_MAX_PATH];
    listing *l = NULL;
    TRY(TAKE(l, 1));
    l->length = (size_t)snprintf(l->text, sizeof l->text, "%s", heading);
    TRY(marker_path(directory, path));
    TRY(disk_join(fresh, sizeof fresh, "%s.tmp-%ld", path, (long)getpid()));
    TRY(visit_all(directory, add_name, l));
    TRY(disk_write(fresh, path, l->text, l->length));
    if (rename(fresh, path) != 0) {
        st = disk_fail(path, "write");
        (void)unlink(fresh);
    }

done:
    free(l);
    return st;
}

// --- checking ------------------------------------------------------------------------------------

typedef struct search {
    const char *marker;
    char foreign[256]; // the first
} search;

static status look_at(int directory, const char *name, void *context)
{
    search *s = context;
    const bool ours = is_file(directory, name) && s->marker[0] &&
                      (strcmp(name, MARKER_NAME) == 0 || lists(s->marker, name));
    if (!ours && !s->foreign[0]) {
        (void)snprintf(s->foreign, sizeof s->foreign, "%s", name);
    }
    return OK;
}

status marker_check(const char *directory)
{
    status st = OK;
    char *text = NULL;
    TRY(read_marker(directory, &text));
    search s = {.marker = text};
    TRY(visit_all(directory, look_at, &s));
    if (s.foreign[0]) {
        st = status_fail(ERR_INPUT, "%s: '%s' in it was not written by this program: not replaced",
                         directory, s.foreign);
    }

done:
    free(text);
    return st;
}
