// reports/json_measured.c
// "measured": the model's errors against measured shapes; inside the comparison's document.
#include "reports/json_parts.h"
#include "reports/measured_show.h"

#include <math.h>

static void write_paper(json *j, const paper_error *paper)
{
    if (!paper) {
        json_null(j, "paper");
        return;
    }
    json_object(j, "paper");
    json_text(j, "prototype", paper->prototype);
    json_real(j, "tip_error_m", 1e-3 * paper->tip_mm);
    json_real(j, "tip_error_of_length", 1e-2 * paper->tip_percent);
    json_real(j, "shape_error", 1e-2 * paper->shape_percent);
    json_object_end(j);
}

static void write_errors(json *j, const run_result *r, const measured_line *line)
{
    const shape_error *e = &line->error;
    json_flag(j, "tip_measured", line->tip);
    json_flag(j, "turn_free", line->turn_free);
    if (line->better >= 0) {
        json_integer(j, "nearer_solution", line->better + 1);
        json_real(j, "nearer_solution_rms_distance_m", line->better_rms);
    } else {
        json_null(j, "nearer_solution");
    }
    json_real(j, "from_m", e->from);
    json_real(j, "to_m", e->to);
    json_real(j, "longer_than_model_m", e->longer);
    json_real(j, "tip_error_m", e->tip);
    json_real(j, "tip_error_sigma_m", e->tip_sigma);
    json_real(j, "tip_error_of_length", e->tip / r->rod_length);
    json_real(j, "tip_angle_rad", e->tip_angle);
    json_real(j, "tip_angle_sigma_rad", e->tip_angle_sigma);
    json_real(j, "shape_error", e->shape);
    json_real(j, "shape_error_sigma", e->shape_sigma);
    json_real(j, "mean_distance_m", e->mean);
    json_real(j, "rms_distance_m", e->rms);
    json_real(j, "largest_distance_m", e->largest);
    json_real(j, "largest_distance_at_s_m", e->at);
    json_real(j, "base_distance_m", e->base);
}

static void write_points(json *j, const measured_line *line)
{
    json_array(j, "points");
    for (int i = 0; i < line->npoint; i++) {
        json_object(j, NULL);
        json_real(j, "s_m", line->s[i]);
        json_reals(j, "p_m", 3, line->p[i].a);
        json_real(j, "sigma_m", line->sigma[i]);
        json_reals(j, "model_p_m", 3, line->model[i].a);
        json_reals(j, "turn_per_m", 3, line->bend[i].a);
        json_real(j, "turn_sigma_per_m", line->bend_sigma[i]);
        json_object_end(j);
    }
    json_array_end(j);
}

static void write_row(json *j, const run_result *r, const measured_row *row)
{
    const struct rod_run *run = &r->rod.run[row->solution];
    json_object(j, NULL);
    json_flag(j, "published", row->line != NULL); // false: only the paper's own errors are known
    json_integer(j, "solution", row->solution + 1);
    json_reals(j, "tensions_N", r->rod.ntendon, run->tension);
    if (row->line) {
        char words[MEASURED_NOTES];
        measured_line_notes(r, row->line, words, sizeof words);
        json_text(j, "notes", words);
        json_text(j, "name", row->line->name);
        json_text(j, "file", row->line->file);
        json_flag(j, "synthetic", r->measured.synthetic);
        write_errors(j, r, row->line);
    }
    write_paper(j, row->paper);
    if (row->line) {
        write_points(j, row->line);
    }
    json_object_end(j);
}

void result_json_measured(json *j, const char *key, const run_result *r)
{
    static const char *const tables[] = {"none", "table_2", "table_3"};
    static const char *const arclengths[] = {"measured", "rest"};
    measured_row rows[MEASURED_ROWS];
    const int n = measured_rows(r, rows);
    json_object(j, key);
    json_text(j, "schema", "stiffaxis/measured/1");
    json_flag(j, "synthetic", r->measured.synthetic);
    json_text(j, "source", r->measured.source);
    json_text(j, "paper", tables[r->measured.paper]);
    json_text(j, "arclength", arclengths[r->measured.arclength]);
    json_real(j, "tolerance", r->measured.tolerance > 0 ? r->measured.tolerance : NAN);
    json_real(j, "turn_window_m", r->measured.window);
    json_array(j, "shapes");
    for (int i = 0; i < n; i++) {
        write_row(j, r, &rows[i]);
    }
    json_array_end(j);
    json_object_end(j);
}
