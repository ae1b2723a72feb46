// reach/design_island.c
// Rounds of a global search and a polish of what it found, until the evaluations are spent. Why
// these two ways, and in these shares: docs/decisions/0017-design-search.md
#include "reach/design_island.h"

#include <math.h>
#include <string.h>

// of a round's evaluations that the global search has
static const double GLOBAL_SHARE = 0.5;
// points of the global search's population, times parameters + 1: the library's own 10 leave none
// of a few hundred evaluations to improve on them
enum { POPULATION = 4 };
// of each parameter's range: a polish's first steps, and what makes no difference to a design
static const double FIRST_STEP = 0.05, RESOLUTION = 1e-3;
// a failed design's; scores are not negative
static const double WORST = -1;

typedef struct walk {
    const design_islands *all;
    int island;
    design_trial *trial;
    int done;
    int best;       // -1: none yet
    uint64_t state; // of the random places
} walk;

// splitmix64, in [0, 1)
static double random_share(walk *w)
{
    uint64_t z = w->state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return (double)(z >> 11) * 0x1p-53;
}

// --- what all see

static uint64_t bits_of(double x)
{
    uint64_t bits = 0;
    memcpy(&bits, &x, sizeof bits);
    return bits;
}

static double number_of(uint64_t bits)
{
    double x = 0;
    memcpy(&x, &bits, sizeof x);
    return x;
}

void design_pulse_begin(design_pulse *p)
{
    atomic_store(&p->goal, bits_of(NAN));
}

// numbers that are not negative are in the order of their bits
static void tell(design_pulse *p, const design_trial *t)
{
    atomic_fetch_add(&p->done, 1);
    atomic_fetch_add(&p->failed, isnan(t->score));
    const uint64_t new = isnan(t->score) ? 0 : bits_of(t->score + 0x1p-1022);
    uint64_t old = atomic_load(&p->score);
    while (new > old && !atomic_compare_exchange_weak(&p->score, &old, new)) {
    }
    if (new > old) {
        atomic_store(&p->goal, bits_of(t->goal));
    }
}

void design_pulse_read(design_pulse *p, design_news *out)
{
    out->done = atomic_load(&p->done);
    out->failed = atomic_load(&p->failed);
    out->goal = number_of(atomic_load(&p->goal));
    const uint64_t score = atomic_load(&p->score);
    out->score = score ? number_of(score) : NAN;
}

// --- one design

// what does not end the whole search
static bool of_the_design(status st)
{
    return st == ERR_NUMERIC || st == ERR_INPUT || st == ERR_FILE || st == ERR_TOLERANCE;
}

static status look(walk *w, design_trial *t)
{
    status st = OK;
    const design_problem *p = w->all->p;
    const design_trial *known = design_log_find(w->all->log, t->x);
    if (known) {
        t->goal = known->goal;
        t->score = known->score;
        t->reused = true;
        return OK;
    }
    st = p->score(p->context, t->x, &t->goal, &t->score);
    if (of_the_design(st)) {
        status_clear();
        t->goal = t->score = NAN;
        st = OK;
    }
    if (st == OK && t->score < 0) {
        st = status_fail(ERR_BUG, "a design's score is negative");
    }
    TRY(st);
    TRY(design_log_add(w->all->log, t));

done:
    return st;
}

static status ask(void *context, const double *x, double *score)
{
    status st = OK;
    walk *w = context;
    const design_problem *p = w->all->p;
    if (w->done == p->evaluations) {
        *score = WORST; // a library that asks once more than it was told
        return OK;
    }
    design_trial *t = &w->trial[w->done];
    for (int i = 0; i < p->nparameter; i++) {
        t->x[i] = fmin(fmax(x[i], p->lower[i]), p->upper[i]) + 0.; // 0 and -0 are one design
    }
    t->island = w->island;
    t->evaluation = w->done + 1;
    TRY(look(w, t));
    tell(w->all->pulse, t);
    if (!isnan(t->score) && (w->best < 0 || t->score > w->trial[w->best].score)) {
        w->best = w->done;
    }
    w->done++;
    *score = isnan(t->score) ? WORST : t->score;

done:
    return st;
}

// --- rounds

static status search(walk *w, int way, double *x, int evaluations, int round)
{
    const design_problem *p = w->all->p;
    double step[DESIGN_MOST], resolution[DESIGN_MOST];
    for (int i = 0; i < p->nparameter; i++) {
        step[i] = FIRST_STEP * (p->upper[i] - p->lower[i]);
        resolution[i] = RESOLUTION * (p->upper[i] - p->lower[i]);
    }
    const nlopt_job job = {
        .way = way,
        .n = p->nparameter,
        .lower = p->lower,
        .upper = p->upper,
        .x = x,
        .step = step,
        .resolution = resolution,
        .population = POPULATION * (p->nparameter + 1),
        .evaluations = evaluations,
        .seed = (unsigned long)p->seed * DESIGN_MOST_ISLANDS + (unsigned long)w->island +
                (unsigned long)round * 0x9e3779b9u,
        .score = ask,
        .context = w,
    };
    return evaluations > 0 ? w->all->door->maximise(&job) : OK;
}

// the best of the trials from `first` on
static int best_since(const walk *w, int first)
{
    int best = first;
    for (int i = first + 1; i < w->done; i++) {
        if (w->trial[i].score > w->trial[best].score || isnan(w->trial[best].score)) {
            best = i;
        }
    }
    return best;
}

status design_island(const design_islands *all, int island, design_trial *trial)
{
    status st = OK;
    const design_problem *p = all->p;
    const size_t bytes = (size_t)p->nparameter * sizeof(double);
    double x[DESIGN_MOST];
    walk w = {.all = all, .island = island, .trial = trial, .best = -1};
    w.state = (uint64_t)p->seed * DESIGN_MOST_ISLANDS + (uint64_t)island;
    for (int round = 0; w.done < p->evaluations; round++) {
        const int first = w.done, left = p->evaluations - w.done;
        for (int i = 0; i < p->nparameter; i++) {
            x[i] = p->lower[i] + random_share(&w) * (p->upper[i] - p->lower[i]);
        }
        if (island == 0 && round == 0) {
            memcpy(x, p->start, bytes);
        }
        TRY(search(&w, NLOPT_WAY_GLOBAL, x, (int)ceil(GLOBAL_SHARE * left), round));
        if (w.done > first) {
            memcpy(x, w.trial[best_since(&w, first)].x, bytes);
        }
        TRY(search(&w, NLOPT_WAY_LOCAL, x, p->evaluations - w.done, round));
        if (w.done == first) { // nothing is asked for any more
            break;
        }
    }

done:
    return st;
}
