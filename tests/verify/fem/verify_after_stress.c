// tests/verify/fem/verify_after_stress.c
// Stresses at the nodes against closed forms: what elements hold exactly comes back exactly, at
// interfaces too, and what they do not converges.
#include "fem/after.h"
#include "tests/verify/fem/polar_mesh.h"

// soft and stiff; Poisson's ratio 0 where bending is to be a polynomial on curved elements
static const material materials[2] = {{.name = "soft", .E = 2e6, .nu = 0.3},
                                      {.name = "stiff", .E = 3e7, .nu = 0.3}};
static const material without_nu[2] = {{.name = "soft", .E = 2e6}, {.name = "stiff", .E = 3e7}};
static const double RATE = 0.7; // twist, curvature [1/m]

typedef void known_field(const double *x, const material *m, double *u, double *stress);

// u = rate z (-y, x, 0): in the elements' own space, however curved they are
static void torsion(const double *x, const material *m, double *u, double *stress)
{
    const double G = material_shear_modulus(m);
    u[0] = -RATE * x[2] * x[1];
    u[1] = RATE * x[2] * x[0];
    u[2] = 0;
    stress[3] = G * RATE * x[0];
    stress[4] = -G * RATE * x[1];
}

// about y: eps_zz = rate x, and sideways by nu, which all materials share
static void bending(const double *x, const material *m, double *u, double *stress)
{
    u[0] = -RATE / 2 * (x[2] * x[2] + m->nu * (x[0] * x[0] - x[1] * x[1]));
    u[1] = -RATE * m->nu * x[0] * x[1];
    u[2] = RATE * x[0] * x[2];
    stress[2] = m->E * RATE * x[0];
}

// no polynomial; G at nu = 0.3
static void wavy(const double *x, const material *m, double *u, double *stress)
{
    const double k = 300, G = material_shear_modulus(m);
    u[0] = u[1] = 0;
    u[2] = sin(k * x[0]) / k * cos(k * x[2]);
    stress[4] = G * cos(k * x[0]) * cos(k * x[2]);
    const double zz = -sin(k * x[0]) * sin(k * x[2]), lambda = 2 * G * m->nu / (1 - 2 * m->nu);
    stress[0] = stress[1] = lambda * zz;
    stress[2] = (lambda + 2 * G) * zz;
}

// the largest miss at the nodes over the largest stress, of fields given at the nodes
static double largest_miss(const mesh *plane, const material *m, int order, int nlayer,
                           known_field *f)
{
    body b = {0};
    segment_body here = {0};
    double *layer = NULL, *u = NULL, *stress = NULL, miss = 0, most = 0;
    CHECK_OK(TAKE(layer, (size_t)nlayer + 1));
    for (int i = 0; i <= nlayer; i++) {
        layer[i] = 6e-3 * pow((double)i / nlayer, 1.3);
    }
    const body_spec spec = {
        .plane = plane, .materials = m, .order = order, .nlayer = nlayer, .layer = layer};
    CHECK_OK(body_make(&spec, &b));
    const segment_problem p = {.body = &b};
    const way_run run = {.last = b.nlevel};
    CHECK_OK(after_keep_body(&p, &run, true, true, &here));
    CHECK_OK(TAKE(u, 3 * (size_t)b.nlevel * (size_t)plane->nnode));
    for (int i = 0; i < b.nlevel * plane->nnode; i++) {
        double unused[6];
        f(here.node + 3 * i, &m[0], u + 3 * i, unused);
    }
    CHECK_OK(after_stress(&here, &b, &run, u, &stress));
    const mesh *apart = &here.apart;
    for (int k = 0; stress && k < apart->nblock; k++) {
        const mesh_block *o = &apart->block[k];
        for (int i = 0; i < b.nlevel * o->nelem * o->per_elem; i++) {
            const int at = i % (o->nelem * o->per_elem), level = i / (o->nelem * o->per_elem);
            const double *xy = apart->xyz + 3 * o->conn[at];
            const double x[3] = {xy[0], xy[1], b.level[level]};
            double exact[6] = {0}, ignored[3];
            f(x, &m[o->material[at / o->per_elem]], ignored, exact);
            for (int d = 0; d < 6; d++) {
                const double found = stress[6 * (level * apart->nnode + o->conn[at]) + d];
                miss = fmax(miss, fabs(found - exact[d]));
                most = fmax(most, fabs(exact[d]));
            }
        }
    }
    free(layer);
    free(u);
    free(stress);
    segment_body_free(&here);
    body_free(&b);
    return miss / most;
}

// rounding of strains from displacements of many elements' sizes
static const double EXACT = 1e-11;

static void a_curved_tube_of_two_materials_twists_exactly(void)
{
    for (int p = 2; p <= 4; p++) {
        polar_segment s = fig4_segment();
        mesh m = {0};
        s.order = p;
        CHECK_OK(polar_mesh(&s, &m));
        const double miss = largest_miss(&m, materials, p, 3, torsion);
        printf("order %d, torsion of a curved tube: %.1e\n", p, miss);
        CHECK_WITHIN(miss, 0, EXACT);
        mesh_free(&m);
    }
}

static void a_curved_tube_without_contraction_bends_exactly(void)
{
    for (int p = 2; p <= 4; p++) {
        polar_segment s = fig4_segment();
        mesh m = {0};
        s.order = p;
        CHECK_OK(polar_mesh(&s, &m));
        const double miss = largest_miss(&m, without_nu, p, 3, bending);
        printf("order %d, bending of a curved tube: %.1e\n", p, miss);
        CHECK_WITHIN(miss, 0, EXACT);
        mesh_free(&m);
    }
}

// two triangles of two materials beside a parallelogram
static void make_flat(int order, mesh *out)
{
    mesh first = {0};
    const shape shapes[2] = {SHAPE_QUAD, SHAPE_TRIANGLE};
    const int nelem[2] = {1, 2}, quad[4] = {0, 1, 2, 3}, triangle[2][3] = {{1, 4, 3}, {4, 5, 3}};
    const double xy[6][2] = {{0, 0}, {2, 0.2}, {0.3, 1}, {2.3, 1.2}, {4, 0}, {3.8, 1.4}};
    CHECK_OK(mesh_make(1, 6, 2, shapes, nelem, &first));
    for (int i = 0; i < 6; i++) {
        first.xyz[3 * i] = 1e-3 * xy[i][0];
        first.xyz[3 * i + 1] = 1e-3 * xy[i][1];
    }
    memcpy(first.block[0].conn, quad, sizeof quad);
    memcpy(first.block[1].conn, triangle, sizeof triangle);
    first.block[1].material[0] = 1;
    CHECK_OK(mesh_of_order(&first, order, out));
    mesh_free(&first);
}

static void flat_elements_of_both_shapes_bend_exactly(void)
{
    for (int p = 2; p <= 4; p++) {
        mesh m = {0};
        make_flat(p, &m);
        for (int along = 2; along <= 4; along++) { // orders need not be the same
            const double miss = largest_miss(&m, materials, along, 2, bending);
            printf("order %d, %d along, bending of flat elements: %.1e\n", p, along, miss);
            CHECK_WITHIN(miss, 0, EXACT);
        }
        mesh_free(&m);
    }
}

// stresses are one order less than displacements
static void other_fields_converge(void)
{
    for (int p = 2; p <= 3; p++) {
        double h[2], miss[2];
        for (int k = 0; k < 2; k++) {
            polar_segment s = fig4_segment();
            mesh m = {0};
            s.order = p;
            s.soft = 24 << k;
            s.stiff = 2 << k;
            s.radial = 1 << k;
            CHECK_OK(polar_mesh(&s, &m));
            h[k] = 1.0 / (1 << k);
            miss[k] = largest_miss(&m, materials, p, 6 << k, wavy);
            mesh_free(&m);
        }
        about("order %d", p);
        printf("order %d, no polynomial: %.1e, %.1e\n", p, miss[0], miss[1]);
        CHECK_ABOVE(observed_order(2, h, miss), p - 0.4);
    }
}

int main(void)
{
    against(BY_CLOSED_FORM, "torsion and bending fields; a manufactured field");
    a_curved_tube_of_two_materials_twists_exactly();
    a_curved_tube_without_contraction_bends_exactly();
    flat_elements_of_both_shapes_bend_exactly();
    other_fields_converge();
    return test_failures != 0;
}
