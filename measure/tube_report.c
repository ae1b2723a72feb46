// measure/tube_report.c
#include "measure/tube_inside.h"

#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

enum { SECTORS = 24, MOST_BINS = 400, POINTS_PER_BIN = 80 };

static const double own_reach = 1.7;   // radii round the line: points that are its own
static const double as_good = 0.5;     // of the length: another tube could be meant
static const double least_seen = 0.25; // of the circumference: less is a gap

static double length_of(const tube_trace *t)
{
    return t->count > 1 ? t->count * t->at[0].radius : 0;
}

// the points that are not round the line
static status others(const tube_grid *grid, const tube_trace *trace, point_cloud *out)
{
    status st = OK;
    bool *own = NULL;
    uint32_t *near = NULL;
    point_cloud rest = {0};
    TRY(TAKE(own, grid->count));
    TRY(TAKE(near, grid->count));
    for (int i = 0; i < trace->count; i++) {
        const size_t n = tube_grid_near(grid, trace->at[i].c, own_reach * trace->at[i].radius, near,
                                        grid->count);
        for (size_t k = 0; k < n; k++) {
            own[near[k]] = true;
        }
    }
    TRY(TAKE(rest.p, grid->count));
    for (size_t i = 0; i < grid->count; i++) {
        if (!own[i]) {
            memcpy(rest.p[rest.count++], grid->p[i], sizeof rest.p[0]);
        }
    }
    *out = rest;
    rest = (point_cloud){0};

done:
    free(own);
    free(near);
    point_cloud_free(&rest);
    return st;
}

status tube_alone(const tube_grid *grid, const tube_trace *trace, const tube_options *options,
                  tube_window *window)
{
    status st = OK;
    point_cloud rest = {0};
    tube_grid cells = {0};
    tube_trace other = {0};
    tube_station seed = {0};
    if (isfinite(options->base.a[0])) {
        return OK;
    }
    tube_options again = *options;
    again.radius = trace->at[0].radius;
    again.seed = options->seed + 1;
    TRY(others(grid, trace, &rest));
    if (tube_seed(&rest, &again, window, &seed) != OK) {
        status_clear();
        goto done;
    }
    TRY(tube_grid_make(&rest, seed.c, seed.radius, &cells));
    TRY(tube_trace_make(&cells, &seed, &again, window, &other));
    if (length_of(&other) > as_good * length_of(trace)) {
        TRY(status_fail(ERR_FILE,
                        "two tubes are in these points, of about %.3g and %.3g mm: say "
                        "where the base is",
                        length_of(trace) * 1e3, length_of(&other) * 1e3));
    }

done:
    point_cloud_free(&rest);
    tube_grid_free(&cells);
    tube_trace_free(&other);
    return st;
}

// sectors of the circumference that are seen, bin after bin along the line
typedef struct bins {
    int count;
    double length;
    bool seen[MOST_BINS][SECTORS];
} bins;

static void see(const tube_fit *f, size_t i, bins *b)
{
    vec3 t;
    const vec3 p = tube_curve_at(&f->curve, f->u[i], &t, NULL);
    const vec3 v = vec3_sub((vec3){{f->p[i][0], f->p[i][1], f->p[i][2]}}, p);
    const int bin = (int)fmax(0, fmin(b->count - 1, f->u[i] / f->curve.length * b->count));
    // any directions across will do, as long as a bin's points share them
    (void)tube_curve_at(&f->curve, (bin + 0.5) * b->length, &t, NULL);
    vec3 e =
        vec3_cross(t, fabs(t.a[0]) < 0.7 * vec3_norm(t) ? (vec3){{1, 0, 0}} : (vec3){{0, 1, 0}});
    e = vec3_scale(1 / vec3_norm(e), e);
    const vec3 d = vec3_cross(vec3_scale(1 / vec3_norm(t), t), e);
    const double turn = atan2(vec3_dot(v, d), vec3_dot(v, e)) / (2 * M_PI) + 0.5;
    b->seen[bin][(int)(turn * SECTORS) % SECTORS] = true;
}

static double angle_seen(const bins *b, int bin)
{
    int n = 0;
    for (int k = 0; k < SECTORS; k++) {
        n += b->seen[bin][k];
    }
    return n * 2 * M_PI / SECTORS;
}

static void tell_gaps(const bins *b, tube_report *report)
{
    bool open = false;
    double sum = 0;
    for (int i = 0; i < b->count; i++) {
        const double angle = angle_seen(b, i);
        sum += angle;
        if (angle >= least_seen * 2 * M_PI) {
            open = false;
            continue;
        }
        if (!open && report->ngap < TUBE_MOST_GAPS) {
            report->gap[report->ngap++] = (tube_gap){i * b->length, 0, angle};
            open = true;
        }
        if (open) {
            tube_gap *gap = &report->gap[report->ngap - 1];
            gap->to = (i + 1) * b->length;
            gap->angle = fmin(gap->angle, angle);
        }
    }
    report->coverage = sum / (2 * M_PI * b->count);
}

void tube_tell(const tube_fit *f, const centreline *line, tube_report *report)
{
    bins b = {0};
    double square = 0;
    for (size_t i = 0; i < f->count; i++) {
        if (f->weight[i] > 0) {
            report->used++;
            square += f->res[i] * f->res[i];
        }
    }
    b.count = (int)fmax(1, fmin(fmin(MOST_BINS, f->curve.length / (f->radius / 4)),
                                (double)report->used / POINTS_PER_BIN));
    b.length = f->curve.length / b.count;
    for (size_t i = 0; i < f->count; i++) {
        if (f->weight[i] > 0) {
            see(f, i, &b);
        }
    }
    tell_gaps(&b, report);
    report->stray = report->thinned - report->used;
    report->rms = report->used ? sqrt(square / (double)report->used) : (double)NAN;
    report->noise = f->noise;
    report->length = line->s[line->count - 1];
    report->length_sigma = hypot(report->base_sigma, report->tip_sigma);
    report->smoothing = f->smoothing;
    report->freedom = f->freedom;
}
