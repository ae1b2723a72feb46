// app/outside.c
#include "app/outside.h"

#include "app/interrupt.h"
#include "io/disk.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { POLL_MS = 2, MOST_ARGUMENTS = 15 };

bool outside_find(const outside_program *p, char *path, size_t size)
{
    const char *places = getenv("PATH");
    places = places ? places : "/usr/local/bin:/usr/bin:/bin";
    while (places && *places) {
        const size_t length = strcspn(places, ":");
        const int written = snprintf(path, size, "%.*s/%s", (int)length, places, p->file);
        if (length > 0 && written > 0 && (size_t)written < size && access(path, X_OK) == 0) {
            return true;
        }
        places += length + (places[length] == ':');
    }
    return false;
}

// In the child: an environment of its own (under mpirun it would join our processes), stdin closed,
// all words into a log, limits on time, and the program. No shell.
static void become(const outside_program *p, const char *program, const char *directory,
                   const char *const *arguments)
{
    static char *const environment[] = {
        "PATH=/usr/bin:/bin",
        "LC_ALL=C",
        "OMPI_MCA_ess_singleton_isolated=1",
        "OMPI_MCA_pml=ob1",
        "OMPI_MCA_btl=self",
        "OPENBLAS_NUM_THREADS=1",
        "OMP_NUM_THREADS=1",
        NULL,
    };
    const rlim_t most = (rlim_t)p->seconds;
    const struct rlimit time = {most, most}, no_core = {0, 0};
    if (chdir(directory) != 0) {
        _exit(127);
    }
    const int null = open("/dev/null", O_RDONLY);
    const int log = open("log.txt", O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (null < 0 || log < 0 || dup2(null, 0) < 0 || dup2(log, 1) < 0 || dup2(log, 2) < 0) {
        _exit(127);
    }
    (void)setrlimit(RLIMIT_CPU, &time);
    (void)setrlimit(RLIMIT_CORE, &no_core);
    // execve takes its arguments as not const and leaves them alone
    char *words[MOST_ARGUMENTS + 1];
    int count = 0;
    for (; arguments[count] && count < MOST_ARGUMENTS; count++) {
        memcpy(&words[count], &arguments[count], sizeof words[count]);
    }
    words[count] = NULL;
    (void)execve(program, words, environment);
    _exit(127);
}

static double seconds_of(struct timeval t)
{
    return (double)t.tv_sec + 1e-6 * (double)t.tv_usec;
}

// waits until the child ended, its time ran out, or the user wants to leave
static status wait_for(const outside_program *p, pid_t child, int *state, double *cpu_seconds)
{
    const struct timespec pause = {0, POLL_MS * 1000000L};
    struct rusage usage;
    for (long waited = 0; waited < p->seconds * 1000L; waited += POLL_MS) {
        const pid_t ended = wait4(child, state, WNOHANG, &usage);
        if (ended == child) {
            *cpu_seconds = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
            return OK;
        }
        if (ended < 0 && errno != EINTR) {
            return status_fail(ERR_RESOURCE, "%s: cannot wait for it: %s", p->name,
                               strerror(errno));
        }
        if (interrupt_pending()) {
            break;
        }
        (void)nanosleep(&pause, NULL);
    }
    (void)kill(child, SIGKILL);
    (void)waitpid(child, state, 0);
    return interrupt_pending()
               ? status_fail(ERR_INTERRUPTED, "interrupted")
               : status_fail(ERR_RESOURCE, "%s took more than %d s", p->name, p->seconds);
}

status outside_run(const outside_program *p, const char *directory, const char *const *arguments,
                   double *cpu_seconds)
{
    status st = OK;
    char program[OUTSIDE_PATH];
    int state = 0;
    double cpu = 0;
    if (!outside_find(p, program, sizeof program)) {
        return status_fail(ERR_RESOURCE, "%s is not installed", p->file);
    }
    (void)fflush(NULL);
    const pid_t child = fork();
    if (child < 0) {
        return status_fail(ERR_RESOURCE, "%s: cannot start it: %s", p->name, strerror(errno));
    }
    if (child == 0) {
        become(p, program, directory, arguments);
    }
    TRY(wait_for(p, child, &state, &cpu));
    if (cpu_seconds) {
        *cpu_seconds = cpu;
    }
    if (!WIFEXITED(state) || WEXITSTATUS(state) != 0) {
        return status_fail(ERR_NUMERIC, "%s failed: %s %d", p->name,
                           WIFEXITED(state) ? "exit code" : "signal",
                           WIFEXITED(state) ? WEXITSTATUS(state) : WTERMSIG(state));
    }

done:
    return st;
}

status outside_enter(const outside_program *p, char *directory)
{
    const char *place = getenv("TMPDIR");
    const int length = snprintf(directory, OUTSIDE_PATH, "%s/stiffaxis-%s-XXXXXX",
                                place && place[0] == '/' ? place : "/tmp", p->file);
    interrupt_hold(); // so that the directory does not stay behind
    if (length < 0 || length >= OUTSIDE_PATH || !mkdtemp(directory)) {
        directory[0] = '\0';
        return status_fail(ERR_RESOURCE, "cannot make a temporary directory for %s: %s", p->name,
                           strerror(errno));
    }
    return OK;
}

status outside_leave(const char *directory, status st)
{
    if (directory[0]) {
        (void)disk_remove_tree(directory);
    }
    const status interrupted = interrupt_release();
    return interrupted != OK ? interrupted : st;
}

status outside_open(const outside_program *p, const char *directory, const char *name,
                    const char *mode, FILE **out)
{
    char path[OUTSIDE_PATH + 64];
    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    *out = fopen(path, mode);
    return *out ? OK : status_fail(ERR_RESOURCE, "%s: %s: %s", p->name, path, strerror(errno));
}

status outside_close_written(const outside_program *p, FILE *file)
{
    const bool good = !ferror(file);
    return fclose(file) == 0 && good
               ? OK
               : status_fail(ERR_RESOURCE, "cannot write %s's files: %s", p->name, strerror(errno));
}
