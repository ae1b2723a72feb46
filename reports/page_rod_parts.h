// reports/page_rod_parts.h
// The parts of the page about the rod beside its shapes.
#pragma once

#include "reports/page_kit.h"

// What a table shows: so many solutions, tendons and loads that it can be read.
enum { ROD_MOST_ROWS = 20, ROD_MOST_TENDONS = 8, ROD_MOST_LOADS = 4 };
typedef struct rod_rows {
    int count, row[ROD_MOST_ROWS];
    int ntendon;
    int nload; // 0 where no factor differs from 1
} rod_rows;
rod_rows rod_rows_choose(const rod_result *rod);

bool rod_error_is_large(const struct rod_run *run);
int rod_decimals(const run_result *r); // of millimetres

status page_rod_warnings(bytes *page, const run_result *r);
status page_rod_loads(bytes *page, const run_result *r);
status page_rod_equilibria(bytes *page, const run_result *r, const rod_rows *rows);
