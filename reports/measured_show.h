// reports/measured_show.h
// The table of errors in the layout of the paper's Tables II and III: one row per measured shape,
// then one per solution for which only the paper has errors.
#pragma once

#include "reports/result.h"

// What the paper reports for its own measured shape.
typedef struct paper_error {
    const char *prototype;
    double angle, tension; // of the tendon at the base [rad], [N]
    double tip_mm, tip_percent, shape_percent;
} paper_error;

// NULL where the case names no table of the paper, or none of its tendons and tensions.
const paper_error *paper_error_of(const run_result *r, int solution);

enum { MEASURED_ROWS = MEASURED_SHAPES + 32, MEASURED_CELL = 64 };

typedef struct measured_row {
    const measured_line *line; // NULL: that shape is not published
    const paper_error *paper;  // NULL: the paper has none
    int solution;
} measured_row;

int measured_rows(const run_result *r, measured_row rows[MEASURED_ROWS]);

// The cells as they are read. plus_minus: " +- " or " ± ".
typedef struct measured_cells {
    char name[MEASURED_NAME];
    char tendon[MEASURED_CELL], tension[MEASURED_CELL]; // "t1 + t2", "0.49 + 0.2"
    char tip[MEASURED_CELL], shape[MEASURED_CELL]; // "1.25 ± 0.05 (1.0)" mm (% of L), "1.6 ± 0.1" %
    char rms[MEASURED_CELL], largest[MEASURED_CELL], angle[MEASURED_CELL]; // mm, mm at mm, deg
    char paper_tip[MEASURED_CELL], paper_shape[MEASURED_CELL];
} measured_cells;
measured_cells measured_cells_of(const run_result *r, const measured_row *row,
                                 const char *plus_minus);

bool measured_has_paper(const run_result *r); // any row with errors of the paper

// "synthetic shapes" or "measured shapes"; "the paper's own errors" where the case has none.
const char *measured_word(const run_result *r);
// What the data is, in one sentence: "SYNTHETIC data, not from a bench: made by ...".
void measured_data_words(const run_result *r, char *text, size_t size);
// What is to be said of one shape before its numbers are believed; "" where there is nothing.
void measured_line_notes(const run_result *r, const measured_line *line, char *text, size_t size);
enum { MEASURED_NOTES = 600 };
// What the paper's columns are; "" where there are none.
const char *measured_paper_words(const run_result *r);
