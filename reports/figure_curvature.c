// reports/figure_curvature.c
// Strains and the wrench that the section itself carries, along the rod in the body frame.
#include "reports/figure_along.h"
#include "reports/figures.h"

#include <math.h>

static double curvature(const rod_result *rod, const struct rod_run *run, int point, int index)
{
    (void)rod;
    return run->curvature[point][index];
}

static double curvature_size(const rod_result *rod, const struct rod_run *run, int point, int index)
{
    (void)rod;
    (void)index;
    return hypot(run->curvature[point][0], run->curvature[point][1]);
}

static double elongation(const rod_result *rod, const struct rod_run *run, int point, int index)
{
    (void)rod;
    return 100 * run->stretch[point][index];
}

static double shear_size(const rod_result *rod, const struct rod_run *run, int point, int index)
{
    (void)rod;
    (void)index;
    return 100 * hypot(run->stretch[point][0], run->stretch[point][1]);
}

static double force(const rod_result *rod, const struct rod_run *run, int point, int index)
{
    (void)rod;
    return run->wrench[point].a[index];
}

static double moment(const rod_result *rod, const struct rod_run *run, int point, int index)
{
    (void)rod;
    return 1e3 * run->wrench[point].a[index];
}

static status write_sheet(const run_result *r, along_sheet *s, const char *dir)
{
    status st = OK;
    rod_show show = {0};
    if (!r->has_rod || r->rod.nsolution == 0 || r->rod.npoint < 2) {
        return OK;
    }
    TRY(rod_show_make(&r->rod, &show));
    s->r = r;
    s->show = &show;
    TRY(along_write(s, dir));

done:
    rod_show_free(&show);
    return st;
}

status figure_curvature(const run_result *r, const char *dir)
{
    along_sheet s = {
        .name = "curvature",
        .title = "Curvature, twist and strains along the rod",
        .alt = "Curvature, twist, elongation and shear along the rod",
        .npanel = 6,
        .panel = {{"Curvature about x", "κx, 1/m", curvature, 0, 0, 0},
                  {"Curvature about y", "κy, 1/m", curvature, 1, 0, 0},
                  {"Size of the curvature", "|κ|, 1/m", curvature_size, 0, 0, 0},
                  {"Twist about z", "τ, 1/m", curvature, 2, 0, 0},
                  {"Elongation of the centreline", "elongation, %", elongation, 2, 1, 0},
                  {"Size of the shear", "shear, %", shear_size, 0, 1, 0}},
        .note = ROD_NOTE_CURVATURE,
    };
    return write_sheet(r, &s, dir);
}

status figure_wrench(const run_result *r, const char *dir)
{
    along_sheet s = {
        .name = "wrench",
        .title = "What the section carries along the rod",
        .alt = "Force and moment of the section along the rod",
        .npanel = 6,
        .panel = {{"Shear force along x", "nx, N", force, 0, 0, 0},
                  {"Shear force along y", "ny, N", force, 1, 0, 0},
                  {"Axial force", "nz, N", force, 2, 0, 0},
                  {"Moment about x", "mx, N mm", moment, 3, 1, 0},
                  {"Moment about y", "my, N mm", moment, 4, 1, 0},
                  {"Torque about z", "mz, N mm", moment, 5, 1, 0}},
        .remark = "In the body frame, moments about the geometric centre; the tendons' own pull is "
                  "not part of it.",
    };
    return write_sheet(r, &s, dir);
}
