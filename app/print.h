// app/print.h
// Tables for people: aligned, with units.
#pragma once

#include "app/case.h"
#include "reports/result.h"

void print_section(const run_result *r);
// Below print_section's table: shear, places that the case asks for, stresses under its wrenches.
void print_answers(const run_result *r);
void print_rods(const run_result *r);
void print_segment(const run_result *r);
void print_compare(const run_result *r);
void print_sensitivity(const run_result *r);
void print_models(const run_result *r); // at its end
void print_measured(const run_result *r);

// What was fitted to measured shapes, and what it rests on.
void print_fit(const run_result *r);

// Which targets the scopes reach, one table each, and how they compare.
void print_reach(const run_result *r);
void print_design(const run_result *r);

// Of every material the largest strain among the rod's solutions, and where.
void print_strains(const run_result *r);

// A user's words as any terminal may show them, cut where they are very long.
typedef struct print_words {
    char text[512];
} print_words;
print_words print_plain(const char *words);

// In the unit shown, where less than half of the last digit is no number and its sign no
// information.
double print_shown(double value, double last_digit);

// K in N, N mm and N mm^2, order nx ny nz mx my mz.
void print_stiffness(const char *title, const mat6 *K);
