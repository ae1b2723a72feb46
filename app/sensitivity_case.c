// app/sensitivity_case.c
#include "app/case_value.h"
#include "app/sensitivity.h"

#include <math.h>
#include <string.h>

// --- keys

#define COUNT(list) ((int)(sizeof(list) / sizeof *(list)))
#define MOST 1e30 // of a number whose unit is not known here

#define NUMBER(word, member, text)                                                                 \
    {                                                                                              \
        .name = word, .kind = KEY_REAL, .min = -MOST, .max = MOST,                                 \
        .offset = offsetof(sensitivity_parameter, member), .about = text                           \
    }

static const key parameter_keys[] = {
    PARAMETER_KEYS,
    NUMBER("low", low, "the low end of its range, in the unit of the keys' spelling"),
    NUMBER("high", high, "the high end"),
    {.name = "alternative",
     .kind = KEY_NAME,
     .offset = offsetof(sensitivity_parameter, alternative),
     .about = "instead of a range: another value, as the case would have it (full, pi/16, \"pi/2 - "
              "(pi/4)*(s/L)\")"},
    {.name = "distribution",
     .kind = KEY_CHOICE,
     .choices = "uniform|normal",
     .initial = "uniform",
     .offset = offsetof(sensitivity_parameter, distribution),
     .about =
         "in the Monte-Carlo runs: uniform from low to high, or normal about the case's value, "
         "cut off at low and high where these are given"},
    {.name = "sigma",
     .kind = KEY_REAL,
     .min = 1e-30,
     .max = MOST,
     .offset = offsetof(sensitivity_parameter, sigma),
     .about =
         "standard deviation of the normal distribution; without low and high the range is two "
         "of it to both sides"},
};

static const sensitivity_parameter parameter_initial = {.low = NAN, .high = NAN, .sigma = NAN};

static const key_table parameter_table = {
    .name = "sensitivity_parameter",
    .size = sizeof(sensitivity_parameter),
    .nkey = COUNT(parameter_keys),
    .keys = parameter_keys,
    .initial = &parameter_initial,
    .about = "a parameter that may move the answer: low and high, or an alternative, or a sigma",
};

static const key monte_carlo_keys[] = {
    {.name = "samples",
     .kind = KEY_INTEGER,
     .min = 10,
     .max = MONTE_CARLO_SAMPLES,
     .required = true,
     .offset = offsetof(monte_carlo_case, samples),
     .about = "how many times all parameters with a range are drawn"},
    {.name = "seed",
     .kind = KEY_INTEGER,
     .min = 0,
     .max = 2147483647,
     .initial = "1",
     .offset = offsetof(monte_carlo_case, seed),
     .about = "of the random numbers: the same seed gives the same samples, and the same answer to "
              "the last bit"},
};

static const monte_carlo_case monte_carlo_initial = {.seed = 1};

static const key_table monte_carlo_table = {
    .name = "monte_carlo",
    .size = sizeof(monte_carlo_case),
    .nkey = COUNT(monte_carlo_keys),
    .keys = monte_carlo_keys,
    .initial = &monte_carlo_initial,
    .about = "the solutions with parameters drawn at random",
};

static const key sensitivity_key_list[] = {
    {.name = "parameters",
     .kind = KEY_LIST,
     .max_count = SENSITIVITY_PARAMETERS,
     .offset = offsetof(sensitivity_case, parameters),
     .table = &parameter_table,
     .about =
         "what may be otherwise; left out: tendon radii by 0.1 mm, nu 0.3 to 0.49, the stiffest "
         "modulus by 10 %, friction to 0.2, the section's other model"},
    {.name = "solutions",
     .kind = KEY_ROWS,
     .min = 1,
     .max = 1e6,
     .max_count = SENSITIVITY_SOLUTIONS,
     .offset = offsetof(sensitivity_case, solutions),
     .about = "which of the rod's solutions, counted from 1; left out: all"},
    {.name = "monte_carlo",
     .kind = KEY_TABLE,
     .offset = offsetof(sensitivity_case, monte_carlo),
     .table = &monte_carlo_table,
     .about = "random samples of all parameters that have a range"},
};

const key_table sensitivity_keys = {
    .name = "sensitivity",
    .size = sizeof(sensitivity_case),
    .nkey = COUNT(sensitivity_key_list),
    .keys = sensitivity_key_list,
    .about =
        "what moves the answer: derivatives, whole solves at the ends of ranges, random samples",
};

// --- checks

static const sensitivity_parameter *parameter_at(const case_data *c, int i)
{
    return (const sensitivity_parameter *)c->file.sensitivity.parameters.items + i;
}

static status check_range(const case_data *c, const sensitivity_parameter *q)
{
    const bool low = !isnan(q->low), high = !isnan(q->high), sigma = !isnan(q->sigma);
    const char *name = q->p.name;
    if (q->alternative.text) {
        return low || high || sigma
                   ? config_fail(c->config, q->alternative.at,
                                 "parameter '%.60s' has a range and an alternative: give one", name)
                   : OK;
    }
    if (low != high) {
        return config_fail(c->config, q->p.at,
                           "parameter '%.60s' has one end of a range only: give "
                           "low and high",
                           name);
    }
    if (!low && !sigma) {
        return config_fail(c->config, q->p.at,
                           "parameter '%.60s' has neither a range (low, high) nor an alternative",
                           name);
    }
    if (low && !(q->low < q->high)) {
        return config_fail(c->config, q->p.at, "parameter '%.60s': low %g is not below high %g",
                           name, q->low, q->high);
    }
    if ((q->distribution == DRAW_NORMAL) != sigma) {
        return config_fail(c->config, q->p.at,
                           sigma ? "parameter '%.60s' has a sigma: say `distribution: normal`"
                                 : "parameter '%.60s' is normal: give its sigma",
                           name);
    }
    return OK;
}

// a range belongs to numbers, and a normal spread to one that is known
static status check_values(const case_data *c, const sensitivity_parameter *q)
{
    status st = OK;
    for (int i = 0; i < q->p.keys.count; i++) {
        const key_text *k = (const key_text *)q->p.keys.items + i;
        case_value v;
        TRY(case_value_find(c, k->text, k->at, &v));
        if (q->alternative.text) {
            continue;
        }
        if (v.text || v.key->kind == KEY_FLAG) {
            TRY(config_fail(c->config, k->at,
                            "'%.60s' is no number and has no range: give an alternative", k->text));
        }
        if (!isnan(q->sigma) && isnan(v.number)) {
            TRY(config_fail(c->config, k->at,
                            "'%.60s' is not one number in this case: a normal spread needs its "
                            "middle",
                            k->text));
        }
    }

done:
    return st;
}

static status check_solutions(const case_data *c)
{
    const sensitivity_case *s = &c->file.sensitivity;
    const int count = rod_case_solutions(&c->file.rod);
    if (s->solutions.nrow > 1) {
        return config_fail(c->config, s->solutions.at, "solutions are one list: [1, 3]");
    }
    for (int i = 0; i < s->solutions.ncol * s->solutions.nrow; i++) {
        const double wanted = s->solutions.a[i];
        if (wanted != floor(wanted) || wanted > count) {
            return config_fail(c->config, s->solutions.at,
                               "there is no solution %g: the rod has %d", wanted, count);
        }
        for (int k = 0; k < i; k++) {
            if (s->solutions.a[k] == wanted) {
                return config_fail(c->config, s->solutions.at, "solution %g is named twice",
                                   wanted);
            }
        }
    }
    const int chosen = s->solutions.nrow > 0 ? s->solutions.ncol : count;
    if (chosen > SENSITIVITY_SOLUTIONS) {
        return config_fail(
            c->config, s->at,
            "%d solutions are more than the %d that a sensitivity follows: choose by "
            "`solutions`",
            chosen, SENSITIVITY_SOLUTIONS);
    }
    return OK;
}

status sensitivity_check(const case_data *c)
{
    status st = OK;
    const sensitivity_case *s = &c->file.sensitivity;
    if (!case_has_rod(c)) {
        return config_fail(c->config, s->at, "a sensitivity is about a rod, and the case has none");
    }
    TRY(check_solutions(c));
    for (int i = 0; i < s->parameters.count; i++) {
        const sensitivity_parameter *q = parameter_at(c, i);
        TRY(parameter_check(c, &q->p));
        for (int k = 0; k < i; k++) {
            TRY(parameters_differ(c, &parameter_at(c, k)->p, &q->p));
        }
        TRY(check_range(c, q));
        TRY(check_values(c, q));
    }

done:
    return st;
}
