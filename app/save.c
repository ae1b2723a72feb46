// app/save.c
#include "app/save.h"

#include "app/interrupt.h"
#include "app/versions.h"
#include "base/door.h"
#include "io/outdir.h"
#include "reports/figures.h"

#include <errno.h>
#include <string.h>

enum { MAX_PATH = 4096 };

// What one kind of saving writes into the directory.
typedef struct contents {
    run_result *result; // store and tables; NULL: not wanted
    const run_result *report;
    const char *name, *text; // one text; NULL: none
    size_t length;
    save_write *write; // NULL: nothing of its own
    const void *data;
} contents;

status save_check(const command *cmd)
{
    status st = OK;
    outdir *d = NULL;
    if (!cmd->out || !cmd->first_rank) {
        return OK;
    }
    interrupt_hold();
    st = outdir_open(cmd->out, cmd->force, &d);
    outdir_abandon(d);
    const status interrupted = interrupt_release();
    return interrupted != OK ? interrupted : st;
}

static status write_text(const outdir *d, const char *name, const char *text, size_t length)
{
    status st = OK;
    char path[MAX_PATH];
    TRY(outdir_path(d, name, path, sizeof path));
    FILE *file = fopen(path, "wx");
    const bool written = file && fwrite(text, 1, length, file) == length;
    const bool closed = file && fclose(file) == 0;
    if (!written || !closed) {
        st = status_fail(ERR_RESOURCE, "%s: cannot write it: %s", path, strerror(errno));
    }

done:
    return st;
}

static status still_wanted(void)
{
    return interrupt_pending() ? status_fail(ERR_INTERRUPTED, "interrupted") : OK;
}

static status write_store(run_result *r, const char *path)
{
    status st = OK;
    door_function loaded;
    TRY(door_open("hdf5", "H5get_libversion", &loaded)); // so that its version is told too
    versions_loaded(r->versions, sizeof r->versions);
    TRY(result_store_write(r, path));

done:
    return st;
}

// what the other ranks of an mpirun write: their levels of a segment, into the first one's file
static status join_store(run_result *r)
{
    return r->has_segment && r->segment.body.shared ? write_store(r, NULL) : OK;
}

static status write_contents(const outdir *d, const contents *what)
{
    status st = OK;
    char path[MAX_PATH], directory[MAX_PATH];
    TRY(outdir_path(d, "result.hdf", path, sizeof path));
    (void)snprintf(directory, sizeof directory, "%.*s", (int)(strrchr(path, '/') - path), path);
    if (what->result) {
        TRY(write_store(what->result, path));
        TRY(still_wanted());
        const char *fitted = what->result->fitted_case, *designed = what->result->designed_case;
        TRY(fitted ? write_text(d, "fitted.yaml", fitted, strlen(fitted)) : OK);
        TRY(designed ? write_text(d, "designed.yaml", designed, strlen(designed)) : OK);
        TRY(write_text(d, "case.yaml", what->result->case_text, what->result->case_length));
    }
    if (what->report) {
        TRY(result_csv(what->report, directory));
        TRY(figures_all(what->report, directory));
        TRY(still_wanted());
        TRY(report_page(what->report, directory));
    }
    if (what->name) {
        TRY(write_text(d, what->name, what->text, what->length));
    }
    TRY(what->write ? what->write(directory, what->data) : OK);
    TRY(still_wanted());

done:
    return st;
}

static status save(const char *path, bool force, const contents *what)
{
    status st = OK;
    outdir *d = NULL;
    interrupt_hold();
    TRY(outdir_open(path, force, &d));
    TRY(write_contents(d, what));
    outdir *whole = d;
    d = NULL; // outdir_commit frees it
    TRY(outdir_commit(whole));

done:
    outdir_abandon(d);
    // when all is written, a late Ctrl-C has nothing left to interrupt
    const status interrupted = interrupt_release();
    return st == OK && interrupted != OK ? interrupted : st;
}

status save_result(const command *cmd, run_result *r)
{
    if (!cmd->out) {
        return OK;
    }
    if (!cmd->first_rank) {
        return join_store(r);
    }
    command_progress(cmd, "writing");
    return save(cmd->out, cmd->force, &(contents){.result = r, .report = r});
}

status save_report(const command *cmd, const char *directory, const run_result *r)
{
    if (!cmd->first_rank) {
        return OK;
    }
    command_progress(cmd, "writing");
    return save(directory, cmd->force, &(contents){.report = r});
}

status save_files(const command *cmd, save_write *write, const void *data)
{
    if (!cmd->out || !cmd->first_rank) {
        return OK;
    }
    command_progress(cmd, "writing");
    return save(cmd->out, cmd->force, &(contents){.write = write, .data = data});
}

status save_text(const command *cmd, const char *name, const char *text, size_t length)
{
    if (!cmd->out || !cmd->first_rank) {
        return OK;
    }
    return save(cmd->out, cmd->force, &(contents){.name = name, .text = text, .length = length});
}
