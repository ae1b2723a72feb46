// base/door.c
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

static void *open_beside_program(const char *name)
{
    char program[3072];
    const ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
    if (length <= 0) {
        return NULL;
    }
    program[length] = '\0';
    char *slash = strrchr(program, '/');
    *(slash ? slash : program) = '\0';

    void *handle = NULL;
    const char *places[] = {"", "/../lib/stiffaxis"};
    for (int i = 0; i < 2 && !handle; i++) {
        char path[4096];
        (void)snprintf(path, sizeof path, "%s%s/stiffaxis_%s.so", program, places[i], name);
        if (access(path, R_OK) == 0) {
            handle = dlopen(path, RTLD_NOW | RTLD_GLOBAL);
        }
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
        handle = open_beside_program(name);
        if (!handle) {
            const char *why = dlerror();
            return status_fail(ERR_RESOURCE, "cannot open the %s module: %s", name,
                               why ? why : "it is not beside the program nor in ../lib/stiffaxis");
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
