// tests/unit/reach/test_clearance.c
#include "reach/clearance.h"

#include "tests/surfaces.h"
#include "tests/test.h"

enum { SAMPLES = 10000 };

static const double tolerance = 1e-6;

// x = s, y = lift + rise sin(waves s): |dp/ds| <= sqrt(1 + (rise waves)^2)
typedef struct wave {
    double lift, rise, waves;
} wave;

static vec3 wave_at(const void *context, double s)
{
    const wave *w = context;
    return (vec3){{s, w->lift + w->rise * sin(w->waves * s), 2e-3}};
}

static body_curve wave_body(const wave *w, double begin, double end)
{
    return (body_curve){.at = wave_at,
                        .context = w,
                        .begin = begin,
                        .end = end,
                        .stretch = sqrt(1 + w->rise * w->waves * w->rise * w->waves)};
}

typedef struct scene {
    surface s;
    distance_tree *tree;
} scene;

static void scene_make(made_surface *m, scene *out)
{
    surface_report r;
    *out = (scene){.tree = NULL};
    CHECK_OK(made_closed(m, &out->s, &r));
    CHECK_OK(distance_tree_make(&out->s, &out->tree));
    made_free(m);
}

static void scene_free(scene *c)
{
    distance_tree_free(c->tree);
    surface_free(&c->s);
}

static clearance along(const distance_tree *t, const body_curve *b, double radius, double within)
{
    clearance out;
    clearance_until(t, b, radius, &(clearance_wish){within, -INFINITY, b->begin, 0}, &out);
    return out;
}

// whether the clearance is nowhere below `least`, no more than that
static bool is_free(const distance_tree *t, const body_curve *b, double radius, double least,
                    double within, clearance *at)
{
    clearance_until(t, b, radius, &(clearance_wish){within, least, b->begin, 0}, at);
    return at->bound >= least;
}

static double least_of_samples(const distance_tree *t, const body_curve *b, double radius)
{
    double least = INFINITY;
    for (int i = 0; i <= SAMPLES; i++) {
        const vec3 p = b->at(b->context, b->begin + (b->end - b->begin) * i / SAMPLES);
        least = fmin(least, distance_to(t, p).distance - radius);
    }
    return least;
}

static void check_body(const scene *c, const body_curve *b, double radius)
{
    clearance got, free_at;
    got = along(c->tree, b, radius, tolerance);
    const double sampled = least_of_samples(c->tree, b, radius);
    // no sample is below the bound, and the place found is as near as any sample
    CHECK(got.bound <= sampled + 1e-15 && got.least <= sampled + tolerance);
    CHECK(got.bound <= got.least && got.bound >= got.least - tolerance * (1 + 1e-9));
    // what is told about the place is so
    CHECK(got.s >= b->begin && got.s <= b->end);
    const nearest_point wall = distance_to(c->tree, b->at(b->context, got.s));
    CHECK_WITHIN(got.least, wall.distance - radius, 1e-15);
    CHECK_WITHIN(vec3_norm(vec3_sub(got.wall.p, got.point)), fabs(got.least + radius), 1e-15);
    CHECK_WITHIN(got.wall.distance, got.least + radius, 1e-15);

    CHECK(is_free(c->tree, b, radius, got.least - 3 * tolerance, tolerance, &free_at));
    CHECK(free_at.bound >= got.least - 3 * tolerance);
    CHECK(free_at.queries <= got.queries);
    CHECK(!is_free(c->tree, b, radius, got.least + 1e-12, tolerance, &free_at));
}

static void waves_among_hills_are_measured(void)
{
    made_surface m = {0};
    scene c;
    made_ball(&m, 20, made_bumpy);
    scene_make(&m, &c);
    unsigned state = 3;
    for (int i = 0; i < 20; i++) {
        double x[3];
        for (int d = 0; d < 3; d++) {
            state = state * 1664525u + 1013904223u;
            x[d] = (state >> 8) / 16777216.0;
        }
        const wave w = {.lift = 20e-3 * (x[0] - 0.5), .rise = 8e-3 * x[1], .waves = 300 * x[2]};
        const body_curve b = wave_body(&w, -20e-3, i % 2 ? 22e-3 : 60e-3);
        check_body(&c, &b, 1e-3 + 2e-3 * x[0]);
    }
    scene_free(&c);
}

// A needle of 0.2 mm that stands up between samples 0.5 mm apart is found.
static void nothing_slips_between_samples(void)
{
    made_surface m = {0};
    scene c;
    made_box(&m, (vec3){{-50e-3, -10e-3, -10e-3}}, (vec3){{50e-3, 10e-3, 10e-3}});
    const vec3 a = {{12.2e-3, -9.9e-3, 2e-3}}, b = {{12.4e-3, -9.9e-3, 1.9e-3}};
    const vec3 d = {{12.4e-3, -9.9e-3, 2.1e-3}}, top = {{12.3e-3, -1.5e-3, 2e-3}};
    made_triangle(&m, a, b, top);
    made_triangle(&m, b, d, top);
    made_triangle(&m, d, a, top);
    made_triangle(&m, a, d, b);
    scene_make(&m, &c);
    const wave straight = {0};
    const body_curve body = wave_body(&straight, -40e-3, 40e-3);
    clearance got;
    got = along(c.tree, &body, 1e-3, tolerance);
    CHECK_WITHIN(got.least, 0.5e-3, tolerance);
    CHECK_WITHIN(got.s, 12.3e-3, sqrt(2 * 1.5e-3 * tolerance));
    CHECK_WITHIN(got.wall.p.a[1], -1.5e-3, 1e-12);
    // through the needle: an island
    const wave low = {.lift = -5e-3};
    const body_curve through = wave_body(&low, -40e-3, 40e-3);
    CHECK(!is_free(c.tree, &through, 1e-3, 0, tolerance, &got));
    CHECK(got.least < 0 && got.s > 11e-3 && got.s < 13.5e-3);
    scene_free(&c);
}

// a sphere, inside of which the clearance is known
static void a_line_in_a_box_is_exact_and_cheap(void)
{
    made_surface m = {0};
    scene c;
    made_box(&m, (vec3){{-50e-3, -10e-3, -10e-3}}, (vec3){{50e-3, 10e-3, 10e-3}});
    scene_make(&m, &c);
    const wave straight = {.lift = 1e-3};
    body_curve body = wave_body(&straight, -30e-3, 49e-3);
    clearance got;
    got = along(c.tree, &body, 0.5e-3, 1e-5);
    CHECK_WITHIN(got.least, 0.5e-3, 1e-15);
    CHECK_WITHIN(got.s, 49e-3, 1e-15);
    CHECK(got.queries < 40);
    CHECK(is_free(c.tree, &body, 0.5e-3, 0, 1e-5, &got));
    // out through the end: the first place too near is told, soon
    body.end = 90e-3;
    CHECK(!is_free(c.tree, &body, 0.5e-3, 0, 1e-5, &got));
    CHECK(got.least < 0 && got.queries <= 2);
    // a point
    body.end = body.begin = 0;
    got = along(c.tree, &body, 0.5e-3, 1e-5);
    CHECK_WITHIN(got.least, 7.5e-3, 1e-15);
    CHECK(is_free(c.tree, &body, 0.5e-3, 7e-3, 1e-5, &got));
    scene_free(&c);
}

static vec3 nowhere(const void *none, double s)
{
    (void)none;
    return (vec3){{s, s > 0.3 ? NAN : 0, 0}};
}

static void what_is_not_finite_is_not_free(void)
{
    made_surface m = {0};
    scene c;
    made_ball(&m, 5, made_round);
    scene_make(&m, &c);
    const body_curve body = {.at = nowhere, .begin = 0, .end = 1, .stretch = 1};
    clearance got;
    CHECK(!is_free(c.tree, &body, 1e-3, 0, 1e-4, &got));
    got = along(c.tree, &body, 1e-3, 1e-4);
    CHECK(!(got.least >= 0));
    scene_free(&c);
}

int main(void)
{
    waves_among_hills_are_measured();
    nothing_slips_between_samples();
    a_line_in_a_box_is_exact_and_cheap();
    what_is_not_finite_is_not_free();
    return test_failures != 0;
}
