// tests/verify/fem/verify_patch.c
// Exact fields on a bad mesh: skewed quads and triangles of two materials with one Poisson's ratio,
// layers of heights 1 to 40, every order. Free base, E-proportional traction: uniform strain for a
// force at the stiffness centre; a moment's strain is linear in x and y, its displacement
// quadratic, and exact from order 2 on.
#include "tests/verify/fem/polar_mesh.h"

static const material materials[2] = {{.E = 0.66e6, .nu = 0.4}, {.E = 15.93e6, .nu = 0.4}};

enum { VERTICES = 9, QUADS = 3, TRIANGLES = 2 };

static const double vertex[VERTICES][2] = {{0, 0},         {1e-3, -2e-4},    {3e-3, 1e-4},
                                           {-3e-4, 2e-3},  {1.9e-3, 1.2e-3}, {2.5e-3, 1.6e-3},
                                           {2e-4, 2.8e-3}, {1.1e-3, 3.3e-3}, {3.2e-3, 3e-3}};
static const int quad_corner[QUADS][4] = {{0, 1, 3, 4}, {1, 2, 4, 5}, {3, 4, 6, 7}};
static const int triangle_corner[TRIANGLES][3] = {{4, 5, 8}, {4, 8, 7}};
static const int quad_material[QUADS] = {0, 1, 1};
static const int triangle_material[TRIANGLES] = {0, 1};

static int find_or_add(mesh *m, const double *x)
{
    for (int i = 0; i < m->nnode; i++) {
        if (hypot(m->xyz[3 * i] - x[0], m->xyz[3 * i + 1] - x[1]) < 1e-9) {
            return i;
        }
    }
    m->xyz[3 * m->nnode] = x[0];
    m->xyz[3 * m->nnode + 1] = x[1];
    return m->nnode++;
}

// straight edges: the geometry is that of the corners' own order-1 element
static void place(mesh *m, int block, int e, const int *corner)
{
    element fine = {0}, coarse = {0};
    const mesh_block *b = &m->block[block];
    CHECK_OK(element_make(b->shape, m->order, &fine));
    CHECK_OK(element_make(b->shape, 1, &coarse));
    for (int i = 0; i < fine.nnode; i++) {
        double N[4], x[2] = {0};
        element_basis(&coarse, fine.node[i], N, NULL);
        for (int k = 0; k < coarse.nnode; k++) {
            x[0] += N[k] * vertex[corner[k]][0];
            x[1] += N[k] * vertex[corner[k]][1];
        }
        b->conn[e * b->per_elem + i] = find_or_add(m, x);
    }
}

static void bad_mesh(int order, mesh *m)
{
    const shape shapes[2] = {SHAPE_QUAD, SHAPE_TRIANGLE};
    const int nelem[2] = {QUADS, TRIANGLES};
    CHECK_OK(mesh_make(order, 5 * ELEMENT_MAX_PLANE_NODES, 2, shapes, nelem, m));
    m->nnode = 0;
    for (int e = 0; e < QUADS; e++) {
        place(m, 0, e, quad_corner[e]);
        m->block[0].material[e] = quad_material[e];
    }
    for (int e = 0; e < TRIANGLES; e++) {
        place(m, 1, e, triangle_corner[e]);
        m->block[1].material[e] = triangle_material[e];
    }
}

// int E (1, x, y, x^2, xy, y^2) over the polygons: triangles by their edges' middles, exact to
// degree 2
static void add_triangle(const double *a, const double *b, const double *c, double E, double *s)
{
    const double area = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    const double *p[4] = {a, b, c, a};
    for (int i = 0; i < 3; i++) {
        const double x = (p[i][0] + p[i + 1][0]) / 2, y = (p[i][1] + p[i + 1][1]) / 2;
        const double part[6] = {1, x, y, x * x, x * y, y * y};
        for (int k = 0; k < 6; k++) {
            s[k] += E * area / 3 * part[k];
        }
    }
}

static void stiffness_integrals(double *s)
{
    for (int e = 0; e < QUADS; e++) {
        const int *q = quad_corner[e];
        const double E = materials[quad_material[e]].E;
        add_triangle(vertex[q[0]], vertex[q[1]], vertex[q[3]], E, s);
        add_triangle(vertex[q[0]], vertex[q[3]], vertex[q[2]], E, s);
    }
    for (int e = 0; e < TRIANGLES; e++) {
        const int *t = triangle_corner[e];
        add_triangle(vertex[t[0]], vertex[t[1]], vertex[t[2]], materials[triangle_material[e]].E,
                     s);
    }
}

// eps_zz = a + b x + c y
typedef struct strain {
    double a, b, c;
} strain;

static void exact_displacement(strain e, double x, double y, double z, double *u)
{
    const double nu = materials[0].nu;
    u[0] = -nu * (e.a * x + e.c * x * y) - e.b * (z * z + nu * (x * x - y * y)) / 2;
    u[1] = -nu * (e.a * y + e.b * x * y) - e.c * (z * z + nu * (y * y - x * x)) / 2;
    u[2] = (e.a + e.b * x + e.c * y) * z;
}

static double worst_displacement(const column_model *m, strain e, const double *u)
{
    const int n = m->plane.nnode, nlevel = m->nlevel;
    double size = 0, worst = 0, d[3],
           shift[3] = {0}; // motion in the plane: two of node 0, a turn by node n - 1
    const double *xyz = m->plane.xyz, *far = xyz + 3 * (n - 1);
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < n * nlevel; i++) {
            const double x = xyz[3 * (i % n)], y = xyz[3 * (i % n) + 1];
            exact_displacement(e, x, y, m->level[i / n], d);
            for (int k = 0; k < 3; k++) {
                size = fmax(size, fabs(d[k]));
                d[k] = u[3 * i + k] - d[k];
            }
            if (pass == 0 && i == 0) {
                shift[0] = d[0];
                shift[1] = d[1];
            }
            if (pass == 0 && i == n - 1) {
                const double dx = far[0] - xyz[0], dy = far[1] - xyz[1];
                shift[2] = (dx * (d[1] - shift[1]) - dy * (d[0] - shift[0])) / (dx * dx + dy * dy);
            }
            d[0] -= shift[0] - shift[2] * (y - xyz[1]);
            d[1] -= shift[1] + shift[2] * (x - xyz[0]);
            for (int k = 0; pass == 1 && k < 3; k++) {
                worst = fmax(worst, fabs(d[k]));
            }
        }
    }
    return worst / size;
}

// the wrench (n_z, m_x, m_y) of the strain, applied at the origin
static void check_strain(column_model *m, strain e, const double *s)
{
    const double none[1][2] = {{0, 0}};
    const segment_load load = {.name = "strain",
                               .force = {0, 0, e.a * s[0] + e.b * s[1] + e.c * s[2]},
                               .moment = {e.a * s[2] + e.b * s[4] + e.c * s[5],
                                          -(e.a * s[1] + e.b * s[3] + e.c * s[4]), 0}};
    segment_result r = {0};
    CHECK_OK(model_solve(m, 1, &load, none, 1, &r));
    if (!r.load) {
        return;
    }
    const double L = m->level[m->nlevel - 1],
                 worst = worst_displacement(m, e, r.load[0].displacement);
    const double centre[2] = {s[1] / s[0], s[2] / s[0]};
    printf("order %d, eps = %g %+g x %+g y: displacements to %.1e\n", m->plane.order, e.a, e.b, e.c,
           worst);
    // rounding times the condition of a mesh with layers of 1 to 40 and angles of 10 degrees
    CHECK_WITHIN(worst, 0, e.b == 0 ? 1e-10 : 1e-9);
    CHECK_NEAR(r.load[0].shortening, -L * (e.a + e.b * centre[0] + e.c * centre[1]), 1e-10);
    const double turn = fabs(e.b) + fabs(e.c), flat = 1e-10 * (turn + fabs(e.a) / L);
    CHECK_WITHIN(r.load[0].mid_curvature[0], e.c, flat);
    CHECK_WITHIN(r.load[0].mid_curvature[1], -e.b, flat);
    CHECK_WITHIN(r.load[0].tip_rotation[1], -e.b * L, flat * L);
    CHECK_NEAR(r.stiffness_centre[0], centre[0], 1e-9);
    CHECK_NEAR(r.stiffness_centre[1], centre[1], 1e-9);
    const double work =
        (load.force[2] * (e.a) + load.moment[0] * e.c - load.moment[1] * e.b) * L / 2;
    CHECK_NEAR(r.load[0].strain_energy, work, 1e-10);
    segment_result_free(&r);
}

int main(void)
{
    double s[6] = {0};
    stiffness_integrals(s);
    // a uniform strain is a force at the stiffness centre alone
    const strain uniform = {.a = -0.02}, bent = {.a = 0.01, .b = 3, .c = -5};
    for (int order = 1; order <= ELEMENT_MAX_ORDER; order++) {
        column_model m = {0};
        bad_mesh(order, &m.plane);
        CHECK_OK(mesh_check(&m.plane));
        CHECK_OK(extrude_plainly(5, 40, 7e-3, &m));
        m.source.materials = materials;
        m.c.base = BASE_FREE_TO_CONTRACT;
        m.c.tip = TIP_E_PROPORTIONAL;
        check_strain(&m, uniform, s);
        if (order > 1) {
            check_strain(&m, bent, s);
        }
        column_model_free(&m);
    }
    return test_failures != 0;
}
