// tests/verify/app/verify_helical.c
// The helical prototype, whose pattern turns and narrows: its tip compliance against 3D FEM, and
// K(s) and the stiffness centre along it from few sections.
#include "app/chain.h"

#include "tests/test.h"

#include <string.h>

// Compliance of the tip [mm, rad / N, N mm] by 3D finite elements: helical prototype of 120 mm,
// base clamped, rigid cap, wrench and motion at the geometric centre of the end, nu 0.3. Curved
// high-order hexahedra, direct solver; good to 2e-5.
static const double by_3d_fem[6][6] = {
    {4524.370002339337, -708.0399020012336, 40.11089147277404, 5.859751773948503, 59.83647363340619,
     2.347238777579812},
    {-708.0399020012336, 4817.17956630691, 60.685065665430045, -57.88395100263348,
     -5.2922530336707805, 1.6546701579959064},
    {40.11089147277404, 60.685065665430045, 7.101668832756489, -0.9995435651613662,
     0.030188406830251528, -0.1276170426942785},
    {5.859751773948503, -57.88395100263348, -0.9995435651613662, 1.006645297822918,
     -0.01684495098617085, -0.03718798090070899},
    {59.83647363340619, -5.2922530336707805, 0.030188406830251528, -0.01684495098617085,
     1.016768748722489, -0.001991837743348555},
    {2.347238777579812, 1.6546701579959064, -0.1276170426942785, -0.03718798090070899,
     -0.001991837743348555, 1.7507230094507946}};

static const double mm = 1e-3;

static const char *const full[] = {"section.model=full", "materials.soft.nu=0.3",
                                   "materials.stiff.nu=0.3", "section.tolerance=1e-6"};

static void open_case(case_data *c)
{
    char path[4096];
    const char *source = getenv("STIFFAXIS_SOURCE");
    (void)snprintf(path, sizeof path, "%s/cases/helical_nc.yaml", source ? source : ".");
    const case_request request = {.path = path, .noverride = 4, .overrides = full};
    if (case_open(&request, c) != OK) {
        printf("%s\n", status_message());
        exit(1);
    }
}

static mat6 reference(void)
{
    mat6 C;
    for (int i = 0; i < 36; i++) {
        const double unit = (i / 6 < 3 ? mm : 1) * (i % 6 < 3 ? 1 : 1 / mm);
        C.a[i / 6][i % 6] = by_3d_fem[i / 6][i % 6] * unit;
    }
    return C;
}

// the largest difference of an entry over sqrt(C_ii C_jj)
static double miss(const law_along *law)
{
    mat6 C;
    CHECK_OK(rod_linear_compliance(law, law->length, 8, &C));
    return mat6_relative_error(C, reference());
}

// Within 1 % entry by entry, where sections taken as prismatic, station by station, are 3.6 % off:
// what remains is the taper and the ends.
static void tip_compliance(case_data *c, const section_result *r)
{
    const double turning = miss(&r->along);
    law_along prismatic = {0};
    CHECK_OK(law_along_make(c->length, r->along.npanel, r->along.nnode, &prismatic));
    for (int i = 0; i < r->along.npanel * r->along.nnode; i++) {
        // no length: no rate
        const double s = law_along_node(&r->along, i / r->along.nnode, i % r->along.nnode);
        CHECK_OK(section_solve(&c->file.section, c->materials, s, 0, &prismatic.law[i]));
        prismatic.turn[i] = r->along.turn[i];
        prismatic.law[i].K = beam_law_move(prismatic.law[i].K, 0, 0, prismatic.turn[i]);
    }
    const double without = miss(&prismatic);
    printf("tip compliance against 3D: %.4f, and %.4f as if prismatic\n", turning, without);
    CHECK_BELOW(turning, 0.01);
    CHECK_ABOVE(without, 0.03);
    law_along_free(&prismatic);
}

static beam_law solved(const case_data *c, double s, beam_centres *centres)
{
    beam_law law = {0};
    CHECK_OK(section_solve(&c->file.section, c->materials, s, c->length, &law));
    CHECK_OK(beam_law_centres(&law, centres));
    return law;
}

// K and the centre at places between the stations, and the centre's slope by differences of
// sections solved on either side
static void between_the_stations(const case_data *c, const section_result *r)
{
    const double L = c->length, h = 0.02 * L, size = 4 * mm;
    double K_miss = 0, centre_miss = 0, slope_miss = 0;
    for (int i = 1; i < 8; i++) {
        const double s = L * (i + 0.37) / 8.5;
        beam_centres at, side[4];
        mat6 K;
        const beam_law law = solved(c, s, &at);
        law_along_at(&r->along, s, &K, NULL);
        K_miss = fmax(K_miss, mat6_relative_error(K, law.K));
        for (int k = 0; k < 4; k++) {
            (void)solved(c, s + h * (k < 2 ? k - 2 : k - 1), &side[k]);
        }
        centre_frame f;
        law_along_centre_frame(&r->along, s, 0, &f);
        for (int d = 0; d < 2; d++) {
            const double x[4] = {side[0].stiffness_centre[d], side[1].stiffness_centre[d],
                                 side[2].stiffness_centre[d], side[3].stiffness_centre[d]};
            // order 4; what it leaves is (h pi / L)^4 / 30 of the slope, 5e-7
            const double slope = (8 * (x[2] - x[1]) - (x[3] - x[0])) / (12 * h);
            centre_miss = fmax(centre_miss, fabs(f.p[d] - at.stiffness_centre[d]) / size);
            slope_miss = fmax(slope_miss, fabs(f.dp[d] - slope) * L / size);
        }
    }
    printf(
        "from %d sections: K to %.1e, centre to %.1e of the radius, its slope to %.1e of radius / "
        "length\n",
        r->effort.nsolved, K_miss, centre_miss, slope_miss);
    CHECK_AT_MOST(r->effort.nsolved, 9);
    CHECK_BELOW(K_miss, 1e-6);
    CHECK_BELOW(centre_miss, 1e-6);
    CHECK_BELOW(slope_miss, 1e-5);
}

int main(void)
{
    against(BY_OTHER_CODE,
            "3D FEM of an independent code: curved high-order hexahedra, direct solver");
    case_data c = {0};
    section_result r = {0};
    open_case(&c);
    CHECK_OK(section_along(&c.file.section, c.materials, c.length, &r));
    tip_compliance(&c, &r);
    against(BY_SECOND_WAY, "sections solved between the stations");
    between_the_stations(&c, &r);
    section_result_free(&r);
    case_free(&c);
    return test_failures != 0;
}
