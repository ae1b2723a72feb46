// The warping of a turning section, handed out in SI: put into its own equations (3.10) here, by
// other code than that which solved them, and without their modes. What satisfies them is the
// solution.
#include "tests/verify/section/hand_meshes.h"

static void place_lopsided(double u, double v, double *xyz)
{
    const double angle = 2.2 * (1 - u), r = 2e-3 + 2e-3 * v;
    xyz[0] = r * cos(angle) + 1e-3;
    xyz[1] = 1.3 * r * sin(angle) - 2e-3 + 3e-4 * u;
    xyz[2] = 0;
}

static int lower_part(double u, double v)
{
    return u < 0.3 && v < 0.6;
}

static const lattice lopsided = {
    .order = 2, .n0 = 5, .n1 = 3, .place = place_lopsided, .material = lower_part};

// an isotropic one, and a fibre that leans out of the section
static void set_materials(material m[2])
{
    m[0] = (material){.name = "soft", .E = 1e6, .nu = 0.42};
    m[1] = (material){.name = "fibre",
                      .E1 = 3e7,
                      .E2 = 4e6,
                      .E3 = 2e6,
                      .G12 = 1.5e6,
                      .G13 = 1e6,
                      .G23 = 7e5,
                      .nu12 = 0.3,
                      .nu13 = 0.25,
                      .nu23 = 0.4,
                      .fibre_angle = 0.6,
                      .plane_angle = -0.4};
    for (int k = 0; k < 2; k++) {
        CHECK_OK(material_bind(&m[k]));
    }
}

// --- one point

typedef struct point {
    int n;
    const int *node;
    const double *N;
    double grad[ELEMENT_MAX_PLANE_NODES][2];
    double x, y, dA;
} point;

static point point_at(const mesh *m, const basis_table *t, int e, int q)
{
    point p = {.n = t->nnode, .node = m->block[0].conn + e * t->nnode, .N = t->N + q * t->nnode};
    const double *dN = t->dN + 2 * q * t->nnode;
    double J[2][2] = {{0}};
    for (int i = 0; i < p.n; i++) {
        p.x += p.N[i] * m->xyz[3 * p.node[i]];
        p.y += p.N[i] * m->xyz[3 * p.node[i] + 1];
        for (int c = 0; c < 4; c++) {
            J[c / 2][c % 2] += m->xyz[3 * p.node[i] + c / 2] * dN[2 * i + c % 2];
        }
    }
    const double det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
    for (int i = 0; i < p.n; i++) {
        p.grad[i][0] = (dN[2 * i] * J[1][1] - dN[2 * i + 1] * J[1][0]) / det;
        p.grad[i][1] = (dN[2 * i + 1] * J[0][0] - dN[2 * i] * J[0][1]) / det;
    }
    p.dA = det * t->weight[q];
    return p;
}

// strains xx yy zz yz xz xy of a displacement u that is N_i along c, in the frame that turns:
// du/dz = k (e_z x u + y du/dx - x du/dy)
static vec6 node_strain(const point *p, int i, int c, double rate)
{
    double u[3] = {0}, ux[3] = {0}, uy[3] = {0};
    u[c] = p->N[i];
    ux[c] = p->grad[i][0];
    uy[c] = p->grad[i][1];
    const vec3 cross = vec3_cross((vec3){{0, 0, 1}}, (vec3){{u[0], u[1], u[2]}});
    double uz[3];
    for (int a = 0; a < 3; a++) {
        uz[a] = rate * (cross.a[a] + p->y * ux[a] - p->x * uy[a]);
    }
    return (vec6){{ux[0], uy[1], uz[2], uy[2] + uz[1], ux[2] + uz[0], uy[0] + ux[1]}};
}

static vec6 slope_strain(double u0, double u1, double u2)
{
    return (vec6){{0, 0, u2, u1, u0, 0}};
}

static vec6 stress_at(const point *p, const section_warping *f, int j, double rate, const mat6 *Q)
{
    const mat6 *s = &f->psi;
    vec6 strain = {{0, 0, s->a[NZ][j] + p->y * s->a[MX][j] - p->x * s->a[MY][j],
                    s->a[NY][j] + p->x * s->a[MZ][j], s->a[NX][j] - p->y * s->a[MZ][j], 0}};
    for (int i = 0; i < p->n; i++) {
        const double *w = f->w + (j * f->nnode + p->node[i]) * 3;
        const double *dw = f->dw + (j * f->nnode + p->node[i]) * 3;
        for (int c = 0; c < 3; c++) {
            strain = vec6_add(strain, vec6_scale(w[c], node_strain(p, i, c, rate)));
        }
        strain = vec6_add(strain, vec6_scale(p->N[i], slope_strain(dw[0], dw[1], dw[2])));
    }
    return mat6_mul_vec(*Q, strain);
}

// theta' = T_k theta
static mat6 transport(double k)
{
    return (mat6){{{0, k, 0, 0, 0, 0},
                   {-k, 0, 0, 0, 0, 0},
                   {0, 0, 0, 0, 0, 0},
                   {0, 1, 0, 0, k, 0},
                   {-1, 0, 0, -k, 0, 0},
                   {0, 0, 0, 0, 0, 0}}};
}

// --- the whole section

typedef struct balance {
    double *force, *size; // [6][nnode][3]: what is left, and the sum of what went in
    mat6 wrench, energy;
} balance;

static void add_point(const point *p, const section_warping *f, double rate, const mat6 *Q,
                      balance *b)
{
    const mat6 T = transport(rate);
    vec6 stress[6];
    for (int j = 0; j < 6; j++) {
        stress[j] = stress_at(p, f, j, rate, Q);
        const double zz = stress[j].a[2], yz = stress[j].a[3], xz = stress[j].a[4];
        const double wrench[6] = {xz, yz, zz, zz * p->y, -zz * p->x, yz * p->x - xz * p->y};
        for (int i = 0; i < 6; i++) {
            b->wrench.a[i][j] += p->dA * wrench[i];
        }
    }
    for (int j = 0; j < 6; j++) {
        vec6 slope = {{0}};
        for (int i = 0; i < 6; i++) {
            slope = vec6_add(slope, vec6_scale(T.a[i][j], stress[i]));
        }
        for (int i = 0; i < 3 * p->n; i++) {
            const int at = (j * f->nnode + p->node[i / 3]) * 3 + i % 3;
            const double u[3] = {i % 3 == 0, i % 3 == 1, i % 3 == 2};
            const double in = vec6_dot(node_strain(p, i / 3, i % 3, rate), stress[j]);
            const double out = p->N[i / 3] * vec6_dot(slope_strain(u[0], u[1], u[2]), slope);
            b->force[at] += p->dA * (in - out);
            b->size[at] += p->dA * (fabs(in) + fabs(out));
        }
    }
}

static void check_balance(const balance *b, int nnode)
{
    for (int j = 0; j < 6; j++) {
        double most = 0, left = 0;
        for (int u = 0; u < 3 * nnode; u++) {
            most = fmax(most, b->size[j * 3 * nnode + u]);
            left = fmax(left, fabs(b->force[j * 3 * nnode + u]));
        }
        CHECK(most > 0);
        CHECK(left < 1e-10 * most);
        for (int i = 0; i < 6; i++) {
            const double unit = (i < 3 ? 1 : 4e-3) / (j < 3 ? 1 : 4e-3);
            CHECK_WITHIN(b->wrench.a[i][j] / unit, i == j, 1e-9);
        }
    }
}

static void equations_hold(double rate)
{
    mesh m = lattice_mesh(&lopsided);
    material materials[2];
    section_warping f = {0};
    beam_law law = {0};
    element e;
    basis_table t = {0};
    set_materials(materials);
    CHECK_OK(section_turning_mesh(&m, materials, rate, &law, &f));
    CHECK_OK(element_make(SHAPE_QUAD, m.order, &e));
    CHECK_OK(basis_table_make(&e, 2 * m.order + 1, &t));
    balance b = {.force = calloc(18 * (size_t)m.nnode, sizeof(double)),
                 .size = calloc(18 * (size_t)m.nnode, sizeof(double))};
    for (int k = 0; k < m.block[0].nelem; k++) {
        const mat6 Q = material_stiffness(&materials[m.block[0].material[k]]);
        for (int q = 0; q < t.npoint; q++) {
            const point p = point_at(&m, &t, k, q);
            add_point(&p, &f, rate, &Q, &b);
        }
    }
    check_balance(&b, m.nnode);
    const mat6 slope = mat6_mul(f.psi, transport(rate));
    for (int i = 0; i < 36; i++) {
        const double unit = fabs(f.psi.a[i / 6][i / 6]) + fabs(f.psi.a[MX][MX]) * 1e3;
        CHECK_WITHIN(f.dpsi.a[i / 6][i % 6], slope.a[i / 6][i % 6], 1e-9 * unit);
    }
    free(b.force);
    free(b.size);
    basis_table_free(&t);
    section_warping_free(&f);
    mesh_free(&m);
}

int main(void)
{
    equations_hold(0);
    equations_hold(150);
    equations_hold(-700);
    return test_failures != 0;
}
