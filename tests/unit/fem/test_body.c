// Bodies: levels, poses, shares of levels, and what is refused.
#include "tests/unit/fem/brick_cases.h"

static const double layers[4] = {1e-3, 2e-3, 4e-3, 4.5e-3};

static body_spec plain_spec(const mesh *plane, const material *materials)
{
    return (body_spec){
        .plane = plane, .materials = materials, .order = 3, .nlayer = 3, .layer = layers};
}

static void levels_are_lobatto_points(void)
{
    mesh m = {0};
    body b = {0};
    const material rubber = {.E = 1e6, .nu = 0.3};
    one_element(SHAPE_QUAD, 2, true, &m);
    const body_spec spec = plain_spec(&m, &rubber);
    CHECK_OK(body_make(&spec, &b));
    CHECK(b.nlevel == 10 && b.prism && !b.node && b.first == 0 && b.last == 10);
    CHECK_NEAR(b.length, 3.5e-3, 1e-15);
    for (int k = 0; k < 3; k++) {
        CHECK(b.level[3 * k] == layers[k]);
        const double h = layers[k + 1] - layers[k];
        CHECK_NEAR(b.level[3 * k + 1], layers[k] + h * (1 - sqrt(0.2)) / 2, 1e-15);
    }
    CHECK(b.level[9] == layers[3]);
    double x[3], origin[3];
    mat3 axes;
    body_node(&b, 3, 4, x);
    CHECK(x[0] == m.xyz[9] && x[1] == m.xyz[10] && x[2] == b.level[4]);
    body_pose_at(&b, 1, -1, &axes, origin);
    CHECK_NEAR(origin[2], 2e-3, 1e-14);
    CHECK(axes.a[0][0] == 1 && axes.a[0][1] == 0);
    body_free(&b);
    mesh_free(&m);
}

static void poses_between_levels_are_rotations(void)
{
    mesh m = {0};
    body b = {0};
    const material rubber = {.E = 1e6, .nu = 0.3};
    one_element(SHAPE_TRIANGLE, 2, false, &m);
    body_spec spec = plain_spec(&m, &rubber);
    spec.order = 4;
    spec.turn_rate = 200;
    CHECK_OK(body_make(&spec, &b));
    CHECK(!b.prism && b.node);
    for (int k = 0; k < 5; k++) {
        mat3 axes;
        double origin[3];
        const double at = -0.9 + 0.4 * k, s = 2e-3 + 1e-3 * (at + 1);
        body_pose_at(&b, 1, at, &axes, origin);
        const mat3 wanted = mat3_rot_z(200 * s), square = mat3_mul(mat3_transpose(axes), axes);
        for (int i = 0; i < 9; i++) {
            CHECK_WITHIN(square.a[i / 3][i % 3], i % 4 == 0, 1e-14);
            // a polynomial of order 4 through a turn of 0.4
            CHECK_WITHIN(axes.a[i / 3][i % 3], wanted.a[i / 3][i % 3], 2e-6);
        }
        CHECK_NEAR(origin[2], s, 1e-14);
    }
    body_free(&b);
    mesh_free(&m);
}

static void a_share_is_the_whole_s_part(void)
{
    mesh m = {0};
    body whole = {0}, kept = {0}, part = {0};
    const material rubber = {.E = 1e6, .nu = 0.3};
    one_element(SHAPE_QUAD, 3, false, &m);
    bar how = {.plane = &m, .twist = 200, .taper = 30, .bend = 40};
    body_spec spec = plain_spec(&m, &rubber);
    spec.shape = (body_shape){.self = &how, .place = bar_place};
    CHECK_OK(body_make(&spec, &whole));
    CHECK_OK(body_make(&spec, &kept));
    CHECK_OK(body_hold(&kept, 3, 7));
    spec.hold_first = 3;
    spec.hold_last = 7;
    CHECK_OK(body_make(&spec, &part));
    CHECK(kept.first == 3 && part.first == 3 && kept.last == 7 && part.last == 7);
    for (int level = 3; level < 7; level++) {
        for (int i = 0; i < m.nnode; i++) {
            double x[3], y[3], z[3];
            body_node(&whole, i, level, x);
            body_node(&kept, i, level, y);
            body_node(&part, i, level, z);
            CHECK(memcmp(x, y, sizeof x) == 0 && memcmp(x, z, sizeof x) == 0);
        }
        const mat3 a = body_axes(&whole, level), b = body_axes(&kept, level);
        CHECK(memcmp(&a, &b, sizeof a) == 0);
    }
    CHECK(body_hold(&kept, 2, 6) == ERR_BUG);
    status_clear();
    body_free(&whole);
    body_free(&kept);
    body_free(&part);
    mesh_free(&m);
}

static status folding(const void *self, double s, double *xyz, mat3 *axes, double origin[3])
{
    // sections that tilt so fast that their inner sides run backwards
    const bar *b = (const bar *)self;
    const bar tight = {.plane = b->plane, .bend = 2000};
    return bar_place(&tight, s, xyz, axes, origin);
}

static void bad_layers_are_refused(void)
{
    mesh m = {0};
    body b = {0};
    const material rubber = {.E = 1e6, .nu = 0.3};
    const double flat[4] = {0, 1e-3, 1e-3, 2e-3}, mad[4] = {0, NAN, 1e-3, 2e-3};
    one_element(SHAPE_QUAD, 1, false, &m);
    body_spec spec = plain_spec(&m, &rubber);
    spec.layer = flat;
    CHECK(body_make(&spec, &b) == ERR_INPUT);
    status_clear();
    spec.layer = mad;
    CHECK(body_make(&spec, &b) == ERR_INPUT);
    status_clear();
    spec.layer = layers;
    spec.nlayer = 0;
    CHECK(body_make(&spec, &b) == ERR_INPUT);
    status_clear();
    spec.nlayer = 3;
    bar how = {.plane = &m};
    spec.shape = (body_shape){.self = &how, .place = folding};
    CHECK(body_make(&spec, &b) == ERR_INPUT);
    status_clear();
    spec.plane = NULL;
    CHECK(body_make(&spec, &b) == ERR_BUG);
    status_clear();
    body_free(&b);
    mesh_free(&m);
}

int main(void)
{
    levels_are_lobatto_points();
    poses_between_levels_are_rotations();
    a_share_is_the_whole_s_part();
    bad_layers_are_refused();
    return test_failures != 0;
}
