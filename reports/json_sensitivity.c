// reports/json_sensitivity.c
// "stiffaxis/sensitivity/1": SI, but the parameters' own values, which have the unit of their keys.
#include "reports/json_parts.h"

static void write_end(json *j, const mover_end *e)
{
    json_object(j, NULL);
    json_real(j, "value", e->value);
    json_text(j, "text", e->text);
    if (e->why[0]) {
        json_text(j, "why_not", e->why);
    }
    json_object_end(j);
}

static void write_mover(json *j, const mover *p)
{
    json_object(j, NULL);
    json_text(j, "name", p->name);
    json_text(j, "keys", p->keys);
    json_text(j, "unit", p->unit);
    json_flag(j, "discrete", p->discrete);
    json_real(j, "value", p->value);
    json_text(j, "text", p->text);
    json_array(j, p->discrete ? "alternative" : "range");
    for (int end = 0; end < MOVER_ENDS; end++) {
        if (p->end[end].asked) {
            write_end(j, &p->end[end]);
        }
    }
    json_array_end(j);
    if (p->sigma > 0) {
        json_real(j, "sigma", p->sigma);
    }
    if (p->no_rate[0]) {
        json_text(j, "why_no_derivative", p->no_rate);
    }
    json_object_end(j);
}

static void write_move(json *j, const run_result *r, const mover *p, const move *m)
{
    json_object(j, NULL);
    json_text(j, "name", p->name);
    json_reals(j, "tip_rate_m_per_unit", 3, m->rate);
    json_real(j, "bend_rate_rad_per_unit", m->bend_rate);
    json_real(j, "rate_error", m->rate_error);
    json_real(j, "largest_m", move_largest(m));
    json_real(j, "largest_of_length", move_largest(m) / r->rod_length);
    json_array(j, "ends");
    for (int end = 0; end < MOVER_ENDS; end++) {
        if (!p->end[end].asked) {
            continue;
        }
        json_object(j, NULL);
        json_reals(j, "tip_moves_m", 3, m->moved[end]);
        json_real(j, "tip_moves_by_m", move_size(m, end));
        json_real(j, "bend_changes_rad", m->bend[end]);
        json_real(j, "fraction", m->reached[end]);
        json_real(j, "derivative_alone_m", move_linear(p, m, end));
        json_real(j, "derivative_is_off", move_nonlinearity(p, m, end, r->rod_length));
        json_object_end(j);
    }
    json_array_end(j);
    json_object_end(j);
}

static void write_solution(json *j, const run_result *r, int solution)
{
    const sensitivity_result *s = &r->sensitivity;
    json_object(j, NULL);
    json_integer(j, "solution", s->solution[solution] + 1);
    json_reals(j, "tensions_N", r->rod.ntendon, r->rod.run[s->solution[solution]].tension);
    json_reals(j, "tip_position_m", 3, r->rod.run[s->solution[solution]].tip.p.a);
    json_real(j, "total_bend_rad", r->rod.run[s->solution[solution]].total_bend_rad);
    json_array(j, "moves");
    for (int k = 0; k < s->nmover; k++) {
        write_move(j, r, &s->mover[k], sensitivity_move(s, k, solution));
    }
    json_array_end(j);
    json_object_end(j);
}

static void write_spread(json *j, const sensitivity_result *s, int solution, int quantity)
{
    static const char *const names[SPREAD_QUANTITIES] = {"tip_x_m", "tip_y_m", "tip_z_m",
                                                         "tip_off_m", "total_bend_rad"};
    const sample_spread *a = sensitivity_spread(s, solution, quantity);
    const double *share = sensitivity_share(s, solution, quantity);
    json_object(j, names[quantity]);
    json_real(j, "mean", a->mean);
    json_real(j, "deviation", a->deviation);
    json_real(j, "quantile_05", a->low);
    json_real(j, "quantile_50", a->median);
    json_real(j, "quantile_95", a->high);
    json_object(j, "share_of_variance");
    for (int k = 0; k < s->nmover; k++) {
        if (s->mover[k].drawn) {
            json_real(j, s->mover[k].name, share[k]);
        }
    }
    json_object_end(j);
    json_real(j, "share_of_no_single_one", a->rest);
    json_object_end(j);
}

static void write_monte_carlo(json *j, const sensitivity_result *s)
{
    const monte_carlo *m = &s->monte_carlo;
    json_object(j, "monte_carlo");
    json_integer(j, "samples", m->nsample);
    json_integer(j, "seed", m->seed);
    json_integer(j, "degree_of_shares", m->degree);
    json_array(j, "solutions");
    for (int i = 0; i < s->nsolution; i++) {
        json_object(j, NULL);
        json_integer(j, "solution", s->solution[i] + 1);
        json_integer(j, "samples_with_answer", m->used[i]);
        for (int q = 0; q < SPREAD_QUANTITIES; q++) {
            write_spread(j, s, i, q);
        }
        json_object_end(j);
    }
    json_array_end(j);
    json_object_end(j);
}

status result_json_sensitivity(json *j, const char *key, const run_result *r)
{
    const sensitivity_result *s = &r->sensitivity;
    json_begin(j, key, "stiffaxis/sensitivity/1", r);
    json_flag(j, "own_list", s->own_list);
    json_real(j, "length_m", r->rod_length);
    json_array(j, "parameters");
    for (int k = 0; k < s->nmover; k++) {
        write_mover(j, &s->mover[k]);
    }
    json_array_end(j);
    json_array(j, "solutions");
    for (int i = 0; i < s->nsolution; i++) {
        write_solution(j, r, i);
    }
    json_array_end(j);
    if (s->monte_carlo.nsample > 0) {
        write_monte_carlo(j, s);
    }
    json_object_end(j);
    return OK;
}
