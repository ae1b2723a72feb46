// tests/verify/rodsolver/verify_rod_snap.c
// A rod pressed beyond Euler's load leans to one side; pushed to the other it snaps at a limit
// point. With EA = GA the elastica gives that push, and the shapes before and behind it.
#include "tests/verify/rodsolver/loaded_rods.h"

static const double LENGTH = 0.2, EI = 3e-4; // [m, N m^2]
static const rod_options options = {.tolerance = 1e-11};

// Leaning by theta_L under the force F at the angle psi, from z towards x: eta = psi - theta,
// EI eta'^2 / 2 = F (cos eta_L - cos eta); eta = eta_L + theta_L t^2
typedef struct leaning {
    double length, x, z;
} leaning;

static void leaning_add(double F, double psi, double tip_angle, double t, double weight,
                        leaning *sum)
{
    const double tip = psi - tip_angle, turned = tip_angle * t * t, theta = tip_angle - turned;
    const double sinc = turned > 0 ? 2 * sin(turned / 2) / turned : 1;
    const double slope = 2 * F / EI * sin(tip + turned / 2) * sinc;
    const double ds = weight * 2 * sqrt(tip_angle / slope);
    sum->length += ds;
    sum->x += ds * sin(theta);
    sum->z += ds * cos(theta);
}

static leaning leaning_rod(double F, double psi, double tip_angle)
{
    enum { PANELS = 300 };
    const double half = 0.5 / PANELS, node = sqrt(0.6);
    leaning sum = {0};
    for (int i = 0; i < PANELS; i++) {
        const double middle = (2 * i + 1) * half;
        leaning_add(F, psi, tip_angle, middle - half * node, half * 5 / 9, &sum);
        leaning_add(F, psi, tip_angle, middle, half * 8 / 9, &sum);
        leaning_add(F, psi, tip_angle, middle + half * node, half * 5 / 9, &sum);
    }
    return sum;
}

// the push against the lean that holds this tip angle, negative where it takes a pull: more push
// makes the rod of this lean longer
static double push_for(double P, double tip_angle)
{
    double low = -1.5, high = fmin(tip_angle / 2, 1.5) * 0.999; // of atan(push / P)
    for (int i = 0; i < 80; i++) {
        const double delta = (low + high) / 2;
        const leaning l = leaning_rod(P / cos(delta), LOADED_PI + delta, tip_angle);
        *(l.length < LENGTH ? &low : &high) = delta;
    }
    return P * tan(low);
}

// the largest push a lean can bear, by golden sections
static double snap_push(double P, double *tip_angle)
{
    const double golden = (sqrt(5) - 1) / 2;
    double a = 0.05, b = 2.5;
    for (int i = 0; i < 60; i++) {
        const double c = b - golden * (b - a), d = a + golden * (b - a);
        if (push_for(P, c) > push_for(P, d)) {
            b = d;
        } else {
            a = c;
        }
    }
    *tip_angle = a;
    return push_for(P, a);
}

// the lean under a pull to its own side
static double lean_under(double P, double pull)
{
    double low = 0.3, high = 3.1;
    for (int i = 0; i < 80; i++) {
        const double angle = (low + high) / 2;
        *(push_for(P, angle) > -pull ? &low : &high) = angle;
    }
    return low;
}

static void leans_as_the_elastica(const solved *s, double P, double pull, double EA, int side)
{
    const double angle = lean_under(P, pull), F = hypot(P, pull);
    const leaning l = leaning_rod(F, LOADED_PI - atan2(pull, P), angle);
    CHECK_WITHIN(s->out.tip.p.a[0], side * (l.x + pull / EA * LENGTH), 1e-9 * LENGTH);
    CHECK_WITHIN(s->out.tip.p.a[2], l.z - P / EA * LENGTH, 1e-9 * LENGTH);
    CHECK(s->out.stable == 1);
}

// stiffer across and in torsion, so that only this plane buckles
static law_along flat_law(double stiff)
{
    const double EA = stiff * EI / (LENGTH * LENGTH);
    return uniform_law(LENGTH, diagonal_K(EA, EA, EA, 6 * EI, EI, 6 * EI));
}

static void pushed_over_it_snaps(double stiff, double times_euler)
{
    law_along law = flat_law(stiff);
    const double unit = EI / (LENGTH * LENGTH), EA = stiff * unit;
    const double P = times_euler * LOADED_PI * LOADED_PI / 4 * unit;
    double angle;
    // from a pull beyond the push at which it snaps back: the way stays between start and end
    const double push = snap_push(P, &angle), pull = 1.3 * push, most = 1.5 * push;
    solved s;
    rod_request request = {.tip_space = {{pull, 0, -P}}, .cold = true, .stability = true};
    solve_well(&s, &(rod_spec){.law = &law}, options, &request);
    leans_as_the_elastica(&s, P, pull, EA, 1);

    // from there, pushed: no further than the limit point, and that is said
    request.cold = false;
    request.tip_space.a[0] = -most;
    CHECK(solved_again(&s, &request) == ERR_NUMERIC);
    status_clear();
    const double wanted = (pull + push) / (pull + most);
    printf("%g times Euler: snaps at push %.10f of EI / L^2, angle %.6f; fraction %.12f, wanted "
           "%.12f\n",
           times_euler, push / unit, angle, s.out.fraction, wanted);
    CHECK_NEAR(s.out.fraction, wanted, 1e-8);
    CHECK_AT_LEAST(s.out.ncritical, 1);
    if (s.out.ncritical >= 1) {
        const rod_critical *last = &s.out.critical[s.out.ncritical - 1];
        CHECK(last->kind == CRITICAL_LIMIT);
        CHECK_NEAR(last->fraction, wanted, 1e-8);
    }
    // a limit point's place is as good as the root of its load's accuracy
    CHECK_WITHIN(atan2(s.out.tip.R.a[0][2], s.out.tip.R.a[0][0]), angle, 1e-3);
    solved_free(&s);

    // followed past it: back through the upright and over to the other side
    request = (rod_request){.tip_space = {{pull, 0, -P}}, .cold = true, .stability = true};
    solve_well(&s, &(rod_spec){.law = &law}, options, &request);
    request = (rod_request){.tip_space = {{-most, 0, -P}}, .past = true, .stability = true};
    CHECK_OK(solved_again(&s, &request));
    CHECK_WITHIN(s.out.fraction, 1, 0);
    leans_as_the_elastica(&s, P, most, EA, -1);
    CHECK(s.out.ncritical == 2);
    for (int i = 0; i < s.out.ncritical && i < 2; i++) {
        const double at = (pull + (i == 0 ? push : -push)) / (pull + most);
        CHECK(s.out.critical[i].kind == CRITICAL_LIMIT);
        CHECK_NEAR(s.out.critical[i].fraction, at, 1e-8);
        CHECK(s.out.critical[i].negative == 1 - i);
    }
    solved_free(&s);
    law_along_free(&law);
}

int main(void)
{
    against(BY_CLOSED_FORM, "the elastica beyond its limit point");
    pushed_over_it_snaps(1e5, 1.2);
    pushed_over_it_snaps(80, 1.5);
    return test_failures != 0;
}
