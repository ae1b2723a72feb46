// tests/verify/app/verify_bodies_directed.c
// Materials with directions, and moduli over the place, in bodies that turn.
#include "tests/verify/app/solved_body.h"

static double apart(const char *section, const char *rest_a, const char *rest_b)
{
    const segment_mesh ask = {.order = 2, .size = 1.5e-3};
    solved a, b;
    solve(section, rest_a, ask, 10, 1, &a);
    solve(section, rest_b, ask, 10, 1, &b);
    CHECK(!a.m.spec.shape.place && b.m.spec.shape.place);
    const double d = mat6_relative_error(a.C, b.C);
    done_with(&a);
    done_with(&b);
    return d;
}

// Fibres and moduli of a place turn with what turns them, by rate as by shape: a curvature too
// small to matter takes the other way.
static void directions_and_moduli_go_along(void)
{
    const char bent[] = "rod: {length_mm: 20, rest: {curvature_x_per_m: 1e-7}}\n"
                        "fem: {length_mm: 20, loads: []}\n";
    const char straight[] = "fem: {length_mm: 20, loads: []}\n";
    const char fibres[] =
        "  mesh: {kind: mapped}\n  shapes:\n    - {rectangle: {width_mm: 4, height_mm: 3}, "
        "material: wood, axes: section, fibre_angle_rad: 0.4, plane_angle_rad: 0.3}\n"
        "  turn_rad: 60*s\n";
    const char still[] =
        "  mesh: {kind: mapped}\n  shapes:\n    - {rectangle: {width_mm: 4, height_mm: 3}, "
        "material: graded}\n";
    const double wood = apart(fibres, straight, bent);
    const double graded =
        apart(still,
              "rod: {length_mm: 20, rest: {twist_rad_per_m: 60}}\n"
              "fem: {length_mm: 20, loads: []}\n",
              "rod: {length_mm: 20, rest: {twist_rad_per_m: 60, curvature_x_per_m: 1e-7}}\n"
              "fem: {length_mm: 20, loads: []}\n");
    printf("by rate and by shape: fibres %.1e, graded moduli %.1e apart\n", wood, graded);
    // between levels axes are interpolated, directions are not
    CHECK_BELOW(wood, 1e-6);
    CHECK_BELOW(graded, 1e-6);
}

// E along the rod is asked for where the section is
static void moduli_along_the_rod_begin_at_the_base(void)
{
    const char shapes[] =
        "  mesh: {kind: mapped}\n  shapes:\n    - {rectangle: {width_mm: 4, height_mm: 3}, "
        "material: along}\n";
    const segment_mesh ask = {.order = 2, .size = 2e-3};
    solved s;
    solve(shapes, "rod: {length_mm: 100}\nfem: {length_mm: 50, section_at_mm: 20, loads: []}\n",
          ask, 12, 1, &s);
    // int ds / (E A), E = 1 MPa (1 + 10 s), nu 0
    CHECK_NEAR(s.C.a[2][2], log(1.7 / 1.2) / 10 / (1e6 * 12e-6), 1e-6);
    done_with(&s);
}

int main(void)
{
    against(BY_SECOND_WAY, "the same turn by rate and by shape");
    directions_and_moduli_go_along();
    moduli_along_the_rod_begin_at_the_base();
    return test_failures != 0;
}
