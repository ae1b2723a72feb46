// measure/tube_station.c
#include "measure/tube_inside.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

enum { UNKNOWNS = 7, ROUNDS = 25, SECTORS = 24, SLICES = 5, LEAST_POINTS = 15 };

static const double most_noise = 0.05;         // radii: points that spread further are no surface
static const double most_inside = 0.2;         // density inside the wall against that on it
static const double least_share = 0.15;        // of the window, seen
static const double weak_angle = 0.7;          // rad: enough where the tube is known to go on
static const double least_angle = 1.5;         // rad, covered: a plane along the tube covers less
static const double fade = 6;                  // deviations at which a point no longer counts
static const double normal_deviation = 1.4826; // of a median without sign

status tube_window_make(const gsl_spline_door *door, tube_window *out)
{
    status st = OK;
    tube_window w = {.door = door};
    TRY(TAKE(w.p, TUBE_WINDOW_POINTS));
    TRY(TAKE(w.size, TUBE_WINDOW_POINTS));
    *out = w;
    w = (tube_window){0};

done:
    tube_window_free(&w);
    return st;
}

void tube_window_free(tube_window *w)
{
    free(w->p);
    free(w->size);
    *w = (tube_window){0};
}

// the piece of line c + a + b w + k w^2 / 2 over w along t, in the frame (e1, e2, t)   (9.2)
typedef struct piece {
    vec3 c, e[2], t;
    double x[UNKNOWNS]; // a (2), b (2), k (2), radius
} piece;

static piece piece_of(const tube_station *s)
{
    piece p = {.c = s->c, .t = s->t};
    const int least = fabs(s->t.a[0]) < 0.6 ? 0 : fabs(s->t.a[1]) < 0.6 ? 1 : 2;
    vec3 axis = {{0, 0, 0}};
    axis.a[least] = 1;
    p.e[0] = vec3_cross(s->t, axis);
    p.e[0] = vec3_scale(1 / vec3_norm(p.e[0]), p.e[0]);
    p.e[1] = vec3_cross(s->t, p.e[0]);
    p.x[4] = vec3_dot(s->k, p.e[0]);
    p.x[5] = vec3_dot(s->k, p.e[1]);
    p.x[6] = s->radius;
    return p;
}

typedef struct seen {
    double w, distance, n[2], angle_x, angle_y; // along, from the line, direction from it
} seen;

static seen seen_from(const piece *p, const double q[3])
{
    const vec3 v = vec3_sub((vec3){{q[0], q[1], q[2]}}, p->c);
    const double w = vec3_dot(v, p->t), *x = p->x;
    const double y[2] = {vec3_dot(v, p->e[0]) - (x[0] + w * (x[2] + w * x[4] / 2)),
                         vec3_dot(v, p->e[1]) - (x[1] + w * (x[3] + w * x[5] / 2))};
    const double slope[2] = {x[2] + w * x[4], x[3] + w * x[5]};
    // what of y is across the line's own direction (slope, 1) there
    const double along =
        (y[0] * slope[0] + y[1] * slope[1]) / (1 + slope[0] * slope[0] + slope[1] * slope[1]);
    const double n[3] = {y[0] - along * slope[0], y[1] - along * slope[1], -along};
    const double d = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    const double unit = d > 0 ? 1 / d : 0;
    return (seen){w, d, {n[0] * unit, n[1] * unit}, y[0], y[1]};
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// robust deviation of the residuals within reach
static double spread(const tube_window *w, const piece *p, double reach)
{
    size_t n = 0;
    for (size_t i = 0; i < w->count; i++) {
        const seen s = seen_from(p, w->p[i]);
        const double size = fabs(s.distance - p->x[6]);
        if (size < reach && fabs(s.w) < TUBE_HALF_WINDOW * p->x[6]) {
            w->size[n++] = size;
        }
    }
    qsort(w->size, n, sizeof *w->size, by_size);
    return n ? normal_deviation * w->size[n / 2] : 0;
}

// one Gauss-Newton step of Tukey's loss; *moved: relative to the radius
static status step(const tube_window *w, double reach, bool free_radius, const double *start,
                   piece *p, double *moved)
{
    const int n = UNKNOWNS - !free_radius;
    const double r = p->x[6], half = TUBE_HALF_WINDOW * r;
    double a[UNKNOWNS * UNKNOWNS] = {0}, g[UNKNOWNS] = {0}, count = 0;
    for (size_t i = 0; i < w->count; i++) {
        const seen s = seen_from(p, w->p[i]);
        const double res = s.distance - r, z = res / reach;
        if (fabs(z) >= 1 || fabs(s.w) > half) {
            continue;
        }
        const double weight = (1 - z * z) * (1 - z * z), u = s.w / half;
        const double row[UNKNOWNS] = {s.n[0],         s.n[1],         s.n[0] * u, s.n[1] * u,
                                      s.n[0] * u * u, s.n[1] * u * u, 1};
        count += weight;
        for (int k = 0; k < n; k++) {
            g[k] += weight * row[k] * res;
            for (int l = 0; l < n; l++) {
                a[k * n + l] += weight * row[k] * row[l];
            }
        }
    }
    *moved = 0;
    if (count < 3) {
        return OK;
    }
    const double scale[UNKNOWNS] = {1, 1, half, half, half * half / 2, half * half / 2, 1};
    // where the points do not decide, the start stands
    const double keep[UNKNOWNS] = {1e-5, 1e-5, 1e-4, 1e-4, 3e-3, 3e-3, 1e-4};
    for (int k = 0; k < n; k++) {
        a[k * n + k] += keep[k] * count;
        g[k] -= keep[k] * count * (p->x[k] - start[k]) * scale[k];
    }
    const status st = w->door->solve(n, a, g, false);
    for (int k = 0; k < n && st == OK; k++) {
        const double most = 0.5 * r, dx = fmax(-most, fmin(most, g[k]));
        p->x[k] += dx / scale[k];
        *moved = fmax(*moved, fabs(dx) / r);
    }
    return st;
}

// what part of the window's surface is seen, and whether the tube is hollow
static void judge(const tube_window *w, const piece *p, tube_station *s)
{
    bool all[SECTORS][SLICES] = {{false}}, middle[SECTORS] = {false};
    const double r = p->x[6], half = TUBE_HALF_WINDOW * r, near = fmax(3 * s->noise, 0.005 * r);
    double inside = 0;
    for (size_t i = 0; i < w->count; i++) {
        const seen q = seen_from(p, w->p[i]);
        const double res = q.distance - r, u = q.w / half;
        if (fabs(u) >= 1) {
            continue;
        }
        const int k = (int)((atan2(q.angle_y, q.angle_x) / (2 * M_PI) + 0.5) * SECTORS) % SECTORS;
        if (fabs(res) < near) {
            all[k][(int)((u + 1) / 2 * SLICES)] = true;
            middle[k] |= fabs(u) < 0.5;
            s->used++;
        } else if (res < -4 / 3.0 * near && res > -10 / 3.0 * near) {
            inside++;
        }
    }
    int nall = 0, nmiddle = 0;
    for (int k = 0; k < SECTORS; k++) {
        nmiddle += middle[k];
        for (int l = 0; l < SLICES; l++) {
            nall += all[k][l];
        }
    }
    s->share = nall / (double)(SECTORS * SLICES);
    s->angle = nmiddle * 2 * M_PI / SECTORS;
    s->weak = s->used >= LEAST_POINTS && s->angle > weak_angle &&
              s->noise < fmax(most_noise * r, w->most_noise) && inside < most_inside * s->used;
    s->good = s->weak && s->angle > least_angle && s->share > least_share;
}

static void take_over(const piece *p, tube_station *s)
{
    vec3 t = p->t, k = {{0, 0, 0}};
    for (int d = 0; d < 2; d++) {
        s->c = vec3_add_scaled(s->c, p->x[d], p->e[d]);
        t = vec3_add_scaled(t, p->x[2 + d], p->e[d]);
        k = vec3_add_scaled(k, p->x[4 + d], p->e[d]);
    }
    s->t = vec3_scale(1 / vec3_norm(t), t);
    s->k = vec3_add_scaled(k, -vec3_dot(k, s->t), s->t);
    s->radius = p->x[6];
}

status tube_station_fit(const tube_window *w, double reach, bool free_radius, tube_station *s)
{
    status st = OK;
    piece p = piece_of(s);
    double start[UNKNOWNS], moved = 1;
    memcpy(start, p.x, sizeof start);
    s->good = false;
    s->weak = false;
    s->used = 0;
    for (int i = 0; i < ROUNDS && (i < 4 || moved > 1e-4); i++) {
        TRY(step(w, reach, free_radius, start, &p, &moved));
        s->noise = spread(w, &p, reach);
        reach = fmax(fmin(fade * s->noise, reach), fmax(0.4 * reach, 1e-3 * p.x[6]));
        if (!(p.x[6] > 0.3 * start[6] && p.x[6] < 3 * start[6])) {
            return OK;
        }
    }
    take_over(&p, s);
    judge(w, &p, s);

done:
    return st;
}

tube_station tube_station_ahead(const tube_station *s, double h)
{
    tube_station next = *s;
    const double curvature = vec3_norm(s->k), angle = curvature * h;
    if (fabs(angle) < 1e-9) {
        next.c = vec3_add_scaled(s->c, h, s->t);
        return next;
    }
    const vec3 n = vec3_scale(1 / curvature, s->k);
    next.c = vec3_add_scaled(vec3_add_scaled(s->c, sin(angle) / curvature, s->t),
                             (1 - cos(angle)) / curvature, n);
    next.t = vec3_add(vec3_scale(cos(angle), s->t), vec3_scale(sin(angle), n));
    next.k =
        vec3_scale(curvature, vec3_add(vec3_scale(cos(angle), n), vec3_scale(-sin(angle), s->t)));
    return next;
}
