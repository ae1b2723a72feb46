// bench/bench_along.c
// Sections along the helical prototype, full model: how many are solved for K(s), the stiffness
// centre and its derivative to a tolerance. The reference has a finer mesh and tighter stations.
#include "bench/bench.h"
#include "section/section.h"
#include "tests/shapes.h"

#include <math.h>

enum { POINTS = 97, MOST_SOLVES = 9 };

static const double length = 0.12, outer = 4e-3, inner = 3.2e-3;
static const double wanted = 1e-6;
static const mesh_options fine = {.order = 4, .finer = 2, .layers = 2};

static const material materials[] = {{.E = 0.66e6, .nu = 0.3}, {.E = 15.93e6, .nu = 0.3}};

// the strip turns by 180 degrees and gets narrower
static double middle(const void *none, double s)
{
    (void)none;
    return PI * s / length;
}

static double width(const void *none, double s)
{
    (void)none;
    return PI / 4 - PI / 8 * s / length;
}

typedef struct run {
    section_result result;
    double ms;
} run;

// tolerance 0: as close as the sections are, on the mesh of `mesh`
static status solve(double tolerance, const mesh_options *mesh, run *out)
{
    status st = OK;
    shape_spec shapes[2] = {an_annulus(outer, inner, 0), a_sector(outer, inner, 0, 1, 1)};
    section_case c = section_case_default();
    shapes[1].sector.mid_angle = (field){.at = middle};
    shapes[1].sector.width = (field){.at = width};
    c.shapes = (key_list){.count = 2, .items = shapes};
    c.nmaterial = 2;
    c.tolerance = tolerance;
    c.mesh = mesh ? *mesh : c.mesh;
    const double begin = bench_cpu_ms();
    TRY(section_along(&c, materials, length, &out->result));
    out->ms = bench_cpu_ms() - begin;

done:
    return st;
}

typedef struct errors {
    double K, centre, slope;
} errors;

// slopes are measured on the largest one, centres on the radius
static errors errors_of(const law_along *along, const law_along *truth)
{
    errors worst = {0};
    double steepest = 0, phi[2] = {0, 0};
    for (int i = 0; i < POINTS; i++) {
        const double s = length * i / (POINTS - 1);
        mat6 K[2];
        centre_frame f[2];
        law_along_at(along, s, &K[0], NULL);
        law_along_at(truth, s, &K[1], NULL);
        law_along_centre_frame(along, s, phi[0], &f[0]);
        law_along_centre_frame(truth, s, phi[1], &f[1]);
        phi[0] = f[0].phi;
        phi[1] = f[1].phi;
        worst.K = fmax(worst.K, mat6_relative_error(K[0], K[1]));
        worst.centre =
            fmax(worst.centre, hypot(f[0].p[0] - f[1].p[0], f[0].p[1] - f[1].p[1]) / outer);
        worst.slope = fmax(worst.slope, hypot(f[0].dp[0] - f[1].dp[0], f[0].dp[1] - f[1].dp[1]));
        steepest = fmax(steepest, hypot(f[1].dp[0], f[1].dp[1]));
    }
    worst.slope /= steepest;
    return worst;
}

static double worst_of(errors e)
{
    return fmax(e.K, fmax(e.centre, e.slope));
}

// *fewest: solves of the first run whose errors are all within what is wanted
static status table(double *fewest, double *error)
{
    status st = OK;
    run truth = {0}, r = {0};
    TRY(solve(0, &fine, &truth));
    printf("helical prototype, 120 mm, full; reference: %d solved, %.0f ms\n%10s %7s %9s %9s %9s "
           "%9s\n",
           truth.result.effort.nsolved, truth.ms, "tolerance", "solved", "K", "centre", "its slope",
           "CPU ms");
    for (double tolerance = 1e-3; tolerance > 3e-8; tolerance /= 10) {
        section_result_free(&r.result);
        TRY(solve(tolerance, NULL, &r));
        const errors e = errors_of(&r.result.along, &truth.result.along);
        printf("%10.0e %7d %9.1e %9.1e %9.1e %9.1f\n", tolerance, r.result.effort.nsolved, e.K,
               e.centre, e.slope, r.ms);
        bench_point("helical prototype, all of K(s), NC, NC'", r.ms, worst_of(e));
        if (tolerance < 2 * wanted && isinf(*fewest)) {
            *fewest = r.result.effort.nsolved;
            *error = worst_of(e);
        }
    }

done:
    section_result_free(&r.result);
    section_result_free(&truth.result);
    return st;
}

int main(void)
{
    double fewest = INFINITY, error = INFINITY;
    if (table(&fewest, &error) != OK) {
        printf("error: %s\n", status_message());
        return 1;
    }
    const int missed =
        bench_target("section solves for a tolerance of 1e-6", fewest, MOST_SOLVES, "solves") +
        bench_target("largest error of K(s), NC and NC' there", error, wanted, "relative");
    return missed > 0;
}
