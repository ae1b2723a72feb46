// reports/fig4_paper.h
// Whether a segment is the paper's Fig. 4, and what the paper reports for it.
#pragma once

#include "reports/result.h"

typedef enum fig4_load { FIG4_NONE, FIG4_AT_GC, FIG4_AT_NC } fig4_load;

// FIG4_NONE unless this is a 20 mm segment of the constant-NC section under (0, 0, -0.5) N at GC
// and at NC, two loads.
fig4_load fig4_which(const run_result *r, int load);
// both loads so, in a case whose title names Fig. 4
bool fig4_is(const run_result *r);

// The paper's words for one load; NULL where it reports nothing.
typedef struct fig4_reported {
    const char *shortening, *tip_angle, *mid_curvature;
} fig4_reported;
fig4_reported fig4_paper(fig4_load which);

// Why the paper's three figures stand beside ours without agreeing.
void fig4_note(const run_result *r, char *text, unsigned long size);
