// section/place.c
#include "section/place.h"

#include "base/memory.h"
#include "meshes/outline.h"
#include "meshes/outline_move.h"

#include <math.h>
#include <string.h>

// The turn's rate comes from turns a little apart, by differences of order 4: this part of the
// rod's length apart they are exact for cubics, and rounding stays below 1e-12 of a turn per
// length.
static const double rate_step = 1e-3;
// Two shapes turn together where their turns over such a step agree to this [rad]
static const double same_spin = 1e-9;

void section_place_free(section_place *p)
{
    section_outline_free(&p->outline);
    *p = (section_place){0};
}

static status finite_turn(const section_case *c, double s, double *turn, double *scale)
{
    *turn = field_at(&c->turn, s);
    *scale = field_at(&c->scale, s);
    if (!isfinite(*turn) || !isfinite(*scale) || !(*scale > 0)) {
        return status_fail(ERR_INPUT,
                           "section: at s = %g mm its turn is %g rad and its scale %g, they must "
                           "be finite and the scale more than 0",
                           1e3 * s, *turn, *scale);
    }
    return OK;
}

// outlines in the body frame, where the section has any
static status draw(const section_case *c, double s, section_outline *out, bool *found)
{
    status st = OK;
    // at the place where the turn is 0 the materials' axes belong to the section as elsewhere
    outline_motion motion = {.turning = field_varies(&c->turn)};
    *found = true;
    TRY(finite_turn(c, s, &motion.angle, &motion.scale));
    TRY(c->drawing
            ? drawing_outline(c->drawing, out, found)
            : shapes_at((shape_list){.count = c->shapes.count, .items = c->shapes.items}, s, out));
    if (*found && (motion.turning || motion.angle != 0 || motion.scale != 1)) {
        section_outline_move(out, &motion);
    }

done:
    return st;
}

status section_outline_at(const section_case *c, double s, section_outline *out, bool *found)
{
    return draw(c, s, out, found);
}

// --- rates

// Differences of order 4 with the points where a one-sided one needs them: f'(0) from f(offset[i]).
typedef struct stencil {
    int offset[5];
    double weight[5];
} stencil;

// f' h = sum weight f(s + offset h), weights of the interpolating polynomial
static stencil stencil_at(double s, double h, double length)
{
    static const stencil all[] = {
        {{0, 1, 2, 3, 4}, {-25.0 / 12, 4, -3, 4.0 / 3, -1.0 / 4}},
        {{-1, 0, 1, 2, 3}, {-1.0 / 4, -5.0 / 6, 3.0 / 2, -1.0 / 2, 1.0 / 12}},
        {{-2, -1, 0, 1, 2}, {1.0 / 12, -2.0 / 3, 0, 2.0 / 3, -1.0 / 12}},
        {{-3, -2, -1, 0, 1}, {-1.0 / 12, 1.0 / 2, -3.0 / 2, 5.0 / 6, 1.0 / 4}},
        {{-4, -3, -2, -1, 0}, {1.0 / 4, -4.0 / 3, 3, -4, 25.0 / 12}},
    };
    int k = 2;
    while (k > 0 && s + all[k].offset[0] * h < 0) {
        k--;
    }
    while (k < 4 && s + all[k].offset[4] * h > length) {
        k++;
    }
    return all[k];
}

static bool turn_varies(const section_case *c)
{
    return field_varies(&c->turn) || field_varies(&c->pattern_turn) ||
           (!c->drawing && shapes_vary((shape_list){c->shapes.count, c->shapes.items}));
}

// turn of the pattern from s to t; *even false where the shapes do not agree
static status turn_between(const section_case *c, const section_place *p, double t, double *angle,
                           bool *even)
{
    status st = OK;
    section_outline o = {0};
    bool found = false;
    const field *turns = section_own_length(c) > 0 ? &c->pattern_turn : &c->turn;
    *angle = field_at(turns, t) - field_at(turns, p->s);
    if (p->drawn && !c->drawing) {
        TRY(draw(c, t, &o, &found));
        const bool agree = section_outline_spin(&p->outline, &o, same_spin, angle);
        *even = *even && agree;
    }

done:
    section_outline_free(&o);
    return st;
}

static status find_rate(const section_case *c, double length, section_place *p)
{
    status st = OK;
    const double h = rate_step * length;
    const stencil k = stencil_at(p->s, h, length);
    double sum = 0;
    bool even = true;
    if (!turn_varies(c) || !(h > 0)) {
        return OK;
    }
    for (int i = 0; i < 5; i++) {
        double angle = 0;
        if (k.weight[i] != 0 && k.offset[i] != 0) {
            TRY(turn_between(c, p, p->s + k.offset[i] * h, &angle, &even));
        }
        sum += k.weight[i] * angle;
    }
    const double rate = sum / h;
    p->uneven = !even;
    // what is left of a constant turn is rounding
    p->turn_rate = even && fabs(rate) * length > same_spin ? rate : 0;

done:
    return st;
}

status section_place_at(const section_case *c, double s, double length, section_place *out)
{
    status st = OK;
    section_place p = {.s = s, .scale = 1};
    TRY(draw(c, s, &p.outline, &p.drawn));
    if (p.drawn) {
        p.turn = p.outline.turn;
        p.has_symmetry = p.outline.has_symmetry;
    } else {
        TRY(finite_turn(c, s, &p.turn, &p.scale));
        p.slice = drawing_slice_at(c->drawing, s);
    }
    TRY(find_rate(c, length, &p));
    *out = p;
    p = (section_place){0};

done:
    section_place_free(&p);
    return st;
}

// --- meshes

// directions for the elements that have the section's own: these turn with it
static status give_frames(mesh *m)
{
    status st = OK;
    material_frame *more = NULL;
    const int n = m->nframe;
    if (n == 0) {
        TRY(mesh_take_frames(m, 1));
    } else {
        TRY(TAKE(more, (size_t)n + 1));
        memcpy(more, m->frame, (size_t)n * sizeof *more);
        free(m->frame);
        m->frame = more;
        m->nframe = n + 1;
    }
    m->frame[n] = material_frame_make(0, 0);
    for (int b = 0; b < m->nblock; b++) {
        for (int e = 0; e < m->block[b].nelem; e++) {
            int *frame = &m->block[b].frame[e];
            *frame = *frame < 0 ? n : *frame;
        }
    }

done:
    return st;
}

static void move_nodes(mesh *m, double scale, double angle)
{
    const double c = scale * cos(angle), s = scale * sin(angle);
    for (int i = 0; i < m->nnode; i++) {
        double *x = m->xyz + 3 * (size_t)i;
        const double a = x[0], b = x[1];
        x[0] = c * a - s * b;
        x[1] = s * a + c * b;
    }
    for (int k = 0; k < m->nframe; k++) {
        material_frame_move(&m->frame[k], scale, angle);
    }
}

status section_place_mesh(const section_case *c, const section_place *p,
                          const mesh_options *options, mesh *out)
{
    status st = OK;
    mesh m = {0};
    if (p->drawn) {
        return section_mesh_make(&p->outline, options, out);
    }
    TRY(drawing_mesh(c->drawing, p->slice, options, &m));
    if (p->turn != 0 || field_varies(&c->turn)) {
        TRY(give_frames(&m));
    }
    move_nodes(&m, p->scale, p->turn);
    *out = m;
    m = (mesh){0};

done:
    mesh_free(&m);
    return st;
}

status section_mesh_with(const section_case *c, double s, const mesh_options *options, mesh *out)
{
    status st = OK;
    section_place p = {0};
    TRY(section_place_at(c, s, 0, &p));
    TRY(section_place_mesh(c, &p, options, out));

done:
    section_place_free(&p);
    return st;
}

status section_mesh_at(const section_case *c, double s, mesh *out)
{
    return section_mesh_with(c, s, &c->mesh, out);
}

// --- questions about the whole section

bool section_varies(const section_case *c)
{
    return field_varies(&c->turn) || field_varies(&c->scale) ||
           (c->drawing ? drawing_slice_count(c->drawing) > 1
                       : shapes_vary((shape_list){c->shapes.count, c->shapes.items}));
}

double section_own_length(const section_case *c)
{
    return c->drawing ? drawing_length(c->drawing) : 0;
}

status section_reach_at(const section_case *c, double s, double *reach)
{
    status st = OK;
    section_outline o = {0};
    bool found = false;
    TRY(draw(c, s, &o, &found));
    *reach = o.size;
    if (!found) {
        TRY(drawing_reach(c->drawing, reach));
        *reach *= field_at(&c->scale, s);
    }

done:
    section_outline_free(&o);
    return st;
}

// --- how far in a direction

static bool has_material(const section_outline *o, double x, double y)
{
    const int top = section_top_shape(o, x, y);
    return top >= 0 && o->items[top].material >= 0;
}

// from outside inwards to the first material, then to its edge
static double reach_along(const section_outline *o, double x, double y)
{
    enum { STEPS = 1000, HALVINGS = 44 }; // to the rounding of a step
    int k = STEPS;
    while (k > 0 && !has_material(o, o->size * k / STEPS * x, o->size * k / STEPS * y)) {
        k--;
    }
    double in = o->size * k / STEPS, out = o->size * (k + 1) / STEPS;
    for (int i = 0; i < HALVINGS && k > 0; i++) {
        const double mid = (in + out) / 2;
        *(has_material(o, mid * x, mid * y) ? &in : &out) = mid;
    }
    return in;
}

status section_reach_towards(const section_case *c, double s, const double place[2], double *reach)
{
    status st = OK;
    section_outline o = {0};
    bool found = false;
    const double away = hypot(place[0], place[1]);
    TRY(section_reach_at(c, s, reach));
    TRY(draw(c, s, &o, &found));
    if (found && away > 0) {
        *reach = reach_along(&o, place[0] / away, place[1] / away);
    }

done:
    section_outline_free(&o);
    return st;
}
