// bench/bench_size.c
// CPU time and memory of one section against its size: an annulus with a stiff sector, quads cut
// into curved quadratic triangles.
//
//   bench_size [full | classical] [turn_rate_rad_per_m]    both without arguments
#include "base/memory.h"
#include "bench/bench.h"
#include "section/section.h"
#include "tests/shapes.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>

static const double pi = 3.14159265358979323846;

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
        const double begin = bench_cpu_ms();
        TRY(classical ? section_classical_mesh(&m, two, &out->law)
                      : section_turning_mesh(&m, two, rate, &out->law, NULL));
        out->seconds = fmin(out->seconds, 1e-3 * (bench_cpu_ms() - begin));
    }

done:
    mesh_free(&m);
    return st;
}

// three sizes, up to a million unknowns
static status table(bool classical, double rate, run r[3], double peak[3])
{
    status st = OK;
    static const int through[] = {6, 18, 55};
    printf("%s, turning at %g rad/m\n", classical ? "classical" : "full", rate);
    printf("%10s %10s %10s %14s %10s\n", "elements", "dofs", "CPU s", "peak so far MB",
           "GJ N mm^2");
    for (int k = 0; k < 3; k++) {
        beam_centres c = {0};
        TRY(solve(through[k], classical, rate, &r[k]));
        TRY(beam_law_centres(&r[k].law, &c));
        peak[k] = peak_mb();
        bench_point(classical ? "classical" : "full", r[k].dofs, r[k].seconds);
        printf("%10d %10d %10.4f %14.0f %10.5f\n", r[k].nelem, r[k].dofs, r[k].seconds, peak[k],
               1e6 * c.GJ);
    }

done:
    return st;
}

static int full_targets(const run r[3], const double peak[3])
{
    const double exponent = log(r[2].seconds / r[0].seconds) / log((double)r[2].dofs / r[0].dofs);
    return bench_target("18 thousand quadratic triangles, full 6x6", r[1].seconds, 0.8, "CPU s") +
           bench_target("their memory", peak[1], 500, "MB") +
           bench_target("a million unknowns", r[2].seconds, 15, "CPU s") +
           bench_target("their memory", peak[2], 6000, "MB") +
           bench_target("exponent of the cost from 13 thousand unknowns", exponent, 1.35, "");
}

int main(int argc, char **argv)
{
    const bool all = argc < 2, only_classical = !all && strcmp(argv[1], "classical") == 0;
    const double rate = argc > 2 ? strtod(argv[2], NULL) : 0;
    run r[3] = {0};
    double peak[3];
    int missed = 0;
    bench_axes("unknowns", "CPU time, s");
    bench_point("established FEniCS code", 106e3, 31); // and 1.4 GB
    if (!only_classical) {
        if (table(false, rate, r, peak) != OK) {
            printf("%s\n", status_message());
            return 1;
        }
        missed += full_targets(r, peak);
    }
    if (all || only_classical) {
        if (table(true, rate, r, peak) != OK) {
            printf("%s\n", status_message());
            return 1;
        }
        missed +=
            bench_target("18 thousand triangles, classical", 1e3 * r[1].seconds, 10, "CPU ms");
    }
    return missed > 0;
}
