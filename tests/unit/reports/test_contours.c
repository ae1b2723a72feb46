// tests/unit/reports/test_contours.c
// Lines round areas of a raster, the nearest of many points, surfaces of fewer triangles, and a
// closed surface seen from one side.
#include "base/memory.h"
#include "reports/base64.h"
#include "reports/coarse_surface.h"
#include "reports/near_points.h"
#include "reports/wall_view.h"
#include "tests/surfaces.h"
#include "tests/test.h"

static double loop_area(const contours *c, int loop)
{
    double twice = 0;
    const int first = c->start[loop], n = c->start[loop + 1] - first;
    for (int k = 0; k < n; k++) {
        const double *a = c->at[first + k], *b = c->at[first + (k + 1) % n];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return twice / 2;
}

enum { SIDE = 101 };
static double heights[SIDE * SIDE];
static const raster square = {SIDE, SIDE, heights};

// a ring between radius 20 and 40 about (50, 50): its hole turns the other way
static void a_ring_has_an_outline_and_a_hole(void)
{
    const double pi = acos(-1.0);
    contours c = {0};
    for (int k = 0; k < SIDE * SIDE; k++) {
        const double r = hypot(k % SIDE - 50, k / SIDE - 50);
        heights[k] = fmin(40 - r, r - 20);
    }
    CHECK_OK(contours_make(&square, 0, 0, 0, &c));
    CHECK(c.nloop == 2);
    if (c.nloop == 2) {
        // chords of about a step: an area of 1 / (6 r) less in all
        CHECK_NEAR(fmax(loop_area(&c, 0), loop_area(&c, 1)), pi * 1600, 1e-3);
        CHECK_NEAR(fmin(loop_area(&c, 0), loop_area(&c, 1)), -pi * 400, 2e-3);
    }
    const int all = c.npoint;
    contours_free(&c);
    CHECK_OK(contours_make(&square, 0, 0.2, 0, &c));
    CHECK(c.nloop == 2 && 3 * c.npoint < all);
    CHECK(c.nloop < 2 || fabs(loop_area(&c, 0) + loop_area(&c, 1) - pi * 1200) < 0.2 * 2 * pi * 60);
    contours_free(&c);
    CHECK_OK(contours_make(&square, 0, 0, 2000, &c)); // the hole is too small to be told
    CHECK(c.nloop == 1);
    contours_free(&c);
}

static bool is_up(int i, int j)
{
    return i > 0 && j > 0 && i < SIDE - 1 && j < SIDE - 1 && heights[i + SIDE * j] == 1;
}

// of a cell with corners of 0 and 1: lines go through the middles of its sides
static double cell_area(int i, int j)
{
    static const double of[] = {0, 1.0 / 8, 0.5, 7.0 / 8, 1};
    const bool a = is_up(i, j), b = is_up(i + 1, j), c = is_up(i + 1, j + 1), d = is_up(i, j + 1);
    const double *h = heights + i + SIDE * j;
    const bool number = isfinite(h[0] + h[1] + h[SIDE] + h[SIDE + 1]);
    if (a == c && b == d && a != b) {
        return number && h[0] + h[1] + h[SIDE] + h[SIDE + 1] >= 2 ? 6.0 / 8 : 2.0 / 8;
    }
    return of[a + b + c + d];
}

// every mask's lines close, also where corners meet and at the border
static void lines_of_any_mask_enclose_it(void)
{
    unsigned long long seed = 7;
    for (unsigned round = 0; round < 20; round++) {
        contours c = {0};
        double sum = 0, inside = 0;
        for (int k = 0; k < SIDE * SIDE; k++) {
            seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
            heights[k] = k % 97 == 0 ? NAN : (seed >> 33) % 20 < round ? 1 : 0;
        }
        for (int k = 0; k < (SIDE - 1) * (SIDE - 1); k++) {
            inside += cell_area(k % (SIDE - 1), k / (SIDE - 1));
        }
        CHECK_OK(contours_make(&square, 0.5, 0, 0, &c));
        for (int l = 0; l < c.nloop; l++) {
            sum += loop_area(&c, l);
        }
        CHECK_WITHIN(sum, inside, 1e-9);
        CHECK((round == 0) == (c.nloop == 0));
        contours_free(&c);
    }
}

static void the_nearest_point_is_the_nearest(void)
{
    enum { POINTS = 700, ASKED = 300 };
    static double point[POINTS][3];
    unsigned long long seed = 3;
    near_points t = {0};
    for (int k = 0; k < 3 * POINTS; k++) {
        seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
        point[k / 3][k % 3] = k < 90 ? 0.5 : (double)(seed >> 40) / (1 << 24); // some are the same
    }
    point[13][1] = NAN;
    CHECK_OK(near_points_make(POINTS, (const double(*)[3])point, &t));
    for (int i = 0; i < ASKED; i++) {
        vec3 p;
        double least = INFINITY;
        for (int d = 0; d < 3; d++) {
            seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
            p.a[d] = 1.4 * (double)(seed >> 40) / (1 << 24) - 0.2;
        }
        for (int k = 0; k < POINTS; k++) {
            const vec3 q = {{point[k][0], point[k][1], point[k][2]}};
            least = fmin(least, vec3_norm(vec3_sub(p, q)));
        }
        const int k = near_points_find(&t, p);
        CHECK(k >= 0);
        if (k >= 0) {
            const vec3 q = {{point[k][0], point[k][1], point[k][2]}};
            CHECK(vec3_norm(vec3_sub(p, q)) == least);
        }
    }
    near_points_free(&t);
    CHECK_OK(near_points_make(0, NULL, &t));
    CHECK(near_points_find(&t, (vec3){{0}}) == -1);
    near_points_free(&t);
}

static vec3 ball(vec3 direction)
{
    return direction;
}

static void make_ball(int m, surface *s)
{
    made_surface made = {0};
    surface_report report;
    made_ball(&made, m, ball);
    CHECK_OK(surface_make(made.n, (const double(*)[3][3])made.corner,
                          &(surface_options){.path = "ball"}, s, &report));
    made_free(&made);
}

static void a_coarse_ball_is_a_ball(void)
{
    surface s = {0};
    coarse_surface c = {0};
    make_ball(40, &s);
    CHECK_OK(coarse_surface_make(s.nvertex, (const double(*)[3])s.vertex, s.ntriangle,
                                 (const int(*)[3])s.triangle, 2000, &c));
    CHECK(c.ntriangle <= 2000 && c.ntriangle > 1000);
    double volume = 0;
    for (int t = 0; t < c.ntriangle; t++) {
        vec3 v[3];
        for (int k = 0; k < 3; k++) {
            CHECK(c.triangle[t][k] >= 0 && c.triangle[t][k] < c.nvertex);
            const double *p = c.vertex[c.triangle[t][k]];
            v[k] = (vec3){{p[0], p[1], p[2]}};
            CHECK(fabs(vec3_norm(v[k]) - 1) < 0.02); // means of places on a ball lie within it
        }
        volume += vec3_dot(v[0], vec3_cross(v[1], v[2])) / 6;
    }
    CHECK_NEAR(volume, 4 * acos(-1.0) / 3, 0.03);
    coarse_surface_free(&c);
    s.vertex[5][0] = INFINITY;
    CHECK_OK(coarse_surface_make(s.nvertex, (const double(*)[3])s.vertex, s.ntriangle,
                                 (const int(*)[3])s.triangle, INT32_MAX, &c));
    CHECK(c.ntriangle < s.ntriangle && c.ntriangle >= s.ntriangle - 8 &&
          c.nvertex == s.nvertex - 1);
    coarse_surface_free(&c);
    surface_free(&s);
}

// a ball's thickness is 2 sqrt(1 - r^2), whatever side it is seen from
static void a_ball_is_as_thick_as_it_is(void)
{
    surface s = {0};
    wall w = {0};
    wall_view v = {0};
    wall_shade shade = {0};
    make_ball(40, &s);
    CHECK_OK(wall_make(s.nvertex, (const double(*)[3])s.vertex, s.ntriangle,
                       (const int(*)[3])s.triangle, &w));
    const camera aslant = camera_from(0.4, 0.7);
    CHECK_OK(wall_view_make(&w, &aslant, 100, &v));
    int inside = 0;
    for (int k = 0; k < v.nx * v.ny; k++) {
        const double x = v.low[0] + v.step * (k % v.nx), y = v.low[1] + v.step * (k / v.nx);
        const double square_of = 1 - x * x - y * y, half = sqrt(fmax(square_of, 0));
        if (square_of > 0.05) {
            inside++;
            CHECK(fabs(v.thick[k] - 2 * half) < 0.01 && fabs(v.near[k] - half) < 0.01);
            CHECK(fabs(v.far[k] + half) < 0.01 && fabs(v.near_light[k] - half) < 0.05);
            CHECK(fabs(vec3_norm(wall_view_place(&v, k, true)) - 1) < 0.01);
        } else if (square_of < 0) {
            CHECK(v.thick[k] == 0 && v.near[k] == -INFINITY);
        }
    }
    CHECK(inside > 6000);
    CHECK_OK(wall_shade_make(&v, SHADES, 0.3, &shade));
    CHECK(shade.outline.nloop == 1 && shade.level[3].nloop == 1);
    CHECK_NEAR(loop_area(&shade.outline, 0) * v.step * v.step, acos(-1.0), 0.02);
    wall_shade_free(&shade);
    wall_view_free(&v);
    wall_free(&w);
    surface_free(&s);
}

// RFC 4648, section 10
static void letters_of_base64_are_the_standards(void)
{
    static const char *const pairs[][2] = {{"", ""},
                                           {"f", "Zg=="},
                                           {"fo", "Zm8="},
                                           {"foo", "Zm9v"},
                                           {"foob", "Zm9vYg=="},
                                           {"fooba", "Zm9vYmE="},
                                           {"foobar", "Zm9vYmFy"}};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        bytes b = {0};
        CHECK_OK(base64_append(&b, pairs[i][0], strlen(pairs[i][0])));
        CHECK(strcmp(b.data ? b.data : "", pairs[i][1]) == 0);
        bytes_free(&b);
    }
}

int main(void)
{
    a_ring_has_an_outline_and_a_hole();
    lines_of_any_mask_enclose_it();
    the_nearest_point_is_the_nearest();
    a_coarse_ball_is_a_ball();
    a_ball_is_as_thick_as_it_is();
    letters_of_base64_are_the_standards();
    return test_failures != 0;
}
