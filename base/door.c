// base/door.c
#define _GNU_SOURCE // dladdr
#include "base/door.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { MAX_DOORS = 8 };

static struct {
    char name[32];
    void *handle;
} doors[MAX_DOORS];

// place: from the folder of `file`
static void *open_near(const char *file, const char *place, const char *name)
{
    char path[4096];
    const char *slash = strrchr(file, '/');
    const int n = snprintf(path, sizeof path, "%.*s%s/stiffaxis_%s.so",
                           slash ? (int)(slash - file) : 1, slash ? file : ".", place, name);
    const bool fits = n > 0 && (size_t)n < sizeof path;
    return fits && access(path, R_OK) == 0 ? dlopen(path, RTLD_NOW | RTLD_GLOBAL) : NULL;
}

// beside this library, which another program may have loaded, else beside the program
static void *open_module(const char *name)
{
    char program[3072];
    const char *places[] = {"", "/../lib/stiffaxis"};
    Dl_info own = {0};
    void *handle = dladdr(doors, &own) && own.dli_fname ? open_near(own.dli_fname, "", name) : NULL;
    const ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
    for (int i = 0; i < 2 && length > 0 && !handle; i++) {
        program[length] = '\0';
        handle = open_near(program, places[i], name);
    }
    return handle;
}

static void *find_door(const char *name)
{
    for (int i = 0; i < MAX_DOORS; i++) {
        if (doors[i].handle && strcmp(doors[i].name, name) == 0) {
            return doors[i].handle;
        }
    }
    return NULL;
}

int door_is_open(const char *name)
{
    return find_door(name) != NULL;
}

status door_open(const char *name, const char *symbol, door_function *out)
{
    void *handle = find_door(name);
    if (!handle) {
        handle = open_module(name);
        if (!handle) {
            const char *why = dlerror();
            return why ? status_fail(ERR_RESOURCE, "cannot open the %s module: %s%s", name, why,
                                     DOOR_HINT)
                       : status_fail(
                             ERR_RESOURCE,
                             "cannot open the %s module: stiffaxis_%s.so is neither beside the "
                             "library or the program nor in ../lib/stiffaxis: install "
                             "stiffaxis again",
                             name, name);
        }
        for (int i = 0; i < MAX_DOORS; i++) {
            if (!doors[i].handle) {
                (void)snprintf(doors[i].name, sizeof doors[i].name, "%s", name);
                doors[i].handle = handle;
                break;
            }
        }
    }
    void *found = dlsym(handle, symbol);
    if (!found) {
        return status_fail(ERR_BUG, "the %s module has no %s", name, symbol);
    }
    memcpy(out, &found, sizeof found);
    return OK;
}
