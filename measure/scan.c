// measure/scan.c
#include "measure/scan.h"

#include "base/memory.h"
#include "measure/scan_parts.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LEAST_POINTS = 50 }; // a few rings of a few points

void scan_result_free(scan_result *r)
{
    centreline_free(&r->line);
    free(r->fit_sigma);
    point_cloud_free(&r->shown);
    *r = (scan_result){0};
}

static vec3 vector(const double a[3])
{
    return (vec3){{a[0], a[1], a[2]}};
}

static void keep_box(const key_rows *box, point_cloud *cloud, size_t *outside)
{
    const double *a = box->a, *b = box->a + 3;
    size_t kept = 0;
    for (size_t i = 0; i < cloud->count; i++) {
        bool within = true;
        for (int d = 0; d < 3; d++) {
            const double x = cloud->p[i][d];
            within = within && x >= fmin(a[d], b[d]) && x <= fmax(a[d], b[d]);
        }
        if (within) {
            memmove(cloud->p[kept++], cloud->p[i], sizeof cloud->p[i]);
        }
    }
    *outside = cloud->count - kept;
    cloud->count = kept;
}

static tube_options options_of(const scan_settings *s, scan_progress progress)
{
    tube_options o = tube_options_default();
    o.radius = s->radius;
    o.length = s->length;
    o.noise = s->noise;
    o.longest_gap = s->longest_gap;
    o.spacing = s->spacing;
    o.smoothing = s->smoothing;
    o.seed = (unsigned long)s->seed;
    o.base = vector(s->base.point);
    o.direction = vector(s->base.direction);
    if (vec3_norm(o.direction) > 0) {
        o.direction = vec3_scale(1 / vec3_norm(o.direction), o.direction);
    }
    o.progress = progress.tell;
    o.context = progress.context;
    return o;
}

static vec3 tangent_at(const centreline *c, int i)
{
    const int from = i > 0 ? i - 1 : 0, to = i + 1 < c->count ? i + 1 : c->count - 1;
    const vec3 d = vec3_sub(c->p[to], c->p[from]);
    return vec3_scale(1 / fmax(vec3_norm(d), 1e-300), d);
}

// the tangent where the line begins, of the parabola through three of its points
static vec3 first_tangent(const centreline *c)
{
    const double h = (c->s[c->count - 1] - c->s[0]) / 50;
    const vec3 p0 = c->p[0], p1 = centreline_at(c, c->s[0] + h);
    const vec3 p2 = centreline_at(c, c->s[0] + 2 * h);
    vec3 t = vec3_scale(-3, p0);
    t = vec3_add_scaled(t, 4, p1);
    t = vec3_sub(t, p2);
    return vec3_scale(1 / fmax(vec3_norm(t), 1e-300), t);
}

// --- the three ways to the rod's frame

static status by_fiducials(const scan_settings *s, tube_options *o, scan_result *r)
{
    status st = OK;
    const scan_fiducial *given = s->fiducials.items;
    fiducial f[SCAN_MOST_FIDUCIALS];
    const int n = s->fiducials.count;
    for (int i = 0; i < n; i++) {
        f[i] = (fiducial){
            .cloud = vector(given[i].cloud), .rod = vector(given[i].rod), .sigma = given[i].sigma};
    }
    st = registration_fiducials(n, f, &r->place, &r->fiducials);
    if (st != OK) {
        return scan_fail_at(s->fiducials.at, st);
    }
    for (int i = 0; i < n; i++) {
        char number[16];
        (void)snprintf(number, sizeof number, "%d", i + 1);
        (void)snprintf(r->residual[i].name, sizeof r->residual[i].name, "%s",
                       given[i].name ? given[i].name : number);
        r->residual[i].distance = f[i].residual;
    }
    r->nresidual = n;
    const pose back = pose_inverse(r->place.place);
    o->base = back.p;
    o->direction = mat3_mul_vec(back.R, (vec3){{0, 0, 1}});
    o->base_is_plane = true;
    return OK;
}

static status by_axis(const scan_settings *s, const base_frame *base, scan_result *r)
{
    const axis_mark m = {
        .cloud = vector(s->mark.point), .angle = s->mark.angle, .sigma = s->mark.sigma};
    base_frame frame = *base;
    r->turn_free = !mark_given(s->mark.at);
    frame.mark = r->turn_free ? NULL : &m;
    return scan_fail_at(s->mark.at, registration_axis(&frame, &r->place));
}

static status frame_of_plate(const scan_settings *s, scan_result *r)
{
    const cloud_plane *p = &r->plate;
    const base_frame base = {
        .origin = r->line.p[0],
        .axis = p->normal,
        .origin_sigma = r->line.sigma[0],
        .height_sigma = scan_plate_height_sigma(p, r->line.p[0]),
        .tilt_sigma = p->sigma / sqrt((double)p->count) *
                      sqrt((pow(p->spread[0], -2) + pow(p->spread[1], -2)) / 2),
    };
    return by_axis(s, &base, r);
}

// the body's own first stretch: its errors go together over a length
static status frame_of_body(const scan_settings *s, scan_result *r)
{
    const double span = r->line.correlation_length;
    const double sigma = r->line.sigma[0];
    const base_frame base = {
        .origin = r->line.p[0],
        .axis = first_tangent(&r->line),
        .origin_sigma = sigma,
        .height_sigma = r->tube.base_sigma,
        .tilt_sigma = span > 0 ? sqrt(2) * sigma / span : 0,
    };
    return by_axis(s, &base, r);
}

// --- the line in the rod's frame

static status place_line(scan_result *r)
{
    status st = OK;
    centreline *c = &r->line;
    TRY(TAKE(r->fit_sigma, (size_t)c->count));
    for (int i = 0; i < c->count; i++) {
        c->p[i] = registration_place(&r->place, c->p[i]);
    }
    for (int i = 0; i < c->count; i++) {
        r->fit_sigma[i] = c->sigma[i];
        c->sigma[i] =
            hypot(c->sigma[i], registration_sigma_across(&r->place, c->p[i], tangent_at(c, i)));
    }
    const vec3 t = first_tangent(c);
    r->lean = acos(fmin(fmax(t.a[2], -1), 1));

done:
    return st;
}

// the box around the body, with some room
static void body_box(const scan_result *r, double low[3], double high[3])
{
    static const double ROOM = 3; // radii
    for (int d = 0; d < 3; d++) {
        low[d] = INFINITY;
        high[d] = -INFINITY;
        for (int i = 0; i < r->line.count; i++) {
            low[d] = fmin(low[d], r->line.p[i].a[d] - ROOM * r->line.radius);
            high[d] = fmax(high[d], r->line.p[i].a[d] + ROOM * r->line.radius);
        }
    }
}

static bool is_within(const double low[3], const double high[3], vec3 p)
{
    bool in = true;
    for (int d = 0; d < 3; d++) {
        in = in && p.a[d] >= low[d] && p.a[d] <= high[d];
    }
    return in;
}

// every so manyth of the points around the body
static status keep_shown(const point_cloud *cloud, scan_result *r)
{
    status st = OK;
    double low[3], high[3];
    size_t count = 0, seen = 0;
    body_box(r, low, high);
    for (size_t i = 0; i < cloud->count; i++) {
        count += is_within(low, high, registration_place(&r->place, vector(cloud->p[i])));
    }
    const size_t step = count / SCAN_SHOWN + 1;
    TRY(TAKE(r->shown.p, count / step + 1));
    for (size_t i = 0; i < cloud->count; i++) {
        const vec3 p = registration_place(&r->place, vector(cloud->p[i]));
        if (is_within(low, high, p) && seen++ % step == 0) {
            memcpy(r->shown.p[r->shown.count++], p.a, sizeof p.a);
        }
    }

done:
    return st;
}

static scan_frame frame_of(const scan_settings *s)
{
    return s->fiducials.count > 0    ? SCAN_BY_FIDUCIALS
           : mark_given(s->plate.at) ? SCAN_BY_PLATE
                                     : SCAN_BY_BODY;
}

static status check_settings(const scan_settings *s)
{
    const bool axis = mark_given(s->plate.at) || mark_given(s->mark.at);
    if (s->fiducials.count > 0 && axis) {
        const mark at = mark_given(s->plate.at) ? s->plate.at : s->mark.at;
        return status_fail_at(ERR_INPUT, at.line, at.column,
                              "fiducials fix the whole frame: leave plate and mark out");
    }
    if (s->box.nrow != 0 && s->box.nrow != 2) {
        return status_fail_at(ERR_INPUT, s->box.at.line, s->box.at.column,
                              "a box takes two corners: [[x, y, z], [x, y, z]]");
    }
    const vec3 d = vector(s->base.direction);
    return vec3_norm(d) > 0 || isnan(d.a[0])
               ? OK
               : status_fail_at(ERR_INPUT, s->base.at.line, s->base.at.column,
                                "the direction has no length");
}

status scan_measure(point_cloud *cloud, const char *name, const scan_settings *settings,
                    scan_progress progress, scan_result *out)
{
    status st = OK;
    scan_result r = *out;
    tube_options o = options_of(settings, progress);
    r.frame = frame_of(settings);
    r.synthetic = settings->synthetic;
    r.radius_given = !isnan(settings->radius);

    TRY(check_settings(settings));
    TRY(scan_check_unit(cloud, name, r.cloud.unit, settings));
    if (settings->box.nrow == 2) {
        keep_box(&settings->box, cloud, &r.boxed);
    }
    if (cloud->count < LEAST_POINTS) {
        TRY(status_fail(ERR_FILE, "%s: %zu point%s%s: too few to show a tube", name, cloud->count,
                        cloud->count == 1 ? "" : "s", r.boxed > 0 ? " in the box" : ""));
    }
    TRY(r.frame == SCAN_BY_FIDUCIALS ? by_fiducials(settings, &o, &r) : OK);
    TRY(r.frame == SCAN_BY_PLATE ? scan_find_plate(cloud, settings, &o, &r.plate) : OK);
    TRY(tube_centreline(cloud, &o, &r.line, &r.tube));
    TRY(r.frame == SCAN_BY_PLATE  ? frame_of_plate(settings, &r)
        : r.frame == SCAN_BY_BODY ? frame_of_body(settings, &r)
                                  : OK);
    TRY(place_line(&r));
    TRY(keep_shown(cloud, &r));
    *out = r;
    r = (scan_result){0};

done:
    scan_result_free(&r);
    return st;
}
