// reports/page_kit.h
// The pieces of report.html. Everything of a user's goes through page_escaped.
#pragma once

#include "reports/figure_kit.h"
#include "reports/markup.h"
#include "reports/result.h"

// Formatted text of ours; its arguments are numbers and words of ours only.
#define PAGE(...) TRY(bytes_format(page, __VA_ARGS__))

status page_escaped(bytes *page, const char *text);

// reports/page_style.c: from the doctype to the beginning of the body.
status page_open(bytes *page, const char *title);
status page_close(bytes *page);

// reports/page_view.c: what the browser may run and fetch, for the head; the scripts of the page's
// views, for its end, nothing where it has none.
status page_policy(bytes *page);
status page_scripts(bytes *page);

// DIR/name.svg with a caption; nothing where there is no such file.
status page_figure(bytes *page, const char *dir, const char *name, const char *caption);
// The same with elements of SVG on top of it, as markup; NULL: nothing.
status page_figure_under(bytes *page, const char *dir, const char *name, const char *over,
                         const char *caption);

// reports/page_section.c, page_rod.c, page_segment.c, page_rest.c: one part each, nothing where the
// result has none.
status page_section(bytes *page, const run_result *r, const char *dir);
status page_section_figure(bytes *page, const run_result *r, const char *dir); // with values
status page_rod(bytes *page, const run_result *r, const char *dir);
status page_answers(bytes *page, const run_result *r, const char *dir); // of the section
status page_strains(bytes *page, const run_result *r);                  // of the rod
status page_measured(bytes *page, const run_result *r, const char *dir);
status page_segment(bytes *page, const run_result *r, const char *dir);
status page_compare(bytes *page, const run_result *r);
status page_models(bytes *page,
                   const run_result *r); // reports/page_models.c, below the comparisons
status page_sensitivity(bytes *page, const run_result *r, const char *dir);
status page_fit(bytes *page, const run_result *r, const char *dir);   // reports/page_fit.c
status page_reach(bytes *page, const run_result *r, const char *dir); // reports/page_reach.c
// In space, to be turned: what three.js draws.
status page_reach_view(bytes *page, const run_result *r);
status page_rod_view(bytes *page, const run_result *r);
status page_segment_view(bytes *page, const run_result *r); // nothing without displacements
status page_assumptions(bytes *page, const run_result *r);
status page_origin(bytes *page, const run_result *r);

// reports/page_materials.c: their table; whether all are isotropic and uniform.
status page_materials(bytes *page, const run_result *r);
bool materials_are_plain(const run_result *r);

// The smallest of the materials' linear strains that are known; 0 where none is. *name: whose it
// is.
double smallest_linear_strain(const run_result *r, const char **name);

int compare_out_of_tolerance(const run_result *r);
int compare_skipped(const run_result *r);
