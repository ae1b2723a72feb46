// meshes/free_child.c
#include "meshes/free_child.h"

#include "base/door.h"
#include "base/memory.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdint.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

// a section of a thousand fragments takes some seconds; what takes longer than this is lost
enum { TIME_LIMIT = 30 }; // [s]

// no honest answer has more entries in one array than this
enum { MOST_ENTRIES = 50000000 };

// one array of the answer: where its pointer is, entries, bytes of an entry
typedef struct part {
    void **at;
    int64_t count;
    size_t size;
} part;

enum { PARTS = 11 };

static void list_parts(plane_pieces *p, part out[PARTS])
{
    const part all[PARTS] = {
        {(void **)&p->xy, 2 * (int64_t)p->nnode, sizeof *p->xy},
        {(void **)&p->corner, 3 * (int64_t)p->ntriangle, sizeof *p->corner},
        {(void **)&p->face, p->ntriangle, sizeof *p->face},
        {(void **)&p->owner, p->nface, sizeof *p->owner},
        {(void **)&p->area, p->nface, sizeof *p->area},
        {(void **)&p->around, p->nface, sizeof *p->around},
        {(void **)&p->segment, 2 * (int64_t)p->nsegment, sizeof *p->segment},
        {(void **)&p->curve, p->nsegment, sizeof *p->curve},
        {(void **)&p->tag, p->ncurve, sizeof *p->tag},
        {(void **)&p->length, p->ncurve, sizeof *p->length},
        {(void **)&p->probe, 2 * CURVE_PROBES * (int64_t)p->ncurve, sizeof *p->probe},
    };
    memcpy(out, all, sizeof all);
}

void plane_pieces_free(plane_pieces *p)
{
    part parts[PARTS];
    list_parts(p, parts);
    for (int i = 0; i < PARTS; i++) {
        free(*parts[i].at);
    }
    *p = (plane_pieces){0};
}

// what travels first
typedef struct head {
    status st;
    char message[512];
    int line, column; // of the message; 0: it has no place
    int nnode, ntriangle, nface, nsegment, ncurve;
} head;

static bool write_all(int fd, const void *data, size_t size)
{
    const char *from = data;
    while (size > 0) {
        const ssize_t n = write(fd, from, size);
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n <= 0) {
            return false;
        }
        from += n;
        size -= (size_t)n;
    }
    return true;
}

static bool read_all(int fd, void *data, size_t size)
{
    char *to = data;
    while (size > 0) {
        const ssize_t n = read(fd, to, size);
        if (n < 0 && errno == EINTR) {
            continue;
        }
        if (n <= 0) {
            return false;
        }
        to += n;
        size -= (size_t)n;
    }
    return true;
}

// the child's life; it leaves without the parent's exit handlers and buffers
static void child_run(gmsh_door_mesh_function mesh, plane_request *request, int fd)
{
    const int nothing = open("/dev/null", O_RDWR);
    for (int i = 0; i < 3 && nothing >= 0; i++) {
        (void)dup2(nothing, i);
    }
    const int signals[] = {SIGINT, SIGTERM, SIGALRM, SIGSEGV, SIGABRT, SIGFPE, SIGBUS};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        (void)signal(signals[i], SIG_DFL);
    }
    (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
    (void)alarm(TIME_LIMIT);

    plane_pieces pieces = {0};
    part parts[PARTS];
    status_clear();
    head h = {.st = mesh(request, &pieces)};
    strncpy(h.message, status_message(), sizeof h.message - 1);
    (void)status_place(&h.line, &h.column);
    h.nnode = pieces.nnode;
    h.ntriangle = pieces.ntriangle;
    h.nface = pieces.nface;
    h.nsegment = pieces.nsegment;
    h.ncurve = pieces.ncurve;
    bool sent = write_all(fd, &h, sizeof h);
    list_parts(&pieces, parts);
    for (int i = 0; i < PARTS && sent && h.st == OK; i++) {
        sent = write_all(fd, *parts[i].at, (size_t)parts[i].count * parts[i].size);
    }
    _exit(0);
}

// *complete: the child said all that it had to say
static status receive(int fd, plane_pieces *out, bool *complete)
{
    status st = OK;
    head h = {0};
    part parts[PARTS];
    if (!read_all(fd, &h, sizeof h)) {
        return OK;
    }
    if (h.st != OK) {
        *complete = true;
        return status_fail_at(h.st, h.line, h.column, "%.500s", h.message);
    }
    out->nnode = h.nnode;
    out->ntriangle = h.ntriangle;
    out->nface = h.nface;
    out->nsegment = h.nsegment;
    out->ncurve = h.ncurve;
    list_parts(out, parts);
    for (int i = 0; i < PARTS; i++) {
        if (parts[i].count < 0 || parts[i].count > MOST_ENTRIES) {
            TRY(status_fail(ERR_BUG, "the free mesher's answer is damaged"));
        }
        TRY(memory_take(parts[i].at, (size_t)parts[i].count, parts[i].size));
        if (!read_all(fd, *parts[i].at, (size_t)parts[i].count * parts[i].size)) {
            goto done;
        }
    }
    *complete = true;

done:
    return st;
}

static status ending(int how)
{
    if (WIFSIGNALED(how) && WTERMSIG(how) == SIGINT) {
        return status_fail(ERR_INTERRUPTED, "interrupted");
    }
    if (WIFSIGNALED(how) && WTERMSIG(how) == SIGALRM) {
        return status_fail(ERR_RESOURCE, "the free mesher was stopped after %d s", TIME_LIMIT);
    }
    if (WIFSIGNALED(how)) {
        return status_fail(ERR_NUMERIC, "the free mesher (gmsh) crashed on these shapes, signal %d",
                           WTERMSIG(how));
    }
    return status_fail(ERR_NUMERIC, "the free mesher (gmsh) ended without an answer");
}

status free_child_run(plane_request *request, plane_pieces *out)
{
    status st = OK;
    door_function found = NULL;
    plane_pieces pieces = {0};
    int ends[2] = {-1, -1}, how = 0;
    bool complete = false;

    TRY(door_open("gmsh", "gmsh_door_mesh", &found));
    if (pipe(ends) != 0) {
        TRY(status_fail(ERR_RESOURCE, "no pipe: %s", strerror(errno)));
    }
    const pid_t child = fork();
    if (child < 0) {
        TRY(status_fail(ERR_RESOURCE, "no child process: %s", strerror(errno)));
    }
    if (child == 0) {
        (void)close(ends[0]);
        child_run((gmsh_door_mesh_function)found, request, ends[1]);
    }
    (void)close(ends[1]);
    ends[1] = -1;
    st = receive(ends[0], &pieces, &complete);
    (void)close(ends[0]);
    ends[0] = -1;
    while (waitpid(child, &how, 0) < 0 && errno == EINTR) {
    }
    TRY(st);
    if (!complete) {
        TRY(ending(how));
    }
    *out = pieces;
    pieces = (plane_pieces){0};

done:
    for (int i = 0; i < 2; i++) {
        if (ends[i] >= 0) {
            (void)close(ends[i]);
        }
    }
    plane_pieces_free(&pieces);
    return st;
}
