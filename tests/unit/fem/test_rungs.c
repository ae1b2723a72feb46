// tests/unit/fem/test_rungs.c
#include "fem/corner_strength.h"
#include "fem/rungs.h"
#include "tests/test.h"

#include <math.h>
#include <stdlib.h>

static void every_rung_asks_for_more(void)
{
    for (int k = 1; k < RUNG_COUNT; k++) {
        const segment_rung below = segment_rung_of(k - 1), r = segment_rung_of(k);
        CHECK(r.plane_order >= 1 && r.plane_order <= ELEMENT_MAX_ORDER);
        CHECK(r.order >= below.order && r.order <= ELEMENT_MAX_ORDER);
        CHECK(r.edge_first <= below.edge_first && r.end_first <= below.end_first);
        CHECK(r.edge_first < below.edge_first || r.plane_order > below.plane_order);
    }
}

// ascending from 0 to the length, next to an end what the rung asks for, neighbours no more than
// the growth apart
static void check_layers(int rung, const rung_body *b)
{
    const segment_rung r = segment_rung_of(rung);
    int n = 0;
    double *at = NULL, longest = 0;
    CHECK_OK(segment_rung_layers(&r, b, &n, &at));
    CHECK(at[0] == 0 && at[n] == b->length);
    for (int i = 0; i < n; i++) {
        const double h = at[i + 1] - at[i];
        const double ratio = i ? h / (at[i] - at[i - 1]) : 1;
        CHECK(h > 0);
        CHECK(ratio < 5.5 && ratio > 1 / 5.5);
        longest = fmax(longest, h);
    }
    const double first = r.end_first * b->radius;
    if (b->length > 30 * first && b->sections_along == 0) {
        CHECK_NEAR(at[1], (b->base == BASE_FREE ? 5 : 1) * first, 1e-12);
        CHECK_NEAR(at[n] - at[n - 1], (b->tip == TIP_FREE ? 5 : 1) * first, 1e-9);
    }
    CHECK(b->sections_along == 0 || longest <= b->length / b->sections_along * 1.0001);
    free(at);
}

static void layers_grow_from_both_ends(void)
{
    for (int k = 0; k < RUNG_COUNT; k++) {
        for (double length = 0.1; length < 2000; length *= 1.7) {
            check_layers(k, &(rung_body){length, 1, BASE_CLAMPED, TIP_RIGID, 0});
            check_layers(k, &(rung_body){length, 1, BASE_CLAMPED, TIP_RIGID, 50});
        }
        check_layers(k, &(rung_body){20e-3, 4e-3, BASE_CLAMPED, TIP_FREE, 0});
        check_layers(k, &(rung_body){20e-3, 4e-3, BASE_FREE, TIP_RIGID, 0});
    }
}

// the same from both ends where both are held
static void held_ends_are_alike(void)
{
    for (int k = 0; k < RUNG_COUNT; k++) {
        const segment_rung r = segment_rung_of(k);
        const rung_body b = {30, 1, BASE_CLAMPED, TIP_RIGID, 0};
        int n = 0;
        double *at = NULL;
        CHECK_OK(segment_rung_layers(&r, &b, &n, &at));
        for (int i = 0; i <= n; i++) {
            CHECK_WITHIN(at[i] + at[n - i], 30, 1e-13);
        }
        CHECK(n <= 24 + 4 * k); // few layers for a body of 15 diameters
        free(at);
    }
}

// a sequence whose error falls as expected, slower and faster
static void estimates_hold_for_geometric_sequences(void)
{
    for (int k = 2; k < RUNG_COUNT; k++) {
        for (double nu = 0; nu <= 0.5; nu += 0.1) {
            const double left = segment_rung_left(k, nu, TIP_RIGID);
            CHECK(left > 0 && left <= 0.7);
            for (double part = left / 8; part < 0.75; part *= 1.5) {
                const double error[3] = {1e-3, 1e-3 * part, 1e-3 * part * part};
                const double value[3] = {2 - error[0], 2 - error[1], 2 - error[2]};
                const double two = segment_rung_error(k, nu, TIP_RIGID, 2, value + 1);
                const double three = segment_rung_error(k, nu, TIP_RIGID, 3, value);
                CHECK(three >= 0.999 * error[2]); // three tell when it falls slowly
                CHECK(part > left || two >= 0.999 * error[2]);
                CHECK(part < left / 4 || two < 10 * error[2]);
            }
        }
    }
}

static void tractions_are_trusted_less(void)
{
    for (int k = 1; k < RUNG_COUNT; k++) {
        CHECK_NEAR(segment_rung_factor(k, 0.3, TIP_E_PROPORTIONAL), 2, 1e-12);
        CHECK(segment_rung_factor(k, 0.3, TIP_RIGID) < 2);
    }
}

// the weaker the singularity, the more one layer helps
static void strength_decides_what_a_layer_leaves(void)
{
    const int last = RUNG_COUNT - 1;
    CHECK(segment_rung_left(last, 0.1, TIP_RIGID) < segment_rung_left(last, 0.3, TIP_RIGID));
    CHECK(segment_rung_left(last, 0.3, TIP_RIGID) < segment_rung_left(last, 0.49, TIP_RIGID));
    CHECK_NEAR(segment_rung_left(last, 0.2, TIP_RIGID) / segment_rung_left(last, 0.4, TIP_RIGID),
               pow(5, 2 * (corner_strength(0.4) - corner_strength(0.2))), 1e-12);
}

int main(void)
{
    every_rung_asks_for_more();
    layers_grow_from_both_ends();
    held_ends_are_alike();
    estimates_hold_for_geometric_sequences();
    strength_decides_what_a_layer_leaves();
    tractions_are_trusted_less();
    return test_failures != 0;
}
