// section/solve.c
#include "section/solve.h"

#include <math.h>

// Rounding of the solves, relative: turning and moving a section shows 5e-13 to 5e-12.
static const double rounding_level = 1e-11;
// The same of closed forms.
static const double closed_rounding = 1e-15;

// Errors are taken to fall like p^-a. Corners where materials meet a free edge, and re-entrant
// ones, give a = 2 to 5, and the low orders fall faster before these show: no faster decay than
// this is believed, no slower one is known.
static const double fastest_decay = 3, slowest_decay = 1;
// without a second difference: a re-entrant corner gives 8/3
static const double assumed_decay = 2;
// Where materials meet, and at re-entrant corners, the decay slows down with the order: what is
// left was 0.6 to 1.4 of what the last three orders promise (catheter, angle). Nobody is served by
// an estimate that is too small.
static const double slowing_margin = 2;
// Order 1 against order 2: order 2 itself keeps up to a third of the error of order 1.
static const double linear_margin = 1.5;

// the ratio d1 / d2 that errors c p^-a give
static double ratio_of_decay(int p, double a)
{
    const double e0 = pow(p, -a), e1 = pow(p - 1, -a), e2 = pow(p - 2, -a);
    return (e1 - e0) / (e2 - e1);
}

double section_error_left(int p, double d1, double d2)
{
    double slow = slowest_decay, fast = fastest_decay;
    double a = assumed_decay, margin = 1;
    if (p > 2 && d2 > 0) {
        margin = slowing_margin;
        // the ratio falls as the decay gets faster; a hundredth is more than an estimate needs
        for (int i = 0; i < 10; i++) {
            a = (slow + fast) / 2;
            if (ratio_of_decay(p, a) > d1 / d2) {
                slow = a;
            } else {
                fast = a;
            }
        }
    }
    const double e0 = pow(p, -a), e1 = pow(p - 1, -a);
    return margin * d1 * e0 / (e1 - e0);
}

static status solve_mesh(int model, const material *materials, const mesh *m, beam_law *out)
{
    return model == MODEL_CLASSICAL ? section_classical_mesh(m, materials, out)
                                    : section_full_mesh(m, materials, out, NULL);
}

static status solve_lower(int model, const material *materials, const mesh *m, int order,
                          beam_law *out)
{
    status st = OK;
    mesh lower = {0};
    TRY(mesh_lower_order(m, order, &lower));
    TRY(solve_mesh(model, materials, &lower, out));

done:
    mesh_free(&lower);
    return st;
}

// the law on the mesh and its error from the lower orders of the same mesh
static status solve_by_orders(int model, const material *materials, const mesh *m, beam_law *out)
{
    status st = OK;
    const int p = m->order;
    beam_law lower = {0}, lowest = {0};
    TRY(solve_mesh(model, materials, m, out));
    TRY(solve_lower(model, materials, m, p - 1, &lower));
    const double d1 = mat6_relative_error(lower.K, out->K);
    double d2 = 0;
    if (p > 2) {
        TRY(solve_lower(model, materials, m, p - 2, &lowest));
        d2 = mat6_relative_error(lowest.K, lower.K);
    }
    out->relative_error =
        fmax(section_error_left(p, d1, d2), fmax(rounding_level, out->relative_error));

done:
    return st;
}

// order 1 has no lower order: a mesh of order 2, curved where the outlines are, stands in for the
// truth
static status solve_linear(const section_case *c, const material *materials,
                           const section_outline *o, const mesh *m, beam_law *out)
{
    status st = OK;
    mesh higher = {0};
    beam_law better = {0};
    mesh_options options = c->mesh;
    options.order = 2;
    TRY(solve_mesh(c->model, materials, m, out));
    TRY(section_mesh_make(o, &options, &higher));
    TRY(solve_mesh(c->model, materials, &higher, &better));
    out->relative_error = fmax(linear_margin * mat6_relative_error(out->K, better.K),
                               fmax(rounding_level, out->relative_error));

done:
    mesh_free(&higher);
    return st;
}

// A wall thinner than this of the section's size is the likely reason where rounding takes over: it
// shows from 1e-3 down.
static const double thin_wall = 1e-2;

// the failure of a solve, with the shape whose thin wall explains it
static status explain(const section_outline *o, status st)
{
    double part = 0;
    const int k = section_thinnest_shape(o, &part);
    if (st != ERR_NUMERIC || k < 0 || part > thin_wall) {
        return st;
    }
    const mark at = o->items[k].at;
    status_clear();
    return status_fail_at(ERR_NUMERIC, at.line, at.column,
                          "shape %d: at %.3g mm it is too thin for a section of %.4g mm: rounding "
                          "takes over in the warping; make it thicker, or choose section.model "
                          "classical",
                          k + 1, 1e3 * part * o->size, 1e3 * o->size);
}

status section_solve_outline(const section_case *c, const material *materials,
                             const section_outline *o, beam_law *out, bool *meshed)
{
    status st = OK;
    mesh m = {0};
    bool closed = false;
    *out = (beam_law){0};
    if (c->model == MODEL_CLASSICAL) {
        TRY(section_classical_closed(o, materials, out, &closed));
        out->relative_error = closed_rounding;
    }
    *meshed = !closed;
    if (!closed) {
        TRY(section_mesh_make(o, &c->mesh, &m));
        st = m.order > 1 ? solve_by_orders(c->model, materials, &m, out)
                         : solve_linear(c, materials, o, &m, out);
        TRY(explain(o, st));
    }
    TRY(beam_law_check(out));

done:
    mesh_free(&m);
    return st;
}

static shape_list shapes_of(const section_case *c)
{
    return (shape_list){.count = c->shapes.count, .items = c->shapes.items};
}

status section_solve(const section_case *c, const material *materials, double s, beam_law *out)
{
    status st = OK;
    section_outline o = {0};
    bool meshed = false;
    TRY(shapes_at(shapes_of(c), s, &o));
    TRY(section_solve_outline(c, materials, &o, out, &meshed));

done:
    section_outline_free(&o);
    return st;
}

status section_check(const section_case *c, const material *materials, double s, bool libraries)
{
    status st = OK;
    section_outline o = {0};
    mesh m = {0};
    beam_law unused = {0};
    bool closed = false;
    TRY(shapes_at(shapes_of(c), s, &o));
    if (c->model == MODEL_CLASSICAL) {
        TRY(section_classical_closed(&o, materials, &unused, &closed));
    }
    const bool mapped = c->mesh.kind != MESH_FREE && section_mesh_is_mapped(&o);
    if (!closed && (libraries || mapped || c->mesh.kind == MESH_MAPPED)) {
        TRY(section_mesh_make(&o, &c->mesh, &m));
    }

done:
    mesh_free(&m);
    section_outline_free(&o);
    return st;
}

status section_mesh_at(const section_case *c, double s, mesh *out)
{
    status st = OK;
    section_outline o = {0};
    TRY(shapes_at(shapes_of(c), s, &o));
    TRY(section_mesh_make(&o, &c->mesh, out));

done:
    section_outline_free(&o);
    return st;
}
