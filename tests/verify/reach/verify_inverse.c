// tests/verify/reach/verify_inverse.c
// What a forward solve made is reached again; what cannot be reached is refused; constant curvature
// in closed form is what a dense search finds.
#include "tests/unit/reach/scopes.h"
#include "tests/verify/reach/dense_arc.h"

#include "reach/inverse.h"

#include <string.h>

// how many, and how fine the dense scans of one, two and three bending joints are
typedef struct campaign {
    int targets, dense_targets, scan[3];
} campaign;

static const campaign full = {1000, 200, {20001, 201, 41}};
static const campaign of_a_check = {60, 15, {2001, 101, 41}};

// the table's own criterion
static const double reached_again = 1e-6; // [m]

typedef struct asked {
    const campaign *size;
    made_scope m;
    pose entry;
    inverse *inverse;
    scope_state *state;
} asked;

static void ask(asked *a)
{
    a->entry = slanted_entry();
    CHECK_OK(scope_state_make(&a->m.scope, &a->entry, &a->state));
    CHECK_OK(inverse_make(&a->m.scope, &a->inverse));
}

static void answered(asked *a)
{
    inverse_free(a->inverse);
    scope_state_free(a->state);
    free_scope(&a->m);
}

static vec3 forward(asked *a, const double *q)
{
    vec3 tip = {{NAN, NAN, NAN}};
    CHECK_OK(scope_bend(a->state, q));
    CHECK_OK(scope_tip(a->state, q, &tip, NULL));
    return tip;
}

// every pose of an answer is in the limits and at the target
static double worst_pose(asked *a, vec3 target, const inverse_answer *out)
{
    double worst = 0;
    for (int i = 0; i < out->npose; i++) {
        CHECK(scope_within(&a->m.scope, out->pose[i].q));
        worst = fmax(worst, distance(forward(a, out->pose[i].q), target));
    }
    return worst;
}

// whether the tip is on the line, so that any turn is as good
static bool straight(asked *a, const double *q)
{
    vec3 tip = {{NAN, NAN, NAN}};
    CHECK_OK(scope_bend(a->state, q));
    CHECK_OK(scope_bent_tip(a->state, &tip, NULL));
    return hypot(tip.a[0], tip.a[1]) < 1e-9;
}

// whether the joints that made the target are among those found
static bool found(const scope *s, const double *q, const inverse_answer *out)
{
    for (int i = 0; i < out->npose; i++) {
        double away = 0;
        for (int j = 0; j < s->njoint; j++) {
            // half a turn to the left is half a turn to the right
            const double off = out->pose[i].q[j] - q[j];
            away = fmax(away, j == 1 ? fabs(sin(off / 2)) : fabs(off) / (s->high[j] - s->low[j]));
        }
        if (away < 1e-3) {
            return true;
        }
    }
    return false;
}

static void reached(const char *name, asked *a)
{
    about("%s", name);
    const scope *s = &a->m.scope;
    unsigned long long seed = 11;
    int missed = 0, own = 0, poses = 0;
    double worst = 0;
    for (int k = 0; k < a->size->targets; k++) {
        double q[SCOPE_JOINTS];
        inverse_answer out;
        random_joints(s, &seed, q);
        // at the limits too
        q[k % s->njoint] = k % 10 == 0 ? s->high[k % s->njoint] : q[k % s->njoint];
        q[k % s->njoint] = k % 10 == 5 ? s->low[k % s->njoint] : q[k % s->njoint];
        const vec3 target = forward(a, q);
        CHECK_OK(inverse_solve(a->inverse, a->state, target, &out));
        missed += out.npose == 0;
        own += straight(a, q) || found(s, q, &out);
        poses += out.npose;
        worst = fmax(worst, worst_pose(a, target, &out));
    }
    printf(
        "%-24s %d of %d reached again, worst %.1e m, %.2f poses each, own joints among them %d\n",
        name, a->size->targets - missed, a->size->targets, worst, poses / (double)a->size->targets,
        own);
    CHECK(missed == 0);
    CHECK_AT_MOST(worst, reached_again);
    if (s->njoint == 3) {
        // all solutions: the one that made the target too, but where two of them merge
        CHECK_AT_LEAST(own, a->size->targets - 5);
    }
}

// the largest distance of the tip from the line, and the extent along it, by a dense scan
static void extent(asked *a, double *rho, double *low, double *high)
{
    const scope *s = &a->m.scope;
    const int n = s->njoint - SCOPE_BEND, m = a->size->scan[n - 1];
    int total = 1;
    *rho = 0;
    *low = INFINITY;
    *high = -INFINITY;
    for (int j = 0; j < n; j++) {
        total *= m;
    }
    for (int k = 0; k < total; k++) {
        double q[SCOPE_JOINTS] = {0};
        vec3 tip;
        for (int j = 0, rest = k; j < n; j++, rest /= m) {
            q[2 + j] = s->low[2 + j] + (s->high[2 + j] - s->low[2 + j]) * (rest % m) / (m - 1);
        }
        CHECK_OK(scope_bend(a->state, q));
        CHECK_OK(scope_bent_tip(a->state, &tip, NULL));
        *rho = fmax(*rho, hypot(tip.a[0], tip.a[1]));
        *low = fmin(*low, tip.a[2]);
        *high = fmax(*high, tip.a[2]);
    }
    *low += s->low[0];
    *high += s->high[0];
}

static vec3 on_cylinder(const asked *a, double rho, double angle, double z)
{
    const vec3 p = {{rho * cos(angle), rho * sin(angle), z}};
    return vec3_add(a->entry.p, mat3_mul_vec(a->entry.R, p));
}

// beyond what the scan found, by at least the margin, aside, behind and ahead
static void refused(const char *name, asked *a)
{
    about("%s", name);
    const scope *s = &a->m.scope;
    const double margin = 1e-4;
    unsigned long long seed = 5;
    double rho, low, high;
    int accepted = 0, wrong = 0;
    double least = INFINITY;
    extent(a, &rho, &low, &high);
    for (int k = 0; k < a->size->targets; k++) {
        inverse_answer out;
        const double by = margin + random_between(&seed, 0, k % 2 ? 1e-3 : s->length);
        const double angle = random_between(&seed, -4, 4);
        double r = random_between(&seed, 0, rho), z = random_between(&seed, low, high);
        if (k % 3 == 0) {
            r = rho + by;
        } else {
            z = k % 3 == 1 ? low - by : high + by;
        }
        CHECK_OK(inverse_solve(a->inverse, a->state, on_cylinder(a, r, angle, z), &out));
        accepted += out.npose != 0;
        // behind and ahead it is the insertion or the bend that ends
        wrong += out.limit == INVERSE_NO_LIMIT;
        CHECK(scope_within(s, out.nearest.q));
        // the scan of the extent is short by a little
        CHECK_AT_LEAST(out.nearest.miss, by - margin / 10);
        least = fmin(least, out.nearest.miss - by);
    }
    printf("%-24s %d of %d unreachable ones refused, farther than made by %.1e m at least\n", name,
           a->size->targets - accepted, a->size->targets, least);
    CHECK(accepted == 0 && wrong == 0);
}

// a turn that is limited to half a circle: what is made on the other half is refused
static void refused_by_turn(const char *name, asked *a)
{
    about("%s", name);
    const scope *s = &a->m.scope;
    unsigned long long seed = 3;
    int accepted = 0, named = 0, asked_for = 0;
    for (int k = 0; k < a->size->targets; k++) {
        double q[SCOPE_JOINTS];
        inverse_answer out;
        random_joints(s, &seed, q);
        const vec3 target = forward(a, q);
        CHECK_OK(inverse_solve(a->inverse, a->state, target, &out));
        bool other_half = out.npose > 0;
        for (int i = 0; i < out.npose; i++) {
            other_half = other_half && out.pose[i].q[1] > 0.1;
        }
        if (!other_half || out.pose[0].q[1] > PROTOTYPE_PI - 0.1) {
            continue;
        }
        asked_for++;
        a->m.scope.high[1] = 0;
        CHECK_OK(inverse_solve(a->inverse, a->state, target, &out));
        accepted += out.npose != 0;
        named += out.limit == SCOPE_TURN || out.limit >= SCOPE_BEND || out.limit == 0;
        a->m.scope.high[1] = PROTOTYPE_PI;
    }
    printf("%-24s %d of %d behind the turn's limits refused, %d by a joint's limit\n", name,
           asked_for - accepted, asked_for, named);
    CHECK_ABOVE(asked_for, a->size->targets / 5);
    CHECK(accepted == 0);
    CHECK_ABOVE(named, asked_for / 2);
}

static void whole(const char *name, asked *a)
{
    ask(a);
    reached(name, a);
    refused(name, a);
    if (a->m.scope.njoint == 3) {
        refused_by_turn(name, a);
    }
    answered(a);
}

// --- constant curvature against a dense search

static void closed_form_is_the_dense_search(const campaign *size)
{
    asked a = {.size = size, .m = arc_scope()};
    unsigned long long seed = 23;
    int reachable = 0, counts = 0;
    const int n = size->dense_targets;
    double worst = 0;
    ask(&a);
    const scope *s = &a.m.scope;
    for (int k = 0; k < n; k++) {
        inverse_answer out;
        const double rho = random_between(&seed, 0, 0.017), z = random_between(&seed, -0.02, 0.13);
        const double angle = random_between(&seed, -PROTOTYPE_PI, PROTOTYPE_PI);
        const vec3 local = {{rho * cos(angle), rho * sin(angle), z}};
        CHECK_OK(inverse_solve(a.inverse, a.state, on_cylinder(&a, rho, angle, z), &out));
        const double dense = dense_miss(s, local);
        reachable += out.npose > 0;
        counts += out.npose == dense_count(s, rho, z);
        CHECK((dense < 1e-9) == (out.npose > 0));
        worst = fmax(worst, fabs(dense - out.nearest.miss));
    }
    printf(
        "%-24s %d of %d reachable, distances within %.1e m of the dense search, %d counts equal\n",
        "constant curvature", reachable, n, worst, counts);
    CHECK_ABOVE(reachable, 0.3 * n);
    CHECK_BELOW(reachable, 0.9 * n);
    CHECK_BELOW(worst, 1e-7); // the nearest of those out of reach is found on the cubics
    CHECK(counts == n);
    answered(&a);
}

int main(void)
{
    against(BY_SECOND_WAY, "forward solves; a dense search");
    const campaign *size = test_is_long() ? &full : &of_a_check;
    against(BY_CLOSED_FORM, "constant curvature");
    closed_form_is_the_dense_search(size);
    against(BY_SECOND_WAY, "forward solves; a dense search");
    asked arc = {.size = size, .m = arc_scope()};
    whole("constant curvature", &arc);
    asked a;
    for (int n = 1; n <= 2; n++) {
        constant_scope(n, usual_plan, (a = (asked){.size = size}, &a.m));
        whole(n == 1 ? "prototype" : "prototype, 2 tendons", &a);
        neuro_scope(n, usual_plan, (a = (asked){.size = size}, &a.m));
        whole(n == 1 ? "neuro-endoscope" : "neuro, 2 tendons", &a);
    }
    a = (asked){.size = size};
    helical_scope(usual_plan, &a.m);
    whole("helical prototype", &a);
    a = (asked){.size = size};
    neuro_scope(3, usual_plan, &a.m);
    whole("neuro, 3 tendons", &a);
    return test_failures != 0;
}
