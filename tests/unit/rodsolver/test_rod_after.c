// tests/unit/rodsolver/test_rod_after.c
// What a solve finds after another one of another kind, or after one that failed.
#include "tests/unit/rodsolver/prototypes.h"

// bends about its y axis alone, six times as stiff about x
static law_along flat_law(void)
{
    const double diagonal[6] = {4, 4, 12, 6 * 8e-5, 8e-5, 6e-5};
    law_along law = {0};
    CHECK_OK(law_along_make(0.12, 1, 1, &law));
    for (int i = 0; law.law && i < 6; i++) {
        law.law[0].K.a[i][i] = diagonal[i];
    }
    return law;
}

static void check_same_tip(rod_state *a, const rod_request *request, double apart)
{
    rod_solution warm = {0}, cold = {0};
    rod_request again = *request;
    again.cold = false;
    CHECK_OK(rod_solve(a, &again, &warm));
    again.cold = true;
    CHECK_OK(rod_solve(a, &again, &cold));
    CHECK_WITHIN(distance(warm.tip.p, cold.tip.p), 0, apart);
    CHECK_WITHIN(rotation_difference(warm.tip.R, cold.tip.R), 0, apart * 100);
    CHECK(warm.stable == cold.stable && warm.fraction == 1);
}

// it leans to one side under one and a half of Euler's load and is pushed to the other: nothing
// starts from there or is derived, the load taken back is solved from rest
static void limit_points_are_left(void)
{
    law_along law = flat_law();
    const made_rod m = make_rod(&law, 0, NULL, (rod_options){.tolerance = 1e-9});
    const double unit = 8e-5 / (0.12 * 0.12), press = 1.5 * PROTOTYPE_PI * PROTOTYPE_PI / 4 * unit;
    rod_solution out = {0};
    rod_request request = {.tip_space = {{1.5 * unit, 0, -press}}};
    CHECK_OK(rod_solve(m.state, &request, &out));
    request.tip_space.a[0] *= -1;
    CHECK(rod_solve(m.state, &request, &out) == ERR_NUMERIC);
    CHECK(out.fraction > 0.5 && out.fraction < 1 && out.ncritical > 0);
    status_clear();
    mat6 compliance;
    CHECK(rod_derive(m.state, 0.12, &(rod_derivatives){.tip_space = &compliance}) == ERR_NUMERIC);
    status_clear();
    request.tip_space.a[0] *= -1;
    check_same_tip(m.state, &request, 1e-9);
    CHECK_OK(rod_derive(m.state, 0.12, &(rod_derivatives){.tip_space = &compliance}));
    free_rod(m);
    law_along_free(&law);
}

// from one that follows or rubs to one that does not: stability is known again
static void requests_may_change_their_kind(void)
{
    const prototype p = helical_nc();
    law_along law = {0};
    prototype_law(&p, &law);
    tendon_spec t[2] = {straight_tendon("rubbing", 3.6e-3, 0),
                        straight_tendon("pulled", 3.6e-3, 2)};
    t[0].friction = 0.2;
    const double tension[2] = {0.3, 0.2}, other[2] = {0, 0.3}, pull[2] = {NAN, 1e-3};
    const rod_request kinds[6] = {
        {.tension = tension},
        {.tension = other, .tip_space = {{0.01}}},
        {.tip_body = {{0, 0.01, 0, 1e-4}}},
        {.tension = other, .pull = pull, .tip_space = {{0, 0.01}}},
        {.pull = pull},
        {.tension = other},
    };
    const made_rod m = make_rod(&law, 2, t, (rod_options){.tolerance = 1e-9});
    for (int i = 0; i < 36; i++) {
        rod_solution out = {0};
        CHECK_OK(rod_solve(m.state, &kinds[i / 6], &out));
        check_same_tip(m.state, &kinds[i % 6], 1e-9);
        CHECK_OK(rod_solve(m.state, &kinds[i % 6], &out));
        CHECK(out.stable == (i % 6 == 0 || i % 6 == 2 ? -1 : 1));
    }
    free_rod(m);
    law_along_free(&law);
}

// turned over, stretched, nothing at all, not a number: refused, and the next solve is as if new
static void bases_are_rotations(void)
{
    law_along law = flat_law();
    const made_rod m = make_rod(&law, 0, NULL, (rod_options){.tolerance = 1e-9});
    const pose bad[4] = {
        {.R = {{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}}},
        {.R = {{{1, 0, 0}, {0, 2, 0}, {0, 0, 1}}}},
        {.R = {{{0}}}},
        {.R = {{{1, 0, 0}, {0, NAN, 0}, {0, 0, 1}}}},
    };
    const pose turned = {.R = {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}}, .p = {{1, 2, 3}}};
    for (int i = 0; i < 5; i++) {
        rod_solution out = {0};
        const rod_request request = {.base = i < 4 ? &bad[i] : &turned};
        CHECK(rod_solve(m.state, &request, &out) == (i < 4 ? ERR_INPUT : OK));
        status_clear();
        CHECK(i < 4 || out.tip.p.a[0] == 1.12);
    }
    free_rod(m);
    law_along_free(&law);
}

int main(void)
{
    limit_points_are_left();
    requests_may_change_their_kind();
    bases_are_rotations();
    return test_failures != 0;
}
