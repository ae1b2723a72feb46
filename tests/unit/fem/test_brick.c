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
        for (int k = 0; k < 3 * 2 * 2 * MATERIALS; k++) {
            const trial t = {.kind = k % 2 ? SHAPE_TRIANGLE : SHAPE_QUAD,
                             .mixed = k / 2 % 2,
                             .order = order,
                             .along = k / 4 % 2 ? order : 1 + order % ELEMENT_MAX_ORDER,
                             .material = k / 4 % MATERIALS,
                             .frame = k / 4 / MATERIALS - 1,
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

// --- energies, stresses, forces

// a displacement gradient, and what it strains
static const double H[3][3] = {{2e-3, -1e-3, 3e-3}, {4e-3, -3e-3, 1e-3}, {-2e-3, 5e-3, 1.5e-3}};
static const vec6 strained = {{2e-3, -3e-3, 1.5e-3, 6e-3, 1e-3, 3e-3}};

static void linear_field(const body *b, int layer, double *u)
{
    const int n = b->plane->block[0].per_elem * (b->order + 1);
    for (int i = 0; i < n; i++) {
        double x[3];
        element_node(b, layer, i, x);
        for (int d = 0; d < 3; d++) {
            u[3 * i + d] = H[d][0] * x[0] + H[d][1] * x[1] + H[d][2] * x[2];
        }
    }
}

// int dV and int density dV of a layer
static double volume(brick *w, int layer, int n, double *weight)
{
    double mass[BRICK_MAX_NODES], f[BRICK_MAX_DOFS] = {0}, sum = 0;
    const double force[3] = {0, 0, 1};
    CHECK_OK(brick_mass(w, layer, mass));
    CHECK_OK(brick_body_force(w, layer, force, f));
    *weight = 0;
    for (int i = 0; i < n; i++) {
        sum += f[3 * i + 2];
        *weight += mass[i];
        CHECK(f[3 * i] == 0 && f[3 * i + 1] == 0);
    }
    return sum;
}

static void check_points(brick *w, int layer, const double *u, const mat6 *Q)
{
    double point[BRICK_MAX_NODES][3];
    const int count = brick_best_points(w, point);
    for (int i = 0; i < count; i++) {
        double strain[6], stress[6], place[3];
        CHECK_OK(brick_stress_at(w, layer, point[i], u, strain, stress, place));
        const vec6 wanted = mat6_mul_vec(*Q, strained);
        const double size = sqrt(vec6_dot(wanted, wanted));
        for (int c = 0; c < 6; c++) {
            CHECK_WITHIN(strain[c], strained.a[c], 1e-14);
            CHECK_WITHIN(stress[c] / size, wanted.a[c] / size, 1e-11);
        }
    }
}

// of prisms of uniform matter, where a linear field's stress is the same everywhere
static void a_linear_field_is_exact(const trial *t, const material *materials)
{
    mesh m = {0};
    body b = {0};
    brick *w = NULL;
    int n3;
    double u[BRICK_MAX_DOFS], weight, energy = 0;
    if (t->material == GRADED || t->material == ALONG || t->frame == 0) { // frame 0 is polar
        return;
    }
    stand(t, materials, &m, NULL, &b);
    linear_field(&b, 1, u);
    double *K = stiffness(&b, 1, &n3);
    for (int i = 0; i < n3 * n3; i++) {
        energy += K[i] * u[i / n3] * u[i % n3];
    }
    const mat6 Q = material_stiffness_in(&materials[t->material],
                                         t->frame < 0 ? NULL : &m.frame[t->frame], 0, 0);
    CHECK_OK(brick_make(&b, &w));
    CHECK_OK(brick_stand_on(w, 0, 0));
    const double V = volume(w, 1, n3 / 3, &weight);
    CHECK_NEAR(energy, V * vec6_dot(strained, mat6_mul_vec(Q, strained)), 1e-11);
    CHECK_NEAR(weight + 1, materials[t->material].density * V + 1, 1e-13);
    check_points(w, 1, u, &Q);
    brick_free(w);
    free(K);
    body_free(&b);
    mesh_free(&m);
}

// --- a body that turns: layer after layer is the one before, turned

static double turned_difference(const double *A, const double *B, int n3, mat3 R)
{
    double worst = 0;
    for (int i = 0; i < n3; i += 3) {
        for (int j = 0; j < n3; j += 3) {
            mat3 a, b;
            for (int k = 0; k < 9; k++) {
                a.a[k / 3][k % 3] = A[(i + k / 3) * n3 + j + k % 3];
                b.a[k / 3][k % 3] = B[(i + k / 3) * n3 + j + k % 3];
            }
            const mat3 t = mat3_mul(mat3_mul(R, a), mat3_transpose(R));
            for (int k = 0; k < 9; k++) {
                worst = fmax(worst, fabs(t.a[k / 3][k % 3] - b.a[k / 3][k % 3]));
            }
        }
    }
    return worst / largest(A, n3 * n3);
}

static void matter_turns_with_the_section(const trial *t, const material *materials)
{
    const double equal[3] = {0, 1e-3, 2e-3};
    mesh m = {0};
    body b = {0};
    int n3;
    if (t->material == ALONG) {
        return;
    }
    one_element(t->kind, t->order, t->bent, &m);
    m.block[0].material[0] = t->material;
    m.block[0].frame[0] = t->frame;
    const body_spec spec = {.plane = &m,
                            .materials = materials,
                            .order = t->along,
                            .nlayer = 2,
                            .layer = equal,
                            .turn_rate = 400,
                            .mixed = t->mixed};
    CHECK_OK(body_make(&spec, &b));
    double *A = stiffness(&b, 0, &n3), *B = stiffness(&b, 1, &n3);
    CHECK_WITHIN(turned_difference(A, B, n3, mat3_rot_z(0.4)), 0, 1e-12);
    free(A);
    free(B);
    body_free(&b);
    mesh_free(&m);
}

static status turned_frame(const void *self, double s, int index, material_frame *out)
{
    const bar *b = (const bar *)self;
    (void)s;
    *out = b->plane->frame[index];
    material_frame_move(out, 1, 0.6);
    return OK;
}

static void frames_along_s_replace_those_of_the_mesh(void)
{
    material materials[MATERIALS];
    make_materials(materials);
    for (int frame = 0; frame < 2; frame++) {
        const trial t = {SHAPE_QUAD, 2, 2, ORTHOTROPIC, frame, true, false};
        mesh m = {0}, moved = {0};
        body asked = {0}, told = {0};
        bar how = straight, again = straight;
        stand(&t, materials, &m, &how, &asked);
        asked.spec.shape.frame = turned_frame;
        stand(&t, materials, &moved, &again, &told);
        CHECK(difference(&asked, &told, 1) > 1e-3);
        material_frame_move(&moved.frame[frame], 1, 0.6);
        CHECK_WITHIN(difference(&asked, &told, 1), 0, 1e-14);
        body_free(&asked);
        body_free(&told);
        mesh_free(&m);
        mesh_free(&moved);
    }
}

// --- failures

static double no_modulus(const void *self, double x, double y, double s)
{
    (void)self;
    (void)y;
    (void)s;
    return x - 2.5e-3;
}

static void bad_moduli_are_refused(void)
{
    material bad = {.E = 1, .nu = 0.3, .modulus = {.at = no_modulus, .across = true}};
    bar hows[2] = {straight, curved};
    for (int k = 0; k < 3; k++) {
        const trial t = {SHAPE_QUAD, 2, 2, 0, -1, false, false};
        mesh m = {0};
        body b = {0};
        brick *w = NULL;
        double K[81 * 81];
        stand(&t, &bad, &m, k == 2 ? NULL : &hows[k], &b);
        CHECK_OK(brick_make(&b, &w));
        CHECK_OK(brick_stand_on(w, 0, 0));
        CHECK(brick_stiffness(w, 0, K) == ERR_INPUT);
        status_clear();
        brick_free(w);
        body_free(&b);
        mesh_free(&m);
    }
}

static void inverted_elements_are_refused(void)
{
    const trial t = {SHAPE_QUAD, 1, 1, ISOTROPIC, -1, false, false};
    material materials[MATERIALS];
    mesh m = {0};
    body b = {0};
    brick *w = NULL;
    double K[24 * 24];
    make_materials(materials);
    for (int k = 0; k < 2; k++) {
        bar how = straight;
        stand(&t, materials, &m, k ? &how : NULL, &b);
        double *x = k ? b.node : m.xyz; // after the check of body_make
        memcpy(x, x + 9, 2 * sizeof *x);
        CHECK_OK(brick_make(&b, &w));
        CHECK_OK(brick_stand_on(w, 0, 0));
        CHECK(brick_stiffness(w, 0, K) == ERR_NUMERIC);
        status_clear();
        brick_free(w);
        body_free(&b);
        mesh_free(&m);
    }
}

int main(void)
{
    material materials[MATERIALS];
    make_materials(materials);
    each_trial(materials, rigid_motions_cost_nothing);
    each_trial(materials, the_product_is_the_quadrature);
    each_trial(materials, a_linear_field_is_exact);
    each_trial(materials, matter_turns_with_the_section);
    frames_along_s_replace_those_of_the_mesh();
    bad_moduli_are_refused();
    inverted_elements_are_refused();
    return test_failures != 0;
}
