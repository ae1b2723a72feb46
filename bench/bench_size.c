// bench/bench_size.c
// CPU time and memory of one section against its size: an annulus with a stiff sector, quads cut
// into curved quadratic triangles.
//
//   bench_size [full | classical] [turn_rate_rad_per_m]
#include "base/memory.h"
#include "section/section.h"
#include "tests/shapes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

static const double pi = 3.14159265358979323846;

static double cpu_s(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double peak_mb(void)
{
    struct rusage use;
    (void)getrusage(RUSAGE_SELF, &use);
    return (double)use.ru_maxrss / 1024;
}

// --- a closed strip of `around` x `through` cells, two triangles each, nodes on circles

typedef struct strip {
    int around, through;
} strip;

static int node_of(const strip *g, int i, int j)
{
    return j * 2 * g->around + i % (2 * g->around);
}

static void cut_cell(const strip *g, int a, int b, mesh_block *block)
{
    // lattice order of quadratic triangles: 3 + 2 + 1 nodes
    static const int lower[6][2] = {{0, 0}, {1, 0}, {2, 0}, {0, 1}, {1, 1}, {0, 2}};
    const int cell = b * g->around + a;
    for (int half = 0; half < 2; half++) {
        const int e = 2 * cell + half;
        for (int k = 0; k < 6; k++) {
            const int i = half ? 2 - lower[k][0] : lower[k][0];
            const int j = half ? 2 - lower[k][1] : lower[k][1];
            block->conn[6 * e + k] = node_of(g, 2 * a + i, 2 * b + j);
        }
        block->material[e] = fabs(a + 0.5 - g->around / 2.0) < g->around / 32.0;
    }
}

static status make_mesh(const strip *g, mesh *out)
{
    status st = OK;
    mesh m = {0};
    const shape triangle = SHAPE_TRIANGLE;
    const int nelem = 2 * g->around * g->through, nnode = 2 * g->around * (2 * g->through + 1);
    TRY(mesh_make(2, nnode, 1, &triangle, &nelem, &m));
    for (int j = 0; j <= 2 * g->through; j++) {
        for (int i = 0; i < 2 * g->around; i++) {
            const double angle = pi * i / g->around, r = 3.2e-3 + 0.4e-3 * j / g->through;
            double *at = m.xyz + 3 * node_of(g, i, j);
            // counter-clockwise triangles: i runs against the angle
            at[0] = r * cos(angle);
            at[1] = -r * sin(angle);
        }
    }
    for (int b = 0; b < g->through; b++) {
        for (int a = 0; a < g->around; a++) {
            cut_cell(g, a, b, &m.block[0]);
        }
    }
    TRY(mesh_check(&m));
    *out = m;
    m = (mesh){0};

done:
    mesh_free(&m);
    return st;
}

// --- table

typedef struct run {
    int nelem, dofs;
    double seconds;
    beam_law law;
} run;

static status solve(int through, bool classical, double rate, run *out)
{
    status st = OK;
    static const material two[] = {{.E = 0.66e6, .nu = 0.3}, {.E = 15.93e6, .nu = 0.3}};
    const strip g = {.around = 28 * through, .through = through};
    mesh m = {0};
    TRY(make_mesh(&g, &m));
    out->nelem = m.block[0].nelem;
    out->dofs = 3 * m.nnode;
    out->seconds = INFINITY;
    for (int i = 0; i < (through < 40 ? 3 : 1); i++) {
        const double begin = cpu_s();
        TRY(classical ? section_classical_mesh(&m, two, &out->law)
                      : section_turning_mesh(&m, two, rate, &out->law, NULL));
        out->seconds = fmin(out->seconds, cpu_s() - begin);
    }

done:
    mesh_free(&m);
    return st;
}

int main(int argc, char **argv)
{
    const bool classical = argc > 1 && strcmp(argv[1], "classical") == 0;
    const double rate = argc > 2 ? strtod(argv[2], NULL) : 0;
    static const int through[] = {6, 18, 55};
    run r[3] = {0};
    printf("%s, turning at %g rad/m\n", classical ? "classical" : "full", rate);
    printf("%10s %10s %10s %14s %10s\n", "elements", "dofs", "CPU s", "peak so far MB",
           "GJ N mm^2");
    for (int k = 0; k < 3; k++) {
        beam_centres c = {0};
        if (solve(through[k], classical, rate, &r[k]) != OK ||
            beam_law_centres(&r[k].law, &c) != OK) {
            printf("%s\n", status_message());
            return 1;
        }
        printf("%10d %10d %10.4f %14.0f %10.5f\n", r[k].nelem, r[k].dofs, r[k].seconds, peak_mb(),
               1e6 * c.GJ);
    }
    printf("cost exponent from %d to %d dofs: %.3f\n", r[0].dofs, r[2].dofs,
           log(r[2].seconds / r[0].seconds) / log((double)r[2].dofs / r[0].dofs));
    return 0;
}
