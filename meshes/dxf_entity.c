// meshes/dxf_entity.c
#include "meshes/dxf_entity.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

// two lengths or angles closer than this part are one: what is written has 6 digits or more
static const double SAME = 1e-9;

// --- the plane of an entity

// Curves lie in planes along xy: -1 where the entity is seen from below, so that its x runs
// backwards.
static status find_sense(const dxf_text *t, const dxf_entity *e, int *sense)
{
    const double x = dxf_get(e, 210, 0), y = dxf_get(e, 220, 0), z = dxf_get(e, 230, 1);
    if (!(hypot(x, y) <= SAME * fabs(z))) {
        return input_file_fail(t->file, e->line, "%s does not lie along the xy plane", e->kind);
    }
    *sense = z < 0 ? -1 : 1;
    return OK;
}

// x -> -x is a half turn and a mirror
static status add_seen(const dxf_text *t, dxf_plan *p, carrier c, int sense)
{
    const double nowhere[2] = {0, 0};
    return dxf_add_piece(t->file, p, sense < 0 ? carrier_moved(&c, PI, nowhere, -1) : c);
}

static status add_divided(const dxf_text *t, dxf_plan *p, int sense, int n, const carrier *c)
{
    status st = OK;
    for (int i = 0; i < n; i++) {
        TRY(add_seen(t, p, c[i], sense));
    }

done:
    return st;
}

// --- single curves

static status draw_line(const dxf_text *t, const dxf_entity *e, dxf_plan *p)
{
    status st = OK;
    TRY(dxf_need(t, e, (const int[]){10, 20, 11, 21, 0}));
    const double a[2] = {dxf_get(e, 10, 0), dxf_get(e, 20, 0)};
    const double b[2] = {dxf_get(e, 11, 0), dxf_get(e, 21, 0)};
    if (dxf_get(e, 30, 0) != dxf_get(e, 31, 0)) {
        TRY(input_file_fail(t->file, e->line, "LINE does not lie along the xy plane"));
    }
    TRY(dxf_add_piece(t->file, p, carrier_line(a, b)));

done:
    return st;
}

// CIRCLE and ARC, counter-clockwise from 50 to 51 [degrees]
static status draw_arc(const dxf_text *t, const dxf_entity *e, dxf_plan *p)
{
    status st = OK;
    const bool full = strcmp(e->kind, "CIRCLE") == 0;
    carrier c[CARRIER_MOST_PIECES];
    int sense = 1;
    TRY(dxf_need(t, e, (const int[]){10, 20, 40, full ? 0 : 50, 51, 0}));
    TRY(find_sense(t, e, &sense));
    const double centre[2] = {dxf_get(e, 10, 0), dxf_get(e, 20, 0)}, radius = dxf_get(e, 40, 0);
    const double from = full ? 0 : fmod(dxf_get(e, 50, 0), 360) * PI / 180;
    double sweep = full ? 2 * PI : fmod(dxf_get(e, 51, 0), 360) * PI / 180 - from;
    if (!(radius > 0)) {
        TRY(input_file_fail(t->file, e->line, "%s has a radius of %g", e->kind, radius));
    }
    sweep = full ? sweep : fmod(sweep, 2 * PI);
    sweep = sweep <= SAME ? sweep + 2 * PI : sweep;
    const int n = carrier_divided(centre, radius, radius, 0, from, from + sweep, c);
    TRY(add_divided(t, p, sense, n, c));

done:
    return st;
}

static status draw_ellipse(const dxf_text *t, const dxf_entity *e, dxf_plan *p)
{
    status st = OK;
    carrier c[CARRIER_MOST_PIECES];
    int sense = 1;
    TRY(dxf_need(t, e, (const int[]){10, 20, 11, 21, 40, 0}));
    TRY(find_sense(t, e, &sense));
    const double centre[2] = {dxf_get(e, 10, 0), dxf_get(e, 20, 0)};
    const double major[2] = {dxf_get(e, 11, 0), dxf_get(e, 21, 0)};
    const double length = hypot(major[0], major[1]), ratio = dxf_get(e, 40, 0);
    const double from = dxf_get(e, 41, 0), to = dxf_get(e, 42, 2 * PI);
    if (!(length > 0 && ratio > 0) || !(fabs(from) < 100 && fabs(to) < 100)) {
        TRY(input_file_fail(t->file, e->line, "ELLIPSE has no extent"));
    }
    double sweep = fmod(to - from, 2 * PI);
    sweep = sweep <= SAME ? sweep + 2 * PI : sweep;
    const double start = fmod(from, 2 * PI);
    const int n = carrier_divided(centre, length, ratio * length, atan2(major[1], major[0]), start,
                                  start + sweep, c);
    // seen from below the second axis points the other way; centre and first axis do not change
    for (int i = 0; i < n && sense < 0; i++) {
        c[i].p[2][0] = -c[i].p[2][0];
        c[i].p[2][1] = -c[i].p[2][1];
    }
    TRY(add_divided(t, p, 1, n, c));

done:
    return st;
}

// --- polylines

// bulge: the tangent of a quarter of the arc's angle, positive to the right of the chord
static status add_bulge(const dxf_text *t, dxf_plan *p, int sense, const double a[2],
                        const double b[2], double bulge)
{
    const double dx = b[0] - a[0], dy = b[1] - a[1], chord = hypot(dx, dy);
    if (chord == 0) {
        return OK; // a corner written twice
    }
    if (fabs(bulge) < SAME) {
        return add_seen(t, p, carrier_line(a, b), sense);
    }
    const double off = (1 - bulge * bulge) / (4 * bulge);
    const double centre[2] = {(a[0] + b[0]) / 2 - off * dy, (a[1] + b[1]) / 2 + off * dx};
    const double radius = chord * (1 + bulge * bulge) / (4 * fabs(bulge));
    const double from = atan2(a[1] - centre[1], a[0] - centre[0]), sweep = 4 * atan(bulge);
    const int n = (int)fmax(1, ceil(fabs(sweep) / (PI / 2) - SAME));
    status st = OK;
    for (int i = 0; i < n; i++) {
        TRY(add_seen(t, p,
                     carrier_arc(centre, radius, radius, 0, from + sweep * i / n,
                                 from + sweep * (i + 1) / n),
                     sense));
    }

done:
    return st;
}

// vertices one after the other; the first one is met again where the line is closed
typedef struct pen {
    int sense;
    bool any;
    double first[2], at[2], bulge; // bulge: of the edge that begins at `at`
} pen;

static status pen_to(const dxf_text *t, dxf_plan *p, pen *w, const double x[2], double bulge)
{
    status st = OK;
    if (w->any) {
        TRY(add_bulge(t, p, w->sense, w->at, x, w->bulge));
    } else {
        memcpy(w->first, x, sizeof w->first);
    }
    w->any = true;
    w->bulge = bulge;
    memcpy(w->at, x, sizeof w->at);

done:
    return st;
}

static status draw_lwpolyline(const dxf_text *t, const dxf_entity *e, dxf_plan *p)
{
    status st = OK;
    pen w = {0};
    TRY(find_sense(t, e, &w.sense));
    double x[2] = {0, 0}, bulge = 0;
    bool any = false;
    for (int i = 0; i <= e->npair; i++) {
        const int code = i < e->npair ? e->pair[i].code : 10;
        const double value = i < e->npair ? e->pair[i].value : 0;
        if (code == 10 && any) {
            TRY(pen_to(t, p, &w, x, bulge));
            bulge = 0;
        }
        any = any || code == 10;
        x[0] = code == 10 ? value : x[0];
        x[1] = code == 20 ? value : x[1];
        bulge = code == 42 ? value : bulge;
    }
    if (w.any && (dxf_get_int(e, 70, 0) & 1)) {
        TRY(pen_to(t, p, &w, w.first, 0));
    }

done:
    return st;
}

// flags of POLYLINE and VERTEX
enum { CLOSED = 1, MESHES = 16 + 64, FRAME_VERTEX = 16 };

static status draw_polyline(dxf_text *t, dxf_entity *e, dxf_plan *p)
{
    status st = OK;
    pen w = {0};
    const long line = e->line;
    const int flags = dxf_get_int(e, 70, 0);
    TRY(find_sense(t, e, &w.sense));
    if (flags & MESHES) {
        TRY(input_file_fail(t->file, line, "POLYLINE is a mesh of faces, not an outline"));
    }
    while (!dxf_is(t, 0, "SEQEND")) {
        if (!dxf_is(t, 0, "VERTEX")) {
            TRY(input_file_fail(t->file, t->line, "the POLYLINE of line %ld has no SEQEND", line));
        }
        TRY(dxf_entity_read(t, e));
        TRY(dxf_need(t, e, (const int[]){10, 20, 0}));
        const double x[2] = {dxf_get(e, 10, 0), dxf_get(e, 20, 0)};
        // the frame of a fitted curve is not the curve
        if (!(dxf_get_int(e, 70, 0) & FRAME_VERTEX)) {
            TRY(pen_to(t, p, &w, x, dxf_get(e, 42, 0)));
        }
    }
    TRY(dxf_entity_read(t, e)); // SEQEND
    if (w.any && (flags & CLOSED)) {
        TRY(pen_to(t, p, &w, w.first, 0));
    }

done:
    return st;
}

// --- all kinds

// these draw nothing that a section is made of
static bool is_note(const char *kind)
{
    static const char *const notes[] = {"TEXT",          "MTEXT",       "POINT",  "DIMENSION",
                                        "LEADER",        "MULTILEADER", "HATCH",  "VIEWPORT",
                                        "ATTDEF",        "ATTRIB",      "SEQEND", "TOLERANCE",
                                        "ARC_DIMENSION", "XLINE",       "RAY"};
    for (size_t i = 0; i < sizeof notes / sizeof *notes; i++) {
        if (strcmp(kind, notes[i]) == 0) {
            return true;
        }
    }
    return false;
}

static status refuse(const dxf_text *t, const dxf_entity *e)
{
    if (strcmp(e->kind, "INSERT") == 0) {
        return input_file_fail(t->file, e->line,
                               "INSERT of a block: explode the drawing's blocks first");
    }
    return input_file_fail(t->file, e->line,
                           "%s cannot be read; lines, arcs, circles, ellipses, polylines and "
                           "splines can",
                           e->kind);
}

status dxf_entity_draw(dxf_text *t, dxf_entity *e, dxf_plan *p)
{
    status st = OK;
    // code 67: in the layout, not in the model
    if (is_note(e->kind) || dxf_get_int(e, 67, 0) == 1 || strcmp(e->layer, "Defpoints") == 0) {
        return OK;
    }
    const struct {
        const char *kind;
        status (*draw)(const dxf_text *t, const dxf_entity *e, dxf_plan *p);
    } kinds[] = {{"LINE", draw_line},         {"CIRCLE", draw_arc},
                 {"ARC", draw_arc},           {"ELLIPSE", draw_ellipse},
                 {"SPLINE", dxf_spline_draw}, {"LWPOLYLINE", draw_lwpolyline}};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        if (strcmp(e->kind, kinds[i].kind) == 0) {
            TRY(dxf_add_chain(t->file, p, e->layer, e->line));
            return kinds[i].draw(t, e, p);
        }
    }
    if (strcmp(e->kind, "POLYLINE") == 0) {
        TRY(dxf_add_chain(t->file, p, e->layer, e->line));
        TRY(draw_polyline(t, e, p));
    } else {
        TRY(refuse(t, e));
    }

done:
    return st;
}
