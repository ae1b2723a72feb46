// measure/scan_plate.c
// The unit and the plate of a scan.
#include "measure/scan_parts.h"

#include "base/memory.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

status scan_fail_at(mark at, status st)
{
    char words[512];
    if (st != ERR_INPUT || !mark_given(at)) {
        return st;
    }
    (void)snprintf(words, sizeof words, "%s", status_message());
    status_clear();
    return status_fail_at(st, at.line, at.column, "%s", words);
}

// --- the unit

enum { SAMPLE = 4096 };

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// the diagonal of the box that holds nine tenths of the points along each axis
static status size_of(const point_cloud *cloud, double *size)
{
    status st = OK;
    double *x = NULL;
    const size_t step = cloud->count / SAMPLE + 1, n = (cloud->count + step - 1) / step;
    double squares = 0;
    TRY(TAKE(x, n));
    for (int d = 0; d < 3; d++) {
        for (size_t i = 0; i < n; i++) {
            x[i] = cloud->p[i * step][d];
        }
        qsort(x, n, sizeof *x, by_size);
        squares += pow(x[n - 1 - n / 20] - x[n / 20], 2);
    }
    *size = sqrt(squares);

done:
    free(x);
    return st;
}

// the unit with which `size` comes nearest to `expected`
static const char *better_unit(double size, double unit, double expected)
{
    int best = 0;
    for (int i = 1; i < SCAN_UNITS; i++) {
        const double now = fabs(log(size / unit * scan_unit(best) / expected));
        const double then = fabs(log(size / unit * scan_unit(i) / expected));
        best = then < now ? i : best;
    }
    return scan_unit_name(scan_unit(best));
}

const char *scan_unit_doubt(double radius, double length, double unit, char *words, size_t size)
{
    // The thinnest steered tubes are a tenth of a mm in radius and some mm long, the largest arms a
    // few dm and some metres; the usual one is taken for what fits a bench.
    static const double LEAST_RADIUS = 0.05e-3, MOST_RADIUS = 1, USUAL_RADIUS = 5e-3;
    static const double LEAST_LENGTH = 1e-3, MOST_LENGTH = 20;
    const bool radius_odd = radius < LEAST_RADIUS || radius > MOST_RADIUS;
    const bool length_odd = length < LEAST_LENGTH || length > MOST_LENGTH;
    words[0] = '\0';
    if (radius_odd || length_odd) {
        const char *better = better_unit(radius, unit, USUAL_RADIUS);
        (void)snprintf(words, size,
                       "a body of %.3g mm radius and %.3g mm length, read in %s: is its unit right "
                       "(scan.unit)? perhaps it is in %s",
                       1e3 * radius, 1e3 * length, scan_unit_name(unit), better);
    }
    return words;
}

status scan_check_unit(const point_cloud *cloud, const char *name, double unit,
                       const scan_settings *settings)
{
    // A rod wound up to a knot is a few hundredths of its length across, the bench around it some
    // lengths; a rod is not wider than long, nor a thousand times as long as wide.
    static const double LEAST_OF_LENGTH = 0.01, MOST_OF_LENGTH = 100;
    static const double LEAST_OF_RADIUS = 1, MOST_OF_RADIUS = 5000, USUAL_OF_RADIUS = 30;
    status st = OK;
    double size = 0;
    TRY(size_of(cloud, &size));
    const bool long_known = !isnan(settings->length);
    const double stated = long_known ? settings->length : settings->radius;
    const double least = (long_known ? LEAST_OF_LENGTH : LEAST_OF_RADIUS) * stated;
    const double most = (long_known ? MOST_OF_LENGTH : MOST_OF_RADIUS) * stated;
    // one point has no size, and is told elsewhere
    if (size > 0 && (size < least || size > most)) {
        const double expected = long_known ? stated : USUAL_OF_RADIUS * stated;
        TRY(status_fail(ERR_FILE,
                        "%s: the cloud is %.3g mm across, the body's %s %.4g mm: read in %s "
                        "(scan.unit), perhaps it is in %s",
                        name, 1e3 * size, long_known ? "length" : "radius", 1e3 * stated,
                        scan_unit_name(unit), better_unit(size, unit, expected)));
    }

done:
    return st;
}

// --- the plate

static vec3 point_at(const point_cloud *c, size_t i)
{
    return (vec3){{c->p[i][0], c->p[i][1], c->p[i][2]}};
}

static double height(const cloud_plane *p, vec3 at)
{
    return vec3_dot(p->normal, vec3_sub(at, p->centre));
}

// to the side on which most points lie that are not on it
static void turn_to_body(const point_cloud *cloud, double beyond, cloud_plane *p)
{
    size_t above = 0, below = 0;
    for (size_t i = 0; i < cloud->count; i++) {
        const double h = height(p, point_at(cloud, i));
        above += h > beyond;
        below += h < -beyond;
    }
    if (below > above) {
        p->normal = vec3_scale(-1, p->normal);
    }
}

double scan_plate_height_sigma(const cloud_plane *plate, vec3 at)
{
    double sigma = 0;
    (void)plane_cut(plate, at, plate->normal, &sigma);
    return sigma;
}

// the points above the plate and below `top`, fewer of them, seen from its centre
static status above_plate(const point_cloud *cloud, const cloud_plane *p, double beyond, double top,
                          point_cloud *out)
{
    enum { ENOUGH = 150000 };
    status st = OK;
    const size_t step = cloud->count / ENOUGH + 1;
    TRY(TAKE(out->p, cloud->count / step + 1));
    for (size_t i = 0; i < cloud->count; i += step) {
        const vec3 at = point_at(cloud, i), d = vec3_sub(at, p->centre);
        const double h = height(p, at);
        if (h > beyond && h < top) {
            memcpy(out->p[out->count++], d.a, sizeof d.a);
        }
    }

done:
    return st;
}

// from a first line without the plate, of what is below `top`
static status foot_below(const point_cloud *cloud, const cloud_plane *p, double beyond, double top,
                         const tube_options *o, vec3 *foot)
{
    status st = OK;
    point_cloud above = {0};
    centreline line = {0};
    tube_report report;
    tube_options rough = *o;
    double sigma = 0;
    rough.progress = NULL;
    rough.base = (vec3){{NAN, NAN, NAN}};
    rough.direction = rough.base;
    TRY(above_plate(cloud, p, beyond, top, &above));
    TRY(tube_centreline(&above, &rough, &line, &report));
    const bool reversed = height(p, vec3_add(line.p[0], p->centre)) >
                          height(p, vec3_add(line.p[line.count - 1], p->centre));
    const int end = reversed ? line.count - 1 : 0;
    const int next = reversed ? line.count - 1 - line.count / 20 : line.count / 20;
    const vec3 t = vec3_sub(line.p[next > 0 ? next : 1], line.p[end]);
    *foot = plane_cut(p, vec3_add(line.p[end], p->centre), t, &sigma);

done:
    centreline_free(&line);
    point_cloud_free(&above);
    return st;
}

// Where the body meets the plate: its first stretch is looked for alone, so that a hand further up
// is no second tube; then all of it.
static status find_foot(const point_cloud *cloud, const cloud_plane *p, double beyond,
                        const tube_options *o, vec3 *foot)
{
    static const double FIRST_STRETCH[] = {6, 8, 11}; // radii
    for (int i = 0; i < 3 && !isnan(o->radius); i++) {
        if (foot_below(cloud, p, beyond, FIRST_STRETCH[i] * o->radius, o, foot) == OK) {
            return OK;
        }
        status_clear();
    }
    return foot_below(cloud, p, beyond, INFINITY, o, foot);
}

status scan_find_plate(const point_cloud *cloud, const scan_settings *settings, tube_options *o,
                       cloud_plane *out)
{
    // [sigma] of the plate's points: what is farther is not its own
    static const double CLEAR = 6;
    status st = OK;
    double sigma = 0;
    const plane_options options = {
        .near = {{settings->plate.point[0], settings->plate.point[1], settings->plate.point[2]}},
        .reach = settings->plate.reach,
        .noise = settings->plate.noise,
        .seed = (unsigned long)settings->seed};
    TRY(plane_find(cloud, &options, out));
    const double beyond = CLEAR * out->sigma;
    turn_to_body(cloud, beyond, out);
    if (isnan(o->base.a[0])) {
        TRY(find_foot(cloud, out, beyond, o, &o->base));
    }
    o->base = plane_cut(out, o->base, out->normal, &sigma);
    o->direction = out->normal;
    o->base_is_plane = true;

done:
    return st;
}
