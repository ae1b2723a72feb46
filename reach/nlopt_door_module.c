// reach/nlopt_door_module.c
#include "reach/nlopt_door.h"

#include <math.h>
#include <nlopt.h>

typedef struct asking {
    const nlopt_job *job;
    nlopt_opt opt;
    status st; // of the score
} asking;

static double ask(unsigned n, const double *x, double *gradient, void *context)
{
    asking *a = context;
    double score = 0;
    (void)n;
    (void)gradient; // neither way asks for it
    if (a->st == OK) {
        a->st = a->job->score(a->job->context, x, &score);
    }
    if (a->st == OK && !isfinite(score)) {
        a->st = status_fail(ERR_BUG, "a score is no number");
    }
    if (a->st != OK) {
        (void)nlopt_force_stop(a->opt);
        return -HUGE_VAL;
    }
    return score;
}

static nlopt_result set(const asking *a)
{
    const nlopt_job *job = a->job;
    nlopt_result r = nlopt_set_lower_bounds(a->opt, job->lower);
    r = r < 0 ? r : nlopt_set_upper_bounds(a->opt, job->upper);
    r = r < 0 ? r : nlopt_set_max_objective(a->opt, ask, (void *)a);
    r = r < 0 ? r : nlopt_set_maxeval(a->opt, job->evaluations);
    if (job->way == NLOPT_WAY_GLOBAL) {
        r = r < 0 ? r : nlopt_set_population(a->opt, (unsigned)job->population);
    } else {
        r = r < 0 ? r : nlopt_set_initial_step(a->opt, job->step);
        r = r < 0 ? r : nlopt_set_xtol_abs(a->opt, job->resolution);
    }
    return r;
}

static status maximise(const nlopt_job *job)
{
    static const nlopt_algorithm algorithm[] = {NLOPT_GN_CRS2_LM, NLOPT_LN_SBPLX};
    double best = 0;
    asking a = {.job = job, .opt = nlopt_create(algorithm[job->way], (unsigned)job->n)};
    if (!a.opt) {
        return status_fail(ERR_RESOURCE, "NLopt: out of memory");
    }
    nlopt_srand(job->seed);
    nlopt_result r = set(&a);
    r = r < 0 ? r : nlopt_optimize(a.opt, job->x, &best);
    nlopt_destroy(a.opt);
    if (a.st != OK) {
        return a.st;
    }
    if (r == NLOPT_OUT_OF_MEMORY) {
        return status_fail(ERR_RESOURCE, "NLopt: out of memory");
    }
    if (r < 0 && r != NLOPT_ROUNDOFF_LIMITED) { // it came as near as numbers go
        return status_fail(ERR_BUG, "NLopt: %s", nlopt_result_to_string(r));
    }
    return OK;
}

const nlopt_door *stiffaxis_nlopt_door(void);
const nlopt_door *stiffaxis_nlopt_door(void)
{
    static const nlopt_door door = {.maximise = maximise};
    return &door;
}
