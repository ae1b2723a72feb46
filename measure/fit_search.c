// measure/fit_search.c
// One search from one place, with a budget: what leads nowhere ends with what it was about.
#include "base/memory.h"
#include "measure/fit_inside.h"
#include "measure/fit_spread.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

// Relative change of a coordinate at which a search ends: far below any interval.
static const double step_tolerance = 1e-7;
// Steps between two looks at what a search still gains, and looks: good searches need 5 to 15
// steps, some creep to their end once they are near it.
enum { STEPS = 12, LOOKS = 2, LOOKS_NEAR_IT = 8 };
// What a search may leave to gain, in parts of chi^2 per degree of freedom: a hundredth of a
// standard error off the best place.
static const double nothing_to_gain = 1e-4;
// ... and what it may leave to be near its end: half a standard error.
static const double near_its_end = 0.25;
// So many searches without an end say that the others have none: half of them, but two.
enum { IN_VAIN = 2 };

// By how much chi^2 would still fall at z, were the model straight: |r|^2 less what the best
// combination of J's columns leaves of it.
static status still_to_gain(fit *f, const double *z, double *gain)
{
    status st = OK;
    const gsl_linear_door *door = NULL;
    const size_t nr = (size_t)fit_nr(f), nz = (size_t)fit_nz(f);
    double *r = NULL, *J = NULL, *x = NULL, all = 0, left = 0;
    TRY(gsl_linear_door_open(&door));
    TRY(TAKE(r, nr));
    TRY(TAKE(J, nr * nz));
    TRY(TAKE(x, nz));
    TRY(fit_residuals(f, z, r, J));
    for (size_t i = 0; i < nr; i++) {
        all += r[i] * r[i];
    }
    TRY(door->least_squares((int)nr, (int)nz, J, r, x, &left));
    *gain = all - left;

done:
    free(r);
    free(J);
    free(x);
    return st;
}

// what a search that stopped tells if no other ends
static void keep(fit *f, const double *z, double cost)
{
    fit_stop *s = &f->stop;
    if (s->any && !(cost < s->chi2)) {
        return;
    }
    s->any = true;
    s->chi2 = cost;
    memcpy(s->x, f->x, sizeof *f->x * (size_t)f->problem->nunknown);
    for (int k = 0; k < f->nfree; k++) {
        const int u = f->free[k];
        s->x[u] = f->problem->unknown[u].start + f->scale[u] * z[k];
    }
    fit_weakest(f, z, s->weakest, sizeof s->weakest);
}

// Whether a search that ran out of steps is there all the same; ERR_NUMERIC by name where its
// unknowns cannot be told apart.
static status look(fit *f, const double *z, double cost, bool *there, bool *near)
{
    status st = OK;
    double gain = 0;
    const double per_freedom = cost / fmax(2 * f->nuse - f->nfree, 1);
    f->named = true;
    TRY(fit_told_apart(f, z));
    f->named = false;
    TRY(still_to_gain(f, z, &gain));
    *there = gain <= nothing_to_gain * per_freedom;
    *near = gain <= near_its_end * per_freedom;

done:
    return st;
}

status fit_search(fit *f, double *z, double *cost)
{
    status st = OK;
    bool there = false, near = false;
    int looks = 0;
    const least_squares problem = {fit_nr(f), fit_nz(f), fit_residuals, f, step_tolerance, STEPS};
    for (; !there && looks < (near ? LOOKS_NEAR_IT : LOOKS); looks++) {
        least_squares_answer answer = {0};
        f->begun = false;
        st = f->door->least_squares(&problem, z, &answer);
        *cost = answer.cost;
        if (st != ERR_NUMERIC || !answer.short_of_it) {
            return st;
        }
        status_clear();
        keep(f, z, *cost);
        TRY(look(f, z, *cost, &there, &near));
    }
    if (!there) {
        TRY(status_fail(ERR_NUMERIC, "fit: no convergence in %d steps", looks * STEPS));
    }

done:
    return st;
}

bool fit_in_vain(const fit *f)
{
    const int tried = f->start + 1;
    return f->stop.any && tried >= IN_VAIN && 2 * tried >= f->problem->nstart;
}

status fit_no_search_ended(fit *f, int nstart)
{
    char words[600] = "", why[400];
    size_t used = 0;
    if (!f->stop.any) {
        return ERR_NUMERIC; // the model's own reason stands
    }
    for (int u = 0; u < f->problem->nunknown && used < sizeof words; u++) {
        used += (size_t)snprintf(words + used, sizeof words - used, "%s%.40s = %.5g", u ? ", " : "",
                                 f->problem->unknown[u].name, f->stop.x[u]);
    }
    (void)snprintf(why, sizeof why, "%s", status_message());
    status_clear();
    if (f->named) { // by name already
        return status_fail(ERR_NUMERIC, "%s; best so far: chi^2 %.4g at %s", why, f->stop.chi2,
                           words);
    }
    return status_fail(ERR_NUMERIC,
                       "%s (starts: %d); best so far: chi^2 %.4g at %s; these shapes "
                       "tell least of %s: fix one of them, or bound it closer",
                       why, nstart, f->stop.chi2, words, f->stop.weakest);
}
