// app/print.h
// Tables for people: aligned, with units.
#pragma once

#include "app/case.h"
#include "reports/result.h"

void print_section(const run_result *r);
void print_rods(const run_result *r);
void print_segment(const run_result *r);
void print_compare(const run_result *r);

// K in N, N mm and N mm^2, order nx ny nz mx my mz.
void print_stiffness(const char *title, const mat6 *K);
