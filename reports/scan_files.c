// reports/scan_files.c
// What --out of a scan keeps.
#include "io/csv.h"
#include "measure/line_file.h"
#include "reports/csv_kit.h"
#include "reports/scan_report.h"

#include <errno.h>
#include <string.h>

static FILE *open_file(const char *dir, const char *name, char *path, size_t room)
{
    (void)snprintf(path, room, "%s/%s", dir, name);
    return fopen(path, "wx");
}

static status close_file(FILE *f, const char *path)
{
    const bool sound = f && !ferror(f);
    const bool closed = f && fclose(f) == 0;
    return sound && closed
               ? OK
               : status_fail(ERR_RESOURCE, "%s: cannot write it: %s", path, strerror(errno));
}

// what reads it as a shape says so too
static void write_notes(const scan_result *r, csv *c)
{
    char words[80];
    if (r->synthetic) {
        csv_remark(c, "SYNTHETIC: made, not measured");
    }
    if (r->turn_free) {
        csv_remark(c, "the frame is " LINE_TURN_FREE);
    }
    if (r->line.correlation_length > 0) {
        (void)snprintf(words, sizeof words, "correlation_length_mm: %.4g",
                       1e3 * r->line.correlation_length);
        csv_remark(c, words);
    }
}

static status write_csv(const scan_result *r, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    csv_add_all(&h, "s_mm x_mm y_mm z_mm sigma_mm fit_sigma_mm");
    const status st = csv_table(dir, "centreline.csv", &h, &c);
    if (st == OK) {
        write_notes(r, c);
    }
    char remark[SCAN_REMARKS][SCAN_REMARK_ROOM];
    const int nremark = st == OK ? scan_remarks(r, remark) : 0;
    for (int i = 0; i < nremark; i++) {
        csv_remark(c, remark[i]);
    }
    for (int i = 0; st == OK && i < r->line.count; i++) {
        csv_real(c, 1e3 * r->line.s[i]);
        for (int d = 0; d < 3; d++) {
            csv_real(c, 1e3 * r->line.p[i].a[d]);
        }
        csv_real(c, 1e3 * r->line.sigma[i]);
        csv_real(c, 1e3 * r->fit_sigma[i]);
    }
    return st == OK ? csv_close(c) : st;
}

// legacy VTK: one line with sigma at its points
static status write_vtk(const scan_result *r, const char *dir)
{
    char path[4096];
    const centreline *c = &r->line;
    FILE *f = open_file(dir, "centreline.vtk", path, sizeof path);
    if (f) {
        fprintf(f,
                "# vtk DataFile Version 3.0\ncentreline of a scan%s, m\nASCII\nDATASET POLYDATA\n",
                r->synthetic ? " (synthetic)" : "");
        fprintf(f, "POINTS %d double\n", c->count);
        for (int i = 0; i < c->count; i++) {
            fprintf(f, "%.9g %.9g %.9g\n", c->p[i].a[0], c->p[i].a[1], c->p[i].a[2]);
        }
        fprintf(f, "LINES 1 %d\n%d", c->count + 1, c->count);
        for (int i = 0; i < c->count; i++) {
            fprintf(f, " %d", i);
        }
        fprintf(f, "\nPOINT_DATA %d\nSCALARS sigma_m double 1\nLOOKUP_TABLE default\n", c->count);
        for (int i = 0; i < c->count; i++) {
            fprintf(f, "%.6g\n", c->sigma[i]);
        }
    }
    return close_file(f, path);
}

static status write_json(const scan_named *scan, const char *dir)
{
    char path[4096];
    json *j = NULL;
    FILE *f = open_file(dir, "scan.json", path, sizeof path);
    status st = f ? json_open(f, &j) : OK;
    if (f && st == OK) {
        st = scan_json(j, scan->result, scan->name);
        const status closed = json_close(j);
        st = st == OK ? closed : st;
    }
    const status closed = close_file(f, path);
    return st == OK ? closed : st;
}

status scan_files(const char *directory, const void *named)
{
    status st = OK;
    const scan_named *scan = named;
    TRY(write_csv(scan->result, directory));
    TRY(write_vtk(scan->result, directory));
    TRY(write_json(scan, directory));
    TRY(figure_scan(scan, directory));

done:
    return st;
}
