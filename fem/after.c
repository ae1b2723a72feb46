// fem/after.c
#include "fem/after_parts.h"

#include "base/memory.h"
#include "fem/level_fit.h"

#include <math.h>

// an origin this near to the base's z, over the length, is on it: rounding
static const double STRAIGHT = 1e-12;

void after_free(after *a)
{
    free(a->pose);
    free(a->curvature);
    *a = (after){0};
}

vec6 wrench_about(vec6 wrench, vec3 from, vec3 to)
{
    const vec3 turn = vec3_cross(vec3_sub(from, to), vec6_linear(wrench));
    for (int i = 0; i < 3; i++) {
        wrench.a[3 + i] += turn.a[i];
    }
    return wrench;
}

// --- where sections are: of any height, whichever levels this rank holds

status after_pose_at(const body *b, double s, section_pose *out)
{
    status st = OK;
    double *xyz = NULL;
    *out = (section_pose){.axes = mat3_identity(), .origin = {{0, 0, s}}};
    if (b->spec.shape.place) {
        TRY(TAKE(xyz, 3 * (size_t)b->plane->nnode));
        TRY(b->spec.shape.place(b->spec.shape.self, s, xyz, &out->axes, out->origin.a));
    } else if (!b->prism) {
        out->axes = mat3_rot_z(b->spec.turn_rate * s);
    }

done:
    free(xyz);
    return st;
}

static status find_poses(after *a)
{
    status st = OK;
    const body *b = a->problem->body;
    TRY(TAKE(a->pose, (size_t)a->run->nlevel));
    a->straight = true;
    for (int i = 0; i < a->run->nlevel; i++) {
        TRY(after_pose_at(b, a->run->z[i], &a->pose[i]));
        const double *at = a->pose[i].origin.a;
        a->straight = a->straight && hypot(at[0], at[1]) <= STRAIGHT * b->length;
    }
    TRY(after_pose_at(b, a->middle, &a->centre));

done:
    return st;
}

// --- sections' weights, of one layer that every rank can have by itself

static status fit_in_layer(const body *b, int layer, int level, level_weight weight, level_fit *out)
{
    status st = OK;
    body slab = {0};
    body_spec spec = b->spec;
    size_t elements = 0;
    for (int i = 0; i < b->plane->nblock; i++) {
        elements += (size_t)b->plane->block[i].nelem;
    }
    spec.nlayer = 1;
    spec.hold_first = spec.hold_last = 0; // of the slab all
    spec.layer = (double[]){b->level[layer * b->order], b->level[(layer + 1) * b->order]};
    spec.matter = spec.matter ? spec.matter + (size_t)layer * elements : NULL;
    TRY(body_make(&spec, &slab));
    TRY(level_fit_make(&slab, level, weight, out));

done:
    body_free(&slab);
    return st;
}

static void centroid_in_base(const after *a, const level_fit *fit, double out[2])
{
    const section_pose *tip = &a->pose[a->run->nlevel - 1];
    const vec3 c = mat3_mul_vec(tip->axes, (vec3){{fit->centroid[0], fit->centroid[1], 0}});
    out[0] = c.a[0];
    out[1] = c.a[1];
}

static status weigh_sections(after *a)
{
    status st = OK;
    const body *b = a->problem->body;
    level_fit by_E = {0}, by_area = {0}, middle = {0};
    int layer = 0;
    while (layer + 1 < b->nlayer && b->level[(layer + 1) * b->order] < a->middle) {
        layer++;
    }
    TRY(fit_in_layer(b, b->nlayer - 1, b->order, LEVEL_BY_E, &by_E));
    TRY(fit_in_layer(b, b->nlayer - 1, b->order, LEVEL_BY_AREA, &by_area));
    TRY(fit_in_layer(b, layer, b->order, LEVEL_BY_AREA, &middle));
    centroid_in_base(a, &by_E, a->tip_centroid);
    centroid_in_base(a, &by_area, a->area_centroid);
    a->EA = by_E.weight;
    a->area = middle.weight;

done:
    level_fit_free(&by_E);
    level_fit_free(&by_area);
    level_fit_free(&middle);
    return st;
}

// --- the unit solutions

after_line after_line_of(const after *a)
{
    const body *b = a->problem->body;
    const way_run *run = a->run;
    bool levels = run->nlevel == b->nlevel;
    for (int i = 0; levels && i < run->nlevel; i++) {
        levels = fabs(run->z[i] - b->level[i]) <= STRAIGHT * b->length;
    }
    return (after_line){.n = run->nlevel, .z = run->z, .order = levels ? b->order : 0};
}

static void find_compliance(after *a)
{
    const way_run *run = a->run;
    for (int j = 0; j < 6; j++) {
        const vec6 tip = run->motion[(j + 1) * run->nlevel - 1];
        for (int i = 0; i < 6; i++) {
            a->compliance.a[i][j] = tip.a[i];
        }
    }
    a->compliance = mat6_symmetric(a->compliance);
}

// Half width of the window over the length. The fit of a slope weighs its middle most, so it may be
// wide.
static const double CURVATURE_WINDOW = 0.25;

static status find_curvatures(after *a)
{
    status st = OK;
    const way_run *run = a->run;
    const after_line line = after_line_of(a);
    const double centre = (run->z[0] + run->z[run->nlevel - 1]) / 2;
    TRY(TAKE(a->curvature, (size_t)run->ncolumn));
    for (int j = 0; j < run->ncolumn; j++) {
        const vec6 slope = line_mean_slope(&line, run->motion + (size_t)j * (size_t)run->nlevel,
                                           centre, CURVATURE_WINDOW * a->length);
        const vec3 w = vec6_angular(slope);
        const vec3 kappa = a->straight ? w : mat3_tmul_vec(a->centre.axes, w);
        a->curvature[j][0] = kappa.a[0];
        a->curvature[j][1] = kappa.a[1];
    }

done:
    return st;
}

// the base's face carries what the middle does; every other takes a part of it
static bool is_walled(const segment_problem *p)
{
    bool walled = false;
    for (int i = 0; i < p->nspring; i++) {
        walled = walled || p->spring[i].on.face != FACE_BASE;
    }
    for (int i = 0; i < p->nhold; i++) {
        walled = walled || p->hold[i].on.face != FACE_BASE;
    }
    return walled;
}

status after_make(const segment_problem *p, const way_run *run, const way_wants *wants, after *out)
{
    status st = OK;
    after a = {.problem = p,
               .run = run,
               .middle = wants->middle,
               .middle_half = wants->middle_half,
               .radius = p->body->radius,
               .length = p->body->length,
               .walled = is_walled(p)};
    TRY(find_poses(&a));
    TRY(weigh_sections(&a));
    find_compliance(&a);
    TRY(find_curvatures(&a));
    TRY(a.walled ? OK : after_find_law(&a));
    *out = a;
    a = (after){0};

done:
    after_free(&a);
    return st;
}
