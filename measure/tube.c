// measure/tube.c
#include "measure/tube_inside.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

enum { END_STEPS = 8 };

static const double shortest = 4;              // radii: less is no body whose line could be told
static const double fit_reach = 0.3;           // radii: from the traced surface
static const double most_contradiction = 0.05; // of a given radius: more is a mistake
static const double told_taper = 0.005; // of the radius: less, or less than the noise, is none
// of the expected length: tendons shorten a body by some per cent less
static const double told_missing = 0.02;
static const double longest_gap = 6;           // radii
static const double told_beyond = 2;           // radii: of another tube behind the tip
static const double told_contradiction = 0.01; // more is told, where the points are sure of it

tube_options tube_options_default(void)
{
    const vec3 unknown = {{NAN, NAN, NAN}};
    return (tube_options){.radius = NAN,
                          .base = unknown,
                          .direction = unknown,
                          .length = NAN,
                          .noise = NAN,
                          .longest_gap = NAN,
                          .spacing = NAN,
                          .smoothing = NAN,
                          .seed = 1};
}

static void tell(const tube_options *o, double share)
{
    if (o->progress) {
        o->progress(o->context, share);
    }
}

static status check(const tube_options *o)
{
    const double size = vec3_norm(o->direction);
    if (isfinite(o->radius) && !(o->radius > 0)) {
        return status_fail(ERR_INPUT, "the tube's radius must be positive");
    }
    if (!isnan(size) && !(size > 0)) {
        return status_fail(ERR_INPUT, "the direction at the base has no length");
    }
    if (o->base_is_plane && !(isfinite(o->base.a[0]) && isfinite(size))) {
        return status_fail(ERR_INPUT, "a base plane needs a point and a direction");
    }
    if ((isfinite(o->spacing) && !(o->spacing > 0)) ||
        (isfinite(o->smoothing) && !(o->smoothing > 0)) ||
        (isfinite(o->length) && !(o->length > 0))) {
        return status_fail(ERR_INPUT, "lengths must be positive");
    }
    return OK;
}

static double traced_length(const tube_trace *t)
{
    double length = 0;
    for (int i = 1; i < t->count; i++) {
        length += vec3_norm(vec3_sub(t->at[i].c, t->at[i - 1].c));
    }
    return length;
}

// where the line comes through the base plane
static double plane_foot(const tube_curve *c, const tube_options *o)
{
    double u = 0;
    for (int i = 0; i < 20; i++) {
        vec3 d1;
        const vec3 p = tube_curve_at(c, u, &d1, NULL);
        const double rate = vec3_dot(d1, o->direction);
        u -= vec3_dot(vec3_sub(p, o->base), o->direction) / (fabs(rate) > 0.1 ? rate : 0.1);
    }
    return u;
}

static status find_ends(const tube_fit *f, const tube_options *o, tube_end *base, tube_end *tip)
{
    status st = OK;
    if (o->base_is_plane) {
        *base = (tube_end){.u = plane_foot(&f->curve, o)};
    } else {
        TRY(tube_find_end(f, -1, base));
    }
    TRY(tube_find_end(f, 1, tip));
    if (!(tip->u - base->u > shortest * f->radius)) {
        TRY(status_fail(ERR_FILE, "no tube: what is found of one ends after %.3g mm",
                        (tip->u - base->u) * 1e3));
    }

done:
    return st;
}

// (9.5) the radius drifts where the points are sure of it; else it is one number
static void judge_taper(tube_fit *f)
{
    const double size = fabs(f->taper);
    f->free_taper = size > 6 * f->taper_sigma && size > fmin(told_taper * f->radius, 2 * f->noise);
    f->taper = f->free_taper ? f->taper : 0;
}

static status cut_at_ends(tube_fit *f, const tube_end *base, const tube_end *tip)
{
    tube_curve cut = {0};
    const status st = tube_curve_cut(&f->curve, base->u, tip->u, f->radius, &cut);
    if (st == OK) {
        const double slope = f->taper / f->curve.length;
        f->radius = tube_fit_radius(f, (base->u + tip->u) / 2);
        f->taper = slope * (tip->u - base->u);
        tube_curve_free(&f->curve);
        f->curve = cut;
        for (size_t i = 0; i < f->count; i++) {
            const vec3 q = {{f->p[i][0], f->p[i][1], f->p[i][2]}};
            f->u[i] = tube_curve_foot(&f->curve, q, f->u[i] - base->u, 6);
        }
    }
    return st;
}

// once with the radius free, which is told, then with a given one
static status solve_cut(tube_fit *f, const tube_options *o, tube_report *report)
{
    status st = OK;
    const double reach = fmax(8 * f->noise, 1e-3 * f->radius);
    f->free_radius = true;
    TRY(tube_fit_solve(f, reach, true, true));
    report->radius_free = f->radius;
    report->radius_free_sigma = f->radius_sigma;
    if (isfinite(o->radius)) {
        const double off = fmax(0, fabs(f->radius - o->radius) - fabs(f->taper) / 2);
        if (off > most_contradiction * o->radius && off > 6 * f->radius_sigma) {
            TRY(status_fail(ERR_INPUT,
                            "the radius given, %.4g mm, contradicts the points: %.4g +- %.2g mm",
                            o->radius * 1e3, f->radius * 1e3, f->radius_sigma * 1e3));
        }
        report->radius_differs = off > told_contradiction * o->radius && off > 6 * f->radius_sigma;
        if (!f->free_taper) { // else no one number is it
            f->free_radius = false;
            f->radius = o->radius;
            TRY(tube_fit_solve(f, fmax(reach, 2 * off), false, true));
        }
    }

done:
    return st;
}

// the distance over which errors fall to 1/e of one another, from the middle on
static double correlation_length(const tube_fit *f)
{
    const double middle = f->curve.length / 2;
    for (int i = 1; i <= 200; i++) {
        const double d = middle * i / 200;
        if (tube_fit_correlation(f, middle, middle + d) < exp(-1)) {
            return d;
        }
    }
    return middle;
}

// straight on beyond its end
static vec3 place_at(const tube_curve *c, double s)
{
    vec3 t;
    const vec3 p = tube_curve_at(c, fmin(s, c->length), &t, NULL);
    return vec3_add_scaled(p, fmax(0, s - c->length) / vec3_norm(t), t);
}

// between the feet of both ends: the last steps may have moved the line along itself
// end[1] and on straight over the cap that closes the tip
static status sample_line(const tube_fit *f, const tube_options *o, const vec3 end[2],
                          double straight, centreline *line)
{
    status st = OK;
    tube_curve even = {0};
    const tube_curve *c = &f->curve;
    const double spacing = isfinite(o->spacing) ? o->spacing : f->radius / 4;
    const double from =
        o->base_is_plane ? plane_foot(c, o) : tube_curve_foot(c, end[0], 0, END_STEPS);
    TRY(tube_curve_cut(c, from, tube_curve_foot(c, end[1], c->length - straight, END_STEPS),
                       f->radius, &even));
    const double length = even.length + straight;
    const double most = 1e5, steps = fmin(most, fmax(4, ceil(length / spacing)));
    const int n = (int)steps + 1;
    TRY(centreline_make(n, line));
    for (int i = 0; i < n; i++) {
        line->s[i] = length * i / (n - 1);
        line->p[i] = place_at(&even, line->s[i]);
        line->sigma[i] = tube_fit_sigma(f, c->length * i / (n - 1));
    }
    line->radius = f->radius;
    line->radius_sigma = f->radius_sigma;
    line->correlation_length = correlation_length(f);

done:
    tube_curve_free(&even);
    return st;
}

// What is not seen is bridged up to a length, and must end where it was said to.
static status bridge(const tube_fit *f, const tube_options *o, centreline *line,
                     tube_report *report)
{
    status st = OK;
    double unseen = 0;
    TRY(tube_bridge(f, line, &unseen));
    report->unseen_base = unseen;
    if (o->base_is_plane && unseen > 0.5 * f->radius) {
        const double most = isfinite(o->longest_gap) ? o->longest_gap : longest_gap * f->radius;
        const double away = vec3_norm(vec3_sub(line->p[0], o->base));
        if (unseen > most || away > f->radius) {
            TRY(status_fail(ERR_FILE,
                            "no points on the first %.3g mm from the base; bridged, the line comes "
                            "%.3g mm beside it",
                            unseen * 1e3, away * 1e3));
        }
        // it bends off by e over the length: longer by so much, and where the plane cuts it
        const double e = line->sigma[0];
        const vec3 t = vec3_sub(line->p[1], line->p[0]);
        const double along = fabs(vec3_dot(t, o->direction)) / vec3_norm(t);
        const double tilt = sqrt(fmax(0, 1 - along * along)) / fmax(along, 0.1);
        report->base_sigma = hypot(report->base_sigma, e * tilt + 2 * e * e / unseen);
    }

done:
    return st;
}

static void tell_length(const tube_options *o, tube_report *report)
{
    report->missing = o->length - report->length;
    report->length_differs = fabs(report->missing) > told_missing * o->length &&
                             fabs(report->missing) > 6 * report->length_sigma;
    if (report->length_differs) { // one of the two is wrong by it
        report->tip_sigma = hypot(report->tip_sigma, report->missing);
        report->length_sigma = hypot(report->length_sigma, report->missing);
    }
}

static status follow(const point_cloud *cloud, const tube_options *o, tube_window *window,
                     tube_fit *f, tube_report *report)
{
    status st = OK;
    tube_station seed = {0};
    tube_grid grid = {0};
    tube_trace trace = {0};
    TRY(tube_seed(cloud, o, window, &seed));
    tell(o, 0.1);
    TRY(tube_grid_make(cloud, seed.c, seed.radius, &grid));
    tell(o, 0.3);
    TRY(tube_trace_make(&grid, &seed, o, window, &trace));
    report->ncylinder = trace.ncylinder;
    if (trace.beyond.length > told_beyond * seed.radius) {
        report->beyond = trace.beyond.length;
        report->beyond_radius = trace.beyond.radius;
    }
    if (traced_length(&trace) < (shortest - 1.5) * seed.radius) {
        TRY(status_fail(ERR_FILE, "no tube: what looks like one ends after %.3g mm",
                        traced_length(&trace) * 1e3));
    }
    TRY(tube_alone(&grid, &trace, o, window));
    tell(o, 0.6);
    TRY(tube_fit_make(&grid, &trace, o, window->door, f));
    report->thinned = f->count;

done:
    tube_trace_free(&trace);
    tube_grid_free(&grid);
    return st;
}

status tube_centreline(const point_cloud *cloud, const tube_options *options, centreline *line,
                       tube_report *report)
{
    status st = OK;
    const gsl_spline_door *door = NULL;
    tube_options o = *options;
    tube_window window = {0};
    tube_fit f = {0};
    tube_end base = {0}, tip = {0};
    *report = (tube_report){.points = cloud->count};
    TRY(check(&o));
    if (isfinite(o.direction.a[0])) {
        o.direction = vec3_scale(1 / vec3_norm(o.direction), o.direction);
    }
    TRY(gsl_spline_door_open(&door));
    TRY(tube_window_make(door, &window));
    window.most_noise = isfinite(o.noise) ? 1.5 * o.noise : 0;
    TRY(follow(cloud, &o, &window, &f, report));
    TRY(tube_fit_solve(&f, fit_reach * f.radius, false, false));
    judge_taper(&f);
    tell(&o, 0.8);
    TRY(find_ends(&f, &o, &base, &tip));
    const vec3 end[2] = {tube_curve_at(&f.curve, base.u, NULL, NULL),
                         tube_curve_at(&f.curve, tip.u - tip.straight, NULL, NULL)};
    TRY(cut_at_ends(&f, &base, &tip));
    TRY(solve_cut(&f, &o, report));
    TRY(sample_line(&f, &o, end, tip.straight, line));
    report->base_sigma = base.sigma;
    TRY(bridge(&f, &o, line, report));
    report->tip_sigma = tip.sigma;
    report->tip = tip.kind;
    report->taper = f.taper;
    report->taper_sigma = f.taper_sigma;
    tube_tell(&f, line, report);
    tell_length(&o, report);
    tell(&o, 1);

done:
    tube_fit_free(&f);
    tube_window_free(&window);
    return st;
}
