// app/cmd_scan.c
// stiffaxis scan CLOUD: points of a tube to its centreline in the rod's frame.
#include "app/answer.h"
#include "app/command.h"
#include "app/save.h"
#include "base/memory.h"
#include "io/config.h"
#include "reports/scan_report.h"

#include <fcntl.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// a file of settings; or only what --set says, beside a cloud
typedef struct scan_file {
    mark at;
    int format;
    const char *title;
    scan_settings scan;
} scan_file;

static const key file_keys[] = {
    {.name = "format",
     .kind = KEY_INTEGER,
     .min = 1,
     .max = 1,
     .required = true,
     .offset = offsetof(scan_file, format),
     .about = "version of the format; this program reads 1"},
    {.name = "title",
     .kind = KEY_TEXT,
     .offset = offsetof(scan_file, title),
     .about = "one line for the report"},
    {.name = "scan",
     .kind = KEY_TABLE,
     .required = true,
     .offset = offsetof(scan_file, scan),
     .table = &scan_keys,
     .about = "a cloud of points and what is known of it"},
};

typedef struct scan_job {
    command *cmd;
    config *config;
    scan_file file;
    char path[PATH_MAX];   // of the cloud
    const char **override; // of --set, each with its `scan.` ...
    char **prefixed;       // ... which was added to these
    const char *doing;
    int percent;
} scan_job;

// Whether the first lines of a regular file are those of settings, not of a cloud.
static bool is_settings(const char *path)
{
    char text[4096];
    struct stat about;
    bool found = strcmp(path, "-") == 0;
    const int file = found ? -1 : open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (file < 0) {
        return found;
    }
    const bool regular = fstat(file, &about) == 0 && S_ISREG(about.st_mode);
    const ssize_t n = regular ? read(file, text, sizeof text - 1) : 0;
    text[n > 0 ? n : 0] = '\0';
    (void)close(file);
    for (const char *line = text; line && !found; line = strchr(line, '\n')) {
        line += *line == '\n';
        found = strncmp(line, "format:", 7) == 0 || strncmp(line, "scan:", 5) == 0;
    }
    return found;
}

static status join_cloud(scan_job *job, bool settings)
{
    const char *path = job->cmd->argument, *slash = strrchr(path, '/');
    const key_text *cloud = &job->file.scan.cloud;
    if (!settings) {
        (void)snprintf(job->path, sizeof job->path, "%s", path);
        return cloud->text
                   ? config_fail(job->config, cloud->at, "the cloud is %.200s already", path)
                   : OK;
    }
    if (!cloud->text || cloud->text[0] == '\0') {
        return config_fail(job->config, job->file.scan.at, "scan.cloud names no file");
    }
    const bool alone = cloud->text[0] == '/' || !slash;
    const int length = alone ? 0 : (int)(slash - path) + 1;
    (void)snprintf(job->path, sizeof job->path, "%.*s%s", length, path, cloud->text);
    return OK;
}

// Without a file of settings all is about the scan: `radius_mm=4` is `scan.radius_mm=4`.
static status add_prefix(scan_job *job)
{
    static const char *const whole[] = {"scan.", "scan=", "title=", "format="};
    status st = OK;
    const command *cmd = job->cmd;
    TRY(TAKE(job->override, (size_t)cmd->noverride + 1));
    TRY(TAKE(job->prefixed, (size_t)cmd->noverride + 1));
    for (int i = 0; i < cmd->noverride; i++) {
        const char *text = cmd->overrides[i];
        bool is_whole = false;
        for (int k = 0; k < 4; k++) {
            is_whole = is_whole || strncmp(text, whole[k], strlen(whole[k])) == 0;
        }
        job->override[i] = text;
        if (!is_whole) {
            const size_t size = strlen(text) + sizeof "scan.";
            TRY(TAKE(job->prefixed[i], size));
            (void)snprintf(job->prefixed[i], size, "scan.%s", text);
            job->override[i] = job->prefixed[i];
        }
    }

done:
    return st;
}

static void free_prefixed(scan_job *job)
{
    for (int i = 0; job->prefixed && i < job->cmd->noverride; i++) {
        free(job->prefixed[i]);
    }
    free(job->prefixed);
    free(job->override);
}

static status open_settings(scan_job *job)
{
    status st = OK;
    const command *cmd = job->cmd;
    const bool settings = is_settings(cmd->argument);
    const scan_file initial = {.scan = *(const scan_settings *)scan_keys.initial};
    key_table root = {.name = "scan_file",
                      .size = sizeof(scan_file),
                      .nkey = (int)(sizeof file_keys / sizeof *file_keys),
                      .keys = file_keys,
                      .initial = &initial,
                      .about = "a scan"};
    TRY(add_prefix(job));
    if (settings) {
        TRY(config_open(cmd->argument, cmd->noverride, job->override, &job->config));
    } else {
        TRY(config_open_text(cmd->argument, "format: 1\nscan: {}\n", cmd->noverride, job->override,
                             &job->config));
    }
    TRY(config_read(job->config, &root, &job->file));
    TRY(join_cloud(job, settings));

done:
    return st;
}

static void tell(void *context, double share)
{
    scan_job *job = context;
    const int percent = (int)(100 * share);
    char words[80];
    if (percent != job->percent) {
        (void)snprintf(words, sizeof words, "%s %d %%", job->doing, percent);
        command_progress(job->cmd, words);
        job->percent = percent;
    }
}

// the file that a message of ERR_FILE is about, or the place of a key
static status place(const scan_job *job, status st)
{
    char words[800];
    mark at = {0, 0};
    const bool placed = status_place(&at.line, &at.column);
    if (st == OK || (!placed && st != ERR_FILE && st != ERR_NUMERIC) ||
        strstr(status_message(), ": error: ") || strstr(status_message(), job->path)) {
        return st;
    }
    (void)snprintf(words, sizeof words, "%s", status_message());
    status_clear();
    return placed ? config_fail(job->config, at, "%s", words)
                  : status_fail(st, "%.300s: %s", job->path, words);
}

static status measure(scan_job *job, scan_result *out)
{
    status st = OK;
    point_cloud cloud = {0};
    const scan_settings *s = &job->file.scan;
    const cloud_read_options read = {.unit = scan_unit(s->unit), .progress = tell, .context = job};
    job->doing = "reading";
    job->percent = -1;
    TRY(cloud_read(job->path, &read, &cloud, &out->cloud));
    job->doing = "following the body";
    job->percent = -1;
    TRY(scan_measure(&cloud, job->path, s, (scan_progress){tell, job}, out));

done:
    point_cloud_free(&cloud);
    return place(job, st);
}

static status show(scan_job *job, const scan_result *r)
{
    status st = OK;
    json *j = NULL;
    if (!job->cmd->json) {
        scan_print(r, job->path, stdout);
        return OK;
    }
    TRY(answer_open(job->cmd, &j));
    st = scan_json(j, r, job->path);
    const status closed = json_close(j);
    st = st == OK ? closed : st;

done:
    return st;
}

static void warn_unit(const command *cmd, const char *path, const scan_result *r)
{
    char words[200];
    if (scan_unit_doubt(r->line.radius, r->tube.length, r->cloud.unit, words, sizeof words)[0] &&
        cmd->first_rank) {
        fprintf(stderr, "%.300s: warning: %s\n", path, words);
    }
}

status cmd_scan(command *cmd)
{
    status st = OK;
    scan_job job = {.cmd = cmd};
    scan_result r = {0};
    TRY(open_settings(&job));
    TRY(save_check(cmd));
    TRY(measure(&job, &r));
    TRY(save_files(cmd, scan_files, &(scan_named){&r, job.path}));
    command_progress(cmd, NULL);
    TRY(show(&job, &r));
    TRY(command_flush());
    warn_unit(cmd, job.path, &r);
    if (cmd->out) {
        command_hint(cmd, "written: %s/centreline.csv, scan.png", cmd->out);
    } else {
        command_hint(cmd, "nothing was written: --out DIR keeps the centreline and a picture");
    }

done:
    scan_result_free(&r);
    config_free(job.config);
    free_prefixed(&job);
    return st;
}
