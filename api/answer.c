// api/answer.c
// What a state tells about its last answer.
#include "api/handles.h"

#include <string.h>

static double place(const stiffaxis_state *state, int n, const double *s, int i)
{
    const double length = stiffaxis_rod_length(state->rod);
    return s ? s[i] : i == n - 1 ? length : length * i / (n - 1);
}

// s NULL: equally spaced ones are finite
static status check_places(const stiffaxis_state *state, int n, const double *s)
{
    if (!state->answered) {
        return status_fail(ERR_INPUT, "a shape is asked for before a solution");
    }
    for (int i = 0; s && i < n; i++) {
        if (!isfinite(s[i])) {
            return status_fail(ERR_INPUT, "arclength %d is not finite", i);
        }
    }
    return OK;
}

int stiffaxis_shape(const stiffaxis_state *state, int n, const double *s, double *position,
                    double *rotation)
{
    status st = OK;
    status_clear();
    TRY(check_places(state, n, s));
    for (int i = 0; i < n; i++) {
        pose g;
        TRY(rod_pose(state->state, place(state, n, s, i), &g));
        if (position) {
            memcpy(position + 3 * (size_t)i, g.p.a, sizeof g.p.a);
        }
        if (rotation) {
            memcpy(rotation + 9 * (size_t)i, g.R.a, sizeof g.R.a);
        }
    }

done:
    return (int)st;
}

// tendons' paths and rest shapes may be expressions, which are one thread's at a time
static status tell_along(const stiffaxis_state *state, int n, const double *s, double *strain,
                         double *wrench, double *tension)
{
    status st = OK;
    const size_t ntendon = (size_t)stiffaxis_rod_tendons(state->rod);
    TRY(check_places(state, n, s));
    for (int i = 0; i < n; i++) {
        const double at = place(state, n, s, i);
        vec6 value;
        if (strain) {
            TRY(rod_strain_at(state->state, at, &value));
            memcpy(strain + 6 * (size_t)i, value.a, sizeof value.a);
        }
        if (wrench || tension) {
            TRY(rod_wrench_at(state->state, at, &value,
                              tension ? tension + ntendon * (size_t)i : NULL));
        }
        if (wrench) {
            memcpy(wrench + 6 * (size_t)i, value.a, sizeof value.a);
        }
    }

done:
    return st;
}

int stiffaxis_along(const stiffaxis_state *state, int n, const double *s, double *strain,
                    double *wrench, double *tension)
{
    status_clear();
    turn_begin();
    const status st = tell_along(state, n, s, strain, wrench, tension);
    turn_end();
    return (int)st;
}

// arrays of doubles are these, too
_Static_assert(sizeof(vec6) == 6 * sizeof(double) && sizeof(mat6) == 36 * sizeof(double),
               "nothing but their numbers");

int stiffaxis_derive(stiffaxis_state *state, double s, const stiffaxis_derivatives *out)
{
    status st = OK;
    status_clear();
    TRY(check_places(state, 1, &s));
    st = rod_derive(state->state, s,
                    &(rod_derivatives){.tension = (vec6 *)out->tension,
                                       .pull = (vec6 *)out->pull,
                                       .load = (vec6 *)out->load,
                                       .tip_space = (mat6 *)out->tip_space,
                                       .tip_body = (mat6 *)out->tip_body,
                                       .base = (mat6 *)out->base,
                                       .length_by_tension = out->length_by_tension});

done:
    return (int)st;
}
