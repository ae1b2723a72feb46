// tests/unit/reports/test_segment_skin.c
#include "reports/segment_skin.h"
#include "tests/test.h"
#include "tests/unit/reports/synthetic.h"

#include <math.h>

// polygons with some 44 sides: area and volume fall short by (2 pi / 44)^2 / 6
static const double polygon_error = 5e-3;

// by the divergence theorem; each triangle seen from outside goes counter-clockwise, so the sign
// tells too
static double volume_of(const segment_skin *k, double factor)
{
    double sum = 0;
    for (int i = 0; i < k->ntriangle; i++) {
        double p[3][3];
        for (int c = 0; c < 3; c++) {
            for (int d = 0; d < 3; d++) {
                const int v = k->triangle[i][c];
                p[c][d] = k->at[v][d] + factor * k->move[v][d];
            }
        }
        sum += (p[0][0] * (p[1][1] * p[2][2] - p[1][2] * p[2][1]) -
                p[0][1] * (p[1][0] * p[2][2] - p[1][2] * p[2][0]) +
                p[0][2] * (p[1][0] * p[2][1] - p[1][1] * p[2][0])) /
               6;
    }
    return sum;
}

static double area_of(const segment_skin *k)
{
    double sum = 0;
    for (int i = 0; i < k->ntriangle; i++) {
        const double *a = k->at[k->triangle[i][0]];
        vec3 u, v;
        for (int d = 0; d < 3; d++) {
            u.a[d] = k->at[k->triangle[i][1]][d] - a[d];
            v.a[d] = k->at[k->triangle[i][2]][d] - a[d];
        }
        sum += vec3_norm(vec3_cross(u, v)) / 2;
    }
    return sum;
}

static void the_skin_is_the_tube_s(void)
{
    run_result r = {0};
    segment_skin k = {0};
    CHECK_OK(synthetic_make(1, 0, 0.5, &r));
    const double length = r.segment_length, ends = 2 * pi * (16 - 10.24) * 1e-6;
    CHECK_OK(segment_skin_make(&r.segment.body, &r.segment.load[0], &k));
    CHECK_NEAR(area_of(&k), ends + 2 * pi * 7.2e-3 * length, polygon_error);
    CHECK_NEAR(fabs(volume_of(&k, 0)), pi * (16 - 10.24) * 1e-6 * length, 3 * polygon_error);
    for (int v = 0; v < k.nvertex; v++) {
        const double size = sqrt(k.move[v][0] * k.move[v][0] + k.move[v][1] * k.move[v][1] +
                                 k.move[v][2] * k.move[v][2]);
        CHECK(fabs(k.value[v] - size) <= 1e-9 * size + 1e-15);
        CHECK(k.material[v] < 2);
    }
    segment_skin_free(&k);
    synthetic_free(&r);
}

static void loads_share_corners_and_triangles(void)
{
    run_result r = {0};
    segment_skin a = {0}, b = {0};
    CHECK_OK(synthetic_make(1, 0, 0.5, &r));
    CHECK(r.segment.nload > 1);
    CHECK_OK(segment_skin_make(&r.segment.body, &r.segment.load[0], &a));
    CHECK_OK(segment_skin_make(&r.segment.body, &r.segment.load[1], &b));
    CHECK(a.nvertex == b.nvertex && a.ntriangle == b.ntriangle);
    CHECK(memcmp(a.at, b.at, (size_t)a.nvertex * sizeof *a.at) == 0);
    CHECK(memcmp(a.triangle, b.triangle, (size_t)a.ntriangle * sizeof *a.triangle) == 0);
    segment_skin_free(&a);
    segment_skin_free(&b);
    synthetic_free(&r);
}

static void what_is_not_all_here_is_refused(void)
{
    run_result r = {0};
    segment_skin k = {0};
    CHECK_OK(synthetic_make(1, 0, 0.5, &r));
    segment_load_result load = r.segment.load[0];
    load.displacement = NULL;
    CHECK(segment_skin_make(&r.segment.body, &load, &k) == ERR_BUG);
    segment_body body = r.segment.body;
    body.last = body.nlevel - 1;
    CHECK(segment_skin_make(&body, &r.segment.load[0], &k) == ERR_BUG);
    CHECK(k.at == NULL);
    synthetic_free(&r);
}

int main(void)
{
    the_skin_is_the_tube_s();
    loads_share_corners_and_triangles();
    what_is_not_all_here_is_refused();
    return test_failures != 0;
}
