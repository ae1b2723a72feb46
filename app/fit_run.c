// app/fit_run.c
// The case's open numbers by its measured shapes.
#include "app/chain.h"
#include "app/fit_files.h"
#include "app/variation.h"
#include "app/warnings.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

typedef struct fitting {
    const command *cmd;
    const case_data *c;
    variation v;
    int nshape;
    int *solution; // [nshape]
    fit_unknown *unknown;
    fit_shape *shape;
    int nsolve, nstart, start;
    double chi2; // of the search at hand; 0: not yet
} fitting;

static const fit_parameter *parameter_of(const case_data *c, int i)
{
    return (const fit_parameter *)c->file.fit.parameters.items + i;
}

static const measured_shape *shape_of(const case_data *c, int k)
{
    return (const measured_shape *)c->file.measured.shapes.items + k;
}

// --- the model

static void hear_progress(void *context, int start, double chi2)
{
    fitting *f = context;
    f->chi2 = f->start == start && f->chi2 > 0 ? fmin(f->chi2, chi2) : chi2;
    f->start = start;
}

static void show_progress(fitting *f)
{
    char words[96];
    const int n = snprintf(words, sizeof words, "fit: start %d of %d, ", f->start + 1, f->nstart);
    (void)snprintf(words + n, sizeof words - (size_t)n,
                   f->chi2 > 0 ? "%d solves, chi^2 %.4g" : "%d solves", ++f->nsolve, f->chi2);
    command_progress(f->cmd, words);
}

static status solve_lines(void *context, const double *x, vec3 *p, double *length)
{
    status st = OK;
    fitting *f = context;
    settings s = {0};
    variation_answer a = {0};
    show_progress(f);
    const variation_places where = {
        .nsolution = f->nshape, .solution = f->solution, .npoint = FIT_POINTS};
    for (int i = 0; i < f->c->file.fit.parameters.count; i++) {
        TRY(settings_add(&s, &parameter_of(f->c, i)->what, x[i]));
    }
    TRY(variation_solve(&f->v, &s, parameter_of(f->c, 0)->what.at, &where, true, &a));
    for (int k = 0; k < f->nshape; k++) {
        if (a.fraction[k] < 1) {
            TRY(status_fail(ERR_NUMERIC, "fit: %s: solution %d ends at a limit point", s.about,
                            f->solution[k] + 1));
        }
        for (int i = 0; i < FIT_POINTS; i++) {
            p[k * FIT_POINTS + i] = a.shape[k * FIT_POINTS + i].p;
        }
    }
    *length = a.s[FIT_POINTS - 1];

done:
    variation_answer_free(&a);
    settings_free(&s);
    return st;
}

// --- what is asked

// whether the line ends at the rod's tip: by its length where nobody said so
static bool ends_at_tip(const measured_shape *m, bool rest, double length)
{
    const shape_way way = {rest ? ARCLENGTH_REST : ARCLENGTH_MEASURED, m->tip};
    return shape_ends_at_tip(&way, m->line.s[m->line.count - 1], length);
}

// The lengths of the model's lines as the case stands [nshape].
static status find_tips(fitting *f)
{
    status st = OK;
    variation_answer a = {0};
    settings s = {0};
    const case_data *c = f->c;
    const variation_places where = {
        .nsolution = f->nshape, .solution = f->solution, .npoint = FIT_POINTS};
    TRY(fit_case_start(&c->file.fit, &s));
    TRY(variation_solve(&f->v, &s, c->file.fit.at, &where, true, &a));
    for (int k = 0; k < f->nshape; k++) {
        double length = 0;
        for (int i = 1; i < FIT_POINTS; i++) {
            const pose *at = &a.shape[k * FIT_POINTS + i];
            length += vec3_norm(vec3_sub(at[0].p, at[-1].p));
        }
        const bool rest = c->file.measured.arclength == ARCLENGTH_REST;
        f->shape[k].to_tip = ends_at_tip(shape_of(c, k), rest, rest ? c->file.rod.length : length);
    }

done:
    settings_free(&s);
    variation_answer_free(&a);
    return st;
}

static status make_problem(fitting *f, fit_problem *out)
{
    status st = OK;
    const case_data *c = f->c;
    const fit_case *fc = &c->file.fit;
    f->nshape = c->file.measured.shapes.count;
    TRY(TAKE(f->solution, (size_t)f->nshape));
    TRY(TAKE(f->shape, (size_t)f->nshape));
    TRY(TAKE(f->unknown, (size_t)fc->parameters.count));
    for (int k = 0; k < f->nshape; k++) {
        const measured_shape *m = shape_of(c, k);
        f->solution[k] = m->index;
        f->shape[k] = (fit_shape){.name = m->name ? m->name : m->csv.text,
                                  .line = &m->line,
                                  .rest = c->file.measured.arclength == ARCLENGTH_REST};
    }
    for (int i = 0; i < fc->parameters.count; i++) {
        const fit_parameter *p = parameter_of(c, i);
        f->unknown[i] =
            (fit_unknown){p->what.name, p->start, isnan(p->lower) ? -INFINITY : p->lower,
                          isnan(p->upper) ? INFINITY : p->upper};
    }
    TRY(find_tips(f));
    *out = (fit_problem){.nunknown = fc->parameters.count,
                         .nshape = f->nshape,
                         .unknown = f->unknown,
                         .shape = f->shape,
                         .lines = solve_lines,
                         .progress = hear_progress,
                         .context = f,
                         .base = fc->base,
                         .base_shift = fc->base_shift,
                         .base_turn = fc->base_turn,
                         .nstart = fc->starts,
                         .seed = (unsigned long)fc->seed,
                         .share = fc->interval};

done:
    return st;
}

// without both bounds of anything all searches would begin at the same place
static int useful_starts(const fit_problem *p)
{
    bool any = false;
    for (int i = 0; i < p->nunknown; i++) {
        any = any || (isfinite(p->unknown[i].lower) && isfinite(p->unknown[i].upper));
    }
    return any ? p->nstart : 1;
}

// --- what is told

static void tell_parameter(const fit_parameter *p, const fit_unknown *u, fit_parameter_told *out)
{
    size_t used = 0;
    *out = (fit_parameter_told){.start = u->start, .lower = u->lower, .upper = u->upper};
    (void)snprintf(out->name, sizeof out->name, "%s", p->what.name);
    (void)snprintf(out->unit, sizeof out->unit, "%s", parameter_unit(&p->what, &out->to_si));
    const key_text *key = p->what.keys.items;
    for (int i = 0; i < p->what.keys.count && used < sizeof out->keys; i++) {
        used += (size_t)snprintf(out->keys + used, sizeof out->keys - used, "%s%s", i ? ", " : "",
                                 key[i].text);
    }
}

static status tell(const fitting *f, const fit_problem *problem, fit_answer *answer,
                   fit_result *out)
{
    status st = OK;
    fit_result r = {.there = true,
                    .synthetic = f->c->file.measured.synthetic,
                    .base = problem->base,
                    .base_shift = problem->base_shift,
                    .base_turn = problem->base_turn,
                    .share = problem->share};
    const char *source = f->c->file.measured.source;
    (void)snprintf(r.source, sizeof r.source, "%s", source ? source : "");
    TRY(TAKE(r.parameter, (size_t)problem->nunknown));
    TRY(TAKE(r.shape, (size_t)problem->nshape));
    for (int i = 0; i < problem->nunknown; i++) {
        tell_parameter(parameter_of(f->c, i), &problem->unknown[i], &r.parameter[i]);
    }
    for (int k = 0; k < problem->nshape; k++) {
        (void)snprintf(r.shape[k].name, sizeof r.shape[k].name, "%s", problem->shape[k].name);
        r.shape[k].solution = f->solution[k];
        r.shape[k].turn_free = shape_of(f->c, k)->line.turn_free;
    }
    r.answer = *answer;
    *answer = (fit_answer){0};
    *out = r;
    r = (fit_result){0};

done:
    fit_result_free(&r);
    return st;
}

// --- the case with the fitted values

static const char *line_that_begins(const char *text, const char *key)
{
    const char *at = strstr(text, key);
    while (at && at != text && at[-1] != '\n') {
        at = strstr(at + 1, key);
    }
    return at;
}

// "fitted: '...'" in front of the file, in place of an earlier such line
static status add_headline(const case_data *c, const fit_result *r, const char *text, int nleft,
                           char **out)
{
    status st = OK;
    static const char key[] = "fitted:";
    char words[400], line[900];
    size_t n = 0;
    (void)fit_result_words(r, words, sizeof words);
    n = (size_t)snprintf(line, sizeof line, "%s '", key);
    for (const char *p = words; *p && n + 120 < sizeof line; p++) {
        line[n++] = *p;
        if (*p == '\'') {
            line[n++] = *p;
        }
    }
    n += (size_t)snprintf(line + n, sizeof line - n, "%s%s'\n",
                          r->synthetic ? " (to synthetic shapes)" : "",
                          nleft > 0 ? "; NOT ALL IN FORCE: see the end of the case" : "");
    const char *old = c->file.fitted ? line_that_begins(text, key) : NULL;
    const char *at = old ? old : line_that_begins(text, "format:");
    const char *rest = old ? old + strcspn(old, "\n") : at;
    rest += old && *rest == '\n';
    n = at ? n : 0; // a case in one pair of braces goes without
    at = at ? at : text;
    rest = rest ? rest : text;
    const size_t before = (size_t)(at - text);
    TRY(TAKE(*out, strlen(text) + n + 1));
    memcpy(*out, text, before);
    memcpy(*out + before, line, n);
    memcpy(*out + before + n, rest, strlen(rest) + 1);

done:
    return st;
}

static status write_fitted(const case_data *c, run_result *out)
{
    status st = OK;
    settings s = {0};
    char *text = NULL, *moved = NULL, *ended = NULL;
    size_t length = 0, moved_length = 0;
    int nleft = 0, moved_left = 0;
    for (int i = 0; i < c->file.fit.parameters.count; i++) {
        TRY(settings_add(&s, &parameter_of(c, i)->what, out->fit.answer.value[i]));
    }
    const int nvalue = s.count;
    TRY(config_rewrite(c->config, nvalue, (const char *const *)s.text, &text, &length, &nleft));
    // whole paths where all of them have a place
    TRY(fit_files(c, &s));
    TRY(config_rewrite(c->config, s.count, (const char *const *)s.text, &moved, &moved_length,
                       &moved_left));
    if (moved_left == nleft) {
        free(text);
        text = moved;
        length = moved_length;
        moved = NULL;
    }
    TRY(TAKE(ended, length + 1));
    memcpy(ended, text, length);
    TRY(add_headline(c, &out->fit, ended, nleft, &out->fitted_case));

done:
    free(ended);
    free(moved);
    free(text);
    settings_free(&s);
    return st;
}

static void warn_turns(const fitting *f)
{
    for (int k = 0; k < f->nshape; k++) {
        const measured_shape *m = shape_of(f->c, k);
        if (m->line.turn_free) {
            warn_at(f->cmd, f->c, m->at,
                    "the scan %.200s is free in its turn about z: it does not tell in which "
                    "direction the rod bends",
                    m->csv.text);
        }
    }
}

status chain_fit(const command *cmd, const case_data *c, run_result *out)
{
    status st = OK;
    fitting f = {.cmd = cmd, .c = c};
    fit_problem problem;
    fit_answer answer = {0};
    command_progress(cmd, "fit");
    TRY(variation_open(c, out->has_section ? &out->section : NULL, &f.v));
    TRY(make_problem(&f, &problem));
    warn_turns(&f);
    f.nstart = problem.nstart = useful_starts(&problem);
    TRY(case_place(c, shape_fit(&problem, &answer), c->file.fit.at));
    TRY(tell(&f, &problem, &answer, &out->fit));
    TRY(write_fitted(c, out));

done:
    command_progress(cmd, NULL);
    fit_answer_free(&answer);
    free(f.solution);
    free(f.shape);
    free(f.unknown);
    variation_free(&f.v);
    return st;
}
