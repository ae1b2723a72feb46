// tests/unit/base/test_dense.c
#include "base/dense.h"
#include "tests/test.h"

// 1 / (i + j + 1): positive definite, its inverse is made of integers
static mat6 hilbert(void)
{
    mat6 h;
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            h.a[i][j] = 1.0 / (i + j + 1);
        }
    }
    return h;
}

static void vectors(void)
{
    const vec3 u = {{1, 2, 3}}, v = {{-2, 0.5, 4}};
    const vec3 c = vec3_cross(u, v);
    CHECK(c.a[0] == 6.5 && c.a[1] == -10 && c.a[2] == 4.5);
    CHECK(vec3_dot(c, u) == 0 && vec3_dot(c, v) == 0);
    CHECK(vec3_norm((vec3){{2, -3, 6}}) == 7);
    const vec3 w = mat3_mul_vec(mat3_hat(u), v);
    CHECK(vec3_norm(vec3_sub(w, c)) == 0);
    CHECK(vec3_add(u, vec3_scale(2, v)).a[2] == 11);
}

static void turns_about_z_go_from_x_to_y(void)
{
    const mat3 R = mat3_rot_z(0.3);
    const vec3 x = mat3_mul_vec(R, (vec3){{1, 0, 0}});
    CHECK_NEAR(x.a[0], cos(0.3), 1e-15);
    CHECK_NEAR(x.a[1], sin(0.3), 1e-15);
    const vec3 back = mat3_tmul_vec(R, x);
    CHECK_WITHIN(back.a[0], 1, 1e-15);
    CHECK_WITHIN(back.a[1], 0, 1e-15);
    const mat3 two = mat3_mul(R, R), wanted = mat3_rot_z(0.6);
    CHECK_WITHIN(two.a[1][0], wanted.a[1][0], 1e-15);
    CHECK(mat3_transpose(R).a[0][1] == R.a[1][0]);
}

static void products_keep_their_order(void)
{
    mat6 a = {0}, b = {0};
    a.a[1][4] = 3;
    b.a[4][2] = 5;
    CHECK(mat6_mul(a, b).a[1][2] == 15);
    CHECK(mat6_mul(b, a).a[1][2] == 0);
    CHECK(mat6_transpose(a).a[4][1] == 3);
    CHECK(mat6_symmetric(a).a[4][1] == 1.5);
    const vec6 e = {{0, 0, 0, 0, 2, 0}};
    CHECK(mat6_mul_vec(a, e).a[1] == 6);
    // t^T k t with t = a: k[1][1] lands on [4][4]
    CHECK(mat6_congruence(a, mat6_identity()).a[4][4] == 9);
    CHECK(vec6_dot(e, vec6_sub(vec6_scale(3, e), vec6_add(e, e))) == 4);
    CHECK(mat6_add(a, mat6_scale(2, a)).a[1][4] == 9);
}

static void cholesky_solves(void)
{
    const vec6 x = {{1, -2, 3, -4, 5, -6}};
    mat6 l;
    CHECK(mat6_cholesky(hilbert(), &l));
    const vec6 y = mat6_cholesky_solve(&l, mat6_mul_vec(hilbert(), x));
    for (int i = 0; i < 6; i++) {
        CHECK_NEAR(y.a[i], x.a[i], 1e-8); // condition number 1.5e7
    }
    mat6 indefinite = mat6_identity();
    indefinite.a[0][5] = indefinite.a[5][0] = 1.01;
    CHECK(!mat6_cholesky(indefinite, &l));
    indefinite.a[2][2] = NAN;
    CHECK(!mat6_cholesky(indefinite, &l));
}

static void inverse_of_the_hilbert_matrix_is_integer(void)
{
    mat6 inverse;
    CHECK(mat6_inverse_spd(hilbert(), &inverse));
    CHECK_NEAR(inverse.a[0][0], 36, 1e-8);
    CHECK_NEAR(inverse.a[0][5], -2772, 1e-8);
    CHECK_NEAR(inverse.a[4][4], 4410000, 1e-8);
    CHECK_NEAR(inverse.a[4][5], -1746360, 1e-8);
}

// N and N m side by side: the inverse must not care about the unit of length
static void inverse_does_not_care_about_units(void)
{
    mat6 k = hilbert(), inverse, wanted;
    CHECK(mat6_inverse_spd(k, &wanted));
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            k.a[i][j] *= (i < 3 ? 1 : 0x1p-40) * (j < 3 ? 1 : 0x1p-40);
        }
    }
    CHECK(mat6_inverse_spd(k, &inverse));
    CHECK_NEAR(inverse.a[5][5], wanted.a[5][5] * 0x1p80, 1e-14);
    CHECK_NEAR(inverse.a[0][5], wanted.a[0][5] * 0x1p40, 1e-14);
    k.a[3][3] = 0;
    CHECK(!mat6_inverse_spd(k, &inverse));
}

static void relative_error_is_measured_by_the_diagonal(void)
{
    mat6 a = mat6_identity();
    a.a[0][0] = 4;
    mat6 b = a;
    b.a[0][1] = 0.02;
    CHECK_NEAR(mat6_relative_error(b, a), 0.01, 1e-14);
    CHECK(mat6_relative_error(a, a) == 0);
    b.a[3][3] = NAN;
    CHECK(isnan(mat6_relative_error(b, a)));
}

int main(void)
{
    vectors();
    turns_about_z_go_from_x_to_y();
    products_keep_their_order();
    cholesky_solves();
    inverse_of_the_hilbert_matrix_is_integer();
    inverse_does_not_care_about_units();
    relative_error_is_measured_by_the_diagonal();
    return test_failures != 0;
}
