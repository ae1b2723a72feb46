// Registration against known rigid motions: exact without noise, and with noise scattered as its
// covariance says.
#include "measure/eigen.h"
#include "measure/gsl_door.h"
#include "measure/registration.h"

#include "base/memory.h"
#include "tests/test.h"

#include <math.h>
#include <string.h>

static const gsl_random_door *door;
static gsl_random *chance;

static vec3 normal3(double sigma)
{
    return (vec3){
        {sigma * door->normal(chance), sigma * door->normal(chance), sigma * door->normal(chance)}};
}

static pose random_pose(void)
{
    const vec3 p = normal3(0.3);
    return (pose){so3_exp(normal3(2)), p};
}

static vec3 moved(pose g, vec3 p)
{
    return vec3_add(mat3_mul_vec(g.R, p), g.p);
}

static const vec3 feature[5] = {{{0.03, 0.01, 0}},
                                {{-0.025, 0.02, 0.004}},
                                {{0.005, -0.03, 0.01}},
                                {{0, 0, 0.06}},
                                {{0.01, 0.012, -0.02}}};

// fiducials of a cloud that stands at `g` in the rod's frame
static void make_fiducials(int count, pose g, double noise, double stated, fiducial *f)
{
    const pose back = pose_inverse(g);
    for (int i = 0; i < count; i++) {
        f[i] = (fiducial){.cloud = vec3_add(moved(back, feature[i]), normal3(noise)),
                          .rod = feature[i],
                          .sigma = stated};
    }
}

// the small motion (u, w) from what is true to what was found
static vec6 error_of(const registration *r, pose truth)
{
    const pose e = pose_mul(r->place, pose_inverse(truth));
    const vec3 w = so3_log(e.R);
    return (vec6){{e.p.a[0], e.p.a[1], e.p.a[2], w.a[0], w.a[1], w.a[2]}};
}

static void exact_without_noise(void)
{
    for (int trial = 0; trial < 50; trial++) {
        const pose g = random_pose();
        fiducial f[5];
        registration r;
        fiducial_report report;
        const int count = 3 + trial % 3;
        make_fiducials(count, g, 0, trial % 2 ? NAN : 1e-4, f);
        f[0].sigma *= 3;
        CHECK_OK(registration_fiducials(count, f, &r, &report));
        const vec6 e = error_of(&r, g);
        CHECK_WITHIN(sqrt(vec6_dot(e, e)), 0, 1e-12); // rounding of metres
        CHECK(report.freedom == 3 * count - 6);
        CHECK_WITHIN(report.rms, 0, 1e-12);
    }
}

// e^T C^-1 e has mean 6 and variance 12 where C is the covariance of e
static void scatter_is_the_covariance(void)
{
    enum { TRIALS = 3000 };
    const double noise = 1e-4;
    double sum = 0, sum_chi2 = 0, sum_variance = 0;
    mat6 scatter = {0}, told = {0};
    for (int trial = 0; trial < TRIALS; trial++) {
        const pose g = random_pose();
        fiducial f[5];
        registration r;
        fiducial_report report;
        mat6 inverse;
        make_fiducials(5, g, noise, trial % 2 ? noise : NAN, f);
        CHECK_OK(registration_fiducials(5, f, &r, &report));
        const vec6 e = error_of(&r, g);
        told = r.covariance;
        for (int i = 0; i < 6; i++) {
            for (int k = 0; k < 6; k++) {
                scatter.a[i][k] += e.a[i] * e.a[k] / TRIALS;
            }
        }
        if (trial % 2) {
            CHECK(mat6_inverse_spd(r.covariance, &inverse));
            sum += vec6_dot(e, mat6_mul_vec(inverse, e)) / (TRIALS / 2);
            sum_chi2 += report.chi2 / (TRIALS / 2);
        } else {
            sum_variance += report.sigma * report.sigma / (TRIALS / 2);
        }
    }
    // four deviations of the mean: 4 sqrt(12 / 1500), 4 sqrt(18 / 1500), 4 sqrt(2 / 9 / 1500)
    printf("mean of e C^-1 e %.3f of 6, chi^2 %.3f of 9, variance %.4f of 1\n", sum, sum_chi2,
           sum_variance / (noise * noise));
    CHECK_WITHIN(sum, 6, 0.36);
    CHECK_WITHIN(sum_chi2, 9, 0.44);
    CHECK_NEAR(sum_variance, noise * noise, 0.05);
    (void)told;
    for (int i = 0; i < 6; i++) {
        // 4 sqrt(2 / 3000) of a variance
        CHECK_NEAR(scatter.a[i][i], told.a[i][i], 0.11);
    }
}

static void residuals_and_weights_count(void)
{
    fiducial f[5];
    registration r;
    fiducial_report report;
    make_fiducials(5, pose_identity(), 0, 1e-4, f);
    f[2].cloud.a[0] += 1e-3;
    f[2].sigma = 1; // as good as not there
    CHECK_OK(registration_fiducials(5, f, &r, &report));
    CHECK_WITHIN(f[2].residual, 1e-3, 1e-9);
    CHECK_WITHIN(f[0].residual, 0, 1e-9);
}

static void refused(const char *words, int count, fiducial *f)
{
    registration r;
    fiducial_report report;
    CHECK(registration_fiducials(count, f, &r, &report) == ERR_INPUT);
    if (!strstr(status_message(), words)) {
        test_failures++;
        printf("'%s' does not say '%s'\n", status_message(), words);
    }
    status_clear();
}

static void what_fixes_no_frame_is_refused(void)
{
    fiducial f[5];
    make_fiducials(2, pose_identity(), 0, NAN, f);
    refused("at least three", 2, f);
    make_fiducials(5, pose_identity(), 0, NAN, f);
    for (int i = 0; i < 5; i++) {
        f[i].cloud.a[0] = -f[i].cloud.a[0];
    }
    refused("mirrored", 5, f);
    make_fiducials(5, random_pose(), 0, NAN, f);
    for (int i = 0; i < 5; i++) {
        f[i].cloud = vec3_scale(25.4, f[i].cloud);
    }
    refused("25.4 times as far apart", 5, f);
    make_fiducials(5, random_pose(), 0, NAN, f);
    f[1].sigma = 1e-4;
    refused("only 1 of 5", 5, f);
    const pose g = random_pose();
    for (int i = 0; i < 4; i++) {
        const vec3 p = {{0.01 * i, 0.02 * i, 1e-5 * (i % 2)}};
        f[i] = (fiducial){.cloud = moved(g, p), .rod = p, .sigma = NAN};
    }
    refused("in one line", 4, f);
    for (int i = 0; i < 4; i++) {
        f[i].rod = f[i].cloud = (vec3){{1, 2, 3}};
    }
    refused("in one line", 4, f);
}

// --- the plate

enum { ON_PLATE = 3000, BESIDE = 4000 };

// a plate of 60 x 40 mm normal to z of the frame at `g`, a body on it, strays
static void make_plate(pose g, double noise, point_cloud *c)
{
    const pose back = pose_inverse(g);
    CHECK_OK(TAKE(c->p, ON_PLATE + BESIDE));
    for (int i = 0; i < ON_PLATE + BESIDE; i++) {
        vec3 p = {{0.06 * (door->uniform(chance) - 0.5), 0.04 * (door->uniform(chance) - 0.5), 0}};
        if (i >= ON_PLATE) {
            const double angle = 6.28318 * door->uniform(chance);
            p = i % 4 ? (vec3){{4e-3 * cos(angle), 4e-3 * sin(angle), 0.1 * door->uniform(chance)}}
                      : vec3_add(normal3(0.02), (vec3){{0, 0, 0.02}});
        }
        p = moved(back, vec3_add(p, normal3(noise)));
        memcpy(c->p[c->count++], p.a, sizeof p.a);
    }
}

static double tilt_squared(const cloud_plane *p, pose g)
{
    const double z = fabs(vec3_dot(mat3_mul_vec(g.R, p->normal), (vec3){{0, 0, 1}}));
    return 2 * (1 - fmin(z, 1)); // both directions
}

static void plate_is_found_as_well_as_told(void)
{
    enum { TRIALS = 60 };
    const double noise = 5e-5;
    double sum = 0, height = 0;
    for (int trial = 0; trial < TRIALS; trial++) {
        const pose g = random_pose();
        point_cloud c = {0};
        cloud_plane p;
        make_plate(g, noise, &c);
        const plane_options o = {
            .near = {{NAN, 0, 0}}, .reach = INFINITY, .noise = 2e-4, .seed = (unsigned)trial + 1};
        CHECK_OK(plane_find(&c, &o, &p));
        CHECK_ABOVE((double)p.count, 0.95 * ON_PLATE);
        CHECK_NEAR(p.sigma, noise, 0.1); // of 3000 points, some of the body's foot
        const double told =
            p.sigma * p.sigma / (double)p.count * (pow(p.spread[0], -2) + pow(p.spread[1], -2));
        sum += tilt_squared(&p, g) / told / TRIALS;
        double height_sigma = 0;
        const vec3 cut =
            plane_cut(&p, moved(pose_inverse(g), (vec3){{0, 0, 0.01}}),
                      mat3_mul_vec(mat3_transpose(g.R), (vec3){{0, 0, 1}}), &height_sigma);
        height += pow(moved(g, cut).a[2] / height_sigma, 2) / TRIALS;
        point_cloud_free(&c);
    }
    // of each direction's square over its own variance: mean near 1 within 4 sqrt(2 / 60), more
    // because the feet of body and strays lie within three deviations of the plate
    printf("plate: tilt^2 over its variance %.2f, height^2 over its variance %.2f\n", sum, height);
    CHECK_WITHIN(sum, 1, 0.75);
    CHECK_WITHIN(height, 1, 0.75);
}

static void no_plate_is_told(void)
{
    point_cloud c = {0};
    cloud_plane p;
    CHECK_OK(TAKE(c.p, 2000));
    for (int i = 0; i < 2000; i++) {
        const vec3 at = normal3(0.02);
        memcpy(c.p[c.count++], at.a, sizeof at.a);
    }
    plane_options o = {.near = {{NAN, 0, 0}}, .reach = INFINITY, .noise = 1e-4, .seed = 1};
    CHECK(plane_find(&c, &o, &p) == ERR_FILE);
    status_clear();
    o = (plane_options){.near = {{1, 1, 1}}, .reach = 0.01, .noise = 1e-4, .seed = 1};
    CHECK(plane_find(&c, &o, &p) == ERR_FILE);
    status_clear();
    point_cloud_free(&c);
}

// the mark stands at its angle, the axis is z, the origin the origin
static void axis_and_mark_make_the_frame(void)
{
    const pose g = random_pose(), back = pose_inverse(g);
    const axis_mark mark = {.cloud = moved(back, (vec3){{0.02 * cos(0.7), 0.02 * sin(0.7), 0.03}}),
                            .angle = 0.7,
                            .sigma = 1e-4};
    base_frame base = {.origin = back.p,
                       .axis = mat3_mul_vec(back.R, (vec3){{0, 0, 1}}),
                       .origin_sigma = 0,
                       .tilt_sigma = 1e-3,
                       .mark = &mark};
    registration r;
    CHECK_OK(registration_axis(&base, &r));
    const vec6 e = error_of(&r, g);
    CHECK_WITHIN(sqrt(vec6_dot(e, e)), 0, 1e-12);
    CHECK_NEAR(sqrt(r.covariance.a[5][5]), 1e-4 / 0.02, 1e-9);
    // 100 mm up the axis a tilt of 1e-3 is 0.1 mm
    CHECK_NEAR(registration_sigma_across(&r, (vec3){{0, 0, 0.1}}, (vec3){{0, 0, 1}}), 1e-4, 1e-9);
    const axis_mark on_axis = {.cloud = moved(back, (vec3){{0, 0, 0.03}})};
    base.mark = &on_axis;
    CHECK(registration_axis(&base, &r) == ERR_INPUT);
    status_clear();
    base.mark = NULL;
    CHECK_OK(registration_axis(&base, &r));
    const vec3 z = mat3_mul_vec(r.place.R, base.axis);
    CHECK_WITHIN(z.a[2], 1, 1e-12);
}

// values of a matrix with known ones
static void eigenvalues(void)
{
    const double a[9] = {2, -1, 0, -1, 2, -1, 0, -1, 2};
    double value[EIGEN_MOST], vector[EIGEN_MOST][EIGEN_MOST];
    eigen_symmetric(3, a, value, vector);
    CHECK_NEAR(value[0], 2 - sqrt(2), 1e-14);
    CHECK_NEAR(value[1], 2, 1e-14);
    CHECK_NEAR(value[2], 2 + sqrt(2), 1e-14);
    for (int i = 0; i < 3; i++) {
        for (int r = 0; r < 3; r++) {
            double row = 0;
            for (int c = 0; c < 3; c++) {
                row += a[3 * r + c] * vector[i][c];
            }
            CHECK_WITHIN(row, value[i] * vector[i][r], 1e-14);
        }
    }
}

int main(void)
{
    against(BY_MADE_DATA, "known rigid motions");
    CHECK_OK(gsl_random_door_open(&door));
    CHECK_OK(door->make(7, &chance));
    eigenvalues();
    exact_without_noise();
    scatter_is_the_covariance();
    residuals_and_weights_count();
    what_fixes_no_frame_is_refused();
    plate_is_found_as_well_as_told();
    no_plate_is_told();
    axis_and_mark_make_the_frame();
    door->free(chance);
    return test_failures != 0;
}
