// app/sensitivity.c
// What moves the answer: derivatives, whole solves at the ends of every parameter's range, and the
// alternatives.
#include "app/sensitivity.h"

#include "app/case_value.h"
#include "app/chain.h"
#include "base/memory.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// poses along the rod: a bend that winds up is followed
enum { BEND_POINTS = 181 };

void sensitivity_bends(const variation_answer *a, double *bend)
{
    for (int k = 0; k < a->nsolution; k++) {
        bend[k] = chain_total_bend(a->npoint, &a->shape[(size_t)k * (size_t)a->npoint]);
    }
}

status sensitivity_solve(sensitivity_study *s, const settings *with, mark at, variation_answer *out)
{
    const variation_places where = {
        .nsolution = s->out->nsolution, .solution = s->out->solution, .npoint = BEND_POINTS};
    return variation_solve(&s->v, with, at, &where, false, out);
}

// --- one end

static void keep_moves(const sensitivity_study *s, int k, int end, const variation_answer *a,
                       const double *bend)
{
    for (int i = 0; i < a->nsolution; i++) {
        move *m = &s->out->move[k * a->nsolution + i];
        const vec3 moved = vec3_sub(a->tip[i].p, s->base.tip[i].p);
        memcpy(m->moved[end], moved.a, sizeof m->moved[end]);
        m->bend[end] = bend[i] - s->bend[i];
        m->reached[end] = a->fraction[i];
    }
}

static status set_end(const sensitivity_study *s, int k, int end, settings *with)
{
    const sensitivity_parameter *q = &s->parameter[k];
    return q->alternative.text ? settings_add_text(with, &q->p, q->alternative.text)
                               : settings_add(with, &q->p, s->out->mover[k].end[end].value);
}

static status solve_end(sensitivity_study *s, int k, int end)
{
    status st = OK;
    settings with = {0};
    variation_answer a = {0};
    double *bend = NULL;
    mover *p = &s->out->mover[k];
    TRY(set_end(s, k, end, &with));
    st = sensitivity_solve(s, &with, s->parameter[k].p.at, &a);
    // what cannot be solved there is said and left out; what the case has no business to ask for is
    // its mistake, unless the list is our own
    if (st == ERR_NUMERIC || (st == ERR_INPUT && s->out->own_list)) {
        (void)snprintf(p->end[end].why, sizeof p->end[end].why, "%s", status_message());
        status_clear();
        st = OK;
        goto done;
    }
    TRY(st);
    TRY(TAKE(bend, (size_t)a.nsolution));
    sensitivity_bends(&a, bend);
    keep_moves(s, k, end, &a, bend);

done:
    free(bend);
    variation_answer_free(&a);
    settings_free(&with);
    return st;
}

// --- what is asked

static void join_keys(const parameter *p, char *text, size_t size)
{
    size_t used = 0;
    for (int i = 0; i < p->keys.count && used < size; i++) {
        const key_text *k = (const key_text *)p->keys.items + i;
        used += (size_t)snprintf(text + used, size - used, "%s%s", i ? ", " : "", k->text);
    }
}

static void set_number(mover_end *e, double value)
{
    e->asked = true;
    e->value = value;
    (void)snprintf(e->text, sizeof e->text, "%.6g", value);
}

static void set_ends(const sensitivity_parameter *q, mover *p)
{
    p->end[MOVER_LOW].value = p->end[MOVER_HIGH].value = NAN;
    if (q->alternative.text) {
        p->discrete = p->end[MOVER_HIGH].asked = true;
        (void)snprintf(p->end[MOVER_HIGH].text, MOVER_TEXT, "%s", q->alternative.text);
        return;
    }
    const bool given = !isnan(q->low);
    set_number(&p->end[MOVER_LOW], given ? q->low : p->value - 2 * q->sigma);
    set_number(&p->end[MOVER_HIGH], given ? q->high : p->value + 2 * q->sigma);
}

static status describe(const case_data *c, const sensitivity_parameter *q, mover *p)
{
    status st = OK;
    double factor = 1;
    case_value v;
    const key_text *k = q->p.keys.items;
    (void)snprintf(p->name, sizeof p->name, "%s", q->p.name);
    (void)snprintf(p->unit, sizeof p->unit, "%s", parameter_unit(&q->p, &factor));
    join_keys(&q->p, p->keys, sizeof p->keys);
    TRY(case_value_find(c, k->text, k->at, &v));
    p->value = v.number;
    for (int i = 1; i < q->p.keys.count; i++) {
        case_value other;
        TRY(case_value_find(c, k[i].text, k[i].at, &other));
        p->value = other.number == p->value ? p->value : NAN; // they differ: no one value
    }
    if (v.text) {
        (void)snprintf(p->text, sizeof p->text, "%.*s", v.length, v.text);
    } else if (isnan(p->value)) {
        (void)snprintf(p->text, sizeof p->text, "as in the case");
    } else {
        (void)snprintf(p->text, sizeof p->text, "%.6g", p->value);
    }
    p->sigma = q->distribution == DRAW_NORMAL ? q->sigma : 0;
    set_ends(q, p);

done:
    return st;
}

static void unknown_moves(sensitivity_result *r)
{
    const move unknown = {.rate = {NAN, NAN, NAN},
                          .bend_rate = NAN,
                          .rate_error = NAN,
                          .moved = {{NAN, NAN, NAN}, {NAN, NAN, NAN}},
                          .bend = {NAN, NAN},
                          .reached = {NAN, NAN}};
    for (int i = 0; i < r->nmover * r->nsolution; i++) {
        r->move[i] = unknown;
    }
}

static status begin(sensitivity_study *s, const default_list *own)
{
    status st = OK;
    const sensitivity_case *sc = &s->c->file.sensitivity;
    const bool listed = sc->parameters.count > 0;
    const int nsolution =
        sc->solutions.nrow > 0 ? sc->solutions.ncol : rod_case_solutions(&s->c->file.rod);
    s->parameter = listed ? sc->parameters.items : own->parameter;
    TRY(sensitivity_result_make(listed ? sc->parameters.count : own->count, nsolution, s->out));
    s->out->own_list = !listed;
    for (int i = 0; i < nsolution; i++) {
        s->out->solution[i] = sc->solutions.nrow > 0 ? (int)sc->solutions.a[i] - 1 : i;
    }
    for (int k = 0; k < s->out->nmover; k++) {
        TRY(describe(s->c, &s->parameter[k], &s->out->mover[k]));
    }
    unknown_moves(s->out);

done:
    return st;
}

static status move_all(sensitivity_study *s)
{
    status st = OK;
    for (int k = 0; k < s->out->nmover; k++) {
        char words[MOVER_NAME + 32];
        (void)snprintf(words, sizeof words, "sensitivity: %s", s->out->mover[k].name);
        command_progress(s->cmd, words);
        for (int end = 0; end < MOVER_ENDS; end++) {
            TRY(s->out->mover[k].end[end].asked ? solve_end(s, k, end) : OK);
        }
        TRY(sensitivity_rates(s, k));
    }

done:
    return st;
}

status chain_sensitivity(const command *cmd, const case_data *c, run_result *out)
{
    status st = OK;
    default_list own = {0};
    sensitivity_study s = {.cmd = cmd, .c = c, .out = &out->sensitivity};
    TRY(sensitivity_check(c));
    TRY(sensitivity_defaults(c, &own));
    TRY(begin(&s, &own));
    TRY(variation_open(c, out->has_section ? &out->section : NULL, &s.v));
    TRY(sensitivity_solve(&s, NULL, c->file.sensitivity.at, &s.base));
    TRY(TAKE(s.bend, (size_t)s.base.nsolution));
    sensitivity_bends(&s.base, s.bend);
    TRY(move_all(&s));
    TRY(mark_given(c->file.sensitivity.monte_carlo.at) ? sensitivity_monte_carlo(&s) : OK);
    out->has_sensitivity = true;

done:
    free(s.bend);
    variation_answer_free(&s.base);
    variation_free(&s.v);
    sensitivity_defaults_free(&own);
    return st;
}
