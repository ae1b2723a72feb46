// reports/csv_kit.h
// What the tables share. Every name of a column of numbers ends in its unit; "ratio" and "count"
// stand for none.
#pragma once

#include "reports/result.h"

enum { CSV_MAX_COLUMNS = 1400, CSV_MAX_NAME = 96 };

// the names of a table's columns as they are collected
typedef struct csv_header {
    int n;
    char text[CSV_MAX_COLUMNS][CSV_MAX_NAME];
} csv_header;

void csv_add(csv_header *h, const char *name);
void csv_add_all(csv_header *h, const char *names); // "A B C": one column each
status csv_table(const char *dir, const char *file, const csv_header *h, csv **out);
void csv_reals(csv *c, int n, const double *values);

// reports/csv_answers.c: columns of sections.csv beyond the law; of rods.csv the strain of every
// material; and tables of their own, kern.csv and stresses.csv, where there is something to say.
void csv_add_answers(csv_header *h);
void csv_answers(csv *c, const run_result *r, int station);
void csv_add_strains(csv_header *h, const run_result *r);
void csv_strains(csv *c, const run_result *r, const struct rod_run *run);
status csv_kern(const run_result *r, const char *dir);
status csv_stresses(const run_result *r, const char *dir);

// reports/csv_models.c: models.csv, a row per entry of the tip's compliance.
status csv_models(const model_checks *m, const char *dir);

// reports/csv_sensitivity.c: sensitivity.csv and monte_carlo.csv, where there is such a part.
status csv_sensitivity(const run_result *r, const char *dir);
// reports/csv_measured.c: measured.csv and measured_shapes.csv.
status csv_measured(const run_result *r, const char *dir);

// reports/csv_fit.c: fit.csv, a row per parameter, and fit_residuals.csv.
status csv_fit(const fit_result *f, const char *dir);

// reports/csv_reach.c: reach.csv, reach_scopes.csv, reach_body.csv, reach_way.csv, reach_map.csv
// and design.csv, those that there is something to say in.
status csv_reach(const reach_result *r, const char *dir);

// reports/csv_segment.c: segment.csv and segment_slices.csv.
status csv_segment(const run_result *r, const char *dir);
