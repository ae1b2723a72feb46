// io/store_reader.c
#include "io/store_reader.h"

#include "base/door.h"
#include "base/memory.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { ASK_HAS, ASK_GET };

typedef struct request {
    int ask;
    char name[READER_MAX_NAME];
} request;

// followed by the array's bytes where code is OK
typedef struct reply {
    int code; // status
    hdf5_array array;
    char message[READER_MAX_MESSAGE];
} reply;

status store_sniff(const char *path)
{
    static const unsigned char wanted[8] = {0x89, 'H', 'D', 'F', '\r', '\n', 0x1a, '\n'};
    unsigned char found[8] = {0};
    struct stat info;
    // a pipe must not hold us up
    const int fd = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0) {
        return status_fail(ERR_INPUT, "%s: cannot open: %s", path, strerror(errno));
    }
    const bool regular = fstat(fd, &info) == 0 && S_ISREG(info.st_mode);
    const bool same = regular && read(fd, found, sizeof found) == (ssize_t)sizeof found &&
                      memcmp(found, wanted, sizeof wanted) == 0;
    (void)close(fd);
    if (!same) {
        return status_fail(ERR_FILE, "%s: %s", path,
                           regular ? "not a stiffaxis result: it is not an HDF5 file"
                                   : "not a stiffaxis result: it is not a regular file");
    }
    return OK;
}

// --- both ends -----------------------------------------------------------------------------------

static bool send_all(int channel, const void *data, size_t size)
{
    const char *p = data;
    while (size > 0) {
        const ssize_t n = send(channel, p, size, MSG_NOSIGNAL);
        if (n <= 0 && errno != EINTR) {
            return false;
        }
        if (n > 0) {
            p += n;
            size -= (size_t)n;
        }
    }
    return true;
}

static bool receive_all(int channel, void *data, size_t size)
{
    char *p = data;
    while (size > 0) {
        const ssize_t n = recv(channel, p, size, 0);
        if (n == 0 || (n < 0 && errno != EINTR)) {
            return false;
        }
        if (n > 0) {
            p += n;
            size -= (size_t)n;
        }
    }
    return true;
}

// --- the child -----------------------------------------------------------------------------------

static void limit_child(void)
{
    const struct rlimit processor = {READER_SECONDS, READER_SECONDS}, none = {0, 0};
    (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
    (void)setrlimit(RLIMIT_CPU, &processor);
    (void)setrlimit(RLIMIT_CORE, &none);
    (void)setrlimit(RLIMIT_FSIZE, &none);
#ifndef __SANITIZE_ADDRESS__
    // room for one array and HDF5's own work; the address sanitizer's shadow is far larger
    const struct rlimit memory = {6 * HDF5_MAX_BYTES, 6 * HDF5_MAX_BYTES};
    (void)setrlimit(RLIMIT_AS, &memory);
#endif
    // a dying library's last words are no message of ours
    const int nothing = open("/dev/null", O_RDWR);
    for (int fd = 0; nothing >= 0 && fd <= 2; fd++) {
        (void)dup2(nothing, fd);
    }
    (void)signal(SIGINT, SIG_DFL);
    (void)signal(SIGTERM, SIG_DFL);
    (void)signal(SIGSEGV, SIG_DFL);
    (void)signal(SIGABRT, SIG_DFL);
}

static status open_checked(const char *path, const char *schema, const hdf5_door **door,
                           hdf5_file **file)
{
    status st = OK;
    door_function found = NULL;
    char text[64];
    TRY(door_open("hdf5", HDF5_DOOR_SYMBOL, &found));
    *door = ((hdf5_door_table_function)found)();
    TRY((*door)->open(path, file));
    if ((*door)->get_text(*file, "schema", sizeof text, text) != OK ||
        strncmp(text, "stiffaxis/", strlen("stiffaxis/")) != 0) {
        status_clear();
        return status_fail(ERR_FILE, "not a stiffaxis result");
    }
    if (strcmp(text, schema) != 0) {
        return status_fail(ERR_FILE,
                           "not a result that this version reads: its schema is '%s', not '%s'",
                           text, schema);
    }

done:
    return st;
}

static status fetch(const hdf5_door *door, const hdf5_file *file, const request *ask,
                    hdf5_array *array, void **data, size_t *bytes)
{
    status st = OK;
    *bytes = 0;
    if (ask->ask == ASK_HAS) {
        return door->has(file, ask->name) ? OK : ERR_FILE;
    }
    TRY(door->look(file, ask->name, array));
    (void)hdf5_array_bytes(array, bytes); // `look` held it against the limit
    TRY(memory_take(data, *bytes, 1));
    TRY(door->read(file, ask->name, array, *data));

done:
    return st;
}

static bool answer(int channel, status code, const hdf5_array *array, const void *data,
                   size_t bytes)
{
    reply r = {.code = code, .array = *array};
    (void)snprintf(r.message, sizeof r.message, "%.*s", READER_MAX_MESSAGE - 1, status_message());
    return send_all(channel, &r, sizeof r) && (code != OK || send_all(channel, data, bytes));
}

static void serve(int channel, const char *path, const char *schema)
{
    const hdf5_door *door = NULL;
    hdf5_file *file = NULL;
    request ask;
    const status opened = open_checked(path, schema, &door, &file);
    bool on = answer(channel, opened, &(hdf5_array){0}, NULL, 0) && opened == OK;
    while (on && receive_all(channel, &ask, sizeof ask)) {
        hdf5_array array = {0};
        void *data = NULL;
        size_t bytes = 0;
        status_clear();
        ask.name[READER_MAX_NAME - 1] = '\0';
        const status code = fetch(door, file, &ask, &array, &data, &bytes);
        on = answer(channel, code, &array, data, bytes);
        free(data);
    }
}

// --- the parent ----------------------------------------------------------------------------------

// what the child says may be nonsense: it has read a hostile file
static bool reply_is_sane(const reply *r, size_t *bytes)
{
    const hdf5_array *a = &r->array;
    return a->rank >= 0 && a->rank <= HDF5_MAX_RANK && a->kind >= HDF5_REAL &&
           a->kind <= HDF5_TEXT && (a->kind != HDF5_TEXT || a->rank == 1) &&
           hdf5_array_bytes(a, bytes) && memchr(r->message, '\0', sizeof r->message);
}

static status wait_for(const store_reader *r, reply *out, size_t *bytes)
{
    if (!receive_all(r->channel, out, sizeof *out) || !reply_is_sane(out, bytes)) {
        return status_fail(ERR_FILE, "damaged: the HDF5 library gave up on it");
    }
    if (out->code == OK) {
        return OK;
    }
    const bool known = out->code == ERR_RESOURCE || out->code == ERR_BUG;
    return status_fail(known ? (status)out->code : ERR_FILE, "%s", out->message);
}

status store_reader_start(const char *path, const char *schema, store_reader *out)
{
    status st = OK;
    int ends[2];
    reply r;
    size_t bytes = 0;
    *out = (store_reader){.child = -1, .channel = -1};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) {
        return status_fail(ERR_RESOURCE, "cannot make a socket: %s", strerror(errno));
    }
    out->channel = ends[0];
    out->child = fork();
    if (out->child == 0) {
        (void)close(ends[0]);
        limit_child();
        serve(ends[1], path, schema);
        _exit(0);
    }
    (void)close(ends[1]);
    if (out->child < 0) {
        TRY(status_fail(ERR_RESOURCE, "cannot start a process: %s", strerror(errno)));
    }
    const struct timeval patience = {.tv_sec = READER_SECONDS};
    (void)setsockopt(out->channel, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    TRY(wait_for(out, &r, &bytes));

done:
    if (st != OK) {
        store_reader_stop(out);
    }
    return st;
}

void store_reader_stop(store_reader *r)
{
    if (r->channel >= 0) {
        (void)close(r->channel);
    }
    if (r->child > 0) {
        // it has nothing to save, and may hang
        (void)kill(r->child, SIGKILL);
        while (waitpid(r->child, NULL, 0) < 0 && errno == EINTR) {
        }
    }
    *r = (store_reader){.child = -1, .channel = -1};
}

static status ask_for(const store_reader *r, int what, const char *name, reply *out, size_t *bytes)
{
    request ask = {.ask = what};
    if (strlen(name) >= sizeof ask.name) {
        return status_fail(ERR_BUG, "the name '%s' is too long", name);
    }
    memcpy(ask.name, name, strlen(name));
    (void)send_all(r->channel, &ask,
                   sizeof ask); // a child that is gone shows when it is waited for
    return wait_for(r, out, bytes);
}

bool store_reader_has(const store_reader *r, const char *name)
{
    reply out;
    size_t bytes = 0;
    const status st = ask_for(r, ASK_HAS, name, &out, &bytes);
    if (st != OK) {
        status_clear();
    }
    return st == OK;
}

status store_reader_get(const store_reader *r, const char *name, hdf5_array *array, void **data)
{
    status st = OK;
    reply out;
    size_t bytes = 0;
    *data = NULL;
    TRY(ask_for(r, ASK_GET, name, &out, &bytes));
    TRY(memory_take(data, bytes + 1, 1));
    if (!receive_all(r->channel, *data, bytes)) {
        TRY(status_fail(ERR_FILE, "damaged: the HDF5 library gave up on it"));
    }
    *array = out.array;

done:
    if (st != OK) {
        free(*data);
        *data = NULL;
    }
    return st;
}
