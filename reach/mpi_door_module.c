// reach/mpi_door_module.c
#include "reach/ranks.h"

#include <limits.h>
#include <math.h>
#include <mpi.h>
#include <stdlib.h>
#include <time.h>

// what MPI keeps until the process ends is no leak of ours
#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#else
#define __lsan_disable() ((void)0)
#define __lsan_enable() ((void)0)
#endif

// a rank that fails waits this long for the others to fail too, and then ends them [s]
static const double PATIENCE = 3;

static status failed(int code, const char *call)
{
    char words[MPI_MAX_ERROR_STRING] = "no message";
    int length = 0;
    (void)MPI_Error_string(code, words, &length);
    return status_fail(ERR_BUG, "MPI: %s, in %s", words, call);
}

// others may need the core meanwhile
static int done_within(MPI_Request *request, double seconds, int *code)
{
    const struct timespec pause = {.tv_nsec = 1000000};
    const double begin = MPI_Wtime();
    int done = 0;
    *code = MPI_Test(request, &done, MPI_STATUS_IGNORE);
    while (*code == MPI_SUCCESS && !done && !(MPI_Wtime() - begin > seconds)) {
        (void)nanosleep(&pause, NULL);
        *code = MPI_Test(request, &done, MPI_STATUS_IGNORE);
    }
    return done;
}

static void finish(int code, void *unused)
{
    int ended = 1, error = MPI_SUCCESS;
    MPI_Request request = MPI_REQUEST_NULL;
    (void)unused;
    (void)MPI_Finalized(&ended);
    if (ended) {
        return;
    }
    // a rank that ends alone would leave the others waiting for it; the first one may be long
    (void)MPI_Ibarrier(MPI_COMM_WORLD, &request);
    if (!done_within(&request, code == OK ? HUGE_VAL : PATIENCE, &error)) {
        (void)MPI_Abort(MPI_COMM_WORLD, code ? code : (int)ERR_BUG);
    }
    (void)MPI_Finalize();
}

static status start(void)
{
    int begun = 0;
    (void)MPI_Initialized(&begun);
    if (begun) {
        return OK;
    }
    __lsan_disable();
    const int code = MPI_Init(NULL, NULL);
    __lsan_enable();
    if (code != MPI_SUCCESS) {
        return status_fail(ERR_RESOURCE, "MPI does not start, code %d", code);
    }
    (void)MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);
    (void)on_exit(finish, NULL);
    return OK;
}

static status broadcast(int root, void *data, size_t bytes)
{
    int code = MPI_SUCCESS;
    MPI_Request request = MPI_REQUEST_NULL;
    if (bytes > INT_MAX) {
        return status_fail(ERR_RESOURCE, "%zu bytes are more than MPI sends at once", bytes);
    }
    code = MPI_Ibcast(data, (int)bytes, MPI_BYTE, root, MPI_COMM_WORLD, &request);
    if (code == MPI_SUCCESS) {
        (void)done_within(&request, HUGE_VAL, &code);
    }
    return code == MPI_SUCCESS ? OK : failed(code, "MPI_Ibcast");
}

const mpi_door *stiffaxis_mpi_door(void);
const mpi_door *stiffaxis_mpi_door(void)
{
    static const mpi_door door = {.start = start, .broadcast = broadcast};
    return &door;
}
