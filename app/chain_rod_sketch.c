// app/chain_rod_sketch.c
// What pictures of a rod show beside its solutions: loads, paths of tendons, the shape at rest.
#include "app/chain.h"
#include "base/memory.h"
#include "rodsolver/routing.h"
#include "rodsolver/tendon_table.h"

#include <math.h>

static vec3 vector_at(const field f[3], double s)
{
    return (vec3){{field_at(&f[0], s), field_at(&f[1], s), field_at(&f[2], s)}};
}

static rod_load_sketch sketch_point(const point_load *load, double length)
{
    const double s = fmin(load->s, length);
    rod_load_sketch out = {.kind = LOAD_AT_POINT, .frame = load->frame, .from = s, .to = s};
    for (int k = 0; k < LOAD_PLACES; k++) {
        for (int i = 0; i < 3; i++) {
            out.force[k].a[i] = load->force[i];
            out.moment[k].a[i] = load->moment[i];
        }
        out.place[k][0] = load->place[0];
        out.place[k][1] = load->place[1];
    }
    return out;
}

static rod_load_sketch sketch_line(const line_load *load, double length)
{
    rod_load_sketch out = {.kind = LOAD_ALONG_LINE,
                           .frame = load->frame,
                           .from = load->from,
                           .to = load->to > 0 ? fmin(load->to, length) : length};
    for (int k = 0; k < LOAD_PLACES; k++) {
        const double s = out.from + (out.to - out.from) * k / (LOAD_PLACES - 1);
        out.force[k] = vector_at(load->force, s);
        out.moment[k] = vector_at(load->moment, s);
        out.place[k][0] = field_at(&load->place[0], s);
        out.place[k][1] = field_at(&load->place[1], s);
    }
    return out;
}

static void sketch_loads(const rod_case *rc, rod_result *rods)
{
    const point_load *points = rc->loads.items;
    const line_load *lines = rc->line_loads.items;
    rod_load_sketch *out = rods->load_sketch;
    for (int i = 0; i < rc->loads.count; i++) {
        *out++ = sketch_point(&points[i], rc->length);
    }
    for (int i = 0; i < rc->line_loads.count; i++) {
        *out++ = sketch_line(&lines[i], rc->length);
    }
    if (rod_case_has_gravity(rc)) {
        const double *g = rc->gravity;
        *out = (rod_load_sketch){
            .kind = LOAD_GRAVITY, .to = rc->length, .acceleration = {{g[0], g[1], g[2]}}};
    }
}

// where the solver has it: the table's curve, not the straight lines between its points
static status lay_tendon(const tendon_spec *tendon, double length, int npoint, double *end,
                         double (*path)[2])
{
    status st = OK;
    tendon_spec t = *tendon;
    spline table = {0};
    t.end = t.end > 0 ? fmin(t.end, length) : length;
    TRY(tendon_table_fit(&t, &table));
    for (int k = 0; k < npoint; k++) {
        const double s = fmin(length * k / (npoint - 1), t.end);
        double at[2] = {0, 0}, slope[2];
        routing_place(&t, s, &path[k][0], &path[k][1]);
        if (t.table.count > 0) {
            spline_at(&table, s, at, slope);
        }
        path[k][0] += at[0];
        path[k][1] += at[1];
    }
    *end = t.end;

done:
    spline_free(&table);
    return st;
}

static status lay_tendons(const rod_case *rc, rod_result *rods)
{
    status st = OK;
    for (int i = 0; i < rods->ntendon; i++) {
        TRY(lay_tendon(&rc->spec[i], rc->length, rods->npoint, &rods->tendon_end[i],
                       rods->tendon_path + (size_t)i * (size_t)rods->npoint));
    }

done:
    return st;
}

// without tension or load
static status find_rest(rod_state *state, const rod_case *rc, rod_result *rods)
{
    status st = OK;
    double *s = NULL, *load = NULL;
    rod_solution solution = {0};
    const pose base = rod_case_base(rc);
    TRY(TAKE(s, (size_t)rods->npoint));
    TRY(TAKE(load, (size_t)rods->nload));
    const rod_request nothing = {.load = load, .base = &base, .cold = true};
    TRY(rod_solve(state, &nothing, &solution));
    TRY(rod_shape(state, rods->npoint, s, rods->rest));

done:
    free(s);
    free(load);
    return st;
}

status chain_rod_sketch(const rod_case *rc, rod_state *state, rod_result *rods)
{
    status st = OK;
    sketch_loads(rc, rods);
    TRY(lay_tendons(rc, rods));
    TRY(find_rest(state, rc, rods));

done:
    return st;
}
