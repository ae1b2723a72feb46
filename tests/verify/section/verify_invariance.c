// tests/verify/section/verify_invariance.c
// The same section turned, moved, mirrored or made of other units has the same stiffness; quads and
// triangles together give what quads give.
#include "tests/verify/section/hand_meshes.h"

// rounding of a few thousand unknowns, moduli 24 apart
static const double rounding = 1e-11;

static void place_in_bent_plate(double u, double v, double *xyz)
{
    xyz[0] = 3e-3 * u + 0.4e-3 * v * v;
    xyz[1] = 1e-3 * v + 0.8e-3 * u * u;
    xyz[2] = 0;
}

static int stiff_corner(double u, double v)
{
    return u > 0.6 && v < 0.5;
}

static mesh bent_plate(int order)
{
    const lattice g = {
        .order = order, .n0 = 6, .n1 = 2, .place = place_in_bent_plate, .material = stiff_corner};
    return lattice_mesh(&g);
}

static beam_law solve(const mesh *m, const material *materials)
{
    beam_law law = {0};
    CHECK_OK(section_full_mesh(m, materials, &law, NULL));
    CHECK_OK(beam_law_check(&law));
    return law;
}

static void turned_and_moved(void)
{
    material m[2];
    prototype_materials(0.45, 0.3, m);
    mesh plate = bent_plate(3);
    const beam_law law = solve(&plate, m);
    const double angle = 0.7, x = 5e-3, y = -11e-3;
    for (int i = 0; i < plate.nnode; i++) {
        double *at = plate.xyz + 3 * i;
        const double u = at[0], v = at[1];
        at[0] = x + u * cos(angle) - v * sin(angle);
        at[1] = y + u * sin(angle) + v * cos(angle);
    }
    const beam_law moved = solve(&plate, m);
    mesh_free(&plate);
    const double miss = mat6_relative_error(beam_law_move(moved.K, x, y, angle), law.K);
    printf("turned and moved: %.1e\n", miss);
    CHECK_BELOW(miss, rounding);
}

static void in_other_units(void)
{
    static const double scale[] = {1e-6, 1e-3, 1e3, 1e9};
    material m[2];
    prototype_materials(0.45, 0.3, m);
    mesh plate = bent_plate(2);
    const beam_law law = solve(&plate, m);
    mesh_free(&plate);
    for (int k = 0; k < 4; k++) {
        const double a = scale[k], stress = k % 2 ? 1e9 : 1e-3;
        material other[2] = {m[0], m[1]};
        other[0].E *= stress;
        other[1].E *= stress;
        plate = bent_plate(2);
        for (int i = 0; i < 3 * plate.nnode; i++) {
            plate.xyz[i] *= a;
        }
        beam_law scaled = solve(&plate, other);
        mesh_free(&plate);
        for (int i = 0; i < 36; i++) {
            scaled.K.a[i / 6][i % 6] /= stress * a * a * (i / 6 < 3 ? 1 : a) * (i % 6 < 3 ? 1 : a);
        }
        CHECK_BELOW(mat6_relative_error(scaled.K, law.K), rounding);
        CHECK_NEAR(scaled.area, law.area * a * a, rounding);
    }
}

// x -> -x: elements turn over, so their nodes are listed backwards along the first coordinate
static void mirrored(void)
{
    material m[2];
    prototype_materials(0.3, 0.45, m);
    mesh plate = bent_plate(4);
    const beam_law law = solve(&plate, m);
    const int n = plate.order + 1;
    for (int i = 0; i < plate.nnode; i++) {
        plate.xyz[3 * i] *= -1;
    }
    for (int row = 0; row < n * plate.block[0].nelem; row++) {
        int *nodes = plate.block[0].conn + row * n;
        for (int i = 0; i < n / 2; i++) {
            const int t = nodes[i];
            nodes[i] = nodes[n - 1 - i];
            nodes[n - 1 - i] = t;
        }
    }
    CHECK_OK(mesh_check(&plate));
    const beam_law other = solve(&plate, m);
    mesh_free(&plate);
    // n_x, m_y and m_z change sign
    mat6 flip = mat6_identity();
    flip.a[NX][NX] = flip.a[MY][MY] = flip.a[MZ][MZ] = -1;
    const double miss = mat6_relative_error(mat6_congruence(flip, other.K), law.K);
    printf("mirrored: %.1e\n", miss);
    CHECK_BELOW(miss, rounding);
}

// --- quads and triangles

// node of the mesh at x, made when it is new
static int node_at(mesh *m, int *count, double x, double y)
{
    for (int i = 0; i < *count; i++) {
        if (hypot(m->xyz[3 * i] - x, m->xyz[3 * i + 1] - y) < 1e-9) {
            return i;
        }
    }
    m->xyz[3 * *count] = x;
    m->xyz[3 * *count + 1] = y;
    return (*count)++;
}

// the parallelogram (triangle) x0 + a r + b s, r and s over the reference element scaled to [0, 1]
static void add_element(mesh *m, int block, int index, int *count, const double corner[3][2])
{
    element e;
    CHECK_OK(element_make(m->block[block].shape, m->order, &e));
    const bool quad = e.shape == SHAPE_QUAD;
    for (int i = 0; i < e.nnode; i++) {
        const double r = quad ? (e.node[i][0] + 1) / 2 : e.node[i][0];
        const double s = quad ? (e.node[i][1] + 1) / 2 : e.node[i][1];
        double x[2];
        for (int c = 0; c < 2; c++) {
            x[c] = corner[0][c] + r * (corner[1][c] - corner[0][c]) +
                   s * (corner[2][c] - corner[0][c]);
        }
        m->block[block].conn[index * e.nnode + i] = node_at(m, count, x[0], x[1]);
    }
}

// 4 x 1, squares of 1/n; the right half in triangles
static mesh mixed_rectangle(int order, int n)
{
    const shape shapes[2] = {SHAPE_QUAD, SHAPE_TRIANGLE};
    const int nelem[2] = {2 * n * n, 4 * n * n};
    const double h = 1.0 / n;
    mesh m = {0};
    int count = 0, quads = 0, triangles = 0;
    CHECK_OK(mesh_make(order, (4 * n * order + 1) * (n * order + 1) * 2, 2, shapes, nelem, &m));
    for (int i = 0; i < 4 * n; i++) {
        for (int j = 0; j < n; j++) {
            const double x = -2 + i * h, y = -0.5 + j * h;
            if (i < 2 * n) {
                const double corner[3][2] = {{x, y}, {x + h, y}, {x, y + h}};
                add_element(&m, 0, quads++, &count, corner);
            } else {
                const double lower[3][2] = {{x, y}, {x + h, y}, {x + h, y + h}};
                const double upper[3][2] = {{x, y}, {x + h, y + h}, {x, y + h}};
                add_element(&m, 1, triangles++, &count, lower);
                add_element(&m, 1, triangles++, &count, upper);
            }
        }
    }
    m.nnode = count;
    CHECK_OK(mesh_check(&m));
    return m;
}

// sections.json d1; corners limit the order to 4, so orders 3 and 4 differ little on one mesh
static void mixed_shapes(void)
{
    const material one = {.E = 1, .nu = 0.3};
    static const int cuts[] = {0, 16, 6, 4, 4};
    static const double wanted[] = {0, 6e-3, 3e-4, 3e-5, 3e-6};
    for (int p = 1; p <= ELEMENT_MAX_ORDER; p++) {
        mesh m = mixed_rectangle(p, cuts[p]);
        const beam_law law = solve(&m, &one);
        mesh_free(&m);
        const beam_centres c = centres_of(&law);
        printf("quads and triangles, order %d: GJ %.2e, GA %.2e\n", p,
               c.GJ / 0.4320199358642487 - 1, law.K.a[NX][NX] / 1.2820102 - 1);
        CHECK_NEAR(c.EA, 4, 1e-12);
        CHECK_NEAR(c.GJ, 0.4320199358642487, wanted[p]);
        CHECK_NEAR(law.K.a[NX][NX], 1.2820102, wanted[p]);
        if (p > 1) {
            // quadratic sideways contraction is in the space: bending is exact
            CHECK_NEAR(law.K.a[MX][MX], 1.0 / 3, 1e-11);
            CHECK_NEAR(law.K.a[MY][MY], 16.0 / 3, 1e-11);
        }
    }
}

int main(void)
{
    against(BY_SYMMETRY,
            "the same section turned, moved, mirrored, in other units, in other elements");
    turned_and_moved();
    in_other_units();
    mirrored();
    mixed_shapes();
    return test_failures != 0;
}
