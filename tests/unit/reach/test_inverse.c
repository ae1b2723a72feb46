// tests/unit/reach/test_inverse.c
#include "tests/unit/reach/scopes.h"

#include "reach/inverse.h"

#include <string.h>

// it leaves the tip where it is to first order, and its rows are as many as joints are over
static void null_space_keeps_the_tip(void)
{
    made_scope m;
    neuro_scope(3, usual_plan, &m);
    const scope *s = &m.scope;
    const pose entry = slanted_entry();
    const int n = s->njoint;
    const double q[] = {0.05, 1, 0.2, 0.1, 0.3};
    double J[3 * SCOPE_JOINTS], row[SCOPE_JOINTS][SCOPE_JOINTS];
    vec3 tip;
    scope_state *state = NULL;
    CHECK_OK(scope_state_make(s, &entry, &state));
    CHECK_OK(scope_bend(state, q));
    CHECK_OK(scope_tip(state, q, &tip, J));
    CHECK(inverse_null_space(s, J, row) == 2);
    for (int k = 0; k < 2; k++) {
        double size = 0, dot = 0;
        for (int j = 0; j < n; j++) {
            const double range = s->high[j] - s->low[j];
            size += pow(row[k][j] / range, 2);
            dot += row[0][j] * row[1][j] / (range * range);
        }
        CHECK_NEAR(size, 1, 1e-12);
        CHECK_WITHIN(dot, 0, 1e-12);
        for (int i = 0; i < 3; i++) {
            double moved = 0;
            for (int j = 0; j < n; j++) {
                moved += J[i * n + j] * row[k][j];
            }
            CHECK_WITHIN(moved, 0, 1e-12 * s->length);
        }
    }
    scope_state_free(state);
    free_scope(&m);
}

// one of each, and the limit that is named
static void limits_are_named(void)
{
    made_scope m = arc_scope();
    const pose entry = pose_identity();
    scope_state *state = NULL;
    inverse *inv = NULL;
    inverse_answer out;
    CHECK_OK(scope_state_make(&m.scope, &entry, &state));
    CHECK_OK(inverse_make(&m.scope, &inv));
    CHECK_OK(inverse_solve(inv, state, (vec3){{0.01, 0, 0.05}}, &out));
    CHECK(out.npose == 2 && out.limit == INVERSE_NO_LIMIT);
    CHECK_OK(inverse_solve(inv, state, (vec3){{0.01, 0, 0.2}}, &out));
    CHECK(out.npose == 0 && out.limit == SCOPE_INSERTION);
    CHECK_OK(inverse_solve(inv, state, (vec3){{0.03, 0, 0.05}}, &out));
    CHECK(out.npose == 0 && out.limit == INVERSE_OUT_OF_REACH);
    CHECK(inverse_solve(inv, state, (vec3){{NAN, 0, 0}}, &out) == ERR_INPUT);
    status_clear();
    inverse_free(inv);
    // the bend ends before the tip is far enough from the line
    m.scope.high[SCOPE_BEND] = 0.5;
    inv = NULL;
    CHECK_OK(inverse_make(&m.scope, &inv));
    CHECK_OK(inverse_solve(inv, state, (vec3){{0.01, 0, 0.05}}, &out));
    CHECK(out.npose == 0 && out.limit == SCOPE_BEND);
    inverse_free(inv);
    // one bend only
    m.scope.low[SCOPE_BEND] = 0.5;
    inv = NULL;
    CHECK_OK(inverse_make(&m.scope, &inv));
    CHECK_OK(inverse_solve(inv, state, (vec3){{0.01, 0, 0.05}}, &out));
    CHECK(out.npose == 0);
    inverse_free(inv);
    scope_state_free(state);
}

int main(void)
{
    null_space_keeps_the_tip();
    limits_are_named();
    return test_failures != 0;
}
