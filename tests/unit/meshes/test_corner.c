// tests/unit/meshes/test_corner.c
#include "meshes/corner.h"
#include "meshes/ladder.h"
#include "tests/shapes.h"
#include "tests/test.h"

static corner look(int n, const shape_spec *s, double x, double y)
{
    section_outline o = {0};
    CHECK_OK(shapes_at((shape_list){.count = n, .items = s}, 0, &o));
    const corner c = corner_at(&o, x, y, 1e-4);
    section_outline_free(&o);
    return c;
}

static void corners_are_told_by_what_surrounds_them(void)
{
    const shape_spec plate[] = {a_rectangle(4, 2, 0, 0, 0, 0), a_rectangle(2, 2, 0, 1, 0, 1)};
    CHECK(look(1, plate, 1, 0.5) == CORNER_NONE);
    CHECK(look(1, plate, 2, 0.5) == CORNER_NONE);
    CHECK(look(1, plate, 2, 1) == CORNER_WEAK);
    CHECK(look(2, plate, 0, 0.5) == CORNER_NONE); // on a straight interface
    CHECK(look(2, plate, 0, 1) == CORNER_WEAK);   // where it ends

    const shape_spec angle[] = {a_rectangle(4, 4, 0.2, 0, 0, 0), a_rectangle(4, 4, 0.2, 2, 2, -1)};
    section_outline o = {0};
    CHECK_OK(shapes_at((shape_list){.count = 2, .items = angle}, 0, &o));
    double corners[4][2];
    rectangle_corners(&o.items[1], corners);
    CHECK(corner_at(&o, corners[0][0], corners[0][1], 1e-4) == CORNER_STRONG); // points inwards
    section_outline_free(&o);

    const shape_spec inlay[] = {a_disc(3, 0, 0, 0), a_rectangle(1, 1, 0, 0, 0, 1)};
    CHECK(look(2, inlay, 0.5, 0.5) == CORNER_STRONG);
    CHECK(look(2, inlay, 0.5, 0.2) == CORNER_NONE);
    CHECK(look(2, inlay, 3, 0) == CORNER_NONE); // the circle's edge is straight from near
    const shape_spec cross[] = {a_rectangle(2, 2, 0, 0, 0, 0), a_rectangle(1, 1, 0, 0.5, 0.5, 1),
                                a_rectangle(1, 1, 0, -0.5, -0.5, 1)};
    CHECK(look(3, cross, 0, 0) == CORNER_STRONG);
    // the same material again makes no corner
    const shape_spec same[] = {a_disc(3, 0, 0, 1), a_rectangle(1, 1, 0, 0, 0, 1)};
    CHECK(look(2, same, 0.5, 0.5) == CORNER_NONE);
}

static void edges_grow_away_from_the_finest(void)
{
    const double at[] = {0, 1, 10}, finest[] = {0, 0.01, 0.2};
    ladder l = {0};
    CHECK_OK(ladder_make(2, at, finest, &(ladder_steps){2, 5, 1}, &l));
    CHECK(l.edge[0] == 0 && l.edge[l.n] == 10);
    int at_break = 0;
    for (int i = 0; i < l.n; i++) {
        const double h = l.edge[i + 1] - l.edge[i];
        CHECK(h > 0 && h <= 2 * (1 + 1e-12));
        CHECK(l.cell[i] == (l.edge[i] >= 1));
        at_break = l.edge[i] == 1 ? i : at_break;
        if (i > 0) {
            // neighbours differ by the growth, and a little where layers meet the middle
            const double before = l.edge[i] - l.edge[i - 1];
            CHECK(h / before < 7 && before / h < 7);
        }
    }
    CHECK_NEAR(l.edge[at_break + 1] - 1, 0.01, 1e-12);
    CHECK_NEAR(1 - l.edge[at_break - 1], 0.01, 1e-12);
    CHECK_NEAR(10 - l.edge[l.n - 1], 0.2, 1e-12);
    ladder_free(&l);
    // nothing asked for: equal parts
    const double none[] = {0, 0, 0};
    CHECK_OK(ladder_make(2, at, none, &(ladder_steps){3, 5, 1}, &l));
    CHECK(l.n == 4 && l.edge[1] == 1 && l.edge[2] == 4 && l.edge[3] == 7);
    ladder_free(&l);
}

int main(void)
{
    corners_are_told_by_what_surrounds_them();
    edges_grow_away_from_the_finest();
    return test_failures != 0;
}
