// tests/unit/fem/test_plane_symmetry.c
#include "base/memory.h"
#include "fem/plane_symmetry.h"
#include "tests/test.h"

#include <string.h>

static const double PI = 3.14159265358979323846;

// nodes alone: what the elements are does not matter to the search
static void nodes(int n, const double (*x)[2], double angle, const double *shift, mesh *out)
{
    const shape quad = SHAPE_QUAD;
    const int none = 0;
    CHECK_OK(mesh_make(1, n, 1, &quad, &none, out));
    for (int i = 0; i < n; i++) {
        out->xyz[3 * i] = shift[0] + cos(angle) * x[i][0] - sin(angle) * x[i][1];
        out->xyz[3 * i + 1] = shift[1] + sin(angle) * x[i][0] + cos(angle) * x[i][1];
    }
}

static void a_kite_has_one_mirror_line_wherever_it_lies(void)
{
    const double kite[4][2] = {{3, 0}, {0, 1}, {-1, 0}, {0, -1}}, shift[2] = {5, -2};
    for (int k = 0; k < 12; k++) {
        const double turn = 0.1 + 2 * PI * k / 12;
        mesh m = {0};
        plane_symmetry s = {0};
        nodes(4, kite, turn, shift, &m);
        CHECK_OK(plane_symmetry_find(&m, false, &s));
        CHECK(s.partner[MIRROR_A] && !s.partner[MIRROR_B] && !s.partner[HALF_TURN]);
        CHECK_WITHIN(sin(s.angle - turn), 0, 1e-12);
        CHECK(s.partner[MIRROR_A] && s.partner[MIRROR_A][1] == 3 && s.partner[MIRROR_A][0] == 0);
        plane_symmetry_free(&s);
        // its line does not pass through the origin
        CHECK_OK(plane_symmetry_find(&m, true, &s));
        CHECK(!s.partner[MIRROR_A] && !s.partner[MIRROR_B]);
        plane_symmetry_free(&s);
        mesh_free(&m);
    }
}

static void a_rectangle_has_two_and_a_parallelogram_a_half_turn_only(void)
{
    const double rectangle[4][2] = {{2, 1}, {-2, 1}, {-2, -1}, {2, -1}}, none[2] = {0, 0};
    const double slanted[4][2] = {{2, 1}, {-1, 1}, {-2, -1}, {1, -1}};
    mesh m = {0};
    plane_symmetry s = {0};
    nodes(4, rectangle, 0.3, none, &m);
    CHECK_OK(plane_symmetry_find(&m, true, &s));
    CHECK(s.partner[MIRROR_A] && s.partner[MIRROR_B] && s.partner[HALF_TURN]);
    plane_symmetry_free(&s);
    mesh_free(&m);
    nodes(4, slanted, 0.3, none, &m);
    CHECK_OK(plane_symmetry_find(&m, false, &s));
    CHECK(!s.partner[MIRROR_A] && !s.partner[MIRROR_B] && s.partner[HALF_TURN]);
    CHECK(s.partner[HALF_TURN] && s.partner[HALF_TURN][0] == 2 && s.partner[HALF_TURN][3] == 1);
    plane_symmetry_free(&s);
    mesh_free(&m);
}

static void a_node_moved_by_a_millionth_breaks_it(void)
{
    double kite[4][2] = {{3, 0}, {0, 1}, {-1, 0}, {0, -1.000001}}, none[2] = {0, 0};
    mesh m = {0};
    plane_symmetry s = {0};
    nodes(4, (const double(*)[2])kite, 0, none, &m);
    CHECK_OK(plane_symmetry_find(&m, false, &s));
    CHECK(!s.partner[MIRROR_A] && !s.partner[MIRROR_B] && !s.partner[HALF_TURN]);
    plane_symmetry_free(&s);
    mesh_free(&m);
}

int main(void)
{
    a_kite_has_one_mirror_line_wherever_it_lies();
    a_rectangle_has_two_and_a_parallelogram_a_half_turn_only();
    a_node_moved_by_a_millionth_breaks_it();
    return test_failures != 0;
}
