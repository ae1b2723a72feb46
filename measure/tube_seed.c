// measure/tube_seed.c
// Where to begin: short cylinders are tried from many starts, the one that is seen best is taken.
#include "measure/tube_inside.h"

#include "base/memory.h"
#include "measure/gsl_door.h"

#include <stdlib.h>
#include <string.h>

enum {
    SAMPLE = 60000,    // points that are looked at
    SEED_WINDOW = 400, // points of one start
    DIRECTIONS = 80,   // over the sphere: every 22 degrees
    TURNS = 8,         // round a normal
    PLACES = 60,       // tried where the base is not known
    MOST_RADII = 24,
};

static const double well_seen = 0.6;                   // share of a window at which the search ends
static const double radius_step = 1.25;                // between radii that are tried
static const double seed_reach = 0.4;                  // radii
static const double offsets[] = {1.5, 2.5, 3.5, 5, 7}; // radii from the base

typedef struct search {
    const tube_options *options;
    tube_window *window;
    const gsl_random_door *door;
    gsl_random *random;
    point_cloud sample;
    int nradius;
    double radius[MOST_RADII];
    bool free_radius;
    tube_station best;
} search;

static bool known(vec3 v)
{
    return isfinite(v.a[0]) && isfinite(v.a[1]) && isfinite(v.a[2]);
}

static status take_sample(const point_cloud *cloud, search *s)
{
    status st = OK;
    TRY(TAKE(s->sample.p, SAMPLE));
    const double every = fmax(1, (double)cloud->count / SAMPLE);
    for (double at = s->door->uniform(s->random) * (every - 1);
         at < (double)cloud->count && s->sample.count < SAMPLE; at += every) {
        const double *p = cloud->p[(size_t)at];
        if (isfinite(p[0]) && isfinite(p[1]) && isfinite(p[2])) {
            memcpy(s->sample.p[s->sample.count++], p, sizeof s->sample.p[0]);
        }
    }

done:
    return st;
}

// points within `reach` of c, evenly thinned to `most`
static void look(search *s, vec3 c, double reach, size_t most)
{
    size_t n = 0;
    for (int pass = 0; pass < 2; pass++) {
        const size_t every = pass ? (n + most - 1) / most : 1;
        size_t seen = 0;
        s->window->count = 0;
        for (size_t i = 0; i < s->sample.count && (pass == 0 || n > 0); i++) {
            const double *p = s->sample.p[i];
            const double x = p[0] - c.a[0], y = p[1] - c.a[1], z = p[2] - c.a[2];
            if (x * x + y * y + z * z < reach * reach) {
                if (pass && seen % every == 0) {
                    memcpy(s->window->p[s->window->count++], p, sizeof s->window->p[0]);
                }
                seen++;
            }
        }
        n = seen;
    }
}

static status try_from(search *s, vec3 c, vec3 t, double radius)
{
    status st = OK;
    tube_station trial = {.c = c, .t = t, .radius = radius};
    TRY(tube_station_fit(s->window, seed_reach * radius, s->free_radius, &trial));
    const vec3 off = vec3_sub(trial.c, c);
    if (trial.good && vec3_norm(off) < 1.5 * radius && trial.share > s->best.share) {
        s->best = trial;
    }

done:
    return st;
}

// evenly over the sphere, by the golden angle
static vec3 direction_of(int i)
{
    const double z = 1 - (2 * i + 1) / (double)DIRECTIONS, turn = i * M_PI * (3 - sqrt(5));
    const double rho = sqrt(1 - z * z);
    return (vec3){{rho * cos(turn), rho * sin(turn), z}};
}

static status from_base(search *s)
{
    status st = OK;
    const bool along = known(s->options->direction);
    const int ndirection = along ? 1 : DIRECTIONS;
    for (size_t o = 0; o < sizeof offsets / sizeof *offsets && s->best.share < well_seen; o++) {
        for (int i = 0; i < s->nradius; i++) {
            for (int d = 0; d < ndirection; d++) {
                const double r = s->radius[i];
                vec3 t = along ? s->options->direction : direction_of(d);
                t = vec3_scale(1 / vec3_norm(t), t);
                const vec3 c = vec3_add_scaled(s->options->base, offsets[o] * r, t);
                look(s, c, 2.2 * r, SEED_WINDOW);
                TRY(try_from(s, c, t, r));
            }
        }
    }

done:
    return st;
}

// the direction in which the window's points spread least
static vec3 normal_of(const tube_window *w)
{
    double mean[3] = {0}, c[3][3] = {{0}};
    for (size_t i = 0; i < w->count; i++) {
        for (int d = 0; d < 3; d++) {
            mean[d] += w->p[i][d] / (double)w->count;
        }
    }
    for (size_t i = 0; i < w->count; i++) {
        for (int d = 0; d < 9; d++) {
            c[d / 3][d % 3] += (w->p[i][d / 3] - mean[d / 3]) * (w->p[i][d % 3] - mean[d % 3]);
        }
    }
    const double trace = c[0][0] + c[1][1] + c[2][2];
    vec3 n = {{0.61, 0.53, 0.59}};
    for (int k = 0; k < 40; k++) { // the power method on trace I - C
        vec3 next = vec3_scale(trace, n);
        for (int d = 0; d < 9; d++) {
            next.a[d / 3] -= c[d / 3][d % 3] * n.a[d % 3];
        }
        n = vec3_scale(1 / (vec3_norm(next) + 1e-300), next);
    }
    return n;
}

static status around_point(search *s, vec3 q, double r)
{
    status st = OK;
    look(s, q, 0.6 * r, SEED_WINDOW);
    if (s->window->count < 6) {
        return OK;
    }
    const vec3 n = normal_of(s->window);
    vec3 e = vec3_cross(n, fabs(n.a[0]) < 0.6 ? (vec3){{1, 0, 0}} : (vec3){{0, 1, 0}});
    e = vec3_scale(1 / vec3_norm(e), e);
    for (int side = -1; side <= 1; side += 2) {
        const vec3 c = vec3_add_scaled(q, side * r, n);
        look(s, c, 2.2 * r, SEED_WINDOW);
        for (int k = 0; k < TURNS && s->window->count; k++) {
            const double turn = k * M_PI / TURNS;
            const vec3 t =
                vec3_add(vec3_scale(cos(turn), e), vec3_scale(sin(turn), vec3_cross(n, e)));
            TRY(try_from(s, c, t, r));
        }
    }

done:
    return st;
}

static status from_anywhere(search *s)
{
    status st = OK;
    const int nplace = s->free_radius && s->nradius > 1 ? PLACES / 2 : PLACES;
    for (int i = 0; i < nplace && s->best.share < well_seen; i++) {
        const size_t at = (size_t)(s->door->uniform(s->random) * (double)s->sample.count);
        const double *p = s->sample.p[at];
        for (int k = 0; k < s->nradius; k++) {
            TRY(around_point(s, (vec3){{p[0], p[1], p[2]}}, s->radius[k]));
        }
    }

done:
    return st;
}

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// between the marks that leave a fiftieth of the points outside on either side: strays do not count
static status extent_of(const point_cloud *c, double *out)
{
    status st = OK;
    double *x = NULL;
    *out = 0;
    TRY(TAKE(x, c->count));
    for (int d = 0; d < 3; d++) {
        for (size_t i = 0; i < c->count; i++) {
            x[i] = c->p[i][d];
        }
        qsort(x, c->count, sizeof *x, by_value);
        *out = fmax(*out, x[c->count - 1 - c->count / 50] - x[c->count / 50]);
    }

done:
    free(x);
    return st;
}

static status choose_radii(search *s)
{
    status st = OK;
    double extent = 0;
    if (isfinite(s->options->radius)) {
        s->radius[s->nradius++] = s->options->radius;
        return OK;
    }
    TRY(extent_of(&s->sample, &extent));
    for (double r = extent / 8; s->nradius < MOST_RADII; r /= radius_step) {
        s->radius[s->nradius++] = r;
    }

done:
    return st;
}

static status search_all(search *s)
{
    return known(s->options->base) ? from_base(s) : from_anywhere(s);
}

status tube_seed(const point_cloud *cloud, const tube_options *options, tube_window *window,
                 tube_station *out)
{
    status st = OK;
    search s = {.options = options, .window = window, .free_radius = !isfinite(options->radius)};
    TRY(gsl_random_door_open(&s.door));
    TRY(s.door->make(options->seed, &s.random));
    TRY(take_sample(cloud, &s));
    if (s.sample.count >= 30) {
        TRY(choose_radii(&s));
        TRY(search_all(&s));
        if (!s.best.good && !s.free_radius) { // a wrong radius is better told than not found
            s.free_radius = true;
            TRY(search_all(&s));
        }
    }
    if (!s.best.good) {
        TRY(status_fail(ERR_FILE, "no tube%s in these %zu points%s",
                        isfinite(options->radius) ? " of that radius" : "", cloud->count,
                        known(options->base) ? " at the base" : ""));
    }
    *out = s.best;

done:
    point_cloud_free(&s.sample);
    if (s.door) {
        s.door->free(s.random);
    }
    return st;
}
