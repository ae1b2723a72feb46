// bench/bench_section.c
// CPU time against error of the full 6x6: the constant-NC section on mapped meshes, one
// factorization each. The reference is a mesh two levels finer than the finest row.
#include "base/memory.h"
#include "section/section.h"
#include "tests/shapes.h"

#include <stdio.h>
#include <time.h>

static const double pi = 3.14159265358979323846;

static double cpu_ms(void)
{
    struct timespec t;
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

typedef struct run {
    beam_law law;
    int nnode;
    double mesh_ms, full_ms;
} run;

static status solve(int order, double size, int repeats, run *out)
{
    status st = OK;
    const material materials[] = {{.E = 0.66e6, .nu = 0.3}, {.E = 15.93e6, .nu = 0.3}};
    const shape_spec shapes[] = {an_annulus(4e-3, 3.2e-3, 0),
                                 a_sector(4e-3, 3.2e-3, pi, pi / 8, 1)};
    const mesh_options options = {.kind = MESH_MAPPED, .order = order, .size = size};
    section_outline o = {0};
    mesh m = {0};

    TRY(shapes_at((shape_list){.count = 2, .items = shapes}, 0, &o));
    const double begin = cpu_ms();
    for (int i = 0; i < repeats; i++) {
        mesh_free(&m);
        TRY(section_mesh_make(&o, &options, &m));
    }
    const double meshed = cpu_ms();
    for (int i = 0; i < repeats; i++) {
        TRY(section_full_mesh(&m, materials, &out->law, NULL));
    }
    out->full_ms = (cpu_ms() - meshed) / repeats;
    out->mesh_ms = (meshed - begin) / repeats;
    out->nnode = m.nnode;

done:
    mesh_free(&m);
    section_outline_free(&o);
    return st;
}

static status table(void)
{
    status st = OK;
    static const double sizes_mm[] = {0, 0.8, 0.4, 0.2};
    run reference = {0}, r = {0};
    TRY(solve(4, 0.05e-3, 1, &reference));
    printf(" order  size mm   nodes      error   mesh ms   full ms   (size 0: chosen, graded)\n");
    for (int order = 1; order <= 4; order++) {
        for (int i = 0; i < 4; i++) {
            TRY(solve(order, 1e-3 * sizes_mm[i], 5, &r));
            printf("%6d %8.2f %7d %10.2e %9.3f %9.3f\n", order, sizes_mm[i], r.nnode,
                   mat6_relative_error(r.law.K, reference.law.K), r.mesh_ms, r.full_ms);
        }
    }

done:
    return st;
}

int main(void)
{
    if (table() != OK) {
        printf("error: %s\n", status_message());
        return 1;
    }
    return 0;
}
