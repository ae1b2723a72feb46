// tests/verify/fem/verify_compliance.c
// Tip compliance of the clamped, capped segment, entry by entry, against an independent code; its
// convergence with the order; and the law of the section against the section analysis. mm, N, rad.
#include "tests/verify/fem/polar_mesh.h"

// reference A20: upper triangle's entries that symmetry about the x axis leaves; its own error
// is 9.1e-5
static mat6 reference_compliance(void)
{
    mat6 C = {0};
    const double diagonal[6] = {23.917007683924982,  38.80063306236766,   1.1999589518868163,
                                0.24331697033857033, 0.11624816688875944, 0.29942150198682455};
    for (int i = 0; i < 6; i++) {
        C.a[i][i] = diagonal[i];
    }
    C.a[NX][NZ] = C.a[NZ][NX] = -2.4600769702955807;
    C.a[NX][MY] = C.a[MY][NX] = 1.1624816688791673;
    C.a[NZ][MY] = C.a[MY][NZ] = -0.24600769703143013;
    C.a[NY][MX] = C.a[MX][NY] = -2.4331697033845594;
    C.a[NY][MZ] = C.a[MZ][NY] = 0.21378716272977993;
    return C;
}

static const double REFERENCE_ERROR = 9.1e-5;

// sections.json b
static mat6 reference_law(void)
{
    mat6 K = {0};
    const double diagonal[6] = {2.138247702752114, 2.86796990887283,  29.21304176918158,
                                81.23604110956464, 302.0390668747022, 65.88819989436854};
    for (int i = 0; i < 6; i++) {
        K.a[i][i] = diagonal[i];
    }
    K.a[NZ][MY] = K.a[MY][NZ] = 62.02736034231311;
    K.a[NY][MZ] = K.a[MZ][NY] = -1.5960168842158597;
    return K;
}

// C from m, N, rad: lengths in mm, so entries of displacements and moments each change; K the other
// way
static mat6 in_millimetres(mat6 a, double displacement, double moment)
{
    for (int i = 0; i < 6; i++) {
        for (int j = 0; j < 6; j++) {
            a.a[i][j] *= (i < 3 ? displacement : moment) * (j < 3 ? displacement : moment);
        }
    }
    return a;
}

static const material MATERIALS[2] = {{.E = 0.66e6, .nu = 0.3}, {.E = 15.93e6, .nu = 0.3}};

static void solve(int order, segment_result *r, beam_law *law)
{
    polar_segment s = fig4_segment();
    column_model model = {0};
    s.order = order;
    s.soft = 8;
    s.layers = 8;
    CHECK_OK(polar_model(&s, MATERIALS, BASE_CLAMPED, TIP_RIGID, &model));
    CHECK_OK(model_solve(&model, 0, &(segment_load){0}, NULL, 0, r));
    CHECK_OK(segment_section_law(&model.plane, MATERIALS, law));
    column_model_free(&model);
}

// what the mesh may miss by order; the clamped edges' singularity sets the pace of the compliance
static const double COMPLIANCE[5] = {0, 0.2, 2e-3, 5e-4, 2.5e-4};
static const double LAW[5] = {0, 1, 2e-3, 1e-4, 1e-4};

static double check_compliance(int order, const segment_result *r)
{
    // u [mm] by F [N]: x 1e3; u by M [N mm] and rotation by F: 1; rotation by M: 1e-3
    const mat6 C = in_millimetres(r->tip_compliance, sqrt(1e3), sqrt(1e-3));
    const double error = mat6_relative_error(C, reference_compliance());
    printf("order %d: %6lld dofs, compliance to %.2e, estimate %.2e, residual %.1e\n", order,
           r->dofs, error, r->relative_error, r->residual);
    CHECK_WITHIN(error, 0, COMPLIANCE[order]);
    CHECK_AT_MOST(error, r->relative_error + REFERENCE_ERROR);
    CHECK_ABOVE(r->residual, 0);
    CHECK_BELOW(r->residual, 1e-13);
    return error;
}

static void check_law(int order, const segment_result *r, const beam_law *law)
{
    const double error = mat6_relative_error(in_millimetres(law->K, 1, 1e3), reference_law());
    const double own = mat6_relative_error(in_millimetres(r->middle.K, 1, 1e3), reference_law());
    printf("order %d: law to %.2e, estimate %.2e; this segment's own middle %.2e off\n", order,
           error, law->relative_error, own);
    CHECK_WITHIN(error, 0, LAW[order]);
    CHECK_AT_MOST(error, law->relative_error);
    // 20 mm are five radii: the ends reach the middle in torsion and shear, not in stretch and
    // bending
    if (order > 2) {
        CHECK_NEAR(1e6 * r->middle.K.a[MX][MX], 81.23604110956464, 1e-3);
        CHECK_NEAR(r->middle.K.a[NZ][NZ], 29.21304176918158, 1e-3);
        CHECK_WITHIN(own, 0.024, 0.01);
    }
}

// both errors lie below their estimates; the compliance's falls with the order
static void results_converge_to_the_references(void)
{
    double before = 1;
    for (int order = 1; order <= ELEMENT_MAX_ORDER; order++) {
        segment_result r = {0};
        beam_law law = {0};
        solve(order, &r, &law);
        const double error = check_compliance(order, &r);
        check_law(order, &r, &law);
        CHECK_BELOW(error, before / 1.5);
        before = error;
        segment_result_free(&r);
    }
}

int main(void)
{
    against(BY_OTHER_CODE,
            "3D FEM of an independent code: curved high-order hexahedra, direct solver");
    results_converge_to_the_references();
    return test_failures != 0;
}
