// meshes/shapes.c
#include "meshes/shape.h"

#include "base/memory.h"
#include "meshes/outline.h"
#include "meshes/outline_turn.h"
#include "meshes/polygon.h"
#include "meshes/shape_frame.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

// Drawings outside of these sizes are mistakes of unit, and their squares would leave the range of
// the checks.
static const double SMALLEST_SIZE = 1e-8, LARGEST_SIZE = 1e4; // [m]

typedef struct freezer {
    outline *o;
    int index;
    double s;
} freezer;

typedef struct where_text {
    char a[40];
} where_text;

// " at s = 12 mm" where a number varies along the rod, else nothing
static where_text where(const freezer *f, const field *a, const field *b)
{
    where_text text = {""};
    if (field_varies(a) || field_varies(b)) {
        (void)snprintf(text.a, sizeof text.a, " at s = %.6g mm", 1e3 * f->s);
    }
    return text;
}

static status number(const freezer *f, const field *from, const char *name, double *out)
{
    *out = field_at(from, f->s);
    if (!isfinite(*out)) {
        return outline_fail(f->o, f->index, "its %s is not a finite number%s", name,
                            where(f, from, from).a);
    }
    return OK;
}

static status length(const freezer *f, const field *from, const char *name, double *out)
{
    status st = number(f, from, name, out);
    if (st == OK && !(*out > 0)) {
        return outline_fail(f->o, f->index, "its %s is %g mm%s, it must be more than 0", name,
                            *out * 1e3, where(f, from, from).a);
    }
    return st;
}

static status centre(const freezer *f, const field *from)
{
    status st = OK;
    TRY(number(f, &from[0], "centre_x", &f->o->centre[0]));
    TRY(number(f, &from[1], "centre_y", &f->o->centre[1]));

done:
    return st;
}

static status freeze_ring(const freezer *f, const ring_spec *ring)
{
    status st = OK;
    outline *o = f->o;
    TRY(centre(f, ring->centre));
    TRY(length(f, &ring->outer_radius, "outer_radius", &o->outer));
    TRY(number(f, &ring->inner_radius, "inner_radius", &o->inner));
    if (!(o->inner >= 0 && o->inner < o->outer)) {
        TRY(outline_fail(o, f->index,
                         "its inner_radius of %g mm is not between 0 and its outer_radius of %g mm"
                         "%s",
                         o->inner * 1e3, o->outer * 1e3,
                         where(f, &ring->inner_radius, &ring->outer_radius).a));
    }
    if (o->kind == KIND_SECTOR) {
        TRY(number(f, &ring->mid_angle, "mid_angle", &o->mid_angle));
        TRY(number(f, &ring->width, "width", &o->width));
        if (!(o->width > 0 && o->width < 2 * PI)) {
            TRY(outline_fail(o, f->index, "its width of %g rad is not between 0 and 2 pi%s",
                             o->width, where(f, &ring->width, &ring->width).a));
        }
    }

done:
    return st;
}

static status freeze_disc(const freezer *f, const disc_spec *disc)
{
    status st = OK;
    TRY(centre(f, disc->centre));
    TRY(length(f, &disc->radius, "radius", &f->o->outer));

done:
    return st;
}

static status freeze_rectangle(const freezer *f, const rectangle_spec *rectangle)
{
    status st = OK;
    TRY(centre(f, rectangle->centre));
    TRY(length(f, &rectangle->width, "width", &f->o->size[0]));
    TRY(length(f, &rectangle->height, "height", &f->o->size[1]));
    TRY(number(f, &rectangle->angle, "angle", &f->o->angle));

done:
    return st;
}

// a corner repeated at the end closes the loop: people write it so
static int corner_count(const key_rows *rows)
{
    const int n = rows->nrow;
    return n > 1 && memcmp(rows->a, rows->a + 2 * (n - 1), 2 * sizeof *rows->a) == 0 ? n - 1 : n;
}

// one loop turned and moved, in the sense asked for, and not in contact with itself
static status freeze_loop(const freezer *f, int k, const key_rows *rows)
{
    outline *o = f->o;
    const char *what = k == 0 ? "polygon" : "hole";
    if (rows->ncol != 2 || corner_count(rows) < 3) {
        return outline_fail(o, f->index, "its %s needs three corners [x, y] or more", what);
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
            return outline_fail(o, f->index, "corner %d of its %s is not finite", i + 1, what);
        }
    }
    int other = 0;
    const int edge = loop_self_contact(a, OUTLINE_SLIVER * reach, &other);
    if (edge >= 0) {
        return outline_fail(o, f->index,
                            "edges %d and %d of its %s cross, fold back or all but touch", edge + 1,
                            other + 1, what);
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
            return outline_fail(o, f->index, "hole %d does not lie inside the polygon", k);
        }
        for (int j = 1; j < k; j++) {
            const loop other = outline_loop(o, j);
            if (loops_touch(other, hole, gap) || loop_contains(other, hole.p[0], hole.p[1]) ||
                loop_contains(hole, other.p[0], other.p[1])) {
                return outline_fail(o, f->index, "holes %d and %d overlap or touch", j, k);
            }
        }
    }
    return OK;
}

static status freeze_polygon(const freezer *f, const polygon_spec *polygon)
{
    status st = OK;
    outline *o = f->o;
    const hole_spec *holes = polygon->holes.items;
    TRY(centre(f, polygon->centre));
    TRY(number(f, &polygon->angle, "angle", &o->angle));
    o->nloop = 1 + polygon->holes.count;
    TRY(TAKE(o->loop_start, (size_t)o->nloop + 1));
    for (int k = 0; k < o->nloop; k++) {
        const key_rows *rows = k == 0 ? &polygon->points : &holes[k - 1].points;
        o->loop_start[k + 1] = o->loop_start[k] + corner_count(rows);
    }
    TRY(TAKE(o->point, 2 * (size_t)o->loop_start[o->nloop]));
    for (int k = 0; k < o->nloop; k++) {
        TRY(freeze_loop(f, k, k == 0 ? &polygon->points : &holes[k - 1].points));
    }
    TRY(check_holes(f));

done:
    return st;
}

static status freeze(const shape_spec *spec, int index, double s, outline *o)
{
    const mark marks[KIND_COUNT] = {spec->annulus.at, spec->sector.at, spec->disc.at,
                                    spec->rectangle.at, spec->polygon.at};
    int given = 0;
    for (int k = 0; k < KIND_COUNT; k++) {
        if (mark_given(marks[k])) {
            given++;
            o->kind = (shape_kind)k;
        }
    }
    if (given != 1) {
        return status_fail_at(ERR_INPUT, spec->at.line, spec->at.column,
                              "shape %d: it must be exactly one of annulus, sector, disc, "
                              "rectangle, polygon",
                              index + 1);
    }
    o->material = spec->material_index;
    o->at = mark_given(spec->at) ? spec->at : marks[o->kind];
    const freezer f = {.o = o, .index = index, .s = s};
    switch (o->kind) {
    case KIND_ANNULUS:
        return freeze_ring(&f, &spec->annulus);
    case KIND_SECTOR:
        return freeze_ring(&f, &spec->sector);
    case KIND_DISC:
        return freeze_disc(&f, &spec->disc);
    case KIND_RECTANGLE:
        return freeze_rectangle(&f, &spec->rectangle);
    case KIND_POLYGON:
        return freeze_polygon(&f, &spec->polygon);
    case KIND_COUNT:
        break;
    }
    return OK;
}

// the size is that of what is drawn with a material; a shape that cuts may reach far beyond
static status measure(section_outline *o)
{
    for (int k = 0; k < o->count; k++) {
        const double reach = outline_reach(&o->items[k]);
        if (!(reach <= LARGEST_SIZE)) {
            return outline_fail(&o->items[k], k, "it reaches %g mm from the origin", 1e3 * reach);
        }
        if (o->items[k].material >= 0) {
            o->size = fmax(o->size, reach);
        }
    }
    if (o->size == 0) {
        return status_fail(ERR_INPUT, "the section is empty: no shape has a material");
    }
    if (o->size < SMALLEST_SIZE) {
        return status_fail(ERR_INPUT, "the section is only %g mm large", 1e3 * o->size);
    }
    return OK;
}

status shapes_at(shape_list shapes, double s, section_outline *out)
{
    status st = OK;
    section_outline o = {.count = shapes.count};

    if (shapes.count < 1) {
        TRY(status_fail(ERR_INPUT, "the section is empty: it has no shapes"));
    }
    TRY(TAKE(o.items, (size_t)o.count));
    for (int k = 0; k < o.count; k++) {
        TRY(freeze(&shapes.items[k], k, s, &o.items[k]));
        TRY(shape_frame_freeze(&shapes.items[k], k, s, &o.items[k]));
    }
    TRY(measure(&o));
    o.turn = section_declared_turn(&o);
    o.has_symmetry = section_is_symmetric(&o);
    *out = o;
    o = (section_outline){0};

done:
    section_outline_free(&o);
    return st;
}

void section_outline_free(section_outline *o)
{
    for (int k = 0; o->items && k < o->count; k++) {
        free(o->items[k].loop_start);
        free(o->items[k].point);
    }
    free(o->items);
    *o = (section_outline){0};
}

static bool any_varies(int n, const field *const *f)
{
    for (int i = 0; i < n; i++) {
        if (field_varies(f[i])) {
            return true;
        }
    }
    return false;
}

bool shapes_vary(shape_list shapes)
{
    for (int k = 0; k < shapes.count; k++) {
        const shape_spec *p = &shapes.items[k];
        const ring_spec *ring = mark_given(p->sector.at) ? &p->sector : &p->annulus;
        const field *const all[] = {
            &ring->outer_radius,     &ring->inner_radius,
            &ring->mid_angle,        &ring->width,
            &ring->centre[0],        &ring->centre[1],
            &p->disc.radius,         &p->disc.centre[0],
            &p->disc.centre[1],      &p->rectangle.width,
            &p->rectangle.height,    &p->rectangle.angle,
            &p->rectangle.centre[0], &p->rectangle.centre[1],
            &p->polygon.angle,       &p->polygon.centre[0],
            &p->polygon.centre[1],
        };
        if (any_varies(sizeof all / sizeof *all, all) || shape_frame_varies(p)) {
            return true;
        }
    }
    return false;
}
