// io/disk.c
#include "io/disk.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { OPEN_DIRECTORY = O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC };

status disk_fail(const char *path, const char *what)
{
    return status_fail(ERR_RESOURCE, "%s: cannot %s: %s", path, what, strerror(errno));
}

status disk_join(char *buffer, size_t size, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    const int length = vsnprintf(buffer, size, format, args);
    va_end(args);
    if (length < 0 || (size_t)length >= size) {
        return status_fail(ERR_INPUT, "%.60s...: the path is too long", buffer);
    }
    return OK;
}

status disk_parent(const char *path, char *buffer, size_t size)
{
    const char *slash = strrchr(path, '/');
    if (!slash) {
        return disk_join(buffer, size, ".");
    }
    // "/name" lies in "/"
    const int length = slash == path ? 1 : (int)(slash - path);
    return disk_join(buffer, size, "%.*s", length, path);
}

static status sync_and_close(int fd, const char *path)
{
    status st = OK;
    if (fsync(fd) != 0 && errno != EINVAL && errno != ENOTSUP) {
        st = disk_fail(path, "sync");
    }
    (void)close(fd);
    return st;
}

status disk_sync(const char *path)
{
    const int fd = open(path, O_RDONLY | O_CLOEXEC);
    if (fd < 0) {
        return disk_fail(path, "open");
    }
    return sync_and_close(fd, path);
}

static status write_all(int fd, const char *path, const char *data, size_t size)
{
    while (size > 0) {
        const ssize_t n = write(fd, data, size);
        if (n < 0 && errno != EINTR) {
            return disk_fail(path, "write");
        }
        data += n > 0 ? n : 0;
        size -= n > 0 ? (size_t)n : 0;
    }
    return OK;
}

status disk_write(const char *path, const char *told, const void *data, size_t size)
{
    const int fd = open(path, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (fd < 0) {
        return disk_fail(told, "write");
    }
    status st = write_all(fd, told, data, size);
    if (st == OK && fsync(fd) != 0 && errno != EINVAL && errno != ENOTSUP) {
        st = disk_fail(told, "write");
    }
    // some file systems tell at the end only that there was no room
    if (close(fd) != 0 && st == OK) {
        st = disk_fail(told, "write");
    }
    if (st != OK) {
        (void)unlink(path);
    }
    return st;
}

// what is done with each entry of a directory before the directory itself
typedef status (*visit_function)(int parent, const char *name, int depth, dev_t device);

static bool is_dots(const char *name)
{
    return strcmp(name, ".") == 0 || strcmp(name, "..") == 0;
}

// takes fd over
static status visit_entries(int fd, const char *name, int depth, dev_t device, visit_function visit)
{
    status st = OK;
    DIR *directory = fdopendir(fd);
    if (!directory) {
        (void)close(fd);
        return disk_fail(name, "list");
    }
    const struct dirent *entry = NULL;
    while (st == OK && (errno = 0, entry = readdir(directory)) != NULL) {
        if (!is_dots(entry->d_name)) {
            st = visit(dirfd(directory), entry->d_name, depth + 1, device);
        }
    }
    if (st == OK && errno != 0) {
        st = disk_fail(name, "list");
    }
    (void)closedir(directory);
    return st;
}

static status remove_entry(int parent, const char *name, int depth, dev_t device)
{
    status st = OK;
    struct stat info;
    if (fstatat(parent, name, &info, AT_SYMLINK_NOFOLLOW) != 0) {
        return disk_fail(name, "remove");
    }
    if (!S_ISDIR(info.st_mode)) {
        return unlinkat(parent, name, 0) == 0 ? OK : disk_fail(name, "remove");
    }
    if (depth > DISK_MAX_DEPTH || info.st_dev != device) {
        return status_fail(ERR_RESOURCE, "%s: not removed: %s", name,
                           depth > DISK_MAX_DEPTH ? "nested too deeply" : "another file system");
    }
    const int fd = openat(parent, name, OPEN_DIRECTORY);
    if (fd < 0) {
        return disk_fail(name, "remove");
    }
    TRY(visit_entries(fd, name, depth, device, remove_entry));
    if (unlinkat(parent, name, AT_REMOVEDIR) != 0) {
        return disk_fail(name, "remove");
    }

done:
    return st;
}

status disk_remove_tree(const char *path)
{
    struct stat info;
    if (lstat(path, &info) != 0) {
        return disk_fail(path, "remove");
    }
    return remove_entry(AT_FDCWD, path, 0, info.st_dev);
}

static status sync_entry(int parent, const char *name, int depth, dev_t device)
{
    status st = OK;
    struct stat info;
    if (fstatat(parent, name, &info, AT_SYMLINK_NOFOLLOW) != 0) {
        return disk_fail(name, "sync");
    }
    if (S_ISDIR(info.st_mode) && depth <= DISK_MAX_DEPTH) {
        const int inner = openat(parent, name, OPEN_DIRECTORY);
        if (inner < 0) {
            return disk_fail(name, "sync");
        }
        TRY(visit_entries(inner, name, depth, device, sync_entry));
    } else if (!S_ISREG(info.st_mode)) {
        return OK;
    }
    const int fd = openat(parent, name, O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
    if (fd < 0) {
        return disk_fail(name, "sync");
    }
    TRY(sync_and_close(fd, name));

done:
    return st;
}

status disk_sync_tree(const char *path)
{
    return sync_entry(AT_FDCWD, path, 0, 0);
}

status disk_make_parents(const char *path)
{
    status st = OK;
    char parent[DISK_MAX_PATH];
    TRY(disk_parent(path, parent, sizeof parent));
    for (char *slash = parent; slash;) {
        slash = strchr(slash + 1, '/');
        if (slash) {
            *slash = '\0';
        }
        if (mkdir(parent, 0777) != 0 && errno != EEXIST) {
            return disk_fail(parent, "make the directory");
        }
        if (slash) {
            *slash = '/';
        }
    }

done:
    return st;
}
