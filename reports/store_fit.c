// reports/store_fit.c
#include "reports/store_parts.h"

#include <stdio.h>

enum { MOST_SHAPES = 10000, MOST_FIT = 1 << 30 };

// passes what may be an empty array
static status pass_parameters(const passage *p, fit_result *f)
{
#define OF(member) offsetof(fit_parameter_told, member)
    static const column columns[] = {
        {"name", COLUMN_TEXT, "-", OF(name), 0, {FIT_NAME}, 0},
        {"unit", COLUMN_TEXT, "-", OF(unit), 0, {FIT_UNIT}, 0},
        {"keys", COLUMN_TEXT, "-", OF(keys), 0, {FIT_KEYS}, 0},
        {"start", COLUMN_REAL, "see unit", OF(start), 0, {0}, 0},
        {"lower", COLUMN_ANY, "see unit", OF(lower), 0, {0}, 0},
        {"upper", COLUMN_ANY, "see unit", OF(upper), 0, {0}, 0},
        {"to_si", COLUMN_REAL, "-", OF(to_si), 0, {0}, 0},
    };
#undef OF
    return passage_columns(p, "fit/parameter", COUNT_OF(columns), columns,
                           rows_of(f->parameter, f->answer.nunknown, sizeof *f->parameter));
}

// one array of the answer as a column of n plain numbers
static status pass_array(const passage *p, const char *name, int kind, int n, double *a)
{
    const column one = {name, kind, "see unit", 0, 0, {0}, 0};
    return passage_columns(p, "fit/answer", 1, &one, rows_of(a, n, sizeof *a));
}

static status pass_values(const passage *p, fit_answer *a)
{
    status st = OK;
    const int n = a->nunknown;
    TRY(pass_array(p, "value", COLUMN_REAL, n, a->value));
    TRY(pass_array(p, "standard_error", COLUMN_KNOWN, n, a->error));
    TRY(pass_array(p, "low", COLUMN_REAL, n, a->low));
    TRY(pass_array(p, "high", COLUMN_REAL, n, a->high));
    TRY(pass_array(p, "beyond", COLUMN_KNOWN, n, a->beyond));
    TRY(pass_array(p, "correlation", COLUMN_KNOWN, n * n, a->correlation));
    for (int i = 0; i < n && !p->reading; i++) {
        a->bound[i] += 1; // from 0 in the file
    }
    const column bound = {"bound", COLUMN_INT, "0 lower, 1 no, 2 upper", 0, 0, {0}, 2};
    st = passage_columns(p, "fit/answer", 1, &bound, rows_of(a->bound, n, sizeof *a->bound));
    for (int i = 0; i < n; i++) {
        a->bound[i] -= 1;
    }

done:
    return st;
}

static status pass_how(const passage *p, fit_result *f)
{
#define OF(member) offsetof(fit_result, member)
    static const column columns[] = {
        {"synthetic", COLUMN_FLAG, "-", OF(synthetic), 0, {0}, 0},
        {"source", COLUMN_TEXT, "-", OF(source), 0, {sizeof f->source}, 0},
        {"base", COLUMN_INT, "-", OF(base), 0, {0}, FIT_BASE_EACH},
        {"base_shift_m", COLUMN_REAL, "m", OF(base_shift), 0, {0}, 0},
        {"base_turn_rad", COLUMN_REAL, "rad", OF(base_turn), 0, {0}, 0},
        {"share", COLUMN_POSITIVE, "-", OF(share), 0, {0}, 0},
        {"condition", COLUMN_ANY, "-", OF(answer.condition), 0, {0}, 0},
        {"chi2", COLUMN_ANY, "-", OF(answer.chi2), 0, {0}, 0},
        {"freedom", COLUMN_INT, "-", OF(answer.freedom), 0, {0}, MOST_FIT},
        {"scale", COLUMN_ANY, "-", OF(answer.scale), 0, {0}, 0},
        {"quantile", COLUMN_ANY, "-", OF(answer.quantile), 0, {0}, 0},
        {"sigma_known", COLUMN_FLAG, "-", OF(answer.sigma_known), 0, {0}, 0},
        {"sigma_m", COLUMN_KNOWN, "m", OF(answer.sigma), 0, {0}, 0},
        {"correlation_length_m", COLUMN_REAL, "m", OF(answer.correlation_length), 0, {0}, 0},
        {"correlation_from", COLUMN_INT, "-", OF(answer.correlation_from), 0, {0}, FIT_BY_LINE},
        {"places", COLUMN_INT, "-", OF(answer.nplace), 0, {0}, MOST_FIT},
        {"starts", COLUMN_INT, "-", OF(answer.nstart), 0, {0}, MOST_FIT},
        {"ended", COLUMN_INT, "-", OF(answer.nended), 0, {0}, MOST_FIT},
        {"same", COLUMN_INT, "-", OF(answer.nsame), 0, {0}, MOST_FIT},
        {"next_chi2", COLUMN_ANY, "-", OF(answer.next_chi2), 0, {0}, 0},
        {"step_error", COLUMN_ANY, "-", OF(answer.step_error), 0, {0}, 0},
        {"solves", COLUMN_INT, "-", OF(answer.nsolve), 0, {0}, MOST_FIT},
    };
#undef OF
    return passage_columns(p, "fit", COUNT_OF(columns), columns, single(f));
}

static status pass_shape(const passage *p, const char *group, fit_shape_told *told, fit_match *m)
{
#define OF(member) offsetof(fit_match, member)
    static const column columns[] = {
        {"rms_m", COLUMN_REAL, "m", OF(rms), 1, {2}, 0},
        {"tip_m", COLUMN_KNOWN, "m", OF(tip), 1, {2}, 0},
        {"base", COLUMN_REAL, "m, rad", OF(base), 1, {6}, 0},
    };
#undef OF
    static const column at = {"s_m", COLUMN_REAL, "m", 0, 0, {0}, 0};
    static const column before = {"before_m", COLUMN_REAL, "m", 0, 0, {0}, 0};
    static const column after = {"after_m", COLUMN_REAL, "m", 0, 0, {0}, 0};
    status st = OK;
    int n = m->nstation;
    TRY(passage_words(p, passage_join(group, "name").text, told->name, sizeof told->name));
    TRY(passage_count(p, passage_join(group, "solution").text, 0, MOST_SOLUTIONS, &told->solution));
    TRY(passage_count(p, passage_join(group, "turn_free").text, 0, 1, &told->turn_free));
    TRY(passage_count(p, passage_join(group, "station_count").text, 1, MOST_POINTS, &n));
    TRY(p->reading ? fit_match_make(n, m) : OK);
    TRY(passage_columns(p, group, COUNT_OF(columns), columns, single(m)));
    TRY(passage_columns(p, group, 1, &at, rows_of(m->s, n, sizeof *m->s)));
    TRY(passage_columns(p, group, 1, &before, rows_of(m->before, n, sizeof *m->before)));
    TRY(passage_columns(p, group, 1, &after, rows_of(m->after, n, sizeof *m->after)));

done:
    return st;
}

status store_pass_fit(const passage *p, run_result *r)
{
    status st = OK;
    fit_result *f = &r->fit;
    int n = f->answer.nunknown, k = f->answer.nshape;
    if (p->reading ? !store_has(p->store, "fit/parameter_count") : !f->there) {
        return OK;
    }
    TRY(passage_count(p, "fit/parameter_count", 1, FIT_MOST_UNKNOWNS, &n));
    TRY(passage_count(p, "fit/shape_count", 1, MOST_SHAPES, &k));
    TRY(p->reading ? fit_result_make(n, k, f) : OK);
    f->there = true;
    TRY(pass_how(p, f));
    TRY(pass_parameters(p, f));
    TRY(pass_values(p, &f->answer));
    for (int i = 0; i < k; i++) {
        char group[PASSAGE_MAX_NAME];
        (void)snprintf(group, sizeof group, "fit/shape/%d", i);
        TRY(pass_shape(p, group, &f->shape[i], &f->answer.match[i]));
    }

done:
    return st;
}
