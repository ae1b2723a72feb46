// tests/unit/base/test_law_along.c
#include "base/law_along.h"
#include "tests/test.h"

static const double length = 0.12;

// the pattern of a made-up section: an entire function of s, in its own frame
typedef struct pattern {
    double EA, x, dx, y, dy, EIx, EIy, axis, daxis, turn, dturn;
} pattern;

static pattern pattern_at(double s)
{
    const double t = s / length;
    return (pattern){
        .EA = 10 + sin(t),
        .x = 0.3 * cos(t),
        .dx = -0.3 * sin(t) / length,
        .y = 0.2 * sin(1.5 * t) - 0.1,
        .dy = 0.3 * cos(1.5 * t) / length,
        .EIx = 5 + 0.3 * t,
        .EIy = 7 - 0.2 * t * t,
        .axis = 0.1 * sin(2 * t),
        .daxis = 0.2 * cos(2 * t) / length,
        .turn = 3 * t * t,
        .dturn = 6 * t / length,
    };
}

// K in the pattern's frame: nothing in it is symmetric
static mat6 pattern_law(double s)
{
    const pattern p = pattern_at(s);
    mat6 K = {0};
    const double diagonal[6] = {3, 4, p.EA, p.EIx, p.EIy, 2};
    for (int i = 0; i < 6; i++) {
        K.a[i][i] = diagonal[i];
    }
    return beam_law_move(beam_law_move(K, 0, 0, -p.axis), -p.x, -p.y, 0);
}

static mat6 exact_law(double s)
{
    return beam_law_move(pattern_law(s), 0, 0, -pattern_at(s).turn);
}

static void fill(law_along *along)
{
    for (int k = 0; k < along->npanel; k++) {
        for (int i = 0; i < along->nnode; i++) {
            const double s = law_along_node(along, k, i);
            along->law[k * along->nnode + i].K = pattern_law(s);
            along->turn[k * along->nnode + i] = pattern_at(s).turn;
        }
    }
}

static void nodes_follow_the_header(void)
{
    law_along a = {0};
    CHECK_OK(law_along_make(length, 2, 5, &a));
    for (int i = 0; i < 5; i++) {
        const double wanted = length / 2 + length / 2 * (1 - cos(acos(-1.0) * i / 4)) / 2;
        CHECK_NEAR(law_along_node(&a, 1, i), wanted, 1e-15);
    }
    CHECK(law_along_node(&a, 0, 4) == law_along_node(&a, 1, 0));
    law_along_free(&a);
    CHECK(law_along_make(length, 0, 3, &a) == ERR_BUG);
    status_clear();
}

static double law_error(int npanel, int nnode, double *slope_error)
{
    law_along a = {0};
    CHECK_OK(law_along_make(length, npanel, nnode, &a));
    fill(&a);
    double worst = 0;
    *slope_error = 0;
    const double h = 1e-3 * length;
    for (int i = 1; i < 40; i++) {
        const double s = length * i / 40;
        mat6 K, dK;
        law_along_at(&a, s, &K, &dK);
        worst = fmax(worst, mat6_relative_error(K, exact_law(s)));
        // an analytic function's derivative by a difference of order 8: good to about 1e-12 here
        static const double c[4] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280};
        mat6 wanted = {0};
        for (int j = 0; j < 4; j++) {
            const mat6 up = exact_law(s + (j + 1) * h), down = exact_law(s - (j + 1) * h);
            wanted = mat6_add(wanted, mat6_scale(c[j] / h, mat6_add(up, mat6_scale(-1, down))));
        }
        for (int j = 0; j < 36; j++) {
            const int r = j / 6, q = j % 6;
            const double size = sqrt(K.a[r][r] * K.a[q][q]) / length;
            *slope_error = fmax(*slope_error, fabs(dK.a[r][q] - wanted.a[r][q]) / size);
        }
    }
    law_along_free(&a);
    return worst;
}

static void law_converges_as_fast_as_an_entire_function_does(void)
{
    double slope_error;
    CHECK(law_error(1, 6, &slope_error) > 1e-6); // the test can tell
    CHECK(law_error(1, 16, &slope_error) < 1e-13);
    CHECK(slope_error < 1e-10);
    CHECK(law_error(3, 12, &slope_error) < 1e-13);
    CHECK(slope_error < 1e-10);
}

// n nodes per panel: the interpolation error falls as (panel length)^n, its derivative's as one
// less
static void panels_converge_at_the_order_of_their_nodes(void)
{
    double h[3], error[3], slope[3];
    for (int i = 0; i < 3; i++) {
        h[i] = 1.0 / (4 << i);
        error[i] = law_error(4 << i, 4, &slope[i]);
    }
    CHECK_WITHIN(observed_order(3, h, error), 4.0, 0.3);
    CHECK_WITHIN(observed_order(3, h, slope), 3.0, 0.3);
}

static void centre_frame_follows_the_pattern(void)
{
    law_along a = {0};
    CHECK_OK(law_along_make(length, 1, 20, &a));
    fill(&a);
    double near = 0;
    for (int i = 0; i <= 40; i++) {
        const double s = length * i / 40;
        const pattern p = pattern_at(s);
        centre_frame f;
        law_along_centre_frame(&a, s, near, &f);
        near = f.phi;
        CHECK_WITHIN(f.phi, p.turn + p.axis, 1e-12);
        CHECK_WITHIN(f.dphi * length, (p.dturn + p.daxis) * length, 1e-9);
        const double c = cos(p.turn), z = sin(p.turn);
        const double x = p.x * c - p.y * z, y = p.x * z + p.y * c;
        CHECK_WITHIN(f.p[0], x, 1e-12);
        CHECK_WITHIN(f.p[1], y, 1e-12);
        CHECK_WITHIN(f.dp[0], p.dx * c - p.dy * z - y * p.dturn, 1e-9);
        CHECK_WITHIN(f.dp[1], p.dx * z + p.dy * c + x * p.dturn, 1e-9);
    }
    law_along_free(&a);
}

// where the two moments cross, the axes keep turning with the pattern instead of jumping by pi/2
static void axes_do_not_jump_where_moments_cross(void)
{
    law_along a = {0};
    CHECK_OK(law_along_make(length, 1, 5, &a));
    for (int i = 0; i < 5; i++) {
        const double t = law_along_node(&a, 0, i) / length;
        for (int j = 0; j < 6; j++) {
            a.law[i].K.a[j][j] = 1 + j;
        }
        a.law[i].K.a[MX][MX] = 5 + t;
        a.law[i].K.a[MY][MY] = 5.5;
        a.turn[i] = t;
    }
    double near = 0;
    for (int i = 0; i <= 20; i++) { // i = 10 is the crossing itself
        centre_frame f;
        law_along_centre_frame(&a, length * i / 20, near, &f);
        near = f.phi;
        CHECK_WITHIN(f.phi, i / 20.0, 1e-9);
        CHECK_WITHIN(f.dphi * length, 1, 1e-9);
    }
    law_along_free(&a);
}

// a declared axis is exact where the moments cross and a mesh's noise sets their product
static void a_declared_axis_is_the_turn(void)
{
    law_along a = {0};
    CHECK_OK(law_along_make(length, 1, 5, &a));
    CHECK(!a.symmetric);
    for (int i = 0; i < 5; i++) {
        const double t = law_along_node(&a, 0, i) / length;
        for (int j = 0; j < 6; j++) {
            a.law[i].K.a[j][j] = 1 + j;
        }
        a.law[i].K.a[MX][MX] = 5 + t;
        a.law[i].K.a[MY][MY] = 5.5;
        a.law[i].K.a[MX][MY] = a.law[i].K.a[MY][MX] = 1e-5 * (i % 2 ? 1 : -0.3);
        a.turn[i] = 4 * t;
    }
    double astray = 0;
    for (int declared = 0; declared < 2; declared++) {
        a.symmetric = declared;
        for (int i = 0; i <= 20; i++) {
            const double s = length * i / 20;
            centre_frame f;
            // a neighbour far off must not matter: a law's stations may be further apart than pi/4
            law_along_centre_frame(&a, s, declared ? 100 : 4 * s / length, &f);
            if (declared) {
                CHECK_WITHIN(f.phi, 4 * s / length, 1e-14);
                CHECK_WITHIN(f.dphi * length, 4, 1e-12);
            } else {
                astray = fmax(astray, fabs(f.dphi * length - 4));
            }
        }
    }
    CHECK(astray > 100); // the test can tell
    law_along_free(&a);
}

static void one_node_is_a_constant_and_s_is_clipped(void)
{
    law_along a = {0};
    CHECK_OK(law_along_make(length, 1, 1, &a));
    a.law[0].K = pattern_law(0);
    a.turn[0] = 0.4;
    mat6 K, dK, end;
    law_along_at(&a, -1, &K, &dK);
    law_along_at(&a, 2 * length, &end, NULL);
    CHECK(mat6_relative_error(K, beam_law_move(pattern_law(0), 0, 0, -0.4)) < 1e-15);
    CHECK(mat6_relative_error(end, K) == 0);
    for (int j = 0; j < 36; j++) {
        CHECK(dK.a[j / 6][j % 6] == 0);
    }
    law_along_free(&a);
}

// a cubic mass and a quadratic centre in a frame that turns: both are the interpolant's own
static void mass_turns_with_the_pattern(void)
{
    law_along a = {0};
    double centre[2];
    CHECK_OK(law_along_make(length, 2, 4, &a));
    CHECK(!law_along_has_mass(&a));
    for (int i = 0; i < 8; i++) {
        const double t = law_along_node(&a, i / 4, i % 4) / length;
        a.law[i].mass = 2 + t - t * t * t;
        a.law[i].mass_centre[0] = 1 + t * t;
        a.law[i].mass_centre[1] = 0.5 * t;
        a.turn[i] = 3 * t * t;
    }
    CHECK(law_along_has_mass(&a));
    for (int i = -1; i <= 11; i++) {
        const double t = fmin(fmax(i / 10.0, 0), 1), turn = 3 * t * t, x = 1 + t * t, y = 0.5 * t;
        CHECK_NEAR(law_along_mass(&a, length * i / 10, centre), 2 + t - t * t * t, 1e-14);
        CHECK_WITHIN(centre[0], x * cos(turn) - y * sin(turn), 1e-14);
        CHECK_WITHIN(centre[1], x * sin(turn) + y * cos(turn), 1e-14);
    }
    a.law[5].mass = 0;
    CHECK(!law_along_has_mass(&a));
    law_along_free(&a);
}

int main(void)
{
    mass_turns_with_the_pattern();
    nodes_follow_the_header();
    law_converges_as_fast_as_an_entire_function_does();
    panels_converge_at_the_order_of_their_nodes();
    centre_frame_follows_the_pattern();
    axes_do_not_jump_where_moments_cross();
    a_declared_axis_is_the_turn();
    one_node_is_a_constant_and_s_is_clipped();
    return test_failures != 0;
}
