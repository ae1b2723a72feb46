// tests/verify/app/verify_rungs.c
// A clamped and capped bar of square section: what uniform meshes leave of the error of its
// compliance, what the rungs of the ladder leave, and whether they say so. docs/theory.md (5.15)
#include "fem/corner_strength.h"
#include "fem/rungs.h"
#include "fem/way.h"
#include "tests/shapes.h"
#include "tests/test.h"

#include <time.h>

static const double SIDE = 6e-3, LENGTH = 20e-3;
static const material RUBBER = {.name = "rubber", .E = 1e6, .nu = 0.3};

typedef struct solved {
    double stretch; // compliance [m/N]
    int nplane;
    double seconds;
} solved;

static double cpu_seconds(void)
{
    return (double)clock() / CLOCKS_PER_SEC;
}

static solved solve(const mesh_options *options, int order, int nlayer, const double *layer)
{
    solved s = {0};
    section_outline o = {0};
    mesh m = {0};
    body b = {0};
    way_run run = {0};
    const shape_spec shape = a_rectangle(SIDE, SIDE, 0, 0, 0, 0);
    const way_wants wants = {.middle = LENGTH / 2, .middle_half = LENGTH / 4};
    const double begin = cpu_seconds();
    CHECK_OK(shapes_at((shape_list){.count = 1, .items = &shape}, 0, &o));
    CHECK_OK(section_mesh_make(&o, options, &m));
    const body_spec spec = {
        .plane = &m, .materials = &RUBBER, .order = order, .nlayer = nlayer, .layer = layer};
    CHECK_OK(body_make(&spec, &b));
    const segment_problem p = {.body = &b, .base = BASE_CLAMPED, .tip = TIP_RIGID};
    CHECK_OK(way_doubling(&p, &wants, &run));
    if (run.motion) {
        s.stretch = run.motion[3 * run.nlevel - 1].a[2];
    }
    s.nplane = m.nnode;
    s.seconds = cpu_seconds() - begin;
    way_run_free(&run);
    body_free(&b);
    mesh_free(&m);
    section_outline_free(&o);
    return s;
}

static solved solve_rung(int rung, int kind)
{
    const segment_rung r = segment_rung_of(rung);
    const rung_body b = {LENGTH, SIDE / sqrt(2), BASE_CLAMPED, TIP_RIGID, 0};
    const mesh_options options = {
        .kind = kind, .order = r.plane_order, .edge_layers = 1, .edge_first = r.edge_first};
    int nlayer = 0;
    double *layer = NULL;
    CHECK_OK(segment_rung_layers(&r, &b, &nlayer, &layer));
    const solved s = solve(&options, r.order, nlayer, layer);
    free(layer);
    return s;
}

// equal elements of order 2, in layers as thick as they are wide
static solved solve_uniform(int parts)
{
    const mesh_options options = {.order = 2, .size = SIDE / parts};
    const int nlayer = (int)ceil(LENGTH * parts / SIDE);
    double layer[200];
    for (int i = 0; i <= nlayer; i++) {
        layer[i] = LENGTH * i / nlayer;
    }
    return solve(&options, 2, nlayer, layer);
}

static void tell(const char *what, int k, solved s, double exact)
{
    printf("%-8s %2d: %5d nodes of the section, compliance off by %8.1e, %.3f s\n", what, k,
           s.nplane, s.stretch / exact - 1, s.seconds);
}

// (element size)^(2 lambda), whatever the order
static void uniform_meshes_converge_as_the_clamped_edge_lets_them(double exact)
{
    double h[3], error[3];
    for (int k = 0; k < 3; k++) {
        const int parts = 4 << k;
        const solved s = solve_uniform(parts);
        h[k] = 1.0 / parts;
        error[k] = 1 - s.stretch / exact;
        tell("uniform", parts, s, exact);
    }
    const double wanted = 2 * corner_strength(RUBBER.nu);
    CHECK_WITHIN(log(error[0] / error[2]) / log(h[0] / h[2]), wanted, 0.12);
}

// every rung, from below, with an estimate that holds and is no more than ten times the error
static void rungs_leave_what_they_are_made_for(const double *value, int n, double exact)
{
    for (int k = 1; k < n; k++) {
        const double error = fabs(value[k] / exact - 1);
        const double told = segment_rung_error(k, RUBBER.nu, TIP_RIGID, k > 1 ? 3 : 2,
                                               value + (k > 1 ? k - 2 : 0)) /
                            exact;
        printf("rung %d: off by %.1e, estimate %.1e\n", k, error, told);
        CHECK_BELOW(value[k], exact);
        CHECK_AT_LEAST(told, error);
        CHECK_BELOW(told, 10 * error);
    }
    CHECK_BELOW(fabs(value[3] / exact - 1), 1e-5);
}

// the same rungs on triangles: layers pay there, too
static void free_meshes_climb_as_well(double exact)
{
    double error[2];
    for (int k = 0; k < 2; k++) {
        const solved s = solve_rung(2 * k, MESH_FREE);
        error[k] = fabs(s.stretch / exact - 1);
        tell("free", 2 * k, s, exact);
    }
    CHECK_BELOW(error[0], 2e-3);
    CHECK_BELOW(error[1], 1e-4);
}

int main(void)
{
    against(BY_SECOND_WAY, "the finest rung of the ladder, good to 2e-6");
    solved s[4];
    double value[4];
    const double exact = solve_rung(4, MESH_MAPPED).stretch; // to 2e-6, checked by the rungs below
    for (int k = 0; k < 4; k++) {
        s[k] = solve_rung(k, MESH_MAPPED);
        value[k] = s[k].stretch;
        tell("rung", k, s[k], exact);
    }
    rungs_leave_what_they_are_made_for(value, 4, exact);
    uniform_meshes_converge_as_the_clamped_edge_lets_them(exact);
    free_meshes_climb_as_well(exact);
    return test_failures != 0;
}
