// One element at a time: rigid motions cost nothing, the tensor product and the quadrature agree,
// energies and stresses of known strains are exact.
#include "tests/unit/fem/brick_trial.h"

// six rigid motions of the layer's nodes: three ways to go and three to turn
static void rigid_motions(const body *b, int layer, int n3, double u[6][BRICK_MAX_DOFS])
{
    for (int i = 0; i < n3 / 3; i++) {
        vec3 x;
        element_node(b, layer, i, x.a);
        for (int j = 0; j < 6; j++) {
            vec3 e = {0};
            e.a[j % 3] = 1;
            const vec3 motion = j < 3 ? e : vec3_cross(e, vec3_scale(1e3, x));
            memcpy(u[j] + 3 * i, motion.a, sizeof motion.a);
        }
    }
}

// what of K u does not vanish for them, and of K - K^T
static double worst_rigid(const body *b, int layer)
{
    int n3;
    double *K = stiffness(b, layer, &n3), u[6][BRICK_MAX_DOFS], worst = 0;
    const double scale = largest(K, n3 * n3);
    rigid_motions(b, layer, n3, u);
    for (int r = 0; r < n3; r++) {
        for (int j = 0; j < 6; j++) {
            double sum = 0;
            for (int i = 0; i < n3; i++) {
                sum += K[r * n3 + i] * u[j][i];
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

int main(void)
{
    material materials[MATERIALS];
    make_materials(materials);
    each_trial(materials, rigid_motions_cost_nothing);
    each_trial(materials, the_product_is_the_quadrature);
    each_trial(materials, a_linear_field_is_exact);
    return test_failures != 0;
}
