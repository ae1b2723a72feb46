// reports/figures.h
// Pictures by cairo: each as SVG, PDF and PNG from the same routine, byte-identical on a rerun.
#pragma once

#include "reports/result.h"

// Each writes DIR/<name>.svg, .pdf and .png; nothing where the result has no such part.
status figure_section(const run_result *r,
                      const char *dir); // section: materials, GC, NC, shear centre, principal axes
status figure_stresses(const run_result *r,
                       const char *dir); // stresses: strain and stress under the first wrenches
status figure_segments(const run_result *r,
                       const char *dir); // segment, segment_stress: deformed, side by side, with
                                         // undeformed outline, by displacement and by stress
status figure_segment_along(const run_result *r,
                            const char *dir); // segment_along: strains and balance along s
status figure_segment_mesh(const run_result *r,
                           const char *dir); // segment_mesh: of the section, and its layers
status figure_time_error(const run_result *r,
                         const char *dir); // time_error: of the segment's meshes, one finer than
                                           // the other
status figure_rods(const run_result *r,
                   const char *dir); // rods: shapes, loads and tendons from three sides
status figure_sweep(const run_result *r,
                    const char *dir); // sweep: tip, bend and strain against what is swept
status figure_curvature(const run_result *r,
                        const char *dir); // curvature: curvature, twist and strains along s
status figure_wrench(const run_result *r, const char *dir);  // wrench: of the section, along s
status figure_tendons(const run_result *r, const char *dir); // tendons: paths, tensions along s
status figure_tornado(const run_result *r,
                      const char *dir); // tornado: how far each parameter moves the tip
status figure_measured(const run_result *r,
                       const char *dir); // measured, measured_along: the model against
                                         // measured shapes
status figure_fit(const run_result *r,
                  const char *dir); // fit: distances along the line, pairs of fitted numbers
status figure_reach(const run_result *r,
                    const char *dir); // reach: targets and bodies in the tissue from three sides
status figure_reach_clearance(const run_result *r,
                              const char *dir); // reach_clearance: room along each body
status figure_reach_map(const run_result *r,
                        const char *dir); // reach_map: what of the wall is reached
status figure_design(const run_result *r,
                     const char *dir); // design: score against evaluations, the best design
status figures_all(const run_result *r, const char *dir);

// One self-contained page DIR/report.html with the figures inlined (SVG), tables and numbers.
status report_page(const run_result *r, const char *dir);

// The summary that the terminal shows, at most `max_lines` lines.
status report_summary(const run_result *r, int max_lines, void *stdio_stream);
