// tests/verify/rodsolver/verify_rod_elastica.c
// Rods under tip loads against closed forms: the elastica under dead and follower forces, circles
// and helices under moments. With EA = GA a rod's rotations are those of the inextensible one, so
// the elliptic integrals are exact for soft rods too; where they differ one quadrature is left.
#include "tests/verify/rodsolver/elliptic.h"
#include "tests/verify/rodsolver/loaded_rods.h"

static const double LENGTH = 0.12, EI = 2e-4, GJ = 1.5e-4; // [m, N m^2]
static const rod_options options = {.tolerance = 1e-12};
// ten times what a chain of panels rounds to at most over ten turns, far below the table's row
static const double AGREE = 1e-10;

typedef struct planar_tip {
    double x, z, angle; // [m, m, rad], the angle from z towards x
} planar_tip;

// --- the elastica under a dead force along x: theta' = sqrt(2 F / EI (sin theta_L - sin theta)),
// 1 + sin theta = 2 k^2 sin^2 phi

static double dead_modulus(double alpha)
{
    double low = sqrt(0.5), high = 1 - 1e-15;
    for (int i = 0; i < 200; i++) {
        const double k = (low + high) / 2, first = asin(1 / (k * sqrt(2)));
        if (jacobi_functions(0, k).K - legendre_f(first, k) < sqrt(alpha)) {
            low = k;
        } else {
            high = k;
        }
    }
    return (low + high) / 2;
}

// over the length, alpha = F L^2 / EI
static planar_tip dead_elastica(double alpha)
{
    const double k = dead_modulus(alpha), first = asin(1 / (k * sqrt(2)));
    const double sine = 2 * k * k - 1; // of the tip's angle
    const jacobi j = jacobi_functions(0, k);
    const double x = 1 - 2 * (j.E - legendre_e(first, k)) / sqrt(alpha);
    return (planar_tip){x, sqrt(2 * sine / alpha), asin(sine)};
}

// --- under a follower force at the angle beta from the tip's tangent: seen from the force, zeta =
// pi - (psi - theta) swings as a pendulum from rest at the tip, zeta = 2 asin(k cd(sqrt(alpha)))

static planar_tip follower_elastica(double alpha, double beta)
{
    const double a = sqrt(alpha), k = sin((LOADED_PI - beta) / 2), k2 = k * k;
    const jacobi j = jacobi_functions(a, k);
    const double cd = j.cn / j.dn;
    const double angle = LOADED_PI - beta - 2 * asin(k * cd), psi = angle + beta;
    const double along = (2 * (a - j.epsilon + k2 * j.sn * cd) - a) / a;
    const double across = 2 * k * sqrt(1 - k2) * j.sn / j.dn / a;
    // the tangent is `along` the force and `across` it, on the side it turns away from
    return (planar_tip){along * sin(psi) - across * cos(psi), along * cos(psi) + across * sin(psi),
                        angle};
}

// --- EA and GA unlike: EI eta'^2 / 2 = F (cos eta_L - cos eta) (1 + F c (cos eta_L + cos eta) /
// 2), c = 1/EA - 1/GA, eta = psi - theta; one quadrature in t, eta = eta_L + theta_L t^2

typedef struct extensible {
    double F, psi, EA, GA;
} extensible;

typedef struct arc {
    double length, x, z;
} arc;

static void arc_add(const extensible *e, double tip_angle, double t, double weight, arc *sum)
{
    const double c = 1 / e->EA - 1 / e->GA, tip = e->psi - tip_angle;
    const double turned = tip_angle * t * t, eta = tip + turned, theta = e->psi - eta;
    const double sinc = turned > 0 ? 2 * sin(turned / 2) / turned : 1;
    const double slope =
        2 * e->F / EI * sin((eta + tip) / 2) * sinc * (1 + e->F * c * (cos(tip) + cos(eta)) / 2);
    const double ds = weight * 2 * sqrt(tip_angle / slope);
    const double stretch = 1 + e->F * cos(eta) / e->EA, shear = e->F * sin(eta) / e->GA;
    sum->length += ds;
    sum->x += ds * (stretch * sin(theta) + shear * cos(theta));
    sum->z += ds * (stretch * cos(theta) - shear * sin(theta));
}

static arc extensible_arc(const extensible *e, double tip_angle)
{
    enum { PANELS = 400 };
    const double half = 0.5 / PANELS, node = sqrt(0.6);
    arc sum = {0};
    for (int i = 0; i < PANELS; i++) {
        const double middle = (2 * i + 1) * half;
        arc_add(e, tip_angle, middle - half * node, half * 5 / 9, &sum);
        arc_add(e, tip_angle, middle, half * 8 / 9, &sum);
        arc_add(e, tip_angle, middle + half * node, half * 5 / 9, &sum);
    }
    return sum;
}

static planar_tip extensible_elastica(const extensible *e)
{
    double low = 0, high = e->psi * (1 - 1e-12);
    for (int i = 0; i < 100; i++) {
        const double angle = (low + high) / 2;
        if (extensible_arc(e, angle).length < LENGTH) {
            low = angle;
        } else {
            high = angle;
        }
    }
    const arc a = extensible_arc(e, low);
    return (planar_tip){a.x, a.z, low};
}

// --- the closed forms themselves

static void integrals_agree_with_each_other_and_with_tables(void)
{
    for (double k = 0.1; k < 1; k += 0.2) {
        for (double phi = 0.2; phi < 1.5; phi += 0.4) {
            const double u = legendre_f(phi, k);
            CHECK_NEAR(jacobi_functions(u, k).am, phi, 1e-14);
            CHECK_NEAR(jacobi_functions(u, k).epsilon, legendre_e(phi, k), 1e-14);
        }
    }
    // Abramowitz and Stegun, table 17.1, m = 1/2
    CHECK_NEAR(jacobi_functions(0, sqrt(0.5)).K, 1.854074677301372, 1e-15);
    CHECK_NEAR(jacobi_functions(0, sqrt(0.5)).E, 1.350643881047675, 1e-15);
}

// Mattiasson, Int. J. Numer. Meth. Engng. 17 (1981) 145-153, table I: w / L, u / L, 2 theta / pi
typedef struct table_row {
    double alpha, w, u;
} table_row;

static const table_row mattiasson[] = {
    {1, 0.30172, 0.05643}, {2, 0.49346, 0.16064}, {5, 0.71379, 0.38763}, {10, 0.81061, 0.55500}};

static void tables_have_these_digits(void)
{
    for (int i = 0; i < 4; i++) {
        const table_row *row = &mattiasson[i];
        const planar_tip tip = dead_elastica(row->alpha);
        CHECK_WITHIN(tip.x, row->w, 0.5e-5);
        CHECK_WITHIN(1 - tip.z, row->u, 0.5e-5);
    }
}

// the quadrature knows nothing of elliptic integrals
static void quadrature_agrees_with_the_integrals(void)
{
    for (int i = 0; i < 4; i++) {
        const double F = mattiasson[i].alpha * EI / (LENGTH * LENGTH), never = 1e300;
        const planar_tip by_arc =
            extensible_elastica(&(extensible){F, LOADED_PI / 2, never, never});
        const planar_tip by_integrals = dead_elastica(mattiasson[i].alpha);
        CHECK_NEAR(by_arc.x, by_integrals.x * LENGTH, 1e-12);
        CHECK_NEAR(by_arc.z, by_integrals.z * LENGTH, 1e-12);
        CHECK_NEAR(by_arc.angle, by_integrals.angle, 1e-12);
    }
}

// --- the rod

static double error_of(const char *what, double value, const solved *s, planar_tip wanted)
{
    about("%s", what);
    const double error = hypot(s->out.tip.p.a[0] - wanted.x, s->out.tip.p.a[2] - wanted.z) / LENGTH;
    const double R[9] = {cos(wanted.angle),  0, sin(wanted.angle), 0, 1, 0,
                         -sin(wanted.angle), 0, cos(wanted.angle)};
    double turn = 0;
    for (int i = 0; i < 9; i++) {
        turn = fmax(turn, fabs(s->out.tip.R.a[i / 3][i % 3] - R[i]));
    }
    printf("%-34s %8g  tip %9.2e  turn %9.2e  estimate %9.2e  stable %2d  steps %d\n", what, value,
           error, turn, s->out.relative_error, s->out.stable, s->out.iterations);
    CHECK_WITHIN(error, 0, AGREE);
    CHECK_WITHIN(turn, 0, AGREE);
    CHECK_WITHIN(s->out.tip.p.a[1], 0, 0); // a plane problem stays plane
    return error;
}

static void dead_force_bends_as_mattiasson(double stiff)
{
    law_along law = even_law(LENGTH, EI, GJ, stiff);
    for (int i = 0; i < 4; i++) {
        const table_row *row = &mattiasson[i];
        const double F = row->alpha * EI / (LENGTH * LENGTH), EA = law.law[0].K.a[NZ][NZ];
        planar_tip wanted = dead_elastica(row->alpha);
        wanted.x = wanted.x * LENGTH + LENGTH * F / EA;
        wanted.z *= LENGTH;
        solved s;
        solve_well(&s, &(rod_spec){.law = &law}, options,
                   &(rod_request){.tip_space = {{F}}, .cold = true, .stability = true});
        error_of("dead force, alpha", row->alpha, &s, wanted);
        CHECK(s.out.stable == 1 && s.out.ncritical == 0);
        CHECK_ABOVE(s.out.eigenvalue, 0);
        if (stiff > 1e7) {
            CHECK_WITHIN(s.out.tip.p.a[0] / LENGTH, row->w, 0.51e-5);
            CHECK_WITHIN(1 - s.out.tip.p.a[2] / LENGTH, row->u, 0.51e-5);
        }
        solved_free(&s);
    }
    law_along_free(&law);
}

// dead forces in any direction, nearly against the rod and beyond Euler's load too, EA unlike GA
static void dead_force_bends_soft_rods(void)
{
    static const double degrees[] = {20, 90, 150, 175}, alpha[] = {0.5, 3, 8};
    static const double ratio[][2] = {{40, 15}, {1e5, 40}, {40, 1e5}};
    for (int i = 0; i < 4 * 3 * 3; i++) {
        const double *r = ratio[i % 3], unit = EI / (LENGTH * LENGTH);
        const extensible e = {alpha[i / 3 % 3] * unit, degrees[i / 9] * LOADED_PI / 180,
                              r[0] * unit, r[1] * unit};
        law_along law = uniform_law(LENGTH, diagonal_K(e.GA, e.GA, e.EA, EI, EI, GJ));
        solved s;
        solve_well(
            &s, &(rod_spec){.law = &law}, options,
            &(rod_request){.tip_space = {{e.F * sin(e.psi), 0, e.F * cos(e.psi)}}, .cold = true});
        error_of("dead force, EA unlike GA, at deg", degrees[i / 9], &s, extensible_elastica(&e));
        solved_free(&s);
        law_along_free(&law);
    }
}

static void follower_force_bends_as_a_pendulum(double stiff)
{
    static const double alpha[] = {1, 5, 13.75, 30}, degrees[] = {90, 45, 135};
    law_along law = even_law(LENGTH, EI, GJ, stiff);
    for (int i = 0; i < 12; i++) {
        const double beta = degrees[i / 4] * LOADED_PI / 180;
        const double F = alpha[i % 4] * EI / (LENGTH * LENGTH), EA = law.law[0].K.a[NZ][NZ];
        planar_tip wanted = follower_elastica(alpha[i % 4], beta);
        const double psi = wanted.angle + beta;
        wanted.x = LENGTH * (wanted.x + F / EA * sin(psi));
        wanted.z = LENGTH * (wanted.z + F / EA * cos(psi));
        solved s;
        solve_well(&s, &(rod_spec){.law = &law}, options,
                   &(rod_request){.tip_body = {{F * sin(beta), 0, F * cos(beta)}}, .cold = true});
        error_of("follower force, alpha", alpha[i % 4], &s, wanted);
        CHECK(s.out.stable == -1); // no potential
        solved_free(&s);
    }
    law_along_free(&law);
}

// M = 2 pi n EI / L closes n circles, whether the moment keeps its axis or follows
static void moment_closes_circles(int coils, bool follower)
{
    law_along law = even_law(LENGTH, EI, GJ, 1e4);
    const vec6 moment = {{0, 0, 0, 0, 2 * LOADED_PI * coils * EI / LENGTH, 0}};
    rod_request request = {.cold = true};
    *(follower ? &request.tip_body : &request.tip_space) = moment;
    solved s;
    solve_well(&s, &(rod_spec){.law = &law}, options, &request);
    error_of(follower ? "follower moment, coils" : "dead moment, coils", coils, &s,
             (planar_tip){0});
    CHECK_NEAR(s.out.max_strain.a[4], moment.a[4] / EI, 1e-12);
    solved_free(&s);
    law_along_free(&law);
}

// a tendon with tau r = 2 pi n EI / L does it too: arcs of length (1 - tau / EA) L
static void tendon_closes_circles(int coils)
{
    law_along law = even_law(LENGTH, EI, GJ, 1e6);
    const double radius = 1e-3, tau = 2 * LOADED_PI * coils * EI / (LENGTH * radius);
    const tendon_spec tendon = {.radius = field_constant(radius)};
    solved s;
    solve_well(&s, &(rod_spec){.law = &law, .ntendon = 1, .tendons = &tendon}, options,
               &(rod_request){.tension = &tau, .cold = true});
    error_of("tendon, coils", coils, &s, (planar_tip){0});
    solved_free(&s);
    law_along_free(&law);
}

// Round rods under moments in any direction: R(s) = exp(s M / EI) exp(s (1/GJ - 1/EI) M_z e_z) from
// the end at which M is given, the base for a dead moment and the tip for a follower
static pose helix_from_there(vec3 M, double s)
{
    const vec6 twist = {{0, 0, 1, M.a[0] / EI, M.a[1] / EI, M.a[2] / EI}};
    pose g = se3_exp(vec6_scale(s, twist));
    g.R = mat3_mul(g.R, mat3_rot_z(s * (1 / GJ - 1 / EI) * M.a[2]));
    return g;
}

static void moments_bend_into_helices(void)
{
    law_along law = even_law(LENGTH, EI, GJ, 1e4);
    static const double directions[][3] = {{1, 0, 1}, {0.3, -0.8, 0.5}, {0, 0.05, 3}, {2, 1, -2}};
    for (int i = 0; i < 8; i++) {
        const double *d = directions[i % 4];
        const vec3 M = vec3_scale(4 * EI / LENGTH, vector(d[0], d[1], d[2]));
        const bool follower = i >= 4;
        rod_request request = {.cold = true};
        *(follower ? &request.tip_body : &request.tip_space) = wrench_of(vector(0, 0, 0), M);
        solved s;
        solve_well(&s, &(rod_spec){.law = &law}, options, &request);
        const pose wanted =
            follower ? pose_inverse(helix_from_there(M, -LENGTH)) : helix_from_there(M, LENGTH);
        printf("%s moment, helix: tip %9.2e  turn %9.2e\n", follower ? "follower" : "dead",
               gap(s.out.tip.p, wanted.p) / LENGTH, turn_gap(s.out.tip.R, wanted.R));
        CHECK_WITHIN(gap(s.out.tip.p, wanted.p) / LENGTH, 0, AGREE);
        CHECK_WITHIN(turn_gap(s.out.tip.R, wanted.R), 0, AGREE);
        solved_free(&s);
    }
    law_along_free(&law);
}

int main(void)
{
    against(BY_CLOSED_FORM, "elliptic integrals of the elastica; Mattiasson, Int. J. Numer. Meth. "
                            "Engng 17 (1981) 145-153, table I; circles and helices");
    integrals_agree_with_each_other_and_with_tables();
    tables_have_these_digits();
    quadrature_agrees_with_the_integrals();
    dead_force_bends_as_mattiasson(30);
    dead_force_bends_as_mattiasson(1e8);
    dead_force_bends_soft_rods();
    follower_force_bends_as_a_pendulum(40);
    follower_force_bends_as_a_pendulum(1e8);
    for (int coils = 1; coils <= 10; coils += 9) {
        moment_closes_circles(coils, false);
        moment_closes_circles(coils, true);
        tendon_closes_circles(coils);
    }
    moments_bend_into_helices();
    return test_failures != 0;
}
