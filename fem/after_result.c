// fem/after_result.c
// From a run to what people read: segment_result and its loads.
#include "fem/after_parts.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

// a point this near to the centroid, over the section's radius, is the centroid: rounding and the
// mesh's own geometry
static const double CENTROID_TOLERANCE = 1e-4;

static status law_and_centres(const after *a, segment_result *r)
{
    status st = OK;
    TRY(after_middle(a, &r->middle));
    TRY(after_centre(a, r->stiffness_centre));
    TRY(after_tip_centre(a, r->tip_centre));
    TRY(after_end_length(a, r->end_length));

done:
    return st;
}

static status no_law(const after *a, segment_result *r)
{
    r->middle.area = a->area;
    for (int i = 0; i < 6; i++) {
        r->end_length[i] = NAN;
        for (int j = 0; j < 6; j++) {
            r->middle.K.a[i][j] = NAN;
        }
    }
    for (int i = 0; i < 2; i++) {
        r->stiffness_centre[i] = r->tip_centre[i] = NAN;
    }
    return OK;
}

status after_fill(const after *a, segment_result *r)
{
    status st = OK;
    const way_run *run = a->run;
    TRY(a->walled ? no_law(a, r) : law_and_centres(a, r));
    r->tip_compliance = a->compliance;
    r->dofs = run->dofs;
    r->residual = fmax(r->residual, run->residual);
    r->iterations = run->iterations;
    r->assemble_seconds += run->assemble_seconds;
    r->factor_seconds += run->factor_seconds;
    r->solve_seconds += run->solve_seconds;

done:
    return st;
}

// --- a load

static status check_uniform(const after *a, const after_ask *ask)
{
    const double *centroid = a->area_centroid, *point = ask->point;
    const double away = hypot(point[0] - centroid[0], point[1] - centroid[1]);
    if ((point[0] != 0 || point[1] != 0) && away > CENTROID_TOLERANCE * a->radius) {
        return status_fail(ERR_INPUT,
                           "load '%s': a uniform traction acts at the area's centroid (%.6g, %.6g) "
                           "mm, not at (%.6g, %.6g) mm",
                           ask->load->name, 1e3 * centroid[0], 1e3 * centroid[1], 1e3 * point[0],
                           1e3 * point[1]);
    }
    if (ask->load->moment[0] != 0 || ask->load->moment[1] != 0 || ask->load->moment[2] != 0) {
        return status_fail(ERR_INPUT, "load '%s': a uniform traction has no moment",
                           ask->load->name);
    }
    return OK;
}

// the wrench about the section's origin at the tip
static vec6 wrench_at_origin(const double *force, const double *moment, const double *point)
{
    vec6 w;
    memcpy(w.a, force, 3 * sizeof *force);
    memcpy(w.a + 3, moment, 3 * sizeof *moment);
    return wrench_about(w, (vec3){{point[0], point[1], 0}}, (vec3){{0, 0, 0}});
}

static status find_factors(const after *a, const after_ask *ask, double *factor)
{
    const segment_load *load = ask->load;
    tip_load on_tip = {0};
    for (int i = 0; i < 3 && ask->uniform >= 0; i++) {
        factor[ask->uniform + i] = load->force[i];
    }
    if (ask->uniform < 0) {
        on_tip.wrench = wrench_at_origin(load->force, load->moment, ask->point);
    }
    if (ask->column >= 0) {
        factor[ask->column] = 1;
    }
    for (int i = 0; i < 6; i++) {
        on_tip.spring[i] = ask->tip_spring[i];
    }
    (void)segment_tip_motion(load, on_tip.motion);
    return after_combine(a, &on_tip, factor);
}

// what acts on the tip from outside, its spring not among it: as given, and with the reactions
// where the tip's motion is
static void tell_wrench(const after *a, const after_ask *ask, const double *factor,
                        segment_load_result *out)
{
    const segment_load *load = ask->load;
    const vec6 q = after_tip_motion(a, factor);
    memcpy(out->point, ask->uniform >= 0 ? a->area_centroid : ask->point, sizeof out->point);
    memcpy(out->force, load->force, sizeof out->force);
    memcpy(out->moment, load->moment, sizeof out->moment);
    double motion[6];
    if (!segment_tip_motion(load, motion)) {
        return;
    }
    vec6 w = {0};
    if (ask->uniform >= 0) {
        w = wrench_at_origin(load->force, load->moment, out->point);
    }
    for (int i = 0; i < 6; i++) {
        w.a[i] += factor[i] + ask->tip_spring[i] * q.a[i];
    }
    w = wrench_about(w, (vec3){{0, 0, 0}}, (vec3){{out->point[0], out->point[1], 0}});
    memcpy(out->force, w.a, sizeof out->force);
    memcpy(out->moment, w.a + 3, sizeof out->moment);
}

static status keep_slices(const after *a, const double *factor, segment_load_result *out)
{
    status st = OK;
    const size_t n = (size_t)a->run->nlevel;
    slice_arrays at = {0};
    TRY(TAKE(at.motion, n));
    TRY(TAKE(at.resultant, n));
    TRY(TAKE(at.load, n));
    TRY(TAKE(at.strain, n));
    TRY(TAKE(out->slice, n));
    TRY(after_slices(a, factor, &at));
    out->nslice = a->run->nlevel;
    for (size_t i = 0; i < n; i++) {
        out->slice[i] = (segment_slice){.s = a->run->z[i],
                                        .motion = at.motion[i],
                                        .resultant = at.resultant[i],
                                        .load = at.load[i],
                                        .strain = at.strain[i]};
    }
    out->balance = after_balance(a, factor, at.resultant, at.load);

done:
    free(at.motion);
    free(at.resultant);
    free(at.load);
    free(at.strain);
    return st;
}

static status keep_fields(const after *a, const segment_body *here, const double *factor,
                          segment_load_result *out)
{
    status st = OK;
    const way_run *run = a->run;
    const size_t plane = 3 * (size_t)here->plane.nnode;
    const size_t all = plane * (size_t)(run->last - run->first);
    const size_t own = plane * (size_t)(here->last - here->first);
    double *u = NULL;
    TRY(TAKE(u, all));
    for (int j = 0; j < run->ncolumn; j++) {
        const double *column = run->u + (size_t)j * all;
        for (size_t i = 0; factor[j] != 0 && i < all; i++) {
            u[i] += factor[j] * column[i];
        }
    }
    TRY(TAKE(out->displacement, own));
    memcpy(out->displacement, u + plane * (size_t)(here->first - run->first), own * sizeof *u);
    if (here->apart.nnode > 0) {
        TRY(after_stress(here, a->problem->body, run, u, &out->stress));
    }

done:
    free(u);
    return st;
}

status after_load(const after *a, const after_ask *ask, segment_load_result *out)
{
    status st = OK;
    double *factor = NULL;
    TRY(ask->uniform >= 0 ? check_uniform(a, ask) : OK);
    TRY(TAKE(factor, (size_t)a->run->ncolumn));
    TRY(find_factors(a, ask, factor));
    // until a coarser mesh says more
    *out = (segment_load_result){.name = ask->load->name,
                                 .shortening_error = NAN,
                                 .tip_displacement_error = NAN,
                                 .tip_rotation_error = NAN,
                                 .mid_curvature_error = NAN,
                                 .strain_energy_error = NAN};
    tell_wrench(a, ask, factor, out);

    const vec6 q = after_tip_motion(a, factor);
    const double *centre = a->tip_centroid;
    out->shortening = -(q.a[NZ] + q.a[MX] * centre[1] - q.a[MY] * centre[0]);
    memcpy(out->tip_displacement, q.a, sizeof out->tip_displacement);
    memcpy(out->tip_rotation, q.a + 3, sizeof out->tip_rotation);
    for (int j = 0; j < a->run->ncolumn; j++) {
        out->mid_curvature[0] += factor[j] * a->curvature[j][0];
        out->mid_curvature[1] += factor[j] * a->curvature[j][1];
    }
    out->strain_energy = after_energy(a, factor);
    TRY(keep_slices(a, factor, out));
    TRY(ask->here ? keep_fields(a, ask->here, factor, out) : OK);

done:
    free(factor);
    return st;
}

// --- estimates

static double distance(int n, const double *a, const double *b)
{
    double sum = 0;
    for (int i = 0; i < n; i++) {
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return sqrt(sum);
}

static void load_errors(const segment_load_result *c, double factor, double law_factor,
                        segment_load_result *f)
{
    f->shortening_error = factor * fabs(c->shortening - f->shortening);
    f->tip_displacement_error = factor * distance(3, c->tip_displacement, f->tip_displacement);
    f->tip_rotation_error = factor * distance(3, c->tip_rotation, f->tip_rotation);
    f->mid_curvature_error = law_factor * distance(2, c->mid_curvature, f->mid_curvature);
    f->strain_energy_error = factor * fabs(c->strain_energy - f->strain_energy);
}

void after_errors(const segment_result *coarse, double factor, double law_factor,
                  segment_result *fine)
{
    const beam_law *old = &coarse->middle;
    beam_law *law = &fine->middle;
    fine->relative_error =
        factor * mat6_relative_error(coarse->tip_compliance, fine->tip_compliance);
    law->relative_error = law_factor * mat6_relative_error(old->K, law->K);
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            law->entry_error.a[i][j] = law_factor * fabs(old->K.a[i][j] - law->K.a[i][j]) /
                                       sqrt(law->K.a[i][i] * law->K.a[j][j]);
        }
    }
    fine->stiffness_centre_error =
        law_factor * distance(2, coarse->stiffness_centre, fine->stiffness_centre);
    for (int i = 0; i < fine->nload && i < coarse->nload; i++) {
        load_errors(&coarse->load[i], factor, law_factor, &fine->load[i]);
    }
}

static void raise_to(double least, double *error)
{
    *error = fmax(*error, least);
}

void after_no_better(const segment_result *coarse, segment_result *fine)
{
    const beam_law *old = &coarse->middle;
    raise_to(coarse->relative_error, &fine->relative_error);
    raise_to(old->relative_error, &fine->middle.relative_error);
    raise_to(coarse->stiffness_centre_error, &fine->stiffness_centre_error);
    for (int i = 0; i < 36; i++) {
        raise_to(old->entry_error.a[i / 6][i % 6], &fine->middle.entry_error.a[i / 6][i % 6]);
    }
    for (int i = 0; i < fine->nload && i < coarse->nload; i++) {
        const segment_load_result *c = &coarse->load[i];
        segment_load_result *f = &fine->load[i];
        raise_to(c->shortening_error, &f->shortening_error);
        raise_to(c->tip_displacement_error, &f->tip_displacement_error);
        raise_to(c->tip_rotation_error, &f->tip_rotation_error);
        raise_to(c->mid_curvature_error, &f->mid_curvature_error);
        raise_to(c->strain_energy_error, &f->strain_energy_error);
    }
}
