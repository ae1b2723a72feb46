// tests/unit/reach/test_scope.c
#include "tests/unit/reach/scopes.h"

#include "reach/arc.h"

#include <string.h>

static vec3 tip_at(scope_state *state, const double *q)
{
    vec3 tip = {{NAN, NAN, NAN}};
    CHECK_OK(scope_bend(state, q));
    CHECK_OK(scope_tip(state, q, &tip, NULL));
    return tip;
}

// the tip by scope_tip, by scope_point and by the rod solved with its base there is one place
static void tip_is_the_rods_own(const scope *s, const double *q)
{
    const pose entry = slanted_entry();
    scope_state *state = NULL;
    rod_state *solo = NULL;
    CHECK_OK(scope_state_make(s, &entry, &state));
    const vec3 tip = tip_at(state, q);
    CHECK_WITHIN(distance(scope_point(state, q, s->length), tip), 0, 1e-15);
    // the shaft ends where the tip begins, and leaves the entry
    CHECK_WITHIN(distance(scope_point(state, q, -q[0]), entry.p), 0, 1e-16);
    CHECK_WITHIN(distance(scope_point(state, q, -1e-12), scope_point(state, q, 1e-12)), 0, 3e-12);
    if (s->rod) {
        const pose base = scope_base(state, q);
        rod_solution out = {0};
        CHECK_OK(rod_state_make(s->rod, &solo));
        CHECK_OK(
            rod_solve(solo, &(rod_request){.tension = q + 2, .base = &base, .cold = true}, &out));
        CHECK_WITHIN(distance(out.tip.p, tip), 0, 1e-15);
    }
    rod_state_free(solo);
    scope_state_free(state);
}

// every column against central differences of fourth order
static void jacobian_is_the_derivative(const scope *s, const double *q)
{
    static const double weight[4] = {1 / 12.0, -8 / 12.0, 8 / 12.0, -1 / 12.0};
    const pose entry = slanted_entry();
    const int n = s->njoint;
    double J[3 * SCOPE_JOINTS];
    vec3 tip;
    scope_state *state = NULL;
    CHECK_OK(scope_state_make(s, &entry, &state));
    CHECK_OK(scope_bend(state, q));
    CHECK_OK(scope_tip(state, q, &tip, J));
    for (int j = 0; j < n; j++) {
        const double h = 4e-4 * (s->high[j] - s->low[j]);
        vec3 slope = {{0, 0, 0}}, column = {{J[j], J[n + j], J[2 * n + j]}};
        for (int k = 0; k < 4; k++) {
            double at[SCOPE_JOINTS];
            memcpy(at, q, sizeof at);
            at[j] += (k < 2 ? k - 2 : k - 1) * h;
            slope = vec3_add_scaled(slope, weight[k] / h, tip_at(state, at));
        }
        CHECK_WITHIN(distance(slope, column) / vec3_norm(column), 0, 1e-7);
    }
    scope_state_free(state);
}

// no two neighbours of many points on the body are farther apart than the stretch says
static void stretch_bounds_the_body(const scope *s, const double *q)
{
    enum { POINTS = 400 };
    const pose entry = slanted_entry();
    scope_state *state = NULL;
    double most = 0;
    CHECK_OK(scope_state_make(s, &entry, &state));
    CHECK_OK(scope_bend(state, q));
    const double from = -q[0], step = (s->length + q[0]) / POINTS;
    for (int i = 0; i < POINTS; i++) {
        most = fmax(most, distance(scope_point(state, q, from + i * step),
                                   scope_point(state, q, from + (i + 1) * step)) /
                              step);
    }
    CHECK(most <= scope_stretch(state) * (1 + 1e-9));
    CHECK(scope_stretch(state) < 2 * most);
    scope_state_free(state);
}

static void all_of(const scope *s)
{
    unsigned long long seed = 7;
    double q[SCOPE_JOINTS];
    for (int k = 0; k < 8; k++) {
        for (int j = 0; j < s->njoint; j++) {
            // away from the limits: differences need room
            const double room = 0.01 * (s->high[j] - s->low[j]);
            q[j] = random_between(&seed, s->low[j] + room, s->high[j] - room);
        }
        tip_is_the_rods_own(s, q);
        jacobian_is_the_derivative(s, q);
        stretch_bounds_the_body(s, q);
    }
}

static void arcs_have_their_closed_form(void)
{
    const double L = 0.02;
    const vec3 quarter = arc_point(L, PROTOTYPE_PI / 2, L), straight = arc_point(L, 0, L);
    CHECK_WITHIN(distance(quarter, (vec3){{2 * L / PROTOTYPE_PI, 0, 2 * L / PROTOTYPE_PI}}), 0,
                 1e-17);
    CHECK_WITHIN(distance(straight, (vec3){{0, 0, L}}), 0, 1e-18);
    // series and closed form meet
    for (double bend = 0.00999; bend < 0.01002; bend += 1e-5) {
        const double h = 1e-4;
        const vec3 slope =
            vec3_scale(1 / (2 * h), vec3_sub(arc_point(L, bend + h, L), arc_point(L, bend - h, L)));
        CHECK_WITHIN(distance(slope, arc_derivative(L, bend, L)) / L, 0, 1e-9);
    }
    for (double bend = -6; bend < 6; bend += 0.1) {
        for (double s = 0; s <= L; s += L / 8) {
            CHECK(vec3_norm(arc_derivative(L, bend, s)) <= s * s / (2 * L) * (1 + 1e-12));
        }
    }
}

// every bend whose end has this distance from the axis, and no other
static void bends_of_an_end(void)
{
    double bend[ARC_MOST_BENDS];
    CHECK(arc_bends(1, 0.5, 0, 6, bend) == 2);
    CHECK(arc_bends(1, 0.5, -6, 6, bend) == 4);
    CHECK(arc_bends(1, 0.5, 0, 2, bend) == 1);
    CHECK_NEAR(arc_point(1, bend[0], 1).a[0], 0.5, 1e-15);
    CHECK(arc_bends(1, 0, -1, 1, bend) == 1 && bend[0] == 0);
    CHECK(arc_bends(1, 0.7246, 0, 6, bend) == 2);
    CHECK(arc_bends(1, 0.72462, 0, 6, bend) == 0);
    CHECK(arc_bends(1, ARC_FARTHEST, 0, 6, bend) >= 1);
    CHECK_WITHIN(bend[0], ARC_FARTHEST_BEND, 1e-6);
}

static void wrong_scopes_are_refused(void)
{
    const pose entry = pose_identity();
    scope_state *state = NULL;
    scope s = arc_scope().scope;
    s.low[2] = 5;
    CHECK(scope_state_make(&s, &entry, &state) == ERR_INPUT);
    CHECK(strstr(status_message(), "bend") != NULL);
    status_clear();
    s = arc_scope().scope;
    s.high[0] = NAN;
    CHECK(scope_check(&s) == ERR_INPUT && strstr(status_message(), "insertion") != NULL);
    status_clear();
    s = arc_scope().scope;
    s.high[2] = 7;
    CHECK(scope_check(&s) == ERR_INPUT);
    status_clear();
    s = arc_scope().scope;
    s.length = 0;
    CHECK(scope_check(&s) == ERR_INPUT);
    status_clear();
    s = arc_scope().scope;
    s.njoint = 4;
    CHECK(scope_check(&s) == ERR_INPUT);
    status_clear();
    made_scope m;
    helical_scope(one_plan, &m);
    m.scope.low[2] = -1;
    CHECK(scope_check(&m.scope) == ERR_INPUT && strstr(status_message(), "push") != NULL);
    status_clear();
    free_scope(&m);
    CHECK(state == NULL);
}

int main(void)
{
    arcs_have_their_closed_form();
    bends_of_an_end();
    wrong_scopes_are_refused();
    const made_scope arc = arc_scope();
    all_of(&arc.scope);
    for (int n = 1; n <= 3; n++) {
        made_scope m;
        constant_scope(n, one_plan, &m);
        all_of(&m.scope);
        free_scope(&m);
        neuro_scope(n, one_plan, &m);
        all_of(&m.scope);
        free_scope(&m);
    }
    made_scope helical;
    helical_scope(one_plan, &helical);
    all_of(&helical.scope);
    free_scope(&helical);
    return test_failures != 0;
}
