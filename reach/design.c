// reach/design.c
#include "reach/design.h"

#include "base/memory.h"
#include "base/team.h"
#include "reach/design_island.h"

#include <errno.h>
#include <math.h>
#include <string.h>
#include <sys/mman.h>

typedef struct search {
    design_islands all;
    ranks ranks;
    design_news last;
} search;

static status check(const design_problem *p)
{
    if (p->nparameter < 1 || p->nparameter > DESIGN_MOST || p->islands < 1 ||
        p->islands > DESIGN_MOST_ISLANDS || p->evaluations < 1 ||
        p->evaluations > DESIGN_MOST_EVALUATIONS) {
        return status_fail(ERR_INPUT,
                           "a design search has 1 to %d parameters, up to %d islands of up to %d "
                           "evaluations each",
                           DESIGN_MOST, DESIGN_MOST_ISLANDS, DESIGN_MOST_EVALUATIONS);
    }
    for (int i = 0; i < p->nparameter; i++) {
        const bool fine = isfinite(p->lower[i]) && isfinite(p->upper[i]) &&
                          p->lower[i] < p->upper[i] && p->lower[i] <= p->start[i] &&
                          p->start[i] <= p->upper[i];
        if (!fine) {
            return status_fail(ERR_INPUT,
                               "parameter %d of the design: start = %g is not within its bounds, "
                               "%g to %g",
                               i + 1, p->start[i], p->lower[i], p->upper[i]);
        }
    }
    return OK;
}

// how many of the islands are this rank's: rank, rank + size, ...
static int own_islands(const search *s)
{
    const int beyond = s->all.p->islands - s->ranks.rank + s->ranks.size - 1;
    return beyond > 0 ? beyond / s->ranks.size : 0;
}

static status work(void *context, int item, void *result)
{
    const search *s = context;
    return design_island(&s->all, s->ranks.rank + item * s->ranks.size, result);
}

static status hear(void *context, int done, int count)
{
    search *s = context;
    const design_problem *p = s->all.p;
    (void)done;
    if (!p->heard) {
        return OK;
    }
    s->last.total = count * p->evaluations;
    design_pulse_read(s->all.pulse, &s->last);
    return p->heard(p->hearer, &s->last);
}

// ranks of one machine share its cores
static int workers(const search *s)
{
    const int each = team_cores() / s->ranks.local;
    const int asked = s->all.p->workers;
    return asked > 0 ? asked : each > 1 ? each : 1;
}

// [islands][evaluations]: this rank's islands first among themselves, then at their places
static status run(search *s, design_trial *trial)
{
    status st = OK;
    const design_problem *p = s->all.p;
    const int own = own_islands(s);
    const size_t bytes = (size_t)p->evaluations * sizeof *trial;
    design_trial *found = NULL;
    TRY(TAKE(found, (size_t)own * (size_t)p->evaluations));
    const team_options options = {.workers = workers(s), .heard = hear, .context = s};
    TRY(team_map(work, s, own, bytes, &options, found));
    for (int i = 0; i < own; i++) {
        const size_t island = (size_t)(s->ranks.rank + i * s->ranks.size);
        memcpy(trial + island * (size_t)p->evaluations, found + (size_t)i * (size_t)p->evaluations,
               bytes);
    }
    TRY(ranks_share(&s->ranks, trial, p->islands, bytes));

done:
    free(found);
    return st;
}

static status count(design_answer *a)
{
    a->best = -1;
    for (int i = 0; i < a->islands * a->evaluations; i++) {
        const design_trial *t = &a->trial[i];
        if (t->evaluation == 0) {
            continue;
        }
        a->done++;
        a->failed += isnan(t->score);
        a->reused += t->reused;
        if (!isnan(t->score) && (a->best < 0 || t->score > a->trial[a->best].score)) {
            a->best = i;
        }
    }
    return a->best >= 0
               ? OK
               : status_fail(ERR_NUMERIC,
                             "none of the %d designs that were looked at has an answer", a->done);
}

status design_search(const design_problem *p, design_answer *out)
{
    status st = OK;
    design_answer a = {.islands = p->islands, .evaluations = p->evaluations};
    design_log log = {.file = -1};
    search s = {.all = {.p = p, .log = &log}, .ranks = ranks_here()};
    design_pulse *pulse =
        mmap(NULL, sizeof *pulse, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (pulse == MAP_FAILED) {
        return status_fail(ERR_RESOURCE, "out of memory: %s", strerror(errno));
    }
    s.all.pulse = pulse;
    design_pulse_begin(pulse);
    TRY(check(p));
    TRY(nlopt_door_open(&s.all.door));
    TRY(design_log_open(p, &s.ranks, &log));
    TRY(TAKE(a.trial, (size_t)p->islands * (size_t)p->evaluations));
    TRY(run(&s, a.trial));
    TRY(count(&a));
    *out = a;
    a = (design_answer){0};

done:
    design_answer_free(&a);
    design_log_close(&log);
    (void)munmap(pulse, sizeof *pulse);
    return st;
}

void design_answer_free(design_answer *a)
{
    free(a->trial);
    *a = (design_answer){0};
}
