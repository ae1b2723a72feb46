// bench/bench_segment_size.c
// The iterative way against size: CPU time, memory and iterations for the six unit wrenches on the
// segment of Fig. 4, its mesh refined alike in all directions and graded to both ends; and on a
// stack of cubes whose stiff sector turns from layer to layer, with a matrix and multigrid.
//
//   bench_segment_size [body | stack [million unknowns...]]    both without arguments
//
// Under mpirun the first rank tells its own CPU time and memory, and the wall's.
#include "bench/bench.h"
#include "fem/way.h"
#include "tests/verify/fem/polar_mesh.h"

#include <sys/resource.h>

static const material two[2] = {{.E = 0.66e6, .nu = 0.3}, {.E = 15.93e6, .nu = 0.3}};

// limits of the table, for one million
static const double LIMIT_SECONDS = 90, LIMIT_GB = 8, LIMIT_GROWTH = 1.3;

enum { MOST_LAYERS = 1000 };

static double wall_seconds(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double peak_gb(void)
{
    struct rusage use;
    (void)getrusage(RUSAGE_SELF, &use);
    return (double)use.ru_maxrss / 1024 / 1024;
}

// proportions of fig4_segment, its size by the elements across the wall; a stack's are cubes
static polar_segment sized(double across, bool stack)
{
    polar_segment s = fig4_segment();
    s.radial = (int)fmax(1, round(across));
    s.soft = (int)round((stack ? 26 : 20) * across);
    s.stiff = (int)fmax(2, round((stack ? 2 : 3) * across));
    s.layers = (int)round((stack ? 25 : 14) * across);
    s.order = stack ? 1 : s.order;
    s.grading = stack ? 1 : s.grading;
    return s;
}

static double dofs_of(const polar_segment *s)
{
    const double p = s->order;
    return 3 * p * (s->soft + s->stiff) * (p * s->radial + 1) * (p * s->layers - 1) + 6;
}

static polar_segment of_size(double dofs, bool stack)
{
    double across = 0.5;
    polar_segment s = sized(across, stack);
    while (dofs_of(&s) < dofs) {
        across += 0.02;
        s = sized(across, stack);
    }
    return s;
}

// the stiff sector turns once over the whole length
static void make_matter(const polar_segment *s, int *matter)
{
    const int around = s->soft + s->stiff;
    for (int layer = 0; layer < s->layers; layer++) {
        for (int e = 0; e < around * s->radial; e++) {
            const int turned = (e / s->radial + layer * around / s->layers) % around;
            *matter++ = turned < s->stiff;
        }
    }
}

static status measure(double million, bool stack, way_run *run, double *seconds)
{
    status st = OK;
    const polar_segment s = of_size(million * 1e6, stack);
    mesh plane = {0};
    body b = {0};
    double *level = NULL, layer[MOST_LAYERS + 1];
    int *matter = NULL;
    if (s.layers > MOST_LAYERS) {
        TRY(status_fail(ERR_INPUT, "more layers than this program has room for"));
    }
    TRY(TAKE(level, (size_t)(s.layers * s.order + 1)));
    TRY(polar_mesh(&s, &plane));
    graded_levels(s.layers, s.order, s.grading, s.length, level);
    for (int k = 0; k <= s.layers; k++) {
        layer[k] = level[k * s.order];
    }
    TRY(TAKE(matter, (size_t)s.layers * (size_t)plane.block[0].nelem));
    make_matter(&s, matter);
    const double begin = bench_cpu_ms(), wall = wall_seconds();
    const body_spec spec = {
        .plane = &plane, .materials = two, .order = s.order, .nlayer = s.layers, .layer = layer};
    TRY(body_make(&spec, &b));
    const segment_problem p = {.body = &b, .base = BASE_CLAMPED, .tip = TIP_RIGID};
    const way_wants wants = {.middle = s.length / 2, .middle_half = s.length / 8};
    TRY(way_iterative(&p, &wants, run));
    *seconds = 1e-3 * (bench_cpu_ms() - begin);
    if (segment_rank() == 0) {
        printf("%10lld %8d %8d %10d %10.1e %9.2f %9.2f %9.2f %9.2f %8.2f %8.2f\n", run->dofs,
               plane.nnode, b.nlevel, run->iterations, run->residual, run->assemble_seconds,
               run->factor_seconds, run->solve_seconds, *seconds, peak_gb(), wall_seconds() - wall);
        (void)fflush(stdout);
    }

done:
    free(level);
    free(matter);
    body_free(&b);
    mesh_free(&plane);
    return st;
}

static int table(bool stack, int n, const double *million)
{
    int fails = 0, first = 0;
    const char *name = stack ? "stack" : "body";
    if (segment_rank() == 0) {
        printf("%s\n%10s %8s %8s %10s %10s %9s %9s %9s %9s %8s %8s\n", name, "dofs", "plane",
               "levels", "iterations", "residual", "set up s", "factor s", "solve s", "CPU s",
               "peak GB", "wall s");
    }
    for (int i = 0; i < n; i++) {
        way_run run = {0};
        double seconds = 0;
        if (measure(million[i], stack, &run, &seconds) != OK) {
            printf("FAIL  %s, %g million unknowns: %s\n", name, million[i], status_message());
            return 1;
        }
        first = i == 0 ? run.iterations : first;
        if (getenv("OMPI_COMM_WORLD_SIZE")) {
            way_run_free(&run); // no verdicts: bench.sh compares ranks
            continue;
        }
        bench_point(name, (double)run.dofs, seconds);
        if (million[i] == 1) {
            printf("%s, 1 M unknowns, six columns:\n", name);
            fails += bench_target("CPU", seconds, LIMIT_SECONDS, "s");
            fails += bench_target("memory", peak_gb(), LIMIT_GB, "GB");
        }
        if (n > 1 && i == n - 1) {
            printf("%s, ", name);
            fails += bench_target("iterations of the largest over the smallest",
                                  (double)run.iterations / first, LIMIT_GROWTH, "");
        }
        way_run_free(&run);
    }
    return fails;
}

int main(int argc, char **argv)
{
    static const double sizes[] = {0.1, 0.3, 1, 3};
    double asked[8];
    int n = 0, fails = 0;
    for (int i = 2; i < argc && n < 8; i++) {
        asked[n++] = atof(argv[i]);
    }
    bench_axes("unknowns", "CPU time of six columns [s]");
    for (int stack = 0; stack < 2; stack++) {
        const bool wanted = argc < 2 || strcmp(argv[1], stack ? "stack" : "body") == 0;
        fails += !wanted ? 0 : table(stack, n > 0 ? n : stack ? 3 : 4, n > 0 ? asked : sizes);
    }
    return fails + test_failures > 0;
}
