// reports/figure_section.h
// The two halves of the section's picture; figure_section (reports/figures.h) puts them on one
// sheet.
#pragma once

#include "reports/figure_kit.h"
#include "reports/plane_edges.h"
#include "reports/result.h"

typedef struct section_sketch {
    const run_result *r;
    const beam_centres *centres;    // of the first station
    const section_answers *answers; // of the first station; NULL: not asked for
    int npath;                      // 0 where nothing varies along the rod
    double (*path)[4];              // s, x, y of the stiffness centre [m] and the turn of x' [rad]
} section_sketch;

// Of the first station; ERR_RESOURCE. The drawing's box on the sheet.
status section_sketch_make(const run_result *r, section_sketch *out);
void section_sketch_free(section_sketch *s);
box section_sketch_box(const section_sketch *s);

// Where a place of the section stands on paper.
typedef struct sketch_frame {
    double scale;  // points per m
    double x0, y0; // where the geometric centre stands
} sketch_frame;
sketch_frame sketch_frame_of(const mesh *m, box at);

// Of a rod's tendons those that pass the first station, and where [m].
bool section_tendon(const section_sketch *s, int tendon, double at[2]);
int section_tendons(const section_sketch *s); // how many

status section_drawing(canvas *c, const section_sketch *s, box at);
void section_panel(canvas *c, const section_sketch *s, box at);

void mark_geometric_centre(canvas *c, double x, double y);
void mark_stiffness_centre(canvas *c, double x, double y);
void mark_shear_centre(canvas *c, double x, double y);
void mark_mass_centre(canvas *c, double x, double y);
void mark_tendon(canvas *c, double x, double y);
void kern_stroke(canvas *c); // of the path at hand
