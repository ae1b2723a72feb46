// tests/unit/rodsolver/test_rod_threads.c
// Two rods in two threads each, every thread with a state of its own: the answers are those of one
// thread, to the last bit, and so is what failures say.
#include "tests/unit/rodsolver/prototypes.h"

#include <pthread.h>
#include <string.h>

enum { THREADS = 4, ROUNDS = 40, TENDONS = 2 };

typedef struct job {
    const rod *rod;
    double turn; // of the load, so that each thread asks for something else
    rod_solution answer[ROUNDS];
    vec6 by_tension[ROUNDS][TENDONS];
    bool failed_as_it_should, ok;
} job;

static void *solve_all(void *argument)
{
    job *j = argument;
    rod_state *state = NULL;
    j->ok = rod_state_make(j->rod, &state) == OK;
    for (int i = 0; j->ok && i < ROUNDS; i++) {
        const double angle = j->turn + 0.1 * i, tension[TENDONS] = {0.2 + 0.01 * i, 0.1};
        const rod_request request = {.tension = tension,
                                     .tip_space = {{5e-3 * cos(angle), 5e-3 * sin(angle)}},
                                     .cold = i % 4 == 0};
        j->ok = rod_solve(state, &request, &j->answer[i]) == OK &&
                rod_derive(state, 0.12, &(rod_derivatives){.tension = j->by_tension[i]}) == OK;
        // the shape ends at the tip, to the last bit
        double s[3];
        pose shape[3];
        j->ok = j->ok && rod_shape(state, 3, s, shape) == OK &&
                memcmp(&shape[2], &j->answer[i].tip, sizeof(pose)) == 0;
        rod_solution unused = {0};
        const double bad[TENDONS] = {-1 - j->turn, 0};
        char words[40];
        (void)snprintf(words, sizeof words, "%g", bad[0]);
        if (i == ROUNDS / 2) {
            j->failed_as_it_should =
                rod_solve(state, &(rod_request){.tension = bad}, &unused) == ERR_INPUT &&
                strstr(status_message(), words) != NULL;
            status_clear();
        }
    }
    rod_state_free(state);
    return NULL;
}

static bool same(const job *a, const job *b)
{
    for (int i = 0; i < ROUNDS; i++) {
        if (memcmp(&a->answer[i].tip, &b->answer[i].tip, sizeof(pose)) != 0 ||
            memcmp(a->by_tension[i], b->by_tension[i], sizeof a->by_tension[i]) != 0) {
            return false;
        }
    }
    return true;
}

int main(void)
{
    static job together[THREADS], alone[THREADS];
    const prototype p[2] = {helical_nc(), homogeneous_tube()};
    const tendon_spec tendon[TENDONS] = {straight_tendon("a", 3.6e-3, 0),
                                         straight_tendon("b", 3.6e-3, 2)};
    law_along law[2] = {0};
    rod *r[2] = {NULL, NULL};
    pthread_t thread[THREADS];
    for (int k = 0; k < 2; k++) {
        prototype_law(&p[k], &law[k]);
        const rod_spec spec = {.law = &law[k], .ntendon = TENDONS, .tendons = tendon};
        CHECK_OK(rod_make(&spec,
                          &(rod_options){.frame = k == 0 ? FRAME_NC : FRAME_GC, .tolerance = 1e-6},
                          &r[k]));
    }
    for (int t = 0; t < THREADS; t++) {
        together[t] = alone[t] = (job){.rod = r[t % 2], .turn = t};
        (void)solve_all(&alone[t]);
        CHECK(alone[t].ok && alone[t].failed_as_it_should);
    }
    for (int t = 0; t < THREADS; t++) {
        CHECK(pthread_create(&thread[t], NULL, solve_all, &together[t]) == 0);
    }
    for (int t = 0; t < THREADS; t++) {
        CHECK(pthread_join(thread[t], NULL) == 0);
        CHECK(together[t].ok && together[t].failed_as_it_should);
        CHECK(same(&together[t], &alone[t]));
    }
    for (int k = 0; k < 2; k++) {
        rod_free(r[k]);
        law_along_free(&law[k]);
    }
    return test_failures != 0;
}
