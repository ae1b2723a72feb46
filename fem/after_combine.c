// fem/after_combine.c
// Loads from the columns of a run, and what they do in every slice.
#include "fem/after_parts.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

vec6 after_tip_motion(const after *a, const double *factor)
{
    const way_run *run = a->run;
    vec6 q = {0};
    for (int j = 0; j < run->ncolumn; j++) {
        q = vec6_add(q, vec6_scale(factor[j], run->motion[(j + 1) * run->nlevel - 1]));
    }
    return q;
}

double after_energy(const after *a, const double *factor)
{
    double twice = 0;
    const int n = a->run->ncolumn;
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            twice += factor[i] * a->run->work[i * n + j] * factor[j];
        }
    }
    return twice / 2;
}

// (5.18): q = C w + q_e, with w_i + k_i q_i = F_i where the tip is free and q_i = d_i where it is
// moved; moments in units of the radius, so that rows and columns compare
status after_combine(const after *a, const tip_load *load, double *factor)
{
    double A[AFTER_MOST_UNKNOWNS][AFTER_MOST_UNKNOWNS] = {{0}}, b[6];
    const mat6 C = a->compliance;
    memset(factor, 0, 6 * sizeof *factor);
    const vec6 beside = after_tip_motion(a, factor);
    for (int i = 0; i < 6; i++) {
        const bool moved = !isnan(load->motion[i]);
        // an imposed motion is weighed as a spring of the tip's own stiffness
        const double unit = i < 3 ? 1 : a->radius, k = moved ? 1 / C.a[i][i] : load->spring[i];
        const double wanted = moved ? k * load->motion[i] : load->wrench.a[i];
        for (int j = 0; j < 6; j++) {
            const double column = j < 3 ? 1 : a->radius;
            A[i][j] = ((i == j && !moved ? 1 : 0) + k * C.a[i][j]) * column / unit;
        }
        b[i] = (wanted - k * beside.a[i]) / unit;
    }
    if (!after_solve(6, A, b)) {
        return status_fail(ERR_NUMERIC, "segment: the tip's imposed motions contradict each other");
    }
    for (int i = 0; i < 6; i++) {
        factor[i] = b[i] * (i < 3 ? 1 : a->radius);
    }
    return OK;
}

// --- slices

// strains of fitted motions: delta v = A^T (t' + r' x q), delta w = A^T q', (5.20); the body's
// frame does not turn with the pattern of a prism
static vec6 strain_of(const after *a, const section_pose *pose, vec3 along, vec6 motion, vec6 slope)
{
    const bool own = a->problem->body->spec.shape.place;
    const vec3 q = vec6_angular(motion);
    const vec3 v = vec3_add(vec6_linear(slope), vec3_cross(along, q)), w = vec6_angular(slope);
    return vec6_turned(own ? mat3_transpose(pose->axes) : mat3_identity(),
                       (vec6){{v.a[0], v.a[1], v.a[2], w.a[0], w.a[1], w.a[2]}});
}

// dr/ds of the origins; linear functions of s stay exact
static status tangents(const after *a, const after_line *line, vec6 *along)
{
    status st = OK;
    vec6 *origin = NULL;
    TRY(TAKE(origin, (size_t)line->n));
    for (int i = 0; i < line->n; i++) {
        memcpy(origin[i].a, a->pose[i].origin.a, sizeof a->pose[i].origin.a);
    }
    TRY(line_slopes(line, origin, along));

done:
    free(origin);
    return st;
}

// what acts on the tip by factors, about the section's origin there; a uniform traction acts at the
// area's centroid
static vec6 wrench_on_tip(const after *a, const double *factor)
{
    vec6 w;
    memcpy(w.a, factor, sizeof w.a);
    for (int j = 0; j < a->problem->nextra; j++) {
        const load_column *extra = &a->problem->extra[j];
        const double *f = extra->tip_force, *c = a->area_centroid, by = factor[6 + j];
        if (extra->uniform_tip) {
            const vec6 own = {{f[0], f[1], f[2], 0, 0, 0}};
            w = vec6_add(
                w, vec6_scale(by, wrench_about(own, (vec3){{c[0], c[1], 0}}, (vec3){{0, 0, 0}})));
        }
    }
    return w;
}

static vec6 sum_of(const after *a, const double *factor, const vec6 *columns, int slice)
{
    vec6 sum = {0};
    for (int j = 0; j < a->run->ncolumn; j++) {
        const size_t at = (size_t)j * (size_t)a->run->nlevel + (size_t)slice;
        sum = vec6_add(sum, vec6_scale(factor[j], columns[at]));
    }
    return sum;
}

status after_slices(const after *a, const double *factor, const slice_arrays *out)
{
    status st = OK;
    const way_run *run = a->run;
    const after_line line = after_line_of(a);
    const vec3 tip = a->pose[run->nlevel - 1].origin;
    vec6 *slope = NULL, *along = NULL;
    TRY(TAKE(slope, (size_t)run->nlevel));
    TRY(TAKE(along, (size_t)run->nlevel));
    TRY(tangents(a, &line, along));
    const vec6 on_tip = wrench_on_tip(a, factor);
    for (int i = 0; i < run->nlevel; i++) {
        out->motion[i] = sum_of(a, factor, run->motion, i);
        out->resultant[i] = sum_of(a, factor, run->resultant, i);
        out->load[i] = run->applied ? sum_of(a, factor, run->applied, i)
                                    : wrench_about(on_tip, tip, a->pose[i].origin);
    }
    TRY(line_slopes(&line, out->motion, slope));
    for (int i = 0; i < run->nlevel; i++) {
        out->strain[i] = strain_of(a, &a->pose[i], vec6_linear(along[i]), out->motion[i], slope[i]);
    }

done:
    free(slope);
    free(along);
    return st;
}

// what the run does not tell may act between base and tip
static bool only_tip_is_loaded(const segment_problem *p)
{
    bool only = p->nspring == 0 && p->nhold == 0;
    for (int j = 0; j < p->nextra; j++) {
        const load_column *c = &p->extra[j];
        only = only && c->npressure == 0 && !c->holds_move;
        for (int d = 0; d < 3; d++) {
            only = only && c->body_force[d] == 0 && c->acceleration[d] == 0;
        }
    }
    return only;
}

// loads that are this small beside the force that would store their energy are rounding: they
// balance themselves, as a pressure in a tube does
static const double SELF_BALANCED = 1e-8;

double after_balance(const after *a, const double *factor, const vec6 *resultant, const vec6 *load)
{
    double miss = 0, most = 0;
    if (!a->run->applied && !only_tip_is_loaded(a->problem)) {
        return NAN;
    }
    for (int i = 0; i < a->run->nlevel; i++) {
        for (int k = 0; k < 6; k++) {
            const double unit = k < 3 ? 1 : a->radius;
            miss = fmax(miss, fabs(resultant[i].a[k] - load[i].a[k]) / unit);
            most = fmax(most, fabs(load[i].a[k]) / unit);
        }
    }
    const double stored = sqrt(2 * fmax(after_energy(a, factor), 0) * a->EA / a->length);
    most = most < SELF_BALANCED * stored ? stored : most;
    return most > 0 ? miss / most : miss;
}
