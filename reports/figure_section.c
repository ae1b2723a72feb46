// reports/figure_section.c
#include "reports/figure_section.h"

#include "base/memory.h"
#include "reports/figures.h"

#include <math.h>
#include <stdlib.h>

enum { PATH_POINTS = 161 };

static const double sheet_width = 960;

box section_sketch_box(const section_sketch *s)
{
    return (box){28, 66, 500, s->npath > 0 ? 640 - 166 : 540 - 86};
}

// without the row of the tendons beside the section
static double base_height(const section_sketch *s)
{
    return s->npath > 0 ? 640 : 540;
}

static double sheet_height(const section_sketch *s)
{
    return base_height(s) + (section_tendons(s) > 0 ? 20 : 0);
}

bool section_tendon(const section_sketch *s, int tendon, double at[2])
{
    const rod_result *rod = &s->r->rod;
    if (!s->r->has_rod || rod->nsolution == 0 || rod->npoint < 2 || !rod->tendon_path) {
        return false;
    }
    const double *along = rod->run[0].s, here = s->r->section.station[0].s;
    const double(*path)[2] = (const double(*)[2]) & rod->tendon_path[tendon * rod->npoint];
    int k = 1;
    while (k < rod->npoint - 1 && along[k] < here) {
        k++;
    }
    const double step = along[k] - along[k - 1];
    const double part = step > 0 ? fmin(fmax((here - along[k - 1]) / step, 0), 1) : 0;
    for (int d = 0; d < 2; d++) {
        at[d] = (1 - part) * path[k - 1][d] + part * path[k][d];
    }
    return here <= rod->tendon_end[tendon] && isfinite(at[0]) && isfinite(at[1]);
}

int section_tendons(const section_sketch *s)
{
    int count = 0;
    double at[2];
    for (int i = 0; s->r->has_rod && i < s->r->rod.ntendon; i++) {
        count += section_tendon(s, i, at);
    }
    return count;
}

static status draw(canvas *c, const void *data)
{
    const section_sketch *s = data;
    const run_result *r = s->r;
    const double height = base_height(s);

    say(c, 28, 36, LOOK_TITLE, "Cross section at s = %s mm",
        number_short(r->section.station[0].s * 1e3, 5).text);
    say_within(c, 28, 56, sheet_width - 56, LOOK_SMALL, r->title);
    if (s->npath > 0) {
        say(c, 36, height - 74, look_inked(LOOK_SMALL, INK_ACCENT),
            "thick line: the stiffness centre's way from base (●) to tip (○)");
    }
    section_panel(c, s, (box){568, 76, sheet_width - 568 - 30, sheet_height(s) - 76 - 20});
    return section_drawing(c, s, section_sketch_box(s));
}

// the interpolant gives a smooth path; it is not one where the centre stands still
static status follow_centre(section_sketch *s)
{
    status st = OK;
    const law_along *along = &s->r->section.along;
    double near = s->centres->principal_angle, moved = 0;

    if (!along->law || along->npanel * along->nnode < 2) {
        return OK;
    }
    TRY(TAKE(s->path, PATH_POINTS));
    for (int i = 0; i < PATH_POINTS; i++) {
        centre_frame f = {0};
        const double at = along->length * i / (PATH_POINTS - 1);
        law_along_centre_frame(along, at, near, &f);
        near = f.phi;
        s->path[i][0] = at;
        s->path[i][1] = f.p[0];
        s->path[i][2] = f.p[1];
        s->path[i][3] = f.phi;
        moved = fmax(moved, hypot(f.p[0] - s->path[0][1], f.p[1] - s->path[0][2]));
    }
    // rounding of the interpolation is no path
    const double size = sqrt(fabs(s->r->section.station[0].law.area));
    s->npath = moved > 1e-6 * size ? PATH_POINTS : 0;

done:
    return st;
}

status section_sketch_make(const run_result *r, section_sketch *out)
{
    status st = OK;
    section_sketch s = {
        .r = r, .centres = &r->section.station[0].centres, .answers = result_answers(r, 0)};
    TRY(follow_centre(&s));
    *out = s;
    s.path = NULL;

done:
    section_sketch_free(&s);
    return st;
}

void section_sketch_free(section_sketch *s)
{
    free(s->path);
    s->path = NULL;
}

status figure_section(const run_result *r, const char *dir)
{
    status st = OK;
    section_sketch s = {0};
    if (!r->has_section || r->section.nstation == 0 || r->section_mesh.nnode == 0) {
        return OK;
    }

    TRY(section_sketch_make(r, &s));
    const picture p = {
        .name = "section",
        .title = "Cross section with its materials, centres and principal axes",
        .width = sheet_width,
        .height = sheet_height(&s),
        .draw = draw,
        .data = &s,
    };
    TRY(picture_write(&p, dir));

done:
    section_sketch_free(&s);
    return st;
}
