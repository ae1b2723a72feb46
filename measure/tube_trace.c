// measure/tube_trace.c
// Cylinder after cylinder, both ways from the first one; each begins where the last one points to.
#include "measure/tube_inside.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_STATIONS = 20000, MOST_BEYOND = 200 };

static const double stride = 1;                             // radii from one cylinder to the next
static const double trace_reach = 0.35, bridge_reach = 0.6; // radii: from the predicted surface
static const double most_shift = 0.7; // radii that a cylinder may lie off its prediction
static const double most_turn = 0.6;  // rad
// a body's radius may drift: by so much from one cylinder to the next, and from the first one
static const double most_step = 0.08, most_drift = 0.15;
static const double worse =
    1.3; // noise of a cylinder against the least so far: it may have drifted
static const double weak_shift = 0.2, weak_turn = 0.25; // of a strip: it must go where it should
static const double near_base = 4;                      // radii: cylinders that may be the clamp's

typedef struct walk {
    const tube_grid *grid;
    const tube_options *options;
    tube_window *window;
    double radius; // of the first cylinder
    double noise;  // least of a cylinder so far
    uint32_t *near;
    int count, ncylinder;
    tube_station *at; // [MOST_STATIONS]
    tube_beyond beyond[2];
} walk;

static void fill_window(walk *w, vec3 c, double reach)
{
    const size_t n = tube_grid_near(w->grid, c, reach, w->near, w->grid->count);
    const size_t every = (n + TUBE_WINDOW_POINTS - 1) / TUBE_WINDOW_POINTS;
    w->window->count = 0;
    for (size_t i = 0; i < n; i += every) {
        memcpy(w->window->p[w->window->count++], w->grid->p[w->near[i]], sizeof w->window->p[0]);
    }
}

static status fit_at(walk *w, const tube_station *start, double reach, bool free_radius,
                     tube_station *out)
{
    *out = *start;
    fill_window(w, start->c, 2.1 * start->radius);
    w->ncylinder++;
    const status st = tube_station_fit(w->window, reach * start->radius, free_radius, out);
    const double turn = acos(fmin(1, vec3_dot(out->t, start->t)));
    const double shift = vec3_norm(vec3_sub(out->c, start->c)) / start->radius;
    out->good = (out->good && shift < most_shift && turn < most_turn) ||
                (out->weak && !free_radius && shift < weak_shift && turn < weak_turn);
    return st;
}

// with the last one's radius; where that does not do, with one that has drifted from it
static status fit_drifting(walk *w, const tube_station *start, double reach, tube_station *out)
{
    status st = OK;
    tube_station other;
    TRY(fit_at(w, start, reach, false, out));
    if (!out->good || out->noise > worse * w->noise) {
        TRY(fit_at(w, start, reach, true, &other));
        const bool near = fabs(other.radius - start->radius) < most_step * start->radius &&
                          fabs(other.radius - w->radius) < most_drift * w->radius;
        *out =
            other.good && near && (!out->good || worse * other.noise < out->noise) ? other : *out;
    }
    w->noise = out->good ? fmin(w->noise, out->noise) : w->noise;

done:
    return st;
}

// below the base plane, or further than the body is long
static bool is_past(const walk *w, const tube_station *s, double sign, double walked)
{
    const tube_options *o = w->options;
    // a body may bend back below its base: only what leads away from it ends there
    if (o->base_is_plane && sign * vec3_dot(s->t, o->direction) < 0 &&
        vec3_norm(vec3_sub(s->c, o->base)) < near_base * s->radius &&
        vec3_dot(vec3_sub(s->c, o->base), o->direction) < -0.2 * s->radius) {
        return true;
    }
    return isfinite(o->length) && walked > o->length + 2 * s->radius;
}

static bool has_been_here(const walk *w, const tube_station *s)
{
    for (int i = 0; i + 6 < w->count; i++) {
        if (vec3_norm(vec3_sub(w->at[i].c, s->c)) < 0.5 * s->radius) {
            return true;
        }
    }
    return false;
}

// where the tube has ended another one may go on, of any radius
static status look_beyond(walk *w, const tube_station *end, double sign, tube_beyond *out)
{
    status st = OK;
    tube_station last = *end;
    double ahead = 1;
    for (int i = 0; i < MOST_BEYOND && ahead <= 3; i++) {
        const tube_station guess = tube_station_ahead(&last, sign * ahead * last.radius);
        tube_station next;
        if (is_past(w, &guess, sign, 0)) {
            break;
        }
        TRY(fit_at(w, &guess, bridge_reach, true, &next));
        if (!next.good || has_been_here(w, &next)) {
            ahead += 0.5;
            continue;
        }
        out->length += vec3_norm(vec3_sub(next.c, last.c));
        out->radius = next.radius;
        last = next;
        ahead = 1;
    }

done:
    return st;
}

// on from the last station; `sign` -1: against its direction
static status go(walk *w, const tube_station *seed, double sign)
{
    status st = OK;
    tube_station last = *seed;
    double gap = 0, walked = 0;
    const double r = seed->radius;
    const double most_gap = isfinite(w->options->longest_gap) ? w->options->longest_gap : 6 * r;
    while (gap <= most_gap && w->count < MOST_STATIONS) {
        const tube_station guess = tube_station_ahead(&last, sign * (gap + stride * r));
        tube_station next;
        if (is_past(w, &guess, sign, walked + gap)) {
            break;
        }
        TRY(fit_drifting(w, &guess, gap > 0 ? bridge_reach : trace_reach, &next));
        if (!next.good) {
            gap += 0.5 * stride * r;
            continue;
        }
        if (has_been_here(w, &next)) {
            break;
        }
        walked += vec3_norm(vec3_sub(next.c, last.c));
        last = next;
        gap = 0;
        w->at[w->count++] = next;
    }
    if (gap > most_gap) {
        TRY(look_beyond(w, &last, sign, &w->beyond[sign > 0]));
    }

done:
    return st;
}

static void turn_round(tube_station *at, int count)
{
    for (int i = 0; i < count / 2; i++) {
        const tube_station other = at[i];
        at[i] = at[count - 1 - i];
        at[count - 1 - i] = other;
    }
}

static double from_place(const tube_station *s, vec3 place)
{
    return vec3_norm(vec3_sub(s->c, place));
}

// the base comes first, directions lead away from it
static void put_in_order(const tube_options *o, tube_beyond before, tube_trace *t)
{
    const vec3 place = isfinite(o->base.a[0]) ? o->base : (vec3){{0, 0, 0}};
    if (from_place(&t->at[t->count - 1], place) < from_place(&t->at[0], place)) {
        turn_round(t->at, t->count);
        t->beyond = before;
    }
    for (int i = 0; i < t->count; i++) {
        const int j = i + 1 < t->count ? i : i - 1;
        if (j >= 0 && vec3_dot(t->at[i].t, vec3_sub(t->at[j + 1].c, t->at[j].c)) < 0) {
            t->at[i].t = vec3_scale(-1, t->at[i].t);
        }
    }
}

status tube_trace_make(const tube_grid *grid, const tube_station *seed, const tube_options *options,
                       tube_window *window, tube_trace *out)
{
    status st = OK;
    walk w = {.grid = grid, .options = options, .window = window, .radius = seed->radius};
    tube_station first = *seed;
    TRY(TAKE(w.near, grid->count));
    TRY(TAKE(w.at, MOST_STATIONS));
    TRY(fit_at(&w, seed, trace_reach, false, &first));
    first = first.good ? first : *seed;
    w.noise = first.noise;
    TRY(go(&w, &first, -1));
    turn_round(w.at, w.count);
    w.at[w.count++] = first;
    TRY(go(&w, &first, 1));
    *out =
        (tube_trace){.count = w.count, .ncylinder = w.ncylinder, .at = w.at, .beyond = w.beyond[1]};
    w.at = NULL;
    put_in_order(options, w.beyond[0], out);

done:
    free(w.near);
    free(w.at);
    return st;
}

void tube_trace_free(tube_trace *t)
{
    free(t->at);
    *t = (tube_trace){0};
}
