// measure/registration.c
#include "measure/registration.h"

#include "measure/eigen.h"

#include <math.h>
#include <stdbool.h>

vec3 registration_place(const registration *r, vec3 cloud)
{
    return vec3_add(mat3_mul_vec(r->place.R, cloud), r->place.p);
}

// Weighted centres, scatter and products of two sets of points.
typedef struct pairing {
    double weight;
    vec3 cloud, rod;             // centres
    double cloud2, rod2;         // sums of w |a|^2 about them
    mat3 product;                // S = sum w a b^T, a of the cloud
    mat3 cloud_scatter, scatter; // sum w a a^T, of the cloud and of the rod's points
} pairing;

static double weight_of(const fiducial *f)
{
    return isnan(f->sigma) ? 1 : 1 / (f->sigma * f->sigma);
}

static void add_product(mat3 *sum, double w, vec3 a, vec3 b)
{
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            sum->a[i][k] += w * a.a[i] * b.a[k];
        }
    }
}

static pairing pair_up(int count, const fiducial *f)
{
    pairing p = {0};
    for (int i = 0; i < count; i++) {
        const double w = weight_of(&f[i]);
        p.weight += w;
        p.cloud = vec3_add_scaled(p.cloud, w, f[i].cloud);
        p.rod = vec3_add_scaled(p.rod, w, f[i].rod);
    }
    p.cloud = vec3_scale(1 / p.weight, p.cloud);
    p.rod = vec3_scale(1 / p.weight, p.rod);
    for (int i = 0; i < count; i++) {
        const double w = weight_of(&f[i]);
        const vec3 a = vec3_sub(f[i].cloud, p.cloud), b = vec3_sub(f[i].rod, p.rod);
        p.cloud2 += w * vec3_dot(a, a);
        p.rod2 += w * vec3_dot(b, b);
        add_product(&p.product, w, a, b);
        add_product(&p.cloud_scatter, w, a, a);
        add_product(&p.scatter, w, b, b);
    }
    return p;
}

// spread across the line of the points over that along it
static double flatness(const mat3 *scatter)
{
    double value[EIGEN_MOST], vector[EIGEN_MOST][EIGEN_MOST];
    eigen_symmetric(3, &scatter->a[0][0], value, vector);
    return value[2] > 0 ? sqrt(fmax(value[1], 0) / value[2]) : 0;
}

static status check_pairing(int count, const pairing *p)
{
    // under a hundredth the turn about their line is hardly known
    static const double LEAST_FLATNESS = 0.01;
    // no measured feature is off by so much of their distances
    static const double MOST_SCALE = 1.2;
    if (!(p->rod2 > 0) || !(p->cloud2 > 0) || flatness(&p->scatter) < LEAST_FLATNESS ||
        flatness(&p->cloud_scatter) < LEAST_FLATNESS) {
        return status_fail(
            ERR_INPUT, "the %d fiducials lie in one line: the turn about it stays unknown", count);
    }
    const double scale = sqrt(p->cloud2 / p->rod2);
    if (scale > MOST_SCALE || scale < 1 / MOST_SCALE) {
        return status_fail(ERR_INPUT,
                           "the fiducials lie %.4g times as far apart in the cloud as on the rod: "
                           "another unit, or other features",
                           scale);
    }
    return OK;
}

// Horn's matrix: its largest eigenvalue's vector is the quaternion of the best rotation, its
// smallest eigenvalue what the best mirrored motion would reach, docs/theory.md (9.40)
static void horn(const mat3 *s, double n[4][4])
{
    const double(*a)[3] = s->a;
    const double m[4][4] = {
        {a[0][0] + a[1][1] + a[2][2], a[1][2] - a[2][1], a[2][0] - a[0][2], a[0][1] - a[1][0]},
        {a[1][2] - a[2][1], a[0][0] - a[1][1] - a[2][2], a[0][1] + a[1][0], a[2][0] + a[0][2]},
        {a[2][0] - a[0][2], a[0][1] + a[1][0], a[1][1] - a[0][0] - a[2][2], a[1][2] + a[2][1]},
        {a[0][1] - a[1][0], a[2][0] + a[0][2], a[1][2] + a[2][1], a[2][2] - a[0][0] - a[1][1]}};
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < 4; k++) {
            n[i][k] = m[i][k];
        }
    }
}

static mat3 rotation_of(const double q[4])
{
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    return (mat3){{{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
                   {2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
                   {2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}}};
}

static status best_motion(const pairing *p, pose *out)
{
    // a mirrored motion that leaves a tenth of the squares, where the right one leaves distances of
    // a fiftieth of the whole: no noise does that
    static const double MIRRORED = 0.1, VISIBLE = 1.0 / (50 * 50);
    double n[4][4], value[EIGEN_MOST], vector[EIGEN_MOST][EIGEN_MOST];
    horn(&p->product, n);
    eigen_symmetric(4, &n[0][0], value, vector);
    const double both = p->cloud2 + p->rod2;
    const double left = both - 2 * value[3], mirrored = both + 2 * value[0];
    if (left > VISIBLE * p->rod2 && mirrored < MIRRORED * left) {
        return status_fail(ERR_INPUT, "the fiducials fit only when one frame is mirrored: an axis "
                                      "has the wrong sign, or two features are swapped");
    }
    out->R = rotation_of(vector[3]);
    out->p = vec3_sub(p->rod, mat3_mul_vec(out->R, p->cloud));
    return OK;
}

// what one fiducial of weight w says of (u, w): J = [I, -hat(p)], (9.41)
static void add_information(mat6 *sum, double w, vec3 p)
{
    const mat3 hat = mat3_hat(p);
    double j[3][6] = {{0}};
    for (int i = 0; i < 3; i++) {
        j[i][i] = 1;
        for (int k = 0; k < 3; k++) {
            j[i][3 + k] = -hat.a[i][k];
        }
    }
    for (int r = 0; r < 6; r++) {
        for (int c = 0; c < 6; c++) {
            sum->a[r][c] += w * (j[0][r] * j[0][c] + j[1][r] * j[1][c] + j[2][r] * j[2][c]);
        }
    }
}

static status check_sigmas(int count, const fiducial *f)
{
    int stated = 0;
    for (int i = 0; i < count; i++) {
        stated += !isnan(f[i].sigma);
    }
    if (count < 3) {
        return status_fail(ERR_INPUT, "%d fiducials: at least three are needed", count);
    }
    return stated == 0 || stated == count
               ? OK
               : status_fail(ERR_INPUT, "only %d of %d fiducials have a sigma: all or none", stated,
                             count);
}

status registration_fiducials(int count, fiducial *f, registration *out, fiducial_report *report)
{
    status st = OK;
    registration r = {0};
    mat6 information = {0};
    double squares = 0, chi2 = 0;
    TRY(check_sigmas(count, f));
    const pairing p = pair_up(count, f);
    TRY(check_pairing(count, &p));
    TRY(best_motion(&p, &r.place));
    for (int i = 0; i < count; i++) {
        f[i].residual = vec3_norm(vec3_sub(registration_place(&r, f[i].cloud), f[i].rod));
        squares += f[i].residual * f[i].residual;
        chi2 += weight_of(&f[i]) * f[i].residual * f[i].residual;
        add_information(&information, weight_of(&f[i]), f[i].rod);
    }
    if (!mat6_inverse_spd(information, &r.covariance)) {
        TRY(status_fail(ERR_INPUT, "the fiducials do not fix the frame"));
    }
    const int freedom = 3 * count - 6;
    const bool stated = !isnan(f[0].sigma);
    const double variance = stated ? 1 : chi2 / freedom;
    r.covariance = mat6_scale(variance, r.covariance);
    *report = (fiducial_report){.rms = sqrt(squares / count),
                                .sigma = stated ? sqrt(count / p.weight) : sqrt(variance),
                                .chi2 = stated ? chi2 : freedom,
                                .freedom = freedom};
    *out = r;

done:
    return st;
}

// --- by the axis at the base

// x across the axis: towards the mark turned back by its angle, or the cloud's own
static status across_axis(const base_frame *base, vec3 *x, double *turn_sigma)
{
    vec3 to = {{1, 0, 0}};
    *turn_sigma = 0;
    if (base->mark) {
        to = vec3_sub(base->mark->cloud, base->origin);
    } else if (fabs(base->axis.a[0]) > 0.9) {
        to = (vec3){{0, 1, 0}};
    }
    const double size = vec3_norm(to);
    to = vec3_add_scaled(to, -vec3_dot(to, base->axis), base->axis);
    const double across = vec3_norm(to);
    if (!(across > 1e-3 * size)) {
        return status_fail(ERR_INPUT, "the mark lies on the rod's axis and gives it no turn");
    }
    *x = vec3_scale(1 / across, to);
    if (base->mark) {
        const double c = cos(base->mark->angle), s = sin(base->mark->angle);
        const vec3 y = vec3_cross(base->axis, *x);
        *x = vec3_sub(vec3_scale(c, *x), vec3_scale(s, y));
        *turn_sigma = hypot(base->mark->sigma, base->origin_sigma) / across;
    }
    return OK;
}

status registration_axis(const base_frame *base, registration *out)
{
    status st = OK;
    registration r = {0};
    vec3 x;
    double turn_sigma = 0;
    TRY(across_axis(base, &x, &turn_sigma));
    const vec3 y = vec3_cross(base->axis, x);
    for (int i = 0; i < 3; i++) {
        r.place.R.a[0][i] = x.a[i];
        r.place.R.a[1][i] = y.a[i];
        r.place.R.a[2][i] = base->axis.a[i];
    }
    r.place.p = vec3_scale(-1, mat3_mul_vec(r.place.R, base->origin));
    const double sigma[6] = {base->origin_sigma, base->origin_sigma, base->height_sigma,
                             base->tilt_sigma,   base->tilt_sigma,   turn_sigma};
    for (int i = 0; i < 6; i++) {
        r.covariance.a[i][i] = sigma[i] * sigma[i];
    }
    *out = r;

done:
    return st;
}

// --- carried on (9.44)

mat3 registration_covariance_at(const registration *r, vec3 rod)
{
    mat3 c = {0};
    const mat3 hat = mat3_hat(rod);
    double j[3][6] = {{0}};
    for (int i = 0; i < 3; i++) {
        j[i][i] = 1;
        for (int k = 0; k < 3; k++) {
            j[i][3 + k] = -hat.a[i][k];
        }
    }
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            for (int a = 0; a < 6; a++) {
                for (int b = 0; b < 6; b++) {
                    c.a[i][k] += j[i][a] * r->covariance.a[a][b] * j[k][b];
                }
            }
        }
    }
    return c;
}

double registration_sigma_across(const registration *r, vec3 rod, vec3 tangent)
{
    const mat3 c = registration_covariance_at(r, rod);
    const double trace = c.a[0][0] + c.a[1][1] + c.a[2][2];
    const double along = vec3_dot(tangent, mat3_mul_vec(c, tangent));
    return sqrt(fmax(trace - along, 0) / 2);
}
