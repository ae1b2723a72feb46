// reports/csv_sensitivity.c
// sensitivity.csv: a row per solution and parameter; monte_carlo.csv: per solution and quantity.
#include "reports/csv_kit.h"

#include <math.h>
#include <string.h>

static void write_move(csv *c, const run_result *r, int k, int i)
{
    const sensitivity_result *s = &r->sensitivity;
    const mover *p = &s->mover[k];
    const move *m = sensitivity_move(s, k, i);
    csv_real(c, s->solution[i] + 1);
    csv_text(c, p->name);
    csv_text(c, p->keys);
    csv_text(c, p->unit);
    csv_text(c, p->text);
    csv_text(c, p->end[MOVER_LOW].text);
    csv_text(c, p->end[MOVER_HIGH].text);
    csv_reals(c, 3, m->rate);
    csv_real(c, m->bend_rate);
    csv_real(c, m->rate_error);
    for (int end = 0; end < MOVER_ENDS; end++) {
        csv_reals(c, 3, m->moved[end]);
        csv_real(c, move_size(m, end));
        csv_real(c, move_size(m, end) / r->rod_length);
        csv_real(c, m->bend[end]);
        csv_real(c, p->discrete ? NAN : move_linear(p, m, end));
    }
}

static status write_moves(const run_result *r, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    csv_add_all(&h, "solution_count parameter keys unit as_it_is low high tip_x_rate_m_per_unit "
                    "tip_y_rate_m_per_unit tip_z_rate_m_per_unit bend_rate_rad_per_unit "
                    "rate_error_ratio");
    csv_add_all(&h, "low_tip_x_m low_tip_y_m low_tip_z_m low_tip_m low_tip_of_length_ratio "
                    "low_bend_rad low_by_derivative_m");
    csv_add_all(&h, "high_tip_x_m high_tip_y_m high_tip_z_m high_tip_m high_tip_of_length_ratio "
                    "high_bend_rad high_by_derivative_m");
    const status st = csv_table(dir, "sensitivity.csv", &h, &c);
    for (int i = 0; st == OK && i < r->sensitivity.nsolution; i++) {
        for (int k = 0; k < r->sensitivity.nmover; k++) {
            write_move(c, r, k, i);
        }
    }
    return st == OK ? csv_close(c) : st;
}

static void add_shares(csv_header *h, const sensitivity_result *s)
{
    for (int k = 0; k < s->nmover; k++) {
        char name[CSV_MAX_NAME];
        if (s->mover[k].drawn) {
            (void)snprintf(name, sizeof name, "share_of_%s_ratio", s->mover[k].name);
            for (char *blank = name; (blank = strchr(blank, ' ')) != NULL;) {
                *blank = '_';
            }
            csv_add(h, name);
        }
    }
}

static status write_monte_carlo(const run_result *r, const char *dir)
{
    // lengths and the bend stand in one column
    static const char *const names[SPREAD_QUANTITIES] = {"tip x", "tip y", "tip z", "tip off",
                                                         "total bend"};
    const sensitivity_result *s = &r->sensitivity;
    csv *c = NULL;
    csv_header h = {0};
    csv_add_all(&h, "solution_count samples_count quantity unit mean_in_unit deviation_in_unit "
                    "quantile_05_in_unit quantile_50_in_unit quantile_95_in_unit "
                    "share_of_no_single_one_ratio");
    add_shares(&h, s);
    const status st = csv_table(dir, "monte_carlo.csv", &h, &c);
    for (int i = 0; st == OK && i < s->nsolution * SPREAD_QUANTITIES; i++) {
        const int solution = i / SPREAD_QUANTITIES, quantity = i % SPREAD_QUANTITIES;
        const sample_spread *a = sensitivity_spread(s, solution, quantity);
        const double numbers[] = {a->mean, a->deviation, a->low, a->median, a->high, a->rest};
        csv_real(c, s->solution[solution] + 1);
        csv_real(c, s->monte_carlo.used[solution]);
        csv_text(c, names[quantity]);
        csv_text(c, quantity == SPREAD_BEND ? "rad" : "m");
        csv_reals(c, 6, numbers);
        for (int k = 0; k < s->nmover; k++) {
            if (s->mover[k].drawn) {
                csv_real(c, sensitivity_share(s, solution, quantity)[k]);
            }
        }
    }
    return st == OK ? csv_close(c) : st;
}

status csv_sensitivity(const run_result *r, const char *dir)
{
    status st = OK;
    if (!r->has_sensitivity) {
        return OK;
    }
    TRY(write_moves(r, dir));
    TRY(r->sensitivity.monte_carlo.nsample > 0 ? write_monte_carlo(r, dir) : OK);

done:
    return st;
}
