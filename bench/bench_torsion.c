// bench/bench_torsion.c
// CPU time against error of GJ where corners decide: a rectangle, against Saint-Venant's series,
// and an L whose re-entrant corner makes uniform meshes converge slowly. Meshing counts.
#include "bench/bench.h"
#include "section/section.h"
#include "tests/shapes.h"

#include <math.h>

static const material unit = {.E = 1e6, .nu = 0.3};
static const double limit = 200; // [ms]

// the L's figure [N mm^2] and what its digits leave open
static const double L_GJ = 1.87017, L_open = 2e-5;
static const double rectangle_wanted = 1e-8;

// GJ of width a over height b by Saint-Venant's series [N m^2]
static double rectangle_GJ(double a, double b)
{
    double sum = 0;
    for (int n = 1; n < 200; n += 2) {
        sum += tanh(n * PI * a / (2 * b)) / pow(n, 5);
    }
    return material_shear_modulus(&unit) * a * pow(b, 3) *
           (1.0 / 3 - 64 * b / (pow(PI, 5) * a) * sum);
}

typedef struct bar {
    const char *name;
    shape_spec shape;
    double exact; // [N m^2]
} bar;

static status solve(const bar *b, const mesh_options *options, double *GJ, double *ms, int *nnode)
{
    status st = OK;
    section_outline o = {0};
    mesh m = {0};
    beam_law law = {0};
    beam_centres centres = {0};
    *ms = INFINITY;
    TRY(shapes_at((shape_list){.count = 1, .items = &b->shape}, 0, &o));
    for (int i = 0; i < 3; i++) {
        mesh_free(&m);
        const double begin = bench_cpu_ms();
        TRY(section_mesh_make(&o, options, &m));
        TRY(section_full_mesh(&m, &unit, &law, NULL));
        TRY(beam_law_centres(&law, &centres));
        *ms = fmin(*ms, bench_cpu_ms() - begin);
    }
    *GJ = centres.GJ;
    *nnode = m.nnode;

done:
    mesh_free(&m);
    section_outline_free(&o);
    return st;
}

static status row(const bar *b, const mesh_options *options, const char *kind, double wanted,
                  double *quickest)
{
    status st = OK;
    char series[48], words[32];
    double GJ = 0, ms = 0;
    int nnode = 0;
    TRY(solve(b, options, &GJ, &ms, &nnode));
    const double error = fabs(GJ / b->exact - 1);
    if (options->size > 0) {
        (void)snprintf(words, sizeof words, "%.3f mm", 1e3 * options->size);
    } else {
        (void)snprintf(words, sizeof words, "1/%.1f, +%d", options->finer, options->layers);
    }
    printf("%6d %11s %7d %10.2e %9.3f\n", options->order, words, nnode, error, ms);
    (void)snprintf(series, sizeof series, "%s, order %d, %s", b->name, options->order, kind);
    bench_point(series, ms, error);
    *quickest = error <= wanted ? fmin(*quickest, ms) : *quickest;

done:
    return st;
}

// *quickest: of the runs that are good to `wanted`
static status table(const bar *b, double wanted, double *quickest)
{
    status st = OK;
    static const double sizes[] = {0.5e-3, 0.25e-3, 0.125e-3};
    static const struct {
        double finer;
        int layers;
    } graded[] = {{1, 0}, {1, 1}, {1.4, 1}, {2, 2}, {2.8, 1}, {2.8, 3}};
    *quickest = INFINITY;
    printf("%s\n order       edges   nodes      error    CPU ms\n", b->name);
    for (int order = 2; order <= 4; order++) {
        mesh_options options = {.kind = MESH_AUTO, .order = order};
        for (int i = 0; i < 3; i++) {
            options.size = sizes[i];
            TRY(row(b, &options, "equal", wanted, quickest));
        }
        options.size = 0;
        for (int i = 0; i < 6; i++) {
            options.finer = graded[i].finer;
            options.layers = graded[i].layers;
            TRY(row(b, &options, "graded", wanted, quickest));
        }
    }

done:
    return st;
}

int main(void)
{
    static const double L[6][2] = {{0, 0},       {6e-3, 0},     {6e-3, 1e-3},
                                   {1e-3, 1e-3}, {1e-3, 10e-3}, {0, 10e-3}};
    const bar rectangle = {"rectangle", a_rectangle(4e-3, 1e-3, 0, 0, 0, 0),
                           rectangle_GJ(4e-3, 1e-3)};
    const bar angle = {"L", a_polygon(6, &L[0][0], 0), 1e-6 * L_GJ};
    double quickest[2] = {0};
    if (table(&rectangle, rectangle_wanted, &quickest[0]) != OK ||
        table(&angle, L_open / L_GJ, &quickest[1]) != OK) {
        printf("error: %s\n", status_message());
        return 1;
    }
    const int missed =
        bench_target("GJ of the rectangle to 1e-8", quickest[0], limit, "ms") +
        bench_target("GJ of the L to its stated digits, 1e-5", quickest[1], limit, "ms");
    return missed > 0;
}
