// Products without a matrix are those with the elements' matrices, for each shape, order, material
// and way to bend a body.
#include "fem/apply.h"

#include "fem/brick.h"
#include "tests/unit/fem/brick_cases.h"

#include <string.h>

enum { LAYERS = 2, MOST_COLUMNS = 7 };

static const double layers[LAYERS + 1] = {0, 0.8e-3, 2e-3};

typedef struct trial {
    shape kind;
    int order, along, material, frame, ncol;
    bool mapped;
} trial;

// reproducible and without a pattern
static double noise(int i)
{
    return sin(12.9898 * i + 0.7) * cos(4.1414 * i * i);
}

// f = K u by element matrices, fields as apply.h has them
static void by_matrices(const body *b, int ncol, const double *u, double *f)
{
    const mesh_block *k = &b->plane->block[0];
    const int n2 = k->per_elem, n3 = 3 * n2 * (b->order + 1), nplane = b->plane->nnode;
    brick *w = NULL;
    double *K = NULL;
    CHECK_OK(TAKE(K, (size_t)(n3 * n3)));
    CHECK_OK(brick_make(b, &w));
    CHECK_OK(brick_stand_on(w, 0, 0));
    for (int layer = 0; layer < LAYERS; layer++) {
        CHECK_OK(brick_stiffness(w, layer, K));
        for (int r = 0; r < n3 * n3; r++) {
            const int i = r / n3, j = r % n3;
            const int to =
                ((layer * b->order + i / (3 * n2)) * 3 + i % 3) * nplane + k->conn[i / 3 % n2];
            const int from =
                ((layer * b->order + j / (3 * n2)) * 3 + j % 3) * nplane + k->conn[j / 3 % n2];
            for (int c = 0; c < ncol; c++) {
                f[to * ncol + c] += K[r] * u[from * ncol + c];
            }
        }
    }
    brick_free(w);
    free(K);
}

static void the_product_is_that_of_matrices(const trial *t, const material *materials)
{
    mesh m = {0};
    body b = {0};
    apply *a = NULL;
    double *u = NULL, *f = NULL, *wanted = NULL;
    one_element(t->kind, t->order, true, &m);
    m.block[0].material[0] = t->material;
    m.block[0].frame[0] = t->frame;
    bar how = {.plane = &m, .twist = 300, .taper = 60, .bend = 80};
    body_spec spec = {
        .plane = &m, .materials = materials, .order = t->along, .nlayer = LAYERS, .layer = layers};
    if (t->mapped) {
        spec.shape = (body_shape){.self = &how, .place = bar_place};
    }
    CHECK_OK(body_make(&spec, &b));
    const int n = 3 * b.plane->nnode * b.nlevel * t->ncol;
    CHECK_OK(TAKE(u, (size_t)n));
    CHECK_OK(TAKE(f, (size_t)n));
    CHECK_OK(TAKE(wanted, (size_t)n));
    double most = 0;
    for (int i = 0; i < n; i++) {
        u[i] = noise(i);
    }
    by_matrices(&b, t->ncol, u, wanted);
    CHECK_OK(apply_make(&b, 0, LAYERS, &a));
    CHECK_OK(apply_layers(a, 0, LAYERS, t->ncol, u, f));
    for (int i = 0; i < n; i++) {
        most = fmax(most, fabs(wanted[i]));
    }
    double worst = 0;
    for (int i = 0; i < n; i++) {
        worst = fmax(worst, fabs(f[i] - wanted[i]) / most);
    }
    CHECK_WITHIN(worst, 0, 1e-13); // rounding of sums of some hundred terms
    apply_free(a);
    free(u);
    free(f);
    free(wanted);
    body_free(&b);
    mesh_free(&m);
}

int main(void)
{
    material materials[MATERIALS];
    make_materials(materials);
    for (int order = 1; order <= ELEMENT_MAX_ORDER; order++) {
        for (int k = 0; k < 4 * MATERIALS; k++) {
            const trial t = {.kind = k % 2 ? SHAPE_TRIANGLE : SHAPE_QUAD,
                             .mapped = k / 2 % 2,
                             .order = order,
                             .along = k % 3 ? order : 1 + order % ELEMENT_MAX_ORDER,
                             .material = k / 4,
                             .frame = k / 4 % 3 - 1,
                             .ncol = k % 3 ? 6 : MOST_COLUMNS};
            the_product_is_that_of_matrices(&t, materials);
        }
    }
    return test_failures != 0;
}
