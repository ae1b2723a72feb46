// api/state.c
#include "api/handles.h"

#include "base/memory.h"

#include <string.h>

_Static_assert((int)STIFFAXIS_MAX_CRITICAL == (int)ROD_MAX_CRITICAL, "as many as a solve tells");

static status make_state(stiffaxis_rod *rod, stiffaxis_state **out)
{
    status st = OK;
    stiffaxis_state *state = NULL;
    *out = NULL;
    TRY(TAKE(state, 1));
    TRY(rod_state_make(rod->w.rod, &state->state));
    state->rod = rod;
    (void)atomic_fetch_add(&rod->users, 1);
    *out = state;
    state = NULL;

done:
    free(state);
    return st;
}

int stiffaxis_state_make(stiffaxis_rod *rod, stiffaxis_state **out)
{
    status_clear();
    return (int)make_state(rod, out);
}

void stiffaxis_state_free(stiffaxis_state *state)
{
    if (state) {
        rod_state_free(state->state);
        stiffaxis_rod_free(state->rod);
        free(state);
    }
}

// --- requests and answers

static pose pose_of(const double g[16])
{
    pose out;
    for (int i = 0; i < 3; i++) {
        memcpy(out.R.a[i], g + 4 * i, sizeof out.R.a[i]);
        out.p.a[i] = g[4 * i + 3];
    }
    return out;
}

// *base: room for the request's
static rod_request rod_request_of(const stiffaxis_rod *rod, const stiffaxis_request *from,
                                  pose *base)
{
    *base = from->base ? pose_of(from->base) : rod->base;
    rod_request to = {
        .tension = from->tension,
        .pull = from->pull,
        .load = from->load,
        .base = from->base || mark_given(rod->w.c.file.rod.base.at) ? base : NULL,
        .cold = from->cold,
        .past = from->past,
        .stability = from->stability,
    };
    memcpy(to.tip_space.a, from->tip_space, sizeof to.tip_space.a);
    memcpy(to.tip_body.a, from->tip_body, sizeof to.tip_body.a);
    return to;
}

static void keep_solution(const rod_solution *from, stiffaxis_solution *to)
{
    memcpy(to->tip_position, from->tip.p.a, sizeof to->tip_position);
    memcpy(to->tip_rotation, from->tip.R.a, sizeof to->tip_rotation);
    memcpy(to->max_strain, from->max_strain.a, sizeof to->max_strain);
    to->relative_error = from->relative_error;
    to->fraction = from->fraction;
    to->eigenvalue = from->eigenvalue;
    to->energy = from->energy;
    to->work = from->work;
    to->residual = from->residual;
    to->iterations = from->iterations;
    to->stable = from->stable;
    to->limited = from->limited;
    to->ncritical = from->ncritical;
    for (int i = 0; i < ROD_MAX_CRITICAL; i++) {
        const rod_critical *c = &from->critical[i];
        to->critical[i] = (stiffaxis_critical){c->fraction, c->kind, c->negative};
    }
}

int stiffaxis_solve(stiffaxis_state *state, const stiffaxis_request *request,
                    stiffaxis_solution *out)
{
    pose base;
    rod_solution found = {.tendon_length = out->tendon_length, .tension = out->tension};
    const rod_request asked = rod_request_of(state->rod, request, &base);
    status_clear();
    const status st = rod_solve(state->state, &asked, &found);
    keep_solution(&found, out);
    state->answered = st == OK || found.limited;
    return (int)st;
}

static status solve_batch(const stiffaxis_rod *rod, int nthread, int n, const double *tension,
                          const stiffaxis_request *like, double *position, double *rotation,
                          int *outcome)
{
    status st = OK;
    pose *tip = NULL, base;
    status *each = NULL;
    int failed = 0;
    const rod_request as = rod_request_of(rod, like ? like : &(stiffaxis_request){0}, &base);
    if (n < 0) {
        TRY(status_fail(ERR_INPUT, "%d rows of tensions", n));
    }
    TRY(TAKE(tip, (size_t)n));
    TRY(TAKE(each, (size_t)n));
    TRY(rod_batch(rod->w.rod, nthread, n, tension, &as, tip, each, &failed));
    for (int i = 0; i < n; i++) {
        memcpy(position + 3 * (size_t)i, tip[i].p.a, sizeof tip[i].p.a);
        if (rotation) {
            memcpy(rotation + 9 * (size_t)i, tip[i].R.a, sizeof tip[i].R.a);
        }
        if (outcome) {
            outcome[i] = (int)each[i];
        }
    }

done:
    free(tip);
    free(each);
    return st;
}

int stiffaxis_batch(const stiffaxis_rod *rod, int nthread, int n, const double *tension,
                    const stiffaxis_request *like, double *position, double *rotation, int *outcome)
{
    status_clear();
    return (int)solve_batch(rod, nthread, n, tension, like, position, rotation, outcome);
}
