// measure/registration_plane.c
// A plane among many points that belong to something else.
#include "measure/registration.h"

#include "base/memory.h"
#include "measure/eigen.h"
#include "measure/gsl_door.h"

#include <math.h>

enum {
    TRIES = 400,    // a fifth on the plane: all triples miss it with probability 0.04
    JUDGES = 10000, // points that judge a triple
    LEAST_COUNT = 50,
    REFINEMENTS = 10,
};

// [sigma] of the noise; beyond it a point belongs to something else
static const double REACH_OF_NOISE = 3;

typedef struct plane_search {
    const point_cloud *cloud;
    const plane_options *options;
    size_t count, *near; // the points within reach
} plane_search;

static vec3 point_at(const point_cloud *c, size_t i)
{
    return (vec3){{c->p[i][0], c->p[i][1], c->p[i][2]}};
}

static bool within(const plane_options *o, vec3 p)
{
    return isnan(o->near.a[0]) || !(vec3_norm(vec3_sub(p, o->near)) > o->reach);
}

static status gather(plane_search *f)
{
    status st = OK;
    for (size_t i = 0; i < f->cloud->count; i++) {
        f->count += within(f->options, point_at(f->cloud, i));
    }
    if (f->count < LEAST_COUNT) {
        TRY(status_fail(ERR_FILE, "only %zu points where the plate is looked for", f->count));
    }
    TRY(TAKE(f->near, f->count));
    size_t n = 0;
    for (size_t i = 0; i < f->cloud->count; i++) {
        if (within(f->options, point_at(f->cloud, i))) {
            f->near[n++] = i;
        }
    }

done:
    return st;
}

static double distance(const cloud_plane *p, vec3 at)
{
    return vec3_dot(p->normal, vec3_sub(at, p->centre));
}

// (9.42) every n-th point judges: the sum of its squared distance within the noise' reach, 1 each
// beyond
static double cost_of(const plane_search *f, const cloud_plane *p, size_t step)
{
    const double reach = REACH_OF_NOISE * f->options->noise;
    double cost = 0;
    for (size_t i = 0; i < f->count; i += step) {
        const double d = distance(p, point_at(f->cloud, f->near[i])) / reach;
        cost += d * d < 1 ? d * d : 1;
    }
    return cost;
}

static bool through(const plane_search *f, const gsl_random_door *door, gsl_random *random,
                    cloud_plane *out)
{
    vec3 p[3];
    for (int k = 0; k < 3; k++) {
        const size_t i = (size_t)(door->uniform(random) * (double)f->count);
        p[k] = point_at(f->cloud, f->near[i]);
    }
    const vec3 a = vec3_sub(p[1], p[0]), b = vec3_sub(p[2], p[0]);
    const vec3 n = vec3_cross(a, b);
    const double size = vec3_norm(n), least = 10 * f->options->noise;
    // a small triple says nothing about a direction
    if (!(size > least * fmax(vec3_norm(a), vec3_norm(b)))) {
        return false;
    }
    *out = (cloud_plane){.centre = p[0], .normal = vec3_scale(1 / size, n)};
    return true;
}

static status best_triple(const plane_search *f, cloud_plane *out)
{
    status st = OK;
    const gsl_random_door *door = NULL;
    gsl_random *random = NULL;
    const size_t step = f->count / JUDGES + 1;
    double best = INFINITY;
    TRY(gsl_random_door_open(&door));
    TRY(door->make(f->options->seed, &random));
    for (int i = 0; i < TRIES; i++) {
        cloud_plane p;
        const double cost = through(f, door, random, &p) ? cost_of(f, &p, step) : INFINITY;
        if (cost < best) {
            best = cost;
            *out = p;
        }
    }
    if (isinf(best)) {
        TRY(status_fail(ERR_FILE, "the points where the plate is looked for show no plane"));
    }

done:
    if (door) {
        door->free(random);
    }
    return st;
}

// least squares over what lies within `reach` of the plane
static cloud_plane refine(const plane_search *f, const cloud_plane *p, double reach)
{
    cloud_plane q = {0};
    mat3 scatter = {0};
    double value[EIGEN_MOST], vector[EIGEN_MOST][EIGEN_MOST];
    vec3 sum = {{0, 0, 0}};
    for (size_t i = 0; i < f->count; i++) {
        const vec3 at = point_at(f->cloud, f->near[i]);
        if (fabs(distance(p, at)) < reach) {
            const vec3 d = vec3_sub(at, p->centre);
            sum = vec3_add(sum, d);
            q.count++;
            for (int r = 0; r < 3; r++) {
                for (int c = 0; c < 3; c++) {
                    scatter.a[r][c] += d.a[r] * d.a[c];
                }
            }
        }
    }
    const double n = q.count > 0 ? (double)q.count : 1;
    for (int r = 0; r < 3; r++) {
        for (int c = 0; c < 3; c++) {
            scatter.a[r][c] = (scatter.a[r][c] - sum.a[r] * sum.a[c] / n) / n;
        }
    }
    eigen_symmetric(3, &scatter.a[0][0], value, vector);
    q.centre = vec3_add_scaled(p->centre, 1 / n, sum);
    q.sigma = sqrt(fmax(value[0], 0));
    for (int i = 0; i < 3; i++) {
        q.normal.a[i] = vector[0][i];
        q.axes.a[0][i] = vector[2][i];
        q.axes.a[1][i] = vector[1][i];
        q.axes.a[2][i] = vector[0][i];
    }
    q.spread[0] = sqrt(fmax(value[2], 0));
    q.spread[1] = sqrt(fmax(value[1], 0));
    return q;
}

static status check_plane(const plane_search *f, const cloud_plane *p)
{
    // a strip along a body is no plate, and a tenth of the points may lie within any slice
    static const double LEAST_SPREAD = 10, LEAST_SHARE = 0.03;
    const bool enough =
        p->count >= LEAST_COUNT && (double)p->count >= LEAST_SHARE * (double)f->count;
    if (!enough || p->spread[1] < LEAST_SPREAD * p->sigma ||
        p->spread[1] < REACH_OF_NOISE * f->options->noise) {
        return status_fail(ERR_FILE, "the points where the plate is looked for show no plane");
    }
    return OK;
}

status plane_find(const point_cloud *cloud, const plane_options *options, cloud_plane *out)
{
    status st = OK;
    plane_search f = {.cloud = cloud, .options = options};
    cloud_plane p = {0};
    TRY(gather(&f));
    TRY(best_triple(&f, &p));
    for (int i = 0; i < REFINEMENTS; i++) {
        const double reach =
            REACH_OF_NOISE * fmin(i > 0 ? p.sigma * 1.2 : INFINITY, options->noise);
        p = refine(&f, &p, reach);
    }
    TRY(check_plane(&f, &p));
    *out = p;

done:
    free(f.near);
    return st;
}

vec3 plane_cut(const cloud_plane *plane, vec3 p, vec3 direction, double *height_sigma)
{
    const double k = distance(plane, p) / vec3_dot(plane->normal, direction);
    const vec3 cut = vec3_add_scaled(p, -k, direction), d = vec3_sub(cut, plane->centre);
    double variance = 1;
    for (int i = 0; i < 2; i++) {
        const vec3 axis = {{plane->axes.a[i][0], plane->axes.a[i][1], plane->axes.a[i][2]}};
        variance += pow(vec3_dot(d, axis) / plane->spread[i], 2);
    }
    *height_sigma = plane->sigma * sqrt(variance / (double)plane->count);
    return cut;
}
