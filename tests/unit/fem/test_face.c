// Faces: holes by their size, closed surfaces, pressures and springs on parts of walls and on ends.
#include "fem/face.h"
#include "tests/grid_mesh.h"

enum { NX = 8, NY = 6 };

// two holes, the larger of three cells, and a hole that touches the larger one at a corner
static const char cells[] = "00000000"
                            "0  0 000"
                            "0 000000"
                            "00000000"
                            "00000 00"
                            "00000000";
static const char touching[] = "00000000"
                               "0  00000"
                               "000 0000"
                               "00000000"
                               "00000000"
                               "00000000";
static const double layers[4] = {0, 1e-3, 2.5e-3, 4e-3};
static const material rubber = {.E = 1e6, .nu = 0.3};

// cells of 1 mm, or the whole bent a little
static void square(const double *from, double *to)
{
    to[0] = 1e-3 * NX * from[0];
    to[1] = 1e-3 * NY * from[1];
}

static void bent(const double *from, double *to)
{
    square(from, to);
    const double x = to[0], y = to[1];
    to[0] += 0.2e-3 * sin(700 * y);
    to[1] += 0.15e-3 * sin(600 * x);
}

typedef struct model {
    mesh plane;
    body body;
} model;

static status turning(const void *self, double s, double *xyz, mat3 *axes, double origin[3])
{
    const mesh *plane = (const mesh *)self;
    *axes = mat3_rot_z(150 * s);
    memcpy(origin, (const double[3]){0, 0, s}, 3 * sizeof *origin);
    for (int i = 0; i < plane->nnode; i++) {
        const double *from = plane->xyz + 3 * (size_t)i;
        const vec3 x = mat3_mul_vec(*axes, vec3_scale(1 + 40 * s, (vec3){{from[0], from[1], 0}}));
        memcpy(xyz + 3 * i, x.a, sizeof x.a);
        xyz[3 * i + 2] += s;
    }
    return OK;
}

static void make(int order, bool triangles, const char *what, void (*map)(const double *, double *),
                 bool mapped, model *m)
{
    const grid g = {NX, NY, order, triangles, what, map};
    *m = (model){0};
    grid_make(&g, &m->plane);
    body_spec spec = {
        .plane = &m->plane, .materials = &rubber, .order = order, .nlayer = 3, .layer = layers};
    if (mapped) {
        spec.shape = (body_shape){.self = &m->plane, .place = turning};
    }
    CHECK_OK(body_make(&spec, &m->body));
}

static void drop(model *m)
{
    body_free(&m->body);
    mesh_free(&m->plane);
}

// area, int normal dA and int x . normal dA of a face part
typedef struct surface {
    const body *body;
    double area, normal[3], volume;
} surface;

static status measure(void *self, const face_patch *p)
{
    surface *s = (surface *)self;
    for (int q = 0; q < p->npoint; q++) {
        s->area += p->dA[q];
        for (int i = 0; i < p->nnode; i++) {
            double x[3];
            body_node(s->body, p->plane_node[i], p->level[i], x);
            for (int d = 0; d < 3; d++) {
                s->volume += p->dA[q] * p->N[q][i] * x[d] * p->normal[q][d] / 3;
                s->normal[d] += p->dA[q] * p->N[q][i] * p->normal[q][d];
            }
        }
    }
    return OK;
}

static surface surface_of(const body *b, int face, double from, double to)
{
    surface s = {.body = b};
    const face_part part = {face, from, to};
    CHECK_OK(face_walk(b, &part, 0, b->nlayer, measure, &s));
    return s;
}

static void holes_are_numbered_by_size(void)
{
    for (int k = 0; k < 2; k++) {
        model m;
        make(2, k == 1, cells, square, false, &m);
        const double mm2 = 1e-6, up = 4;
        CHECK_NEAR(surface_of(&m.body, FACE_OUTSIDE, 0, INFINITY).area, 28 * up * mm2, 1e-12);
        CHECK_NEAR(surface_of(&m.body, FACE_INSIDE, 0, INFINITY).area, 16 * up * mm2, 1e-12);
        CHECK_NEAR(surface_of(&m.body, FACE_HOLE, 0, INFINITY).area, 8 * up * mm2, 1e-12);
        CHECK_NEAR(surface_of(&m.body, FACE_HOLE + 1, 0, INFINITY).area, 4 * up * mm2, 1e-12);
        CHECK_NEAR(surface_of(&m.body, FACE_HOLE + 2, 0, INFINITY).area, 4 * up * mm2, 1e-12);
        CHECK_NEAR(surface_of(&m.body, FACE_TIP, 0, INFINITY).area, 43 * mm2, 1e-12);
        CHECK_NEAR(surface_of(&m.body, FACE_BASE, 0, INFINITY).normal[2], -43 * mm2, 1e-12);
        // part of a wall, from within one layer to within another
        CHECK_NEAR(surface_of(&m.body, FACE_HOLE + 1, 0.3e-3, 2.7e-3).area, 4 * 2.4 * mm2, 1e-12);
        const int none[2] = {FACE_HOLE + 3, FACE_HOLE + 90};
        for (int i = 0; i < 2; i++) {
            surface s = {0};
            const face_part part = {none[i], 0, INFINITY};
            CHECK(face_walk(&m.body, &part, 0, 3, measure, &s) == ERR_INPUT);
            status_clear();
        }
        drop(&m);
    }
}

static void holes_that_touch_at_a_corner_stay_two(void)
{
    model m;
    face_border f = {0};
    make(1, false, touching, square, false, &m);
    CHECK_OK(face_border_make(&m.body, 0, &f));
    CHECK(f.nloop == 3);
    double smallest = 0, sum = 0;
    for (int k = 0; k < f.nloop; k++) {
        sum += f.area[k];
        smallest = fmin(smallest, f.area[k]);
    }
    CHECK_NEAR(sum, 45e-6, 1e-12);
    CHECK_NEAR(smallest, -2e-6, 1e-12);
    face_border_free(&f);
    drop(&m);
}

static double volume_of(const body *b)
{
    double sum = 0;
    const int faces[4] = {FACE_BASE, FACE_TIP, FACE_OUTSIDE, FACE_INSIDE};
    for (int k = 0; k < 4; k++) {
        sum += surface_of(b, faces[k], 0, INFINITY).volume;
    }
    return sum;
}

static void surfaces_are_closed(void)
{
    for (int order = 1; order <= ELEMENT_MAX_ORDER; order++) {
        for (int k = 0; k < 2; k++) {
            model m;
            make(order, k == 1, cells, bent, true, &m);
            const int faces[4] = {FACE_BASE, FACE_TIP, FACE_OUTSIDE, FACE_INSIDE};
            double sum[3] = {0}, area = 0;
            for (int i = 0; i < 4; i++) {
                const surface s = surface_of(&m.body, faces[i], 0, INFINITY);
                area += s.area;
                for (int d = 0; d < 3; d++) {
                    sum[d] += s.normal[d];
                }
            }
            for (int d = 0; d < 3; d++) {
                CHECK_WITHIN(sum[d] / area, 0, 1e-13);
            }
            CHECK(volume_of(&m.body) > 43e-6 * 4e-3);
            drop(&m);
        }
    }
}

static void a_pressure_in_a_hole_balances_on_its_ends_only(void)
{
    model m;
    make(3, false, cells, bent, false, &m);
    const int n = m.plane.nnode, nlevel = m.body.nlevel;
    double *f = NULL, sum[3] = {0}, total[3] = {0};
    CHECK_OK(TAKE(f, 3 * (size_t)(n * nlevel)));
    const face_pressure inside = {.on = {FACE_INSIDE, 0, INFINITY}, .pressure = 2e3};
    CHECK_OK(face_add_load(&m.body, &inside, 0, 3, f));
    for (int i = 0; i < 3 * n * nlevel; i++) {
        sum[i % 3] += f[i];
        total[i % 3] += fabs(f[i]);
    }
    CHECK_WITHIN(sum[0] / total[0], 0, 1e-13);
    CHECK_WITHIN(sum[1] / total[1], 0, 1e-13);
    CHECK(total[0] > 0 && total[2] <= 1e-13 * total[0]);
    memset(f, 0, 3 * (size_t)(n * nlevel) * sizeof *f);
    const face_pressure pull = {.on = {FACE_TIP, 0, 0}, .pressure = 50, .traction = {1, 2, 3}};
    CHECK_OK(face_add_load(&m.body, &pull, 0, 3, f));
    const double area = surface_of(&m.body, FACE_TIP, 0, 0).area;
    memset(sum, 0, sizeof sum);
    for (int i = 0; i < 3 * n * nlevel; i++) {
        sum[i % 3] += f[i];
    }
    CHECK_NEAR(sum[0], area, 1e-12);
    CHECK_NEAR(sum[1], 2 * area, 1e-12);
    CHECK_NEAR(sum[2], (3 - 50) * area, 1e-12);
    free(f);
    drop(&m);
}

// sum over all rows and columns of one direction
typedef struct springs {
    face_spring spring;
    double sum[3];
} springs;

static status add_spring(void *self, const face_patch *p)
{
    springs *s = (springs *)self;
    static double K[9 * FACE_MAX_NODES * FACE_MAX_NODES];
    face_spring_matrix(p, &s->spring, K);
    const int n3 = 3 * p->nnode;
    for (int i = 0; i < n3 * n3; i++) {
        if (i / n3 % 3 == i % n3 % 3) {
            s->sum[i % n3 % 3] += K[i];
        }
    }
    return OK;
}

static void springs_push_back_by_their_area(void)
{
    model m;
    make(2, true, cells, square, false, &m);
    const face_part all = {FACE_OUTSIDE, 0, INFINITY};
    springs own = {.spring = {.stiffness = {7, 3, 3}}};
    springs axes = {.spring = {.axes = true, .stiffness = {1, 2, 4}}};
    CHECK_OK(face_walk(&m.body, &all, 0, 3, add_spring, &own));
    CHECK_OK(face_walk(&m.body, &all, 0, 3, add_spring, &axes));
    const double up = 4e-3, x = 2 * NY * 1e-3 * up, y = 2 * NX * 1e-3 * up;
    CHECK_NEAR(own.sum[0], 7 * x + 3 * y, 1e-12);
    CHECK_NEAR(own.sum[1], 3 * x + 7 * y, 1e-12);
    CHECK_NEAR(own.sum[2], 3 * (x + y), 1e-12);
    CHECK_NEAR(axes.sum[0], x + y, 1e-12);
    CHECK_NEAR(axes.sum[2], 4 * (x + y), 1e-12);
    drop(&m);
}

static void nodes_lie_on_their_face(void)
{
    model m;
    make(2, false, cells, square, false, &m);
    const int n = m.plane.nnode, nlevel = m.body.nlevel;
    bool *mark = NULL;
    CHECK_OK(TAKE(mark, (size_t)(n * nlevel)));
    const face_part part = {FACE_OUTSIDE, 1e-3, 2.5e-3};
    CHECK_OK(face_nodes(&m.body, &part, 0, nlevel, mark));
    int count = 0;
    for (int i = 0; i < n * nlevel; i++) {
        const double *x = m.plane.xyz + 3 * (i % n), s = m.body.level[i / n];
        const bool edge =
            x[0] < 1e-9 || x[0] > NX * 1e-3 - 1e-9 || x[1] < 1e-9 || x[1] > NY * 1e-3 - 1e-9;
        CHECK(mark[i] == (edge && s > 1e-3 - 1e-9 && s < 2.5e-3 + 1e-9));
        count += mark[i];
    }
    CHECK(count == 3 * 56);
    free(mark);
    drop(&m);
}

// a step: the upper layers have lost a row of cells, and the matter of each has its own border
static void a_stack_has_walls_of_each_layer(void)
{
    model m;
    int matter[3 * NX * NY];
    make(1, false, NULL, square, false, &m);
    body b = {0};
    for (int i = 0; i < 3 * NX * NY; i++) {
        const int row = i % (NX * NY) / NX;
        matter[i] = i >= NX * NY && row == 0 ? -1 : 0;
    }
    body_spec spec = m.body.spec;
    spec.layer = layers;
    spec.matter = matter;
    CHECK_OK(body_make(&spec, &b));
    const double area = 28 * 1 + 26 * 3;
    CHECK_NEAR(surface_of(&b, FACE_OUTSIDE, 0, INFINITY).area, 1e-6 * area, 1e-12);
    CHECK_NEAR(surface_of(&b, FACE_TIP, 0, 0).area, 40e-6, 1e-12);
    CHECK_NEAR(surface_of(&b, FACE_BASE, 0, 0).area, 48e-6, 1e-12);
    CHECK(!body_node_is_used(&b, 0, 2) && body_node_is_used(&b, 0, 1));
    CHECK(body_node_is_used(&b, NX + 1, 3) && body_material(&b, 0, 3, 1) == -1);
    body_free(&b);
    drop(&m);
}

int main(void)
{
    holes_are_numbered_by_size();
    holes_that_touch_at_a_corner_stay_two();
    surfaces_are_closed();
    a_pressure_in_a_hole_balances_on_its_ends_only();
    springs_push_back_by_their_area();
    nodes_lie_on_their_face();
    a_stack_has_walls_of_each_layer();
    return test_failures != 0;
}
