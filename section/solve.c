// section/solve.c
#include "section/solve.h"

#include "section/estimate.h"

#include <math.h>

// Rounding of closed forms, relative.
static const double closed_rounding = 1e-15;

// what is solved, beside the mesh
typedef struct solver {
    const section_case *c;
    const material *materials;
    const section_place *p;
} solver;

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

static status solve_mesh(const void *what, const mesh *m, beam_law *out)
{
    const solver *q = what;
    const status st = q->c->model == MODEL_CLASSICAL
                          ? section_classical_mesh(m, q->materials, out)
                          : section_turning_mesh(m, q->materials, q->p->turn_rate, out, NULL);
    return q->p->drawn ? explain(&q->p->outline, st) : st;
}

static status make_mesh(const void *what, const mesh_options *options, mesh *out)
{
    const solver *q = what;
    return section_place_mesh(q->c, q->p, options, out);
}

// K on the mesh, and what the mesh leaves behind
static status solve_on_mesh(const solver *q, beam_law *out, mesh_options *used)
{
    const section_case *c = q->c;
    const bool drawn = q->p->drawn, warps = c->model != MODEL_CLASSICAL;
    const mesh_solver s = {
        .what = q,
        .solve = solve_mesh,
        .mesh = make_mesh,
        .graded = drawn,
        .materials = warps ? q->materials : NULL,
        .turning = warps && q->p->turn_rate != 0,
    };
    return c->tolerance > 0 && drawn && !(c->mesh.size > 0)
               ? estimate_meet(&s, &c->mesh, c->mesh.order_chosen, c->tolerance, out, used)
               : estimate_solve(&s, &c->mesh, out);
}

status section_solve_place(const section_case *c, const material *materials, const section_place *p,
                           beam_law *out, section_used *used)
{
    status st = OK;
    const solver q = {c, materials, p};
    bool closed = false;
    *out = (beam_law){0};
    used->mesh = c->mesh;
    if (c->model == MODEL_CLASSICAL && p->drawn) {
        TRY(section_classical_closed(&p->outline, materials, out, &closed));
        beam_law_set_error(out, closed_rounding);
    }
    used->meshed = !closed;
    if (!closed) {
        TRY(solve_on_mesh(&q, out, &used->mesh));
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
    section_used used;
    TRY(section_place_at(c, s, length, &p));
    TRY(section_solve_place(c, materials, &p, out, &used));

done:
    section_place_free(&p);
    return st;
}

status section_check(const section_case *c, const material *materials, double s, bool libraries,
                     mesh *out)
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
    if (out) {
        *out = m;
        m = (mesh){0};
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
