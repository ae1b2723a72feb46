// One element at a time: rigid motions cost nothing, the tensor product and the quadrature agree,
// materials turn with the section, energies of known strains are exact.
#include "tests/unit/fem/brick_cases.h"

static const double layers[3] = {0, 0.8e-3, 2e-3};
static const bar straight = {0}, curved = {.twist = 300, .taper = 60, .bend = 80};

typedef struct trial {
    shape kind;
    int order, along, material, frame;
    bool bent, mixed;
} trial;

// body of two layers on one element; how NULL: a prism
static void stand(const trial *t, const material *materials, mesh *m, bar *how, body *b)
{
    one_element(t->kind, t->order, t->bent, m);
    m->block[0].material[0] = t->material;
    m->block[0].frame[0] = t->frame;
    body_spec spec = {.plane = m,
                      .materials = materials,
                      .order = t->along,
                      .nlayer = 2,
                      .layer = layers,
                      .mixed = t->mixed};
    if (how) {
        how->plane = m;
        spec.shape = (body_shape){.self = how, .place = bar_place};
    }
    CHECK_OK(body_make(&spec, b));
}

static double *stiffness(const body *b, int layer, int *n3)
{
    brick *w = NULL;
    double *K = NULL;
    *n3 = 3 * b->plane->block[0].per_elem * (b->order + 1);
    CHECK_OK(TAKE(K, (size_t)(*n3 * *n3)));
    CHECK_OK(brick_make(b, &w));
    CHECK_OK(brick_stand_on(w, 0, 0));
    CHECK_OK(brick_stiffness(w, layer, K));
    brick_free(w);
    return K;
}

static double largest(const double *a, int n)
{
    double most = 0;
    for (int i = 0; i < n; i++) {
        most = fmax(most, fabs(a[i]));
    }
    return most;
}

static void element_node(const body *b, int layer, int i, double *x)
{
    const int n2 = b->plane->block[0].per_elem;
    body_node(b, i % n2, layer * b->order + i / n2, x);
}

// what of K u does not vanish for the six rigid motions, and of K - K^T
static double worst_rigid(const body *b, int layer)
{
    int n3;
    double *K = stiffness(b, layer, &n3), worst = 0;
    const double scale = largest(K, n3 * n3);
    for (int r = 0; r < n3; r++) {
        for (int j = 0; j < 6; j++) {
            double sum = 0;
            for (int i = 0; i < n3 / 3; i++) {
                vec3 x, e = {0};
                element_node(b, layer, i, x.a);
                e.a[j % 3] = 1;
                const vec3 u = j < 3 ? e : vec3_cross(e, vec3_scale(1e3, x));
                for (int d = 0; d < 3; d++) {
                    sum += K[r * n3 + 3 * i + d] * u.a[d];
                }
            }
            worst = fmax(worst, fabs(sum) / scale);
        }
        for (int s = 0; s < n3; s++) {
            worst = fmax(worst, fabs(K[r * n3 + s] - K[s * n3 + r]) / scale);
        }
    }
    free(K);
    return worst;
}

static double difference(const body *a, const body *b, int layer)
{
    int n3;
    double *A = stiffness(a, layer, &n3), *B = stiffness(b, layer, &n3), worst = 0;
    for (int i = 0; i < n3 * n3; i++) {
        worst = fmax(worst, fabs(A[i] - B[i]));
    }
    worst /= largest(A, n3 * n3);
    free(A);
    free(B);
    return worst;
}

static void each_trial(const material *materials, void (*check)(const trial *, const material *))
{
    for (int order = 1; order <= ELEMENT_MAX_ORDER; order++) {
        for (int k = 0; k < 2 * 2 * MATERIALS; k++) {
            const trial t = {.kind = k % 2 ? SHAPE_TRIANGLE : SHAPE_QUAD,
                             .mixed = k / 2 % 2,
                             .order = order,
                             .along = k / 4 % 2 ? order : 1 + order % ELEMENT_MAX_ORDER,
                             .material = k / 4,
                             .frame = k / 4 % 3 - 1,
                             .bent = k / 2 % 3 > 0};
            check(&t, materials);
        }
    }
}

static void rigid_motions_cost_nothing(const trial *t, const material *materials)
{
    bar hows[2] = {straight, curved};
    for (int k = 0; k < 3; k++) {
        mesh m = {0};
        body b = {0};
        stand(t, materials, &m, k == 2 ? NULL : &hows[k], &b);
        for (int layer = 0; layer < 2; layer++) {
            // rounding of sums of some hundred terms
            CHECK_WITHIN(worst_rigid(&b, layer), 0, 3e-13);
        }
        body_free(&b);
        mesh_free(&m);
    }
}

static void the_product_is_the_quadrature(const trial *t, const material *materials)
{
    mesh m = {0}, again = {0};
    body prism = {0}, mapped = {0};
    bar how = straight;
    stand(t, materials, &m, NULL, &prism);
    stand(t, materials, &again, &how, &mapped);
    CHECK(prism.prism && !mapped.prism);
    CHECK_WITHIN(difference(&prism, &mapped, 1), 0, 1e-13);
    body_free(&prism);
    body_free(&mapped);
    mesh_free(&m);
    mesh_free(&again);
}

int main(void)
{
    material materials[MATERIALS];
    make_materials(materials);
    each_trial(materials, rigid_motions_cost_nothing);
    each_trial(materials, the_product_is_the_quadrature);
    return test_failures != 0;
}
