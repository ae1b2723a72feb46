// app/fit_case.c
#include "app/fit_case.h"

#include "app/case.h"
#include "app/case_value.h"
#include "app/variation.h"
#include "measure/shape_fit.h"

#include <math.h>

static const key parameter_keys[] = {
    PARAMETER_KEYS,
    {.name = "start",
     .kind = KEY_REAL,
     .required = true,
     .offset = offsetof(fit_parameter, start),
     .about = "where the search begins, in the unit of the keys"},
    {.name = "lower",
     .kind = KEY_REAL,
     .offset = offsetof(fit_parameter, lower),
     .about = "bound; with both bounds searches begin at random places between them too"},
    {.name = "upper", .kind = KEY_REAL, .offset = offsetof(fit_parameter, upper), .about = "bound"},
};

static const fit_parameter parameter_initial = {.start = NAN, .lower = NAN, .upper = NAN};

static const key_table fit_parameter_keys = {
    .name = "fit parameter",
    .size = sizeof(fit_parameter),
    .nkey = (int)(sizeof parameter_keys / sizeof *parameter_keys),
    .keys = parameter_keys,
    .initial = &parameter_initial,
    .about = "A number that the case leaves open.",
};

static const key keys[] = {
    {.name = "parameters",
     .kind = KEY_LIST,
     .max_count = FIT_MOST_UNKNOWNS,
     .required = true,
     .offset = offsetof(fit_case, parameters),
     .table = &fit_parameter_keys,
     .about = "what is fitted"},
    {.name = "base",
     .kind = KEY_CHOICE,
     .choices = "fixed|common|each",
     .initial = "each",
     .offset = offsetof(fit_case, base),
     .about = "how the measured shapes may lie off the model's base: not at all, all by one small "
              "motion (scanned without taking the rod down), each by its own (registered each "
              "time)"},
    {.name = "base_shift",
     .kind = KEY_REAL,
     .dimension = DIM_LENGTH,
     .min = 1e-9,
     .max = 1,
     .initial = "0.1",
     .offset = offsetof(fit_case, base_shift),
     .about = "standard deviation of the base's place, each component"},
    {.name = "base_turn",
     .kind = KEY_REAL,
     .dimension = DIM_ANGLE,
     .min = 1e-9,
     .max = 1,
     .initial = "0.01",
     .offset = offsetof(fit_case, base_turn),
     .about = "standard deviation of the base's direction and turn, each component"},
    {.name = "starts",
     .kind = KEY_INTEGER,
     .min = 1,
     .max = FIT_MOST_STARTS,
     .initial = "4",
     .offset = offsetof(fit_case, starts),
     .about = "searches: the first from the start values, the others from random places between "
              "the bounds"},
    {.name = "seed",
     .kind = KEY_INTEGER,
     .min = 0,
     .max = 2147483647,
     .initial = "1",
     .offset = offsetof(fit_case, seed),
     .about = "of these places"},
    {.name = "interval",
     .kind = KEY_REAL,
     .min = 0.5,
     .max = 0.9999,
     .initial = "0.95",
     .offset = offsetof(fit_case, interval),
     .about = "share of the intervals that are told"},
};

fit_case fit_case_default(void)
{
    return (fit_case){
        .base = FIT_BASE_EACH, // a scan is registered anew each time
        .base_shift = 1e-4,    // a scanner's own error
        .base_turn = 0.01,     // 0.05 mm of it over a plate of some 10 mm
        .starts = 4,
        .seed = 1,
        .interval = 0.95,
    };
}

const key_table fit_keys = {
    .name = "fit",
    .size = sizeof(fit_case),
    .nkey = (int)(sizeof keys / sizeof *keys),
    .keys = keys,
    .about = "Numbers that the case leaves open, fitted to its measured shapes.",
};

bool case_has_fit(const case_data *c)
{
    return mark_given(c->file.fit.at);
}

status case_need_fit(const case_data *c)
{
    return case_has_fit(c) ? OK
                           : config_fail(c->config, (mark){1, 1},
                                         "the case has no 'fit'; docs/measurements.md shows one");
}

static status check_bounds(const case_data *c, const fit_parameter *p)
{
    const char *name = p->what.name;
    if (p->lower >= p->upper) {
        return config_fail(c->config, p->what.at,
                           "parameter '%.60s': lower = %g does not lie below upper = %g", name,
                           p->lower, p->upper);
    }
    if (p->start < p->lower || p->start > p->upper) {
        return config_fail(c->config, p->what.at,
                           "parameter '%.60s': start = %g lies outside its bounds, %g to %g", name,
                           p->start, p->lower, p->upper);
    }
    if (p->start == 0 && !(p->lower < p->upper)) {
        return config_fail(c->config, p->what.at,
                           "parameter '%.60s' starts at 0 and has no bounds: nothing tells how "
                           "large it may be; give lower and upper",
                           name);
    }
    return OK;
}

status fit_case_start(const fit_case *f, settings *out)
{
    status st = OK;
    const fit_parameter *p = f->parameters.items;
    for (int i = 0; i < f->parameters.count; i++) {
        TRY(settings_add(out, &p[i].what, p[i].start));
    }

done:
    return st;
}

// A start so many times the case's own value, or that part of it, is in another unit.
static const double another_unit = 100;

static status check_start(const case_data *c, const fit_parameter *p)
{
    status st = OK;
    double factor = 0;
    const char *unit = parameter_unit(&p->what, &factor);
    if (!unit[0]) {
        return OK;
    }
    for (int i = 0; i < p->what.keys.count; i++) {
        const key_text *k = (const key_text *)p->what.keys.items + i;
        case_value v;
        if (case_value_find(c, k->text, k->at, &v) != OK) {
            status_clear(); // variation_check says why
            return OK;
        }
        const double ratio = fabs(p->start / v.number);
        if (v.text || isnan(ratio) || p->start == 0 || v.number == 0 ||
            (ratio < another_unit && ratio > 1 / another_unit)) {
            continue;
        }
        TRY(config_fail(c->config, p->what.at,
                        "parameter '%.60s': start = %g is %.3g times the case's own %.60s = %g: "
                        "start, lower and upper are in the key's unit, %s",
                        p->what.name, p->start, ratio, k->text, v.number, unit));
    }

done:
    return st;
}

// each key on its own, so that the message names the parameter whose key it is
static status check_keys(const case_data *c, const fit_parameter *p)
{
    status st = OK;
    settings s = {0};
    TRY(settings_add(&s, &p->what, p->start));
    TRY(variation_check(c, &s, p->what.at));

done:
    settings_free(&s);
    return st;
}

status case_fit_check(const case_data *c)
{
    status st = OK;
    const fit_case *f = &c->file.fit;
    const fit_parameter *p = f->parameters.items;
    if (f->parameters.count == 0) {
        return config_fail(c->config, f->at, "'fit' names no parameters");
    }
    if (!case_has_rod(c) || c->file.measured.shapes.count == 0) {
        return config_fail(c->config, f->at,
                           "'fit' needs shapes to fit to: the case has no 'measured.shapes'");
    }
    for (int i = 0; i < f->parameters.count; i++) {
        TRY(parameter_check(c, &p[i].what));
        TRY(check_bounds(c, &p[i]));
        for (int j = 0; j < i; j++) {
            TRY(parameters_differ(c, &p[j].what, &p[i].what));
        }
    }
    for (int i = 0; i < f->parameters.count; i++) {
        TRY(check_start(c, &p[i]));
        TRY(check_keys(c, &p[i]));
    }

done:
    return st;
}
