// measure/tensile.c
#include "measure/tensile_inside.h"

#include "base/memory.h"

#include <math.h>

enum { MOST_POINTS = 400, ENOUGH_POINTS = 150, MOST_ROUNDS = 8 };

tensile_rule tensile_rule_default(void)
{
    return (tensile_rule){.share = 0.95, .departure = 0.05};
}

// The stretch, on at most MOST_POINTS means; where few of them lie in it, again on its part of the
// curve, as long as that is closer and no less steep.
static status choose(const gsl_line_door *door, const tensile_curve *c, tensile_choice *out)
{
    status st = OK;
    tensile_curve thin = {0}, whole = {0};
    double end = c->strain[0];
    for (int i = 0; i < c->n; i++) {
        end = fmax(end, c->strain[i]);
    }
    TRY(tensile_thin(c, end, MOST_POINTS, &whole));
    for (int round = 0; round < MOST_ROUNDS; round++) {
        tensile_choice w = {0};
        tensile_curve_free(&thin);
        TRY(tensile_thin(c, end, MOST_POINTS, &thin));
        st = tensile_choose(door, &thin, &whole, &w);
        if (round > 0 &&
            (st == ERR_FILE || w.se > out->se || w.E + 3 * w.se < out->E - 3 * out->se)) {
            status_clear();
            st = OK;
            break;
        }
        TRY(st);
        *out = w;
        const double next = thin.strain[0] + 2 * (w.stretch.to - thin.strain[0]);
        if (thin.n > c->n / 2 || w.stretch.count >= ENOUGH_POINTS || next >= end) {
            break;
        }
        end = next;
    }

done:
    tensile_curve_free(&thin);
    tensile_curve_free(&whole);
    return st;
}

status tensile_measure(const tensile_curve *c, const tensile_rule *rule, tensile_answer *out)
{
    status st = OK;
    const gsl_line_door *line = NULL;
    const gsl_random_door *random = NULL;
    tensile_answer a = {0};
    tensile_curve loading = {0};
    tensile_choice w = {0};
    TRY(gsl_line_door_open(&line));
    TRY(gsl_random_door_open(&random));
    TRY(tensile_loading(c, &loading, &a));
    TRY(choose(line, &loading, &w));
    const double half = w.se * random->student(rule->share, w.fit.freedom);
    a.E = w.E;
    for (int i = 0; i < loading.n; i++) {
        a.end = i == 0 ? loading.strain[i] : fmax(a.end, loading.strain[i]);
    }
    a.standard_error = w.se;
    a.interval[0] = w.E - half;
    a.interval[1] = w.E + half;
    a.freedom = w.fit.freedom;
    a.strain_offset = w.zero;
    a.window[0] = w.stretch.from;
    a.window[1] = w.stretch.to;
    a.noise = w.fit.noise;
    a.correlation = w.fit.tau;
    a.nwindow = w.stretch.count;
    tensile_linear_range(&loading, &w, rule->departure, &a);
    *out = a;

done:
    tensile_curve_free(&loading);
    return st;
}
