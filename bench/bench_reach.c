// bench/bench_reach.c
// Time of a scope's forward solves and of its inverse.
#include "bench/bench.h"
#include "tests/unit/reach/scopes.h"

#include "reach/inverse.h"

enum { ROUNDS = 5, TARGETS = 400 };

typedef struct times {
    double forward, jacobian, point, make, inside, outside; // [us]
    double poses;
} times;

typedef struct bench_scope {
    scope_state *state;
    inverse *inverse;
    vec3 inside[TARGETS], outside[TARGETS];
    double q[TARGETS][SCOPE_JOINTS];
} bench_scope;

static status make_targets(const scope *s, bench_scope *b)
{
    status st = OK;
    unsigned long long seed = 1;
    for (int k = 0; k < TARGETS; k++) {
        random_joints(s, &seed, b->q[k]);
        TRY(scope_bend(b->state, b->q[k]));
        TRY(scope_tip(b->state, b->q[k], &b->inside[k], NULL));
        b->outside[k] = (vec3){{s->length * 1.1, random_between(&seed, 0, s->length), 0.05}};
    }

done:
    return st;
}

static status time_forward(const scope *s, bench_scope *b, times *t)
{
    status st = OK;
    double J[3 * SCOPE_JOINTS], sum = 0;
    vec3 tip;
    const double start = bench_cpu_ms();
    for (int k = 0; k < TARGETS; k++) {
        TRY(scope_bend(b->state, b->q[k]));
        TRY(scope_tip(b->state, b->q[k], &tip, NULL));
    }
    const double solved = bench_cpu_ms();
    for (int k = 0; k < TARGETS; k++) {
        TRY(scope_tip(b->state, b->q[TARGETS - 1], &tip, J));
    }
    const double derived = bench_cpu_ms();
    for (int k = 0; k < TARGETS; k++) {
        sum += scope_point(b->state, b->q[TARGETS - 1], s->length * k / TARGETS).a[0];
    }
    const double end = bench_cpu_ms();
    t->forward = fmin(t->forward, 1e3 * (solved - start) / TARGETS);
    t->jacobian = fmin(t->jacobian, 1e3 * (derived - solved) / TARGETS);
    t->point = fmin(t->point, sum == 0 ? NAN : 1e3 * (end - derived) / TARGETS);

done:
    return st;
}

static status time_inverse(bench_scope *b, times *t)
{
    status st = OK;
    static inverse_answer out;
    const double start = bench_cpu_ms();
    t->poses = 0;
    for (int k = 0; k < TARGETS; k++) {
        TRY(inverse_solve(b->inverse, b->state, b->inside[k], &out));
        t->poses += (double)out.npose / TARGETS;
    }
    const double inside = bench_cpu_ms();
    for (int k = 0; k < TARGETS; k++) {
        TRY(inverse_solve(b->inverse, b->state, b->outside[k], &out));
        if (out.npose > 0) {
            TRY(status_fail(ERR_BUG, "a target out of reach is reached"));
        }
    }
    const double end = bench_cpu_ms();
    t->inside = fmin(t->inside, 1e3 * (inside - start) / TARGETS);
    t->outside = fmin(t->outside, 1e3 * (end - inside) / TARGETS);

done:
    return st;
}

static status measure(const char *name, const scope *s, times *t)
{
    status st = OK;
    static bench_scope b;
    const pose entry = pose_identity();
    b = (bench_scope){0};
    *t = (times){INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, INFINITY, 0};
    TRY(scope_state_make(s, &entry, &b.state));
    const double start = bench_cpu_ms();
    TRY(inverse_make(s, &b.inverse));
    t->make = 1e3 * (bench_cpu_ms() - start);
    TRY(make_targets(s, &b));
    for (int i = 0; i < ROUNDS; i++) {
        TRY(time_forward(s, &b, t));
        TRY(time_inverse(&b, t));
    }
    printf("%-22s %9.2f %9.2f %9.2f %9.0f %9.1f %9.1f %7.2f\n", name, t->forward, t->jacobian,
           t->point, t->make, t->inside, t->outside, t->poses);

done:
    inverse_free(b.inverse);
    scope_state_free(b.state);
    return st;
}

static status all(int *missed)
{
    status st = OK;
    times t, one;
    made_scope m = arc_scope();
    printf("CPU time [us], best of %d\n%-22s %9s %9s %9s %9s %9s %9s %7s\n", ROUNDS, "scope",
           "forward", "jacobian", "point", "map", "inverse", "refusal", "poses");
    TRY(measure("constant curvature", &m.scope, &t));
    helical_scope(usual_plan, &m);
    TRY(measure("helical prototype", &m.scope, &one));
    free_scope(&m);
    for (int n = 1; n <= 3; n++) {
        neuro_scope(n, usual_plan, &m);
        TRY(measure(n == 1 ? "neuro, 1 tendon" : n == 2 ? "neuro, 2" : "neuro, 3", &m.scope, &t));
        free_scope(&m);
        *missed |= bench_target("one target out of reach", 1e-3 * t.outside, 1, "ms");
    }

done:
    return st;
}

int main(void)
{
    int missed = 0;
    const status st = all(&missed);
    if (st != OK) {
        fprintf(stderr, "bench_reach: %s\n", status_message());
    }
    return st != OK || missed;
}
