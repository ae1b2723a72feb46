// tests/unit/app/test_total_bend.c
// The angle between the tangents of a rod's two ends, followed past pi.
#include "app/chain.h"

#include "tests/test.h"

enum { POSES = 181 };

// tangents that lean by angle(t) towards direction(t), t from 0 to 1
static double bend_of(double (*angle)(double), double (*direction)(double))
{
    static pose shape[POSES];
    for (int i = 0; i < POSES; i++) {
        const double t = (double)i / (POSES - 1), b = angle(t), d = direction(t);
        shape[i] = pose_identity();
        shape[i].R = so3_exp((vec3){{-b * sin(d), b * cos(d), 0}});
    }
    return chain_total_bend(POSES, shape);
}

static double none(double t)
{
    (void)t;
    return 0;
}

static double slanted(double t)
{
    (void)t;
    return 0.7;
}

static double turning(double t)
{
    return 3 * t;
}

static double arc_226(double t)
{
    return 226 * M_PI / 180 * t;
}

static double two_turns(double t)
{
    return 4.2 * M_PI * t;
}

static double there_and_back(double t)
{
    return t < 0.5 ? 3 * t : 3 * (1 - t) - 0.4 * (t - 0.5);
}

static double gentle(double t)
{
    return 1.2 * t;
}

static void a_straight_rod_does_not_bend(void)
{
    CHECK_WITHIN(bend_of(none, none), 0, 1e-15);
}

static void plane_arcs_count_past_half_a_turn(void)
{
    CHECK_NEAR(bend_of(arc_226, none), 226 * M_PI / 180, 1e-12);
    CHECK_NEAR(bend_of(arc_226, slanted), 226 * M_PI / 180, 1e-12);
    CHECK_NEAR(bend_of(two_turns, slanted), 4.2 * M_PI, 1e-12);
}

// 0.2 rad to the other side
static void bending_back_is_taken_off(void)
{
    CHECK_WITHIN(bend_of(there_and_back, slanted), 0.2, 1e-12);
}

// out of plane it is the angle between the two tangents
static void a_turning_direction_adds_nothing(void)
{
    CHECK_NEAR(bend_of(gentle, turning), 1.2, 1e-12);
}

int main(void)
{
    a_straight_rod_does_not_bend();
    plane_arcs_count_past_half_a_turn();
    bending_back_is_taken_off();
    a_turning_direction_adds_nothing();
    return test_failures != 0;
}
