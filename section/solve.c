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

// what is solved, beside the mesh
typedef struct solver {
    const section_case *c;
    const material *materials;
    const section_place *p;
} solver;

static status solve_mesh(const solver *q, const mesh *m, beam_law *out)
{
    return q->c->model == MODEL_CLASSICAL
               ? section_classical_mesh(m, q->materials, out)
               : section_turning_mesh(m, q->materials, q->p->turn_rate, out, NULL);
}

static status solve_order(const solver *q, const mesh *m, int order, beam_law *out)
{
    status st = OK;
    mesh other = {0};
    TRY(mesh_of_order(m, order, &other));
    TRY(solve_mesh(q, &other, out));

done:
    mesh_free(&other);
    return st;
}

// the law on the mesh and its error from the lower orders of the same mesh
static status solve_by_orders(const solver *q, const mesh *m, beam_law *out)
{
    status st = OK;
    const int p = m->order;
    beam_law lower = {0}, lowest = {0};
    TRY(solve_mesh(q, m, out));
    TRY(solve_order(q, m, p - 1, &lower));
    const double d1 = mat6_relative_error(lower.K, out->K);
    double d2 = 0;
    if (p > 2) {
        TRY(solve_order(q, m, p - 2, &lowest));
        d2 = mat6_relative_error(lowest.K, lower.K);
    }
    out->relative_error =
        fmax(section_error_left(p, d1, d2), fmax(rounding_level, out->relative_error));

done:
    return st;
}

// order 1 has no lower order: one of order 2 stands in for the truth, curved where the outlines
// are; where a file holds the mesh, the same elements
static status solve_linear(const solver *q, const mesh *m, beam_law *out)
{
    status st = OK;
    mesh higher = {0};
    beam_law better = {0};
    mesh_options options = q->c->mesh;
    options.order = 2;
    TRY(solve_mesh(q, m, out));
    TRY(q->p->drawn ? section_place_mesh(q->c, q->p, &options, &higher)
                    : mesh_of_order(m, 2, &higher));
    TRY(solve_mesh(q, &higher, &better));
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

// K on the mesh, and what the mesh leaves behind
static status solve_on_mesh(const solver *q, beam_law *out)
{
    status st = OK;
    mesh m = {0};
    TRY(section_place_mesh(q->c, q->p, &q->c->mesh, &m));
    st = m.order > 1 ? solve_by_orders(q, &m, out) : solve_linear(q, &m, out);
    TRY(q->p->drawn ? explain(&q->p->outline, st) : st);

done:
    mesh_free(&m);
    return st;
}

status section_solve_place(const section_case *c, const material *materials, const section_place *p,
                           beam_law *out, bool *meshed)
{
    status st = OK;
    const solver q = {c, materials, p};
    bool closed = false;
    *out = (beam_law){0};
    if (c->model == MODEL_CLASSICAL && p->drawn) {
        TRY(section_classical_closed(&p->outline, materials, out, &closed));
        out->relative_error = closed_rounding;
    }
    *meshed = !closed;
    if (!closed) {
        TRY(solve_on_mesh(&q, out));
    }
    TRY(beam_law_check(out));

done:
    return st;
}

status section_solve(const section_case *c, const material *materials, double s, double length,
                     beam_law *out)
{
    status st = OK;
    section_place p = {0};
    bool meshed = false;
    TRY(section_place_at(c, s, length, &p));
    TRY(section_solve_place(c, materials, &p, out, &meshed));

done:
    section_place_free(&p);
    return st;
}

status section_check(const section_case *c, const material *materials, double s, bool libraries)
{
    status st = OK;
    section_place p = {0};
    mesh m = {0};
    beam_law unused = {0};
    bool closed = false;
    TRY(section_place_at(c, s, 0, &p));
    if (c->model == MODEL_CLASSICAL && p.drawn) {
        TRY(section_classical_closed(&p.outline, materials, &unused, &closed));
    }
    const bool mapped = p.drawn && c->mesh.kind != MESH_FREE && section_mesh_is_mapped(&p.outline);
    if (!closed && (libraries || mapped || c->mesh.kind == MESH_MAPPED)) {
        TRY(section_place_mesh(c, &p, &c->mesh, &m));
    }

done:
    mesh_free(&m);
    section_place_free(&p);
    return st;
}

status section_resolution(const section_case *c, const material *materials, const section_place *p,
                          const beam_law *law, double *out)
{
    status st = OK;
    mesh m = {0};
    beam_law coarse = {0};
    const solver q = {c, materials, p};
    bool found = false;
    *out = 0;
    if (!c->drawing) {
        return OK;
    }
    TRY(drawing_mesh_coarser(c->drawing, p->slice, &c->mesh, &m, &found));
    if (found) {
        TRY(solve_mesh(&q, &m, &coarse));
        // the mesh is not turned and scaled as the place is
        const double a = p->scale;
        const double factor[6] = {a, a, a, a * a, a * a, a * a};
        for (int i = 0; i < 36; i++) {
            coarse.K.a[i / 6][i % 6] *= factor[i / 6] * factor[i % 6];
        }
        *out = mat6_relative_error(beam_law_move(coarse.K, 0, 0, -p->turn), law->K);
    }

done:
    mesh_free(&m);
    return st;
}
