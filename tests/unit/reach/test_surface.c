// tests/unit/reach/test_surface.c
#include "reach/surface.h"

#include "tests/surfaces.h"
#include "tests/test.h"

static const vec3 zero = {{0, 0, 0}}, one = {{10e-3, 20e-3, 30e-3}};

static void refuse(const made_surface *m, const char *words)
{
    surface s = {0};
    surface_report r;
    CHECK(made_closed(m, &s, &r) == ERR_FILE);
    const bool said = strstr(status_message(), words) != NULL;
    if (!said) {
        printf("wanted '%s', said '%s'\n", words, status_message());
    }
    CHECK(said);
    CHECK(strncmp(status_message(), "wall.stl: ", 10) == 0);
    CHECK(strchr(status_message(), '\n') == NULL);
    surface_free(&s);
    status_clear();
}

// neighbours know one another and run along their edge in opposite senses
static void check_across(const surface *s)
{
    int wrong = 0;
    for (int i = 0; i < 3 * s->ntriangle; i++) {
        const int t = i / 3, k = i % 3, u = s->across[t][k] / 3, j = s->across[t][k] % 3;
        wrong += s->across[u][j] != i || s->triangle[t][k] != s->triangle[u][(j + 1) % 3] ||
                 s->triangle[u][j] != s->triangle[t][(k + 1) % 3];
    }
    CHECK(wrong == 0);
}

static void a_box_is_measured(void)
{
    made_surface m = {0};
    surface s = {0};
    surface_report r;
    made_box(&m, zero, one);
    CHECK_OK(made_closed(&m, &s, &r));
    CHECK(s.nvertex == 8 && s.ntriangle == 12 && r.parts == 1 && r.turned == 0);
    CHECK(r.merged == 28 && r.degenerate == 0 && r.inner == 0 && r.flipped == 0);
    CHECK_NEAR(s.volume, 6e-6, 1e-14);
    CHECK_NEAR(s.area, 2 * (2e-4 + 6e-4 + 3e-4), 1e-14);
    CHECK_NEAR(s.high[2], 30e-3, 1e-15);
    CHECK_NEAR(r.merge, 1e-7 * sqrt(14) * 1e-2, 1e-12);
    check_across(&s);
    surface_free(&s);
    made_free(&m);
}

static void senses_are_made_alike_and_outward(void)
{
    made_surface m = {0};
    surface s = {0};
    surface_report r;
    made_ball(&m, 10, made_bumpy);
    for (int i = 0; i < m.n; i += 3) {
        made_turn(&m, i);
    }
    CHECK_OK(made_closed(&m, &s, &r));
    CHECK(r.turned == (m.n + 2) / 3);
    const double volume = s.volume;
    CHECK(volume > 0);
    check_across(&s);
    surface_free(&s);
    for (int i = 0; i < m.n; i++) {
        i % 3 ? made_turn(&m, i) : (void)0;
    }
    CHECK_OK(made_closed(&m, &s, &r));
    CHECK(r.turned == m.n);
    CHECK_NEAR(s.volume, volume, 1e-13);
    surface_free(&s);
    made_free(&m);
}

static void near_corners_become_one(void)
{
    made_surface m = {0};
    surface s = {0};
    surface_report r;
    made_ball(&m, 6, made_round);
    unsigned state = 5;
    for (int i = 0; i < 9 * m.n; i++) {
        state = state * 1664525u + 1013904223u;
        (&m.corner[0][0][0])[i] += 2e-9 * ((state >> 8) / 16777216.0 - 0.5);
    }
    CHECK_OK(made_closed(&m, &s, &r));
    CHECK(s.nvertex == 4 * 36 + 2 && s.ntriangle == 8 * 36);
    surface_free(&s);
    // and no farther ones
    m.corner[7][1][0] += 1e-6;
    refuse(&m, "it is not closed: ");
    const surface_options wide = {.path = "wall.stl", .merge = 2e-6};
    CHECK_OK(surface_make(m.n, (const double(*)[3][3])m.corner, &wide, &s, &r));
    CHECK(r.merge == 2e-6);
    surface_free(&s);
    made_free(&m);
}

static void what_is_open_is_refused(void)
{
    made_surface m = {0};
    made_ball(&m, 4, made_round);
    made_take_out(&m, 17);
    refuse(&m, "it is not closed: 3 edges have only one triangle, one at (");
    made_free(&m);
    made_triangle(&m, zero, one, (vec3){{1e-3, 0, 0}});
    refuse(&m, "1 triangles: a closed surface has from 4 to 5000000");
    for (int i = 0; i < 5; i++) {
        made_triangle(&m, zero, one, one);
    }
    refuse(&m, "1 of its 6 triangles have three corners");
    made_free(&m);
    for (int i = 0; i < 5; i++) {
        made_triangle(&m, one, one, one);
    }
    refuse(&m, "all its triangles are at one place");
    made_free(&m);
    made_box(&m, zero, one);
    m.corner[3][1][2] = NAN;
    refuse(&m, "triangle 4 has no finite place within 10 km");
    made_free(&m);
}

static void three_at_an_edge_are_refused(void)
{
    made_surface m = {0};
    // two boxes with one edge in common
    made_box(&m, zero, one);
    made_box(&m, (vec3){{10e-3, 20e-3, 0}}, (vec3){{20e-3, 40e-3, 30e-3}});
    refuse(&m, "1 edges have more than two triangles, one at (10, 20, 15) mm");
    made_free(&m);
    // one corner in common
    made_box(&m, zero, one);
    made_box(&m, one, (vec3){{20e-3, 40e-3, 60e-3}});
    refuse(&m, "sheets touch at 1 vertices, one at (10, 20, 30) mm");
    made_free(&m);
}

static void crossings_are_refused(void)
{
    made_surface m = {0};
    // boxes that cross askew, in line, with faces in one plane; and that touch
    const vec3 low[] = {{{5e-3, 5e-3, 5e-3}},
                        {{5e-3, 0, 0}},
                        {{-5e-3, 5e-3, 5e-3}},
                        {{10e-3, 5e-3, 5e-3}},
                        {{2e-3, 0, 1e-3}}};
    const vec3 high[] = {{{15e-3, 25e-3, 35e-3}},
                         {{15e-3, 20e-3, 30e-3}},
                         {{15e-3, 10e-3, 10e-3}},
                         {{15e-3, 10e-3, 10e-3}},
                         {{3e-3, 1e-3, 2e-3}}};
    for (int i = 0; i < 5; i++) {
        made_box(&m, zero, one);
        made_box(&m, low[i], high[i]);
        refuse(&m, "pairs of its triangles cross or touch, one at (");
        made_free(&m);
    }
}

// a corner pushed through the other side: triangles that share a corner cross others
static void a_surface_pushed_through_itself_is_refused(void)
{
    made_surface m = {0};
    made_ball(&m, 5, made_round);
    for (int i = 0; i < 3 * m.n; i++) {
        double *p = m.corner[i / 3][i % 3];
        if (p[2] == 50e-3) {
            p[2] = -60e-3;
        }
    }
    refuse(&m, "pairs of its triangles cross or touch");
    made_free(&m);
    // within a plane: a box's corner of a cut face moved beyond the face's other edge
    made_box(&m, zero, one);
    const int whole = m.n;
    for (int i = 0; i < whole; i++) {
        double(*c)[3] = m.corner[i];
        if (c[0][2] == 30e-3 && c[1][2] == 30e-3 && c[2][2] == 30e-3) {
            const vec3 a = {{c[0][0], c[0][1], c[0][2]}}, b = {{c[1][0], c[1][1], c[1][2]}},
                       d = {{c[2][0], c[2][1], c[2][2]}}, out = {{-1e-3, -1e-3, 30e-3}};
            made_triangle(&m, a, b, out);
            made_triangle(&m, b, d, out);
            made_triangle(&m, d, a, out);
            made_take_out(&m, i);
            break;
        }
    }
    refuse(&m, "pairs of its triangles cross or touch");
    made_free(&m);
}

static void what_encloses_nothing_is_refused(void)
{
    made_surface m = {0};
    // two sheets of two triangles each, back to back
    const vec3 a = zero, b = {{1e-2, 0, 0}}, c = {{1e-2, 1e-2, 0}}, d = {{0, 1e-2, 0}};
    made_triangle(&m, a, b, c);
    made_triangle(&m, a, c, d);
    made_triangle(&m, a, d, b);
    made_triangle(&m, b, d, c);
    refuse(&m, "a piece encloses nothing");
    made_free(&m);
}

static vec3 made_small(vec3 u)
{
    return vec3_add(vec3_scale(5e-3, u), (vec3){{3e-3, 2e-3, 1e-3}});
}

static vec3 made_tiny(vec3 u)
{
    return vec3_add(vec3_scale(1e-3, u), (vec3){{3e-3, 2e-3, 1e-3}});
}

static vec3 made_aside(vec3 u)
{
    return vec3_add(vec3_scale(5e-3, u), (vec3){{80e-3, 0, 0}});
}

static void islands_are_understood(void)
{
    made_surface m = {0};
    surface s = {0};
    surface_report r;
    double volume[4];
    made_shape *const shapes[] = {made_round, made_small, made_tiny, made_aside};
    for (int i = 0; i < 4; i++) {
        made_ball(&m, 6, shapes[i]);
        CHECK_OK(made_closed(&m, &s, &r));
        volume[i] = s.volume;
        made_free(&m);
        surface_free(&s);
    }
    for (int i = 0; i < 4; i++) {
        made_ball(&m, 6, shapes[i]);
    }
    CHECK_OK(made_closed(&m, &s, &r));
    CHECK(r.parts == 4 && r.inner == 1);
    CHECK_NEAR(s.volume, volume[0] - volume[1] + volume[2] + volume[3], 1e-13);
    check_across(&s);
    surface_free(&s);
    made_free(&m);
}

static void specks_are_refused(void)
{
    made_surface m = {0};
    for (int i = 0; i < 65; i++) {
        made_box(&m, (vec3){{i, 0, 0}}, (vec3){{i + 0.5, 1, 1}});
    }
    refuse(&m, "more than 64 pieces");
    made_free(&m);
}

// a side of the box with a corner on its edge's middle: the triangle there has no area
static void corners_on_one_line_are_joined(void)
{
    made_surface m = {0};
    surface s = {0};
    surface_report r;
    const vec3 a = zero, b = {{1e-2, 0, 0}}, c = {{0, 1e-2, 0}}, top = {{0, 0, 1e-2}};
    const vec3 on[3] = {{{2e-3, 0, 0}}, {{5e-3, 0, 0}}, {{7e-3, 0, 0}}};
    // the base runs over the points on edge a b, the front does not; slivers fill between
    made_triangle(&m, a, c, on[0]);
    made_triangle(&m, on[0], c, on[1]);
    made_triangle(&m, on[1], c, on[2]);
    made_triangle(&m, on[2], c, b);
    made_triangle(&m, a, b, top);
    made_triangle(&m, b, c, top);
    made_triangle(&m, c, a, top);
    made_triangle(&m, a, on[0], on[1]);
    made_triangle(&m, a, on[1], b);
    made_triangle(&m, on[1], on[2], b);
    CHECK_OK(made_closed(&m, &s, &r));
    CHECK(r.flipped >= 3); // a flat one may be met by way of another
    check_across(&s);
    for (int t = 0; t < s.ntriangle; t++) {
        vec3 p[3];
        surface_corners(&s, t, p);
        CHECK(vec3_norm(vec3_cross(vec3_sub(p[1], p[0]), vec3_sub(p[2], p[0]))) > 1e-6);
    }
    CHECK_NEAR(s.volume, 1e-6 / 6, 1e-13);
    surface_free(&s);
    made_free(&m);
}

static void units_off_by_1000_are_noticed(void)
{
    made_surface m = {0};
    surface s = {0};
    surface_report r;
    made_ball(&m, 4, made_round);
    CHECK_OK(made_closed(&m, &s, &r));
    CHECK_OK(surface_check_size(&s, "wall.stl", 0.03));
    CHECK_OK(surface_check_size(&s, "wall.stl", 0.3));
    const double off[] = {30, 300, 30e-6, 300e-6};
    for (int i = 0; i < 4; i++) {
        CHECK(surface_check_size(&s, "wall.stl", off[i]) == ERR_INPUT);
        CHECK(strstr(status_message(), "unit") != NULL);
        status_clear();
    }
    surface_free(&s);
    made_free(&m);
}

int main(void)
{
    a_box_is_measured();
    senses_are_made_alike_and_outward();
    near_corners_become_one();
    what_is_open_is_refused();
    three_at_an_edge_are_refused();
    crossings_are_refused();
    a_surface_pushed_through_itself_is_refused();
    what_encloses_nothing_is_refused();
    islands_are_understood();
    specks_are_refused();
    corners_on_one_line_are_joined();
    units_off_by_1000_are_noticed();
    return test_failures != 0;
}
