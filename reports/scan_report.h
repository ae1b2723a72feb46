// reports/scan_report.h
// What a scan gave, for people and for programs.
#pragma once

#include "io/json.h"
#include "measure/scan.h"

#include <stdio.h>

// `name`: of the cloud's file.
void scan_print(const scan_result *r, const char *name, FILE *stream);
status scan_json(json *j, const scan_result *r, const char *name);

// DIR/centreline.csv (what a case's `measured` reads), DIR/centreline.vtk (a line for ParaView),
// DIR/scan.json, DIR/scan.svg, .pdf and .png.
typedef struct scan_named {
    const scan_result *result;
    const char *name;
} scan_named;
status scan_files(const char *directory, const void *named); // a scan_named
status figure_scan(const scan_named *scan, const char *directory);

// What is to be doubted, a sentence each: how many.
enum { SCAN_REMARKS = 5, SCAN_REMARK_ROOM = 160 };
int scan_remarks(const scan_result *r, char text[SCAN_REMARKS][SCAN_REMARK_ROOM]);

// What the frame stands on, in words.
const char *scan_frame_words(const scan_result *r);
// The longest stretch without points; NULL: none.
const tube_gap *scan_worst_gap(const scan_result *r);
double scan_worst_sigma(const scan_result *r, double *s); // [m]
