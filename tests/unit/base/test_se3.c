// tests/unit/base/test_se3.c
#include "base/se3.h"
#include "tests/test.h"

static const double pi = 3.14159265358979323846;

static double mat3_difference(mat3 a, mat3 b)
{
    double worst = 0;
    for (int i = 0; i < 9; i++) {
        worst = fmax(worst, fabs(a.a[i / 3][i % 3] - b.a[i / 3][i % 3]));
    }
    return worst;
}

static double pose_difference(pose g, pose h)
{
    return fmax(mat3_difference(g.R, h.R), vec3_norm(vec3_sub(g.p, h.p)));
}

// exp of a 4x4 [hat w, v; 0, 0] by its own power series after halving: an independent way
static pose exp_by_series(vec6 twist)
{
    const int halvings = 8;
    const double c = 1.0 / (1 << halvings);
    const vec3 v = {{c * twist.a[0], c * twist.a[1], c * twist.a[2]}};
    const mat3 W = mat3_hat((vec3){{c * twist.a[3], c * twist.a[4], c * twist.a[5]}});
    pose sum = pose_identity(), term = {.R = W, .p = v};
    for (int k = 1; k < 16; k++) {
        for (int i = 0; i < 3; i++) {
            sum.p.a[i] += term.p.a[i];
            for (int j = 0; j < 3; j++) {
                sum.R.a[i][j] += term.R.a[i][j];
            }
        }
        term.p = vec3_scale(1.0 / (k + 1), mat3_mul_vec(W, term.p));
        term.R = mat3_mul(W, term.R);
        for (int i = 0; i < 9; i++) {
            term.R.a[i / 3][i % 3] /= k + 1;
        }
    }
    for (int k = 0; k < halvings; k++) {
        sum = pose_mul(sum, sum);
    }
    return sum;
}

static void exponential_is_the_power_series(void)
{
    // angles on both sides of the switch at 1/4, up to more than one turn
    const double angle[] = {0, 1e-9, 1e-3, 0.2499, 0.2501, 1, 3.1, 7};
    for (int k = 0; k < 8; k++) {
        const double a = angle[k];
        const vec6 twist = {{0.3, -1.2, 0.7, a * 2 / 7, a * -3 / 7, a * 6 / 7}};
        const pose g = se3_exp(twist);
        CHECK_WITHIN(pose_difference(g, exp_by_series(twist)), 0, 2e-13); // 2^8 roundings
        CHECK_WITHIN(mat3_difference(mat3_mul(g.R, mat3_transpose(g.R)), mat3_identity()), 0,
                     1e-15);
        const vec3 w = {{twist.a[3], twist.a[4], twist.a[5]}};
        CHECK(mat3_difference(so3_exp(w), g.R) == 0);
    }
}

// v = e_z, w = kappa e_y: the circle in the plane of x and z
static void constant_strain_bends_into_a_circle(void)
{
    const double kappa = 40, L = 0.12;
    const pose g = se3_exp((vec6){{0, 0, L, 0, kappa * L, 0}});
    CHECK_NEAR(g.p.a[0], (1 - cos(kappa * L)) / kappa, 1e-14);
    CHECK_NEAR(g.p.a[2], sin(kappa * L) / kappa, 1e-14);
    CHECK_NEAR(g.R.a[0][2], sin(kappa * L), 1e-14);
}

static void logarithm_undoes_the_exponential(void)
{
    const double angle[] = {0, 1e-12, 1e-5, 0.5, 2, 3, pi - 1e-6, pi - 1e-10};
    const vec3 axis[] = {{{1, 0, 0}}, {{0, -1, 0}}, {{0, 0, 1}}, {{2.0 / 7, -3.0 / 7, 6.0 / 7}}};
    for (int k = 0; k < 8; k++) {
        for (int j = 0; j < 4; j++) {
            const vec3 w = vec3_scale(angle[k], axis[j]);
            CHECK_WITHIN(vec3_norm(vec3_sub(so3_log(so3_exp(w)), w)), 0, 1e-14);
        }
    }
    // at pi the sign of the axis is free
    CHECK_NEAR(vec3_norm(so3_log(mat3_rot_z(pi))), pi, 1e-14);
}

// g exp(xi) g^-1 = exp(Ad(g) xi)
static void adjoint_carries_twists(void)
{
    const pose g = se3_exp((vec6){{0.3, -0.1, 0.9, 0.4, -1.1, 0.2}});
    const vec6 xi = {{0.5, 0.2, -0.4, 0.7, 0.1, -0.3}};
    const pose left = pose_mul(pose_mul(g, se3_exp(xi)), pose_inverse(g));
    CHECK_WITHIN(pose_difference(left, se3_exp(mat6_mul_vec(se3_adjoint(g), xi))), 0, 1e-15);
    CHECK_WITHIN(pose_difference(pose_mul(g, pose_inverse(g)), pose_identity()), 0, 1e-15);
}

// exp(a) exp(b) = exp(a + b + [a, b] / 2 + third order)
static void bracket_is_the_commutator(void)
{
    const vec6 a = {{0.3, -0.1, 0.9, 0.4, -1.1, 0.2}}, b = {{0.5, 0.2, -0.4, 0.7, 0.1, -0.3}};
    double h[3], error[3];
    for (int k = 0; k < 3; k++) {
        h[k] = 0.02 / (1 << k);
        const vec6 x = vec6_scale(h[k], a), y = vec6_scale(h[k], b);
        const vec6 z = vec6_add(vec6_add(x, y), vec6_scale(0.5, se3_bracket(x, y)));
        error[k] = pose_difference(pose_mul(se3_exp(x), se3_exp(y)), se3_exp(z));
    }
    CHECK_WITHIN(observed_order(3, h, error), 3.0, 0.05);
}

int main(void)
{
    exponential_is_the_power_series();
    constant_strain_bends_into_a_circle();
    logarithm_undoes_the_exponential();
    adjoint_carries_twists();
    bracket_is_the_commutator();
    return test_failures != 0;
}
