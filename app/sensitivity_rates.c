// app/sensitivity_rates.c
// How the tip moves by a parameter, from the rod's own derivative towards rods that are made with
// it a little larger and smaller: docs/theory.md (4.27), (9.57).
#include "app/rod_ask.h"
#include "app/sensitivity.h"

#include <math.h>
#include <string.h>

// steps over the range: the misfits' differences keep nine digits, the square of what they leave
// out lies below 1e-7, and the extrapolation takes most of that
static const double step_part = 1e-3;

// where the other rods lie from the case's, in steps: on both sides, or on one where the parameter
// cannot go to the other (friction below 0, nu at one half)
enum { SIDES = 4 };
static const double both[SIDES] = {1, -1, 2, -2}, one_side[SIDES] = {1, 2, 4, 0};

// a step's other rod, on the panels of the base's
typedef struct other {
    bool there;
    double step;
    varied w;
    rod *rod;
} other;

static status make_rod(const varied *w, int npanel, rod **out)
{
    const rod_case *rc = &w->c.file.rod;
    const rod_spec spec = rod_case_spec(rc, w->law);
    return rod_make(
        &spec, &(rod_options){.frame = rc->frame, .tolerance = rc->tolerance, .npanel = npanel},
        out);
}

static status other_make(sensitivity_study *s, int k, double step, int npanel, other *out)
{
    status st = OK;
    settings with = {0};
    const sensitivity_parameter *q = &s->parameter[k];
    out->step = step;
    TRY(settings_add(&with, &q->p, s->out->mover[k].value + step));
    TRY(varied_make(&s->v, &with, q->p.at, &out->w));
    TRY(make_rod(&out->w, npanel, &out->rod));
    out->there = true;

done:
    settings_free(&with);
    return st;
}

static void other_free(other *o)
{
    rod_free(o->rod);
    varied_free(&o->w);
    *o = (other){0};
}

// --- one solution

typedef struct bend_frame {
    vec3 base, tip, across; // tangents; the unit vector across the base's in which the bend grows
    mat3 R;                 // of the tip
    double bend;
} bend_frame;

static vec3 third(mat3 R)
{
    return (vec3){{R.a[0][2], R.a[1][2], R.a[2][2]}};
}

static bend_frame bend_of(pose base, pose tip, double bend)
{
    bend_frame f = {.base = third(base.R), .tip = third(tip.R), .R = tip.R, .bend = bend};
    const vec3 aside = vec3_add_scaled(f.tip, -cos(bend), f.base);
    f.across = vec3_scale(1 / sin(bend), aside);
    return f;
}

// tip = cos b base + sin b across, so that b' = tip' . (cos b across - sin b base)
static double bend_rate(const bend_frame *f, vec6 twist)
{
    const vec3 w = mat3_mul_vec(f->R, vec6_angular(twist));
    const vec3 turns = vec3_cross(w, f->tip);
    return vec3_dot(turns,
                    vec3_add_scaled(vec3_scale(cos(f->bend), f->across), -sin(f->bend), f->base));
}

// of two estimates, off by e and 4 e where both leave out a square: the better one, and its error
static vec6 extrapolate(vec6 fine, vec6 coarse, vec6 *left)
{
    *left = vec6_scale(1.0 / 3, vec6_sub(fine, coarse));
    return vec6_add(fine, *left);
}

static status derive(rod_state *state, const other *o, bool two_sided, double s, vec6 *twist,
                     vec6 *left)
{
    status st = OK;
    vec6 d[SIDES] = {{{0}}};
    for (int i = 0; i < SIDES; i++) {
        TRY(o[i].there ? rod_derive_towards(state, o[i].rod, o[i].step, s, &d[i]) : OK);
    }
    if (two_sided) {
        const vec6 fine = vec6_scale(0.5, vec6_add(d[0], d[1]));
        *twist = extrapolate(fine, vec6_scale(0.5, vec6_add(d[2], d[3])), left);
    } else {
        const vec6 fine = vec6_sub(vec6_scale(2, d[0]), d[1]);
        *twist = extrapolate(fine, vec6_sub(vec6_scale(2, d[1]), d[2]), left);
    }

done:
    return st;
}

static status rate_of(sensitivity_study *s, rod_state *state, const other *o, bool two_sided,
                      const bend_frame *f, move *m)
{
    status st = OK;
    vec6 twist, left;
    TRY(derive(state, o, two_sided, s->c->file.rod.length, &twist, &left));
    const vec3 v = mat3_mul_vec(f->R, vec6_linear(twist));
    memcpy(m->rate, v.a, sizeof m->rate);
    m->bend_rate = bend_rate(f, twist);
    m->rate_error = vec3_norm(vec6_linear(left)) / vec3_norm(v);

done:
    return st;
}

// --- all of them

static status rates_along(sensitivity_study *s, int k, const varied *base, rod *r, const other *o,
                          bool two_sided)
{
    status st = OK;
    rod_state *state = NULL;
    rod_ask ask = {0};
    const sensitivity_result *out = s->out;
    TRY(rod_state_make(r, &state));
    TRY(rod_ask_make(&base->c.file.rod, &ask));
    ask.request.stability = false;
    const pose start = ask.request.base ? ask.base : pose_identity();
    for (int i = 0; i < out->nsolution; i++) {
        rod_solution found = {0};
        move *m = &out->move[k * out->nsolution + i];
        rod_ask_fill(&ask, out->solution[i]);
        ask.request.cold = base->c.file.rod.start == START_REST || i == 0;
        st = rod_solve(state, &ask.request, &found);
        if (rod_ask_limited(st, &found)) {
            status_clear();
            st = OK; // nothing is derived there
            continue;
        }
        TRY(st);
        const bend_frame f = bend_of(start, found.tip, s->bend[i]);
        TRY(rate_of(s, state, o, two_sided, &f, m));
    }

done:
    rod_ask_free(&ask);
    rod_state_free(state);
    return st;
}

// the panels that the hardest of the solutions asks for
static status count_panels(sensitivity_study *s, varied *base, int *npanel)
{
    status st = OK;
    variation_answer a = {0};
    *npanel = 0;
    for (int i = 0; i < s->out->nsolution; i++) {
        TRY(varied_solve(base,
                         &(variation_places){.nsolution = 1, .solution = &s->out->solution[i]},
                         false, &a));
        variation_answer_free(&a);
        const int n = rod_panel_count(base->state);
        *npanel = n > *npanel ? n : *npanel;
    }

done:
    return st;
}

// a refused value is no mistake of the case: the derivative goes to the other side
static status try_other(sensitivity_study *s, int k, double step, int npanel, other *o)
{
    const status st = other_make(s, k, step, npanel, o);
    if (st == OK || (st != ERR_INPUT && st != ERR_NUMERIC)) {
        return st;
    }
    status_clear();
    other_free(o);
    return OK;
}

static status make_others(sensitivity_study *s, int k, int npanel, other o[SIDES], bool *two_sided)
{
    status st = OK;
    const mover *p = &s->out->mover[k];
    const double h = step_part * (p->end[MOVER_HIGH].value - p->end[MOVER_LOW].value);
    int found = 0;
    *two_sided = true;
    for (int i = 0; i < SIDES; i++) {
        TRY(try_other(s, k, both[i] * h, npanel, &o[i]));
        found += o[i].there;
    }
    if (found == SIDES) {
        return OK;
    }
    *two_sided = false;
    const double sign = o[0].there && o[2].there ? 1 : -1;
    for (int i = 0; i < SIDES; i++) {
        other_free(&o[i]);
        TRY(one_side[i] > 0 ? other_make(s, k, sign * one_side[i] * h, npanel, &o[i]) : OK);
    }

done:
    return st;
}

static status find_rates(sensitivity_study *s, int k)
{
    status st = OK;
    varied base = {0};
    other o[SIDES] = {0};
    rod *r = NULL;
    bool two_sided = true;
    int npanel = 0;
    TRY(varied_make(&s->v, NULL, s->parameter[k].p.at, &base));
    TRY(count_panels(s, &base, &npanel));
    TRY(make_rod(&base, npanel, &r));
    TRY(make_others(s, k, npanel, o, &two_sided));
    TRY(rates_along(s, k, &base, r, o, two_sided));

done:
    for (int i = 0; i < SIDES; i++) {
        other_free(&o[i]);
    }
    rod_free(r);
    varied_free(&base);
    return st;
}

status sensitivity_rates(sensitivity_study *s, int k)
{
    mover *p = &s->out->mover[k];
    if (p->discrete) {
        return OK;
    }
    if (isnan(p->value)) {
        (void)snprintf(p->no_rate, sizeof p->no_rate, "the case has an expression there");
        return OK;
    }
    const status st = find_rates(s, k);
    if (st != ERR_NUMERIC && st != ERR_INPUT) {
        return st;
    }
    (void)snprintf(p->no_rate, sizeof p->no_rate, "%s", status_message());
    status_clear();
    return OK;
}
