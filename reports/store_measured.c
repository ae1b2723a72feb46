// reports/store_measured.c
#include "reports/store_parts.h"

#include <stdio.h>

enum { MOST_LINE_POINTS = 100000 };

#define LINE(member) offsetof(measured_line, member)
#define ERROR_OF(member) offsetof(measured_line, error.member)

static status pass_errors(const passage *p, measured_result *m)
{
    static const column columns[] = {
        {"name", COLUMN_TEXT, "-", LINE(name), 0, {MEASURED_NAME}, 0},
        {"file", COLUMN_TEXT, "-", LINE(file), 0, {MEASURED_NAME}, 0},
        {"tip_measured", COLUMN_FLAG, "-", LINE(tip), 0, {0}, 0},
        {"turn_free", COLUMN_FLAG, "-", LINE(turn_free), 0, {0}, 0},
        {"better_rms_m", COLUMN_KNOWN, "m", LINE(better_rms), 0, {0}, 0},
        {"from_m", COLUMN_REAL, "m", ERROR_OF(from), 0, {0}, 0},
        {"to_m", COLUMN_REAL, "m", ERROR_OF(to), 0, {0}, 0},
        {"longer_m", COLUMN_REAL, "m", ERROR_OF(longer), 0, {0}, 0},
        {"tip_error_m", COLUMN_KNOWN, "m", ERROR_OF(tip), 0, {0}, 0},
        {"tip_error_sigma_m", COLUMN_KNOWN, "m", ERROR_OF(tip_sigma), 0, {0}, 0},
        {"tip_angle_rad", COLUMN_KNOWN, "rad", ERROR_OF(tip_angle), 0, {0}, 0},
        {"tip_angle_sigma_rad", COLUMN_KNOWN, "rad", ERROR_OF(tip_angle_sigma), 0, {0}, 0},
        {"shape_error", COLUMN_REAL, "-", ERROR_OF(shape), 0, {0}, 0},
        {"shape_error_sigma", COLUMN_KNOWN, "-", ERROR_OF(shape_sigma), 0, {0}, 0},
        {"mean_m", COLUMN_REAL, "m", ERROR_OF(mean), 0, {0}, 0},
        {"rms_m", COLUMN_REAL, "m", ERROR_OF(rms), 0, {0}, 0},
        {"largest_m", COLUMN_REAL, "m", ERROR_OF(largest), 0, {0}, 0},
        {"largest_at_m", COLUMN_REAL, "m", ERROR_OF(at), 0, {0}, 0},
        {"base_m", COLUMN_KNOWN, "m", ERROR_OF(base), 0, {0}, 0},
    };
    return passage_columns(p, "measured/shape", COUNT_OF(columns), columns,
                           rows_of(m->line, m->nline, sizeof *m->line));
}

static status pass_points(const passage *p, int i, int nsolution, measured_line *line)
{
    static const column s = {"s_m", COLUMN_REAL, "m", 0, 0, {0}, 0};
    static const column sigma = {"sigma_m", COLUMN_KNOWN, "m", 0, 0, {0}, 0};
    static const column measured = {"p_m", COLUMN_REAL, "m", 0, 1, {3}, 0};
    static const column model = {"model_p_m", COLUMN_REAL, "m", 0, 1, {3}, 0};
    static const column bend = {"turn_per_m", COLUMN_KNOWN, "1/m", 0, 1, {3}, 0};
    static const column bend_sigma = {"turn_sigma_per_m", COLUMN_KNOWN, "1/m", 0, 0, {0}, 0};
    status st = OK;
    char group[48];
    int n = line->npoint;
    (void)snprintf(group, sizeof group, "measured/shape/%d", i);
    const passage_name count = passage_join(group, "point_count");
    const passage_name solution = passage_join(group, "solution");
    int better = line->better + 1; // 0: none
    TRY(passage_count(p, solution.text, 0, nsolution - 1, &line->solution));
    TRY(passage_count(p, passage_join(group, "better_solution").text, 0, nsolution, &better));
    line->better = better - 1;
    TRY(passage_count(p, count.text, 2, MOST_LINE_POINTS, &n));
    TRY(p->reading ? measured_line_room(line, n) : OK);
    TRY(passage_columns(p, group, 1, &s, rows_of(line->s, n, sizeof *line->s)));
    TRY(passage_columns(p, group, 1, &sigma, rows_of(line->sigma, n, sizeof *line->sigma)));
    TRY(passage_columns(p, group, 1, &measured, rows_of(line->p, n, sizeof *line->p)));
    TRY(passage_columns(p, group, 1, &model, rows_of(line->model, n, sizeof *line->model)));
    TRY(passage_columns(p, group, 1, &bend, rows_of(line->bend, n, sizeof *line->bend)));
    TRY(passage_columns(p, group, 1, &bend_sigma,
                        rows_of(line->bend_sigma, n, sizeof *line->bend_sigma)));

done:
    return st;
}

status store_pass_measured(const passage *p, run_result *r)
{
#define RESULT(member) offsetof(measured_result, member)
    static const column columns[] = {
        {"synthetic", COLUMN_FLAG, "-", RESULT(synthetic), 0, {0}, 0},
        {"source", COLUMN_TEXT, "-", RESULT(source), 0, {MEASURED_SOURCE}, 0},
        {"paper", COLUMN_INT, "-", RESULT(paper), 0, {0}, PAPER_TABLE_3},
        {"arclength", COLUMN_INT, "-", RESULT(arclength), 0, {0}, ARCLENGTH_REST},
        {"tolerance", COLUMN_REAL, "-", RESULT(tolerance), 0, {0}, 0},
        {"turn_window_m", COLUMN_REAL, "m", RESULT(window), 0, {0}, 0},
    };
#undef RESULT
    status st = OK;
    measured_result *m = &r->measured;
    int n = m->nline;
    if (!r->has_rod || r->rod.nsolution == 0) {
        return passage_damaged(p, "measured", "belongs to a rod, and there is none");
    }
    TRY(passage_columns(p, "measured", COUNT_OF(columns), columns, single(m)));
    TRY(passage_count(p, "measured/count", 0, MEASURED_SHAPES, &n));
    TRY(passage_room(p, (void **)&m->line, (size_t)n, sizeof *m->line));
    m->nline = n;
    TRY(pass_errors(p, m));
    for (int i = 0; i < n; i++) {
        TRY(pass_points(p, i, r->rod.nsolution, &m->line[i]));
    }

done:
    return st;
}
