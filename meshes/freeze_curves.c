// meshes/freeze_curves.c
#include "base/memory.h"
#include "meshes/freeze.h"
#include "meshes/loops.h"
#include "meshes/outline.h"
#include "meshes/periodic_spline.h"

#include <math.h>

#define PI 3.14159265358979323846

enum { ROUNDED_PIECES = 8 };

static status take_pieces(outline *o, int nloop, size_t npiece)
{
    status st = OK;
    o->kind = KIND_LOOPS;
    TRY(TAKE(o->loop_start, (size_t)nloop + 1));
    TRY(TAKE(o->piece, npiece));
    o->nloop = nloop;

done:
    return st;
}

// lengths far outside the range leave no room for the squares of the checks
static status finish(const freezer *f)
{
    outline *o = f->o;
    double reach = 0;
    for (int k = 0; k < o->nloop; k++) {
        reach = fmax(reach, curves_reach(outline_curves(o, k)));
    }
    if (!(reach <= LARGEST_DRAWING)) {
        return outline_fail(o, "it reaches %g mm from the origin", 1e3 * reach);
    }
    return outline_check_curves(o);
}

status freeze_ellipse(const freezer *f, const ellipse_spec *ellipse)
{
    status st = OK;
    outline *o = f->o;
    double axis[2] = {0, 0};
    TRY(freeze_centre(f, ellipse->centre));
    TRY(freeze_number(f, &ellipse->angle, "angle", &o->angle));
    TRY(freeze_length(f, &ellipse->semi_axis_x, "semi_axis_x", &axis[0]));
    TRY(freeze_length(f, &ellipse->semi_axis_y, "semi_axis_y", &axis[1]));
    TRY(take_pieces(o, 1, CARRIER_MOST_PIECES));
    o->thickness = fmin(axis[0], axis[1]);
    o->loop_start[1] = carrier_divided(o->centre, axis[0], axis[1], o->angle, 0, 2 * PI, o->piece);
    TRY(finish(f));

done:
    return st;
}

static void add_edge(outline *o, const double *a, const double *b)
{
    if (hypot(b[0] - a[0], b[1] - a[1]) > OUTLINE_MERGE * (o->size[0] + o->size[1])) {
        o->piece[o->loop_start[1]++] = carrier_line(a, b);
    }
}

// arcs about the corners' centres, and the edges between them
static void draw_rounded(outline *o, double radius)
{
    const double c = cos(o->angle), s = sin(o->angle);
    const double half[2] = {o->size[0] / 2 - radius, o->size[1] / 2 - radius};
    const double sign[5][2] = {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 1}};
    for (int i = 0; i < 4; i++) {
        double centre[2][2], corner[2][2];
        const double end = o->angle + (i + 1) * PI / 2;
        for (int k = 0; k < 2; k++) {
            const double x = sign[i + k][0] * half[0], y = sign[i + k][1] * half[1];
            centre[k][0] = o->centre[0] + c * x - s * y;
            centre[k][1] = o->centre[1] + s * x + c * y;
            corner[k][0] = centre[k][0] + radius * cos(end);
            corner[k][1] = centre[k][1] + radius * sin(end);
        }
        if (radius > 0) {
            o->piece[o->loop_start[1]++] =
                carrier_arc(centre[0], radius, radius, o->angle, i * PI / 2, (i + 1) * PI / 2);
        }
        add_edge(o, corner[0], corner[1]);
    }
}

status freeze_rounded(const freezer *f, const rounded_spec *rounded)
{
    status st = OK;
    outline *o = f->o;
    double radius = 0;
    TRY(freeze_centre(f, rounded->centre));
    TRY(freeze_length(f, &rounded->width, "width", &o->size[0]));
    TRY(freeze_length(f, &rounded->height, "height", &o->size[1]));
    TRY(freeze_number(f, &rounded->corner_radius, "corner_radius", &radius));
    TRY(freeze_number(f, &rounded->angle, "angle", &o->angle));
    const double shorter = fmin(o->size[0], o->size[1]);
    if (!(radius >= 0 && radius <= shorter / 2 * (1 + OUTLINE_MERGE))) {
        TRY(outline_fail(
            o, "its corner_radius of %g mm is not between 0 and half its shorter edge, %g mm%s",
            1e3 * radius, 1e3 * shorter / 2,
            freeze_where(f, &rounded->corner_radius, &rounded->width).a));
    }
    TRY(take_pieces(o, 1, ROUNDED_PIECES));
    radius = fmin(radius, shorter / 2);
    draw_rounded(o, radius);
    o->thickness = radius > 0 ? fmin(shorter, radius) : shorter;
    TRY(finish(f));

done:
    return st;
}

// one loop of a spline, turned and moved
static status freeze_points(const freezer *f, int k, const key_rows *rows)
{
    status st = OK;
    outline *o = f->o;
    const curve_loop a = outline_curves(o, k);
    const char *what = k == 0 ? "spline" : "hole";
    const double c = cos(o->angle), s = sin(o->angle);
    double *points = NULL;
    if (rows->ncol != 2 || a.n < 3) {
        TRY(outline_fail(o, "its %s needs three points [x, y] or more", what));
    }
    TRY(TAKE(points, 2 * (size_t)a.n));
    for (int i = 0; i < a.n; i++) {
        const double x = rows->a[2 * i], y = rows->a[2 * i + 1];
        points[2 * i] = o->centre[0] + c * x - s * y;
        points[2 * i + 1] = o->centre[1] + s * x + c * y;
        if (!(hypot(points[2 * i], points[2 * i + 1]) <= LARGEST_DRAWING)) {
            TRY(outline_fail(o, "point %d of its %s is far away", i + 1, what));
        }
    }
    for (int i = 0; i < a.n; i++) {
        const double *p = points + 2 * i, *q = points + 2 * ((i + 1) % a.n);
        if (p[0] == q[0] && p[1] == q[1]) {
            TRY(outline_fail(o, "points %d and %d of its %s are one", i + 1, (i + 1) % a.n + 1,
                             what));
        }
    }
    TRY(periodic_spline_make(a.n, points, a.piece));

done:
    free(points);
    return st;
}

status freeze_spline(const freezer *f, const polygon_spec *spline)
{
    status st = OK;
    outline *o = f->o;
    const hole_spec *holes = spline->holes.items;
    size_t npiece = 0;
    TRY(freeze_centre(f, spline->centre));
    TRY(freeze_number(f, &spline->angle, "angle", &o->angle));
    for (int k = 0; k <= spline->holes.count; k++) {
        npiece += (size_t)freeze_row_count(k == 0 ? &spline->points : &holes[k - 1].points);
    }
    TRY(take_pieces(o, 1 + spline->holes.count, npiece));
    o->thickness = INFINITY; // its pieces were compared with one another
    for (int k = 0; k < o->nloop; k++) {
        const key_rows *rows = k == 0 ? &spline->points : &holes[k - 1].points;
        o->loop_start[k + 1] = o->loop_start[k] + freeze_row_count(rows);
        TRY(freeze_points(f, k, rows));
    }
    TRY(finish(f));

done:
    return st;
}
