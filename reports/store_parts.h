// reports/store_parts.h
// The parts of a run_result on their way to the store and back, one function each for both ways.
#pragma once

#include "reports/passage.h"
#include "reports/result.h"

// more of anything than a run of ours has; a file that says more is damaged
enum {
    MOST_MATERIALS = 10000,
    MOST_STATIONS = 1000000,
    MOST_PANELS = 100000,
    MOST_SOLUTIONS = 100000,
    MOST_POINTS = 1000000,
    MOST_LOADS = 10000,
    MOST_ROWS = 100000,
};

#define STIFFNESS_UNIT "N, N m, N m^2 (nx ny nz mx my mz)"
#define COMPLIANCE_UNIT "1/N, 1/(N m), 1/(N m^2) (nx ny nz mx my mz)"

#define COUNT_OF(table) ((int)(sizeof(table) / sizeof *(table)))

static inline column_rows rows_of(void *base, int n, size_t stride)
{
    return (column_rows){.base = base, .n = (size_t)n, .stride = stride};
}

// the same where the members are pointers to the items
static inline column_rows rows_behind(void *base, int n, size_t stride)
{
    return (column_rows){.base = base, .n = (size_t)n, .stride = stride, .behind = true};
}

static inline column_rows single(void *base)
{
    return (column_rows){.base = base, .n = 1, .single = true};
}

status store_pass_section(const passage *p, run_result *r);
status store_pass_answers(const passage *p, run_result *r); // after the section
status store_pass_strains(const passage *p, run_result *r); // after the rod
status store_pass_rod(const passage *p, run_result *r);
status store_pass_segment(const passage *p, run_result *r);
// Fields go into the file where all levels are: here, or on the ranks together.
bool store_segment_is_whole(const segment_body *b);
status store_pass_segment_body(const passage *p, run_result *r);
status store_pass_segment_fields(const passage *p, int load, run_result *r); // of one load
status store_pass_sensitivity(const passage *p, run_result *r);              // after the rod
status store_pass_models(const passage *p, run_result *r);                   // with the comparisons
status store_pass_measured(const passage *p, run_result *r);                 // after the rod
status store_pass_fit(const passage *p, run_result *r);   // nothing where nothing was fitted
status store_pass_reach(const passage *p, run_result *r); // nothing without a reach study

// The solved sections' laws by fingerprint.
status store_write_known(store *s, const char *path, const section_known *known);

// /VTKHDF: the section's mesh and the deformed segments, with their names under part/. Nothing
// where there is no mesh.
status store_write_grid(store *s, const run_result *r);
