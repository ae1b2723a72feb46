// bench/bench_segment_size.c
// The iterative way against size: CPU time, memory and iterations for the six unit wrenches on the
// segment of Fig. 4, its mesh refined alike in all directions and graded to both ends.
//
//   bench_segment_size [million unknowns...]    0.1 0.3 1 3 without arguments
#include "bench/bench.h"
#include "fem/way.h"
#include "tests/verify/fem/polar_mesh.h"

#include <sys/resource.h>

static const material two[2] = {{.E = 0.66e6, .nu = 0.3}, {.E = 15.93e6, .nu = 0.3}};

// limits of the table, for one million
static const double LIMIT_SECONDS = 90, LIMIT_GB = 8, LIMIT_GROWTH = 1.3;

enum { MOST_LAYERS = 1000 };

static double peak_gb(void)
{
    struct rusage use;
    (void)getrusage(RUSAGE_SELF, &use);
    return (double)use.ru_maxrss / 1024 / 1024;
}

// proportions of fig4_segment, its size by the elements across the wall
static polar_segment sized(double across)
{
    polar_segment s = fig4_segment();
    s.radial = (int)fmax(1, round(across));
    s.soft = (int)round(20 * across);
    s.stiff = (int)fmax(2, round(3 * across));
    s.layers = (int)round(14 * across);
    return s;
}

static double dofs_of(const polar_segment *s)
{
    const double p = s->order;
    return 3 * p * (s->soft + s->stiff) * (p * s->radial + 1) * (p * s->layers - 1) + 6;
}

static polar_segment of_size(double dofs)
{
    double across = 0.5;
    polar_segment s = sized(across);
    while (dofs_of(&s) < dofs) {
        across += 0.02;
        s = sized(across);
    }
    return s;
}

static status measure(double million, way_run *run, double *seconds)
{
    status st = OK;
    const polar_segment s = of_size(million * 1e6);
    mesh plane = {0};
    body b = {0};
    double *level = NULL, layer[MOST_LAYERS + 1];
    if (s.layers > MOST_LAYERS) {
        TRY(status_fail(ERR_INPUT, "more layers than this program has room for"));
    }
    TRY(TAKE(level, (size_t)(s.layers * s.order + 1)));
    TRY(polar_mesh(&s, &plane));
    graded_levels(s.layers, s.order, s.grading, s.length, level);
    for (int k = 0; k <= s.layers; k++) {
        layer[k] = level[k * s.order];
    }
    const double begin = bench_cpu_ms();
    const body_spec spec = {
        .plane = &plane, .materials = two, .order = s.order, .nlayer = s.layers, .layer = layer};
    TRY(body_make(&spec, &b));
    const segment_problem p = {.body = &b, .base = BASE_CLAMPED, .tip = TIP_RIGID};
    const way_wants wants = {.middle = s.length / 2, .middle_half = s.length / 8};
    TRY(way_iterative(&p, &wants, run));
    *seconds = 1e-3 * (bench_cpu_ms() - begin);
    printf("%10lld %8d %8d %10d %10.1e %9.2f %9.2f %9.2f %9.2f %8.2f\n", run->dofs, plane.nnode,
           b.nlevel, run->iterations, run->residual, run->assemble_seconds, run->factor_seconds,
           run->solve_seconds, *seconds, peak_gb());
    (void)fflush(stdout);

done:
    free(level);
    body_free(&b);
    mesh_free(&plane);
    return st;
}

int main(int argc, char **argv)
{
    static const double sizes[] = {0.1, 0.3, 1, 3};
    const int n = argc > 1 ? argc - 1 : 4;
    int fails = 0, first = 0;
    printf("%10s %8s %8s %10s %10s %9s %9s %9s %9s %8s\n", "dofs", "plane", "levels", "iterations",
           "residual", "set up s", "factor s", "solve s", "CPU s", "peak GB");
    bench_axes("unknowns", "CPU time of six columns [s]");
    for (int i = 0; i < n; i++) {
        const double million = argc > 1 ? atof(argv[i + 1]) : sizes[i];
        way_run run = {0};
        double seconds = 0;
        if (measure(million, &run, &seconds) != OK) {
            printf("FAIL  %g million unknowns: %s\n", million, status_message());
            return 1;
        }
        bench_point("iterative", (double)run.dofs, seconds);
        if (million == 1) {
            fails += bench_target("six columns of 1 M unknowns, CPU", seconds, LIMIT_SECONDS, "s");
            fails += bench_target("memory of 1 M unknowns", peak_gb(), LIMIT_GB, "GB");
        }
        first = i == 0 ? run.iterations : first;
        if (n > 1 && i == n - 1) {
            fails += bench_target("iterations, largest over smallest",
                                  (double)run.iterations / first, LIMIT_GROWTH, "");
        }
        way_run_free(&run);
    }
    return fails + test_failures > 0;
}
