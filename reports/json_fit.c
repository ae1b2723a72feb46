// reports/json_fit.c
// The document of a fit. Numbers of a parameter stand in the unit of its keys, which is told, and
// in SI.
#include "reports/json_parts.h"

#include <math.h>

const char *const fit_base_names[] = {"fixed", "common", "each"};

static void write_parameter(json *j, const fit_result *f, int i)
{
    const fit_parameter_told *p = &f->parameter[i];
    const fit_answer *a = &f->answer;
    const double interval[2] = {a->low[i], a->high[i]};
    json_object(j, NULL);
    json_text(j, "name", p->name);
    json_text(j, "keys", p->keys);
    json_text(j, "unit", p->unit[0] ? p->unit : "1");
    json_real(j, "value", a->value[i]);
    json_real(j, "standard_error", a->error[i]);
    json_reals(j, "interval", 2, interval);
    json_real(j, "value_si", p->to_si * a->value[i]);
    json_real(j, "standard_error_si", p->to_si * a->error[i]);
    json_real(j, "start", p->start);
    json_real(j, "lower", p->lower);
    json_real(j, "upper", p->upper);
    json_text(j, "at_bound", a->bound[i] < 0 ? "lower" : a->bound[i] > 0 ? "upper" : "no");
    json_real(j, "beyond_bound", a->beyond[i]);
    json_object_end(j);
}

static void write_shape(json *j, const fit_result *f, int k)
{
    const fit_match *m = &f->answer.match[k];
    json_object(j, NULL);
    json_text(j, "name", f->shape[k].name);
    json_integer(j, "solution", f->shape[k].solution + 1);
    json_flag(j, "turn_free", f->shape[k].turn_free != 0);
    json_real(j, "rms_before_m", m->rms[0]);
    json_real(j, "rms_after_m", m->rms[1]);
    json_real(j, "tip_before_m", m->tip[0]);
    json_real(j, "tip_after_m", m->tip[1]);
    json_reals(j, "base_shift_m", 3, m->base.a);
    json_reals(j, "base_turn_rad", 3, m->base.a + 3);
    json_reals(j, "s_m", m->nstation, m->s);
    json_reals(j, "distance_before_m", m->nstation, m->before);
    json_reals(j, "distance_after_m", m->nstation, m->after);
    json_object_end(j);
}

static void write_how(json *j, const fit_result *f)
{
    const fit_answer *a = &f->answer;
    json_real(j, "chi2", a->chi2);
    json_integer(j, "degrees_of_freedom", a->freedom);
    json_real(j, "chi2_reduced", a->chi2 / a->freedom);
    json_real(j, "errors_scaled_by", a->scale);
    json_real(j, "interval_share", f->share);
    json_real(j, "student_quantile", a->quantile);
    json_flag(j, "sigma_known", a->sigma_known);
    json_real(j, "sigma_m", a->sigma);
    json_real(j, "correlation_length_m", a->correlation_length);
    json_text(j, "correlation_from", a->correlation_from == FIT_BY_LINE ? "line" : "residuals");
    json_integer(j, "places", a->nplace);
    json_text(j, "base", fit_base_names[f->base]);
    json_real(j, "base_shift_sigma_m", f->base_shift);
    json_real(j, "base_turn_sigma_rad", f->base_turn);
    json_integer(j, "starts", a->nstart);
    json_integer(j, "starts_that_converged", a->nended);
    json_integer(j, "starts_that_ended_here", a->nsame);
    json_real(j, "next_chi2", a->next_chi2);
    json_real(j, "derivative_relative_error", a->step_error);
    json_integer(j, "model_solves", a->nsolve);
}

status result_json_fit(json *j, const char *key, const run_result *r)
{
    const fit_result *f = &r->fit;
    const int n = f->answer.nunknown;
    json_begin(j, key, "stiffaxis/fit/1", r);
    json_flag(j, "synthetic", f->synthetic);
    json_text(j, "source", f->source);
    json_array(j, "parameters");
    for (int i = 0; i < n; i++) {
        write_parameter(j, f, i);
    }
    json_array_end(j);
    json_array(j, "correlation");
    for (int i = 0; i < n; i++) {
        json_reals(j, NULL, n, f->answer.correlation + (size_t)i * (size_t)n);
    }
    json_array_end(j);
    json_real(j, "condition", f->answer.condition);
    write_how(j, f);
    json_array(j, "shapes");
    for (int k = 0; k < f->answer.nshape; k++) {
        write_shape(j, f, k);
    }
    json_array_end(j);
    json_object_end(j);
    return OK;
}
