// reports/csv_fit.c
#include "reports/csv_kit.h"

#include <math.h>
#include <stdio.h>

static status write_parameters(const fit_result *f, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    const fit_answer *a = &f->answer;
    csv_add_all(&h, "parameter keys unit value_in_unit standard_error_in_unit low_in_unit "
                    "high_in_unit start_in_unit at_bound data");
    for (int i = 0; i < a->nunknown; i++) {
        char name[CSV_MAX_NAME];
        (void)snprintf(name, sizeof name, "correlation_with_%d_ratio", i + 1);
        csv_add(&h, name);
    }
    const status st = csv_table(dir, "fit.csv", &h, &c);
    for (int i = 0; st == OK && i < a->nunknown; i++) {
        const fit_parameter_told *p = &f->parameter[i];
        csv_text(c, p->name);
        csv_text(c, p->keys);
        csv_text(c, p->unit);
        csv_real(c, a->value[i]);
        csv_real(c, a->error[i]);
        csv_real(c, a->low[i]);
        csv_real(c, a->high[i]);
        csv_real(c, p->start);
        csv_text(c, a->bound[i] < 0 ? "lower" : a->bound[i] > 0 ? "upper" : "no");
        csv_text(c, f->synthetic ? "synthetic" : "measured");
        csv_reals(c, a->nunknown, a->correlation + (size_t)i * (size_t)a->nunknown);
    }
    return st == OK ? csv_close(c) : st;
}

static status write_residuals(const fit_result *f, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    csv_add_all(&h, "shape s_m distance_before_m distance_after_m");
    const status st = csv_table(dir, "fit_residuals.csv", &h, &c);
    for (int k = 0; st == OK && k < f->answer.nshape; k++) {
        const fit_match *m = &f->answer.match[k];
        for (int i = 0; i < m->nstation; i++) {
            csv_text(c, f->shape[k].name);
            csv_real(c, m->s[i]);
            csv_real(c, m->before[i]);
            csv_real(c, m->after[i]);
        }
    }
    return st == OK ? csv_close(c) : st;
}

static status write_bases(const fit_result *f, const char *dir)
{
    csv *c = NULL;
    csv_header h = {0};
    csv_add_all(&h, "shape turn_about_z shift_x_m shift_y_m shift_z_m turn_x_rad turn_y_rad "
                    "turn_z_rad");
    const status st = csv_table(dir, "fit_bases.csv", &h, &c);
    for (int k = 0; st == OK && k < f->answer.nshape; k++) {
        csv_text(c, f->shape[k].name);
        csv_text(c, f->shape[k].turn_free ? "free" : "known");
        csv_reals(c, 6, f->answer.match[k].base.a);
    }
    return st == OK ? csv_close(c) : st;
}

status csv_fit(const fit_result *f, const char *dir)
{
    status st = OK;
    TRY(write_parameters(f, dir));
    TRY(write_residuals(f, dir));
    TRY(f->base != FIT_BASE_FIXED ? write_bases(f, dir) : OK);

done:
    return st;
}
