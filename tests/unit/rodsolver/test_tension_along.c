#include "rodsolver/rod.h"
#include "tests/test.h"
#include "tests/unit/rodsolver/prototypes.h"

// a straight tendon that rubs: tau' = -mu tau kappa, kappa = tau r / EI, docs/theory.md section 4;
// up to its very end, and nothing behind
static void friction_is_told_up_to_the_tendons_end(void)
{
    const prototype p = homogeneous_tube();
    const double tau = 0.5, mu = 0.3, r = 3.6e-3, end = 0.75 * p.length;
    const double c = mu * tau * r / prototype_integrals(&p, 0).EIx;
    tendon_spec tendon = straight_tendon("a", r, 0);
    tendon.friction = mu;
    tendon.end = end;
    law_along law = {0};
    rod *rod = NULL;
    rod_state *state = NULL;
    rod_solution solution = {0};
    prototype_law(&p, &law);
    const rod_spec spec = {.law = &law, .ntendon = 1, .tendons = &tendon};
    const rod_options options = {.tolerance = 1e-10};
    const rod_request request = {.tension = &tau, .cold = true};
    CHECK_OK(rod_make(&spec, &options, &rod));
    CHECK_OK(rod_state_make(rod, &state));
    CHECK_OK(rod_solve(state, &request, &solution));
    for (int k = 0; k <= 10; k++) {
        const double s = k == 10 ? end : k == 9 ? end * (1 + 1e-15) : 0.1 * k * end;
        double tension = NAN;
        vec6 wrench;
        CHECK_OK(rod_wrench_at(state, s, &wrench, &tension));
        // between stations: a polynomial through the six of a pair
        CHECK_NEAR(tension, tau / (1 + c * s), 1e-7);
        CHECK_OK(rod_wrench_at(state, 0.5 * (end + p.length), &wrench, &tension));
        CHECK(tension == 0);
    }
    rod_state_free(state);
    rod_free(rod);
    law_along_free(&law);
}

int main(void)
{
    friction_is_told_up_to_the_tendons_end();
    return test_failures != 0;
}
