// tests/verify/reach/verify_search.c
// Whether a target is reached without touching, against dense brute force and against obstacles
// whose free sets are known in closed form.
#include "tests/unit/reach/scopes.h"

#include "reach/search.h"

enum { POINTS = 60 };

// targets that brute force looks for too, its bends, and its steps of insertion and of turn to
// either side
typedef struct campaign {
    int targets, bends, steps;
} campaign;

static const campaign full_arc = {200, 400, 12}, full_rod = {12, 200, 12};
static const campaign check_arc = {20, 150, 7}, check_rod = {8, 80, 5};

// what is not proved has no more room than this many times the resolution
static const double few = 3;

// a toy obstacle: how far outside of it a point is
typedef struct toy {
    double (*free)(const struct toy *t, vec3 p);
    vec3 centre;
    double size;
} toy;

static double out_of_ball(const toy *t, vec3 p)
{
    return distance(p, t->centre) - t->size;
}

// tissue above z = size
static double under_slab(const toy *t, vec3 p)
{
    return t->size - p.a[2];
}

// free only within a tube about the line
static double in_tube(const toy *t, vec3 p)
{
    return t->size - hypot(p.a[0], p.a[1]);
}

static double toy_room(void *context, scope_state *state, const double *q, double *s)
{
    const toy *t = context;
    const scope *sc = scope_of(state);
    double least = INFINITY;
    for (int i = 0; i <= POINTS; i++) {
        // a third on the shaft
        const double at = i < POINTS / 3 ? -q[0] * (1 - i / (POINTS / 3.0))
                                         : sc->length * (i - POINTS / 3) / (POINTS - POINTS / 3);
        const double here = t->free(t, scope_point(state, q, at)) - sc->radius;
        *s = here < least ? at : *s;
        least = fmin(least, here);
    }
    return least;
}

typedef struct toy_search {
    const scope *scope;
    scope_state *state;
    inverse *inverse;
    toy toy;
    room_probe room;
    search_options options;
} toy_search;

static void start(const scope *s, toy_search *t)
{
    const pose entry = pose_identity();
    t->scope = s;
    t->room = (room_probe){.at = toy_room, .context = &t->toy};
    t->options = search_options_default();
    CHECK_OK(scope_state_make(s, &entry, &t->state));
    CHECK_OK(inverse_make(s, &t->inverse));
}

static void stop(toy_search *t)
{
    inverse_free(t->inverse);
    scope_state_free(t->state);
}

// every pose of a grid about the target whose tip is near enough: the most room of all
static double dense_room(toy_search *t, vec3 target, const campaign *size)
{
    const scope *s = t->scope;
    const int steps = size->steps;
    const double tol = t->options.tolerance, rho = hypot(target.a[0], target.a[1]);
    double best = -INFINITY;
    for (int i = 0; i <= size->bends; i++) {
        vec3 bent;
        double q[SCOPE_JOINTS] = {0, 0, s->low[2] + (s->high[2] - s->low[2]) * i / size->bends};
        CHECK_OK(scope_bend(t->state, q));
        CHECK_OK(scope_bent_tip(t->state, &bent, NULL));
        const double r = hypot(bent.a[0], bent.a[1]);
        if (fabs(r - rho) > tol) {
            continue;
        }
        for (int k = 0; k < (2 * steps + 1) * (2 * steps + 1); k++) {
            const double spread = fmin(PROTOTYPE_PI, 1.2 * tol / fmin(r, rho));
            q[1] = atan2(target.a[1], target.a[0]) - atan2(bent.a[1], bent.a[0]);
            q[1] =
                remainder(q[1] + spread * (k % (2 * steps + 1) - steps) / steps, 2 * PROTOTYPE_PI);
            q[0] = target.a[2] - bent.a[2] + tol * (k / (2 * steps + 1) - steps) / (double)steps;
            if (scope_within(s, q) &&
                distance(scope_point(t->state, q, s->length), target) <= tol) {
                double at = 0;
                best = fmax(best, toy_room(&t->toy, t->state, q, &at));
            }
        }
    }
    return best;
}

static search_answer answer(toy_search *t, vec3 target)
{
    search_answer a = {0};
    CHECK_OK(search_solve(t->inverse, t->state, target, &t->room, &t->options, &a));
    if (a.verdict == SEARCH_REACHED || a.verdict == SEARCH_COLLISION) {
        // what it says of its pose holds
        double at = 0;
        CHECK(scope_within(t->scope, a.pose.q));
        CHECK_OK(scope_bend(t->state, a.pose.q));
        CHECK_AT_MOST(distance(scope_point(t->state, a.pose.q, t->scope->length), target),
                      t->options.tolerance * (1 + 1e-9));
        CHECK_WITHIN(toy_room(&t->toy, t->state, a.pose.q, &at), a.room, 0);
        CHECK_WITHIN(at, a.s, 0);
        CHECK((a.room >= 0) == (a.verdict == SEARCH_REACHED));
    }
    return a;
}

// the same verdict, at least as much room where it decides, and never more than the bound
static void against_dense(const char *name, toy_search *t, const campaign *size)
{
    about("%s", name);
    unsigned long long seed = 9;
    int reached = 0, touched = 0, away = 0, open = 0;
    long looks = 0;
    for (int k = 0; k < size->targets; k++) {
        double q[SCOPE_JOINTS];
        random_joints(t->scope, &seed, q);
        CHECK_OK(scope_bend(t->state, q));
        vec3 target = scope_point(t->state, q, t->scope->length);
        target.a[0] += k % 4 == 0 ? 2e-3 : 0;
        const search_answer a = answer(t, target);
        const double dense = dense_room(t, target, size);
        looks += a.looks;
        if (a.verdict == SEARCH_REACHED) {
            reached++;
        } else if (a.verdict == SEARCH_COLLISION) {
            touched++;
            // proved: brute force finds no free pose either, and none with more room than the bound
            open += a.bound >= 0;
            CHECK_BELOW(a.bound, few * t->options.resolution);
        } else {
            away++;
            CHECK(dense == -INFINITY);
        }
        CHECK_AT_MOST(dense, a.bound + 1e-12);
        CHECK(!(dense >= 0) || a.verdict == SEARCH_REACHED);
    }
    printf("%-28s %d reached, %d touch (%d of them undecided within the resolution), %d out of "
           "reach, %.0f looks each\n",
           name, reached, touched, open, away, (double)looks / size->targets);
    CHECK_ABOVE(reached, 0);
    CHECK_ABOVE(touched, 0);
}

// --- closed forms

// In a tube of radius R about the line the tip itself is what touches, so that the most room is
// that of the tip being inwards by the tolerance: R - r - (rho - tolerance).
static void tube_has_its_closed_form(toy_search *t)
{
    const scope *s = t->scope;
    int both[2] = {0};
    t->toy = (toy){in_tube, {{0}}, 9e-3};
    for (int k = 0; k < 40; k++) {
        const double rho = 5e-3 + 2e-4 * k, most = 9e-3 - s->radius - (rho - t->options.tolerance);
        const vec3 target = {{rho * cos(k), rho * sin(k), 0.06}};
        const search_answer a = answer(t, target);
        if (fabs(most) > t->options.resolution) {
            CHECK(a.verdict == (most > 0 ? SEARCH_REACHED : SEARCH_COLLISION));
            both[most > 0]++;
        }
        CHECK_AT_MOST(a.room, most + 1e-9);
        CHECK_AT_LEAST(a.bound, most - 1e-9);
        if (!(most > 0)) {
            CHECK_BELOW(a.bound, few * t->options.resolution);
        }
        if (a.verdict == SEARCH_COLLISION) {
            CHECK_ABOVE(a.s, 0.9 * s->length);
        }
    }
    CHECK_ABOVE(both[0], 5);
    CHECK_ABOVE(both[1], 5);
}

// Under a slab at z = h, bent by less than a right angle, the tip is the highest point: the most
// room is h - r - (z - tolerance), where the roots beyond a right angle are higher still
static void slab_has_its_closed_form(toy_search *t)
{
    const scope *s = t->scope;
    int both[2] = {0};
    t->toy = (toy){under_slab, {{0}}, 0.05};
    for (int k = 0; k < 30; k++) {
        const double z = 0.046 + 2e-4 * k, most = 0.05 - s->radius - (z - t->options.tolerance);
        const search_answer a = answer(t, (vec3){{0.006 * cos(k), 0.006 * sin(k), z}});
        if (fabs(most) > t->options.resolution) {
            CHECK(a.verdict == (most > 0 ? SEARCH_REACHED : SEARCH_COLLISION));
            both[most > 0]++;
        }
        CHECK_AT_MOST(a.room, most + 1e-9);
        CHECK_AT_LEAST(a.bound, most - 1e-9);
    }
    CHECK_ABOVE(both[0], 5);
    CHECK_ABOVE(both[1], 5);
}

// A ball on the line that the shaft cannot pass: free iff the base stays before it
static void reasons_are_named(toy_search *t)
{
    const scope *s = t->scope;
    t->toy = (toy){out_of_ball, {{0, 0, 1}}, 1e-3};
    search_answer a = answer(t, (vec3){{0.0155, 0, 0.05}});
    CHECK(a.verdict == SEARCH_OUT_OF_REACH && a.joint == -1);
    CHECK_WITHIN(a.pose.miss, 0.0155 - 0.724611353776708 * s->length, 1e-7);
    a = answer(t, (vec3){{0.006, 0, 0.15}});
    CHECK(a.verdict == SEARCH_JOINT_LIMIT && a.joint == SCOPE_INSERTION);
    a = answer(t, (vec3){{0.006, 0, 0.05}});
    CHECK(a.verdict == SEARCH_REACHED);
    CHECK_AT_LEAST(a.bound, a.room);
    // the shaft is where it touches
    t->toy = (toy){out_of_ball, {{0, 0, 0.03}}, 3e-3};
    a = answer(t, (vec3){{0.006, 0, 0.09}});
    CHECK(a.verdict == SEARCH_COLLISION);
    CHECK_BELOW(a.s, 0);
    CHECK_BELOW(a.bound, 0);
    // its points are 4 mm apart: one is within 2 mm of the centre
    CHECK_BELOW(a.room, -1.9e-3);
    CHECK_ABOVE(a.room, -4.1e-3);
    // the tip itself is inside
    t->toy = (toy){out_of_ball, {{0.006, 0, 0.09}}, 3e-3};
    a = answer(t, (vec3){{0.006, 0, 0.09}});
    CHECK(a.verdict == SEARCH_COLLISION);
    CHECK_BELOW(a.bound, 0);
    // the tip goes as far out of the ball as the tolerance lets it
    CHECK_WITHIN(a.room, t->options.tolerance - 4e-3, 3e-4);
    search_options wrong = t->options;
    wrong.tolerance = 0;
    CHECK(search_solve(t->inverse, t->state, (vec3){{0}}, &t->room, &wrong, &a) == ERR_INPUT);
    status_clear();
}

static void more_joints(void)
{
    made_scope m;
    toy_search t = {0};
    unsigned long long seed = 4;
    int reached = 0, made = 0;
    neuro_scope(2, usual_plan, &m);
    m.scope.radius = 1e-3;
    start(&m.scope, &t);
    t.toy = (toy){out_of_ball, {{4e-3, 0, 0.07}}, 4e-3};
    for (int k = 0; k < 60; k++) {
        double q[SCOPE_JOINTS], at = 0;
        random_joints(&m.scope, &seed, q);
        CHECK_OK(scope_bend(t.state, q));
        const vec3 target = scope_point(t.state, q, m.scope.length);
        if (toy_room(&t.toy, t.state, q, &at) >= 0) {
            made++;
            reached += answer(&t, target).verdict == SEARCH_REACHED;
        }
    }
    printf("%-28s %d of %d free targets reached\n", "neuro, 2 tendons, ball", reached, made);
    CHECK_ABOVE(made, 20);
    CHECK(reached == made);
    // no pose holds its tip out of the ball
    const search_answer a = answer(&t, (vec3){{4e-3, 0, 0.07}});
    CHECK(a.verdict == SEARCH_COLLISION && a.bound == INFINITY);
    CHECK_ABOVE(a.starts, 0);
    stop(&t);
    free_scope(&m);
}

int main(void)
{
    against(BY_CLOSED_FORM, "free sets of tubes and slabs");
    const bool whole = test_is_long();
    made_scope arc = arc_scope();
    toy_search t = {0};
    start(&arc.scope, &t);
    tube_has_its_closed_form(&t);
    slab_has_its_closed_form(&t);
    reasons_are_named(&t);
    t.toy = (toy){out_of_ball, {{5e-3, 2e-3, 0.06}}, 6e-3};
    against(BY_SECOND_WAY, "dense brute force");
    against_dense("constant curvature, ball", &t, whole ? &full_arc : &check_arc);
    t.toy = (toy){under_slab, {{0}}, 0.06};
    against_dense("constant curvature, slab", &t, whole ? &full_arc : &check_arc);
    t.toy = (toy){in_tube, {{0}}, 8e-3};
    against_dense("constant curvature, tube", &t, whole ? &full_arc : &check_arc);
    stop(&t);

    made_scope m;
    neuro_scope(1, usual_plan, &m);
    m.scope.radius = 1e-3;
    t = (toy_search){0};
    start(&m.scope, &t);
    t.toy = (toy){out_of_ball, {{3e-3, 2e-3, 0.06}}, 5e-3};
    against_dense("neuro-endoscope, ball", &t, whole ? &full_rod : &check_rod);
    t.toy = (toy){in_tube, {{0}}, 9e-3};
    against_dense("neuro-endoscope, tube", &t, whole ? &full_rod : &check_rod);
    stop(&t);
    free_scope(&m);
    more_joints();
    return test_failures != 0;
}
