// app/compare_rows.h
// How the rows of a comparison are made; for the files compare_*.c.
#pragma once

#include "app/case.h"
#include "app/command.h"
#include "reports/result.h"

enum { COMPARE_MAX_ROWS = 64 };

// The section that is compared: prismatic, at one arclength, by the full model on the section's own
// mesh.
typedef struct compare_section {
    double s;         // the segment's place where there is one, else 0 [m]
    double radius;    // about the origin, of everything [m]
    double error;     // estimate of the case's own section there, relative
    double contrast;  // largest modulus over the smallest
    bool one_poisson; // one Poisson's ratio among the materials that the section uses
    bool isotropic;   // they are isotropic and uniform
    mesh mesh;
    beam_law full;
    beam_centres centres;
} compare_section;

// Above this contrast of the moduli the layers at the ends of a 3D column reach several radii in:
// what they do to a tip's sideways motion and twist, and to the 3D law, has no bound that holds for
// every section.
#define COMPARE_MOST_CONTRAST 50.0

typedef struct tolerance {
    double value;       // relative
    const char *reason; // what it is made of
} tolerance;

// The next row; there is always room for one more (the last is used again when all are taken).
compare_row *compare_add(run_result *r, const char *unit, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
// ok where difference <= t.value; a NaN is not
void compare_judge(compare_row *row, double ours, double other, double difference, tolerance t);
// difference = |ours - other| / |other|
void compare_relative(compare_row *row, double ours, double other, tolerance t);
void compare_skip(compare_row *row, const char *format, ...) __attribute__((format(printf, 2, 3)));

// An error estimate is no bound: differences are held to so many times of it.
#define COMPARE_MARGIN 3.0

// What the section's own mesh may be off, 1e-2 at most: a section too coarse to tell anything is
// out of tolerance instead of right by default.
double compare_section_share(const compare_section *section);

double compare_centre_distance(const double *a, const double *b); // of two points in the section

// A load of the segment as a wrench at the geometric centre, and whether it is no more than that.
vec6 compare_load_wrench(const segment_load *load, const double *point);
bool compare_acts_on_tip_only(const segment_load *load);

// The rows of each kind.
status compare_closed_forms(const case_data *c, const compare_section *section, run_result *r);
status compare_getdp(const case_data *c, const compare_section *section, run_result *r);
status compare_published(const case_data *c, const compare_section *section, run_result *r);
status compare_section_segment(const case_data *c, const compare_section *section, run_result *r);
status compare_frames(const case_data *c, run_result *r);
// after compare_models, whose rod it is
void compare_rod_segment(const case_data *c, const compare_section *section, run_result *r);
status compare_models(const case_data *c, const compare_section *section, run_result *r);
void compare_loads(const case_data *c, const compare_section *section, run_result *r);
// verdicts where the case gives a tolerance
void compare_measured(run_result *r);
status compare_calculix(const case_data *c, run_result *r);
