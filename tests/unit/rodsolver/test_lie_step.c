// tests/unit/rodsolver/test_lie_step.c
#include "rodsolver/lie_step.h"
#include "tests/test.h"

static vec6 strain(double s)
{
    return (vec6){{0.1 * sin(3 * s), 0.2 * s, 1 - 0.1 * cos(s), 2 * cos(2 * s), 3 * sin(s), 1 - s}};
}

static pose march(int npanel)
{
    pose g = pose_identity();
    const double h = 1.0 / npanel;
    for (int k = 0; k < npanel; k++) {
        vec6 xi[GAUSS_STATIONS];
        for (int i = 0; i < GAUSS_STATIONS; i++) {
            xi[i] = strain((k + gauss_point[i]) * h);
        }
        g = pose_mul(g, se3_exp(lie_step_twist(h, xi)));
    }
    return g;
}

// g' = g hat(xi) by the classical Runge-Kutta method on the matrix entries: an independent way,
// with its own sign
static pose march_by_matrices(int nstep)
{
    double g[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    const double h = 1.0 / nstep;
    for (int n = 0; n < nstep; n++) {
        double k[4][4][4] = {{{0}}};
        for (int stage = 0; stage < 4; stage++) {
            const double c = stage == 0 ? 0 : stage == 3 ? 1 : 0.5;
            const vec6 x = strain((n + c) * h);
            const double X[4][4] = {{0, -x.a[5], x.a[4], x.a[0]},
                                    {x.a[5], 0, -x.a[3], x.a[1]},
                                    {-x.a[4], x.a[3], 0, x.a[2]},
                                    {0, 0, 0, 0}};
            for (int i = 0; i < 64; i++) {
                const int a = i / 16, b = i / 4 % 4, m = i % 4;
                const double before = stage == 0 ? 0 : k[stage - 1][a][m];
                k[stage][a][b] += (g[a][m] + c * h * before) * X[m][b];
            }
        }
        for (int i = 0; i < 16; i++) {
            const int a = i / 4, b = i % 4;
            g[a][b] += h / 6 * (k[0][a][b] + 2 * k[1][a][b] + 2 * k[2][a][b] + k[3][a][b]);
        }
    }
    pose out = {.p = {{g[0][3], g[1][3], g[2][3]}}};
    for (int i = 0; i < 9; i++) {
        out.R.a[i / 3][i % 3] = g[i / 3][i % 3];
    }
    return out;
}

static double difference(pose g, pose h)
{
    double worst = vec3_norm(vec3_sub(g.p, h.p));
    for (int i = 0; i < 9; i++) {
        worst = fmax(worst, fabs(g.R.a[i / 3][i % 3] - h.R.a[i / 3][i % 3]));
    }
    return worst;
}

static void magnus_step_is_of_order_six(void)
{
    const pose exact = march(256);
    CHECK_WITHIN(difference(exact, march_by_matrices(4000)), 0, 1e-12);
    double h[4], error[4];
    for (int i = 0; i < 4; i++) {
        h[i] = 1.0 / (2 << i);
        error[i] = difference(march(2 << i), exact);
    }
    CHECK_WITHIN(observed_order(3, h + 1, error + 1), 6.0, 0.2);
}

static void gauss_points_are_gauss_points(void)
{
    // exact to degree 5, and the error of degree 6 is 1/2800
    for (int n = 0; n <= 6; n++) {
        double sum = 0;
        for (int i = 0; i < GAUSS_STATIONS; i++) {
            sum += gauss_weight[i] * pow(gauss_point[i], n);
        }
        CHECK_WITHIN(sum, n < 6 ? 1.0 / (n + 1) : 1.0 / 7 - 1.0 / 2800, 1e-15);
    }
}

static void pair_weights_reproduce_degree_five(void)
{
    const double t = 1.37;
    double weight[2 * GAUSS_STATIONS], sum = 0;
    lie_pair_weights(t, weight);
    for (int i = 0; i < 2 * GAUSS_STATIONS; i++) {
        sum += weight[i] * pow(gauss_point[i % GAUSS_STATIONS] + i / GAUSS_STATIONS, 5);
    }
    CHECK_NEAR(sum, pow(t, 5), 1e-13);
}

// eight panels at once, gentle ones and one that turns further than the series reach
static void lanes_step_like_one_panel(void)
{
    lanes h, xi[GAUSS_STATIONS][6];
    for (int k = 0; k < LANES; k++) {
        h[k] = k == 5 ? 1.5 : k == 6 ? 1e-9 : 0.08 * (k + 1);
        for (int i = 0; i < GAUSS_STATIONS; i++) {
            const vec6 x = strain(0.3 * k + gauss_point[i] * h[k]);
            for (int c = 0; c < 6; c++) {
                xi[i][c][k] = x.a[c];
            }
        }
    }
    lanes_pose g;
    double widest = 0;
    lie_step_lanes(&h, (const lanes(*)[6])xi, &g);
    for (int k = 0; k < LANES; k++) {
        vec6 one[GAUSS_STATIONS];
        for (int i = 0; i < GAUSS_STATIONS * 6; i++) {
            one[i / 6].a[i % 6] = xi[i / 6][i % 6][k];
        }
        const vec6 twist = lie_step_twist(h[k], one);
        const pose wanted = se3_exp(twist);
        // brackets of large twists lose some bits
        const double rounding = k == 5 ? 5e-15 : 5e-16;
        for (int i = 0; i < 9; i++) {
            CHECK_WITHIN(g.R[i / 3][i % 3][k], wanted.R.a[i / 3][i % 3], rounding);
        }
        for (int i = 0; i < 3; i++) {
            CHECK_WITHIN(g.p[i][k], wanted.p.a[i], rounding * h[k]);
        }
        widest = fmax(widest, vec3_norm((vec3){{twist.a[3], twist.a[4], twist.a[5]}}));
    }
    CHECK(widest > 2);
}

int main(void)
{
    lanes_step_like_one_panel();
    magnus_step_is_of_order_six();
    gauss_points_are_gauss_points();
    pair_weights_reproduce_degree_five();
    return test_failures != 0;
}
