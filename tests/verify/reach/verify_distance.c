// tests/verify/reach/verify_distance.c
// Signed distances against all triangles one by one, and sides against counts of what a ray meets
// and the winding number: neither uses a normal.
#include "reach/distance.h"

#include "base/se3.h"

#include "tests/surfaces.h"
#include "tests/test.h"

// of the first scene; half as many of the others
enum { POINTS = 100000, POINTS_OF_A_CHECK = 14000 };

static const double WANTED = 1e-9; // [m]

static unsigned long long random_state = 88172645463325252u;

static double draw(void)
{
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return (double)(random_state >> 11) / 9007199254740992.0;
}

static vec3 draw_within(double half)
{
    return (vec3){{half * (2 * draw() - 1), half * (2 * draw() - 1), half * (2 * draw() - 1)}};
}

// a triangle, prepared: its frame and its edges
typedef struct flat {
    vec3 a, u, v, n;
    double length, x, y; // corners (0, 0), (length, 0), (x, y) in the frame u, v about a
} flat;

static flat flat_of(const vec3 c[3])
{
    flat f = {.a = c[0]};
    const vec3 e = vec3_sub(c[1], c[0]), g = vec3_sub(c[2], c[0]);
    f.length = vec3_norm(e);
    f.u = vec3_scale(1 / f.length, e);
    f.n = vec3_cross(e, g);
    f.n = vec3_scale(1 / vec3_norm(f.n), f.n);
    f.v = vec3_cross(f.n, f.u);
    f.x = vec3_dot(g, f.u);
    f.y = vec3_dot(g, f.v);
    return f;
}

// squared distance in the plane to the segment from (ax, ay) to (bx, by)
static double to_segment(double ax, double ay, double bx, double by, double x, double y)
{
    const double ex = bx - ax, ey = by - ay;
    const double t = ((x - ax) * ex + (y - ay) * ey) / (ex * ex + ey * ey);
    const double c = t < 0 ? 0 : t > 1 ? 1 : t, dx = x - ax - c * ex, dy = y - ay - c * ey;
    return dx * dx + dy * dy;
}

static double square_to(const flat *f, vec3 p)
{
    const vec3 to = vec3_sub(p, f->a);
    const double x = vec3_dot(to, f->u), y = vec3_dot(to, f->v), z = vec3_dot(to, f->n);
    double off = 0;
    if (y < 0 || x * f->y < y * f->x || (x - f->length) * f->y > y * (f->x - f->length)) {
        off = fmin(
            to_segment(0, 0, f->length, 0, x, y),
            fmin(to_segment(0, 0, f->x, f->y, x, y), to_segment(f->length, 0, f->x, f->y, x, y)));
    }
    return z * z + off;
}

// whether the ray from p along +z meets the triangle
static bool ray_meets(const vec3 c[3], vec3 p)
{
    bool in = false;
    double z = 0;
    for (int k = 0, j = 2; k < 3; j = k++) {
        const double *a = c[k].a, *b = c[j].a;
        if ((a[1] > p.a[1]) != (b[1] > p.a[1])) {
            in ^= p.a[0] < (b[0] - a[0]) * (p.a[1] - a[1]) / (b[1] - a[1]) + a[0];
        }
    }
    if (in) {
        const vec3 n = vec3_cross(vec3_sub(c[1], c[0]), vec3_sub(c[2], c[0]));
        const vec3 to = vec3_sub(p, c[0]);
        z = c[0].a[2] - (to.a[0] * n.a[0] + to.a[1] * n.a[1]) / n.a[2];
    }
    return in && z > p.a[2];
}

static double solid_angle(const vec3 corner[3], vec3 p)
{
    const vec3 a = vec3_sub(corner[0], p), b = vec3_sub(corner[1], p), c = vec3_sub(corner[2], p);
    const double la = vec3_norm(a), lb = vec3_norm(b), lc = vec3_norm(c);
    return 2 * atan2(vec3_dot(a, vec3_cross(b, c)), la * lb * lc + vec3_dot(a, b) * lc +
                                                        vec3_dot(b, c) * la + vec3_dot(c, a) * lb);
}

typedef struct scene {
    const char *name;
    surface s;
    distance_tree *tree;
    flat *flats;
    vec3 (*turned)[3]; // the corners, turned so that the ray goes askew
    mat3 turn;
} scene;

static void scene_make(const char *name, made_surface *m, scene *out)
{
    surface_report r;
    *out = (scene){.name = name, .turn = so3_exp((vec3){{0.3, -0.8, 0.55}})};
    CHECK_OK(made_closed(m, &out->s, &r));
    CHECK_OK(distance_tree_make(&out->s, &out->tree));
    out->flats = calloc((size_t)out->s.ntriangle, sizeof *out->flats);
    out->turned = calloc((size_t)out->s.ntriangle, sizeof *out->turned);
    for (int t = 0; t < out->s.ntriangle; t++) {
        vec3 c[3];
        surface_corners(&out->s, t, c);
        out->flats[t] = flat_of(c);
        for (int k = 0; k < 3; k++) {
            out->turned[t][k] = mat3_mul_vec(out->turn, c[k]);
        }
    }
    made_free(m);
}

static void scene_free(scene *c)
{
    distance_tree_free(c->tree);
    surface_free(&c->s);
    free(c->flats);
    free(c->turned);
}

// anywhere about it; near faces, edges and corners at 1 mm to 1 pm; far away
static vec3 draw_point(const scene *c, int i)
{
    if (i % 4 == 0) {
        return draw_within(i % 40 == 0 ? 10 : 90e-3);
    }
    vec3 p[3];
    const int t = (int)(draw() * c->s.ntriangle);
    surface_corners(&c->s, t, p);
    const double weight[3] = {draw(), i % 4 < 3 ? draw() : 0, i % 4 < 2 ? draw() : 0};
    const double sum = weight[0] + weight[1] + weight[2];
    vec3 on = {{0}};
    for (int k = 0; k < 3; k++) {
        on = vec3_add_scaled(on, weight[k] / sum, p[k]);
    }
    return vec3_add(on, draw_within(pow(10, -3 - 9 * draw())));
}

static double brute_force(const scene *c, vec3 p)
{
    double least = INFINITY;
    for (int t = 0; t < c->s.ntriangle; t++) {
        least = fmin(least, square_to(&c->flats[t], p));
    }
    const vec3 q = mat3_mul_vec(c->turn, p);
    bool inside = false;
    for (int t = 0; t < c->s.ntriangle; t++) {
        inside ^= ray_meets(c->turned[t], q);
    }
    return inside ? sqrt(least) : -sqrt(least);
}

static double winding(const scene *c, vec3 p)
{
    double angle = 0;
    for (int t = 0; t < c->s.ntriangle; t++) {
        vec3 corner[3];
        surface_corners(&c->s, t, corner);
        angle += solid_angle(corner, p);
    }
    return angle / (4 * acos(-1));
}

// what is known without a search must not exclude what is so
static bool is_between(distance_range known, double d)
{
    return known.low <= d + WANTED && d <= known.high + WANTED && fabs(d) <= known.reach + WANTED;
}

static void compare(const scene *c, int n)
{
    double worst = 0, worst_place = 0;
    int wound = 0, excluded = 0, within = 0;
    for (int i = 0; i < n; i++) {
        const vec3 p = draw_point(c, i);
        const nearest_point got = distance_to(c->tree, p);
        worst = fmax(worst, fabs(got.distance - brute_force(c, p)));
        worst_place = fmax(worst_place, fabs(vec3_norm(vec3_sub(got.p, p)) - fabs(got.distance)));
        if (i % 50 == 0 && fabs(got.distance) > WANTED) {
            wound += fabs(winding(c, p) - (got.distance > 0 ? 1 : 0)) > 1e-6;
        }
        const double d = got.distance;
        excluded += !is_between(distance_between(c->tree, p), d) ||
                    !is_between(distance_between_closely(c->tree, p), d);
        within += distance_within(c->tree, p, fabs(d)).distance != d ||
                  distance_within(c->tree, p, fabs(d) * 0.999 - 1e-15).triangle >= 0;
    }
    printf("%-24s %6d triangles, %6d points: worst difference %.1e m\n", c->name, c->s.ntriangle, n,
           worst);
    CHECK_WITHIN(worst, 0, WANTED);
    CHECK_WITHIN(worst_place, 0, 1e-15 + 1e-15);
    CHECK(wound == 0);
    CHECK(excluded == 0);
    CHECK(within == 0);
}

// spikes 30 mm long and 0.1 mm wide, some outward and some inward
static vec3 made_spiked(vec3 u)
{
    const double top = fmax(fabs(u.a[0]), fmax(fabs(u.a[1]), fabs(u.a[2])));
    const double r = u.a[0] == 1 || u.a[1] == 1     ? 70e-3
                     : u.a[2] == -1 || u.a[0] == -1 ? 5e-3
                                                    : 40e-3 + 1e-3 * top;
    return vec3_scale(r, u);
}

static vec3 made_island(vec3 u)
{
    return vec3_add(vec3_scale(8e-3, u), (vec3){{12e-3, 11e-3, 13e-3}});
}

// thin: 0.1 um between its faces
static vec3 made_plate(vec3 u)
{
    const double top = fmax(fabs(u.a[0]), fabs(u.a[1]));
    return (vec3){{40e-3 * u.a[0], 30e-3 * u.a[1], 0.1e-6 * u.a[2] * (1 + top)}};
}

int main(void)
{
    against(BY_SECOND_WAY, "all triangles one by one, winding numbers");
    const int points = test_is_long() ? POINTS : POINTS_OF_A_CHECK;
    made_surface m = {0};
    scene c;
    made_ball(&m, 18, made_bumpy);
    scene_make("hills and hollows", &m, &c);
    compare(&c, points);
    scene_free(&c);
    made_ball(&m, 12, made_spiked);
    made_ball(&m, 3, made_island);
    scene_make("spikes and an island", &m, &c);
    compare(&c, points / 2);
    scene_free(&c);
    made_ball(&m, 6, made_plate);
    scene_make("a thin plate", &m, &c);
    compare(&c, points / 2);
    scene_free(&c);
    made_box(&m, (vec3){{0, 0, 0}}, (vec3){{30e-3, 20e-3, 50e-3}});
    scene_make("a box", &m, &c);
    compare(&c, points / 2);
    scene_free(&c);
    return test_failures != 0;
}
