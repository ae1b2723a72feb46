// tests/verify/fem/verify_doubling.c
// The prism's way by doubling: exact cases, its error per doubling, published compliances, and the
// direct way on the same mesh. docs/theory.md (5.12)
#include "fem/level_fit.h"
#include "tests/verify/fem/ring_prism.h"

// the largest miss of a wanted compliance, |C - D|_ij / sqrt(D_ii D_jj)
static double miss(const prism *p, const mat6 *wanted)
{
    return mat6_relative_error(tip_compliance(&p->run), *wanted);
}

// --- exact: a base free to contract, traction E x (rigid motion), one Poisson's ratio

// pull at the stiffness centre: L / EA with the mesh's own EA
static double pull_miss(const prism *p)
{
    level_fit fit = {0};
    double u = 0;
    CHECK_OK(level_fit_make(&p->body, 0, LEVEL_BY_E, &fit));
    const vec6 w = {{0, 0, 1, fit.centroid[1], -fit.centroid[0], 0}};
    for (int j = 0; j < 6; j++) {
        u += w.a[j] * vec6_dot(w, p->run.motion[(j + 1) * p->run.nlevel - 1]);
    }
    const double wanted = p->body.length / fit.weight;
    level_fit_free(&fit);
    return fabs(u / wanted - 1);
}

static void pull_is_exact_at_any_length_and_contrast(void)
{
    puts("ring under pull: miss over diameters long and contrast, 256 slabs");
    for (int i = 0; i < 4; i++) {
        const double length = 8e-3 * (const double[]){0.1, 1, 10, 50}[i];
        for (double contrast = 1; contrast < 2e8; contrast *= 1e4) {
            const material pair[2] = {{.name = "soft", .E = 1e6, .nu = 0.45},
                                      {.name = "stiff", .E = 1e6 * contrast, .nu = 0.45}};
            const ring s = fig4_ring(3);
            prism p = {0};
            prism_solve(&s, pair, 2, 256, length, 0, BASE_FREE_TO_CONTRACT, TIP_E_PROPORTIONAL, &p);
            printf("  %5.1f diameters, contrast %.0e: miss %.1e, residual %.1e\n", length / 8e-3,
                   contrast, pull_miss(&p), p.run.residual);
            CHECK_WITHIN(pull_miss(&p), 0, 1e-9);
            CHECK_WITHIN(p.run.residual, 0, 1e-10);
            prism_free(&p);
        }
    }
}

// cells of 1 mm of a bar of 3 x 2 mm, one of them stiff: no symmetry, and its corner at (1, 1) mm
static const double BAR_STIFF = 20e6, BAR_SOFT = 1e6;

static status bar_mesh(mesh *out)
{
    status st = OK;
    const int p = 2, nelem = 6, nx = 3 * p + 1;
    const shape quad = SHAPE_QUAD;
    TRY(mesh_make(p, nx * (2 * p + 1), 1, &quad, &nelem, out));
    for (int i = 0; i < out->nnode; i++) {
        out->xyz[3 * i] = 1e-3 * (1 + (double)(i % nx) / p);
        out->xyz[3 * i + 1] = 1e-3 * (1 + (double)(i / nx) / p);
    }
    for (int e = 0; e < 6; e++) {
        out->block[0].material[e] = e == 2;
        for (int m = 0; m < 9; m++) {
            out->block[0].conn[9 * e + m] = (e / 3 * p + m / 3) * nx + e % 3 * p + m % 3;
        }
    }

done:
    return st;
}

// n_z, m_x, m_y over strain, kappa_x, kappa_y
static mat3 bar_law(void)
{
    mat3 A = {0};
    for (int e = 0; e < 6; e++) {
        const double E = e == 2 ? BAR_STIFF : BAR_SOFT, x = 1.5 + e % 3, y = 1.5 + e / 3;
        const double own[3][3] = {
            {1, y, -x}, {y, y * y + 1 / 12.0, -x * y}, {-x, -x * y, x * x + 1 / 12.0}};
        for (int i = 0; i < 9; i++) {
            A.a[i / 3][i % 3] +=
                E * 1e-6 * own[i / 3][i % 3] * (i / 3 ? 1e-3 : 1) * (i % 3 ? 1e-3 : 1);
        }
    }
    return A;
}

// A x (strains of the tip) and all resultants are the unit wrenches; moments over 1 mm
static double bar_miss(const way_run *run, double length)
{
    const mat3 A = bar_law();
    double worst = 0;
    for (int j = 0; j < 3; j++) {
        const vec6 *motion = run->motion + (2 + j) * run->nlevel;
        for (int i = 0; i < 3; i++) {
            double w = 0;
            for (int k = 0; k < 3; k++) {
                w += A.a[i][k] * motion[run->nlevel - 1].a[2 + k] / length;
            }
            worst = fmax(worst, fabs(w - (i == j)) * (j ? 1e-3 : 1) / (i ? 1e-3 : 1));
        }
        for (int k = 0; k < 6 * run->nlevel; k++) {
            const int i = k % 6;
            const double w = run->resultant[(2 + j) * run->nlevel + k / 6].a[i];
            worst = fmax(worst, fabs(w - (i == 2 + j)) * (j ? 1e-3 : 1) / (i < 3 ? 1 : 1e-3));
        }
    }
    return worst;
}

static void pull_and_bending_of_a_bar_are_exact_and_rounding_grows_slowly(void)
{
    const material pair[2] = {{.name = "soft", .E = BAR_SOFT, .nu = 0.3},
                              {.name = "stiff", .E = BAR_STIFF, .nu = 0.3}};
    mesh plane = {0};
    double first = 0;
    CHECK_OK(bar_mesh(&plane));
    puts("bar of 20 mm under pull and bending: miss over doublings");
    for (int k = 4; k <= 12; k++) {
        body b = {0};
        way_run run = {0};
        const way_wants wants = {.middle = 10e-3, .middle_half = 2e-3};
        CHECK_OK(prism_body(&plane, pair, 2, 1 << k, 20e-3, 0, &b));
        const segment_problem problem = {
            .body = &b, .base = BASE_FREE_TO_CONTRACT, .tip = TIP_E_PROPORTIONAL};
        CHECK_OK(way_doubling(&problem, &wants, &run));
        if (run.motion) {
            const double miss = bar_miss(&run, 20e-3);
            first = k == 4 ? miss : first;
            printf("  %2d doublings: %.1e, %.1f a doubling\n", k, miss,
                   k > 4 ? pow(miss / first, 1.0 / (k - 4)) : 1);
            CHECK_WITHIN(miss, 0, 1e-9);
        }
        way_run_free(&run);
        body_free(&b);
    }
    mesh_free(&plane);
}

// --- published compliances

static void compliances_of_the_prototype_agree_entry_by_entry(void)
{
    // clamped, rigid cap, mm and N: independent high-order hexahedra to 9e-5 and 2e-5
    const mat6 published[2] = {{{{23.91700768, 0, -2.46007697, 0, 1.162481669, 0},
                                 {0, 38.80063306, 0, -2.433169703, 0, 0.2137871627},
                                 {-2.46007697, 0, 1.199958952, 0, -0.246007697, 0},
                                 {0, -2.433169703, 0, 0.2433169703, 0, 0},
                                 {1.162481669, 0, -0.246007697, 0, 0.1162481669, 0},
                                 {0, 0.2137871627, 0, 0, 0, 0.299421502}}},
                               {{{3427.730248, 0, -89.55099657, 0, 42.19901209, 0},
                                 {0, 7111.104892, 0, -88.45778431, 0, 1.030613808},
                                 {-89.55099657, 0, 7.269771948, 0, -1.492516615, 0},
                                 {0, -88.45778431, 0, 1.474296425, 0, 0},
                                 {42.19901209, 0, -1.492516615, 0, 0.7033168706, 0},
                                 {0, 1.030613808, 0, 0, 0, 1.837995664}}}};
    for (int k = 0; k < 2; k++) {
        ring s = fig4_ring(3);
        prism p = {0};
        mat6 wanted = published[k];
        for (int i = 0; i < 36; i++) {
            wanted.a[i / 6][i % 6] *= i / 6 < 3 && i % 6 < 3   ? 1e-3
                                      : i / 6 < 3 || i % 6 < 3 ? 1
                                                               : 1e3;
        }
        s.steps = s.arc_steps = 1;
        s.shrink = 0.2;
        s.first = 0.25;
        s.soft = 8;
        prism_solve(&s, SOFT_AND_STIFF, 2, k ? 2048 : 512, k ? 0.12 : 0.02, 0, BASE_CLAMPED,
                    TIP_RIGID, &p);
        printf("%d mm, clamped, rigid cap: miss of the published compliance %.1e\n", k ? 120 : 20,
               miss(&p, &wanted));
        CHECK_WITHIN(miss(&p, &wanted), 0, 2e-4);
        prism_free(&p);
    }
}

// --- the same mesh, the other way

static void direct_solution_of_the_same_mesh_agrees(void)
{
    const double rate[2] = {0, 100};
    for (int k = 0; k < 8; k++) {
        ring s = fig4_ring(2);
        const int order = 1 + k % 4, base = k % 2 ? BASE_FREE_TO_CONTRACT : BASE_CLAMPED;
        const int tip = k / 2 % 2 ? TIP_E_PROPORTIONAL : TIP_RIGID;
        prism p = {0};
        way_run other = {0};
        s.soft = 6;
        prism_make(&s, SOFT_AND_STIFF, order, 16, 20e-3, rate[k / 4], base, tip, &p);
        p.wants.fields = true;
        CHECK_OK(way_doubling(&p.problem, &p.wants, &p.run));
        CHECK_OK(way_direct(&p.problem, &p.wants, &other));
        const mat6 C = tip_compliance(&p.run), D = tip_compliance(&other);
        const double c = mat6_relative_error(C, D),
                     e = mat6_relative_error(p.run.energy, other.energy);
        double most = 0, apart = 0;
        const size_t plane = 3 * (size_t)p.plane.nnode;
        for (int j = 0; j < 6 && other.u; j++) {
            // at the ends of layers: inner levels of a slab are interpolated
            for (int level = 0; level < p.body.nlevel; level += order) {
                const double *u = way_run_level(&p.run, p.plane.nnode, j, level);
                const double *v = way_run_level(&other, p.plane.nnode, j, level);
                const double scale = j < 3 ? 1 : 100;
                for (size_t i = 0; i < plane; i++) {
                    most = fmax(most, fabs(v[i]) / scale);
                    apart = fmax(apart, fabs(u[i] - v[i]) / scale);
                }
            }
        }
        printf("order %d, base %d, tip %d, turning %g/m: against direct: compliance %.1e, energy "
               "%.1e, displacements %.1e\n",
               order, base, tip, rate[k / 4], c, e, apart / most);
        CHECK_WITHIN(c, 0, 1e-9);
        CHECK_WITHIN(e, 0, 1e-9);
        CHECK_ABOVE(most, 0);
        CHECK_WITHIN(apart / most, 0, 1e-9);
        way_run_free(&other);
        prism_free(&p);
    }
}

// fibres aslant: the slab's ends are exchanged by a mirror, by a half turn, by an inversion, and in
// a bar of two materials by nothing
static void slabs_of_fibres_agree_or_are_refused(void)
{
    const double angle[4][2] = {{0, 0}, {0.5, 0}, {0.5, 0.3}, {0.5, 0.3}};
    mesh plane = {0};
    CHECK_OK(bar_mesh(&plane));
    for (int k = 0; k < 4; k++) {
        material pair[2] = {{.name = "fibres",
                             .E1 = 10e6,
                             .E2 = 1e6,
                             .E3 = 2e6,
                             .G12 = 0.5e6,
                             .G13 = 0.6e6,
                             .G23 = 0.4e6,
                             .nu12 = 0.3,
                             .nu13 = 0.25,
                             .nu23 = 0.2,
                             .fibre_angle = angle[k][0],
                             .plane_angle = angle[k][1]}};
        const way_wants wants = {.middle = 4e-3, .middle_half = 1e-3};
        body b = {0};
        way_run run = {0}, other = {0};
        CHECK_OK(material_bind(&pair[0]));
        pair[1] = k < 3 ? pair[0] : (material){.name = "stiff", .E = 20e6, .nu = 0.3};
        CHECK_OK(prism_body(&plane, pair, 2, 16, 8e-3, 0, &b));
        const segment_problem problem = {.body = &b, .tip = TIP_E_PROPORTIONAL};
        if (k == 3) {
            CHECK(way_doubling(&problem, &wants, &run) == ERR_INPUT);
            status_clear();
        } else {
            CHECK_OK(way_doubling(&problem, &wants, &run));
            CHECK_OK(way_direct(&problem, &wants, &other));
        }
        if (run.motion && other.motion) {
            const double c = mat6_relative_error(tip_compliance(&run), tip_compliance(&other));
            printf("fibres %.1f, %.1f: against direct: compliance %.1e, energy %.1e\n", angle[k][0],
                   angle[k][1], c, mat6_relative_error(run.energy, other.energy));
            CHECK_WITHIN(c, 0, 1e-9);
            CHECK_WITHIN(mat6_relative_error(run.energy, other.energy), 0, 1e-9);
        }
        way_run_free(&run);
        way_run_free(&other);
        body_free(&b);
    }
    mesh_free(&plane);
}

// uniform traction, resultant at the area's centroid, beside the six columns
static void uniform_tips_agree_with_the_direct_way(void)
{
    const load_column extra[2] = {{.uniform_tip = true, .tip_force = {0, 0, 1}},
                                  {.uniform_tip = true, .tip_force = {0.5, -1, 0.2}}};
    ring s = fig4_ring(2);
    prism p = {0};
    way_run other = {0};
    s.soft = 6;
    prism_make(&s, SOFT_AND_STIFF, 2, 16, 20e-3, 50, BASE_FREE_TO_CONTRACT, TIP_UNIFORM, &p);
    p.problem.nextra = 2;
    p.problem.extra = extra;
    CHECK_OK(way_doubling(&p.problem, &p.wants, &p.run));
    CHECK_OK(way_direct(&p.problem, &p.wants, &other));
    double apart = 0, of = 0;
    for (int i = 0; i < 64 && p.run.work && other.work; i++) {
        const double scale = sqrt(other.work[9 * (i / 8)] * other.work[9 * (i % 8)]);
        apart = fmax(apart, fabs(p.run.work[i] - other.work[i]) / scale);
        of = fmax(of, fabs(other.work[i]) / scale);
    }
    printf("uniform tips: work against direct %.1e of %.1f\n", apart, of);
    CHECK_WITHIN(apart, 0, 1e-9);
    CHECK_ABOVE(of, 0.5);
    way_run_free(&other);
    prism_free(&p);
}

static void what_it_cannot_take_is_refused(void)
{
    const face_spring spring = {.on = {.face = FACE_OUTSIDE}, .stiffness = {1, 1}};
    const load_column heavy = {.body_force = {0, 0, 1}};
    ring s = fig4_ring(1);
    prism p = {0};
    prism_make(&s, SOFT_AND_STIFF, 1, 4, 20e-3, 0, BASE_CLAMPED, TIP_RIGID, &p);
    CHECK(way_cost_doubling(&p.problem, 1).possible);
    p.problem.base = BASE_FREE;
    CHECK(way_doubling(&p.problem, &p.wants, &p.run) == ERR_INPUT);
    CHECK(!way_cost_doubling(&p.problem, 1).possible);
    p.problem.base = BASE_CLAMPED;
    p.problem.nspring = 1;
    p.problem.spring = &spring;
    CHECK(way_doubling(&p.problem, &p.wants, &p.run) == ERR_INPUT);
    p.problem.nspring = 0;
    p.problem.nextra = 1;
    p.problem.extra = &heavy;
    CHECK(way_doubling(&p.problem, &p.wants, &p.run) == ERR_INPUT);
    CHECK(!way_cost_doubling(&p.problem, 1).possible);
    status_clear();
    prism_free(&p);
}

int main(void)
{
    against(BY_CLOSED_FORM, "pull and bending of prisms");
    pull_is_exact_at_any_length_and_contrast();
    pull_and_bending_of_a_bar_are_exact_and_rounding_grows_slowly();
    against(BY_OTHER_CODE,
            "3D FEM of an independent code: curved high-order hexahedra, direct solver");
    compliances_of_the_prototype_agree_entry_by_entry();
    against(BY_SECOND_WAY, "the direct way on the same mesh");
    direct_solution_of_the_same_mesh_agrees();
    slabs_of_fibres_agree_or_are_refused();
    uniform_tips_agree_with_the_direct_way();
    what_it_cannot_take_is_refused();
    return test_failures != 0;
}
