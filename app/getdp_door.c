// app/getdp_door.c
#include "app/getdp_door.h"

#include "app/getdp_files.h"
#include "app/interrupt.h"
#include "io/disk.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { MAX_PATH = 4096, MAX_SECONDS = 120, POLL_MS = 5 };

bool getdp_find(char *path, size_t size)
{
    const char *places = getenv("PATH");
    while (places && *places) {
        const size_t length = strcspn(places, ":");
        const int written = snprintf(path, size, "%.*s/getdp", (int)length, places);
        if (length > 0 && written > 0 && (size_t)written < size && access(path, X_OK) == 0) {
            return true;
        }
        places += length + (places[length] == ':');
    }
    return false;
}

// In the child: an environment of its own (under mpirun it would join our processes), stdin closed,
// all words into a log, limits on time, and the program. No shell.
static void become_getdp(const char *program, const char *directory, const char *const *arguments)
{
    static char *const environment[] = {
        "PATH=/usr/bin:/bin",
        "LC_ALL=C",
        "OMPI_MCA_ess_singleton_isolated=1",
        "OMPI_MCA_pml=ob1",
        "OMPI_MCA_btl=self",
        "OPENBLAS_NUM_THREADS=1",
        NULL,
    };
    const struct rlimit time = {MAX_SECONDS, MAX_SECONDS}, no_core = {0, 0};
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
    char *words[16];
    int count = 0;
    for (; arguments[count] && count < 15; count++) {
        memcpy(&words[count], &arguments[count], sizeof words[count]);
    }
    words[count] = NULL;
    (void)execve(program, words, environment);
    _exit(127);
}

// waits until the child ended, its time ran out, or the user wants to leave
static status wait_for(pid_t child, int *state)
{
    const struct timespec pause = {0, POLL_MS * 1000000L};
    for (long waited = 0; waited < MAX_SECONDS * 1000L; waited += POLL_MS) {
        const pid_t ended = waitpid(child, state, WNOHANG);
        if (ended == child) {
            return OK;
        }
        if (ended < 0 && errno != EINTR) {
            return status_fail(ERR_RESOURCE, "GetDP: cannot wait for it: %s", strerror(errno));
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
               : status_fail(ERR_RESOURCE, "GetDP took more than %d s", MAX_SECONDS);
}

static status run_getdp(const char *directory, const char *const *arguments)
{
    status st = OK;
    char program[MAX_PATH];
    int state = 0;
    if (!getdp_find(program, sizeof program)) {
        return status_fail(ERR_RESOURCE, "getdp is not installed");
    }
    (void)fflush(NULL);
    const pid_t child = fork();
    if (child < 0) {
        return status_fail(ERR_RESOURCE, "GetDP: cannot start it: %s", strerror(errno));
    }
    if (child == 0) {
        become_getdp(program, directory, arguments);
    }
    TRY(wait_for(child, &state));
    if (!WIFEXITED(state) || WEXITSTATUS(state) != 0) {
        return status_fail(ERR_NUMERIC, "GetDP failed: %s %d",
                           WIFEXITED(state) ? "exit code" : "signal",
                           WIFEXITED(state) ? WEXITSTATUS(state) : WTERMSIG(state));
    }

done:
    return st;
}

static status make_directory(char *path, size_t size)
{
    const char *place = getenv("TMPDIR");
    const int length = snprintf(path, size, "%s/stiffaxis-getdp-XXXXXX",
                                place && place[0] == '/' ? place : "/tmp");
    if (length < 0 || (size_t)length >= size || !mkdtemp(path)) {
        path[0] = '\0';
        return status_fail(ERR_RESOURCE, "cannot make a temporary directory for GetDP: %s",
                           strerror(errno));
    }
    return OK;
}

static status open_file(const char *directory, const char *name, const char *mode, FILE **out)
{
    char path[MAX_PATH + 64];
    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    *out = fopen(path, mode);
    return *out ? OK : status_fail(ERR_RESOURCE, "%s: %s", path, strerror(errno));
}

static status close_written(FILE *file)
{
    const bool good = !ferror(file);
    return fclose(file) == 0 && good
               ? OK
               : status_fail(ERR_RESOURCE, "cannot write GetDP's files: %s", strerror(errno));
}

typedef struct getdp_problem {
    const char *name; // of its resolution, and before .pro of its file
    int npost;
    const char *post[3]; // its post-processing steps
} getdp_problem;

static const getdp_problem torsion = {"Torsion", 1, {"Torsion"}};
static const getdp_problem plane_strain = {"Plane", 3, {"Plane0", "Plane1", "Plane2"}};

static status write_files(const char *directory, const getdp_problem *problem, const mesh *m,
                          int nmaterial, const material *materials)
{
    status st = OK;
    FILE *file = NULL;
    TRY(open_file(directory, "section.msh", "w", &file));
    getdp_write_mesh(m, file);
    TRY(close_written(file));
    TRY(open_file(directory, "problem.pro", "w", &file));
    if (problem == &torsion) {
        getdp_write_torsion(nmaterial, materials, file);
    } else {
        getdp_write_plane(m, nmaterial, materials, file);
    }
    TRY(close_written(file));

done:
    return st;
}

static status read_number(const char *directory, const char *name, double *value)
{
    status st = OK;
    FILE *file = NULL;
    double time = 0;
    if (open_file(directory, name, "r", &file) != OK) {
        status_clear();
        return status_fail(ERR_NUMERIC, "GetDP gave no result");
    }
    const int count = fscanf(file, "%lf %lf", &time, value);
    (void)fclose(file);
    if (count != 2 || !isfinite(*value)) {
        return status_fail(ERR_NUMERIC, "GetDP's result %s holds no number", name);
    }
    return st;
}

static status read_torsion(const char *directory, double *GJ)
{
    status st = OK;
    TRY(read_number(directory, "gj.txt", GJ));
    *GJ *= 1e-6; // from N mm^2
    if (!(*GJ > 0)) {
        st = status_fail(ERR_NUMERIC, "GetDP gave no torsional stiffness");
    }

done:
    return st;
}

static status read_plane(const char *directory, mat3 *out)
{
    static const double metres[3] = {1, 1e-3, 1e-3};
    status st = OK;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            char name[32];
            (void)snprintf(name, sizeof name, "k%d%d.txt", i, j);
            TRY(read_number(directory, name, &out->a[i][j]));
            out->a[i][j] *= metres[i] * metres[j];
        }
    }

done:
    return st;
}

// solves in a private directory and leaves the answers there; leave() takes it away again
static status solve_in(char *directory, const getdp_problem *problem, const mesh *plane,
                       int nmaterial, const material *materials)
{
    status st = OK;
    const char *arguments[16] = {"getdp",       "problem.pro", "-msh", "section.msh", "-solve",
                                 problem->name, "-v",          "2",    "-pos"};
    mesh lower = {0};
    for (int i = 0, n = 9; i < problem->npost; i++) {
        arguments[n++] = problem->post[i];
    }
    if (plane->order > 2) {
        TRY(mesh_of_order(plane, 2, &lower));
    }
    TRY(make_directory(directory, MAX_PATH));
    TRY(write_files(directory, problem, lower.nnode ? &lower : plane, nmaterial, materials));
    TRY(run_getdp(directory, arguments));

done:
    mesh_free(&lower);
    return st;
}

static status leave(const char *directory, status st)
{
    if (directory[0]) {
        (void)disk_remove_tree(directory);
    }
    const status interrupted = interrupt_release();
    return interrupted != OK ? interrupted : st;
}

status getdp_torsion(const mesh *plane, int nmaterial, const material *materials, double *GJ)
{
    status st = OK;
    char directory[MAX_PATH] = "";
    interrupt_hold(); // so that the directory does not stay behind
    TRY(solve_in(directory, &torsion, plane, nmaterial, materials));
    TRY(read_torsion(directory, GJ));

done:
    return leave(directory, st);
}

status getdp_axial_bending(const mesh *plane, int nmaterial, const material *materials, mat3 *out)
{
    status st = OK;
    char directory[MAX_PATH] = "";
    interrupt_hold();
    TRY(solve_in(directory, &plane_strain, plane, nmaterial, materials));
    TRY(read_plane(directory, out));

done:
    return leave(directory, st);
}

status getdp_version(char *text, size_t size)
{
    static const char *const arguments[] = {"getdp", "-version", NULL};
    status st = OK;
    char directory[MAX_PATH] = "";
    FILE *file = NULL;
    text[0] = '\0';
    interrupt_hold();
    TRY(make_directory(directory, sizeof directory));
    TRY(run_getdp(directory, arguments));
    TRY(open_file(directory, "log.txt", "r", &file));
    if (!fgets(text, (int)size, file)) {
        st = status_fail(ERR_NUMERIC, "GetDP does not tell its version");
    }
    text[strcspn(text, "\n")] = '\0';
    (void)fclose(file);

done:
    return leave(directory, st);
}
