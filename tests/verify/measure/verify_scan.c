// A whole scan: synthetic clouds of a known line, somewhere in space, back in the rod's frame by
// fiducials, by plate and mark, or by the body alone; and off by what is told.
#include "measure/scan.h"

#include "base/memory.h"
#include "tests/test.h"
#include "tests/verify/measure/made_cloud.h"

#include <math.h>
#include <string.h>

static const double RADIUS = 4e-3, NOISE = 5e-5;
static made_line line;

static vec3 moved(pose g, vec3 p)
{
    return vec3_add(mat3_mul_vec(g.R, p), g.p);
}

// the scanner's frame: anywhere
static pose scanner(int trial)
{
    const vec3 w = {{0.7 + trial, -0.4 * trial, 0.3}}, p = {{0.2, -0.1 * trial, 0.3}};
    return (pose){so3_exp(w), p};
}

static void make(int trial, bool plate, point_cloud *out)
{
    const pose g = scanner(trial);
    const made_scan scan = {.radius = RADIUS,
                            .count = 20000,
                            .noise = NOISE,
                            .stray = 0.03,
                            .plate = plate,
                            .cap = MADE_FLAT,
                            .seed = (unsigned long)trial + 1};
    CHECK_OK(made_cloud(&line, &scan, out));
    for (size_t i = 0; i < out->count; i++) {
        const vec3 p = moved(g, (vec3){{out->p[i][0], out->p[i][1], out->p[i][2]}});
        memcpy(out->p[i], p.a, sizeof p.a);
    }
}

static scan_settings settings(void)
{
    scan_settings s = *(const scan_settings *)scan_keys.initial;
    s.at = (mark){1, 1};
    s.radius = RADIUS;
    s.length = line.length;
    return s;
}

// squared distances across the line over the variance told, mean over the line; and the worst [m]
static double compare(const scan_result *r, double *worst)
{
    double sum = 0;
    for (int i = 0; i < r->line.count; i++) {
        const pose g = made_line_at(&line, fmin(r->line.s[i], line.length));
        const vec3 t = mat3_mul_vec(g.R, (vec3){{0, 0, 1}}), d = vec3_sub(r->line.p[i], g.p);
        const vec3 across = vec3_add_scaled(d, -vec3_dot(d, t), t);
        sum += vec3_dot(across, across) / (2 * r->line.sigma[i] * r->line.sigma[i]);
        *worst = fmax(*worst, vec3_norm(across));
    }
    return sum / r->line.count;
}

enum { TRIALS = 8 };

static void measure(int trial, bool plate, const scan_settings *s, double *sum, double *worst)
{
    point_cloud cloud = {0};
    scan_result r = {.cloud = {.unit = 1e-3}};
    make(trial, plate, &cloud);
    const status st = scan_measure(&cloud, "made", s, (scan_progress){0}, &r);
    if (st != OK) {
        test_failures++;
        printf("trial %d: %s\n", trial, status_message());
        status_clear();
    } else {
        *sum += compare(&r, worst) / TRIALS;
        CHECK_WITHIN(r.line.s[0], 0, 1e-9);
        CHECK_WITHIN(r.line.p[0].a[2], 0, 2e-4);
        CHECK(!r.turn_free);
    }
    scan_result_free(&r);
    point_cloud_free(&cloud);
}

static void by_fiducials(void)
{
    static const double feature[4][3] = {
        {0.03, 0.01, 0}, {-0.025, 0.02, 0.004}, {0.005, -0.03, 0.01}, {0.02, 0.025, 0.06}};
    const gsl_random_door *door = NULL;
    gsl_random *chance = NULL;
    double sum = 0, worst = 0;
    CHECK_OK(gsl_random_door_open(&door));
    CHECK_OK(door->make(3, &chance));
    for (int trial = 0; trial < TRIALS; trial++) {
        scan_fiducial f[4];
        memset(f, 0, sizeof f);
        scan_settings s = settings();
        for (int i = 0; i < 4; i++) {
            memcpy(f[i].rod, feature[i], sizeof f[i].rod);
            const vec3 seen =
                moved(scanner(trial), (vec3){{feature[i][0], feature[i][1], feature[i][2]}});
            for (int d = 0; d < 3; d++) {
                f[i].cloud[d] = seen.a[d] + 1e-4 * door->normal(chance);
            }
            f[i].sigma = 1e-4;
        }
        s.fiducials = (key_list){.at = {1, 1}, .count = 4, .items = f};
        measure(trial, false, &s, &sum, &worst);
    }
    door->free(chance);
    // of a few errors per trial that all points of a line share
    printf("fiducials: squared error over its variance %.2f, worst %.3f mm\n", sum, 1e3 * worst);
    CHECK_WITHIN(sum, 1, 0.8);
    CHECK_WITHIN(worst, 0, 8e-4);
}

static void by_plate_and_mark(bool base_known)
{
    double sum = 0, worst = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        scan_settings s = settings();
        const vec3 near = moved(scanner(trial), (vec3){{0.015, 0.01, 0}});
        const vec3 feature = moved(scanner(trial), (vec3){{0.02 * cos(0.5), 0.02 * sin(0.5), 0}});
        s.plate.at = s.mark.at = (mark){1, 1};
        memcpy(s.plate.point, near.a, sizeof near.a);
        s.plate.reach = 0.05;
        memcpy(s.mark.point, feature.a, sizeof feature.a);
        s.mark.angle = 0.5;
        if (base_known) {
            const vec3 base = moved(scanner(trial), (vec3){{1e-3, -1e-3, 2e-3}});
            memcpy(s.base.point, base.a, sizeof base.a);
        }
        measure(trial, true, &s, &sum, &worst);
    }
    printf("plate and mark: squared error over its variance %.2f, worst %.3f mm\n", sum,
           1e3 * worst);
    CHECK_WITHIN(sum, 1, 0.9);
    CHECK_WITHIN(worst, 0, 1e-4);
}

// the frame of the body itself: its base at the origin, z along it there
static void by_the_body(void)
{
    point_cloud cloud = {0};
    scan_settings s = settings();
    scan_result r = {.cloud = {.unit = 1e-3}};
    make(0, false, &cloud);
    const vec3 base = moved(scanner(0), (vec3){{0, 0, 0}});
    memcpy(s.base.point, base.a, sizeof base.a);
    CHECK_OK(scan_measure(&cloud, "made", &s, (scan_progress){0}, &r));
    CHECK(r.turn_free);
    CHECK_WITHIN(vec3_norm(r.line.p[0]), 0, 1e-12);
    CHECK_WITHIN(r.lean, 0, 1e-6);
    CHECK_WITHIN(r.tube.length, line.length, 3e-4);
    // the tip's height and distance from the axis do not depend on the turn
    const vec3 tip = r.line.p[r.line.count - 1], known = line.at[MADE_STATIONS - 1].p;
    CHECK_WITHIN(tip.a[2], known.a[2], 5e-4);
    CHECK_WITHIN(hypot(tip.a[0], tip.a[1]), hypot(known.a[0], known.a[1]), 5e-4);
    scan_result_free(&r);
    point_cloud_free(&cloud);
}

static void another_unit_is_told(void)
{
    static const double scale[4] = {1e3, 1e-3, 1e3, 1e-3};
    for (int i = 0; i < 4; i++) {
        point_cloud cloud = {0};
        scan_result r = {.cloud = {.unit = 1e-3}};
        scan_settings s = settings();
        s.length = i < 2 ? line.length : (double)NAN;
        make(0, false, &cloud);
        for (size_t k = 0; k < cloud.count; k++) {
            for (int d = 0; d < 3; d++) {
                cloud.p[k][d] *= scale[i];
            }
        }
        CHECK(scan_measure(&cloud, "made", &s, (scan_progress){0}, &r) == ERR_FILE);
        CHECK(strstr(status_message(), i % 2 ? "perhaps it is in m" : "perhaps it is in um"));
        status_clear();
        scan_result_free(&r);
        point_cloud_free(&cloud);
    }
}

int main(void)
{
    against(BY_MADE_DATA, "synthetic clouds of a known line");
    static const double helix[3] = {12, 0, 15};
    made_line_make(0.12, made_arc, helix, &line);
    by_fiducials();
    by_plate_and_mark(true);
    by_plate_and_mark(false);
    by_the_body();
    another_unit_is_told();
    return test_failures != 0;
}
