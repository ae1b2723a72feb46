// examples/control_loop.c
// A control loop around the rod solver: two tendons make the tip of a soft tube go round a circle
// while a small weight hangs on it. Every millisecond the tensions take one Newton step towards the
// target with the Jacobian of the last answer, and the rod is solved from there. Nothing is
// allocated in the loop.
//
//   cc control_loop.c $(pkg-config --cflags --libs stiffaxis-rod) -lm
#include <stiffaxis/rod.h>

#include <math.h>
#include <stdio.h>
#include <time.h>

#define PI 3.14159265358979323846

enum {
    TENDONS = 2,
    TICKS = 4000,
    FIRST_TICKS = 20, // these find the way from rest
};
static const double length = 0.12; // of the rod [m]
static const double period = 1e-3; // of the loop [s]

// A tube of silicone: the same stiffness everywhere, so that one node on one panel says it all.
static status tube_law(law_along *law)
{
    const double E = 0.66e6, nu = 0.45, outer = 4e-3, inner = 3.2e-3;
    const double area = PI * (outer * outer - inner * inner);
    const double moment = PI / 4 * (pow(outer, 4) - pow(inner, 4));
    const double G = E / (2 * (1 + nu));
    const double diagonal[6] = {G * area,   G * area,   E * area,
                                E * moment, E * moment, 2 * G * moment};
    const status st = law_along_make(length, 1, 1, law);
    for (int i = 0; st == OK && i < 6; i++) {
        law->law[0].K.a[i][i] = diagonal[i];
    }
    return st;
}

// a circle of 10 mm, once in two seconds, entered slowly [m]
static void target_at(double t, double target[2])
{
    const double size = 10e-3 * (1 - exp(-2 * t)), angle = PI * t;
    target[0] = 25e-3 + size * cos(angle);
    target[1] = 15e-3 + size * sin(angle);
}

// How the tip moves sideways by the tensions: the columns of rod_derive are body twists (v, w), and
// the tip moves with R v.
static status tip_jacobian(rod_state *state, const pose *tip, double J[2][TENDONS])
{
    vec6 column[TENDONS];
    const rod_derivatives wanted = {.tension = column};
    const status st = rod_derive(state, length, &wanted);
    for (int j = 0; st == OK && j < TENDONS; j++) {
        for (int i = 0; i < 2; i++) {
            J[i][j] = 0;
            for (int c = 0; c < 3; c++) {
                J[i][j] += tip->R.a[i][c] * column[j].a[c];
            }
        }
    }
    return st;
}

// one Newton step of the tensions; a tendon cannot push
static void step(double J[2][TENDONS], const double miss[2], double tension[TENDONS])
{
    const double det = J[0][0] * J[1][1] - J[0][1] * J[1][0];
    tension[0] = fmax(0, tension[0] + (J[1][1] * miss[0] - J[0][1] * miss[1]) / det);
    tension[1] = fmax(0, tension[1] + (J[0][0] * miss[1] - J[1][0] * miss[0]) / det);
}

static double seconds(void)
{
    struct timespec now;
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

typedef struct record {
    double worst_error, slowest, total; // [m, s, s]
} record;

static status run(rod_state *state, record *out)
{
    double tension[TENDONS] = {0.1, 0.1};
    rod_solution answer = {0};
    const rod_request request = {.tension = tension, .tip_space = {{0, -2e-3}}}; // 0.2 g on the tip
    status st = rod_solve(state, &request, &answer);
    for (int tick = 0; st == OK && tick < TICKS; tick++) {
        double target[2], J[2][TENDONS];
        const double begin = seconds();
        target_at(tick * period, target);
        const double miss[2] = {target[0] - answer.tip.p.a[0], target[1] - answer.tip.p.a[1]};
        st = tip_jacobian(state, &answer.tip, J);
        if (st == OK) {
            step(J, miss, tension);
            st = rod_solve(state, &request, &answer);
        }
        const double taken = seconds() - begin;
        const double error = hypot(target[0] - answer.tip.p.a[0], target[1] - answer.tip.p.a[1]);
        out->total += taken;
        if (tick >= FIRST_TICKS) {
            out->slowest = fmax(out->slowest, taken);
            out->worst_error = fmax(out->worst_error, error);
        }
    }
    return st;
}

int main(void)
{
    const tendon_spec tendons[TENDONS] = {
        {.name = "right", .radius = field_constant(3.6e-3), .angle = field_constant(0)},
        {.name = "up", .radius = field_constant(3.6e-3), .angle = field_constant(PI / 2)},
    };
    law_along law = {0};
    rod *r = NULL;
    rod_state *state = NULL;
    record seen = {0};

    status st = tube_law(&law);
    const rod_spec spec = {.law = &law, .ntendon = TENDONS, .tendons = tendons};
    if (st == OK) {
        st = rod_make(&spec, &(rod_options){.tolerance = 1e-6}, &r); // once: 0.12 um at the tip
    }
    if (st == OK) {
        st = rod_state_make(r, &state); // once per thread
    }
    if (st == OK) {
        st = run(state, &seen);
    }
    if (st == OK) {
        printf("%d ticks of %g ms: %.1f us each, slowest %.0f us: %.0f per second\n", TICKS,
               1e3 * period, 1e6 * seen.total / TICKS, 1e6 * seen.slowest, TICKS / seen.total);
        printf("tip off its target by %.2g um at most, once it is there\n", 1e6 * seen.worst_error);
    } else {
        fprintf(stderr, "control_loop: %s\n", status_message());
    }
    rod_state_free(state);
    rod_free(r);
    law_along_free(&law);
    return st;
}
