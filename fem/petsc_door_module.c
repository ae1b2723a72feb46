// fem/petsc_door_module.c
// The library's start and end, and what ranks tell each other.
#include "fem/petsc_inside.h"

#include "base/memory.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>
#include <unistd.h>

// what MPI keeps until the process ends is no leak of ours
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#else
#define __lsan_disable() ((void)0)
#define __lsan_enable() ((void)0)
#endif

// Set before the library starts, since PETSc 3.18 forgets MUMPS controls that are set on the
// factor. The graph is compressed by blocks. MUMPS' low-rank blocks (ICNTL 35) gained nothing at
// 2.3e5 unknowns, and its analysis on several ranks is not in Debian's.
static const struct {
    const char *name, *value;
} settings[] = {
    {"-skip_petscrc", "1"},
    {"-no_signal_handler", "1"},
    {"-mat_mumps_icntl_15", "-3"},
    {"-mat_mumps_icntl_14", "40"},
};

status petsc_fail(PetscErrorCode code, const char *call)
{
    const char *words = NULL;
    // an allocation that fails below some layers of PETSc comes up as one of these
    if (code == PETSC_ERR_MEM) {
        return status_fail(ERR_RESOURCE, "PETSc: out of memory in %s: " PETSC_SMALLER, call);
    }
    (void)PetscErrorMessage(code, &words, NULL);
    if (!words) { // not PETSc's own: seen where libraries under it found no memory
        return status_fail(
            ERR_RESOURCE,
            "PETSc: code %d from below it in %s, as for want of memory: " PETSC_SMALLER, (int)code,
            call);
    }
    return status_fail(ERR_BUG, "PETSc: %s (code %d), in %s", words, (int)code, call);
}

// --- start and end

// a rank that fails waits this long for the others to fail too, and then ends them [s]
static const double PATIENCE = 3;

static bool others_end_too(void)
{
    MPI_Request request;
    int done = 0;
    struct timespec pause = {.tv_nsec = 1000000};
    (void)MPI_Ibarrier(MPI_COMM_WORLD, &request);
    const double begin = MPI_Wtime();
    while (!done && MPI_Wtime() - begin < PATIENCE) {
        (void)MPI_Test(&request, &done, MPI_STATUS_IGNORE);
        (void)nanosleep(&pause, NULL);
    }
    return done;
}

// a rank that ends alone would leave the others waiting for it
static void finish(int code, void *unused)
{
    PetscBool finished = PETSC_TRUE;
    int size = 1;
    (void)unused;
    (void)PetscFinalized(&finished);
    if (finished) {
        return;
    }
    (void)MPI_Comm_size(MPI_COMM_WORLD, &size);
    if (code != OK && size > 1 && !others_end_too()) {
        (void)MPI_Abort(MPI_COMM_WORLD, code);
    }
    (void)PetscFinalize();
}

// no option may come from outside the case; a process of its own needs no daemon and no network
static void prepare_environment(void)
{
    (void)unsetenv("PETSC_OPTIONS");
    (void)unsetenv("PETSC_OPTIONS_YAML");
    if (!getenv("OMPI_COMM_WORLD_SIZE")) {
        (void)setenv("OMPI_MCA_ess_singleton_isolated", "1", 1);
        (void)setenv("OMPI_MCA_pml", "ob1", 1);
    }
}

static status start(int *rank, int *size)
{
    status st = OK;
    PetscBool ready = PETSC_FALSE;
    PETSC_TRY(PetscInitialized(&ready));
    if (!ready) {
        prepare_environment();
        for (size_t i = 0; i < sizeof settings / sizeof *settings; i++) {
            PETSC_TRY(PetscOptionsSetValue(NULL, settings[i].name, settings[i].value));
        }
        __lsan_disable();
        const PetscErrorCode begun = PetscInitializeNoArguments();
        __lsan_enable();
        PETSC_TRY(begun);
        (void)on_exit(finish, NULL);
        // errors come back as codes: no trace on the user's screen
        PETSC_TRY(PetscPushErrorHandler(PetscIgnoreErrorHandler, NULL));
    }
    (void)MPI_Comm_rank(PETSC_COMM_WORLD, rank);
    (void)MPI_Comm_size(PETSC_COMM_WORLD, size);

done:
    return st;
}

// what others have left of the machine's memory: a kernel without any kills instead of refusing
static double memory_left(void)
{
    double all = (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE), kilobytes = 0;
    char line[128];
    FILE *file = fopen("/proc/meminfo", "r");
    while (file && fgets(line, sizeof line, file)) {
        if (sscanf(line, "MemAvailable: %lf", &kilobytes) == 1 && 1024 * kilobytes < all) {
            all = 1024 * kilobytes;
        }
    }
    if (file) {
        (void)fclose(file);
    }
    return all;
}

// memory left, or what the process may have of it [byte]
double petsc_machine_memory(void)
{
    double limit = memory_left(), group = 0;
    struct rlimit room;
    if (getrlimit(RLIMIT_AS, &room) == 0 && room.rlim_cur != RLIM_INFINITY) {
        limit = (double)room.rlim_cur < limit ? (double)room.rlim_cur : limit;
    }
    FILE *file = fopen("/sys/fs/cgroup/memory.max", "r");
    if (file) {
        // "max" where there is no limit
        limit = fscanf(file, "%lf", &group) == 1 && group < limit ? group : limit;
        (void)fclose(file);
    }
    return limit;
}

// --- between the ranks

enum { MESSAGE_LENGTH = 512 };

status petsc_agree(status mine)
{
    int rank = 0, worst[2] = {0};
    char words[MESSAGE_LENGTH] = "";
    (void)MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
    const int failed[2] = {(int)mine, rank};
    (void)MPI_Allreduce(failed, worst, 1, MPI_2INT, MPI_MAXLOC, PETSC_COMM_WORLD);
    if (worst[0] == OK) {
        return OK;
    }
    (void)snprintf(words, sizeof words, "%s", status_message());
    (void)MPI_Bcast(words, MESSAGE_LENGTH, MPI_CHAR, worst[1], PETSC_COMM_WORLD);
    // the first message stands where this rank has one of its own
    return mine != OK ? mine : status_fail((status)worst[0], "%s", words);
}

static void sum(int n, double *v)
{
    (void)MPI_Allreduce(MPI_IN_PLACE, v, n, MPI_DOUBLE, MPI_SUM, PETSC_COMM_WORLD);
}

static void largest(int n, double *v)
{
    (void)MPI_Allreduce(MPI_IN_PLACE, v, n, MPI_DOUBLE, MPI_MAX, PETSC_COMM_WORLD);
}

static void pass(int to, int nsend, const double *send, int nget, double *get)
{
    int rank = 0;
    (void)MPI_Comm_rank(PETSC_COMM_WORLD, &rank);
    MPI_Request request = MPI_REQUEST_NULL;
    if (nget > 0) {
        (void)MPI_Irecv(get, nget, MPI_DOUBLE, rank - to, 0, PETSC_COMM_WORLD, &request);
    }
    if (nsend > 0) {
        (void)MPI_Send(send, nsend, MPI_DOUBLE, rank + to, 0, PETSC_COMM_WORLD);
    }
    (void)MPI_Wait(&request, MPI_STATUS_IGNORE);
}

static void pass_down(int nsend, const double *send, int nget, double *get)
{
    pass(-1, nsend, send, nget, get);
}

static void pass_up(int nsend, const double *send, int nget, double *get)
{
    pass(1, nsend, send, nget, get);
}

const petsc_door *stiffaxis_petsc_door(void);

const petsc_door *stiffaxis_petsc_door(void)
{
    static const petsc_door door = {.start = start,
                                    .memory = petsc_machine_memory,
                                    .agree = petsc_agree,
                                    .sum = sum,
                                    .largest = largest,
                                    .pass_down = pass_down,
                                    .pass_up = pass_up,
                                    .matrix_make = petsc_matrix_make,
                                    .matrix_add = petsc_matrix_add,
                                    .matrix_factor = petsc_matrix_factor,
                                    .matrix_coarsen = petsc_matrix_coarsen,
                                    .matrix_steps = petsc_matrix_steps,
                                    .matrix_solve = petsc_matrix_solve,
                                    .matrix_free = petsc_matrix_free};
    return &door;
}
