// bench/bench_segment_reference.c
// The compliance of the paper's Fig. 4 segment under unit traction ~ E (clamped, nu 0.3), good to
// 1e-6: two ladders of meshes that shrink towards walls, interfaces and the clamp, of other orders
// and other factors, and their limits by the known strength of the clamped edge. docs/theory.md
// (5.12)
#include "bench/bench.h"
#include "fem/level_fit.h"
#include "tests/verify/fem/ring_mesh.h"

enum { MOST_RUNGS = 4 };

typedef struct reference_ladder {
    int order, soft, rungs;
    double shrink, first;
} reference_ladder;

// lambda of r^lambda at a right angle of which one side is held and one free, plane strain:
// k sin^2(lambda pi/2) = (k + 1)^2/4 - lambda^2, k = 3 - 4 nu
static double edge_strength(double nu)
{
    const double k = 3 - 4 * nu;
    double low = 0.5, high = 1;
    for (int i = 0; i < 60; i++) {
        const double at = (low + high) / 2, s = sin(at * PI / 2);
        if (k * s * s < (k + 1) * (k + 1) / 4 - at * at) {
            low = at;
        } else {
            high = at;
        }
    }
    return (low + high) / 2;
}

// [mm/N], relative to the mesh's own L / EA and back to the exact one: the arcs' error is not the
// clamp's
static double compliance(const ring *s, int layers, double *cpu)
{
    static const material pair[2] = {{.name = "soft", .E = 0.66e6, .nu = 0.3},
                                     {.name = "stiff", .E = 15.93e6, .nu = 0.3}};
    const double length = 20e-3, begin = bench_cpu_ms();
    const double EA = (s->outer * s->outer - s->inner * s->inner) / 2 *
                      (pair[0].E * (2 * PI - s->width) + pair[1].E * s->width);
    mesh plane = {0};
    body b = {0};
    way_run run = {0};
    level_fit fit = {0};
    double sum = 0;
    CHECK_OK(ring_mesh(s, &plane));
    CHECK_OK(prism_body(&plane, pair, 2, layers, length, 0, &b));
    const segment_problem problem = {.body = &b, .tip = TIP_E_PROPORTIONAL};
    const way_wants wants = {.middle = length / 2, .middle_half = length / 8};
    CHECK_OK(way_doubling(&problem, &wants, &run));
    CHECK_OK(level_fit_make(&b, 0, LEVEL_BY_E, &fit));
    const vec6 load = {{0, 0, 1, fit.centroid[1], -fit.centroid[0], 0}};
    for (int j = 0; j < 6 && run.motion; j++) {
        sum += load.a[j] * vec6_dot(load, run.motion[(j + 1) * run.nlevel - 1]);
    }
    const double ratio = sum * fit.weight / length;
    *cpu = bench_cpu_ms() - begin;
    level_fit_free(&fit);
    way_run_free(&run);
    body_free(&b);
    mesh_free(&plane);
    return 1e3 * ratio * length / EA;
}

static double limit_of(const reference_ladder *l, double strength)
{
    double value[MOST_RUNGS] = {0};
    printf("order %d, elements shrink by %.2f:\n", l->order, l->shrink);
    for (int k = 0; k < l->rungs; k++) {
        ring s = fig4_ring(l->order);
        s.soft = l->soft;
        s.shrink = l->shrink;
        s.first = l->first;
        s.steps = s.arc_steps = k + 1;
        // slabs a quarter of the smallest element
        const double smallest = l->first * (s.outer - s.inner) * pow(l->shrink, k);
        const int layers = 1 << (int)ceil(log2(20e-3 / (smallest / 4)));
        double cpu = 0;
        value[k] = compliance(&s, layers, &cpu);
        printf("  %d layers towards edges, %5d slabs: %.8f mm/N, %6.1f CPU s", k + 1, layers,
               value[k], 1e-3 * cpu);
        if (k > 1) {
            printf(", step %.3f of the last, by the edge's strength %.3f",
                   (value[k] - value[k - 1]) / (value[k - 1] - value[k - 2]),
                   pow(l->shrink, 2 * strength));
        }
        puts("");
    }
    const double q = pow(l->shrink, 2 * strength), last = value[l->rungs - 1];
    return last + (last - value[l->rungs - 2]) * q / (1 - q);
}

int main(void)
{
    const reference_ladder ladder[2] = {{4, 8, 3, 0.2, 0.25}, {3, 12, 3, 0.25, 0.3}};
    const double strength = edge_strength(0.3);
    double limit[2];
    printf("strength of the clamped edge: %.6f\n", strength);
    for (int k = 0; k < 2; k++) {
        limit[k] = limit_of(&ladder[k], strength);
        printf("  limit %.8f mm/N\n", limit[k]);
    }
    const double apart = fabs(limit[1] / limit[0] - 1);
    printf("Fig. 4 compliance: %.7f mm/N, the two ladders apart by %.1e\n", limit[0], apart);
    return bench_target("two ladders' limits apart, relative", apart, 1e-6, "") +
           (test_failures != 0);
}
