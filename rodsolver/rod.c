// rodsolver/rod.c
#include "base/memory.h"
#include "rodsolver/equilibrium.h"
#include "rodsolver/rod_plan.h"

#include <math.h>

static void end_frames(rod *r)
{
    if (r->options.frame == FRAME_NC) {
        const plan *p = &r->plans[r->nplan - 1];
        r->base = centre_frame_pose(&p->node_frame[0]);
        r->tip = centre_frame_pose(&p->node_frame[2 * p->npair]);
    }
}

static status check_options(const law_along *law, const rod_options *options)
{
    if (options->npanel <= 0 && !(options->tolerance >= ROD_MIN_TOLERANCE)) {
        return status_fail(ERR_INPUT, "rod: tolerance %g is below the rounding limit %g",
                           options->tolerance, ROD_MIN_TOLERANCE);
    }
    for (int i = 0; i < law->npanel * law->nnode; i++) {
        const status st = beam_law_check(&law->law[i]);
        if (st != OK) {
            return st;
        }
    }
    return OK;
}

// Where the stiffness centre or its axes jump there is no curve through them to be solved along.
// This near to an edge both sides are told apart, and sections solved twice differ by less than
// this (of the length, rad)
static const double beside_edge = 1e-9, frame_jump = 1e-6;

static status check_frame(const law_along *law)
{
    double phi = law->turn[0];
    for (int k = 0; k + 1 < law->npanel; k++) {
        const double s = law->edge[k + 1], beside = beside_edge * law->length;
        centre_frame a, b;
        law_along_centre_frame(law, s - beside, phi, &a);
        law_along_centre_frame(law, s + beside, a.phi, &b);
        phi = b.phi;
        const double apart = hypot(b.p[0] - a.p[0], b.p[1] - a.p[1]);
        if (apart > frame_jump * law->length || fabs(b.phi - a.phi) > frame_jump) {
            return status_fail(ERR_INPUT,
                               "rod: the stiffness centre jumps at s = %.6g mm, by %.2g mm and "
                               "%.2g rad: such a rod is solved in the geometric centre's frame",
                               1e3 * s, 1e3 * apart, b.phi - a.phi);
        }
    }
    return OK;
}

status rod_make(const rod_spec *spec, const rod_options *options, rod **out)
{
    status st = OK;
    rod *r = NULL;
    TRY(check_options(spec->law, options));
    if (options->frame == FRAME_NC) {
        TRY(check_frame(spec->law));
    }
    TRY(TAKE(r, 1));
    r->options = *options;
    r->doubt = 1;
    r->base = r->tip = pose_identity();
    for (int i = 0; i < GAUSS_STATIONS; i++) {
        lie_pair_weights(2 * gauss_point[i], r->pair_weight[i]);
    }
    TRY(rod_copy_spec(r, spec));
    if (options->npanel > 0) {
        TRY(plan_add(r, options->npanel));
        TRY(plan_make(r, (options->npanel + 1) / 2, &r->half));
    } else {
        TRY(plans_choose(r));
    }
    end_frames(r);
    *out = r; // ownership passes only when all is well
    r = NULL;

done:
    rod_free(r);
    return st;
}

void rod_free(rod *r)
{
    if (!r) {
        return;
    }
    for (int i = 0; i < r->nplan; i++) {
        plan_free(&r->plans[i], r);
    }
    plan_free(&r->half, r);
    for (int i = 0; r->path && i < r->ntendon; i++) {
        spline_free(&r->path[i]);
    }
    free(r->path);
    free(r->spec);
    free(r->point_loads);
    free(r->line_loads);
    free(r->acts);
    free(r->breaks);
    free(r);
}

status state_take(const struct rod *r, rod_state *out)
{
    status st = OK;
    rod_state s = {.rod = r, .base = pose_identity()};
    const plan *finest = &r->plans[r->nplan - 1];
    TRY(TAKE(s.tension, (size_t)r->ntendon));
    TRY(TAKE(s.active, (size_t)r->ntendon));
    TRY(TAKE(s.pulling, (size_t)r->ntendon));
    TRY(TAKE(s.lane_tendon, (size_t)r->ntendon));
    TRY(TAKE(s.local.tendon, (size_t)r->ntendon));
    TRY(TAKE(s.xi, 6 * (size_t)finest->nstation + ROW_PADDING));
    TRY(TAKE(s.pair_pose, (size_t)finest->npair + 1));
    *out = s; // ownership passes only when all is well
    s = (rod_state){0};

done:
    state_give_back(&s);
    return st;
}

void state_give_back(rod_state *state)
{
    free(state->tension);
    free(state->active);
    free(state->pulling);
    free(state->lane_tendon);
    free(state->local.tendon);
    free(state->xi);
    free(state->pair_pose);
    *state = (rod_state){0};
}

status rod_state_make(const rod *r, rod_state **out)
{
    status st = OK;
    rod_state *s = NULL;
    TRY(TAKE(s, 1));
    TRY(state_take(r, s));
    TRY(equilibrium_make(r, &s->loaded));
    *out = s; // ownership passes only when all is well
    s = NULL;

done:
    rod_state_free(s);
    return st;
}

void rod_state_free(rod_state *state)
{
    if (state) {
        equilibrium_free(state->loaded);
        state_give_back(state);
        free(state);
    }
}

int rod_load_count(const rod *r)
{
    return r->npoint_load + r->nline_load + r->has_gravity;
}

int rod_panel_count(const rod_state *state)
{
    const rod *r = state->rod;
    const plan *p = state->solved ? state->solved : &r->plans[r->first_plan[ROD_PROBES - 1]];
    return 2 * p->npair;
}

double rod_critical_tension(const rod *r, int tendon, double *s)
{
    const plan_tendon *t = &r->plans[r->nplan - 1].tendon[tendon];
    if (s) {
        *s = t->critical_at;
    }
    return t->critical;
}

static size_t plan_bytes(const rod *r, const plan *p)
{
    const size_t n = (size_t)p->nstation, npanel = 2 * (size_t)p->npair;
    size_t bytes = n * (sizeof *p->s + sizeof *p->K + (21 + 6) * sizeof *p->rest) +
                   npanel * sizeof *p->pair_edge + (size_t)r->ntendon * sizeof *p->tendon;
    bytes += p->frame ? n * (sizeof *p->frame + 4 * sizeof *p->turn) +
                            (npanel + 1) * sizeof *p->node_frame
                      : 0;
    for (int i = 0; i < r->ntendon; i++) {
        const plan_tendon *t = &p->tendon[i];
        bytes += (size_t)t->nstation * (sizeof *t->place + (4 + SECULAR_ROWS) * sizeof *t->row);
    }
    bytes += (size_t)(r->nline_load + r->has_gravity) * (sizeof *p->line + n * sizeof **p->line);
    return bytes + (size_t)r->npoint_load * sizeof *p->point_panel;
}

size_t rod_plan_bytes(const rod *r, int nstation)
{
    int k = 0;
    while (k < r->nplan - 1 && r->plans[k].nstation < nstation) {
        k++;
    }
    return plan_bytes(r, &r->plans[k]);
}
