// tests/verify/rodsolver/verify_rod_buckling.c
// Loads at which rods buckle or snap against closed forms: Euler's with shear and axial strain, own
// weight, lateral buckling, a pressed rod pushed over, and what has no static bifurcation at all.
#include "tests/verify/rodsolver/loaded_rods.h"

static const double LENGTH = 0.2, EI = 3e-4; // [m, N m^2]
static const rod_options options = {.tolerance = 1e-11};
// of a critical load: where the bifurcation is bracketed to, above the solver's own tolerance
static const double AGREE = 1e-8;

static double unit_load(void)
{
    return EI / (LENGTH * LENGTH);
}

static double euler_load(void)
{
    return LOADED_PI * LOADED_PI / 4 * unit_load();
}

static void pressed_on(solved *s, const law_along *law, double P, rod_options how)
{
    solve_well(s, &(rod_spec){.law = law}, how,
               &(rod_request){.tip_space = {{0, 0, -P}}, .cold = true, .stability = true});
    // whatever became of its stability, the equilibrium that continues from rest is straight
    CHECK_WITHIN(s->out.tip.p.a[0], 0, 1e-12 * LENGTH);
    CHECK_WITHIN(s->out.tip.p.a[1], 0, 1e-12 * LENGTH);
    CHECK_NEAR(s->out.tip.p.a[2], LENGTH * (1 - P / law->law[0].K.a[NZ][NZ]), 1e-11);
}

static void pressed(solved *s, const law_along *law, double P)
{
    pressed_on(s, law, P, options);
}

static void print_criticals(const char *what, const solved *s)
{
    printf("%-40s stable %2d, eigenvalue %9.3g, criticals:", what, s->out.stable,
           s->out.eigenvalue);
    for (int i = 0; i < s->out.ncritical; i++) {
        const rod_critical *c = &s->out.critical[i];
        printf(" %s %.12f -> %d;", c->kind == CRITICAL_LIMIT ? "limit" : "bifurcation", c->fraction,
               c->negative);
    }
    printf("\n");
}

static void critical_is(const solved *s, int i, double fraction, int negative)
{
    CHECK_BELOW(i, s->out.ncritical);
    if (i < s->out.ncritical) {
        CHECK_NEAR(s->out.critical[i].fraction, fraction, AGREE);
        CHECK(s->out.critical[i].kind == CRITICAL_BIFURCATION);
        CHECK(s->out.critical[i].negative == negative);
    }
}

// --- Euler. A straight rod under -P has v_z = 1 - P / EA; a small turn theta bends it by EI
// theta'' = -P x' and x' = (v_z + P / GA) theta, so mode n buckles where
//   P (1 - P / EA + P / GA) = (2 n - 1)^2 pi^2 EI / (4 L^2)

static double cosserat_euler(double euler, double EA, double GA)
{
    const double c = 1 / GA - 1 / EA;
    return 2 * euler / (1 + sqrt(1 + 4 * euler * c));
}

// shear softens, axial strain stiffens; both planes, each with its own load
static void columns_buckle_as_euler_reissner(void)
{
    static const double ratio[][2] = {{1e8, 1e8}, {60, 60}, {1e5, 12}, {14, 1e5}, {30, 9}};
    for (int i = 0; i < 5; i++) {
        const double E = euler_load(), EA = ratio[i][0] * E, GA = ratio[i][1] * E;
        law_along law = uniform_law(LENGTH, diagonal_K(GA, GA, EA, 1.5 * EI, EI, 0.8 * EI));
        const double first = cosserat_euler(E, EA, GA), second = cosserat_euler(1.5 * E, EA, GA);
        solved s;
        pressed(&s, &law, 1.2 * second);
        print_criticals("column", &s);
        CHECK(s.out.ncritical == 2 && s.out.stable == 0);
        critical_is(&s, 0, first / (1.2 * second), 1);
        critical_is(&s, 1, 1 / 1.2, 2);
        solved_free(&s);
        pressed(&s, &law, 0.99 * first);
        CHECK(s.out.ncritical == 0 && s.out.stable == 1);
        CHECK_ABOVE(s.out.eigenvalue, 0);
        solved_free(&s);
        law_along_free(&law);
    }
}

// the first three modes of a round column: two directions at once each time. The third has waves
// that a straight column's few panels do not show to so many digits
static void round_columns_buckle_both_ways(void)
{
    law_along law = uniform_law(LENGTH, diagonal_K(1e6 * euler_load(), 1e6 * euler_load(),
                                                   1e6 * euler_load(), EI, EI, 0.8 * EI));
    solved s;
    pressed_on(&s, &law, 30 * euler_load(), (rod_options){.npanel = 64});
    print_criticals("round column, to 30 times Euler", &s);
    CHECK(s.out.stable == 0);
    CHECK_ABOVE(s.out.ncritical, 0);
    for (int i = 0; i < s.out.ncritical; i++) {
        const double load = 30 * s.out.critical[i].fraction;
        const double mode = load < 5 ? 1 : load < 17 ? 9 : 25;
        CHECK_NEAR(load, mode, AGREE);
    }
    const int last = s.out.ncritical - 1;
    CHECK(last < 0 || s.out.critical[last].negative == 6);
    solved_free(&s);
    law_along_free(&law);
}

// EA between: P (1 - P / EA) grows past Euler's load and falls below it again. Shorter than EA = 4
// times Euler's load it never gets there, down to 30 % of the length
static void stocky_columns_straighten_or_never_buckle(void)
{
    const double E = euler_load(), GA = 1e7 * E;
    law_along law = uniform_law(LENGTH, diagonal_K(GA, GA, 4.5 * E, 40 * EI, EI, EI));
    const double c = 1 / GA - 1 / (4.5 * E), root = sqrt(1 + 4 * E * c);
    const double load[] = {2 * E / (1 + root), 2 * E / (1 - root)}, P = 0.7 * 4.5 * E;
    solved s;
    pressed(&s, &law, P);
    print_criticals("EA = 4.5 Euler loads, to 30 %", &s);
    CHECK(s.out.ncritical == 2 && s.out.stable == 1);
    critical_is(&s, 0, load[0] / P, 1);
    critical_is(&s, 1, load[1] / P, 0);
    solved_free(&s);
    law_along_free(&law);

    law = uniform_law(LENGTH, diagonal_K(GA, GA, 3 * E, 40 * EI, EI, EI));
    pressed(&s, &law, 0.7 * 3 * E);
    print_criticals("EA = 3 Euler loads, to 30 %", &s);
    CHECK(s.out.ncritical == 0 && s.out.stable == 1);
    solved_free(&s);
    law_along_free(&law);
}

// the eigenvalue against the elastic energy falls as 1 - P / Euler where nothing stretches or
// shears
static void eigenvalue_falls_with_the_load(void)
{
    law_along law = even_law(LENGTH, EI, EI, 1e8);
    for (int i = 0; i < 5; i++) {
        const double part = 0.2 * i;
        solved s;
        pressed(&s, &law, part * euler_load());
        CHECK_WITHIN(s.out.eigenvalue, 1 - part, 1e-6);
        solved_free(&s);
    }
    law_along_free(&law);
}

// --- Bessel's J_nu(x) x^-nu up to a constant, and its first zero

static double bessel_part(double nu, double x)
{
    double sum = 1, term = 1;
    for (int k = 1; k < 60; k++) {
        term *= -x * x / 4 / (k * (k + nu));
        sum += term;
    }
    return sum;
}

static double bessel_zero(double nu)
{
    double low = 0, high = 2.4; // the first zero of J_0 is beyond those of nu < 0
    for (int i = 0; i < 100; i++) {
        const double x = (low + high) / 2;
        *(bessel_part(nu, x) > 0 ? &low : &high) = x;
    }
    return low;
}

// Own weight: EI theta'' = -q (L - s) theta with EA = GA, whatever they are; q L^3 / EI = 7.8373
// (Greenhill 1881), with gravity on the law's mass and as a line load
static void rods_buckle_under_their_weight(bool gravity)
{
    const double x = bessel_zero(-1.0 / 3), q = 9.0 / 4 * x * x * EI / pow(LENGTH, 3);
    CHECK_WITHIN(9.0 / 4 * x * x, 7.8373, 0.5e-4);
    for (int i = 0; i < 2; i++) {
        law_along law = even_law(LENGTH, EI, EI, i == 0 ? 1e7 : 50);
        law.law[0].K.a[MX][MX] *= 2;
        const double g = 9.81, most = 1.4;
        law.law[0].mass = most * q / g;
        const line_load weight = {.force[2] = field_constant(-most * q)};
        rod_spec spec = {.law = &law, .gravity = {0, 0, -g}};
        if (!gravity) {
            spec = (rod_spec){.law = &law, .nline_load = 1, .line_loads = &weight};
        }
        solved s;
        solve_well(&s, &spec, options, &(rod_request){.cold = true, .stability = true});
        print_criticals(gravity ? "own weight by gravity" : "own weight by a line load", &s);
        CHECK(s.out.ncritical == 1 && s.out.stable == 0);
        critical_is(&s, 0, 1 / most, 1);
        solved_free(&s);
        law_along_free(&law);
    }
}

// Lateral buckling of a narrow cantilever: F L^2 / sqrt(EI GJ) = 4.0126 (Prandtl, Michell 1899),
// the stiff way so stiff that what it bends before is 1e-8
static void narrow_cantilevers_buckle_sideways(void)
{
    const double x = bessel_zero(-0.25), GJ = 0.6 * EI, stiff = 1e8;
    CHECK_WITHIN(2 * x, 4.013, 0.5e-3);
    const double EA = 1e8 * unit_load(), F = 2 * x * sqrt(EI * GJ) / (LENGTH * LENGTH), most = 1.2;
    law_along law = uniform_law(LENGTH, diagonal_K(EA, EA, EA, EI, stiff * EI, GJ));
    solved s;
    solve_well(&s, &(rod_spec){.law = &law}, options,
               &(rod_request){.tip_space = {{most * F}}, .cold = true, .stability = true});
    print_criticals("narrow cantilever", &s);
    CHECK(s.out.ncritical == 1 && s.out.stable == 0);
    if (s.out.ncritical == 1) {
        // EI / EI_stiff, squared corrections and the load's own
        CHECK_NEAR(s.out.critical[0].fraction, 1 / most, 1e-7);
        CHECK(s.out.critical[0].kind == CRITICAL_BIFURCATION && s.out.critical[0].negative == 1);
    }
    solved_free(&s);
    law_along_free(&law);
}

// --- what cannot buckle statically: a follower force along the axis (Beck) has its shape fixed
// from the tip on; a torque about a fixed axis at the free end (Ziegler) leaves EI u'' - i M u' + P
// (u - u_L) = 0 without a solution but 0 for M != 0, whatever P

static void nothing_static_happens(void)
{
    law_along law = even_law(LENGTH, EI, 0.7 * EI, 1e4);
    const double P = 30 * unit_load();
    solved s;
    solve_well(&s, &(rod_spec){.law = &law}, options,
               &(rod_request){.tip_body = {{0, 0, -P}}, .cold = true, .stability = true});
    print_criticals("follower force", &s);
    CHECK(s.out.ncritical == 0 && s.out.stable == -1);
    CHECK_NEAR(s.out.tip.p.a[2], LENGTH * (1 - P / law.law[0].K.a[NZ][NZ]), 1e-11);
    solved_free(&s);

    const double M = 3 * EI / LENGTH;
    solve_well(&s, &(rod_spec){.law = &law}, options,
               &(rod_request){.tip_space = {{0, 0, -2 * euler_load(), 0, 0, M}},
                              .cold = true,
                              .stability = true});
    print_criticals("dead force and torque", &s);
    CHECK(s.out.ncritical == 0 && s.out.stable == -1);
    CHECK_WITHIN(turn_gap(s.out.tip.R, mat3_rot_z(M * LENGTH / (0.7 * EI))), 0, 1e-9);
    solved_free(&s);
    law_along_free(&law);
}

int main(void)
{
    against(BY_CLOSED_FORM,
            "Euler with shear and stretch (Reissner); Greenhill 1881; Prandtl and Michell 1899");
    columns_buckle_as_euler_reissner();
    round_columns_buckle_both_ways();
    stocky_columns_straighten_or_never_buckle();
    eigenvalue_falls_with_the_load();
    rods_buckle_under_their_weight(true);
    rods_buckle_under_their_weight(false);
    narrow_cantilevers_buckle_sideways();
    nothing_static_happens();
    return test_failures != 0;
}
