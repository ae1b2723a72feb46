// base/team.c
#define _GNU_SOURCE // sched_getaffinity
#include "base/team.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

enum { MOST_WORKERS = 256, LISTEN_MS = 100 };

// What one worker says of itself. It takes items in ascending order and ends at the first that
// fails, so one failure is enough.
typedef struct seat {
    atomic_int item; // at hand; -1: none
    status st;       // of that item
    int line, column;
    char message[1024];
} seat;

// what all processes see
typedef struct board {
    _Alignas(max_align_t) atomic_int next; // results follow the board
    atomic_int done, failed;
    seat at[MOST_WORKERS];
} board;

typedef struct team {
    team_work *work;
    void *context; // of work
    int n, nworker;
    size_t size;
    board *b;
    char *result; // [n][size]
    pid_t pid[MOST_WORKERS];
    sigset_t before; // signals that this process had blocked
    int hear, tell;  // a byte per item that is done; closed when all workers have gone
} team;

int team_cores(void)
{
    cpu_set_t set;
    const int n = sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
    return n > 0 ? n : 1;
}

// --- a worker's life

static void write_failure(seat *s, status st)
{
    s->st = st;
    strncpy(s->message, status_message(), sizeof s->message - 1);
    (void)status_place(&s->line, &s->column);
}

static void work_on(const team *t, seat *s)
{
    while (!atomic_load(&t->b->failed)) {
        const int item = atomic_fetch_add(&t->b->next, 1);
        if (item >= t->n) {
            break;
        }
        atomic_store(&s->item, item);
        const status st = t->work(t->context, item, t->result + (size_t)item * t->size);
        if (st != OK) {
            write_failure(s, st);
            atomic_store(&t->b->failed, 1);
            return;
        }
        atomic_store(&s->item, -1);
        atomic_fetch_add(&t->b->done, 1);
        const ssize_t told = write(t->tell, "", 1); // a full pipe wakes them too
        (void)told;
    }
}

// signals are blocked until here: none is answered as the first process does
static void worker_live(const team *t, seat *s, pid_t parent)
{
    const int numbers[] = {SIGINT, SIGTERM, SIGHUP};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        struct sigaction a;
        if (sigaction(numbers[i], NULL, &a) == 0 && a.sa_handler != SIG_IGN) {
            (void)signal(numbers[i], SIG_DFL);
        }
    }
    (void)prctl(PR_SET_PDEATHSIG, SIGKILL);
    (void)sigprocmask(SIG_SETMASK, &t->before, NULL);
    (void)close(t->hear);
    if (getppid() == parent) { // it may have gone before the line above could tell
        status_clear();
        work_on(t, s);
    }
    _exit(0);
}

// --- the first process

static status start(team *t)
{
    status st = OK;
    sigset_t all;
    const pid_t self = getpid();
    (void)sigfillset(&all);
    (void)sigprocmask(SIG_BLOCK, &all, &t->before);
    for (int i = 0; i < t->nworker && st == OK; i++) {
        const pid_t pid = fork();
        if (pid == 0) {
            worker_live(t, &t->b->at[i], self);
        }
        if (pid < 0) {
            st = status_fail(ERR_RESOURCE, "no worker process: %s", strerror(errno));
        }
        t->pid[i] = pid;
    }
    (void)sigprocmask(SIG_SETMASK, &t->before, NULL);
    (void)close(t->tell); // theirs alone from here on
    t->tell = -1;
    return st;
}

static status death(const seat *s, int how)
{
    const int number = WIFSIGNALED(how) ? WTERMSIG(how) : 0;
    const int item = atomic_load(&s->item);
    if (number == SIGINT || number == SIGTERM || number == SIGHUP) {
        return status_fail(ERR_INTERRUPTED, "interrupted");
    }
    if (number == SIGKILL || number == SIGXCPU) {
        return status_fail(ERR_RESOURCE,
                           "a worker process was killed at piece %d of the work: "
                           "memory or time may have run out",
                           item + 1);
    }
    return status_fail(ERR_BUG, "a worker process died at piece %d of the work, %s %d", item + 1,
                       number ? "signal" : "exit code", number ? number : WEXITSTATUS(how));
}

// collects those that have ended; the first that died fails
static status collect(team *t, int flags)
{
    status st = OK;
    for (int i = 0; i < t->nworker; i++) {
        int how = 0;
        pid_t ended = 0;
        while (t->pid[i] > 0 && (ended = waitpid(t->pid[i], &how, flags)) < 0 && errno == EINTR) {
        }
        if (t->pid[i] <= 0 || ended == 0) {
            continue;
        }
        t->pid[i] = 0;
        if (st == OK && ended > 0 && (!WIFEXITED(how) || WEXITSTATUS(how) != 0)) {
            st = death(&t->b->at[i], how);
        }
    }
    return st;
}

static void end_all(team *t)
{
    for (int i = 0; i < t->nworker; i++) {
        if (t->pid[i] > 0) {
            (void)kill(t->pid[i], SIGKILL);
        }
    }
    (void)collect(t, 0);
}

static status listen_to_all(team *t, const team_options *o)
{
    status st = OK;
    bool open = true;
    while (open) {
        char told[64];
        struct pollfd ready = {.fd = t->hear, .events = POLLIN};
        if (poll(&ready, 1, LISTEN_MS) > 0) {
            const ssize_t got = read(t->hear, told, sizeof told);
            open = got > 0 || (got < 0 && errno == EINTR);
        }
        TRY(collect(t, open ? WNOHANG : 0));
        if (o->heard) {
            TRY(o->heard(o->context, atomic_load(&t->b->done), t->n));
        }
    }

done:
    return st;
}

static status first_failure(const team *t)
{
    const seat *first = NULL;
    for (int i = 0; i < t->nworker; i++) {
        const seat *s = &t->b->at[i];
        if (s->st != OK && (!first || s->item < first->item)) {
            first = s;
        }
    }
    if (first) {
        return status_fail_at(first->st, first->line, first->column, "%s", first->message);
    }
    // where SIGCHLD is ignored nobody tells how they ended
    return atomic_load(&t->b->done) == t->n ? OK
                                            : status_fail(ERR_BUG, "a worker process went away");
}

static status with_workers(team *t, const team_options *o, void *results)
{
    status st = OK;
    int ends[2] = {-1, -1};
    const size_t bytes = (size_t)t->n * t->size, room = sizeof(board) + bytes;
    t->b = MAP_FAILED;
    t->tell = -1;
    if (pipe(ends) != 0) {
        return status_fail(ERR_RESOURCE, "no pipe: %s", strerror(errno));
    }
    t->hear = ends[0];
    t->tell = ends[1];
    (void)fcntl(t->tell, F_SETFL, O_NONBLOCK);
    t->b = mmap(NULL, room, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (t->b == MAP_FAILED) {
        TRY(status_fail(ERR_RESOURCE, "out of memory: %zu bytes for workers to share", room));
    }
    t->result = (char *)(t->b + 1);
    for (int i = 0; i < MOST_WORKERS; i++) {
        atomic_store(&t->b->at[i].item, -1);
    }
    TRY(start(t));
    TRY(listen_to_all(t, o));
    TRY(first_failure(t));
    memcpy(results, t->result, bytes);

done:
    end_all(t);
    if (t->tell >= 0) {
        (void)close(t->tell);
    }
    (void)close(t->hear);
    if (t->b != MAP_FAILED) {
        (void)munmap(t->b, room);
    }
    return st;
}

static status without(const team *t, const team_options *o, void *results)
{
    status st = OK;
    for (int i = 0; i < t->n; i++) {
        TRY(t->work(t->context, i, (char *)results + (size_t)i * t->size));
        if (o->heard) {
            TRY(o->heard(o->context, i + 1, t->n));
        }
    }

done:
    return st;
}

status team_map(team_work *work, void *context, int n, size_t size, const team_options *options,
                void *results)
{
    static const team_options usual = {0};
    const team_options *o = options ? options : &usual;
    int nworker = o->workers > 0 ? o->workers : team_cores();
    nworker = nworker < n ? nworker : n;
    nworker = nworker < MOST_WORKERS ? nworker : MOST_WORKERS;
    if (n <= 0) {
        return OK;
    }
    if (size > (SIZE_MAX / 2 - sizeof(board)) / (size_t)n) {
        return status_fail(ERR_RESOURCE, "%d results of %zu bytes are too many", n, size);
    }
    memset(results, 0, (size_t)n * size);
    team t = {.work = work, .context = context, .n = n, .nworker = nworker, .size = size};
    return nworker > 1 ? with_workers(&t, o, results) : without(&t, o, results);
}
