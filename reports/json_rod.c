// reports/json_rod.c
// The rod's document. Keys carry their unit; what is not known is null.
#include "reports/json_parts.h"

#include <math.h>

typedef struct rod_run rod_run;

static void write_mat3(json *j, const char *key, const mat3 *m)
{
    json_array(j, key);
    for (int i = 0; i < 3; i++) {
        json_reals(j, NULL, 3, m->a[i]);
    }
    json_array_end(j);
}

static void write_names(json *j, const char *key, int n, char (*names)[RESULT_NAME])
{
    json_array(j, key);
    for (int i = 0; i < n; i++) {
        json_text(j, NULL, names[i]);
    }
    json_array_end(j);
}

static void write_shape(json *j, const rod_result *rod, const rod_run *run)
{
    json_array(j, "shape");
    for (int i = 0; i < rod->npoint; i++) {
        json_object(j, NULL);
        json_real(j, "s_m", run->s[i]);
        json_reals(j, "p_m", 3, run->shape[i].p.a);
        json_reals(j, "strain", 3, run->stretch[i]);
        json_reals(j, "curvature_per_m", 3, run->curvature[i]);
        json_reals(j, "force_N", 3, run->wrench[i].a);
        json_reals(j, "moment_Nm", 3, &run->wrench[i].a[3]);
        json_reals(j, "tension_N", rod->ntendon, run->along + (size_t)i * (size_t)rod->ntendon);
        json_object_end(j);
    }
    json_array_end(j);
}

static void write_slack(json *j, const rod_result *rod, const rod_run *run)
{
    json_array(j, "slack");
    for (int i = 0; i < rod->ntendon; i++) {
        json_flag(j, NULL, result_is_slack(run, i));
    }
    json_array_end(j);
}

static void write_stability(json *j, const rod_run *run)
{
    static const char *const kinds[] = {"limit_point", "bifurcation"};
    if (run->stable < 0) {
        json_null(j, "stable"); // no potential: follower loads, friction
    } else {
        json_flag(j, "stable", run->stable == 1);
    }
    json_real(j, "eigenvalue", run->eigenvalue);
    json_real(j, "fraction", run->fraction);
    json_array(j, "critical_points");
    for (int i = 0; i < run->ncritical; i++) {
        const rod_critical *c = &run->critical[i];
        json_object(j, NULL);
        json_text(j, "kind", kinds[c->kind == CRITICAL_BIFURCATION]);
        json_real(j, "fraction", c->fraction);
        if (c->negative < 0) {
            json_null(j, "negative_directions");
        } else {
            json_integer(j, "negative_directions", c->negative);
        }
        json_object_end(j);
    }
    json_array_end(j);
}

static void write_twists(json *j, const char *key, int n, const vec6 *twists)
{
    json_array(j, key);
    for (int i = 0; i < n; i++) {
        json_reals(j, NULL, 6, twists[i].a);
    }
    json_array_end(j);
}

static void write_rates(json *j, const rod_result *rod, const rod_rates *rates)
{
    if (!rod->has_rates) {
        return;
    }
    json_object(j, "tip_derivatives");
    write_twists(j, "by_tension_per_N", rod->ntendon, rates->tension);
    write_twists(j, "by_pull_per_m", rod->ntendon, rates->pull);
    write_twists(j, "by_load_factor", rod->nload, rates->load);
    json_mat6(j, "compliance_space", rates->space);
    json_mat6(j, "compliance_body", rates->body);
    json_object_end(j);
}

static void write_run(json *j, const run_result *r, const rod_run *run)
{
    const rod_result *rod = &r->rod;
    json_object(j, NULL);
    json_reals(j, "tensions_N", rod->ntendon, run->tension);
    json_reals(j, "pulls_m", rod->ntendon, run->pull);
    write_slack(j, rod, run);
    json_reals(j, "load_factors", rod->nload, run->load);
    json_reals(j, "tip_position_m", 3, run->tip.p.a);
    write_mat3(j, "tip_rotation", &run->tip.R);
    json_real(j, "total_bend_rad", run->total_bend_rad);
    json_reals(j, "tendon_length_m", rod->ntendon, run->tendon_length);
    json_integer(j, "iterations", run->iterations);
    write_stability(j, run);
    json_real(j, "relative_error", run->relative_error);
    json_real(j, "residual", run->residual);
    json_real(j, "energy_J", run->energy);
    json_real(j, "work_J", run->work);
    json_real(j, "energy_misfit", result_energy_misfit(run));
    json_real(j, "largest_strain", run->largest_strain);
    json_run_strains(j, r, run);
    write_rates(j, rod, &run->rates);
    write_shape(j, rod, run);
    json_object_end(j);
}

status result_json_rod(json *j, const char *key, const run_result *r)
{
    const rod_result *rod = &r->rod;
    json_begin(j, key, "stiffaxis/rod/1", r);
    json_real(j, "length_m", r->rod_length);
    write_names(j, "tendons", rod->ntendon, rod->tendon_name);
    write_names(j, "loads", rod->nload, rod->load_name);
    json_array(j, "solutions");
    for (int i = 0; i < rod->nsolution; i++) {
        write_run(j, r, &rod->run[i]);
    }
    json_array_end(j);
    json_object_end(j);
    return OK;
}
