// app/cmd_report.c
// stiffaxis report RESULT: figures, tables and page from a stored result, nothing recomputed.
#include "app/answer.h"
#include "app/command.h"
#include "app/save.h"
#include "io/disk.h"
#include "io/marker.h"
#include "reports/figures.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { MAX_PATH = 4096 };

// RESULT is the file, or the directory that holds it
static status result_file(const char *given, char *path, size_t size)
{
    struct stat about;
    const bool directory = stat(given, &about) == 0 && S_ISDIR(about.st_mode);
    const int length = snprintf(path, size, "%s%s", given, directory ? "/result.hdf" : "");
    if (length < 0 || (size_t)length >= size) {
        return status_fail(ERR_INPUT, "the path is longer than %zu bytes", size);
    }
    return OK;
}

// the directory that holds the file, by a name that something can be appended to
static status holder(const char *path, char *directory, size_t size)
{
    status st = OK;
    char real[PATH_MAX];
    TRY(disk_parent(path, directory, size));
    for (size_t n = strlen(directory); n > 1 && directory[n - 1] == '/'; n--) {
        directory[n - 1] = '\0';
    }
    const char *slash = strrchr(directory, '/'), *last = slash ? slash + 1 : directory;
    if (strcmp(last, ".") == 0 || strcmp(last, "..") == 0) {
        if (!realpath(directory, real)) {
            return status_fail(ERR_INPUT, "%s: cannot open: %s", path, strerror(errno));
        }
        TRY(disk_join(directory, size, "%s", real));
    }

done:
    return st;
}

// Beside what a run wrote, never inside: a directory of results holds what its run wrote and
// nothing else.
static status default_directory(const char *path, char *directory, size_t size)
{
    status st = OK;
    char where[MAX_PATH];
    size_t stem = strlen(path);
    TRY(holder(path, where, sizeof where));
    if (marker_is_there(where)) {
        return disk_join(directory, size, "%s-report", where);
    }
    stem -= stem > 4 && strcmp(path + stem - 4, ".hdf") == 0 ? 4 : 0;
    TRY(disk_join(directory, size, "%.*s-report", (int)stem, path));

done:
    return st;
}

static status show(command *cmd, const char *directory, const run_result *r)
{
    status st = OK;
    json *j = NULL;
    if (!cmd->json) {
        return report_summary(r, cmd->summary_lines, stdout);
    }
    TRY(answer_open(cmd, &j));
    json_object(j, NULL);
    json_text(j, "schema", "stiffaxis/report/1");
    json_text(j, "title", r->title);
    json_text(j, "directory", directory);
    json_object_end(j);
    st = json_close(j);

done:
    return st;
}

status cmd_report(command *cmd)
{
    status st = OK;
    char path[MAX_PATH], beside[MAX_PATH];
    run_result r = {0};
    TRY(result_file(cmd->argument, path, sizeof path));
    TRY(default_directory(path, beside, sizeof beside));
    const char *directory = cmd->out ? cmd->out : beside;
    TRY(result_store_read(path, &r));
    TRY(save_report(cmd, directory, &r));
    TRY(show(cmd, directory, &r));
    TRY(command_flush());
    command_hint(cmd, "written: %s/report.html", directory);

done:
    run_result_free(&r);
    return st;
}
