// Materials turn with the section, by their frames or by frames that change along s; moduli and
// elements that are none are refused.
#include "tests/unit/fem/brick_trial.h"

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
    each_trial(materials, matter_turns_with_the_section);
    frames_along_s_replace_those_of_the_mesh();
    bad_moduli_are_refused();
    inverted_elements_are_refused();
    return test_failures != 0;
}
