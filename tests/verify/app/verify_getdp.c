// tests/verify/app/verify_getdp.c
// GetDP's torsion on meshes of ours against closed forms: the outside way is right itself, on
// triangles and on cut quadrilaterals. Passes without a word where GetDP is not installed.
#include "app/getdp_door.h"
#include "meshes/mesher.h"

#include "tests/test.h"

static const material soft = {.name = "soft", .E = 2.6e6, .nu = 0.3}; // G = 1 MPa

static double getdp_of(const outline *one, double size, double parts, int kind)
{
    const section_outline o = {.count = 1, .items = (outline *)one, .size = size};
    const mesh_options options = {.kind = kind, .order = 2, .size = size / parts};
    mesh m = {0};
    double GJ = NAN;
    CHECK_OK(section_mesh_make(&o, &options, &m));
    CHECK_OK(getdp_torsion(&m, 1, &soft, &GJ));
    mesh_free(&m);
    return GJ;
}

// Saint-Venant's series for a square of side a: J = a^4 (1/3 - 64/pi^5 sum over odd n of tanh(n pi
// / 2) / n^5)
static double square_constant(void)
{
    double sum = 0;
    for (int n = 1; n < 60; n += 2) {
        sum += tanh(n * M_PI / 2) / pow(n, 5);
    }
    return 1.0 / 3 - 64 / pow(M_PI, 5) * sum;
}

// quadratic elements: the energy's error falls with h^4
static void a_square_converges_to_the_series(int kind)
{
    const double a = 2e-3, exact = 1e6 * square_constant() * a * a * a * a;
    const outline square = {.kind = KIND_RECTANGLE, .size = {a, a}, .centre = {1e-3, 2e-3}};
    const double parts[3] = {8, 16, 32};
    double h[3], error[3];
    for (int i = 0; i < 3; i++) {
        h[i] = 1 / parts[i];
        error[i] = fabs(getdp_of(&square, a, parts[i], kind) / exact - 1);
        printf("square, %2.0f elements along an edge: %.2e\n", parts[i], error[i]);
    }
    about(kind == MESH_MAPPED ? "quadrilaterals" : "triangles");
    CHECK_NEAR(observed_order(3, h, error), 4, 0.1);
    CHECK_BELOW(error[2], 3e-6);
}

static void a_ring_agrees_with_the_polar_moment(int kind)
{
    const double ro = 4e-3, ri = 3.2e-3;
    const outline ring = {.kind = KIND_ANNULUS, .outer = ro, .inner = ri};
    // no warping: what is left is the circle's geometry by parabolas
    CHECK_NEAR(getdp_of(&ring, ro, 12, kind), 1e6 * M_PI / 2 * (pow(ro, 4) - pow(ri, 4)), 2e-6);
}

int main(void)
{
    against(
        BY_CLOSED_FORM,
        "Saint-Venant's series of a square, the polar moment of a ring: GetDP itself is checked");
    char path[4096];
    if (!getdp_find(path, sizeof path)) {
        printf("getdp is not installed\n");
        return 0;
    }
    for (int kind = MESH_MAPPED; kind <= MESH_FREE; kind++) {
        a_square_converges_to_the_series(kind);
        a_ring_agrees_with_the_polar_moment(kind);
    }
    return test_failures != 0;
}
