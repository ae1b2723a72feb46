// meshes/shapes.c
#include "meshes/shape.h"

#include "base/memory.h"
#include "meshes/freeze.h"
#include "meshes/outline.h"
#include "meshes/outline_turn.h"
#include "meshes/shape_frame.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

// with its copies; gmsh takes seconds for so many
enum { MOST_OUTLINES = 2000 };

// what an entry of the list can be; lumens come last, they are discs in the end
enum { ENTRY_ELLIPSE = KIND_LOOPS, ENTRY_ROUNDED, ENTRY_SPLINE, ENTRY_LUMENS, ENTRIES };

static const char *const entry_names[ENTRIES] = {"annulus",           "sector",  "disc",
                                                 "rectangle",         "polygon", "ellipse",
                                                 "rounded_rectangle", "spline",  "lumens"};

// the one that is given, -1 unless there is exactly one
static int entry_of(const shape_spec *spec, mark *at)
{
    const mark marks[ENTRIES] = {spec->annulus.at,           spec->sector.at,  spec->disc.at,
                                 spec->rectangle.at,         spec->polygon.at, spec->ellipse.at,
                                 spec->rounded_rectangle.at, spec->spline.at,  spec->lumens.at};
    int entry = -1, given = 0;
    for (int k = 0; k < ENTRIES; k++) {
        if (mark_given(marks[k])) {
            given++;
            entry = k;
        }
    }
    *at = mark_given(spec->at) || entry < 0 ? spec->at : marks[entry];
    return given == 1 ? entry : -1;
}

// --- copies

static int place_count(const lumens_spec *l)
{
    return l->places.nrow > 0 ? l->places.nrow : l->count;
}

static int copy_count(const shape_spec *spec, int entry)
{
    const int places = entry == ENTRY_LUMENS ? place_count(&spec->lumens) : 1;
    return places * (mark_given(spec->array.at) ? spec->array.count : 1);
}

static status freeze_lumen(const freezer *f, const lumens_spec *l, int place)
{
    status st = OK;
    outline *o = f->o;
    double x = 0, y = 0, radius = 0;
    TRY(freeze_centre(f, l->centre));
    TRY(freeze_length(f, &l->radius, "radius", &o->outer));
    if (l->places.nrow > 0) {
        x = l->places.a[2 * place];
        y = l->places.a[2 * place + 1];
    } else {
        TRY(freeze_length(f, &l->circle_radius, "circle_radius", &radius));
        TRY(freeze_number(f, &l->first_angle, "first_angle", &o->angle));
        o->angle += 2 * PI * place / l->count;
        o->declares = field_varies(&l->first_angle);
        x = radius * cos(o->angle);
        y = radius * sin(o->angle);
    }
    o->centre[0] += x;
    o->centre[1] += y;

done:
    return st;
}

// about the origin by `angle`, or with `turn` false only the centre's way there
static void carry(outline *o, double angle, bool turn)
{
    const double c = cos(angle), s = sin(angle), x = o->centre[0], y = o->centre[1];
    const double to[2] = {c * x - s * y, s * x + c * y};
    const double shift[2] = {turn ? 0 : to[0] - x, turn ? 0 : to[1] - y};
    const int n = o->nloop > 0 ? o->loop_start[o->nloop] : 0;
    for (int i = 0; i < n && o->kind == KIND_LOOPS; i++) {
        o->piece[i] = carrier_moved(&o->piece[i], turn ? angle : 0, shift, 1);
    }
    for (int i = 0; i < n && o->kind == KIND_POLYGON; i++) {
        const double px = o->point[2 * i], py = o->point[2 * i + 1];
        o->point[2 * i] = turn ? c * px - s * py : px + shift[0];
        o->point[2 * i + 1] = turn ? s * px + c * py : py + shift[1];
    }
    o->centre[0] = to[0];
    o->centre[1] = to[1];
    o->angle += turn ? angle : 0;
    o->mid_angle += turn ? angle : 0;
}

static status place_in_array(const freezer *f, const array_spec *array, int copy)
{
    status st = OK;
    outline *o = f->o;
    double radius = 0, first = 0;
    TRY(freeze_number(f, &array->radius, "array's radius", &radius));
    TRY(freeze_number(f, &array->first_angle, "array's first_angle", &first));
    const double out[2] = {radius, 0};
    const int n = o->nloop > 0 ? o->loop_start[o->nloop] : 0;
    for (int i = 0; i < n && o->kind == KIND_LOOPS; i++) {
        o->piece[i] = carrier_moved(&o->piece[i], 0, out, 1);
    }
    for (int i = 0; i < n && o->kind == KIND_POLYGON; i++) {
        o->point[2 * i] += radius;
    }
    o->centre[0] += radius;
    carry(o, first + 2 * PI * copy / array->count, array->turn);
    o->declares = o->declares || field_varies(&array->first_angle);

done:
    return st;
}

// --- one shape

static status freeze_kind(const freezer *f, const shape_spec *spec, int entry, int place)
{
    f->o->declares = true;
    f->o->kind = entry < KIND_LOOPS ? (shape_kind)entry : KIND_LOOPS;
    switch (entry) {
    case KIND_ANNULUS:
        f->o->declares = false;
        return freeze_ring(f, &spec->annulus);
    case KIND_SECTOR:
        return freeze_ring(f, &spec->sector);
    case KIND_DISC:
        f->o->declares = false;
        return freeze_disc(f, &spec->disc);
    case KIND_RECTANGLE:
        return freeze_rectangle(f, &spec->rectangle);
    case KIND_POLYGON:
        return freeze_polygon(f, &spec->polygon);
    case ENTRY_ELLIPSE:
        return freeze_ellipse(f, &spec->ellipse);
    case ENTRY_ROUNDED:
        return freeze_rounded(f, &spec->rounded_rectangle);
    case ENTRY_SPLINE:
        return freeze_spline(f, &spec->spline);
    default:
        f->o->declares = false;
        f->o->kind = KIND_DISC;
        return freeze_lumen(f, &spec->lumens, place);
    }
}

// copy: from 0
static status freeze(const shape_spec *spec, int index, int copy, double s, outline *o)
{
    status st = OK;
    mark at = {0};
    const int entry = entry_of(spec, &at);
    if (entry < 0) {
        TRY(status_fail_at(ERR_INPUT, spec->at.line, spec->at.column,
                           "shape %d: it must be exactly one of annulus, sector, disc, rectangle, "
                           "polygon, ellipse, rounded_rectangle, spline, lumens",
                           index + 1));
    }
    const int copies = copy_count(spec, entry);
    char words[24] = "";
    if (copies > 1) {
        (void)snprintf(words, sizeof words, ", copy %d", copy + 1);
    }
    (void)snprintf(o->called, sizeof o->called, "shape %d (%s%s)", index + 1, entry_names[entry],
                   words);
    o->material = spec->material_index;
    o->at = at;
    const freezer f = {.o = o, .s = s};
    const int turns = mark_given(spec->array.at) ? spec->array.count : 1;
    TRY(freeze_kind(&f, spec, entry, copy / turns));
    if (mark_given(spec->array.at)) {
        TRY(place_in_array(&f, &spec->array, copy % turns));
    }
    TRY(shape_frame_freeze(spec, s, o));

done:
    return st;
}

// --- the section

// the size is that of what is drawn with a material; a shape that cuts may reach far beyond
status section_outline_measure(section_outline *o)
{
    for (int k = 0; k < o->count; k++) {
        const double reach = outline_reach(&o->items[k]);
        if (!(reach <= LARGEST_DRAWING)) {
            return outline_fail(&o->items[k], "it reaches %g mm from the origin", 1e3 * reach);
        }
        if (o->items[k].material >= 0) {
            o->size = fmax(o->size, reach);
        }
    }
    if (o->size == 0) {
        return status_fail(ERR_INPUT, "the section is empty: no shape has a material");
    }
    if (o->size < SMALLEST_DRAWING) {
        return status_fail(ERR_INPUT, "the section is only %g mm large", 1e3 * o->size);
    }
    o->turn = section_declared_turn(o);
    o->has_symmetry = section_is_symmetric(o);
    return OK;
}

// how many outlines the entries freeze into
static status count_outlines(shape_list shapes, int *count)
{
    double total = 0;
    mark at = {0};
    for (int k = 0; k < shapes.count; k++) {
        total += copy_count(&shapes.items[k], entry_of(&shapes.items[k], &at));
        if (!(total <= MOST_OUTLINES)) {
            return status_fail_at(ERR_INPUT, at.line, at.column,
                                  "shape %d: with its copies there are more than %d shapes", k + 1,
                                  MOST_OUTLINES);
        }
    }
    *count = (int)total;
    return OK;
}

status shapes_at(shape_list shapes, double s, section_outline *out)
{
    status st = OK;
    section_outline o = {0};
    int n = 0;

    TRY(count_outlines(shapes, &o.count));
    if (o.count < 1) {
        TRY(status_fail(ERR_INPUT, "the section is empty: it has no shapes"));
    }
    TRY(TAKE(o.items, (size_t)o.count));
    for (int k = 0; k < shapes.count; k++) {
        mark at = {0};
        const int copies = copy_count(&shapes.items[k], entry_of(&shapes.items[k], &at));
        for (int copy = 0; copy < copies; copy++) {
            TRY(freeze(&shapes.items[k], k, copy, s, &o.items[n++]));
        }
    }
    TRY(section_outline_measure(&o));
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
        free(o->items[k].piece);
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

#define VARIES(...)                                                                                \
    any_varies((int)(sizeof((const field *[]){__VA_ARGS__}) / sizeof(field *)),                    \
               (const field *const[]){__VA_ARGS__})

static bool shape_varies(const shape_spec *p)
{
    const ring_spec *a = &p->annulus, *b = &p->sector;
    const disc_spec *d = &p->disc;
    const rectangle_spec *r = &p->rectangle;
    const polygon_spec *g = &p->polygon, *n = &p->spline;
    const ellipse_spec *e = &p->ellipse;
    const rounded_spec *c = &p->rounded_rectangle;
    const lumens_spec *l = &p->lumens;
    const array_spec *y = &p->array;
    return VARIES(&a->outer_radius, &a->inner_radius, &a->centre[0], &a->centre[1]) ||
           VARIES(&b->outer_radius, &b->inner_radius, &b->centre[0], &b->centre[1]) ||
           VARIES(&b->mid_angle, &b->width, &d->radius, &d->centre[0], &d->centre[1]) ||
           VARIES(&r->width, &r->height, &r->angle, &r->centre[0], &r->centre[1]) ||
           VARIES(&g->angle, &g->centre[0], &g->centre[1]) ||
           VARIES(&n->angle, &n->centre[0], &n->centre[1]) ||
           VARIES(&e->semi_axis_x, &e->semi_axis_y, &e->angle, &e->centre[0], &e->centre[1]) ||
           VARIES(&c->width, &c->height, &c->corner_radius, &c->angle) ||
           VARIES(&c->centre[0], &c->centre[1], &y->radius, &y->first_angle) ||
           VARIES(&l->radius, &l->circle_radius, &l->first_angle, &l->centre[0], &l->centre[1]);
}

bool shapes_vary(shape_list shapes)
{
    for (int k = 0; k < shapes.count; k++) {
        if (shape_varies(&shapes.items[k]) || shape_frame_varies(&shapes.items[k])) {
            return true;
        }
    }
    return false;
}
