// bench/bench_brick.c
// One element's stiffness, CPU ms: the tensor product of a prism, and quadrature over elements of
// any shape, with and without the projected change of volume.
#include "bench/bench.h"
#include "tests/unit/fem/brick_cases.h"

enum { REPEATS = 30, WAYS = 4 };

static const double limit[ELEMENT_MAX_ORDER + 1] = {0, 0.7, 0.7, 0.7, 4}; // [ms]
static const char *const ways[WAYS] = {"prism", "mapped", "mapped, orthotropic",
                                       "mapped, orthotropic, polar"};

typedef struct subject {
    mesh plane;
    body body;
    bar how;
} subject;

static void make(const material *materials, shape kind, int order, int way, bool mixed, subject *s)
{
    static const double layer[3] = {0, 0.8e-3, 2e-3};
    *s = (subject){.how = {.twist = 300, .taper = 60}};
    one_element(kind, order, true, &s->plane);
    s->plane.block[0].material[0] = way < 2 ? ISOTROPIC : ORTHOTROPIC;
    s->plane.block[0].frame[0] = way == 3 ? 0 : 1; // frame 0 is polar
    s->how.plane = &s->plane;
    body_spec spec = {.plane = &s->plane,
                      .materials = materials,
                      .order = order,
                      .nlayer = 2,
                      .layer = layer,
                      .mixed = mixed};
    if (way > 0) {
        spec.shape = (body_shape){.self = &s->how, .place = bar_place};
    }
    CHECK_OK(body_make(&spec, &s->body));
}

// best of some, of the second layer on a plane element: what all but the first layer cost
static double measure(const body *b, double *K)
{
    brick *w = NULL;
    double best = INFINITY;
    CHECK_OK(brick_make(b, &w));
    CHECK_OK(brick_stand_on(w, 0, 0));
    for (int k = 0; k < REPEATS; k++) {
        CHECK_OK(brick_stiffness(w, 0, K));
        const double begin = bench_cpu_ms();
        CHECK_OK(brick_stiffness(w, 1, K));
        best = fmin(best, bench_cpu_ms() - begin);
    }
    brick_free(w);
    return best;
}

static int measure_order(const material *materials, shape kind, int order, double *K)
{
    int bad = 0;
    printf("%s of order %d:", kind == SHAPE_QUAD ? "hexahedron" : "prism", order);
    double worst = 0;
    for (int k = 0; k < 2 * WAYS; k++) {
        subject s;
        make(materials, kind, order, k % WAYS, k >= WAYS, &s);
        const double ms = measure(&s.body, K);
        printf("%s %s%s %.4f", k ? "," : "", ways[k % WAYS], k >= WAYS ? ", projected" : "", ms);
        worst = k < WAYS ? fmax(worst, ms) : worst;
        body_free(&s.body);
        mesh_free(&s.plane);
    }
    printf(" ms\n");
    if (kind == SHAPE_QUAD && order >= 3) {
        bad = bench_target(order == 3 ? "a hexahedron of order 3" : "a hexahedron of order 4",
                           worst, limit[order], "ms");
    }
    return bad;
}

int main(void)
{
    material materials[MATERIALS];
    double *K = NULL;
    int bad = 0;
    make_materials(materials);
    CHECK_OK(TAKE(K, (size_t)BRICK_MAX_DOFS * BRICK_MAX_DOFS));
    for (int k = 0; k < 2; k++) {
        for (int order = 1; order <= ELEMENT_MAX_ORDER; order++) {
            bad += measure_order(materials, k ? SHAPE_TRIANGLE : SHAPE_QUAD, order, K);
        }
    }
    free(K);
    return bad + test_failures != 0;
}
