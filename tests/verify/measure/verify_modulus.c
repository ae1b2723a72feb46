// tests/verify/measure/verify_modulus.c
// Two hundred made curves of each kind with a known modulus: how often its interval holds it. The
// curves are synthetic: formulae of stress over strain, written here, and noise.
#include "measure/gsl_door.h"
#include "measure/tensile.h"
#include "tests/test.h"

enum { MOST = 2400 };

typedef struct kind {
    const char *name;
    int n;           // points up to the largest strain
    double strain;   // the largest
    double noise;    // standard deviation, as a share of E times a hundredth
    double grows;    // 1: the noise grows with the stress
    double together; // autocorrelation from point to point
    double toe;      // strain over which the clamps take hold
    double bend;     // sigma = E xi (1 - bend xi)
    double soft;     // sigma = E soft tanh(xi/soft); 0: none
    bool neo;        // neo-Hookean: sigma = E/3 (lambda - 1/lambda^2)
    double end;      // beyond it the slope is a third; 0: nowhere
    double slack;    // strain before anything pulls
    double ripple;   // strain's own noise
    bool unload;     // down again, 10 % softer, and up once more
} kind;

static const gsl_random_door *random_of;

// the stress over E of a material whose modulus at zero is 1
static double material(const kind *k, double xi)
{
    if (k->neo) {
        const double stretch = 1 + xi;
        return (stretch - 1 / (stretch * stretch)) / 3;
    }
    if (k->soft > 0) {
        return k->soft * tanh(xi / k->soft);
    }
    if (k->end > 0 && xi > k->end) {
        return k->end + (xi - k->end) / 3;
    }
    return xi * (1 - k->bend * xi);
}

// a toe: slack clamps take hold one after another, the slope rises in proportion over `toe`
static double stress_over_E(const kind *k, double strain)
{
    const double x = strain - k->slack;
    if (x <= 0) {
        return 0;
    }
    return x < k->toe ? 0.5 * x * x / k->toe : material(k, x - 0.5 * k->toe);
}

static status make_curve(const kind *k, double E, gsl_random *g, tensile_curve *c)
{
    status st = OK;
    TRY(tensile_curve_make(k->n, c));
    double noise = random_of->normal(g);
    for (int i = 0; i < k->n; i++) {
        const int up = k->unload ? k->n / 3 : k->n - 1;
        const double phase = fmod((double)i / up, 2);
        const double strain = k->strain * (phase > 1 ? 2 - phase : phase),
                     along = strain / k->strain;
        noise = k->together * noise + sqrt(1 - k->together * k->together) * random_of->normal(g);
        const double size = 0.01 * k->noise * (k->grows > 0 ? along + 0.02 : 1);
        c->strain[i] = strain + k->ripple * random_of->normal(g);
        const double softer = i > up ? 0.9 : 1;
        c->stress[i] = E * (softer * stress_over_E(k, strain) + size * noise);
    }

done:
    return st;
}

static void modulus_is_in_its_interval(const kind *k, unsigned long seed)
{
    // 95 % of the curves, but for what chance leaves of that: three standard deviations, for many
    // kinds are looked at
    const int curves = test_is_long() ? 200 : 60;
    const double mean = 0.95 * curves, chance = 3 * sqrt(0.05 * mean);
    const tensile_rule rule = tensile_rule_default();
    int inside = 0, failed = 0;
    double width = 0, bias = 0;
    gsl_random *g = NULL;
    CHECK_OK(random_of->make(seed, &g));
    for (int i = 0; i < curves; i++) {
        const double E = 0.3e6 * pow(100, random_of->uniform(g));
        tensile_curve c = {0};
        tensile_answer a = {0};
        CHECK_OK(make_curve(k, E, g, &c));
        if (tensile_measure(&c, &rule, &a) != OK) {
            failed++;
            status_clear();
        } else {
            inside += a.interval[0] <= E && E <= a.interval[1];
            width += 0.5 * (a.interval[1] - a.interval[0]) / E / curves;
            bias += (a.E / E - 1) / curves;
        }
        tensile_curve_free(&c);
    }
    random_of->free(g);
    printf("%-46s %3d of %d, half width %6.3f %%, mean error %+7.3f %%, %d refused\n", k->name,
           inside, curves, 100 * width, 100 * bias, failed);
    CHECK(failed == 0);
    CHECK_AT_MOST(fabs(inside - mean), chance);
}

static const kind kinds[] = {
    {.name = "white noise, toe", .n = 500, .strain = 0.05, .noise = 0.05, .toe = 0.006},
    {.name = "white noise, toe, slack, a knee",
     .n = 500,
     .strain = 0.08,
     .noise = 0.05,
     .toe = 0.006,
     .slack = 0.002,
     .end = 0.05},
    {.name = "a third of it slack, a knee",
     .n = 500,
     .strain = 0.06,
     .noise = 0.02,
     .slack = 0.02,
     .end = 0.02},
    {.name = "half of it slack", .n = 500, .strain = 0.06, .noise = 0.02, .slack = 0.03},
    {.name = "a quarter of it toe", .n = 500, .strain = 0.05, .noise = 0.05, .toe = 0.0125},
    {.name = "white noise, straight", .n = 500, .strain = 0.05, .noise = 0.05},
    {.name = "little noise, toe", .n = 500, .strain = 0.05, .noise = 0.003, .toe = 0.006},
    {.name = "much noise, toe", .n = 500, .strain = 0.05, .noise = 0.3, .toe = 0.006},
    {.name = "noise that grows with the stress, toe",
     .n = 500,
     .strain = 0.05,
     .noise = 0.1,
     .grows = 1,
     .toe = 0.006},
    {.name = "noise over about 10 points, toe",
     .n = 800,
     .strain = 0.05,
     .noise = 0.05,
     .together = 0.8,
     .toe = 0.006},
    {.name = "noise over about 40 points, toe",
     .n = 2400,
     .strain = 0.05,
     .noise = 0.05,
     .together = 0.95,
     .toe = 0.006},
    {.name = "30 points, toe", .n = 30, .strain = 0.05, .noise = 0.03, .toe = 0.006},
    {.name = "bend of 10 % in slope at 5 %, toe",
     .n = 500,
     .strain = 0.08,
     .noise = 0.03,
     .bend = 1,
     .toe = 0.006},
    {.name = "neo-Hookean up to 30 %, toe",
     .n = 800,
     .strain = 0.3,
     .noise = 0.03,
     .neo = true,
     .toe = 0.006},
    {.name = "tanh to a plateau, toe",
     .n = 800,
     .strain = 0.2,
     .noise = 0.05,
     .soft = 0.06,
     .toe = 0.006},
    {.name = "strain with noise too, toe",
     .n = 500,
     .strain = 0.05,
     .noise = 0.05,
     .ripple = 2e-5,
     .toe = 0.006},
    {.name = "with unloading and a second cycle, toe",
     .n = 1500,
     .strain = 0.05,
     .noise = 0.05,
     .toe = 0.006,
     .unload = true},
};

// verify_modulus [SEED]
int main(int argc, char **argv)
{
    against(BY_MADE_DATA, "synthetic stress-strain curves of known modulus");
    CHECK_OK(gsl_random_door_open(&random_of));
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        modulus_is_in_its_interval(&kinds[i], argc > 1 ? strtoul(argv[1], NULL, 10) : 6);
    }
    return test_failures != 0;
}
