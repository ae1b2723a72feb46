// meshes/freeze.c
#include "meshes/freeze.h"

#include "base/memory.h"
#include "meshes/outline.h"
#include "meshes/polygon.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define PI 3.14159265358979323846

// " at s = 12 mm" where a number varies along the rod, else nothing
freeze_words freeze_where(const freezer *f, const field *a, const field *b)
{
    freeze_words text = {""};
    if (field_varies(a) || field_varies(b)) {
        (void)snprintf(text.a, sizeof text.a, " at s = %.6g mm", 1e3 * f->s);
    }
    return text;
}

status freeze_number(const freezer *f, const field *from, const char *name, double *out)
{
    *out = field_at(from, f->s);
    if (!isfinite(*out)) {
        return outline_fail(f->o, "its %s is not a finite number%s", name,
                            freeze_where(f, from, from).a);
    }
    return OK;
}

status freeze_length(const freezer *f, const field *from, const char *name, double *out)
{
    status st = freeze_number(f, from, name, out);
    if (st == OK && !(*out > 0)) {
        return outline_fail(f->o, "its %s is %g mm%s, it must be more than 0", name, *out * 1e3,
                            freeze_where(f, from, from).a);
    }
    return st;
}

status freeze_centre(const freezer *f, const field *from)
{
    status st = OK;
    TRY(freeze_number(f, &from[0], "centre_x", &f->o->centre[0]));
    TRY(freeze_number(f, &from[1], "centre_y", &f->o->centre[1]));

done:
    return st;
}

status freeze_ring(const freezer *f, const ring_spec *ring)
{
    status st = OK;
    outline *o = f->o;
    TRY(freeze_centre(f, ring->centre));
    TRY(freeze_length(f, &ring->outer_radius, "outer_radius", &o->outer));
    TRY(freeze_number(f, &ring->inner_radius, "inner_radius", &o->inner));
    if (!(o->inner >= 0 && o->inner < o->outer)) {
        TRY(outline_fail(o,
                         "its inner_radius of %g mm is not between 0 and its outer_radius of %g mm"
                         "%s",
                         o->inner * 1e3, o->outer * 1e3,
                         freeze_where(f, &ring->inner_radius, &ring->outer_radius).a));
    }
    if (o->kind == KIND_SECTOR) {
        TRY(freeze_number(f, &ring->mid_angle, "mid_angle", &o->mid_angle));
        TRY(freeze_number(f, &ring->width, "width", &o->width));
        if (!(o->width > 0 && o->width < 2 * PI)) {
            TRY(outline_fail(o, "its width of %g rad is not between 0 and 2 pi%s", o->width,
                             freeze_where(f, &ring->width, &ring->width).a));
        }
    }

done:
    return st;
}

status freeze_disc(const freezer *f, const disc_spec *disc)
{
    status st = OK;
    TRY(freeze_centre(f, disc->centre));
    TRY(freeze_length(f, &disc->radius, "radius", &f->o->outer));

done:
    return st;
}

status freeze_rectangle(const freezer *f, const rectangle_spec *rectangle)
{
    status st = OK;
    TRY(freeze_centre(f, rectangle->centre));
    TRY(freeze_length(f, &rectangle->width, "width", &f->o->size[0]));
    TRY(freeze_length(f, &rectangle->height, "height", &f->o->size[1]));
    TRY(freeze_number(f, &rectangle->angle, "angle", &f->o->angle));

done:
    return st;
}

// a corner repeated at the end closes the loop: people write it so
int freeze_row_count(const key_rows *rows)
{
    const int n = rows->nrow;
    return n > 1 && memcmp(rows->a, rows->a + 2 * (n - 1), 2 * sizeof *rows->a) == 0 ? n - 1 : n;
}

// one loop turned and moved, in the sense asked for, and not in contact with itself
static status freeze_loop(const freezer *f, int k, const key_rows *rows)
{
    outline *o = f->o;
    const char *what = k == 0 ? "polygon" : "hole";
    if (rows->ncol != 2 || freeze_row_count(rows) < 3) {
        return outline_fail(o, "its %s needs three corners [x, y] or more", what);
    }
    const loop a = outline_loop(o, k);
    const double c = cos(o->angle), s = sin(o->angle);
    double reach = 0;
    for (int i = 0; i < a.n; i++) {
        const double x = rows->a[2 * i], y = rows->a[2 * i + 1];
        a.p[2 * i] = o->centre[0] + c * x - s * y;
        a.p[2 * i + 1] = o->centre[1] + s * x + c * y;
        reach = fmax(reach, hypot(a.p[2 * i] - a.p[0], a.p[2 * i + 1] - a.p[1]));
        if (!isfinite(a.p[2 * i]) || !isfinite(a.p[2 * i + 1])) {
            return outline_fail(o, "corner %d of its %s is not finite", i + 1, what);
        }
    }
    int other = 0;
    const int edge = loop_self_contact(a, OUTLINE_SLIVER * reach, &other);
    if (edge >= 0) {
        return outline_fail(o, "edges %d and %d of its %s cross, fold back or all but touch",
                            edge + 1, other + 1, what);
    }
    if ((loop_area(a) > 0) != (k == 0)) {
        loop_reverse(a);
    }
    return OK;
}

static status check_holes(const freezer *f)
{
    const outline *o = f->o;
    const loop outer = outline_loop(o, 0);
    const double gap = OUTLINE_SLIVER * sqrt(fabs(loop_area(outer)));
    for (int k = 1; k < o->nloop; k++) {
        const loop hole = outline_loop(o, k);
        if (loops_touch(outer, hole, gap) || !loop_contains(outer, hole.p[0], hole.p[1])) {
            return outline_fail(o, "hole %d does not lie inside the polygon", k);
        }
        for (int j = 1; j < k; j++) {
            const loop other = outline_loop(o, j);
            if (loops_touch(other, hole, gap) || loop_contains(other, hole.p[0], hole.p[1]) ||
                loop_contains(hole, other.p[0], other.p[1])) {
                return outline_fail(o, "holes %d and %d overlap or touch", j, k);
            }
        }
    }
    return OK;
}

status freeze_polygon(const freezer *f, const polygon_spec *polygon)
{
    status st = OK;
    outline *o = f->o;
    const hole_spec *holes = polygon->holes.items;
    TRY(freeze_centre(f, polygon->centre));
    TRY(freeze_number(f, &polygon->angle, "angle", &o->angle));
    o->nloop = 1 + polygon->holes.count;
    TRY(TAKE(o->loop_start, (size_t)o->nloop + 1));
    for (int k = 0; k < o->nloop; k++) {
        const key_rows *rows = k == 0 ? &polygon->points : &holes[k - 1].points;
        o->loop_start[k + 1] = o->loop_start[k] + freeze_row_count(rows);
    }
    TRY(TAKE(o->point, 2 * (size_t)o->loop_start[o->nloop]));
    for (int k = 0; k < o->nloop; k++) {
        TRY(freeze_loop(f, k, k == 0 ? &polygon->points : &holes[k - 1].points));
    }
    TRY(check_holes(f));

done:
    return st;
}
