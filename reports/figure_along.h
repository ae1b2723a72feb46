// reports/figure_along.h
// A sheet of small plots over the arclength, three in a row.
#pragma once

#include "reports/figure_rod_style.h"

enum { ALONG_MAX_PANELS = 12 };

typedef struct along_panel {
    char name[96], label[48]; // above it; its axis, with unit
    double (*value)(const rod_result *rod, const struct rod_run *run, int point, int index);
    int index;
    int group; // panels of a group share what counts as nothing: a part of their largest value
    double to; // arclength up to which it is drawn [m]; 0: all
} along_panel;

typedef struct along_sheet {
    const run_result *r;
    const rod_show *show;
    const char *name, *title; // of the files; on the sheet
    const char *alt;          // for a screen reader; which solutions is added
    int npanel;
    along_panel panel[ALONG_MAX_PANELS];
    rod_note note;
    const char *remark; // below the legend; NULL: none
    // drawn into the place of the first panel before the others, which then come after it; may be
    // NULL
    void (*first)(canvas *c, const struct along_sheet *s, box at);
} along_sheet;

status along_write(const along_sheet *s, const char *dir);
