// tests/verify/rodsolver/verify_rod_compliance.c
// The linear limit of the straight rod against closed forms and against an independent 3D FEM (mm,
// N, nu = 0.3).
#include "tests/unit/rodsolver/prototypes.h"

static void cantilever_has_its_closed_form(void)
{
    const prototype p = homogeneous_tube();
    const prototype_section q = prototype_integrals(&p, 0);
    const double L = p.length, GA = q.EA / (2 * (1 + p.nu));
    law_along law = {0};
    prototype_law(&p, &law);
    mat6 C;
    CHECK_OK(rod_linear_compliance(&law, L, 4, &C));
    CHECK_NEAR(C.a[0][0], L / GA + L * L * L / (3 * q.EIy), 1e-13);
    CHECK_NEAR(C.a[4][0], L * L / (2 * q.EIy), 1e-13);
    CHECK_NEAR(C.a[3][1], -L * L / (2 * q.EIx), 1e-13);
    CHECK_NEAR(C.a[2][2], L / q.EA, 1e-13);
    CHECK_NEAR(C.a[5][5], L / q.GJ, 1e-13);
    // half of the law's rod
    CHECK_OK(rod_linear_compliance(&law, L / 2, 4, &C));
    CHECK_NEAR(C.a[4][4], L / 2 / q.EIy, 1e-13);
    CHECK(rod_linear_compliance(&law, 2 * L, 4, &C) == ERR_BUG);
    status_clear();
    law_along_free(&law);
}

// a straight tendon's first-order effect is that of its force and moment at the tip
static void small_tension_is_the_linear_limit(void)
{
    prototype p = constant_nc();
    p.angle[0] = p.angle[1] = 2; // no symmetry left to hide behind
    law_along law = {0};
    prototype_law(&p, &law);
    mat6 C;
    CHECK_OK(rod_linear_compliance(&law, p.length, 4, &C));
    const double tau = 1e-7, x = 3.6e-3 * cos(0.4), y = 3.6e-3 * sin(0.4);
    const vec6 wrench = {{0, 0, -tau, -tau * y, tau * x, 0}};
    const vec6 wanted = mat6_mul_vec(C, wrench);
    const tendon_spec t = straight_tendon("a", 3.6e-3, 0.4);
    rod_solution out = {0};
    const made_rod r = solved_rod(&law, 1, &t, (rod_options){.tolerance = 1e-12}, &tau, &out);
    const vec3 turn = so3_log(out.tip.R);
    for (int c = 0; c < 3; c++) {
        const double moved = out.tip.p.a[c] - (c == 2 ? p.length : 0);
        CHECK_WITHIN(moved, wanted.a[c], 1e-6 * p.length * fabs(wanted.a[3]) + 1e-15);
        CHECK_WITHIN(turn.a[c], wanted.a[c + 3], 1e-6 * fabs(wanted.a[3]));
    }
    free_rod(r);
    law_along_free(&law);
}

// compliances by 3D FEM, error bars 2e-5: the upper triangle of the constant and of the helical
// prototype, 120 mm
static const double constant_3d[21] = {
    3427.7302475676743,      2.6752539631920824e-05, -89.55099657218443,    -3.0438508031699285e-07,
    42.19901209221298,       -1.893823141603717e-08, 7111.10489199625,      -6.405481787045183e-07,
    -88.45778431340312,      3.008790610348002e-07,  1.0306138079853089,    7.26977194761135,
    7.324682115041779e-09,   -1.4925166146688007,    4.584058291291611e-10, 1.4742964249814021,
    -3.4383135341877657e-09, -2.696460586207379e-09, 0.7033168706155009,    -2.1594086018192766e-10,
    1.8379956642455995};
static const double helical_3d[21] = {
    4524.370002339337,    -708.0399020012336,   40.11089147277404,   5.859751773948503,
    59.83647363340619,    2.347238777579812,    4817.17956630691,    60.685065665430045,
    -57.88395100263348,   -5.2922530336707805,  1.6546701579959064,  7.101668832756489,
    -0.9995435651613662,  0.030188406830251528, -0.1276170426942785, 1.006645297822918,
    -0.01684495098617085, -0.03718798090070899, 1.016768748722489,   -0.001991837743348555,
    1.7507230094507946};

static mat6 in_metres(const double *upper)
{
    mat6 C;
    for (int i = 0, k = 0; i < 6; i++) {
        for (int j = i; j < 6; j++, k++) {
            C.a[i][j] = C.a[j][i] = upper[k] * (i < 3 ? 1e-3 : 1) * (j < 3 ? 1 : 1e3);
        }
    }
    return C;
}

static double error_of_rod(const law_along *law, const double *reference)
{
    mat6 C;
    CHECK_OK(rod_linear_compliance(law, law->length, 24, &C));
    return mat6_relative_error(C, in_metres(reference));
}

// how far a rod is from 3D: the figures of the reference's own rods
static void distance_from_3d_is_the_published_one(void)
{
    prototype constant = constant_nc(), helical = helical_nc();
    constant.nu = helical.nu = 0.3;
    law_along law = {0};
    prototype_law(&constant, &law);
    CHECK_NEAR(error_of_rod(&law, constant_3d), 0.3252474088236081, 1e-4);
    // the same section with warping, N and mm
    static const double full[6][6] = {{2.138247702752114, 0, 0, 0, 0, 0},
                                      {0, 2.86796990887283, 0, 0, 0, -1.5960168842158597},
                                      {0, 0, 29.21304176918158, 0, 62.02736034231311, 0},
                                      {0, 0, 0, 81.23604110956464, 0, 0},
                                      {0, 0, 62.02736034231311, 0, 302.0390668747022, 0},
                                      {0, -1.5960168842158597, 0, 0, 0, 65.88819989436854}};
    for (int i = 0; i < 36; i++) {
        const int r = i / 6, c = i % 6;
        law.law[0].K.a[r][c] = full[r][c] * (r < 3 ? 1 : 1e-3) * (c < 3 ? 1 : 1e-3);
    }
    law.turn[0] = 0;
    CHECK_NEAR(error_of_rod(&law, constant_3d), 0.004438146312226713, 0.01);
    law_along_free(&law);
    prototype_law(&helical, &law);
    CHECK_NEAR(error_of_rod(&law, helical_3d), 0.3425043159505308, 1e-4);
    law_along_free(&law);
}

int main(void)
{
    against(BY_CLOSED_FORM, "cantilever and tension in the linear limit");
    cantilever_has_its_closed_form();
    small_tension_is_the_linear_limit();
    against(BY_OTHER_CODE,
            "3D FEM of an independent code: curved high-order hexahedra, direct solver");
    distance_from_3d_is_the_published_one();
    return test_failures != 0;
}
