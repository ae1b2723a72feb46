// measure/shares.h against functions whose variance is known by hand, and what samples alone make.
#include "measure/shares.h"

#include "measure/gsl_door.h"
#include "tests/test.h"

enum { MOST = 20000, TWO = 2, THREE = 3 };

static double x[THREE * MOST], y[MOST];

static const gsl_random_door *random_numbers(unsigned long seed, gsl_random **g)
{
    const gsl_random_door *door = NULL;
    CHECK_OK(gsl_random_door_open(&door));
    CHECK_OK(door->make(seed, g));
    return door;
}

static void draw(int n, int p, unsigned long seed)
{
    gsl_random *g = NULL;
    const gsl_random_door *door = random_numbers(seed, &g);
    for (int i = 0; i < n * p; i++) {
        x[i] = 2 * door->uniform(g) - 1;
    }
    door->free(g);
}

// y = 3 a + 4 b of uniform a, b: 9 and 16 of 25 parts
static void a_plane_is_shared_by_its_slopes(void)
{
    double share[TWO];
    sample_spread s;
    draw(MOST, TWO, 5);
    for (int i = 0; i < MOST; i++) {
        y[i] = 1 + 3 * x[2 * i] + 4 * x[2 * i + 1];
    }
    CHECK_OK(shares_of(MOST, TWO, x, y, 3, share, &s));
    // by chance 1/sqrt(n) each
    CHECK_NEAR(share[0], 0.36, 0.03);
    CHECK_NEAR(share[1], 0.64, 0.03);
    CHECK(s.rest < 1e-20);
    CHECK_NEAR(s.mean, 1, 0.05);
    CHECK_NEAR(s.deviation, 5 / sqrt(3.0), 0.03);
}

// a^2 + a b: the square is a's own, the product belongs to both and is in no share
static void a_product_belongs_to_both(void)
{
    double share[TWO];
    sample_spread s;
    draw(MOST, TWO, 6);
    for (int i = 0; i < MOST; i++) {
        y[i] = x[2 * i] * x[2 * i] + x[2 * i] * x[2 * i + 1];
    }
    CHECK_OK(shares_of(MOST, TWO, x, y, 3, share, &s));
    // var a^2 = 4/45, var ab = 1/9
    const double total = 4.0 / 45 + 1.0 / 9;
    CHECK_NEAR(share[0], 4.0 / 45 / total, 0.05);
    CHECK(share[1] < 2e-3);
    CHECK_NEAR(s.rest, 1.0 / 9 / total, 0.05);
}

static void quantiles_are_those_of_the_samples(void)
{
    double share[1];
    sample_spread s;
    for (int i = 0; i < 101; i++) {
        x[i] = 0.02 * i - 1;
        y[i] = (i * 37) % 101; // 0 to 100 in some order
    }
    CHECK_OK(shares_of(101, 1, x, y, 0, share, &s));
    CHECK_NEAR(s.low, 5, 1e-14);
    CHECK_NEAR(s.median, 50, 1e-14);
    CHECK_NEAR(s.high, 95, 1e-14);
    CHECK_NEAR(s.mean, 50, 1e-14);
    CHECK_NEAR(s.deviation, sqrt(101 * 102 / 12.0), 1e-13);
    CHECK(isnan(share[0]) && isnan(s.rest)); // degree 0 shares nothing
}

static void few_samples_claim_little(void)
{
    double share[THREE];
    sample_spread s;
    CHECK(shares_degree(1000, 5) == 3);
    CHECK(shares_degree(100, 5) == 1);
    CHECK(shares_degree(99, 5) == 0);
    CHECK_OK(shares_of(0, THREE, x, y, 1, share, &s));
    CHECK(isnan(s.mean) && isnan(share[2]));
    y[0] = 2;
    CHECK_OK(shares_of(1, THREE, x, y, 1, share, &s));
    CHECK(s.mean == 2 && isnan(s.deviation) && isnan(share[0]) && s.low == 2 && s.high == 2);
    for (int i = 0; i < 50; i++) {
        y[i] = 7;
    }
    CHECK_OK(shares_of(50, 1, x, y, 1, share, &s));
    CHECK(share[0] == 0 && s.rest == 0 && s.deviation == 0); // nothing to share
}

int main(void)
{
    a_plane_is_shared_by_its_slopes();
    a_product_belongs_to_both();
    quantiles_are_those_of_the_samples();
    few_samples_claim_little();
    return test_failures != 0;
}
