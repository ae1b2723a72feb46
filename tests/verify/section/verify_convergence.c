// tests/verify/section/verify_convergence.c
// Orders of convergence: Gauss-Lobatto nodes on exact circles give 2 p for the section's integrals,
// and so does energy, docs/theory.md (6.3). A thick ring in two layers, refined along and across.
#include "tests/verify/section/hand_meshes.h"

static const double outer = 4, inner = 2, middle = 3;

static void place_in_ring(double u, double v, double *xyz)
{
    const double r = inner + (outer - inner) * (1 - v), angle = 2 * pi * u;
    xyz[0] = r * cos(angle);
    xyz[1] = r * sin(angle);
    xyz[2] = 0;
}

static int outer_layer(double u, double v)
{
    (void)u;
    return v < 0.5;
}

static double polar_moment(double ro, double ri)
{
    return pi / 2 * (pow(ro, 4) - pow(ri, 4));
}

// the meshes of one order: 6, 9, 12, ... elements around, as many across in proportion
typedef struct errors {
    double area, EI, GJ, shear;
} errors;

static errors errors_of(int order, int n, const material *layers, double shear)
{
    const lattice ring = {.order = order,
                          .n0 = n,
                          .n1 = n / 3,
                          .closed = true,
                          .place = place_in_ring,
                          .material = outer_layer};
    mesh m = lattice_mesh(&ring);
    beam_law classical = {0}, full = {0}, plain = {0};
    const material same[2] = {layers[0], layers[0]};
    CHECK_OK(section_classical_mesh(&m, layers, &classical));
    CHECK_OK(section_full_mesh(&m, layers, &full, NULL));
    CHECK_OK(section_full_mesh(&m, same, &plain, NULL));
    mesh_free(&m);
    const double J1 = polar_moment(outer, middle), J0 = polar_moment(middle, inner);
    const double EI = (layers[1].E * J1 + layers[0].E * J0) / 2;
    const double GJ =
        material_shear_modulus(&layers[1]) * J1 + material_shear_modulus(&layers[0]) * J0;
    return (errors){
        .area = fabs(classical.area / (pi * (outer * outer - inner * inner)) - 1),
        .EI = fabs(classical.K.a[MX][MX] / EI - 1),
        .GJ = fabs(centres_of(&full).GJ / GJ - 1),
        .shear = fabs(plain.K.a[NX][NX] / shear - 1),
    };
}

static void orders(int p)
{
    // coarser meshes for higher orders: the errors stay above rounding
    static const int counts[5][3] = {{0}, {24, 36, 48}, {12, 18, 24}, {12, 18, 24}, {6, 12, 18}};
    const material layers[2] = {{.E = 1, .nu = 0.3}, {.E = 5, .nu = 0.3}};
    const double nu = 0.3, k = inner / outer, q = 1 + k * k;
    const double coefficient =
        6 * (1 + nu) * (1 + nu) * q * q /
        ((7 + 14 * nu + 8 * nu * nu) * q * q + 4 * k * k * (5 + 10 * nu + 4 * nu * nu));
    const double shear = coefficient * pi * (outer * outer - inner * inner) / 2 / (1 + nu);
    double h[3], area[3], EI[3], GJ[3], stiff[3];
    for (int i = 0; i < 3; i++) {
        const errors e = errors_of(p, counts[p][i], layers, shear);
        h[i] = 1.0 / counts[p][i];
        area[i] = e.area;
        EI[i] = e.EI;
        GJ[i] = e.GJ;
        stiff[i] = e.shear;
    }
    about("order %d", p);
    printf("order %d: area %.2f (%.1e), EI %.2f (%.1e), GJ %.2f (%.1e), shear %.2f (%.1e)\n", p,
           observed_order(3, h, area), area[2], observed_order(3, h, EI), EI[2],
           observed_order(3, h, GJ), GJ[2], observed_order(3, h, stiff), stiff[2]);
    CHECK_WITHIN(observed_order(3, h, area), 2 * p, 0.3);
    CHECK_WITHIN(observed_order(3, h, EI), 2 * p, 0.3);
    CHECK_WITHIN(observed_order(3, h, GJ), 2 * p, 0.3);
    CHECK_WITHIN(observed_order(3, h, stiff), 2 * p, 0.3);
}

int main(void)
{
    against(BY_CLOSED_FORM, "a ring of two layers: area, EI, GJ; shear by theory (3.7)");
    for (int p = 1; p <= ELEMENT_MAX_ORDER; p++) {
        orders(p);
    }
    return test_failures != 0;
}
