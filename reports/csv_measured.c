// reports/csv_measured.c
// measured.csv: a row per measured shape, and per error of the paper whose shape is not published;
// measured_shapes.csv: their points.
#include "reports/csv_kit.h"
#include "reports/measured_show.h"

#include <math.h>
#include <stdio.h>

static void write_errors(csv *c, const run_result *r, const measured_line *line)
{
    const shape_error none = {.tip = NAN,
                              .tip_sigma = NAN,
                              .tip_angle = NAN,
                              .tip_angle_sigma = NAN,
                              .shape = NAN,
                              .shape_sigma = NAN,
                              .mean = NAN,
                              .rms = NAN,
                              .largest = NAN,
                              .at = NAN,
                              .from = NAN,
                              .to = NAN,
                              .longer = NAN};
    const shape_error *e = line ? &line->error : &none;
    const double values[] = {e->tip,
                             e->tip_sigma,
                             e->tip / r->rod_length,
                             e->tip_angle,
                             e->tip_angle_sigma,
                             e->shape,
                             e->shape_sigma,
                             e->mean,
                             e->rms,
                             e->largest,
                             e->at,
                             e->from,
                             e->to,
                             e->longer};
    csv_reals(c, (int)(sizeof values / sizeof *values), values);
}

static void write_doubts(csv *c, const run_result *r, const measured_line *line)
{
    char words[MEASURED_NOTES] = "", better[16] = "";
    if (line) {
        measured_line_notes(r, line, words, sizeof words);
    }
    if (line && line->better >= 0) {
        (void)snprintf(better, sizeof better, "%d", line->better + 1);
    }
    csv_text(c, !line ? "" : line->turn_free ? "free" : "known");
    csv_text(c, better);
    csv_text(c, words);
}

static const char *kind_of(const run_result *r, const measured_line *line)
{
    return !line ? "not published" : r->measured.synthetic ? "synthetic" : "measured";
}

static status write_rows(const run_result *r, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    measured_row rows[MEASURED_ROWS];
    const int n = measured_rows(r, rows);
    csv_add_all(&h, "name data file turn_about_z nearer_solution notes solution_count tendon "
                    "tension_N tip_error_m "
                    "tip_error_sigma_m tip_error_of_length_ratio tip_angle_rad "
                    "tip_angle_sigma_rad shape_error_ratio "
                    "shape_error_sigma_ratio mean_distance_m rms_distance_m largest_distance_m "
                    "largest_distance_at_m from_m to_m longer_than_model_m paper_tip_error_m "
                    "paper_tip_error_of_length_ratio paper_shape_error_ratio");
    const status st = csv_table(dir, "measured.csv", &h, &c);
    for (int i = 0; st == OK && i < n; i++) {
        const measured_cells cells = measured_cells_of(r, &rows[i], " +- ");
        const paper_error *paper = rows[i].paper;
        csv_text(c, cells.name);
        csv_text(c, kind_of(r, rows[i].line));
        csv_text(c, rows[i].line ? rows[i].line->file : "");
        write_doubts(c, r, rows[i].line);
        csv_real(c, rows[i].solution + 1);
        csv_text(c, cells.tendon);
        csv_text(c, cells.tension);
        write_errors(c, r, rows[i].line);
        csv_real(c, paper ? 1e-3 * paper->tip_mm : NAN);
        csv_real(c, paper ? 1e-2 * paper->tip_percent : NAN);
        csv_real(c, paper ? 1e-2 * paper->shape_percent : NAN);
    }
    return st == OK ? csv_close(c) : st;
}

static status write_points(const run_result *r, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    csv_add_all(&h,
                "name data solution_count s_m x_m y_m z_m sigma_m model_x_m model_y_m model_z_m "
                "distance_m turn_x_per_m turn_y_per_m turn_sigma_per_m");
    const status st = csv_table(dir, "measured_shapes.csv", &h, &c);
    for (int i = 0; st == OK && i < r->measured.nline; i++) {
        const measured_line *line = &r->measured.line[i];
        for (int k = 0; k < line->npoint; k++) {
            csv_text(c, line->name);
            csv_text(c, kind_of(r, line));
            csv_real(c, line->solution + 1);
            csv_real(c, line->s[k]);
            csv_reals(c, 3, line->p[k].a);
            csv_real(c, line->sigma[k]);
            csv_reals(c, 3, line->model[k].a);
            csv_real(c, vec3_norm(vec3_sub(line->p[k], line->model[k])));
            csv_reals(c, 2, line->bend[k].a);
            csv_real(c, line->bend_sigma[k]);
        }
    }
    return st == OK ? csv_close(c) : st;
}

status csv_measured(const run_result *r, const char *dir)
{
    status st = OK;
    TRY(write_rows(r, dir));
    TRY(r->measured.nline > 0 ? write_points(r, dir) : OK);

done:
    return st;
}
