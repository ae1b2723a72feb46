// tests/verify/fem/verify_bars.c
// Closed forms of homogeneous bars: a tube in torsion, the law of a tube and of a flat strip,
// uniform traction.
#include "tests/verify/fem/polar_mesh.h"

static polar_segment tube(void)
{
    polar_segment s = fig4_segment();
    s.width = 0;
    s.stiff = 0;
    s.soft = 8;
    s.layers = 4;
    return s;
}

static status solve(column_model *m, const segment_load *load, const double *point,
                    segment_result *r)
{
    const double at[1][2] = {{point[0], point[1]}};
    return model_solve(m, 1, load, at, 0, r);
}

static const double ORIGIN[2] = {0, 0};
static const material rubber = {.E = 0.66e6, .nu = 0.3};

// how far the displacements are from tau z (-y, x, 0) and a turn of the whole, over the largest of
// them
static double off_the_twist(const column_model *m, double tau, const double *u)
{
    const int n = m->plane.nnode;
    double worst = 0, largest = 0;
    for (int i = 0; i < n * m->nlevel; i++) {
        const double *x = m->plane.xyz + 3 * (i % n), turn = tau * m->level[i / n];
        const double d[3] = {u[3 * i] + turn * x[1], u[3 * i + 1] - turn * x[0], u[3 * i + 2]};
        for (int k = 0; k < 3; k++) {
            worst = fmax(worst, fabs(d[k]));
            largest = fmax(largest, fabs(u[3 * i + k]));
        }
    }
    return worst / largest;
}

// sections turn without warping: u = tau z (-y, x, 0), which every order holds. What is left is the
// circle's geometry, of order 2p in the element's angle; pins that carried anything would show in
// the field
static void a_tube_twists_by_T_L_over_GJ(void)
{
    const polar_segment s = tube();
    const double G = rubber.E / 2.6, J = PI / 2 * (pow(s.outer, 4) - pow(s.inner, 4));
    const segment_load load = {.name = "torque", .moment = {0, 0, 1e-3}};
    const double wanted = 1e-3 * s.length / (G * J), twist[5] = {0, 0.3, 5e-3, 1e-4, 1e-6};
    const double field[5] = {0, 1e-4, 1e-4, 1e-4, 1e-6};
    for (int order = 1; order <= ELEMENT_MAX_ORDER; order++) {
        polar_segment with = s;
        column_model m = {0};
        segment_result r = {0};
        with.order = order;
        with.layers = 2;
        CHECK_OK(polar_model(&with, &rubber, BASE_FREE_TO_CONTRACT, TIP_E_PROPORTIONAL, &m));
        CHECK_OK(model_solve(&m, 1, &load, &ORIGIN, 1, &r));
        if (r.load) {
            const double angle = r.load[0].tip_rotation[2];
            const double off = off_the_twist(&m, angle / s.length, r.load[0].displacement);
            printf("tube, order %d: twist to %.1e, field to %.1e\n", order, angle / wanted - 1,
                   off);
            CHECK_NEAR(angle, wanted, twist[order]);
            CHECK_WITHIN(off, 0, field[order]);
            CHECK_NEAR(r.load[0].strain_energy, 1e-3 * angle / 2, 1e-10);
        }
        segment_result_free(&r);
        column_model_free(&m);
    }
}

// sections.json a and a45: shear stiffness from the closed-form coefficient of a tube; mm, N, MPa
// turned into SI
static void the_law_of_a_tube(double nu, double GA, double GJ)
{
    const polar_segment s = tube();
    const material m = {.E = 0.66e6, .nu = nu};
    const double A = PI * (s.outer * s.outer - s.inner * s.inner);
    const double I = PI / 4 * (pow(s.outer, 4) - pow(s.inner, 4));
    const double diagonal[6] = {GA, GA, m.E * A, m.E * I, m.E * I, 1e-6 * GJ};
    column_model model = {0};
    beam_law law = {0};
    mat6 wanted = {0};
    for (int i = 0; i < 6; i++) {
        wanted.a[i][i] = diagonal[i];
    }
    CHECK_OK(polar_model(&s, &m, BASE_CLAMPED, TIP_RIGID, &model));
    CHECK_OK(segment_section_law(&model.plane, &m, &law));
    const double error = mat6_relative_error(law.K, wanted);
    printf("tube, nu %.2f: law to %.1e, estimate %.1e\n", nu, error, law.relative_error);
    // order 3 with eight elements around: geometry and shear flow 1e-5 to 1e-4
    CHECK_WITHIN(error, 0, 3e-4);
    CHECK_AT_MOST(error, law.relative_error);
    CHECK_NEAR(law.area, A, 1e-4);
    column_model_free(&model);
}

// sections.json d1: 4 x 1 mm, E = 1 MPa, nu = 0.3; torsion by the series, GA along y from a fine
// section analysis
static void the_law_of_a_strip(void)
{
    const material m = {.E = 1e6, .nu = 0.3};
    const shape quad = SHAPE_QUAD;
    const int nx = 6, order = 3, wide = nx * order + 1, nelem = nx;
    double node[ELEMENT_MAX_ORDER + 1];
    column_model model = {0};
    beam_law law = {0};
    gauss_lobatto_nodes(order + 1, node);
    CHECK_OK(mesh_make(order, wide * (order + 1), 1, &quad, &nelem, &model.plane));
    for (int i = 0; i < wide * (order + 1); i++) {
        const int k = i % wide, e = k == wide - 1 ? nx - 1 : k / order;
        model.plane.xyz[3 * i] = 4e-3 * ((e + (node[k - e * order] + 1) / 2) / nx - 0.5);
        model.plane.xyz[3 * i + 1] = 0.5e-3 * node[i / wide];
    }
    for (int e = 0; e < nx; e++) {
        for (int i = 0; i < 16; i++) {
            model.plane.block[0].conn[16 * e + i] = e * order + i % 4 + wide * (i / 4);
        }
    }
    CHECK_OK(segment_section_law(&model.plane, &m, &law));
    printf("strip: GJ to %.1e, GA to %.1e\n", 1e6 * law.K.a[MZ][MZ] / 0.4320199359 - 1,
           law.K.a[NY][NY] / 0.89800 - 1);
    CHECK_NEAR(law.K.a[NZ][NZ], 4.0, 1e-5);
    CHECK_NEAR(law.K.a[MX][MX], 1e-6 * 4.0 / 12, 1e-5);
    CHECK_NEAR(law.K.a[MY][MY], 1e-6 * 64.0 / 12, 1e-5);
    CHECK_NEAR(law.K.a[MZ][MZ], 1e-6 * 0.4320199359, 3e-4);
    CHECK_NEAR(law.K.a[NY][NY], 0.89800, 1e-3); // the reference's own figures
    column_model_free(&model);
}

// with one material the uniform traction is the E-proportional one
static void uniform_traction_of_one_material(void)
{
    polar_segment with = tube();
    const segment_load load = {.name = "force", .force = {0.01, -0.02, -0.3}};
    segment_result r[2] = {{0}, {0}};
    with.order = 2;
    for (int i = 0; i < 2; i++) {
        column_model m = {0};
        CHECK_OK(
            polar_model(&with, &rubber, BASE_CLAMPED, i ? TIP_UNIFORM : TIP_E_PROPORTIONAL, &m));
        CHECK_OK(solve(&m, &load, ORIGIN, &r[i]));
        column_model_free(&m);
    }
    if (r[0].load && r[1].load) {
        CHECK_NEAR(r[1].load[0].shortening, r[0].load[0].shortening, 1e-10);
        CHECK_NEAR(r[1].load[0].strain_energy, r[0].load[0].strain_energy, 1e-10);
        CHECK_NEAR(r[1].load[0].tip_displacement[1], r[0].load[0].tip_displacement[1], 1e-10);
        CHECK_NEAR(r[1].load[0].mid_curvature[0], r[0].load[0].mid_curvature[0], 1e-10);
    }
    segment_result_free(&r[0]);
    segment_result_free(&r[1]);
}

// of two materials: the resultant acts at the area's centroid, and nowhere else
static void uniform_traction_of_two_materials(void)
{
    polar_segment s = fig4_segment();
    const material both[2] = {rubber, {.E = 15.93e6, .nu = 0.3}};
    const segment_load force = {.name = "force", .force = {0, 0, -0.5}};
    const segment_load moment = {.name = "moment", .moment = {0, 1e-3, 0}};
    const double centre[2] = {-2.1232763e-3, 0};
    column_model m = {0};
    segment_result r = {0};
    s.order = 2;
    s.layers = 6;
    CHECK_OK(polar_model(&s, both, BASE_CLAMPED, TIP_UNIFORM, &m));
    CHECK(solve(&m, &force, centre, &r) == ERR_INPUT);
    status_clear();
    CHECK(solve(&m, &moment, ORIGIN, &r) == ERR_INPUT);
    status_clear();
    CHECK_OK(solve(&m, &force, ORIGIN, &r));
    if (r.load) {
        CHECK_WITHIN(r.load[0].point[0], 0, 1e-7); // the mesh's own centroid
        // physics, section 4 of the paper's facts: 0.638 mm is the mean tip displacement under
        // uniform pressure
        CHECK_NEAR(r.load[0].strain_energy, 0.5 * 0.5 * 0.638e-3, 5e-3);
    }
    segment_result_free(&r);
    column_model_free(&m);
}

int main(void)
{
    against(BY_CLOSED_FORM,
            "T L / GJ; a tube's shear by theory (3.7); a strip by Saint-Venant's series");
    a_tube_twists_by_T_L_over_GJ();
    the_law_of_a_tube(0.3, 2.3432918532015687, 60.26661217321418);
    the_law_of_a_tube(0.45, 2.1005118041115174, 54.0321350518472);
    the_law_of_a_strip();
    uniform_traction_of_one_material();
    uniform_traction_of_two_materials();
    return test_failures != 0;
}
