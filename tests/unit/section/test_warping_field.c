// tests/unit/section/test_warping_field.c
// The warping handed out in SI at the section's origin: its stresses carry the unit wrenches and
// its energy is the compliance, both integrated here anew.
#include "section/section.h"
#include "tests/test.h"

static const material two[2] = {{.E = 1e6, .nu = 0.45}, {.E = 2e7, .nu = 0.3}};

static mesh lopsided_tube(void)
{
    mesh m = {0};
    outline items[2] = {
        {.kind = KIND_ANNULUS, .outer = 4e-3, .inner = 2e-3, .centre = {3e-3, -1e-3}},
        {.kind = KIND_SECTOR,
         .outer = 4e-3,
         .inner = 2e-3,
         .centre = {3e-3, -1e-3},
         .mid_angle = 0.4,
         .width = 1,
         .material = 1}};
    const section_outline o = {.count = 2, .items = items, .size = 8e-3};
    const mesh_options options = {.kind = MESH_MAPPED, .order = 3, .size = 1e-3};
    CHECK_OK(section_mesh_make(&o, &options, &m));
    return m;
}

// strains xx yy zz yz xz xy of column j at a point, from values and derivatives of the basis
static vec6 strain_at(const section_warping *f, int j, const int *node, int n, const double *N,
                      const double (*grad)[2], double x, double y)
{
    double wx[3] = {0}, wy[3] = {0}, dw[3] = {0}, psi[6];
    for (int i = 0; i < n; i++) {
        for (int c = 0; c < 3; c++) {
            const double w = f->w[(j * f->nnode + node[i]) * 3 + c];
            wx[c] += grad[i][0] * w;
            wy[c] += grad[i][1] * w;
            dw[c] += N[i] * f->dw[(j * f->nnode + node[i]) * 3 + c];
        }
    }
    for (int i = 0; i < 6; i++) {
        psi[i] = f->psi.a[i][j];
    }
    return (vec6){{
        wx[0],
        wy[1],
        dw[2] + psi[NZ] + psi[MX] * y - psi[MY] * x,
        wy[2] + dw[1] + psi[NY] + psi[MZ] * x,
        wx[2] + dw[0] + psi[NX] - psi[MZ] * y,
        wy[0] + wx[1],
    }};
}

typedef struct sums {
    mat6 wrench, energy; // column j for unit wrench j
} sums;

static void add_point(const mesh *m, const section_warping *f, const basis_table *t, int e, int q,
                      sums *s)
{
    const mesh_block *b = &m->block[0];
    const int n = t->nnode, *node = b->conn + e * n;
    const double *N = t->N + q * n, *dN = t->dN + 2 * q * n;
    double x = 0, y = 0, J[2][2] = {{0}}, grad[ELEMENT_MAX_PLANE_NODES][2];
    for (int i = 0; i < n; i++) {
        x += N[i] * m->xyz[3 * node[i]];
        y += N[i] * m->xyz[3 * node[i] + 1];
        for (int c = 0; c < 4; c++) {
            J[c / 2][c % 2] += m->xyz[3 * node[i] + c / 2] * dN[2 * i + c % 2];
        }
    }
    const double det = J[0][0] * J[1][1] - J[0][1] * J[1][0], dA = det * t->weight[q];
    for (int i = 0; i < n; i++) {
        grad[i][0] = (dN[2 * i] * J[1][1] - dN[2 * i + 1] * J[1][0]) / det;
        grad[i][1] = (dN[2 * i + 1] * J[0][0] - dN[2 * i] * J[0][1]) / det;
    }
    const mat6 Q = material_stiffness(&two[b->material[e]]);
    vec6 strain[6];
    for (int j = 0; j < 6; j++) {
        strain[j] = strain_at(f, j, node, n, N, (const double(*)[2])grad, x, y);
    }
    for (int j = 0; j < 6; j++) {
        const vec6 t6 = mat6_mul_vec(Q, strain[j]);
        const double zz = t6.a[2], yz = t6.a[3], xz = t6.a[4];
        const double wrench[6] = {xz, yz, zz, zz * y, -zz * x, yz * x - xz * y};
        for (int i = 0; i < 6; i++) {
            s->wrench.a[i][j] += dA * wrench[i];
            s->energy.a[i][j] += dA * vec6_dot(strain[i], t6);
        }
    }
}

static void stresses_carry_unit_wrenches(void)
{
    mesh m = lopsided_tube();
    section_warping field = {0};
    beam_law law = {0};
    element e;
    basis_table t = {0};
    sums s = {0};
    CHECK_OK(section_full_mesh(&m, two, &law, &field));
    CHECK(field.nnode == m.nnode);
    CHECK_OK(element_make(SHAPE_QUAD, m.order, &e));
    CHECK_OK(basis_table_make(&e, 2 * m.order + 1, &t));
    for (int k = 0; k < m.block[0].nelem; k++) {
        for (int q = 0; q < t.npoint; q++) {
            add_point(&m, &field, &t, k, q, &s);
        }
    }
    mat6 F;
    CHECK(mat6_inverse_spd(law.K, &F));
    const double size = 4e-3; // moments and forces differ by a length
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            const double unit = (i < 3 ? 1 : size) / (j < 3 ? 1 : size);
            CHECK_WITHIN(s.wrench.a[i][j] / unit, i == j, 1e-10);
            CHECK_WITHIN(s.energy.a[i][j] / sqrt(F.a[i][i] * F.a[j][j]),
                         F.a[i][j] / sqrt(F.a[i][i] * F.a[j][j]), 1e-10);
        }
    }
    basis_table_free(&t);
    section_warping_free(&field);
    mesh_free(&m);
}

// theta' = T theta: psi' of a unit n_y is psi of a unit m_x, and so is w'
static void slopes_follow_the_end_wrench(void)
{
    mesh m = lopsided_tube();
    section_warping f = {0};
    beam_law law = {0};
    CHECK_OK(section_full_mesh(&m, two, &law, &f));
    for (int i = 0; i < 6; i++) {
        CHECK_WITHIN(f.dpsi.a[i][NY], f.psi.a[i][MX], 1e-11 * fabs(f.psi.a[MX][MX]));
        CHECK_WITHIN(f.dpsi.a[i][NX], -f.psi.a[i][MY], 1e-11 * fabs(f.psi.a[MX][MX]));
        CHECK(f.dpsi.a[i][MZ] == 0 && f.dpsi.a[i][NZ] == 0);
    }
    double most = 0;
    const int n = 3 * m.nnode;
    for (int u = 0; u < n; u++) {
        most = fmax(most, fabs(f.dw[NY * n + u]));
    }
    CHECK(most > 0);
    for (int u = 0; u < n; u++) {
        CHECK_WITHIN(f.dw[NY * n + u], f.w[MX * n + u], 1e-11 * most);
    }
    section_warping_free(&f);
    mesh_free(&m);
}

// two squares that share one corner hang together by a hinge
static void parts_joined_at_a_point_are_refused(void)
{
    mesh m = {0};
    const shape quad = SHAPE_QUAD;
    const int nelem = 2;
    static const double place[7][2] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {2, 1}, {1, 2}, {2, 2}};
    static const int conn[8] = {0, 1, 2, 3, 3, 4, 5, 6};
    beam_law law = {0};
    CHECK_OK(mesh_make(1, 7, 1, &quad, &nelem, &m));
    for (int i = 0; i < 7; i++) {
        m.xyz[3 * i] = place[i][0];
        m.xyz[3 * i + 1] = place[i][1];
    }
    for (int i = 0; i < 8; i++) {
        m.block[0].conn[i] = conn[i];
    }
    CHECK(section_full_mesh(&m, two, &law, NULL) == ERR_NUMERIC);
    status_clear();
    mesh_free(&m);
}

int main(void)
{
    stresses_carry_unit_wrenches();
    slopes_follow_the_end_wrench();
    parts_joined_at_a_point_are_refused();
    return test_failures != 0;
}
