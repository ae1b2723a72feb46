// tests/verify/app/verify_calculix.c
// CalculiX on bodies of ours: the deck is right where closed forms are quadratic, and on the
// paper's Fig. 4 it nears an independent 3D reference from below. Passes without a word where
// CalculiX is not installed.
#include "app/calculix_door.h"
#include "base/memory.h"
#include "meshes/mesher.h"

#include "tests/test.h"

#include <string.h>

static const double RADIUS = 4e-3, WALL = 0.8e-3, LENGTH = 20e-3;

// layers of equal height, or doubling from both ends to the middle
static status body_on(const mesh *plane, const material *materials, int layers, bool graded,
                      body *out)
{
    double z[65] = {0}, total = 0;
    for (int i = 0; i < layers; i++) {
        const int step = i < layers - 1 - i ? i : layers - 1 - i;
        z[i + 1] = z[i] + (graded ? ldexp(1, step) : 1);
    }
    total = z[layers];
    for (int i = 0; i <= layers; i++) {
        z[i] *= LENGTH / total;
    }
    const body_spec spec = {
        .plane = plane, .materials = materials, .order = 2, .nlayer = layers, .layer = z};
    return body_make(&spec, out);
}

// with nu = 0 a clamp holds nothing: stretch and bending are polynomials that its elements hold
static void a_tube_without_contraction_has_its_closed_form(int kind, bool cap)
{
    const material soft = {.name = "soft", .E = 1e6, .nu = 0};
    const outline ring = {.kind = KIND_ANNULUS, .outer = RADIUS, .inner = RADIUS - WALL};
    const section_outline o = {.count = 1, .items = (outline *)&ring, .size = RADIUS};
    const mesh_options options = {.kind = kind, .order = 2, .size = RADIUS / 3};
    const double ri = RADIUS - WALL, pi = 3.14159265358979323846;
    const double A = pi * (RADIUS * RADIUS - ri * ri), I = pi / 4 * (pow(RADIUS, 4) - pow(ri, 4));
    const vec6 wrench[3] = {{{0, 0, 1}}, {{0, 0, 0, 0, 1e-3}}, {{0, 0, 0, 0, 0, 1e-3}}};
    vec6 motion[3];
    mesh plane = {0};
    body b = {0};
    double cpu = 0;
    CHECK_OK(section_mesh_make(&o, &options, &plane));
    CHECK_OK(body_on(&plane, &soft, 5, false, &b));
    const calculix_ask ask = {.body = &b, .cap = cap, .nload = 3, .wrench = wrench};
    CHECK_OK(calculix_tip(&ask, motion, &cpu));
    // parabolas for circles: 3e-5 of A and I, twice that of the polar moment
    CHECK_NEAR(motion[0].a[2], LENGTH / (soft.E * A), 1e-4);
    CHECK_NEAR(motion[1].a[4], 1e-3 * LENGTH / (soft.E * I), 1e-4);
    CHECK_NEAR(motion[1].a[0], 1e-3 * LENGTH * LENGTH / 2 / (soft.E * I), 1e-4);
    CHECK_NEAR(motion[2].a[5], 1e-3 * LENGTH / (soft.E / 2 * 2 * I), 2e-4);
    CHECK_BELOW(fabs(motion[0].a[0]), 1e-5 * motion[0].a[2]);
    CHECK_ABOVE(cpu, 0);
    body_free(&b);
    mesh_free(&plane);
}

static const material both[2] = {{.name = "soft", .E = 0.66e6, .nu = 0.3},
                                 {.name = "stiff", .E = 15.93e6, .nu = 0.3}};

static status fig4_plane(double size, mesh *out)
{
    outline items[2] = {
        {.kind = KIND_ANNULUS, .outer = RADIUS, .inner = RADIUS - WALL, .material = 0},
        {.kind = KIND_SECTOR,
         .outer = RADIUS,
         .inner = RADIUS - WALL,
         .mid_angle = M_PI,
         .width = M_PI / 8,
         .material = 1},
    };
    const section_outline o = {.count = 2, .items = items, .size = RADIUS};
    const mesh_options options = {.kind = MESH_MAPPED, .order = 2, .size = size * RADIUS};
    return section_mesh_make(&o, &options, out);
}

// 20 mm, nu = 0.3, by curved high-order hexahedra (mm, N): axial, and bending by an axial force
static void fig4_nears_the_reference(void)
{
    const double axial = 1.1999589518868163e-3, turned = -0.24600769703143013;
    const vec6 wrench = {{0, 0, 1}};
    const double size[2] = {0.4, 0.2};
    const int layers[2] = {8, 12};
    double error[2];
    for (int i = 0; i < 2; i++) {
        mesh plane = {0};
        body b = {0};
        vec6 motion = {0};
        double cpu = 0;
        CHECK_OK(fig4_plane(size[i], &plane));
        CHECK_OK(body_on(&plane, both, layers[i], true, &b));
        const calculix_ask ask = {
            .body = &b, .cap = true, .reduced = false, .nload = 1, .wrench = &wrench};
        CHECK_OK(calculix_tip(&ask, &motion, &cpu));
        error[i] = fabs(motion.a[2] / axial - 1);
        printf("Fig. 4, %d nodes: axial %.1e, bending %.1e, %.2f s\n", (int)body_node_count(&b),
               error[i], fabs(motion.a[4] / turned - 1), cpu);
        CHECK_BELOW(fabs(motion.a[4] / turned - 1), 5e-3);
        body_free(&b);
        mesh_free(&plane);
    }
    CHECK_BELOW(error[0], 1e-2);
    CHECK_BELOW(error[1], error[0] / 1.5);
}

static void what_it_has_no_elements_for_is_refused(void)
{
    mesh plane = {0};
    body b = {0};
    vec6 motion;
    material graded[2] = {both[0], both[1]};
    const vec6 wrench = {{0, 0, 1}};
    graded[1].kind = MATERIAL_ORTHOTROPIC;
    CHECK_OK(fig4_plane(1, &plane));
    CHECK_OK(body_on(&plane, graded, 2, false, &b));
    const calculix_ask ask = {.body = &b, .nload = 1, .wrench = &wrench};
    CHECK(calculix_tip(&ask, &motion, NULL) == ERR_INPUT);
    CHECK(strstr(status_message(), "'stiff' is not isotropic") != NULL);
    status_clear();
    body_free(&b);
    mesh_free(&plane);
}

int main(void)
{
    against(BY_CLOSED_FORM, "tubes without lateral contraction: CalculiX itself is checked");
    char path[4096];
    if (!calculix_find(path, sizeof path)) {
        printf("CalculiX is not installed\n");
        return 0;
    }
    a_tube_without_contraction_has_its_closed_form(MESH_MAPPED, false);
    a_tube_without_contraction_has_its_closed_form(MESH_MAPPED, true);
    a_tube_without_contraction_has_its_closed_form(MESH_FREE, false);
    against(BY_OTHER_CODE,
            "3D FEM of an independent code: curved high-order hexahedra, direct solver");
    fig4_nears_the_reference();
    what_it_has_no_elements_for_is_refused();
    return test_failures != 0;
}
