// Manufactured solutions in 3D: u_k = a_k sin(k_k . x + phi_k), the body force that it needs, its
// values on the whole boundary. Orders p + 1 in L2 and p in the energy, p = 1 to 4, hexahedra and
// prisms, straight, and in a ring sector that is bent, twisted and tapered.
#include "tests/body_solve.h"
#include "tests/grid_mesh.h"

enum { MESHES = 2 };

static const double amplitude[3] = {1, 0.7, -0.8}, phase[3] = {0.3, 1.1, -0.5};
static const double wave[3][3] = {{1.3, 0.6, -0.9}, {-0.7, 1.1, 0.8}, {0.5, -0.8, 1.2}};

typedef struct manufactured {
    equations *s;
    mat6 Q;
    double l2, l2_size, energy, energy_size;
} manufactured;

static const int strain_of[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};

static double argument(int k, const double *x)
{
    return wave[k][0] * x[0] + wave[k][1] * x[1] + wave[k][2] * x[2] + phase[k];
}

static void exact(const double *x, double *u)
{
    for (int k = 0; k < 3; k++) {
        u[k] = amplitude[k] * sin(argument(k, x));
    }
}

static vec6 strain_by(double H[3][3])
{
    return (vec6){
        {H[0][0], H[1][1], H[2][2], H[1][2] + H[2][1], H[0][2] + H[2][0], H[0][1] + H[1][0]}};
}

static vec6 exact_strain(const double *x)
{
    double H[3][3];
    for (int i = 0; i < 9; i++) {
        H[i / 3][i % 3] = amplitude[i / 3] * wave[i / 3][i % 3] * cos(argument(i / 3, x));
    }
    return strain_by(H);
}

// - d_j C_ijkl d_l u_k
static double force(const mat6 *Q, int i, const double *x)
{
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        for (int j = 0; j < 3; j++) {
            for (int l = 0; l < 3; l++) {
                sum += Q->a[strain_of[i][j]][strain_of[k][l]] * wave[k][j] * wave[k][l] *
                       amplitude[k] * sin(argument(k, x));
            }
        }
    }
    return sum;
}

static void add_force(brick *w, int layer, void *self)
{
    const manufactured *m = (const manufactured *)self;
    int number[BRICK_MAX_DOFS];
    CHECK_OK(brick_geometry(w, layer));
    brick_places(w);
    element_unknowns(w, layer, number);
    for (int q = 0; q < w->nq; q++) {
        for (int d = 0; d < 3; d++) {
            const double f = force(&m->Q, d, w->place[q]) * w->dV[q];
            for (int i = 0; i < w->n; i++) {
                m->s->f[number[3 * i + d]] += f * basis_at(w, q, i);
            }
        }
    }
}

static void add_error(brick *w, int layer, void *self)
{
    manufactured *m = (manufactured *)self;
    double u[BRICK_MAX_DOFS];
    CHECK_OK(brick_geometry(w, layer));
    brick_places(w);
    element_displacements(m->s, w, layer, u);
    for (int q = 0; q < w->nq; q++) {
        double H[3][3] = {{0}}, v[3] = {0}, at[3];
        const double *g = w->grad + 3 * (size_t)q * (size_t)w->n;
        for (int i = 0; i < 3 * w->n; i++) {
            v[i % 3] += basis_at(w, q, i / 3) * u[i];
            for (int j = 0; j < 3; j++) {
                H[i % 3][j] += g[j * w->n + i / 3] * u[i];
            }
        }
        exact(w->place[q], at);
        const vec6 wanted = exact_strain(w->place[q]), miss = vec6_sub(strain_by(H), wanted);
        for (int d = 0; d < 3; d++) {
            m->l2 += w->dV[q] * (v[d] - at[d]) * (v[d] - at[d]);
            m->l2_size += w->dV[q] * at[d] * at[d];
        }
        m->energy += w->dV[q] * vec6_dot(miss, mat6_mul_vec(m->Q, miss));
        m->energy_size += w->dV[q] * vec6_dot(wanted, mat6_mul_vec(m->Q, wanted));
    }
}

// --- geometry

// a quarter of a ring about a point of the section, which then is bent about an axis outside,
// twisted and tapered along the way
static void ring(const double *from, double *to)
{
    const double r = 0.5 + 0.5 * from[0], a = 1.2 * from[1] - 0.3;
    to[0] = r * cos(a) - 0.6;
    to[1] = r * sin(a) - 0.1;
}

static status sweep(const void *self, double s, double *xyz, mat3 *axes, double origin[3])
{
    const mesh *plane = (const mesh *)self;
    const double k = 0.8, scale = 1 - 0.3 * s;
    const mat3 lean = {{{cos(k * s), 0, sin(k * s)}, {0, 1, 0}, {-sin(k * s), 0, cos(k * s)}}};
    *axes = mat3_mul(lean, mat3_rot_z(0.7 * s));
    memcpy(origin, (const double[3]){(1 - cos(k * s)) / k, 0, sin(k * s) / k}, 3 * sizeof *origin);
    for (int i = 0; i < plane->nnode; i++) {
        const double *x = plane->xyz + 3 * (size_t)i;
        const vec3 r = mat3_mul_vec(*axes, (vec3){{scale * x[0], scale * x[1], 0}});
        for (int d = 0; d < 3; d++) {
            xyz[3 * i + d] = origin[d] + r.a[d];
        }
    }
    return OK;
}

static void skew(const double *from, double *to)
{
    to[0] = from[0] + 0.2 * from[1];
    to[1] = 0.9 * from[1] - 0.1 * from[0];
}

typedef struct family {
    const char *name;
    bool triangles, curved, mixed;
    const material *matter;
} family;

static void hold_boundary(equations *s)
{
    const body *b = s->body;
    bool *mark = NULL;
    const int n = b->plane->nnode;
    const face_part walls = {FACE_OUTSIDE, 0, INFINITY};
    CHECK_OK(TAKE(mark, (size_t)(n * b->nlevel)));
    CHECK_OK(face_nodes(b, &walls, 0, b->nlevel, mark));
    for (int i = 0; i < n * b->nlevel; i++) {
        if (mark[i] || i / n == 0 || i / n == b->nlevel - 1) {
            double x[3], u[3];
            body_node(b, i % n, i / n, x);
            exact(x, u);
            for (int d = 0; d < 3; d++) {
                hold(s, i % n, i / n, d, u[d]);
            }
        }
    }
    free(mark);
}

static void solve_one(const family *f, int order, int cells, double *l2, double *energy)
{
    mesh plane = {0};
    body b = {0};
    equations s = {0};
    double layer[20];
    const grid g = {cells, cells, order, f->triangles, NULL, f->curved ? ring : skew};
    grid_make(&g, &plane);
    for (int k = 0; k <= cells; k++) {
        layer[k] = (double)k / cells;
    }
    body_spec spec = {.plane = &plane,
                      .materials = f->matter,
                      .order = order,
                      .nlayer = cells,
                      .layer = layer,
                      .mixed = f->mixed};
    if (f->curved) {
        spec.shape = (body_shape){.self = &plane, .place = sweep};
    }
    CHECK_OK(body_make(&spec, &b));
    equations_make(&b, &s);
    assemble(&s);
    manufactured m = {.s = &s, .Q = material_stiffness(f->matter)};
    each_element(&b, add_force, &m);
    hold_boundary(&s);
    solve(&s);
    each_element(&b, add_error, &m);
    *l2 = sqrt(m.l2 / m.l2_size);
    *energy = sqrt(m.energy / m.energy_size);
    equations_free(&s);
    body_free(&b);
    mesh_free(&plane);
}

static void check_orders(const family *f, int order)
{
    static const int all[ELEMENT_MAX_ORDER][MESHES] = {{6, 9}, {3, 5}, {2, 3}, {2, 3}};
    double h[MESHES], l2[MESHES], energy[MESHES];
    for (int k = 0; k < MESHES; k++) {
        h[k] = 1.0 / all[order - 1][k];
        solve_one(f, order, all[order - 1][k], &l2[k], &energy[k]);
    }
    about("%s, order %d", f->name, order);
    const double two = observed_order(MESHES, h, l2), one = observed_order(MESHES, h, energy);
    printf("%-28s p = %d: L2 %.2e %.2e order %.2f; energy %.2e %.2e order %.2f\n", f->name, order,
           l2[0], l2[1], two, energy[0], energy[1], one);
    CHECK_ABOVE(two, order + 1 - 0.25);
    CHECK_ABOVE(one, order - 0.25);
}

int main(void)
{
    against(BY_CLOSED_FORM, "manufactured solutions");
    material soft = {.E = 1, .nu = 0.3}, ortho = {.E1 = 10,
                                                  .E2 = 1,
                                                  .E3 = 2,
                                                  .G12 = 0.7,
                                                  .G13 = 0.5,
                                                  .G23 = 0.4,
                                                  .nu12 = 0.3,
                                                  .nu13 = 0.25,
                                                  .nu23 = 0.2,
                                                  .fibre_angle = 0.4,
                                                  .plane_angle = 0.3};
    CHECK_OK(material_bind(&soft));
    CHECK_OK(material_bind(&ortho));
    const family all[] = {
        {"hexahedra, straight", false, false, false, &soft},
        {"hexahedra, curved", false, true, false, &soft},
        {"prisms, straight", true, false, false, &soft},
        {"prisms, curved", true, true, false, &soft},
        {"hexahedra, orthotropic", false, false, false, &ortho},
        {"hexahedra, curved, mixed", false, true, true, &soft},
        {"prisms, curved, mixed", true, true, true, &soft},
    };
    for (size_t k = 0; k < sizeof all / sizeof *all; k++) {
        for (int order = 1; order <= ELEMENT_MAX_ORDER; order++) {
            check_orders(&all[k], order);
        }
    }
    return test_failures != 0;
}
