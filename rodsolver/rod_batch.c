// rodsolver/rod_batch.c
// Many rows of tensions at once: each thread has a state of its own and every row is solved from
// rest, so that the answers do not depend on the number of threads.
#include "base/memory.h"
#include "rodsolver/rod_plan.h"

#include <math.h>
#include <pthread.h>
#include <unistd.h>

enum { MOST_THREADS = 256 };

typedef struct share {
    rod_state *state;
    const rod_request *like;
    const double *tension;
    int first, last; // rows
    pose *tip;
    status *outcome;
    int failed;
    pthread_t thread;
    bool running;
} share;

static void *solve_rows(void *arg)
{
    share *w = arg;
    const int ntendon = w->state->rod->ntendon;
    rod_request request = *w->like;
    rod_solution out = {0};
    request.cold = true;
    for (int i = w->first; i < w->last; i++) {
        request.tension = w->tension + (size_t)i * (size_t)ntendon;
        const status st = rod_solve_tip(w->state, &request, &out);
        if (st == OK) {
            w->tip[i] = out.tip;
        } else {
            w->tip[i] = (pose){.p = {{NAN, NAN, NAN}}};
            w->failed++;
            status_clear();
        }
        if (w->outcome) {
            w->outcome[i] = st;
        }
    }
    return NULL;
}

static int threads_for(int asked, int n)
{
    const long cores = asked > 0 ? asked : sysconf(_SC_NPROCESSORS_ONLN);
    const int most = n < MOST_THREADS ? n : MOST_THREADS;
    return cores < 1 ? 1 : cores < most ? (int)cores : most;
}

// where a thread cannot be had, its rows are solved here
static void run(share *work, int nthread)
{
    for (int i = 1; i < nthread; i++) {
        work[i].running = pthread_create(&work[i].thread, NULL, solve_rows, &work[i]) == 0;
    }
    for (int i = 0; i < nthread; i++) {
        if (!work[i].running) {
            (void)solve_rows(&work[i]);
        }
    }
    for (int i = 1; i < nthread; i++) {
        if (work[i].running) {
            (void)pthread_join(work[i].thread, NULL);
        }
    }
}

status rod_batch(const rod *r, int nthread, int n, const double *tension, const rod_request *like,
                 pose *tip, status *outcome, int *failed)
{
    status st = OK;
    const rod_request nothing = {0};
    share *work = NULL;
    const int count = n > 0 ? threads_for(nthread, n) : 0;
    *failed = 0;
    TRY(TAKE(work, (size_t)count));
    for (int i = 0; i < count; i++) {
        // rows split evenly, to the last one
        work[i] = (share){.like = like ? like : &nothing,
                          .tension = tension,
                          .first = (int)((long long)n * i / count),
                          .last = (int)((long long)n * (i + 1) / count),
                          .tip = tip,
                          .outcome = outcome};
        TRY(rod_state_make(r, &work[i].state));
    }
    run(work, count);
    for (int i = 0; i < count; i++) {
        *failed += work[i].failed;
    }

done:
    for (int i = 0; work && i < count; i++) {
        rod_state_free(work[i].state);
    }
    free(work);
    return st;
}
