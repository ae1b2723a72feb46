// io/outdir.c
#include "io/outdir.h"

#include "base/memory.h"
#include "io/disk.h"
#include "io/marker.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

struct outdir {
    bool force;
    char target[DISK_MAX_PATH - 64]; // room for "/NAME" and ".tmp-PID"
    char work[DISK_MAX_PATH];
};

// whether something stands at the target; what must not be replaced is ERR_INPUT
static status check_target(const char *path, bool force, bool *exists)
{
    status st = OK;
    struct stat info;
    *exists = lstat(path, &info) == 0;
    if (!*exists) {
        return errno == ENOENT ? OK : disk_fail(path, "look at");
    }
    if (S_ISLNK(info.st_mode)) {
        return status_fail(ERR_INPUT, "%s: is a symbolic link: name the directory itself", path);
    }
    if (!S_ISDIR(info.st_mode)) {
        return status_fail(ERR_INPUT, "%s: exists and is not a directory", path);
    }
    if (!force) {
        return status_fail(ERR_INPUT, "%s: exists already: --force replaces it", path);
    }
    TRY(marker_check(path));

done:
    return st;
}

static status make_work_directory(const outdir *d)
{
    // left behind by a killed run whose process number comes again
    struct stat info;
    if (lstat(d->work, &info) == 0 && S_ISDIR(info.st_mode) && marker_is_there(d->work)) {
        const status st = disk_remove_tree(d->work);
        if (st != OK) {
            return st;
        }
    }
    // its own name is nobody's concern
    return mkdir(d->work, 0777) == 0 ? OK : disk_fail(d->target, "make the directory");
}

static status copy_target(const char *path, char *target, size_t size)
{
    status st = OK;
    TRY(disk_join(target, size, "%s", path));
    for (size_t n = strlen(target); n > 1 && target[n - 1] == '/'; n--) {
        target[n - 1] = '\0';
    }
    const char *slash = strrchr(target, '/');
    const char *last = slash ? slash + 1 : target;
    if (last[0] == '\0' || strcmp(last, ".") == 0 || strcmp(last, "..") == 0) {
        return status_fail(ERR_INPUT, "'%s': results need a directory with a name of its own",
                           path);
    }

done:
    return st;
}

status outdir_open(const char *path, bool force, outdir **out)
{
    status st = OK;
    outdir *d = NULL;
    bool exists = false;
    TRY(TAKE(d, 1));
    d->force = force;
    TRY(copy_target(path, d->target, sizeof d->target));
    TRY(disk_join(d->work, sizeof d->work, "%s.tmp-%ld", d->target, (long)getpid()));
    TRY(check_target(d->target, force, &exists));
    TRY(disk_make_parents(d->target));
    TRY(make_work_directory(d));
    st = marker_write(d->work); // so that a killed run leaves what is known as ours
    if (st != OK) {
        (void)disk_remove_tree(d->work);
        goto done;
    }
    *out = d;
    d = NULL;

done:
    free(d);
    return st;
}

status outdir_path(const outdir *d, const char *name, char *buffer, size_t size)
{
    if (name[0] == '\0' || name[0] == '.' || strchr(name, '/')) {
        return status_fail(ERR_BUG, "'%s' is not a plain file name", name);
    }
    return disk_join(buffer, size, "%s/%s", d->work, name);
}

// the old directory stands aside until the new one is in its place
static status swap_in(const outdir *d)
{
    status st = OK;
    char old[DISK_MAX_PATH];
    TRY(disk_join(old, sizeof old, "%s.old-%ld", d->target, (long)getpid()));
    if (rename(d->target, old) != 0) {
        return disk_fail(d->target, "move aside");
    }
    // whatever came at the last moment: nothing comes to the name that it has now
    st = marker_check(old);
    if (st == OK && rename(d->work, d->target) != 0) {
        st = disk_fail(d->target, "rename the results to");
    }
    if (st != OK) {
        (void)rename(old, d->target);
        return st;
    }
    TRY(disk_remove_tree(old));

done:
    return st;
}

status outdir_commit(outdir *d)
{
    status st = OK;
    bool exists = false;
    char parent[DISK_MAX_PATH];
    TRY(disk_parent(d->target, parent, sizeof parent));
    TRY(marker_write(d->work));
    TRY(disk_sync_tree(d->work));
    // the target may have changed since outdir_open
    TRY(check_target(d->target, d->force, &exists));
    if (exists) {
        TRY(swap_in(d));
    } else if (rename(d->work, d->target) != 0) {
        TRY(disk_fail(d->target, "rename the results to"));
    }
    TRY(disk_sync(parent));
    free(d);
    return OK;

done:
    outdir_abandon(d);
    return st;
}

void outdir_abandon(outdir *d)
{
    struct stat info;
    if (d && lstat(d->work, &info) == 0) {
        (void)disk_remove_tree(d->work);
    }
    free(d);
}
