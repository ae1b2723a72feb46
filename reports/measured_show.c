// reports/measured_show.c
#include "reports/measured_show.h"

#include "reports/figure_kit.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

static const double degrees = 180 / 3.14159265358979323846;

static bool is_measured(const run_result *r, int solution)
{
    for (int i = 0; i < r->measured.nline; i++) {
        if (r->measured.line[i].solution == solution) {
            return true;
        }
    }
    return false;
}

int measured_rows(const run_result *r, measured_row rows[MEASURED_ROWS])
{
    int n = 0;
    for (int i = 0; i < r->measured.nline && n < MEASURED_ROWS; i++) {
        const measured_line *line = &r->measured.line[i];
        rows[n++] = (measured_row){line, paper_error_of(r, line->solution), line->solution};
    }
    for (int i = 0; i < r->rod.nsolution && n < MEASURED_ROWS; i++) {
        const paper_error *paper = paper_error_of(r, i);
        if (paper && !is_measured(r, i)) {
            rows[n++] = (measured_row){NULL, paper, i};
        }
    }
    return n;
}

bool measured_has_paper(const run_result *r)
{
    measured_row rows[MEASURED_ROWS];
    const int n = measured_rows(r, rows);
    for (int i = 0; i < n; i++) {
        if (rows[i].paper) {
            return true;
        }
    }
    return false;
}

// of the tendons that are pulled
static void tendon_cells(const rod_result *rod, const struct rod_run *run, measured_cells *c)
{
    for (int i = 0; i < rod->ntendon; i++) {
        const size_t used = strlen(c->tendon), taken = strlen(c->tension);
        if (run->tension[i] > 0) {
            (void)snprintf(c->tendon + used, sizeof c->tendon - used, "%s%.40s", used ? " + " : "",
                           rod->tendon_name[i]);
            (void)snprintf(c->tension + taken, sizeof c->tension - taken, "%s%.4g",
                           taken ? " + " : "", run->tension[i]);
        }
    }
    if (!c->tendon[0]) {
        (void)snprintf(c->tendon, sizeof c->tendon, "none");
        (void)snprintf(c->tension, sizeof c->tension, "0");
    }
}

// as many decimals as its uncertainty leaves, two or three
static void with_sigma(char *cell, double value, double sigma, const char *plus_minus)
{
    const int decimals = sigma > 0 && sigma < 0.02 ? 3 : 2;
    if (sigma > 0) {
        (void)snprintf(cell, MEASURED_CELL, "%.*f%s%.*f", decimals, value, plus_minus, decimals,
                       sigma);
    } else {
        (void)snprintf(cell, MEASURED_CELL, "%.*f", decimals, value);
    }
}

static void add_mark(char *cell, const char *mark)
{
    const size_t used = strlen(cell);
    (void)snprintf(cell + used, MEASURED_CELL - used, "%s", mark);
}

static void error_cells(const run_result *r, const measured_line *line, const char *plus_minus,
                        measured_cells *c)
{
    const shape_error *e = &line->error;
    const char *mark = line->turn_free ? " *" : "";
    if (isnan(e->tip)) {
        (void)snprintf(c->tip, sizeof c->tip, "not measured");
        (void)snprintf(c->angle, sizeof c->angle, "-");
    } else {
        with_sigma(c->tip, 1e3 * e->tip, 1e3 * e->tip_sigma, plus_minus);
        const size_t used = strlen(c->tip);
        (void)snprintf(c->tip + used, sizeof c->tip - used, " (%.1f)%s",
                       100 * e->tip / r->rod_length, mark);
        with_sigma(c->angle, degrees * e->tip_angle, degrees * e->tip_angle_sigma, plus_minus);
        add_mark(c->angle, mark);
    }
    with_sigma(c->shape, 100 * e->shape, 100 * e->shape_sigma, plus_minus);
    add_mark(c->shape, mark);
    (void)snprintf(c->rms, sizeof c->rms, "%.2f%s", 1e3 * e->rms, mark);
    (void)snprintf(c->largest, sizeof c->largest, "%.2f at %.1f%s", 1e3 * e->largest, 1e3 * e->at,
                   mark);
}

measured_cells measured_cells_of(const run_result *r, const measured_row *row,
                                 const char *plus_minus)
{
    measured_cells c = {.name = "", .paper_tip = "-", .paper_shape = "-"};
    tendon_cells(&r->rod, &r->rod.run[row->solution], &c);
    if (row->line) {
        (void)snprintf(c.name, sizeof c.name, "%s", row->line->name);
        error_cells(r, row->line, plus_minus, &c);
    } else {
        (void)snprintf(c.name, sizeof c.name, "%s (paper)", row->paper->prototype);
        (void)snprintf(c.tip, sizeof c.tip, "not published");
        (void)snprintf(c.shape, sizeof c.shape, "not published");
        (void)snprintf(c.rms, sizeof c.rms, "-");
        (void)snprintf(c.largest, sizeof c.largest, "-");
        (void)snprintf(c.angle, sizeof c.angle, "-");
    }
    if (row->paper) {
        (void)snprintf(c.paper_tip, sizeof c.paper_tip, "%.2f (%.1f)", row->paper->tip_mm,
                       row->paper->tip_percent);
        (void)snprintf(c.paper_shape, sizeof c.paper_shape, "%.1f", row->paper->shape_percent);
    }
    return c;
}

const char *measured_word(const run_result *r)
{
    return r->measured.nline == 0  ? "the paper's shapes"
           : r->measured.synthetic ? "synthetic shapes"
                                   : "measured shapes";
}

void measured_data_words(const run_result *r, char *text, size_t size)
{
    const measured_result *m = &r->measured;
    if (m->nline == 0) {
        (void)snprintf(text, size, "The case has no measured shapes of its own");
    } else if (m->synthetic) {
        (void)snprintf(text, size, "SYNTHETIC data, not from a bench%s%s", m->source[0] ? ": " : "",
                       m->source);
    } else {
        (void)snprintf(text, size, "Measured%s%s",
                       m->source[0] ? ": " : "; the case names no source", m->source);
    }
}

// the model's own stretch and a scanner's last step stay below this share of the length
#define WORTH_TELLING 0.02

static void add_words(char *text, size_t size, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static void add_words(char *text, size_t size, const char *format, ...)
{
    const size_t used = strlen(text);
    va_list args;
    va_start(args, format);
    if (used + 3 < size) {
        const size_t joint = used > 0 ? 2 : 0;
        memcpy(text + used, "; ", joint + 1);
        text[used + joint] = '\0';
        (void)vsnprintf(text + used + joint, size - used - joint, format, args);
    }
    va_end(args);
}

void measured_line_notes(const run_result *r, const measured_line *line, char *text, size_t size)
{
    const shape_error *e = &line->error;
    text[0] = '\0';
    if (line->turn_free) {
        add_words(
            text, size,
            "its scan is free in its turn about z, so how far and where it lies off the model "
            "(*) depends on the scan's own x, and no uncertainty is told; a mark or fiducials "
            "in the scan fix it");
    }
    if (e->longer > WORTH_TELLING * r->rod_length) {
        add_words(text, size, "longer than the model by %.1f mm; %s", 1e3 * e->longer,
                  line->tip ? "tip error from tip to tip (`tip: not_measured` where it is not the "
                              "tip where it ends)"
                            : "what lies beyond the model is not compared");
    }
    if (line->better >= 0) {
        measured_cells c = {.name = ""};
        tendon_cells(&r->rod, &r->rod.run[line->better], &c);
        add_words(text, size,
                  "it lies far nearer to solution %d (%s at %s N): rms %.2f mm instead of %.2f mm; "
                  "perhaps it is paired with the wrong "
                  "tensions",
                  line->better + 1, c.tendon, c.tension, 1e3 * line->better_rms, 1e3 * e->rms);
    }
}

const char *measured_paper_words(const run_result *r)
{
    return !measured_has_paper(r)               ? ""
           : r->measured.paper == PAPER_TABLE_2 ? "The paper's errors (Table II) are those of its "
                                                  "own model against its own measured "
                                                  "shapes, which are not published"
                                                : "The paper's errors (Table III) are those of its "
                                                  "own model against its own measured "
                                                  "shapes, which are not published";
}
