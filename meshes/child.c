// meshes/child.c
#include "meshes/child.h"

#include "base/memory.h"
#include "meshes/seal.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

// no honest answer has more entries in one array than this
enum { MOST_ENTRIES = 50000000 };

// what travels first, then the answer's struct and its arrays
typedef struct head {
    status st;
    char message[512];
    int line, column; // of the message; 0: it has no place
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

static int64_t milliseconds(void)
{
    struct timespec t = {0};
    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    return (int64_t)t.tv_sec * 1000 + t.tv_nsec / 1000000;
}

// the parent's end
typedef struct pipe_end {
    int fd;
    int64_t until; // [ms]
    bool late;
} pipe_end;

static bool read_all(pipe_end *p, void *data, size_t size)
{
    char *to = data;
    while (size > 0) {
        const int64_t left = p->until - milliseconds();
        struct pollfd ready = {.fd = p->fd, .events = POLLIN};
        const int some = left > 0 ? poll(&ready, 1, (int)left) : 0;
        if (some < 0 && errno == EINTR) {
            continue;
        }
        p->late = some == 0;
        const ssize_t n = some > 0 ? read(p->fd, to, size) : 0;
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

// --- the child's life; it leaves without the parent's exit handlers and buffers

static void prepare(const child_job *job)
{
    const int nothing = open("/dev/null", O_RDWR);
    for (int i = 0; i < 3 && nothing >= 0; i++) {
        (void)dup2(nothing, i);
    }
    const int signals[] = {SIGINT, SIGTERM, SIGALRM, SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGXCPU};
    for (size_t i = 0; i < sizeof signals / sizeof *signals; i++) {
        (void)signal(signals[i], SIG_DFL);
    }
    (void)signal(SIGXFSZ, SIG_IGN); // a write beyond the limit fails, and that is all
    (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
    (void)alarm((unsigned)job->seconds + 1); // should the parent be stopped
}

static void child_live(const child_job *job, void *answer, int fd)
{
    status_clear();
    prepare(job);
    head h = {.st = seal(job->seconds, job->memory, job->sealed)};
    if (h.st == OK) {
        h.st = job->work(job->request, answer);
    }
    strncpy(h.message, status_message(), sizeof h.message - 1);
    (void)status_place(&h.line, &h.column);
    child_part parts[CHILD_MOST_PARTS];
    const int n = job->list(answer, parts);
    bool sent = write_all(fd, &h, sizeof h) && write_all(fd, answer, job->answer_size);
    for (int i = 0; i < n && sent && h.st == OK; i++) {
        sent = write_all(fd, *parts[i].at, (size_t)parts[i].count * parts[i].size);
    }
    _exit(0);
}

// --- the parent's

// *complete: the child said all that it had to say
static status receive(const child_job *job, pipe_end *p, void *answer, bool *complete)
{
    status st = OK;
    head h = {0};
    child_part parts[CHILD_MOST_PARTS];
    if (!read_all(p, &h, sizeof h)) {
        return OK;
    }
    if (h.st != OK) {
        *complete = true;
        h.message[sizeof h.message - 1] = '\0';
        return status_fail_at(h.st, h.line, h.column, "%s", h.message);
    }
    const bool whole = read_all(p, answer, job->answer_size);
    const int n = job->list(answer, parts);
    for (int i = 0; i < n; i++) {
        *parts[i].at = NULL; // it pointed into the child
    }
    for (int i = 0; i < n && whole; i++) {
        if (parts[i].count < 0 || parts[i].count > MOST_ENTRIES) {
            TRY(status_fail(ERR_BUG, "the answer of %s is damaged", job->what));
        }
        TRY(memory_take(parts[i].at, (size_t)parts[i].count, parts[i].size));
        if (!read_all(p, *parts[i].at, (size_t)parts[i].count * parts[i].size)) {
            goto done;
        }
    }
    *complete = whole;

done:
    return st;
}

static status ending(const child_job *job, int how, bool late)
{
    const int signal_number = WIFSIGNALED(how) ? WTERMSIG(how) : 0;
    if (signal_number == SIGINT) {
        return status_fail(ERR_INTERRUPTED, "interrupted");
    }
    if (late || signal_number == SIGALRM || signal_number == SIGXCPU) {
        return status_fail(ERR_RESOURCE, "%s was stopped after %d s", job->what, job->seconds);
    }
    if (signal_number) {
        return status_fail(
            job->when_killed, "%s crashed on it, signal %d%s", job->what, signal_number,
            job->when_killed == ERR_FILE ? ": it is damaged, or holds what is not supported" : "");
    }
    return status_fail(job->when_killed, "%s ended without an answer", job->what);
}

void child_answer_free(const child_job *job, void *answer)
{
    child_part parts[CHILD_MOST_PARTS];
    const int n = job->list(answer, parts);
    for (int i = 0; i < n; i++) {
        free(*parts[i].at);
    }
    memset(answer, 0, job->answer_size);
}

static status listen_to(const child_job *job, pid_t child, int fd, void *answer)
{
    status st = OK;
    int how = 0;
    bool complete = false;
    pipe_end p = {.fd = fd, .until = milliseconds() + (int64_t)job->seconds * 1000};
    st = receive(job, &p, answer, &complete);
    if (!complete) {
        (void)kill(child, p.late || st != OK ? SIGKILL : 0);
    }
    while (waitpid(child, &how, 0) < 0 && errno == EINTR) {
    }
    TRY(st);
    if (!complete) {
        TRY(ending(job, how, p.late));
    }

done:
    return st;
}

status child_run(const child_job *job, void *answer)
{
    status st = OK;
    int ends[2] = {-1, -1};
    memset(answer, 0, job->answer_size);
    if (pipe(ends) != 0) {
        return status_fail(ERR_RESOURCE, "no pipe: %s", strerror(errno));
    }
    const pid_t child = fork();
    if (child == 0) {
        (void)close(ends[0]);
        child_live(job, answer, ends[1]);
    }
    (void)close(ends[1]);
    st = child > 0 ? listen_to(job, child, ends[0], answer)
                   : status_fail(ERR_RESOURCE, "no child process: %s", strerror(errno));
    (void)close(ends[0]);
    return st;
}
