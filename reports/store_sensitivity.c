// reports/store_sensitivity.c
// Behind the rod, whose solutions it is about. A result from before there was such a part has none.
#include "reports/store_parts.h"

static status pass_movers(const passage *p, sensitivity_result *s)
{
#define MOVER(member) offsetof(mover, member)
#define END(k, member) offsetof(mover, end[k].member)
    static const column columns[] = {
        {"name", COLUMN_TEXT, "-", MOVER(name), 0, {MOVER_NAME}, 0},
        {"keys", COLUMN_TEXT, "-", MOVER(keys), 0, {MOVER_KEYS}, 0},
        {"unit", COLUMN_TEXT, "-", MOVER(unit), 0, {MOVER_UNIT}, 0},
        {"discrete", COLUMN_FLAG, "-", MOVER(discrete), 0, {0}, 0},
        {"value", COLUMN_KNOWN, "see unit", MOVER(value), 0, {0}, 0},
        {"text", COLUMN_TEXT, "-", MOVER(text), 0, {MOVER_TEXT}, 0},
        {"low_asked", COLUMN_FLAG, "-", END(MOVER_LOW, asked), 0, {0}, 0},
        {"low", COLUMN_KNOWN, "see unit", END(MOVER_LOW, value), 0, {0}, 0},
        {"low_text", COLUMN_TEXT, "-", END(MOVER_LOW, text), 0, {MOVER_TEXT}, 0},
        {"low_why_not", COLUMN_TEXT, "-", END(MOVER_LOW, why), 0, {MOVER_WHY}, 0},
        {"high_asked", COLUMN_FLAG, "-", END(MOVER_HIGH, asked), 0, {0}, 0},
        {"high", COLUMN_KNOWN, "see unit", END(MOVER_HIGH, value), 0, {0}, 0},
        {"high_text", COLUMN_TEXT, "-", END(MOVER_HIGH, text), 0, {MOVER_TEXT}, 0},
        {"high_why_not", COLUMN_TEXT, "-", END(MOVER_HIGH, why), 0, {MOVER_WHY}, 0},
        {"why_no_derivative", COLUMN_TEXT, "-", MOVER(no_rate), 0, {MOVER_WHY}, 0},
        {"drawn", COLUMN_FLAG, "-", MOVER(drawn), 0, {0}, 0},
        {"sigma", COLUMN_REAL, "see unit", MOVER(sigma), 0, {0}, 0},
    };
#undef MOVER
#undef END
    return passage_columns(p, "sensitivity/parameter", COUNT_OF(columns), columns,
                           rows_of(s->mover, s->nmover, sizeof *s->mover));
}

static status pass_moves(const passage *p, sensitivity_result *s)
{
#define MOVE(member) offsetof(move, member)
    static const column columns[] = {
        {"tip_rate", COLUMN_KNOWN, "m per unit", MOVE(rate), 1, {3}, 0},
        {"bend_rate", COLUMN_KNOWN, "rad per unit", MOVE(bend_rate), 0, {0}, 0},
        {"rate_error_relative", COLUMN_ANY, "-", MOVE(rate_error), 0, {0}, 0},
        {"tip_moves_m", COLUMN_KNOWN, "m", MOVE(moved), 2, {MOVER_ENDS, 3}, 0},
        {"bend_changes_rad", COLUMN_KNOWN, "rad", MOVE(bend), 1, {MOVER_ENDS}, 0},
        {"fraction", COLUMN_KNOWN, "-", MOVE(reached), 1, {MOVER_ENDS}, 0},
    };
#undef MOVE
    return passage_columns(p, "sensitivity/move", COUNT_OF(columns), columns,
                           rows_of(s->move, s->nmover * s->nsolution, sizeof *s->move));
}

static status pass_solutions(const passage *p, sensitivity_result *s, int nrod)
{
    const column columns[] = {{"solution", COLUMN_INT, "-", 0, 0, {0}, nrod - 1}};
    return passage_columns(p, "sensitivity", COUNT_OF(columns), columns,
                           rows_of(s->solution, s->nsolution, sizeof *s->solution));
}

static status pass_spreads(const passage *p, sensitivity_result *s)
{
#define SPREAD(member) offsetof(sample_spread, member)
    static const column columns[] = {
        {"mean", COLUMN_KNOWN, "m, rad", SPREAD(mean), 0, {0}, 0},
        {"deviation", COLUMN_KNOWN, "m, rad", SPREAD(deviation), 0, {0}, 0},
        {"quantile_05", COLUMN_KNOWN, "m, rad", SPREAD(low), 0, {0}, 0},
        {"quantile_50", COLUMN_KNOWN, "m, rad", SPREAD(median), 0, {0}, 0},
        {"quantile_95", COLUMN_KNOWN, "m, rad", SPREAD(high), 0, {0}, 0},
        {"share_of_no_single_one", COLUMN_KNOWN, "-", SPREAD(rest), 0, {0}, 0},
    };
#undef SPREAD
    static const column share[] = {{"share", COLUMN_KNOWN, "-", 0, 0, {0}, 0}};
    static const column used[] = {{"samples_with_answer", COLUMN_INT, "-", 0, 0, {0}, 1000000}};
    status st = OK;
    monte_carlo *m = &s->monte_carlo;
    const int rows = s->nsolution * SPREAD_QUANTITIES;
    TRY(passage_columns(p, "sensitivity/monte_carlo", COUNT_OF(used), used,
                        rows_of(m->used, s->nsolution, sizeof *m->used)));
    TRY(passage_columns(p, "sensitivity/monte_carlo", COUNT_OF(columns), columns,
                        rows_of(m->spread, rows, sizeof *m->spread)));
    TRY(passage_columns(p, "sensitivity/monte_carlo", COUNT_OF(share), share,
                        rows_of(m->share, rows * s->nmover, sizeof *m->share)));

done:
    return st;
}

static status pass_monte_carlo(const passage *p, sensitivity_result *s)
{
    status st = OK;
    monte_carlo *m = &s->monte_carlo;
    TRY(passage_count(p, "sensitivity/monte_carlo/samples", 0, 1000000, &m->nsample));
    if (m->nsample == 0) {
        return OK;
    }
    TRY(passage_count(p, "sensitivity/monte_carlo/seed", 0, 2147483647, &m->seed));
    TRY(passage_count(p, "sensitivity/monte_carlo/degree", 0, SHARES_MOST_DEGREE, &m->degree));
    if (p->reading) {
        const monte_carlo counts = *m;
        TRY(monte_carlo_make(s, m));
        m->nsample = counts.nsample;
        m->seed = counts.seed;
        m->degree = counts.degree;
    }
    TRY(pass_spreads(p, s));

done:
    return st;
}

status store_pass_sensitivity(const passage *p, run_result *r)
{
    static const char *const count = "sensitivity/parameter_count";
    status st = OK;
    sensitivity_result *s = &r->sensitivity;
    int nmover = s->nmover, nsolution = s->nsolution, own = s->own_list;
    if (p->reading ? !store_has(p->store, count) : !r->has_sensitivity) {
        return OK;
    }
    TRY(r->has_rod ? OK : passage_damaged(p, count, "belongs to no rod"));
    TRY(passage_count(p, count, 1, MOST_MOVERS, &nmover));
    TRY(passage_count(p, "sensitivity/solution_count", 1, r->rod.nsolution, &nsolution));
    TRY(passage_count(p, "sensitivity/own_list", 0, 1, &own));
    TRY(p->reading ? sensitivity_result_make(nmover, nsolution, s) : OK);
    s->own_list = own;
    TRY(pass_solutions(p, s, r->rod.nsolution));
    TRY(pass_movers(p, s));
    TRY(pass_moves(p, s));
    TRY(pass_monte_carlo(p, s));
    r->has_sensitivity = true;

done:
    return st;
}
