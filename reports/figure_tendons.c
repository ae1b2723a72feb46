// reports/figure_tendons.c
// Where the tendons run in the section, and the tension along each.
#include "reports/figure_along.h"
#include "reports/figures.h"

#include <math.h>
#include <stdio.h>

enum { PANELS = ALONG_MAX_PANELS - 1, NAMED = 12 };

static double tension(const rod_result *rod, const struct rod_run *run, int point, int index)
{
    return run->along[point * rod->ntendon + index];
}

static double farthest(const rod_result *rod)
{
    double most = 0;
    for (int i = 0; i < rod->ntendon * rod->npoint; i++) {
        most = fmax(most, fmax(fabs(rod->tendon_path[i][0]), fabs(rod->tendon_path[i][1])));
    }
    return 1e3 * most;
}

static bool moves(const rod_result *rod, int tendon)
{
    const double *base = rod->tendon_path[tendon * rod->npoint];
    for (int k = 1; k < rod->npoint; k++) {
        const double *at = rod->tendon_path[tendon * rod->npoint + k];
        if (hypot(at[0] - base[0], at[1] - base[1]) > 1e-9 * rod->tendon_end[tendon]) {
            return true;
        }
    }
    return false;
}

static void path(canvas *c, const rod_result *rod, const plot *p, int tendon)
{
    const double(*at)[2] = (const double(*)[2]) & rod->tendon_path[tendon * rod->npoint];
    const colour ink = INK, white = {1, 1, 1, 1};
    for (int k = 0; k < rod->npoint; k = rod_next_point(rod, k)) {
        const double x = plot_x(p, 1e3 * at[k][0]), y = plot_y(p, 1e3 * at[k][1]);
        if (k == 0) {
            canvas_move(c, x, y);
        } else {
            canvas_line(c, x, y);
        }
    }
    canvas_stroke(c, ink, 1.6);
    if (moves(rod, tendon)) {
        const double *end = at[rod->npoint - 1];
        canvas_circle(c, plot_x(p, 1e3 * end[0]), plot_y(p, 1e3 * end[1]), 3.5);
        canvas_fill_stroke(c, white, ink, 1.6);
    }
    canvas_circle(c, plot_x(p, 1e3 * at[0][0]), plot_y(p, 1e3 * at[0][1]), 4);
    canvas_fill_stroke(c, ink, white, 1);
}

// x to the right, y up, at one scale
static void section_view(canvas *c, const along_sheet *s, box at)
{
    const rod_result *rod = &s->r->rod;
    const double most = 1.25 * fmax(farthest(rod), 1e-9), wide = most * at.w / at.h;
    const plot p = {at, -wide, wide, -most, most};
    say(c, at.x, at.y - 7, LOOK_HEADING, "Paths in the section");
    plot_frame(c, &p, "x, mm", "y, mm");
    canvas_clip(c, at.x, at.y, at.w, at.h);
    for (int i = 0; i < rod->ntendon; i++) {
        path(c, rod, &p, i);
    }
    for (int i = 0; i < rod->ntendon && rod->ntendon <= NAMED; i++) {
        const double *base = rod->tendon_path[i * rod->npoint];
        say_within(c, plot_x(&p, 1e3 * base[0]) + 7, plot_y(&p, 1e3 * base[1]) - 6, 80,
                   look_haloed(look_inked(LOOK_SMALL, INK)), rod->tendon_name[i]);
    }
    canvas_unclip(c);
}

// largest tension of a tendon at its base over all solutions
static double strongest(const rod_result *rod, int tendon)
{
    double most = 0;
    for (int i = 0; i < rod->nsolution; i++) {
        most = fmax(most, rod->run[i].tension[tendon]);
    }
    return most;
}

// those that pull; where they are too many, the first of them
static int add_panels(const rod_result *rod, along_sheet *s)
{
    int left_off = 0;
    for (int i = 0; i < rod->ntendon; i++) {
        along_panel *panel = &s->panel[s->npanel];
        if (!(strongest(rod, i) > 0)) {
            continue;
        }
        if (s->npanel == PANELS) {
            left_off++;
            continue;
        }
        *panel = (along_panel){
            .label = "tension, N", .value = tension, .index = i, .to = rod->tendon_end[i]};
        (void)snprintf(panel->name, sizeof panel->name, "Tension along %s", rod->tendon_name[i]);
        s->npanel++;
    }
    return left_off;
}

status figure_tendons(const run_result *r, const char *dir)
{
    status st = OK;
    rod_show show = {0};
    char remark[160];
    along_sheet s = {
        .r = r,
        .show = &show,
        .name = "tendons",
        .title = "Tendons: paths and tensions",
        .alt = "Paths of the tendons in the section and the tension along each",
        .first = section_view,
        .remark = remark,
    };
    if (!r->has_rod || r->rod.nsolution == 0 || r->rod.npoint < 2 || r->rod.ntendon == 0) {
        return OK;
    }
    const int left_off = add_panels(&r->rod, &s);
    (void)snprintf(remark, sizeof remark,
                   "Full dot: at the base; ring: at the end of a path that moves.");
    if (left_off > 0) {
        (void)snprintf(remark, sizeof remark,
                       "Full dot: at the base; ring: at the end. %d more tendons that pull are in "
                       "shapes.csv.",
                       left_off);
    }
    TRY(rod_show_make(&r->rod, &show));
    TRY(along_write(&s, dir));

done:
    rod_show_free(&show);
    return st;
}
