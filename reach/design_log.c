// reach/design_log.c
#include "reach/design_log.h"

#include "base/input_file.h"
#include "base/memory.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
    LINE = 1024,
    PATH = 4096,
    LARGEST = 256 << 20, // of a log file [bytes]: some 1e6 lines
    MOST_PARTS = 100000,
};

static const char magic[] = "# stiffaxis design log 1 ";

static void head_of(const design_problem *p, char words[LINE])
{
    (void)snprintf(words, LINE, "%s%016llx%016llx %d\n", magic, (unsigned long long)p->problem.a,
                   (unsigned long long)p->problem.b, p->nparameter);
}

// by x; -0 and 0 are different places, as are all that differ in a bit
static int by_x(int n, const double *a, const double *b)
{
    return memcmp(a, b, (size_t)n * sizeof *a);
}

static int compare(const void *a, const void *b)
{
    return by_x(DESIGN_MOST, ((const design_trial *)a)->x, ((const design_trial *)b)->x);
}

// --- reading

// the number at *at, behind which `end` stands; *at goes beyond
static bool read_number(const char **at, char end, double *out)
{
    char *rest = NULL;
    *out = strtod(*at, &rest);
    const bool fine = rest != *at && *rest == end;
    *at = rest + fine;
    return fine;
}

// whether a score is one that goes with its goal, up to the rounding of their sums
static bool fits(const design_problem *p, double goal, double score)
{
    const double least = p->per_goal * goal, rounding = 1e-12 * (1 + fabs(least));
    return isnan(score)
               ? isnan(goal)
               : goal >= 0 && isfinite(score) && score >= 0 &&
                     (p->per_goal <= 0 || (score >= least - rounding && score < least + 1));
}

static bool read_trial(const design_problem *p, const char *line, design_trial *out)
{
    const int n = p->nparameter;
    double island = 0, evaluation = 0;
    bool fine = read_number(&line, ',', &island) && read_number(&line, ',', &evaluation) &&
                read_number(&line, ',', &out->goal) && read_number(&line, ',', &out->score);
    for (int i = 0; i < n && fine; i++) {
        fine = read_number(&line, i + 1 < n ? ',' : '\n', &out->x[i]) && isfinite(out->x[i]);
    }
    fine = fine && island >= 0 && island < DESIGN_MOST_ISLANDS && evaluation >= 1 &&
           evaluation <= DESIGN_MOST_EVALUATIONS && fits(p, out->goal, out->score);
    if (fine) {
        out->island = (int)island;
        out->evaluation = (int)evaluation;
    }
    return fine;
}

// *begun: whether there is more than a part of this search's own first line
static status check_head(const design_problem *p, const input_file *f, bool *begun)
{
    char head[LINE];
    head_of(p, head);
    *begun = f->count >= strlen(head) || memcmp(f->bytes, head, f->count) != 0;
    if (!*begun) {
        return OK;
    }
    if (!input_file_begins(f, magic)) {
        return input_file_fail(f, 0,
                               "is there already and is no log of a design search: not touched");
    }
    if (strncmp((const char *)f->bytes, head, strlen(head)) != 0) {
        return status_fail(ERR_INPUT,
                           "%s: belongs to the search of another case, or of this case as it was "
                           "before: remove it to begin anew",
                           f->path);
    }
    return OK;
}

static status read_lines(const design_problem *p, const input_file *f, design_log *l, size_t *whole)
{
    status st = OK;
    const char *text = (const char *)f->bytes, *at = text;
    design_trial *more = NULL;
    int count = 0;
    long line = 1;
    for (const char *c = text; (c = strchr(c, '\n')); c++) {
        count++;
    }
    TRY(TAKE(more, (size_t)(l->ntrial + count)));
    if (l->ntrial > 0) {
        memcpy(more, l->trial, (size_t)l->ntrial * sizeof *more);
    }
    free(l->trial);
    l->trial = more;
    for (const char *end; (end = strchr(at, '\n')); at = end + 1, line++) {
        design_trial *t = &l->trial[l->ntrial];
        if (line > 1 && !read_trial(p, at, t)) {
            TRY(input_file_fail(f, line, "is no line of a design search with %d parameters",
                                l->nparameter));
        }
        l->ntrial += line > 1;
    }
    *whole = (size_t)(at - text);

done:
    return st;
}

// bytes of a log as it was read
typedef struct part {
    size_t whole; // up to the end of the last whole line; 0: there is no file, or nothing in it
    size_t all;
} part;

static status read_part(const design_problem *p, const char *path, design_log *l, part *out)
{
    status st = OK;
    bool begun = false;
    struct stat about;
    input_file f = {0};
    const key_text name = {.text = path};
    *out = (part){0};
    if (stat(path, &about) != 0 && errno == ENOENT) {
        return OK;
    }
    // other ranks write on theirs meanwhile
    TRY(input_file_read_so_far(NULL, &name, LARGEST, &f));
    TRY(check_head(p, &f, &begun));
    if (begun) {
        TRY(read_lines(p, &f, l, &out->whole));
    }
    out->all = f.count;

done:
    input_file_free(&f);
    return st;
}

static status part_path(const char *log, int rank, char path[PATH])
{
    const int n =
        rank > 0 ? snprintf(path, PATH, "%s.%d", log, rank) : snprintf(path, PATH, "%s", log);
    return n < PATH ? OK : status_fail(ERR_INPUT, "the name of the log is too long");
}

// those of this run's ranks, and of a run of more ranks before it
static status read_parts(const design_problem *p, const ranks *r, design_log *l, part *own)
{
    status st = OK;
    char path[PATH];
    part read = {.whole = 1};
    for (int i = 0; i < MOST_PARTS && (i < r->size || read.whole > 0); i++) {
        TRY(part_path(p->log, i, path));
        TRY(read_part(p, path, l, &read));
        *own = i == r->rank ? read : *own;
    }

done:
    return st;
}

// --- writing

static status cannot(const char *path)
{
    return status_fail(ERR_RESOURCE, "%s: cannot write it: %s", path, strerror(errno));
}

// one call of the system: lines of several workers do not mix
static status write_line(int file, const char *line, const char *path)
{
    const size_t size = strlen(line);
    ssize_t n = 0;
    do {
        n = write(file, line, size);
    } while (n < 0 && errno == EINTR);
    errno = n >= 0 && (size_t)n < size ? ENOSPC : errno;
    return n >= 0 && (size_t)n == size ? OK : cannot(path);
}

// Held until the last worker has ended. Where the file system knows no locks, none is held.
static status lock(int file, const char *path, const part *read)
{
    struct stat about;
    const bool held = flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    // or one that wrote since this log was read has ended by now
    if (held ||
        (fstat(file, &about) == 0 && S_ISREG(about.st_mode) && about.st_size != (off_t)read->all)) {
        return status_fail(ERR_RESOURCE,
                           "%s: another design search is writing this log: wait for it, or give "
                           "this one another --out",
                           path);
    }
    return OK;
}

static status begin_writing(const design_problem *p, const ranks *r, const part *read,
                            design_log *l)
{
    status st = OK;
    char path[PATH], head[LINE];
    TRY(part_path(p->log, r->rank, path));
    l->file = open(path, O_WRONLY | O_APPEND | O_CREAT | O_NONBLOCK | O_CLOEXEC, 0666);
    if (l->file < 0) {
        TRY(cannot(path));
    }
    TRY(lock(l->file, path, read));
    if (ftruncate(l->file, (off_t)read->whole) != 0) {
        TRY(cannot(path));
    }
    if (read->whole == 0) {
        head_of(p, head);
        TRY(write_line(l->file, head, path));
    }

done:
    return st;
}

status design_log_open(const design_problem *p, const ranks *r, design_log *out)
{
    status st = OK;
    part own = {0};
    design_log l = {.nparameter = p->nparameter, .file = -1};
    if (p->log) {
        TRY(read_parts(p, r, &l, &own));
        if (l.ntrial > 0) {
            qsort(l.trial, (size_t)l.ntrial, sizeof *l.trial, compare);
        }
        TRY(begin_writing(p, r, &own, &l));
    }
    *out = l;
    l = (design_log){.file = -1};

done:
    design_log_close(&l);
    return st;
}

void design_log_close(design_log *l)
{
    if (l->file >= 0) {
        (void)close(l->file);
    }
    free(l->trial);
    *l = (design_log){.file = -1};
}

const design_trial *design_log_find(const design_log *l, const double *x)
{
    int low = 0, high = l->ntrial;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        const int order = by_x(l->nparameter, x, l->trial[middle].x);
        if (order == 0) {
            return &l->trial[middle];
        }
        low = order > 0 ? middle + 1 : low;
        high = order > 0 ? high : middle;
    }
    return NULL;
}

status design_log_add(const design_log *l, const design_trial *t)
{
    char line[LINE];
    int n = snprintf(line, sizeof line, "%d,%d,%.17g,%.17g", t->island, t->evaluation, t->goal,
                     t->score);
    if (l->file < 0) {
        return OK;
    }
    for (int i = 0; i < l->nparameter; i++) {
        n += snprintf(line + n, sizeof line - (size_t)n, ",%.17g", t->x[i]);
    }
    (void)snprintf(line + n, sizeof line - (size_t)n, "\n");
    return write_line(l->file, line, "the log of the design search");
}
