// io/hdf5_share_door_module.c
// Files that all ranks write together, by MPI-IO. Whoever solved on several ranks has started MPI.
#include "io/hdf5_inside.h"

#include "base/memory.h"

#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

void hdf5_ranks(int *rank, int *size)
{
    int running = 0, over = 0;
    *rank = 0;
    *size = 1;
    (void)MPI_Initialized(&running);
    (void)MPI_Finalized(&over);
    if (running && !over) {
        (void)MPI_Comm_rank(MPI_COMM_WORLD, rank);
        (void)MPI_Comm_size(MPI_COMM_WORLD, size);
    }
}

void hdf5_tell(void *data, size_t size)
{
    int rank = 0, many = 1;
    hdf5_ranks(&rank, &many);
    if (many > 1) {
        (void)MPI_Bcast(data, (int)size, MPI_BYTE, 0, MPI_COMM_WORLD);
    }
}

status hdf5_agree(status mine)
{
    int rank = 0, many = 1, worst = (int)mine;
    hdf5_ranks(&rank, &many);
    if (many > 1) {
        (void)MPI_Allreduce(MPI_IN_PLACE, &worst, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    }
    if (mine == OK && worst != OK) {
        return status_fail((status)worst, "another rank failed");
    }
    return mine;
}

// bytes of descriptions, not data, that wait until the end: as many as HDF5 lets wait
static const size_t most_waiting = (size_t)32 << 20;

// Descriptions are written at the end, when all ranks know that all data went well: where one rank
// fails in the middle of that the others wait for it.
static void write_late(hdf5_scope *s, hid_t access)
{
    H5AC_cache_config_t config = {.version = H5AC__CURR_CACHE_CONFIG_VERSION};
    hdf5_check(s, H5Pget_mdc_config(access, &config));
    config.dirty_bytes_threshold = most_waiting;
    config.incr_mode = H5C_incr__off;
    config.flash_incr_mode = H5C_flash_incr__off;
    config.decr_mode = H5C_decr__off;
    config.set_initial_size = 1;
    config.initial_size = config.max_size = most_waiting;
    config.evictions_enabled = 0;
    hdf5_check(s, H5Pset_mdc_config(access, &config));
}

status hdf5_create_shared(const char *path, hdf5_file **out)
{
    status st = OK;
    int rank = 0, size = 1;
    hdf5_file *f = NULL;
    hdf5_scope s = {0};
    TRY(hdf5_agree(TAKE(f, 1)));
    f->shared = true;
    hdf5_ranks(&rank, &size);
    f->first_rank = rank == 0;
    const hid_t access = hdf5_keep(&s, H5Pcreate(H5P_FILE_ACCESS));
    hdf5_check(&s, H5Pset_fapl_mpio(access, MPI_COMM_WORLD, MPI_INFO_NULL));
    hdf5_check(&s, H5Pset_fclose_degree(access, H5F_CLOSE_STRONG));
    write_late(&s, access);
    f->id = H5Fcreate(path, H5F_ACC_TRUNC, H5P_DEFAULT, access);
    hdf5_check(&s, f->id < 0 ? -1 : 0);
    TRY(hdf5_agree(hdf5_leave(&s, ERR_RESOURCE, "create", path)));
    *out = f;
    f = NULL;

done:
    free(f);
    return st;
}

// After a disk that was full HDF5 crashes when it closes its files at exit. Whoever comes here has
// told what failed, and all ranks come.
static void end_at_once(int code, void *unused)
{
    (void)unused;
    (void)fflush(NULL);
    _exit(code);
}

status hdf5_finish(hdf5_file *f)
{
    hdf5_scope s = {0};
    status st = OK;
    if (f->failed != OK) {
        st = status_fail(f->failed, "%s", f->reason);
    }
    st = hdf5_agree(st);
    if (st == OK) {
        hdf5_check(&s, H5Fflush(f->id, H5F_SCOPE_GLOBAL));
        hdf5_check(&s, H5Fclose(f->id));
        st = hdf5_agree(hdf5_leave(&s, ERR_RESOURCE, "finish", "the file"));
    }
    if (st != OK) {
        (void)on_exit(end_at_once, NULL);
    }
    free(f);
    return st;
}
