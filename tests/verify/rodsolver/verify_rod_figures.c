// tests/verify/rodsolver/verify_rod_figures.c
// What Fig. 8 of the paper must show: curvature along the helical prototype at 0.98 N (classical
// section, nu = 0.45, tendon at 3.6 mm). Fig. 7's bends stand in verify_errata_rod.
#include "tests/unit/rodsolver/prototypes.h"

enum { POINTS = 241 };

typedef struct curvature {
    double x, y, size; // [1/m]
} curvature;

static void curvatures(curvature *k)
{
    const prototype p = helical_nc();
    law_along law = {0};
    prototype_law(&p, &law);
    const tendon_spec t = straight_tendon("a", 3.6e-3, PROTOTYPE_PI / 2);
    const double tau = 0.98;
    rod_solution out = {0};
    const made_rod r = solved_rod(&law, 1, &t, (rod_options){.tolerance = 1e-9}, &tau, &out);
    for (int i = 0; i < POINTS; i++) {
        vec6 xi;
        CHECK_OK(rod_strain_at(r.state, p.length * i / (POINTS - 1), &xi));
        k[i] = (curvature){xi.a[3], xi.a[4], hypot(xi.a[3], xi.a[4])};
    }
    free_rod(r);
    law_along_free(&law);
}

static void curvature_falls_in_the_middle_and_rises_again(void)
{
    static curvature k[POINTS];
    curvatures(k);
    int low = 0;
    for (int i = 1; i < POINTS; i++) {
        low = k[i].size < k[low].size ? i : low;
    }
    printf("curvature %.2f -> %.2f at %.3f L -> %.2f 1/m\n", k[0].size, k[low].size,
           (double)low / (POINTS - 1), k[POINTS - 1].size);
    CHECK_WITHIN(k[0].size, 37.5, 0.05);
    CHECK_WITHIN(k[low].size, 6.2, 0.05);
    CHECK_WITHIN(k[POINTS - 1].size, 45, 0.5);
    CHECK_ABOVE(low, 0.4 * POINTS);
    CHECK_BELOW(low, 0.6 * POINTS);
    for (int i = 1; i < POINTS; i++) {
        CHECK(i <= low ? k[i].size < k[i - 1].size : k[i].size > k[i - 1].size);
    }
}

// at L/2 the stiff sector lies under the tendon: the section is symmetric about the y axis, and w_y
// changes sign
static void one_component_changes_sign_in_the_middle(void)
{
    static curvature k[POINTS];
    curvatures(k);
    const int half = (POINTS - 1) / 2;
    CHECK_WITHIN(k[half].y, 0, 1e-9);
    CHECK_BELOW(k[half - 1].y * k[half + 1].y, 0);
    for (int i = 1; i < POINTS - 1; i++) {
        CHECK(i == half || (k[i].y > 0) == (i < half ? k[1].y > 0 : k[1].y < 0));
    }
}

int main(void)
{
    against(BY_PUBLISHED, "the paper's Fig. 8");
    curvature_falls_in_the_middle_and_rises_again();
    one_component_changes_sign_in_the_middle();
    return test_failures != 0;
}
