// tests/verify/app/verify_paper.c
// What the paper's figures 4, 7 and 8 show, by the case files of cases/ and the whole chain.
#include "app/chain.h"
#include "app/compare.h"

#include "tests/test.h"

#include <string.h>

static const double degrees = 180 / M_PI;

// runs the parts of cases/NAME.yaml; the case must outlive the result
static void run_case(const char *name, int noverride, const char *const *overrides,
                     chain_parts parts, case_data *c, run_result *r)
{
    char path[4096];
    const command cmd = {.quiet = true, .first_rank = true};
    const char *source = getenv("STIFFAXIS_SOURCE");
    (void)snprintf(path, sizeof path, "%s/cases/%s.yaml", source ? source : ".", name);
    const case_request request = {.path = path, .noverride = noverride, .overrides = overrides};
    if (case_open(&request, c) != OK || chain_run(&cmd, c, parts, r) != OK) {
        printf("%s\n", status_message());
        exit(1);
    }
}

static void done(case_data *c, run_result *r)
{
    run_result_free(r);
    case_free(c);
}

static const char *const paper_model[] = {"section.model=classical", "materials.soft.nu=0.45",
                                          "materials.stiff.nu=0.45"};

// Fig. 7: the tendon on the soft side bends the rod by 226 deg, the one on the stiff side by 58
// deg. The tolerance is half of the last digit that paper.md tells.
static void fig_7_bends_by_226_and_58_degrees(int noverride)
{
    case_data c = {0};
    run_result r = {0};
    run_case("constant_nc", noverride, paper_model, (chain_parts){.rod = true}, &c, &r);
    CHECK(r.rod.nsolution == 6);
    const struct rod_run *soft = &r.rod.run[2], *stiff = &r.rod.run[5];
    CHECK(soft->tension[0] == 0.98 && stiff->tension[1] == 0.98);
    CHECK_WITHIN(degrees * soft->total_bend_rad, 226, 0.5);
    CHECK_WITHIN(degrees * stiff->total_bend_rad, 58, 0.5);
    // in the plane of symmetry, to opposite sides
    CHECK_WITHIN(soft->tip.p.a[1], 0, 1e-12);
    CHECK_ABOVE(r.rod.run[0].tip.p.a[0], 0);
    CHECK_BELOW(stiff->tip.p.a[0], 0);
    // beyond the 5 % up to which the materials are close to linear
    CHECK_ABOVE(soft->largest_strain, 0.05);
    done(&c, &r);
}

// Fig. 8: at 0.98 N the curvature's size falls from 37.5 to 6.2 1/m near the middle and rises to
// 45, and one of its components changes sign at L/2
static void fig_8_is_nearly_straight_in_the_middle(void)
{
    case_data c = {0};
    run_result r = {0};
    run_case("helical_nc", 0, NULL, (chain_parts){.rod = true}, &c, &r);
    const struct rod_run *run = &r.rod.run[2];
    const int n = r.rod.npoint;
    int least = 0, changes = 0;
    double change_at = 0;
    CHECK(run->tension[0] == 0.98);
    for (int i = 0; i < n; i++) {
        const double *k = run->curvature[i], *low = run->curvature[least];
        least = hypot(k[0], k[1]) < hypot(low[0], low[1]) ? i : least;
        if (i > 0 && (k[1] > 0) != (run->curvature[i - 1][1] > 0)) {
            changes++;
            change_at = 0.5 * (run->s[i] + run->s[i - 1]);
        }
    }
    printf("Fig. 8: curvature %.2f, %.3f at s/L = %.3f, %.2f 1/m; sign change at s/L = %.3f\n",
           hypot(run->curvature[0][0], run->curvature[0][1]),
           hypot(run->curvature[least][0], run->curvature[least][1]), run->s[least] / r.rod_length,
           hypot(run->curvature[n - 1][0], run->curvature[n - 1][1]), change_at / r.rod_length);
    CHECK_WITHIN(hypot(run->curvature[0][0], run->curvature[0][1]), 37.5, 0.05);
    CHECK_WITHIN(hypot(run->curvature[least][0], run->curvature[least][1]), 6.2, 0.05);
    CHECK_WITHIN(hypot(run->curvature[n - 1][0], run->curvature[n - 1][1]), 45, 0.5);
    CHECK_WITHIN(run->s[least] / r.rod_length, 0.5, 0.05);
    // after the base, where the component is 0 by symmetry, it changes sign once
    const double step = r.rod_length / (n - 1);
    CHECK_AT_LEAST(changes, 1);
    CHECK_WITHIN(change_at, 0.5 * r.rod_length, step);
    done(&c, &r);
}

// Fig. 4 by the linear theory that the paper used, against the independent 3D FEM of physics.md,
// section 5, within 0.3 %
static void fig_4_bends_at_gc_and_compresses_at_nc(void)
{
    case_data c = {0};
    run_result r = {0};
    run_case("fig4", 0, NULL, (chain_parts){.segment = true, .compare = true}, &c, &r);
    CHECK(r.segment.nload == 2);
    const segment_load_result *gc = &r.segment.load[0], *nc = &r.segment.load[1];
    CHECK_NEAR(gc->tip_displacement[2], -0.59999e-3, 3e-3);
    CHECK_NEAR(degrees * gc->tip_rotation[1], 7.048, 3e-3);
    CHECK_NEAR(gc->mid_curvature[1], 6.232, 3e-3);
    // the section's own NC is where the load is applied
    CHECK_NEAR(nc->point[0], -2.1233e-3, 1e-4);
    CHECK_NEAR(nc->shortening, 0.3397e-3, 3e-3);
    const double *tilt = nc->tip_rotation;
    CHECK_BELOW(degrees * sqrt(tilt[0] * tilt[0] + tilt[1] * tilt[1] + tilt[2] * tilt[2]), 0.1);
    // no end condition gives the paper's 10.7 deg: the section's EI / EA is 5.83 mm^2 where it
    // would take 7.11
    const beam_centres *centres = &r.section.station[0].centres;
    CHECK_NEAR(centres->EI[1] / centres->EA, 5.83e-6, 1e-3);
    // and every way to each number agrees
    CHECK_ABOVE(r.ncompare, 10);
    CHECK_OK(compare_verdict(&r));
    done(&c, &r);
}

// as Fig. 4 with nu = 0.45, where the clamped end contracts more
static void fig_4_holds_for_soft_rubber_too(void)
{
    case_data c = {0};
    run_result r = {0};
    run_case("fig4", 2, paper_model + 1, (chain_parts){.segment = true}, &c, &r);
    const segment_load_result *nc = &r.segment.load[1];
    CHECK_NEAR(nc->shortening, 0.3353e-3, 4e-3); // the reference is good to 1e-3
    CHECK_BELOW(degrees * fabs(nc->tip_rotation[1]), 0.1);
    done(&c, &r);
}

// --- tips of the classical section with nu = 0.45 by another solver, good to 1e-11 m

typedef struct known_tip {
    const char *name;
    double tension[2], tip[3];
} known_tip;

static const known_tip known_tips[] = {
    {"constant_nc", {0.49, 0}, {0.08028418628221297, 0, 0.05294104438628274}},
    {"constant_nc", {0, 0.49}, {-0.02969691042957603, 0, 0.11397934811276046}},
    {"constant_nc", {0.98, 0}, {0.04600661601636546, 0, -0.019715267641886875}},
    {"constant_nc", {0, 0.98}, {-0.055183595642014256, 0, 0.09871079721865669}},
    {"helical_nc", {0.98}, {-0.03127907696297282, 0.08485895950768964, 0.02897760051018824}},
    {"helical_nc", {1.96}, {-0.005438892654100678, 0.03703327984881886, -0.036215048325144994}},
};
enum { KNOWN_TIPS = sizeof known_tips / sizeof *known_tips };

static double distance(vec3 a, vec3 b)
{
    return vec3_norm(vec3_sub(a, b));
}

static const struct rod_run *run_with(const run_result *r, const double tension[2])
{
    for (int i = 0; i < r->rod.nsolution; i++) {
        const struct rod_run *run = &r->rod.run[i];
        if (run->tension[0] == tension[0] &&
            (r->rod.ntendon < 2 || run->tension[1] == tension[1])) {
            return run;
        }
    }
    printf("no solution for %g N, %g N\n", tension[0], tension[1]);
    exit(1);
}

// the case in both frames, with overrides before the frame's own
static void run_frames(const char *name, int noverride, const char *const *overrides,
                       case_data c[2], run_result r[2])
{
    const char *all[8];
    for (int i = 0; i < noverride; i++) {
        all[i] = overrides[i];
    }
    for (int k = 0; k < 2; k++) {
        all[noverride] = k == 0 ? "rod.frame=gc" : "rod.frame=nc";
        run_case(name, noverride + 1, all, (chain_parts){.rod = true}, &c[k], &r[k]);
    }
}

static void frames_agree(const run_result r[2])
{
    double apart = 0;
    CHECK_ABOVE(r[0].rod.nsolution, 0);
    CHECK(r[0].rod.nsolution == r[1].rod.nsolution);
    for (int i = 0; i < r[0].rod.nsolution; i++) {
        apart = fmax(apart, distance(r[0].rod.run[i].tip.p, r[1].rod.run[i].tip.p));
    }
    printf("%d tips, GC and NC %.1e m apart\n", r[0].rod.nsolution, apart);
    CHECK_AT_MOST(apart, 1e-12);
}

static void tips_of_the_paper_model(const char *name)
{
    const char *overrides[] = {paper_model[0], paper_model[1], paper_model[2],
                               "section.tolerance=1e-12", "rod.tolerance=1e-12"};
    case_data c[2] = {0};
    run_result r[2] = {0};
    run_frames(name, 5, overrides, c, r);
    frames_agree(r);
    for (int k = 0; k < KNOWN_TIPS; k++) {
        const known_tip *known = &known_tips[k];
        if (strcmp(known->name, name) != 0) {
            continue;
        }
        const vec3 wanted = {{known->tip[0], known->tip[1], known->tip[2]}};
        for (int frame = 0; frame < 2; frame++) {
            const struct rod_run *run = run_with(&r[frame], known->tension);
            CHECK_WITHIN(distance(run->tip.p, wanted), 0, 1e-9);
        }
    }
    for (int k = 0; k < 2; k++) {
        done(&c[k], &r[k]);
    }
}

// Twice the printed width: at theta_w = 0.443 pi, s/L = 0.23, the two bending moments are equal,
// and only the declared axis tells the stiffness-centre frame where to go
static void frames_agree_where_moments_cross(const char *model)
{
    const char *overrides[] = {model, "rod.tolerance=1e-12",
                               "rod.tensions_N=[[0.49], [0.98], [1.96]]"};
    case_data c[2] = {0};
    run_result r[2] = {0};
    run_frames("helical_nc_halfwidth", 3, overrides, c, r);
    const section_result *section = &r[1].section;
    const beam_centres *base = &section->station[0].centres;
    const beam_centres *tip = &section->station[section->nstation - 1].centres;
    CHECK_ABOVE(base->EI[0], base->EI[1]);
    CHECK_BELOW(tip->EI[0], tip->EI[1]);
    frames_agree(r);
    for (int k = 0; k < 2; k++) {
        done(&c[k], &r[k]);
    }
}

int main(void)
{
    against(BY_PUBLISHED, "the paper's Fig. 7, in digits of half the last place told");
    fig_7_bends_by_226_and_58_degrees(3);
    fig_7_bends_by_226_and_58_degrees(0);
    against(BY_OTHER_CODE, "rods of an independent code, good to 1e-11 m");
    tips_of_the_paper_model("constant_nc");
    tips_of_the_paper_model("helical_nc");
    against(BY_SECOND_WAY, "the frame of the stiffness centre against that of the geometric one");
    frames_agree_where_moments_cross("section.model=classical");
    frames_agree_where_moments_cross("section.model=full");
    against(BY_PUBLISHED, "the paper's Fig. 8");
    fig_8_is_nearly_straight_in_the_middle();
    against(BY_OTHER_CODE,
            "3D FEM of an independent code: curved high-order hexahedra, direct solver");
    fig_4_bends_at_gc_and_compresses_at_nc();
    fig_4_holds_for_soft_rubber_too();
    return test_failures != 0;
}
