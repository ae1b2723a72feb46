// reports/figures.c
#include "reports/figures.h"

status figures_all(const run_result *r, const char *dir)
{
    status st = OK;
    TRY(figure_section(r, dir));
    TRY(figure_stresses(r, dir));
    TRY(figure_segments(r, dir));
    TRY(figure_segment_along(r, dir));
    TRY(figure_segment_mesh(r, dir));
    TRY(figure_time_error(r, dir));
    TRY(figure_rods(r, dir));
    TRY(figure_sweep(r, dir));
    TRY(figure_curvature(r, dir));
    TRY(figure_wrench(r, dir));
    TRY(figure_tendons(r, dir));
    TRY(figure_tornado(r, dir));
    TRY(figure_measured(r, dir));
    TRY(figure_fit(r, dir));
    TRY(figure_reach(r, dir));
    TRY(figure_reach_clearance(r, dir));
    TRY(figure_reach_map(r, dir));
    TRY(figure_design(r, dir));

done:
    return st;
}
