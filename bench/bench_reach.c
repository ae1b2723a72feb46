// bench/bench_reach.c
// Time of a scope's forward solves, of its inverse and of its search in a surface of 100,000
// triangles.
#include "base/memory.h"
#include "bench/bench.h"
#include "tests/unit/reach/scopes.h"

#include "reach/inverse.h"
#include "reach/reach_map.h"
#include "reach/scope_room.h"

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

// --- in a surface

enum { ROWS = 160, COLUMNS = 320, CORNERS = 2 * ROWS * COLUMNS, WANTED = 20 };

// a bent ellipsoid, flat as ventricles are, about the entry line
static vec3 wall(int row, int column)
{
    const double a = PROTOTYPE_PI * row / ROWS, b = 2 * PROTOTYPE_PI * (column % COLUMNS) / COLUMNS;
    const double r = row % ROWS ? 0.018 * sin(a) : 0;
    return (vec3){{r * cos(b) + 4e-3 * sin(a), 0.5 * r * sin(b), 0.035 - 0.04 * cos(a)}};
}

static status make_wall(surface *out)
{
    status st = OK;
    double(*corner)[3][3] = NULL;
    surface_report report;
    int n = 0;
    TRY(TAKE(corner, CORNERS));
    for (int i = 0; i < ROWS * COLUMNS; i++) {
        const int r = i / COLUMNS, c = i % COLUMNS;
        const vec3 p[4] = {wall(r, c), wall(r + 1, c), wall(r + 1, c + 1), wall(r, c + 1)};
        for (int half = 0; half < 2; half++) {
            // two corners are one at the poles
            if (half == 0 ? r < ROWS - 1 : r > 0) {
                for (int k = 0; k < 9; k++) {
                    corner[n][k / 3][k % 3] = p[k / 3 == 0 ? 0 : k / 3 + half].a[k % 3];
                }
                n++;
            }
        }
    }
    TRY(surface_make(n, (const double(*)[3][3])corner,
                     &(surface_options){.path = "bent ellipsoid", .merge = 1e-8}, out, &report));

done:
    free(corner);
    return st;
}

static status search_all(const char *name, const scope *s, const distance_tree *tree, double *ms)
{
    status st = OK;
    scope_state *state = NULL;
    inverse *inv = NULL;
    const pose entry = pose_identity();
    scope_room in = {.tree = tree, .tolerance = 5e-5};
    const room_probe room = scope_room_probe(&in);
    const search_options options = search_options_default();
    int verdict[4] = {0}, looks = 0, proved = 0;
    const double start = bench_cpu_ms();
    TRY(scope_state_make(s, &entry, &state));
    TRY(inverse_make(s, &inv));
    for (int k = 0; k < WANTED; k++) {
        search_answer a;
        // from well inside to the wall
        vec3 target = wall(60 + 4 * k, 67 * k);
        target.a[0] *= 0.5 + 0.45 * k / WANTED;
        target.a[1] *= 0.5 + 0.45 * k / WANTED;
        TRY(search_solve(inv, state, target, &room, &options, &a));
        verdict[a.verdict]++;
        proved += a.verdict == SEARCH_COLLISION && a.bound < 0;
        looks += a.looks;
    }
    *ms = bench_cpu_ms() - start;
    printf("%-22s %d targets: %d reached, %d out of reach, %d joint limit, %d touch (%d proved); "
           "%d looks, %.0f ms\n",
           name, WANTED, verdict[0], verdict[1], verdict[2], verdict[3], proved, looks, *ms);

done:
    inverse_free(inv);
    scope_state_free(state);
    return st;
}

// --- the map

enum { MAP_POINTS = 10000 };

static status map_all(const char *name, const scope *s, const surface *wall,
                      const distance_tree *tree, int *missed)
{
    status st = OK;
    scope_state *state = NULL;
    inverse *inv = NULL;
    double(*point)[3] = NULL;
    int count[3] = {0};
    reach_map_answer a = {0};
    const pose entry = pose_identity();
    scope_room in = {.tree = tree, .tolerance = 5e-5};
    const room_probe room = scope_room_probe(&in);
    reach_map_options options = reach_map_options_default();
    options.near = s->radius + 1e-3; // the skin within 1 mm
    const double start = bench_cpu_ms();
    TRY(TAKE(point, MAP_POINTS));
    TRY(TAKE(a.state, MAP_POINTS));
    TRY(surface_samples(wall, MAP_POINTS, 1, point));
    TRY(scope_state_make(s, &entry, &state));
    TRY(inverse_make(s, &inv));
    TRY(reach_map(inv, state, &room, MAP_POINTS, (const double(*)[3])point, &options, &a));
    for (int i = 0; i < MAP_POINTS; i++) {
        count[a.state[i]]++;
    }
    const double seconds = 1e-3 * (bench_cpu_ms() - start);
    printf("%-22s %d points: %d reached, %d not, %d undecided; %d looks, tips within %.2g mm\n",
           name, MAP_POINTS, count[1], count[0], count[2], a.looks, 1e3 * a.spacing);
    *missed |= bench_target("map of 10,000 points", seconds, 30, "s");

done:
    inverse_free(inv);
    scope_state_free(state);
    free(a.state);
    free(point);
    return st;
}

static status searches(int *missed)
{
    status st = OK;
    surface s = {0};
    distance_tree *tree = NULL;
    made_scope m = arc_scope();
    double ms;
    TRY(make_wall(&s));
    TRY(distance_tree_make(&s, &tree));
    printf("\nin a surface of %d triangles, map included\n", s.ntriangle);
    TRY(search_all("constant curvature", &m.scope, tree, &ms));
    *missed |= bench_target("20 targets", 1e-3 * ms, 2, "s");
    TRY(map_all("constant curvature", &m.scope, &s, tree, missed));
    for (int n = 1; n <= 2; n++) {
        neuro_scope(n, usual_plan, &m);
        st = search_all(n == 1 ? "neuro, 1 tendon" : "neuro, 2 tendons", &m.scope, tree, &ms);
        st = st == OK ? map_all(n == 1 ? "neuro, 1 tendon" : "neuro, 2 tendons", &m.scope, &s, tree,
                                missed)
                      : st;
        free_scope(&m);
        TRY(st);
        *missed |= bench_target("20 targets", 1e-3 * ms, 2, "s");
    }

done:
    distance_tree_free(tree);
    surface_free(&s);
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
    for (int n = 1; n <= 2; n++) {
        neuro_scope(n, usual_plan, &m);
        TRY(measure(n == 1 ? "neuro, 1 tendon" : "neuro, 2 tendons", &m.scope, &t));
        free_scope(&m);
        *missed |= bench_target("one target out of reach", 1e-3 * t.outside, 1, "ms");
    }
    TRY(searches(missed));

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
