// Fits and tractions on a level: rigid motions come back, resultants are unit wrenches, weights are
// the moduli along the rod.
#include "fem/level_fit.h"
#include "tests/grid_mesh.h"
#include "tests/unit/fem/brick_cases.h"

// cells of two materials, 4 mm x 2 mm
static void box(const double *from, double *to)
{
    to[0] = 4e-3 * from[0];
    to[1] = 2e-3 * from[1] - 0.5e-3;
}

static const double layers[3] = {0, 1e-3, 3e-3};

typedef struct model {
    material materials[MATERIALS];
    mesh plane;
    body body;
    bar how;
} model;

static void make(model *m, const char *cells, int order, bool triangles, bar how)
{
    const grid g = {4, 2, order, triangles, cells, box};
    *m = (model){.how = how};
    make_materials(m->materials);
    grid_make(&g, &m->plane);
    m->how.plane = &m->plane;
    body_spec spec = {
        .plane = &m->plane, .materials = m->materials, .order = 2, .nlayer = 2, .layer = layers};
    if (how.bend != 0) {
        spec.shape = (body_shape){.self = &m->how, .place = bar_place};
    }
    CHECK_OK(body_make(&spec, &m->body));
}

static void drop(model *m)
{
    body_free(&m->body);
    mesh_free(&m->plane);
}

// place of a node about the section's origin
static vec3 arm(const body *b, int node, int level)
{
    vec3 x, o;
    body_node(b, node, level, x.a);
    body_origin(b, level, o.a);
    return vec3_sub(x, o);
}

static void check_fit(const body *b, int level, level_weight weight)
{
    const int n = b->plane->nnode;
    level_fit fit = {0};
    double *u = NULL;
    const double length = 1e-3;
    CHECK_OK(TAKE(u, 3 * (size_t)n));
    CHECK_OK(level_fit_make(b, level, weight, &fit));
    for (int j = 0; j < 6; j++) {
        vec3 e = {0}, force = {0}, moment = {0};
        e.a[j % 3] = 1;
        for (int i = 0; i < n; i++) {
            const vec3 r = arm(b, i, level), motion = j < 3 ? e : vec3_cross(e, r);
            memcpy(u + 3 * i, motion.a, sizeof motion.a);
            vec3 f;
            memcpy(f.a, fit.force + 3 * (j * n + i), sizeof f.a);
            force = vec3_add(force, f);
            moment = vec3_add(moment, vec3_cross(r, f));
        }
        const vec6 back = level_fit_motion(&fit, u);
        for (int k = 0; k < 6; k++) {
            // N or 1 / mm: units of a millimetre make all of one size
            const double scale = (j < 3 ? 1 : length) / (k < 3 ? 1 : length);
            CHECK_WITHIN(back.a[k] / scale, k == j, 1e-11);
            const double part = k < 3 ? force.a[k] : moment.a[k - 3];
            CHECK_WITHIN(part * scale, k == j, 1e-11);
        }
    }
    level_fit_free(&fit);
    free(u);
}

static void rigid_motions_come_back(void)
{
    const bar straight = {0}, bent = {.bend = 60, .twist = 300, .taper = 50};
    for (int order = 1; order <= ELEMENT_MAX_ORDER; order++) {
        for (int k = 0; k < 4; k++) {
            model m;
            make(&m, "01430143", order, k % 2 == 1, k < 2 ? straight : bent);
            check_fit(&m.body, 0, LEVEL_BY_E);
            check_fit(&m.body, 3, LEVEL_BY_E);
            check_fit(&m.body, 4, LEVEL_BY_AREA);
            drop(&m);
        }
    }
}

static void weights_are_the_moduli_along_the_rod(void)
{
    model m;
    level_fit fit = {0};
    make(&m, "00110011", 2, false, (bar){0});
    CHECK_OK(level_fit_make(&m.body, 2, LEVEL_BY_E, &fit));
    const double soft = 0.66e6, stiff = 15.93e6, half = 4e-6;
    CHECK_NEAR(fit.weight, (soft + stiff) * half, 1e-13);
    CHECK_NEAR(fit.centroid[0], (soft * 1e-3 + stiff * 3e-3) / (soft + stiff), 1e-13);
    CHECK_NEAR(fit.centroid[1], 0.5e-3, 1e-13);
    level_fit_free(&fit);
    CHECK_OK(level_fit_make(&m.body, 2, LEVEL_BY_AREA, &fit));
    CHECK_NEAR(fit.weight, 8e-6, 1e-13);
    CHECK_NEAR(fit.centroid[0], 2e-3, 1e-13);
    level_fit_free(&fit);
    drop(&m);

    make(&m, "22222222", 1, false, (bar){0}); // orthotropic, in the section's own axes
    mat6 S;
    CHECK(mat6_inverse_spd(material_stiffness(&m.materials[ORTHOTROPIC]), &S));
    CHECK_OK(level_fit_make(&m.body, 0, LEVEL_BY_E, &fit));
    CHECK_NEAR(fit.weight, 8e-6 / S.a[2][2], 1e-12);
    level_fit_free(&fit);
    drop(&m);

    make(&m, "44444444", 2, true, (bar){0}); // E(x, y, s), linear
    CHECK_OK(level_fit_make(&m.body, 4, LEVEL_BY_E, &fit));
    CHECK_NEAR(fit.weight, 8e-6 * along_modulus(NULL, 2e-3, 0.5e-3, 3e-3), 1e-12);
    level_fit_free(&fit);
    drop(&m);
}

// at the foot of a mapped body's turned section the centroid is told in the section's own axes
static void centroids_turn_with_the_section(void)
{
    model m;
    level_fit fit = {0};
    const bar bent = {.bend = 60, .twist = 300, .taper = 50};
    make(&m, "00110011", 3, true, bent);
    CHECK_OK(level_fit_make(&m.body, 4, LEVEL_BY_E, &fit));
    const double soft = 0.66e6, stiff = 15.93e6, scale = 1 + 50 * 3e-3;
    CHECK_NEAR(fit.weight, (soft + stiff) * 4e-6 * scale * scale, 1e-12);
    CHECK_NEAR(fit.centroid[0], scale * (soft * 1e-3 + stiff * 3e-3) / (soft + stiff), 1e-12);
    CHECK_NEAR(fit.centroid[1], scale * 0.5e-3, 1e-12);
    level_fit_free(&fit);
    drop(&m);
}

int main(void)
{
    rigid_motions_come_back();
    weights_are_the_moduli_along_the_rod();
    centroids_turn_with_the_section();
    return test_failures != 0;
}
